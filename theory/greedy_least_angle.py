"""Least angle of the greedy algorithm in the limit of edge length 0, on disks too large for a tree.

Of every generation only the sectors are cut whose daughters promise the smallest angles. The
promise of a sector of opening phi, its corner s from the rim, is phi times the larger of 1/3, which
a daughter keeps at least, and a = A^2/(4 s), A = I_0^(-1)(phi*/phi), or phi I_0(2 a)/3 between two
geodesics: an order of merit, not a bound.
"""

from dataclasses import dataclass
from math import log, tan

from theory.errors import DomainError
from theory.greedy_limit import (
    LimitCut,
    LimitSector,
    cut_sector,
    initial_sector,
    require_parameters,
)

#: Generations without a new least angle after which the search ends.
PATIENCE = 2

#: Where I_0^(-1) is looked for: I_0(100) is beyond 10^41.
LARGEST_ARGUMENT = 100.0


@dataclass(frozen=True, kw_only=True)
class Generation:
    """Least opening, in radians, of the daughters born at this generation's cuts, and their path.

    path: that of the sector cut; cuts: number of sectors of the generation that were cut.
    """

    angle: float
    path: str
    cuts: int


def promise(opening: float, distance: float, cutoff: float, *, geodesic: bool) -> float:
    """Order of merit of a sector of this opening whose corner has this distance from the rim.

    geodesic: whether both its sides are geodesics.
    """
    from scipy.optimize import brentq
    from scipy.special import i0, ive

    if opening >= cutoff or distance <= 0:
        return cutoff
    level = log(cutoff / opening)
    argument = float(brentq(lambda x: log(ive(0, x)) + x - level, 0.0, LARGEST_ARGUMENT))
    share = argument**2 / (4 * distance)
    return opening * (float(i0(2 * share)) / 3 if geodesic else max(1 / 3, share))


def least_angles(
    radius: float, phi0: float, cutoff: float, *, width: int, nodes: int = 48, margin: float = 1.0
) -> tuple[Generation, ...]:
    """Least openings by generation: an upper bound of the least angle of the whole tree.

    width: number of sectors that are cut in a generation; phi0, cutoff in radians, 0 < phi0 <
    cutoff < pi; nodes: of the Chebyshev series. Raises DomainError.
    """
    require_parameters(radius, phi0, cutoff)
    if width < 1:
        raise DomainError(f"width {width}: expected 1 or more sectors")
    sectors, found = [initial_sector(radius, phi0, nodes, margin)], []
    least, waited = phi0, 0
    while sectors and waited < PATIENCE:
        born: list[tuple[float, str, LimitSector]] = []
        cuts: list[LimitCut] = []
        for sector in sectors:
            cut, daughters, _ = cut_sector(sector, radius, cutoff, margin)
            if cut is None:
                continue
            cuts.append(cut)
            for daughter in daughters:
                merit = promise(
                    cut.angle / 3, radius - cut.rho, cutoff, geodesic=daughter.path[-1] == "A"
                )
                born.append((merit, daughter.path, daughter))
        if not cuts:
            break
        first = min(cuts, key=lambda cut: (cut.angle, cut.path))
        found.append(Generation(angle=first.angle / 3, path=first.path, cuts=len(cuts)))
        waited = 0 if first.angle / 3 < least else waited + 1
        least = min(least, first.angle / 3)
        born.sort(key=lambda entry: entry[:2])
        sectors = [sector for _, _, sector in born[:width]]
    return tuple(found)


def largest_curvature(found: tuple[Generation, ...], phi0: float, cutoff: float) -> float:
    """Larger of cot(phi/2) at the least angle and tan(phi*/2) (ebound)."""
    least = min([phi0, *(generation.angle for generation in found)])
    return max(1 / tan(least / 2), tan(cutoff / 2))
