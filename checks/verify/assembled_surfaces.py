"""Stars with bent rays assembled in float64: order of accuracy, crossings, turns of the normal."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from math import pi
from typing import Any

import numpy as np
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.printed import assembly as printed
from checks.verify.convergence import order as observed_order
from theory import assembled_float as surfaces

Count = tuple[str, Any, Any]
LENGTH = 0.5
STEPS = (16, 32, 64, 128)
#: Angles over pi and curvatures a + b t + c t^2 of the rays of four stars, m = 2 to 5.
STARS: dict[int, tuple[tuple[float, ...], tuple[tuple[float, float, float], ...]]] = {
    2: ((0.5, 0.35, 0.65, 0.5), ((1, 1, 0), (-0.5, 0, 2), (0.3, 2, -1), (0.8, 0, 0))),
    3: (
        (0.3, 0.4, 0.25, 0.35, 0.45, 0.25),
        ((1, 1, 0), (-0.5, 0, 1), (0.3, 3, -2), (0.7, 0, 0), (-1, 2, 0), (1, 0, -2)),
    ),
    4: (
        (0.25, 0.2, 0.3, 0.25, 0.25, 0.3, 0.2, 0.25),
        ((0.5, 0, 0), (0, 1, 0), (-1, 0, 1), (0.2, 0, 0)) * 2,
    ),
    5: ((0.2,) * 10, ((0.4, 0, 1), (-0.3, 1, 0)) * 5),
}


def _curvature(coefficients: Sequence[float], factor: float = 1.0) -> Callable[[float], float]:
    a, b, c = coefficients
    return lambda t: factor * (a + b * t + c * t * t)


@cache
def star(order: int, steps: int) -> tuple[surfaces.Sector, ...]:
    """Assembled star of this order with bent rays."""
    angles, curvatures = STARS[order]
    return surfaces.assembled(
        [pi * a for a in angles],
        [_curvature(k) for k in curvatures],
        length=LENGTH,
        steps=steps,
    )


def _turned_angle(coefficients: Sequence[float], t: Any) -> Any:
    """Integral of the curvature from 0."""
    a, b, c = coefficients
    return a * t + b * t**2 / 2 + c * t**3 / 3


def _curve(angle: float, curvature: Callable[[float], float], torsion: int, steps: int) -> Any:
    """Points of the curve of this curvature and torsion: Simpson's rule on a fine grid."""
    fine = 2 * max(STEPS)
    tangent = surfaces.ray_frames(angle, curvature, torsion, LENGTH, 2 * fine)[:, 0]
    h = LENGTH / fine
    pieces = h / 6 * (tangent[:-2:2] + 4 * tangent[1::2] + tangent[2::2])
    points = np.concatenate([np.zeros((1, 3)), np.cumsum(pieces, axis=0)])
    return points[:: fine // steps]


def _error(
    steps: int, widened: float, jump: float, factor: float, torsion_odd: int, count: int
) -> float:
    """Largest error of the star of order 3: sphere, closed form, angles and curves of the rays.

    count: of the sectors; if it is not 6, they have equal angles.
    """
    angles, curvatures = STARS[3]
    if count != len(angles):
        angles, curvatures = (2 / count,) * count, (curvatures * 2)[:count]
    wide = [pi * a for a in angles[:-1]] + [pi * (angles[-1] + widened)]
    given = [_curvature(k) for k in curvatures]
    sectors = surfaces.assembled(
        wide,
        given,
        length=LENGTH,
        steps=steps,
        torsions=(-1, torsion_odd),
        other_side=[_curvature(k, 1 + jump) for k in curvatures],
    )
    t = np.linspace(0, LENGTH, steps + 1)
    beta = np.cumsum([0.0, *(pi * a for a in angles)])
    worst = 0.0
    for i, sector in enumerate(sectors, 1):
        worst = max(worst, float(np.abs(np.linalg.norm(sector.normal, axis=2) - 1).max()))
        worst = max(worst, float(np.abs(sector.first_u - sector.first_v).max()))
        before = i - 1 or len(sectors)
        even, odd = (i, before) if i % 2 == 0 else (before, i)
        for along, ray, sign in (("u", even, -sector.sigma), ("v", odd, sector.sigma)):
            expected = wide[i - 1] + sign * factor * _turned_angle(curvatures[ray - 1], t)
            found = surfaces.edge_angles(sector, along)
            worst = max(worst, float(np.abs(found - expected).max()))
            edge = sector.first_u[:, 0] if along == "u" else sector.first_u[0]
            curve = _curve(float(beta[ray]), given[ray - 1], -1 if along == "u" else 1, steps)
            worst = max(worst, float(np.abs(edge - curve).max()))
    return worst


def example(
    setting: Setting,
    *,
    widened: str = "0",
    jump: str = "0",
    factor: str = "1",
    torsion_odd: int = 1,
    count: int = 6,
) -> Evidence:
    """Six sectors of unequal angles between bent rays, integrated on four grids.

    widened: of the last angle, over pi; jump: relative difference of the curvatures prescribed on
    the two sides of the rays; factor: of the turn of theta along the edges; torsion_odd: of the
    odd rays; count: of the sectors.
    """
    del setting
    levels = [mp.mpf(1) / n for n in STEPS]
    errors = [
        mp.mpf(_error(n, float(widened), float(jump), float(factor), torsion_odd, count))
        for n in STEPS
    ]
    return observed_order(
        levels,
        errors,
        2,
        digits=10,
        shown="six sectors of unequal angles between curves of variable curvature, Moutard "
        "equation to second order: the normal's length, both orders of integration of the "
        "position, the angle on each edge against that of the prescribed geodesic curvature, and "
        "every ray from both of its sectors against its curve converge",
    )


def counted(rows: Iterable[Count], *, shown: str) -> Evidence:
    """Measured evidence that each number found is the expected one."""
    tried = 0
    for place, found, expected in rows:
        tried += 1
        if found != expected:
            witness = f"{place}: {found}, not {expected}"
            return Evidence(
                outcome="fail",
                grade="experiment",
                witness=witness,
                tried=tried,
                met=tried,
                shown=shown,
            )
    return Evidence(outcome="pass", grade="experiment", tried=tried, met=tried, shown=shown)


def crossings(setting: Setting, *, directions: int = 1, offset: int = 0) -> Evidence:
    """Crossings of the tangent plane at the centre on small and larger circuits, m = 2 to 5.

    directions: 1 for those from below to above, 2 for all; offset: added to the expected m.
    """
    del setting

    def rows() -> Iterator[Count]:
        for m in STARS:
            sectors = star(m, 64)
            for k in (8, 16, 32, 64):
                heights = [float(p[2]) for p, _ in surfaces.circuit(sectors, k)]
                found = surfaces.upward_crossings(heights)
                if directions == 2:
                    found += surfaces.upward_crossings(heights[::-1])
                place = f"m = {m}, circuit at {k}/64 of the star"
                yield place, found, printed.order_of_saddleness(2 * m, offset=offset)

    return counted(
        rows(),
        shown="on bent stars of the orders 2 to 5 a circuit passes from below to above the tangent "
        "plane at the centre m times, down to an eighth of the star",
    )


def undulations(setting: Setting, *, regular: int = 2, away: int = 0) -> Evidence:
    """Undulations on the boundary of the assembled stars, beyond the two of a regular saddle.

    regular: undulations of a regular saddle; away: sectors left out from the circuit.
    """
    del setting

    def rows() -> Iterator[Count]:
        for m in STARS:
            sectors = star(m, 64)
            found = surfaces.circuit(sectors[: 2 * m - away], None)
            lowest = min(float(n[2]) for _, n in found)
            yield f"m = {m}: N.e_3 > 0 on the boundary", lowest > 0, True
            heights = [float(p[2]) for p, _ in found]
            excess = surfaces.upward_crossings(heights) - 2
            yield f"m = {m}, excess", excess, printed.excess_undulations(m, regular=regular)

    return counted(
        rows(),
        shown="on the boundary of bent stars of the orders 2 to 5, of side 1/2, the height over "
        "the tangent plane at the centre still changes its sign as often as near it: m - 2 "
        "undulations more than a saddle; the surfaces are immersed of curvature -1 throughout",
    )


def normal_turns(setting: Setting, *, offset: int = 0, sense: int = 1) -> Evidence:
    """Turns of the normal's tangential part on circuits of the bent stars: J = 1 - m.

    offset: added to the expected number; sense: of the circuit.
    """
    del setting

    def rows() -> Iterator[Count]:
        for m in STARS:
            for k in (8, 32):
                normals = [n for _, n in surfaces.circuit(star(m, 64), k)][::sense]
                yield f"m = {m}, circuit {k}/64", surfaces.winding(normals), 1 - m + offset

    return counted(
        rows(),
        shown="on bent stars of the orders 2 to 5 the normal turns 1 - m times on a circuit about "
        "the centre: -1 for the saddle, -2 for the monkey saddle",
    )
