r"""Pseudospherical surfaces with a one-parameter group of motions, in asymptotic coordinates.

A motion along the group shifts the asymptotic lines by constant lengths, neither of them 0 as
phi_uv = sin phi; so its generator is, with v reversed and phi turned to pi - phi if need be, a
multiple of K = (1/l) d_u - l d_v, l > 0, and phi = f(xi) with xi = l u + v/l, f'' = sin f. The
pitch is d = (l - 1/l)^2; it is 0 for surfaces of revolution. In H^2 the length of a Killing field
obeys x_ss = x along the geodesics across its orbits: x = c cosh s, c e^s or c sinh s, with
s the signed distance from an axis, a horocycle or a fixed point.
"""

from typing import Any

import sympy as sp

from theory.amsler import U, V, chebyshev_metric

RATIO = sp.Symbol("l", positive=True)
ANGLE = sp.Symbol("phi", positive=True)
SQUARE = sp.Symbol("q", positive=True)
PITCH = sp.Symbol("d", nonnegative=True)


def generator() -> sp.Matrix:
    """Components of the Killing field K along r_u, r_v."""
    return sp.Matrix([1 / RATIO, -RATIO])


def phase() -> Any:
    """Coordinate xi = l u + v/l, constant along the orbits."""
    return RATIO * U + V / RATIO


def squared_length() -> Any:
    """Square of the length of K where the asymptotic lines meet at ANGLE."""
    field = generator()
    return sp.expand((field.T * chebyshev_metric(ANGLE, sigma=1) * field)[0, 0])


def squared_half_tangent(square: Any = SQUARE, pitch: Any = PITCH) -> Any:
    """Square of tan(phi/2) where K has this squared length, (q - d)/(4 + d - q)."""
    cosine = (2 + pitch - square) / 2
    return sp.factor((1 - cosine) / (1 + cosine))


def pitch() -> Any:
    """Pitch d by l."""
    return (RATIO - 1 / RATIO) ** 2


def squared_profile(kind: str, s: Any) -> Any:
    """Square of |K|/c at the distance s, for an `axis`, a `horocycle` or a fixed `point`."""
    return {"axis": sp.cosh, "horocycle": sp.exp, "point": sp.sinh}[kind](s) ** 2
