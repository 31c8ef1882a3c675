"""Isometries of S^2 and H^2 as linear maps of triples.

Each function moves a point x; `matrix` gives the rows of the 3 by 3 matrix of a map. A half-turn
and a reflection need no root, so they stay rational on rational data.
"""

from collections.abc import Callable
from typing import Any

from discrete.geodesics import turned_direction
from discrete.space_forms import Product, Scalar, SpaceForm, Triple


def half_turn(dot: Product, centre: Triple, x: Triple) -> Triple:
    """Image of x under the half-turn about a point; the centre may be any multiple of the point.

    Undefined for <centre, centre> = 0.
    """
    k = 2 * dot(x, centre) / dot(centre, centre)
    return (k * centre[0] - x[0], k * centre[1] - x[1], k * centre[2] - x[2])


def reflection(dot: Product, normal: Triple, x: Triple) -> Triple:
    """Image of x under the reflection in the geodesic <normal, x> = 0; <normal, normal> > 0."""
    k = 2 * dot(x, normal) / dot(normal, normal)
    return (x[0] - k * normal[0], x[1] - k * normal[1], x[2] - k * normal[2])


def translation(dot: Product, p: Triple, q: Triple, x: Triple) -> Triple:
    """Image of x under the translation along the geodesic from p to q that moves p to q.

    Two half-turns: about p, then about the midpoint. Undefined for antipodal p, q on S^2.
    """
    s = (p[0] + q[0], p[1] + q[1], p[2] + q[2])
    return half_turn(dot, s, half_turn(dot, p, x))


def rotation(space: SpaceForm, functions: Any, p: Triple, angle: Scalar, x: Triple) -> Triple:
    """Image of x under the rotation about p by an angle (positive: from x1 to x2 at the origin)."""
    along_p = space.curvature * space.dot(p, x)
    level = (x[0] - along_p * p[0], x[1] - along_p * p[1], x[2] - along_p * p[2])
    turned = turned_direction(space, functions, p, level, angle)
    return (
        along_p * p[0] + turned[0],
        along_p * p[1] + turned[1],
        along_p * p[2] + turned[2],
    )


def matrix(isometry: Callable[[Triple], Triple]) -> tuple[Triple, Triple, Triple]:
    """Rows of the matrix of a linear map of triples."""
    columns = [isometry(e) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    first, second, third = (tuple(column[i] for column in columns) for i in range(3))
    return (first, second, third)


def apply(rows: tuple[Triple, Triple, Triple], x: Triple) -> Triple:
    """Image of x under a matrix given by rows."""
    return (
        rows[0][0] * x[0] + rows[0][1] * x[1] + rows[0][2] * x[2],
        rows[1][0] * x[0] + rows[1][1] * x[1] + rows[1][2] * x[2],
        rows[2][0] * x[0] + rows[2][1] * x[1] + rows[2][2] * x[2],
    )
