"""Least angle of the greedy algorithm in the limit of edge length 0, on disks too large for a tree.

Small angles descend from small ones, since a daughter keeps at least a third of its parent's angle:
of every generation only the sectors of smallest opening are cut.
"""

from dataclasses import dataclass
from math import tan

from theory.errors import DomainError
from theory.greedy_limit import LimitSector, cut_sector, initial_sector, require_parameters

#: Generations without a new least angle after which the search ends.
PATIENCE = 2


@dataclass(frozen=True, kw_only=True)
class Generation:
    """Least opening, in radians, of the daughters born at this generation's cuts, and their path.

    path: that of the sector cut; cuts: number of sectors of the generation that were cut.
    """

    angle: float
    path: str
    cuts: int


def least_angles(
    radius: float, phi0: float, cutoff: float, *, width: int, nodes: int = 48, margin: float = 1.0
) -> tuple[Generation, ...]:
    """Least openings by generation: an upper bound of the least angle of the whole tree.

    width: number of sectors, those of smallest opening, that are cut in a generation; phi0, cutoff
    in radians, 0 < phi0 < cutoff < pi; nodes: of the Chebyshev series. Raises DomainError.
    """
    require_parameters(radius, phi0, cutoff)
    if width < 1:
        raise DomainError(f"width {width}: expected 1 or more sectors")
    sectors, found = [initial_sector(radius, phi0, nodes, margin)], []
    least, waited = phi0, 0
    while sectors and waited < PATIENCE:
        born: list[tuple[float, LimitSector]] = []
        cuts = []
        for sector in sectors:
            cut, daughters, _ = cut_sector(sector, radius, cutoff, margin)
            if cut is not None:
                cuts.append(cut)
                born.extend((cut.angle / 3, daughter) for daughter in daughters)
        if not cuts:
            break
        first = min(cuts, key=lambda cut: (cut.angle, cut.path))
        found.append(Generation(angle=first.angle / 3, path=first.path, cuts=len(cuts)))
        waited = 0 if first.angle / 3 < least else waited + 1
        least = min(least, first.angle / 3)
        born.sort(key=lambda pair: (pair[0], pair[1].path))
        sectors = [sector for _, sector in born[:width]]
    return tuple(found)


def largest_curvature(found: tuple[Generation, ...], phi0: float, cutoff: float) -> float:
    """Larger of cot(phi/2) at the least angle and tan(phi*/2) (ebound)."""
    least = min([phi0, *(generation.angle for generation in found)])
    return max(1 / tan(least / 2), tan(cutoff / 2))
