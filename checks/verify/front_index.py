"""Ramification index of the normal at points of smooth pseudospherical fronts, in balls."""

from typing import Any

import sympy as sp
from flint import arb, fmpq

from checks.ball import enclosure
from checks.ball_arguments import value_on
from checks.printed import normal_map as printed
from theory.polynomial_graph import circle
from theory.surfaces import Front, dini, kuen, pseudosphere
from theory.vectors import Vector, cross, derivative, dot
from theory.winding import winding_by_arcs

_SMALL = fmpq(1, 50)
_POINTS = ((sp.Rational(1), sp.Rational(1, 3)), (sp.Rational(3, 2), sp.Rational(-1, 2)),
           (sp.Rational(1, 2), sp.Rational(1)))  # fmt: skip


def front_indices(*, radius: fmpq = _SMALL, points: int = 3) -> dict[str, int]:
    """J_p at points of three smooth fronts, along circles of this radius in the (u, v)-plane."""
    fronts = (pseudosphere(), dini(sp.Rational(3, 2)), kuen())
    return {
        f"{front.name} at (u, v) = {point}": _front_index(front, point, radius)
        for front in fronts
        for point in _POINTS[:points]
    }


def _front_index(front: Front, point: tuple[Any, Any], radius: fmpq) -> int:
    """J_p of a front at a point off its edges, along a circle of its (u, v)-plane, in balls."""
    u, v = sp.symbols("u v", real=True)
    normal, position = front.at(front.normal, u, v), front.at(front.position, u, v)
    place = {u: point[0], v: point[1]}
    pole = _values(normal, place)
    r_u, r_v = (_values(derivative(position, s), place) for s in (u, v))
    area = dot(cross(r_u, r_v), pole)
    if not (area > 0 or area < 0):
        raise ArithmeticError("the point lies too near to an edge")
    side = 1 if area > 0 else -1
    first = cross(pole, (arb(1), arb(2), arb(3)))
    second = cross(pole, first)

    def loop(t: arb) -> tuple[arb, arb]:
        x, y = circle(t, radius, turns=side)
        there = {u: x + enclosure(point[0], {}), v: y + enclosure(point[1], {})}
        x, y, z = (value_on(entry, there) for entry in normal)
        part = printed.tangential_part(pole, (x, y, z))
        return dot(part, first), dot(part, second)

    return winding_by_arcs(loop)


def _values(a: Vector, place: dict[sp.Symbol, Any]) -> Vector:
    """Triple of balls from a triple of expressions."""
    return (enclosure(a[0], place), enclosure(a[1], place), enclosure(a[2], place))
