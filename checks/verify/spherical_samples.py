"""Spherical nets for the checks of section 4: rational stars around a vertex, and what they are."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, pi, sin
from typing import Any

import sympy as sp
from flint import arb, ctx

from checks.ball import enclosure
from checks.verify.unit_vectors import circle
from discrete.elementary import ball_functions
from discrete.spherical_net import SphericalNet, assembled, corner_angles, corner_parts
from theory.vectors import Vector

#: Start of all curves, in the discrete side's order the origin (1, 0, 0) of S^2.
POLE: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
EDGE = sp.Rational(1, 10)


def direction(angle: float) -> tuple[Any, Any]:
    """Rational point of the circle near an angle."""
    turned = (angle + pi) % (2 * pi) - pi
    if abs(turned) > pi / 2:
        x, y = direction(turned - pi if turned > 0 else turned + pi)
        return -x, -y
    return circle(sp.Rational(round(1000 * sin(turned) / (1 + cos(turned))), 1000))


def ray(angle: float, edges: int, *, edge: Any = EDGE, turns: Sequence[Any] = ()) -> list[Vector]:
    """Rational polyline from the pole, in a direction near an angle, with edges 2 arctan edge.

    turns: half-tangents of its left turns, 0 where none is given.
    """
    x, y = direction(angle)
    at, along = POLE, (sp.Integer(0), x, y)
    c, s = circle(edge)
    found = [at]
    for k in range(edges):
        if k and k <= len(turns):
            along = _turned(at, along, *circle(turns[k - 1]))
        onwards = _combined(at, along, c, s)
        along = _combined(along, at, c, -s)
        at = onwards
        found.append(at)
    return found


def _combined(a: Vector, b: Vector, c: Any, s: Any) -> Vector:
    return (c * a[0] + s * b[0], c * a[1] + s * b[1], c * a[2] + s * b[2])


def _turned(p: Vector, along: Vector, c: Any, s: Any) -> Vector:
    left = (
        p[1] * along[2] - p[2] * along[1],
        p[2] * along[0] - p[0] * along[2],
        p[0] * along[1] - p[1] * along[0],
    )
    return _combined(along, left, c, s)


def star_net(
    order: int,
    *,
    winding: int | None = None,
    edges: int = 2,
    uneven: float = 0.15,
    curved: bool = True,
    edge: Any = EDGE,
) -> SphericalNet:
    """Star of 2m rational curves whose directions turn `winding` times, 1 - m by default.

    uneven: how far the directions are from equal angles, in radians; curved: whether the curves
    turn.
    """
    times = 1 - order if winding is None else winding
    rays = []
    for k in range(2 * order):
        angle = 2 * pi * times * k / (2 * order) + uneven * sin(2.3 * k)
        turns = [sp.Rational((-1) ** k, 20)] * (edges - 1) if curved else []
        rays.append(ray(angle, edges, edge=edge, turns=turns))
    return assembled(rays)


def ball(number: Any) -> arb:
    """Ball around a rational or algebraic number, at the precision in force."""
    return number if isinstance(number, arb) else enclosure(sp.sympify(number), {})


def balled(net: SphericalNet) -> SphericalNet:
    """The same net with balls as coordinates, at the precision in force."""
    normals = tuple(tuple(ball(entry) for entry in n) for n in net.normals)
    return SphericalNet(complex=net.complex, normals=normals)


def ball_angles(net: SphericalNet) -> Any:
    """Signed corner angles of a net as balls, at the precision in force."""
    return corner_angles(balled(net), ball_functions())


def nearest_integer(x: arb) -> int | None:
    """The one integer in a ball, or None."""
    found = x.unique_fmpz()
    return None if found is None else int(found)


def half_turns(net: SphericalNet, vertex: int, *, bits: int = 128) -> int | None:
    """Sum of the signed angles at an interior vertex in units of pi, known to be an integer."""
    with ctx.workprec(bits):
        angles = ball_angles(net)
        total = sum(
            (
                angles[face, k]
                for face, k in zip(*(net.complex.faces == vertex).nonzero(), strict=True)
            ),
            arb(0),
        )
        return nearest_integer(total / arb.pi())


def reverses_orientation(net: SphericalNet) -> bool:
    """Whether all corners of all rhombi turn against the complex, decided exactly or by balls."""
    sines, _ = corner_parts(net)
    return all(bool(sine < 0) for sine in sines.ravel())


def broken_side(net: SphericalNet) -> str:
    """First two sides of a face with different products, in exact numbers; or nothing."""
    for face, corners in enumerate(net.complex.faces.tolist()):
        around = [net.normals[v] for v in corners]
        products = [
            sum(x * y for x, y in zip(a, b, strict=True)) for a, b in pairwise([*around, around[0]])
        ]
        for k in range(1, 4):
            if products[k] != products[0]:
                return f"face {face}: the sides have the products {products[0]} and {products[k]}"
    return ""
