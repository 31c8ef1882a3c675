"""Polygons of asymptotic arcs in one coordinate patch: Hazzidakis' formula cell by cell.

The patch has lines u = u_0, u_1, ... and v = v_0, v_1, ...; a polygon is the tuple of its vertices
(i, j) in order, neighbours differing in one index. The angle phi at (u_i, v_j) is unknown.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import Any

import sympy as sp

Point = tuple[int, int]
Polygon = tuple[Point, ...]
Angle = Callable[[Point], Any]

POLYGONS: dict[str, Polygon] = {
    "rectangle": ((0, 0), (2, 0), (2, 1), (0, 1)),
    "L": ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)),
    "U": ((0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 3), (0, 3)),
    "staircase": ((0, 0), (4, 0), (4, 1), (3, 1), (3, 2), (2, 2), (2, 3), (0, 3)),
    "cross": ((1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2),
              (2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1)),
    "spiral": ((0, 0), (5, 0), (5, 4), (1, 4), (1, 2), (3, 2), (3, 3), (4, 3), (4, 1), (0, 1)),
}  # fmt: skip
"""Counter-clockwise polygons of the (u, v)-plane."""


def unknown_angle(point: Point) -> sp.Symbol:
    """Angle at a point of the grid, a symbol of its own."""
    return sp.Symbol(f"phi_{point[0]}_{point[1]}", real=True)


def arcs(polygon: Polygon) -> list[tuple[Point, Point]]:
    """Sides of the polygon in order."""
    return list(pairwise((*polygon, polygon[0])))


def family(arc: tuple[Point, Point]) -> str:
    """Letter of the coordinate that runs along the arc, "other" where both do."""
    (a, b), (c, d) = arc
    return "other" if a != c and b != d else "u" if b == d else "v"


def is_simple(polygon: Polygon) -> bool:
    """Whether a closed polygon of u- and v-arcs passes each point of the grid once at most."""
    passed: list[Point] = []
    for (a, b), (c, d) in arcs(polygon):
        steps = max(abs(c - a), abs(d - b))
        passed += [(a + (c - a) * k // steps, b + (d - b) * k // steps) for k in range(steps)]
    return len(set(passed)) == len(passed)


def oriented(polygon: Polygon, *, sigma: int) -> Polygon:
    """Give the polygon the orientation sigma du dv, its first side being a u-arc."""
    turned = polygon if sigma == 1 else polygon[::-1]
    for shift in range(2):
        moved = turned[shift:] + turned[:shift]
        if family(arcs(moved)[0]) == "u":
            return moved
    raise ValueError("the polygon has no u-arc at its beginning or after its first side")


def boundary_integral(polygon: Polygon, angle: Angle, *, sign_u: int = -1) -> Any:
    """Integral of (phi_v dv + sign_u phi_u du)/2 along the polygon, by its values at the ends."""
    total = sp.Integer(0)
    for start, end in arcs(polygon):
        weight = sign_u if family((start, end)) == "u" else 1
        total += weight * (angle(end) - angle(start)) / 2
    return total


def cells(polygon: Polygon) -> list[Point]:
    """Cells (i, j) = [u_i, u_i+1] x [v_j, v_j+1] inside the polygon, by counting crossings."""
    width, height = (max(p[k] for p in polygon) for k in (0, 1))
    return [(i, j) for i in range(width) for j in range(height) if _inside(polygon, i, j)]


def _inside(polygon: Polygon, i: int, j: int) -> bool:
    crossed = 0
    for (a, b), (c, d) in arcs(polygon):
        crossed += a == c and a > i and min(b, d) <= j < max(b, d)
    return crossed % 2 == 1


def cell_difference(cell: Point, angle: Angle) -> Any:
    """Integral of phi_uv du dv over a cell, by its values at the corners."""
    i, j = cell
    return angle((i + 1, j + 1)) - angle((i, j + 1)) - angle((i + 1, j)) + angle((i, j))


def pendulum_rhombus_area(largest: Any, least: Any) -> Any:
    """Area of a rhombus on Minding's bobbin, its angle falling from largest to least.

    phi = P(u - v) with P'' = -sin P, P'(0) = 0, on [0, L]^2 with P(0) = largest, P(L) = least > 0.
    The area is 2 int_0^L (L - x) sin P dx, and its derivative by L is 2 int_0^L sin P = -2 P'(L).
    """
    return 2 * (largest - least)


def pendulum_defect() -> Any:
    """Derivative by L of the integral above minus that of 2 P(0) - 2 P(L), for an unknown P."""
    length, x = sp.symbols("L x", positive=True)
    p = sp.Function("P")
    by_length = sp.diff(2 * sp.Integral((length - x) * -p(x).diff(x, 2), (x, 0, length)), length)
    inner = by_length.doit().subs(p(x).diff(x).subs(x, 0), 0)
    return sp.simplify(inner - sp.diff(-2 * p(length), length))
