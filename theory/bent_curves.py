"""Frenet-Serret series of a curve of constant torsion whose curvature is a polynomial, and fronts.

The frame (T, N x T, N), N the binormal, turns by T' = k N x T, (N x T)' = -k T + tau N,
N' = -tau N x T. Fronts are integrated from the series of a weakly harmonic normal by
r_u = N_u x N, r_v = -N_v x N.
"""

from collections.abc import Sequence
from typing import Any

import sympy as sp

from theory.moutard import ZERO, Series
from theory.vectors import Vector, added, cross, scaled

Rows = tuple[Vector, Vector, Vector]


def frame_coefficients(
    tangent: Vector, normal: Vector, curvature: Sequence[Any], torsion: int, *, order: int
) -> list[Rows]:
    """Taylor coefficients of (T, N x T, N) by arc length; curvature: those of the curvature."""
    rows: list[Rows] = [(tangent, cross(normal, tangent), normal)]
    for n in range(order):
        bent: Vector = ZERO
        straight: Vector = ZERO
        for j, k in enumerate(curvature[: n + 1]):
            bent = added(bent, scaled(k, rows[n - j][1]))
            straight = added(straight, scaled(k, rows[n - j][0]))
        side = added(scaled(-1, straight), scaled(torsion, rows[n][2]))
        turned = scaled(-torsion, rows[n][1])
        step = sp.Rational(1, n + 1)
        rows.append((_expanded(step, bent), _expanded(step, side), _expanded(step, turned)))
    return rows


def _expanded(factor: Any, a: Vector) -> Vector:
    return (sp.expand(factor * a[0]), sp.expand(factor * a[1]), sp.expand(factor * a[2]))


def binormals(
    tangent: Vector, normal: Vector, curvature: Sequence[Any], torsion: int, *, order: int
) -> list[Vector]:
    """Taylor coefficients of the binormal."""
    return [
        rows[2] for rows in frame_coefficients(tangent, normal, curvature, torsion, order=order)
    ]


def lelieuvre_series(normal: Series, order: int) -> tuple[Series, Series]:
    """Taylor coefficients of r_u and r_v from those of N, up to a total degree."""
    r_u: Series = {}
    r_v: Series = {}
    for i in range(order + 1):
        for j in range(order + 1 - i):
            first, second = ZERO, ZERO
            for a in range(i + 1):
                for b in range(j + 1):
                    rest = normal[i - a, j - b]
                    first = added(first, cross(scaled(a + 1, normal[a + 1, b]), rest))
                    second = added(second, cross(scaled(b + 1, normal[a, b + 1]), rest))
            r_u[i, j], r_v[i, j] = _expanded(1, first), _expanded(-1, second)
    return r_u, r_v


def position_series(rates: tuple[Series, Series]) -> Series:
    """Taylor coefficients of r, along v = 0 and then along v; r(0, 0) = 0."""
    r_u, r_v = rates
    position: Series = {(0, 0): ZERO}
    for i, j in sorted(r_u, key=sum):
        if j == 0:
            position[i + 1, 0] = scaled(sp.Rational(1, i + 1), r_u[i, 0])
        position[i, j + 1] = scaled(sp.Rational(1, j + 1), r_v[i, j])
    return position
