r"""Bending energy of a pseudospherical net near a singular edge, phi = 0 or pi (eqn:gammalimit).

Per du dv the sum of the powers of the curvatures times the area element sin phi; with e the
distance of phi from 0 or pi. Near an edge the coordinates are a distance t from it and what runs
along it, and the weight w(t) is the length of the level set of t in (u, v).
"""

from typing import Any

import sympy as sp

from theory.curvature import principal_curvatures

T = sp.Symbol("t", positive=True)

CONTACTS: dict[str, tuple[int, Any]] = {
    # Name: power k of t in e <= c t^k, and the weight.
    "crossing": (1, sp.Integer(1)),
    "point, smooth": (2, 2 * sp.pi * T),
    "point, corner": (1, 2 * sp.pi * T),
    # A disk of H^2: the distance to the edge is of order t^2 there, so that its rim is a corner.
    "rim tangent to the edge": (1, 2 * T),
}


def density(phi: Any, *, power: int = 2) -> Any:
    """Sum of the powers of the sizes of both curvatures, times sin phi."""
    larger, smaller = principal_curvatures(phi)
    return (larger**power + (-smaller) ** power) * sp.sin(phi)


def leading(power: int) -> tuple[Any, int]:
    """Coefficient c and exponent p of the density c e^p, e the small angle from an edge."""
    e = sp.Symbol("e", positive=True)
    # |tan(phi/2)| tends to 2/e at pi, |cot(phi/2)| at 0: the density is of order e^(1 - power).
    exponent = 1 - power if power > 1 else 0
    return sp.limit(density(e, power=power) / e**exponent, e, 0, "+"), exponent


def energy_outside(contact: str, cut: Any, *, power: int = 2) -> Any:
    """Leading part of the energy at distances from cut to 1 of an edge met in this way, c = 1."""
    order, weight = CONTACTS[contact]
    coefficient, exponent = leading(power)
    return sp.integrate(coefficient * T ** (order * exponent) * weight, (T, cut, 1))
