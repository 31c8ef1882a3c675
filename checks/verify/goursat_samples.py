"""Rational data on S^2 for discrete Goursat problems: polylines with exact unit vectors."""

from collections.abc import Sequence

import sympy as sp

from checks.verify.unit_vectors import circle
from theory.vectors import Vector

TENTH = sp.Rational(1, 10)
START: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
#: Half-tangents of the turns at the vertices of two curved sides, in twentieths.
_TURNS = {1: (1, -2, 3, 1, -1), 2: (-1, 2, 1, -3, 2)}


def walked(
    half_tangents: Sequence[sp.Rational], turns: Sequence[sp.Rational], *, heading: sp.Rational
) -> list[Vector]:
    """Polyline from (1, 0, 0) with edges 2 arctan of these; turns: half-tangents of left turns.

    heading: half-tangent of the angle from x_1 to its first edge. All vertices are rational.
    """
    c, s = circle(heading)
    at, along = START, (sp.Integer(0), c, s)
    found = [at]
    for k, t in enumerate(half_tangents):
        if k:
            c, s = circle(turns[k - 1])
            side = _cross(at, along)
            along = (
                c * along[0] + s * side[0],
                c * along[1] + s * side[1],
                c * along[2] + s * side[2],
            )
        c, s = circle(t)
        onwards = (c * at[0] + s * along[0], c * at[1] + s * along[1], c * at[2] + s * along[2])
        along = (c * along[0] - s * at[0], c * along[1] - s * at[1], c * along[2] - s * at[2])
        at = onwards
        found.append(at)
    return found


def _cross(a: Vector, b: Vector) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def curved_side(which: int, *, edges: int = 3) -> list[Vector]:
    """Side 1 (heading x_1) or 2 (heading -x_2) with turns and edges of unequal lengths."""
    lengths = [sp.Rational(1, 8 + which + k % 3) for k in range(edges)]
    turns = [sp.Rational(_TURNS[which][k % 5], 20) for k in range(edges - 1)]
    return walked(lengths, turns, heading=sp.Integer(0) if which == 1 else sp.Integer(-1))


def far_sides(
    u_edges: int, v_edges: int, *, edge: sp.Rational = TENTH
) -> tuple[list[Vector], list[Vector]]:
    """Two curved sides with edges of one length 2 arctan edge, in directions apart."""
    sides = []
    for which, count in ((1, u_edges), (2, v_edges)):
        turns = [sp.Rational(_TURNS[which][k % 5], 20) for k in range(count - 1)]
        heading = sp.Integer(0) if which == 1 else sp.Rational(-3, 4)
        sides.append(walked([edge] * count, turns, heading=heading))
    return sides[0], sides[1]
