"""Closed one-forms p du + q dv with values in R^3, and the maps that they integrate to."""

from typing import Any

import sympy as sp

from theory.vectors import Vector, added, derivative, scaled


def _integrated(entry: Any, u: sp.Symbol, v: sp.Symbol, weight: int) -> Any:
    terms = sp.Poly(entry, u, v).terms()
    return sum((c * u**i * v**j / (i + j + weight + 1) for (i, j), c in terms), sp.Integer(0))


def radial_integral(a: Vector, u: sp.Symbol, v: sp.Symbol, *, weight: int = 0) -> Vector:
    """Integral of t^weight a(t u, t v) over 0 <= t <= 1 for polynomials a in u and v."""
    return (
        _integrated(a[0], u, v, weight),
        _integrated(a[1], u, v, weight),
        _integrated(a[2], u, v, weight),
    )


def primitive(p: Vector, q: Vector, u: sp.Symbol, v: sp.Symbol) -> Vector:
    """Integral of p du + q dv from the origin to (u, v) along the segment, p and q polynomials.

    It solves r_u = p, r_v = q where a solution exists.
    """
    return added(
        scaled(u, radial_integral(p, u, v)),
        scaled(v, radial_integral(q, u, v)),
    )


def primitive_defect(p: Vector, q: Vector, u: sp.Symbol, v: sp.Symbol) -> tuple[Vector, Vector]:
    """Differences r_u - p and r_v - q for the primitive r of p du + q dv."""
    r = primitive(p, q, u, v)
    return (
        added(derivative(r, u), scaled(-1, p)),
        added(derivative(r, v), scaled(-1, q)),
    )
