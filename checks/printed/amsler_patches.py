"""Section 3.2, Amsler sectors patched around a point, as printed (amsler-frame)."""

from collections.abc import Callable
from typing import Any

import sympy as sp

from theory.vectors import Vector, added, cross, dot, scaled

Rays = Callable[[int], Vector]
E_3: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(1))


def normal_on_u(u: Any, n: Vector, e_u: Vector, *, sign: int = 1, rate: int = 1) -> Vector:
    """First line of (amsler-frame): N(u, 0) = cos(u) n + sin(u) n x e_u."""
    return added(scaled(sp.cos(rate * u), n), scaled(sign * sp.sin(rate * u), cross(n, e_u)))


def normal_on_v(v: Any, n: Vector, e_v: Vector, *, sign: int = -1, rate: int = 1) -> Vector:
    """Second line of (amsler-frame): N(0, v) = cos(v) n - sin(v) n x e_v."""
    return added(scaled(sp.cos(rate * v), n), scaled(sign * sp.sin(rate * v), cross(n, e_v)))


def line(t: Any, z: Vector, e: Vector, *, sign: int = 1) -> Vector:
    """Third line of (amsler-frame): z + u e_u, and z + v e_v."""
    return added(z, scaled(sign * t, e))


def second_line_place(v: Any, *, argument: str = "first") -> tuple[Any, Any]:
    """Arguments of r in r(v, 0) = z + v e_v, as printed; argument: the place of v."""
    zero = sp.Integer(0)
    return {"first": (v, zero), "second": (zero, v)}[argument]


def patch_directions(
    i: int, s: Rays, *, even: int = 0, exchanged: bool = True, shift: int = 0
) -> tuple[Vector, Vector]:
    """Directions (e_u, e_v) = (s_i, s_(i-1)) for even i, (s_(i-1), s_i) for odd i."""
    own, before = s(i + shift), s(i - 1 + shift)
    return (own, before) if i % 2 == even or not exchanged else (before, own)


def corner_limit(i: int, s: Rays, *, sign: int = 1) -> Any:
    """Value (s*_(i-1) . s_i) printed, up to a sign, for the limit of N_u x N_v."""
    return sign * dot(cross(E_3, s(i - 1)), s(i))
