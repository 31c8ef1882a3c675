r"""Comparison of two solutions of phi_uv = sin phi on a rectangle by their data on both axes.

The difference w = phi_2 - phi_1 solves w_uv = c w with c = (sin phi_2 - sin phi_1)/w, in (0, 1] as
long as 0 < phi_1, phi_2 < pi/2. With A(u, v) = w(u, 0) + w(0, v) - w(0, 0) that is w = A + T w,
(T f)(u, v) being the integral of c f over [0, u] x [0, v], a positive operator whose powers are at
most (u v)^n/n!^2: w is the sum of all T^n A.
So A >= 0 everywhere gives w >= 0. Where u_0 v_0 = q < 1, |w| <= max |A|/(1 - q), and the sign of A
at the far corner decides that of w there as soon as |A| > max |A| q/(1 - q).
"""

from fractions import Fraction
from typing import Any

import sympy as sp

from theory.errors import DomainError


def mixed_sum(on_u: Any, on_v: Any, corner: Any) -> Any:
    """A = w(u, 0) + w(0, v) - w(0, 0), the solution of A_uv = 0 with the data of w."""
    return on_u + on_v - corner


def rate(first: Any, second: Any) -> Any:
    """Rate c = (sin phi_2 - sin phi_1)/(phi_2 - phi_1) by the mean and half the difference; sympy.

    sin(h)/h cos(mean), both positive where 0 < phi_1, phi_2 < pi/2.
    """
    half, mean = (second - first) / 2, (second + first) / 2
    return sp.sin(half) / half * sp.cos(mean)


def far_corner(
    at_corner: Fraction, *, largest: Fraction, area: Fraction
) -> tuple[Fraction, Fraction]:
    """Bounds of w at the far corner: A there, and max |A| on the rectangle, of this u_0 v_0 < 1.

    >>> far_corner(Fraction(-1), largest=Fraction(1), area=Fraction(1, 101))
    (Fraction(-101, 100), Fraction(-99, 100))
    """
    if not 0 <= area < 1:
        raise DomainError(f"the area u_0 v_0 must lie in [0, 1), not {area}")
    room = largest * area / (1 - area)
    return at_corner - room, at_corner + room
