"""Normals of a front whose angle is continuous and nowhere differentiable along its edges.

The edges u = 0 and v = 0 are C^1 curves of unit speed on the sphere whose direction turns by a
Weierstrass function of Hoelder exponent 1/2, so that no geodesic curvature exists. Between them the
Moutard equation N_uv = -(N_u . N_v) N is solved by half-turns: N_12 is the half-turn of N about the
middle of N_1 and N_2. Angles in radians, float64.
"""

from math import atan2, cos, sin, sqrt
from typing import Any

Point = tuple[float, float, float]

TERMS = 14
AMPLITUDE = 0.15
FINE = 32
"""Steps of a curve to a side of the grid."""


def turning(t: float, phase: float) -> float:
    """Weierstrass function sum of 2^-k cos(4^k t + k phase), times the amplitude, 0 at t = 0."""
    terms = ((cos(4**k * t + k * phase) - cos(k * phase)) / 2.0**k for k in range(TERMS))
    return AMPLITUDE * sum(terms)


def edge(cells: int, length: float, phase: float, direction: float) -> list[Point]:
    """Points of an edge at equal distances, from (0, 0, 1) in this direction."""
    step = length / (cells * FINE)
    normal, first, second = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
    points = [normal]
    for n in range(cells * FINE):
        turn = direction + turning((n + 0.5) * step, phase)
        along = _combined(cos(turn), first, sin(turn), second)
        across = _combined(-sin(turn), first, cos(turn), second)
        moved = _combined(cos(step), normal, sin(step), along)
        along = _combined(-sin(step), normal, cos(step), along)
        normal = moved
        first = _combined(cos(turn), along, -sin(turn), across)
        second = _combined(sin(turn), along, cos(turn), across)
        if (n + 1) % FINE == 0:
            points.append(normal)
    return points


def normals(cells: int, length: float, angle: float) -> list[list[Point]]:
    """Grid of normals over [0, length]^2, the edges leaving the corner at this angle."""
    columns = [[point] for point in edge(cells, length, 1.0, 0.0)]
    columns[0] = edge(cells, length, 2.3, angle)
    for i in range(cells):
        for j in range(cells):
            columns[i + 1].append(_half_turn(columns[i][j], columns[i + 1][j], columns[i][j + 1]))
    return columns


def cell_angles(grid: list[list[Point]]) -> list[list[float]]:
    """Angle between N_u and N_v in the middle of each cell, from two opposite corners of it."""
    cells = range(len(grid) - 1)
    return [
        [
            (
                _corner(grid[i][j], grid[i + 1][j], grid[i][j + 1])
                + _corner(grid[i + 1][j + 1], grid[i][j + 1], grid[i + 1][j])
            )
            / 2
            for j in cells
        ]
        for i in cells
    ]


def area(angles: list[list[float]], length: float) -> float:
    """Integral of the sine between the middles of the outer cells, by the trapezoidal rule."""
    last = len(angles) - 1
    weights = [0.5 if i in (0, last) else 1.0 for i in range(last + 1)]
    total = sum(
        a * b * sin(angles[i][j]) for i, a in enumerate(weights) for j, b in enumerate(weights)
    )
    return float(total * (length / (last + 1)) ** 2)


def _combined(a: float, first: Point, b: float, second: Point) -> Point:
    return (
        a * first[0] + b * second[0],
        a * first[1] + b * second[1],
        a * first[2] + b * second[2],
    )


def _dot(a: Point, b: Point) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _half_turn(point: Point, first: Point, second: Point) -> Point:
    middle = _combined(1.0, first, 1.0, second)
    factor = 2 * _dot(point, middle) / _dot(middle, middle)
    return _combined(factor, middle, -1.0, point)


def _corner(point: Point, first: Point, second: Point) -> float:
    """Angle at a point of the sphere between the arcs to two others."""
    a: Any = _combined(1.0, first, -_dot(first, point), point)
    b: Any = _combined(1.0, second, -_dot(second, point), point)
    across = sqrt(max(_dot(a, a) * _dot(b, b) - _dot(a, b) ** 2, 0.0))
    return atan2(across, _dot(a, b))
