"""Chebyshev net in the hyperbolic plane between two geodesics from a point: an Amsler sector.

Points are triples (x0, x1, x2) of the hyperboloid x0^2 - x1^2 - x2^2 = 1, x0 > 0. The edges have
equal sides of length h on geodesics; the fourth vertex of a quad is the half-turn of the first
about the middle of the other two, so that opposite sides are equal. Float64, within distance 2.
"""

from math import acos, cos, cosh, sin, sinh, sqrt

Point = tuple[float, float, float]


def product(a: Point, b: Point) -> float:
    """Minkowski product of signature -++."""
    return -a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def half_turn(point: Point, first: Point, second: Point) -> Point:
    """Half-turn of a point about the middle of two others."""
    s = (first[0] + second[0], first[1] + second[1], first[2] + second[2])
    k = 2 * product(point, s) / product(s, s)
    return (k * s[0] - point[0], k * s[1] - point[1], k * s[2] - point[2])


def net(alpha: float, length: float, cells: int) -> list[list[Point]]:
    """Vertices (i, j) over [0, length]^2, the edges leaving (1, 0, 0) at the angle alpha."""
    steps = [length * i / cells for i in range(cells + 1)]
    columns: list[list[Point]] = [[(cosh(s), sinh(s), 0.0)] for s in steps]
    columns[0] = [(cosh(t), sinh(t) * cos(alpha), sinh(t) * sin(alpha)) for t in steps]
    for i in range(cells):
        for j in range(cells):
            columns[i + 1].append(half_turn(columns[i][j], columns[i + 1][j], columns[i][j + 1]))
    return columns


def corner_angle(point: Point, first: Point, second: Point) -> float:
    """Angle at a point between the geodesics to two others."""
    ab = product(first, second) + product(first, point) * product(second, point)
    aa = product(first, point) ** 2 - 1
    bb = product(second, point) ** 2 - 1
    return acos(ab / sqrt(aa * bb))


def far_angle(alpha: float, length: float, cells: int) -> float:
    """Angle of the last quad at the corner opposite to the apex."""
    columns = net(alpha, length, cells)
    return corner_angle(columns[-1][-1], columns[-2][-1], columns[-1][-2])
