"""Section 3.1, items (A) to (F), as printed: frames, Lelieuvre formulae, the oriented normal.

Vectors are triples, in R^3 or by coefficients in a moving basis, so the cross product is handed in.
"""

from collections.abc import Callable
from typing import Any

import sympy as sp

from theory.vectors import Vector, scaled

Cross = Callable[[Vector, Vector], Vector]
Rows = tuple[tuple[Any, Any, Any], tuple[Any, Any, Any], tuple[Any, Any, Any]]


def unit_normal(r_u: Vector, r_v: Vector, norm: Any, cross: Cross, *, sign: int = 1) -> Vector:
    """Item (A): N = +- r_u x r_v / |r_u x r_v|; norm: that of r_u x r_v."""
    return scaled(sign / norm, cross(r_u, r_v))


def frame(tangent: Vector, normal: Vector, cross: Cross) -> tuple[Vector, Vector, Vector]:
    """Item (B): the frame (r_u, N x r_u, N) of a u-line, and likewise for a v-line."""
    return (tangent, cross(normal, tangent), normal)


def frenet_u(kappa: Any, *, torsion: int = -1, back: int = 1) -> Rows:
    """First system of (eq:frames): the matrix of d/du on (r_u, N x r_u, N)."""
    return ((0, kappa, 0), (-kappa, 0, torsion), (0, back, 0))


def frenet_v(kappa: Any, *, torsion: int = 1, back: int = -1) -> Rows:
    """Second system of (eq:frames): the matrix of d/dv on (r_v, N x r_v, N)."""
    return ((0, kappa, 0), (-kappa, 0, torsion), (0, back, 0))


def normal_along_u(r_u: Vector, normal: Vector, cross: Cross, *, sign: int = 1) -> Vector:
    """Item (C): N_u = N x r_u."""
    return scaled(sign, cross(normal, r_u))


def right_handed_u(
    r_u: Vector, n_u: Vector, normal: Vector, *, sign: int = 1
) -> tuple[Vector, Vector, Vector]:
    """Item (C): the frame (r_u, N_u, N)."""
    return (r_u, scaled(sign, n_u), normal)


def right_handed_v(
    r_v: Vector, n_v: Vector, normal: Vector, *, sign: int = -1
) -> tuple[Vector, Vector, Vector]:
    """Item (C): the frame (r_v, -N_v, N)."""
    return (r_v, scaled(sign, n_v), normal)


def lelieuvre_u(n_u: Vector, normal: Vector, cross: Cross, *, sign: int = 1) -> Vector:
    """First formula of (eq:lelieuvre): r_u = N_u x N."""
    return scaled(sign, cross(n_u, normal))


def lelieuvre_v(n_v: Vector, normal: Vector, cross: Cross, *, sign: int = -1) -> Vector:
    """Second formula of (eq:lelieuvre): r_v = -N_v x N."""
    return scaled(sign, cross(n_v, normal))


def lorentz_harmonic(normal: Vector, n_uv: Vector, cross: Cross) -> Vector:
    """Left side of (eq:lorentz_harmonic), N x N_uv, which vanishes."""
    return cross(normal, n_uv)


def mixed_derivative(n_u: Vector, n_v: Vector, cross: Cross, *, sign: int = 1) -> Vector:
    """Item (D): r_uv = N_u x N_v."""
    return scaled(sign, cross(n_u, n_v))


def graph_orientation(x: Vector, y: Vector, *, second: int = 2) -> Any:
    """Item (F): omega = dx_1 ^ dx_2 on two vectors of R^3; second: index of the second factor."""
    return x[0] * y[second - 1] - x[second - 1] * y[0]


def compatible(beta: Any, x: Vector, y: Vector, normal: Vector, cross: Cross) -> Any:
    """Item (F): the value beta (X x Y).N that omega(X, Y) has for some positive function beta."""
    product = cross(x, y)
    return beta * (product[0] * normal[0] + product[1] * normal[1] + product[2] * normal[2])


def oriented_normal(
    omega_uv: Any,
    r_u: Vector,
    r_v: Vector,
    norm: Any,
    cross: Cross,
    *,
    oriented: bool = True,
    sign: int = 1,
) -> Vector:
    """Right side of (eq:Nfront): sigma r_u x r_v / |r_u x r_v|, sigma = sign(omega(r_u, r_v)).

    omega_uv: omega(r_u, r_v), whose sign sympy must know; norm: that of r_u x r_v.
    """
    sigma = sp.sign(omega_uv) if oriented else sp.Integer(1)
    return scaled(sign * sigma / norm, cross(r_u, r_v))
