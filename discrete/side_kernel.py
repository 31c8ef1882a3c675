"""Compiled sides of a sector: the polyline on H^2, and its frames on a K-surface.

In space the edges at a vertex lie in the tangent plane, at the angles of the net on H^2, and the
normal turns about a u-edge by minus, about a v-edge by plus the Gudermannian of its length.
"""

import math
from functools import cache
from typing import Any

from discrete.compilation import Kernel, compiled, stamp_of


def hyperbolic_side(length: float, start: float, left_turns: Any, side: Any) -> None:
    """Vertices side[:, k] of the hyperboloid, from its origin in the direction `start`.

    left_turns[k]: at vertex k; the first and the last are not used.
    """
    cosh, sinh = math.cosh(length), math.sinh(length)
    x0, x1, x2 = 1.0, 0.0, 0.0
    t0, t1, t2 = 0.0, math.cos(start), math.sin(start)
    n0, n1, n2 = 0.0, -math.sin(start), math.cos(start)
    side[0, 0], side[1, 0], side[2, 0] = x0, x1, x2
    for k in range(1, side.shape[1]):
        y0, y1, y2 = cosh * x0 + sinh * t0, cosh * x1 + sinh * t1, cosh * x2 + sinh * t2
        t0, t1, t2 = sinh * x0 + cosh * t0, sinh * x1 + cosh * t1, sinh * x2 + cosh * t2
        x0, x1, x2 = y0, y1, y2
        side[0, k], side[1, k], side[2, k] = x0, x1, x2
        c, s = math.cos(left_turns[k]), math.sin(left_turns[k])
        u0, u1, u2 = c * t0 + s * n0, c * t1 + s * n1, c * t2 + s * n2
        n0, n1, n2 = c * n0 - s * t0, c * n1 - s * t1, c * n2 - s * t2
        t0, t1, t2 = u0, u1, u2


def spherical_side(length: float, twist: float, left_turns: Any, frame: Any, side: Any) -> None:
    """Normals side[:, k] along a side; frame: normal and direction of the first edge, (2, 3).

    length: of an edge on H^2; twist: -1 for u-edges, 1 for v-edges.
    """
    d, cosine = math.tanh(length), 1 / math.cosh(length)
    x0, x1, x2 = frame[0, 0], frame[0, 1], frame[0, 2]
    t0, t1, t2 = frame[1, 0], frame[1, 1], frame[1, 2]
    side[0, 0], side[1, 0], side[2, 0] = x0, x1, x2
    for k in range(1, side.shape[1]):
        w0, w1, w2 = t1 * x2 - t2 * x1, t2 * x0 - t0 * x2, t0 * x1 - t1 * x0
        f = twist * d
        x0, x1, x2 = cosine * x0 + f * w0, cosine * x1 + f * w1, cosine * x2 + f * w2
        side[0, k], side[1, k], side[2, k] = x0, x1, x2
        c, s = math.cos(left_turns[k]), math.sin(left_turns[k])
        w0, w1, w2 = x1 * t2 - x2 * t1, x2 * t0 - x0 * t2, x0 * t1 - x1 * t0
        t0, t1, t2 = c * t0 + s * w0, c * t1 + s * w1, c * t2 + s * w2


def net_points(normals: Any, points: Any) -> None:
    """Positions of a net from its normals by the Lelieuvre formulas; points[:, 0, 0] is given."""
    for i in range(points.shape[1]):
        if i > 0:
            add_edge(normals, points, i, 0, i - 1, 0, 1.0)
        for j in range(1, points.shape[2]):
            add_edge(normals, points, i, j, i, j - 1, -1.0)


def add_edge(normals: Any, points: Any, i: int, j: int, k: int, m: int, sign: float) -> None:
    """Position of vertex (i, j) from that of (k, m): plus or minus the cross product of normals."""
    a0, a1, a2 = normals[0, i, j], normals[1, i, j], normals[2, i, j]
    b0, b1, b2 = normals[0, k, m], normals[1, k, m], normals[2, k, m]
    points[0, i, j] = points[0, k, m] + sign * (a1 * b2 - a2 * b1)
    points[1, i, j] = points[1, k, m] + sign * (a2 * b0 - a0 * b2)
    points[2, i, j] = points[2, k, m] + sign * (a0 * b1 - a1 * b0)


@cache
def hyperbolic_side_kernel() -> Kernel:
    """Compiled `hyperbolic_side`."""
    stamp = stamp_of(hyperbolic_side)

    def side_of(length: float, start: float, left_turns: Any, side: Any) -> None:
        _ = stamp
        hyperbolic_side(length, start, left_turns, side)

    return compiled(side_of)


@cache
def spherical_side_kernel() -> Kernel:
    """Compiled `spherical_side`."""
    stamp = stamp_of(spherical_side)

    def side_of(length: float, twist: float, left_turns: Any, frame: Any, side: Any) -> None:
        _ = stamp
        spherical_side(length, twist, left_turns, frame, side)

    return compiled(side_of)


@cache
def points_kernel() -> Kernel:
    """Compiled `net_points`."""
    stamp = stamp_of(add_edge, net_points)

    def points_of(normals: Any, points: Any) -> None:
        _ = stamp
        net_points(normals, points)

    return compiled(points_of)
