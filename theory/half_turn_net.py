"""Chebyshev nets on the unit sphere and the hyperboloid from broken geodesics, by half-turns.

The vertex opposite to p in a quad p, p1, p12, p2 is the half-turn of p about the midpoint of p1 p2:
a difference scheme of second order for N_uv = -(N_u.N_v) N. Points are arrays (..., 3), floats; the
third coordinate is the timelike one of the hyperboloid (curvature = -1).
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def inner(a: Array, b: Array, curvature: int) -> Array:
    """Product of the space form: Euclidean for curvature 1, Minkowski for -1."""
    product: Array = (
        a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + curvature * a[..., 2] * b[..., 2]
    )
    return product


def broken_geodesic(directions: Array, edge: float, curvature: int) -> Array:
    """Vertices of a broken geodesic from the pole with edges of this length.

    directions: angle of each edge to a frame moved in parallel along the line, which starts as the
    first two axes: at a vertex the line turns by the difference.
    """
    cosine, sine = (np.cos, np.sin) if curvature > 0 else (np.cosh, np.sinh)
    point = np.array([0.0, 0.0, 1.0])
    first, second = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    vertices = [point]
    for angle in directions:
        c, s = np.cos(angle), np.sin(angle)
        tangent, side = c * first + s * second, c * second - s * first
        moved = cosine(edge) * point + sine(edge) * tangent
        turned = cosine(edge) * tangent - curvature * sine(edge) * point
        point, first, second = moved, c * turned - s * side, s * turned + c * side
        vertices.append(point)
    return np.array(vertices)


def net(on_u: Array, on_v: Array, curvature: int) -> Array:
    """Vertices (i, j) of the net with these two sides, which start at one point.

    Filled diagonal by diagonal. Raises ValueError where the sides do not meet.
    """
    if not np.allclose(on_u[0], on_v[0]):
        raise ValueError("the two sides of the net do not start at one point")
    n, m = len(on_u), len(on_v)
    points = np.zeros((n, m, 3))
    points[:, 0], points[0, :] = on_u, on_v
    for total in range(2, n + m - 1):
        i = np.arange(max(1, total - m + 1), min(n, total))
        j = total - i
        corner, mid = points[i - 1, j - 1], points[i - 1, j] + points[i, j - 1]
        factor = 2 * inner(corner, mid, curvature) / inner(mid, mid, curvature)
        points[i, j] = factor[:, None] * mid - corner
    return points


def angle(points: Array, curvature: int) -> Array:
    """Angle at the first vertex of each quad, in (0, pi), from its edges in space."""
    a, b = points[1:, :-1] - points[:-1, :-1], points[:-1, 1:] - points[:-1, :-1]
    lengths = np.sqrt(inner(a, a, curvature) * inner(b, b, curvature))
    found: Array = np.arccos(np.clip(inner(a, b, curvature) / lengths, -1, 1))
    return found
