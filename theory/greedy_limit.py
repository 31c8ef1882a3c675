"""The greedy algorithm (alg:greedy-cuts) in the limit of edge length 0, in float64.

A sector is cut at (u*, v*): v* is the least v, and u* the least u, whose line reaches the cutoff
angle in the disk. Its daughters are the sectors between the line v = v* from u* on, the two
geodesics that trisect the angle at the cut, and the line u = u* from v* on. A line keeps its
geodesic curvature, so that phi along it drops by two thirds of the angle at the cut.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import acosh, atan2, cos, cosh, pi, sin
from typing import Any

import numpy as np

from theory.errors import DomainError
from theory.goursat_rows import first_crossing
from theory.sector_side import Side, geodesic_side


@dataclass(frozen=True, kw_only=True)
class LimitCut:
    """Cut of the sector with this path: where, at which angle; rho, theta: of the branch point."""

    path: str
    u: float
    v: float
    angle: float
    rho: float
    theta: float


@dataclass(frozen=True, kw_only=True)
class LimitTree:
    """Cuts of the first initial sector; slack: least distance of an uncut sector to the cutoff."""

    cuts: tuple[LimitCut, ...]
    min_angle: float
    slack: float


@dataclass(frozen=True, kw_only=True, eq=False)
class LimitSector:
    """Sector between two sides from its corner; mirrored: whether it is its own mirror image."""

    path: str
    mirrored: bool
    first: Side
    second: Side


def tangents(point: Any, u_rate: Any, v_rate: Any, angle: float) -> tuple[Any, Any]:
    """Orthonormal pair at a point (3,): along u, and across it towards v."""
    return u_rate, (v_rate - cos(angle) * u_rate) / sin(angle)


def _reach(radius: float, margin: float, point: Any, tangent: Any) -> float:
    """Length of a geodesic until the distance radius + margin from the centre."""
    level = cosh(radius + margin)
    a, b = float(point[0]), float(tangent[0])  # a cosh s + b sinh s = level
    return acosh(level / (a * a - b * b) ** 0.5) - float(np.arctanh(b / a))


def _daughters(
    sector: LimitSector, u: float, v: float, row: Side, column: Side, reach: tuple[float, float]
) -> tuple[LimitCut, list[LimitSector]]:
    at = row.at(u)
    angle, point = float(at[0]), at[1:]
    along, across = tangents(point, row.rate(u)[1:], column.rate(0.0)[1:], angle)
    count, third = len(row.values), angle / 3
    rays = []
    for k in (1, 2):
        tangent = cos(k * third) * along + sin(k * third) * across
        rays.append(geodesic_side(_reach(*reach, point, tangent), count, third, point, tangent))
    lower, upper = row.beyond(u, 2 * third), column.beyond(0.0, 2 * third)
    path, mirrored = sector.path, sector.mirrored
    found = [
        LimitSector(path=path + "u", mirrored=False, first=lower, second=rays[0]),
        LimitSector(path=path + "A", mirrored=mirrored, first=rays[1], second=rays[0]),
        LimitSector(path=path + "v", mirrored=False, first=rays[1], second=upper),
    ]
    cut = LimitCut(
        path=path,
        u=u,
        v=v,
        angle=angle,
        rho=acosh(point[0]),
        theta=atan2(point[2], point[1]) % (2 * pi),
    )
    return cut, found[:2] if mirrored else found


def cut_sector(
    sector: LimitSector, radius: float, cutoff: float, margin: float
) -> tuple[LimitCut | None, list[LimitSector], float]:
    """Cut of a sector and its daughters, one of two that are mirror images, or None and none.

    The last entry is the largest angle seen at the rim. margin: reach of the sides beyond the disk.
    """
    lowest = first_crossing(sector.first, sector.second, radius, cutoff)
    if lowest.v is None or lowest.row is None:
        return None, [], lowest.largest
    first = first_crossing(sector.second.beyond(lowest.v, 0.0), lowest.row, radius, cutoff)
    if first.v is None or first.row is None:
        raise ArithmeticError("a row reaches the cutoff and no column does")
    cut, found = _daughters(sector, first.v, lowest.v, lowest.row, first.row, (radius, margin))
    return cut, found, cutoff


def initial_sector(radius: float, phi0: float, nodes: int, margin: float) -> LimitSector:
    """First sector at the centre, of this angle, its sides reaching the margin beyond the disk."""
    length, origin = radius + margin, [1.0, 0.0, 0.0]
    axes = [
        geodesic_side(length, nodes, phi0, origin, [0.0, cos(angle), sin(angle)])
        for angle in (0.0, phi0)
    ]
    return LimitSector(path="", mirrored=True, first=axes[0], second=axes[1])


def _tree(
    radius: float, phi0: float, cutoff: float, nodes: int, margin: float, generations: int | None
) -> Iterator[tuple[LimitCut | None, float]]:
    waiting = [initial_sector(radius, phi0, nodes, margin)]
    while waiting:
        sector = waiting.pop()
        cut, found, largest = cut_sector(sector, radius, cutoff, margin)
        if generations is None or len(sector.path) + 1 < generations:
            waiting.extend(reversed(found))
        yield cut, largest


def require_parameters(radius: float, phi0: float, cutoff: float) -> None:
    """Raise DomainError unless 0 < phi0 < cutoff < pi and the radius is positive."""
    if not (radius > 0 and 0 < phi0 < cutoff < pi):
        raise DomainError(
            f"radius {radius}, phi0 {phi0}, cutoff {cutoff}: expected a positive radius and "
            "0 < phi0 < cutoff < pi"
        )


def limit_tree(
    radius: float,
    phi0: float,
    cutoff: float,
    *,
    nodes: int = 48,
    margin: float = 1.0,
    generations: int | None = None,
) -> LimitTree:
    """Cuts of one half of the first initial sector, in order from the centre, daughters u, A, v.

    phi0, cutoff in radians, 0 < phi0 < cutoff < pi; nodes: of the Chebyshev series along a line;
    generations: only so many generations of cuts, if given. Raises DomainError.
    """
    require_parameters(radius, phi0, cutoff)
    found = list(_tree(radius, phi0, cutoff, nodes, margin, generations))
    cuts = tuple(cut for cut, _ in found if cut is not None)
    slack = min((cutoff - largest for cut, largest in found if cut is None), default=cutoff)
    return LimitTree(
        cuts=cuts, min_angle=min([phi0, *(cut.angle / 3 for cut in cuts)]), slack=slack
    )


def limit_path(
    radius: float, phi0: float, cutoff: float, path: str, *, nodes: int = 48, margin: float = 1.0
) -> tuple[LimitCut, ...]:
    """Cuts of the first initial sector and of those that the letters of a path lead to.

    It ends early at a sector that is not cut. Arguments as for `limit_tree`; raises DomainError,
    also for a letter that names no daughter (v names none of a sector symmetric to itself).
    """
    require_parameters(radius, phi0, cutoff)
    sector, cuts = initial_sector(radius, phi0, nodes, margin), []
    for letter in (*path, None):
        cut, found, _ = cut_sector(sector, radius, cutoff, margin)
        if cut is None:
            break
        cuts.append(cut)
        if letter is None:
            break
        daughters = {daughter.path[-1]: daughter for daughter in found}
        if letter not in daughters:
            raise DomainError(f"path {path!r}: {letter!r} names no daughter of {sector.path!r}")
        sector = daughters[letter]
    return tuple(cuts)
