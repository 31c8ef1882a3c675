"""Goursat problem of a sector solved row by row: an equation in v for the rows u -> phi, x.

d/dv phi(u, v) = phi_v(0, v) + int_0^u sin phi du', and likewise x_uv = cos(phi) x: spectral in u,
DOP853 in v. Float64, tolerances stated; scipy is imported when a function is called.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import cosh, inf, pi
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev

from theory.sector_side import Side, integration

TOLERANCE = 1e-12

#: Interval of u.
Part = tuple[float, float]

#: Rows looked at within one step of the integrator, and points on a row, to bracket an event.
ROWS, POINTS = 5, 160


@dataclass(frozen=True, kw_only=True, eq=False)
class Crossing:
    """Row where the cutoff is reached first, or None; largest: angle phi seen at the rim."""

    v: float | None
    row: Side | None
    largest: float


def _rate(first: Side, second: Side) -> Callable[[float, Any], Any]:
    count = len(first.values)
    summed = integration(count) * first.length
    slope = chebyshev.chebder(second.series) * (2 / second.length)

    def rate(v: float, state: Any) -> Any:
        row = state.reshape(count, 4)
        source = np.empty_like(row)
        source[:, 0] = np.sin(row[:, 0])
        source[:, 1:] = np.cos(row[:, :1]) * row[:, 1:]
        side = chebyshev.chebval(2 * v / second.length - 1, slope)
        return (side + summed @ source).ravel()

    return rate


def rows(first: Side, second: Side) -> Iterator[tuple[float, float, Callable[[float], Side]]]:
    """Intervals of v that cover the second side, and for each the function from v to the row."""
    from scipy.integrate import DOP853

    solver = DOP853(
        _rate(first, second), 0.0, first.values.ravel().copy(), second.length,
        rtol=TOLERANCE, atol=TOLERANCE,
    )  # fmt: skip
    while solver.status == "running":
        solver.step()
        if solver.status == "failed":
            raise ArithmeticError(f"the integrator stopped at v = {solver.t}")
        yield float(solver.t_old), float(solver.t), _row_between(first, solver.dense_output())


def _row_between(first: Side, between: Any) -> Callable[[float], Side]:
    return lambda v: Side(length=first.length, values=between(v).reshape(-1, 4))


def part_in_disk(row: Side, radius: float, below: Part) -> Part | None:
    """Part [u, u'] of a row in the disk that lies above the part of a row below; None without one.

    Beyond a singular edge the net may fold back into the disk: that part is not reached.
    Raises ArithmeticError where the part ends with the row.
    """
    from scipy.optimize import brentq

    height = row.series[:, 1]

    def level(s: Any) -> Any:
        return chebyshev.chebval(2 * s / row.length - 1, height) - cosh(radius)

    u = np.linspace(0, row.length, POINTS)
    inside = (level(u) <= 0) & (u >= below[0] - u[2])
    if not inside.any():
        return None
    start = int(np.argmax(inside))
    if u[start] > below[1] + u[2]:
        return None
    outside = np.flatnonzero(~inside[start:])
    if len(outside) == 0:
        raise ArithmeticError("a row ends in the disk: its sides are too short")
    k = start + int(outside[0])
    end = float(brentq(level, u[k - 1], u[k], xtol=1e-14, rtol=1e-14))
    return float(u[start]), end


def first_crossing(first: Side, second: Side, radius: float, cutoff: float) -> Crossing:
    """Least v whose row reaches the cutoff angle within the disk, at its rim, and that row.

    phi increases along a row wherever it does on the first side and lies below pi.
    """
    from scipy.optimize import brentq

    largest, part = -inf, (0.0, inf)
    for start, end, row in rows(first, second):
        points = np.linspace(start, end, ROWS + 1)
        for before, v in pairwise(points):
            below, reached = part, part_in_disk(row(v), radius, part)
            if reached is None:
                return Crossing(v=None, row=None, largest=largest)
            part = reached
            angle = float(row(v).at(part[1])[0])
            largest = max(largest, angle)
            if angle > cutoff:

                def excess(w: float, row: Any = row, below: Part = below) -> float:
                    found = part_in_disk(row(w), radius, below)
                    return pi if found is None else float(row(w).at(found[1])[0]) - cutoff

                at = float(brentq(excess, before, v, xtol=1e-14, rtol=1e-14))
                return Crossing(v=at, row=row(at), largest=cutoff)
    raise ArithmeticError("the uppermost row meets the disk: the sides are too short")
