"""Section 3.2, assembly of m-saddles, as printed (prop:assembly, def:m-saddle)."""

from collections.abc import Callable
from typing import Any

import sympy as sp

from theory.vectors import Vector, cross, dot

Rays = Callable[[int], Vector]
E_3: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(1))


def initial_frame(s: Vector, *, sign: int = 1) -> tuple[Vector, Vector]:
    """Item 2 of (prop:assembly): the tangent s_i and the normal e_3 at the start of F_i."""
    return (s[0], s[1], s[2]), (E_3[0], E_3[1], sign * E_3[2])


def corner_norm(i: int, s: Rays, *, ahead: int = 0) -> Any:
    """Value s*_(i-1) . s_i whose modulus is the limit of |N_u x N_v| on S_i."""
    return dot(cross(E_3, s(i - 1)), s(i + ahead))


def order_of_saddleness(sectors: int, *, per_order: int = 2, offset: int = 0) -> sp.Rational:
    """Order m of an m-saddle with 2m sectors (def:m-saddle)."""
    return sp.Rational(sectors, per_order) + offset


def is_m_saddle(
    jumps: dict[str, bool],
    *,
    position: bool = True,
    normal: bool = True,
    harmonic: bool = True,
    regular: bool = True,
) -> bool:
    """Whether a patched map is an m-saddle (def:m-saddle), from what fails of it.

    jumps: whether r, whether N jumps on a ray, whether N is not Lorentz harmonic inside a sector,
    whether N_u or N_v vanishes.
    """
    return not (
        (position and jumps["position"])
        or (normal and jumps["normal"])
        or (harmonic and jumps["harmonic"])
        or (regular and jumps["regular"])
    )


def excess_undulations(order: Any, *, regular: int = 2) -> Any:
    """Undulations in excess of a regular saddle, m - 2."""
    return order - regular
