"""Kinks: the solutions phi = 4 arctan(exp(a u + v/a + c)) of phi_uv = sin phi (eq:sg).

They take every value in (0, 2 pi); phi < pi where a u + v/a + c < 0. Angles and slopes are written
through q = tan(phi/4) > 0, so that they are rational.
"""

from typing import Any

import sympy as sp

U, V = sp.symbols("u v", nonnegative=True)


def quarter_tangent(a: Any, c: Any) -> Any:
    """Positive tangent q of phi/4 at (u, v)."""
    return sp.exp(a * U + V / a + c)


def sine(q: Any) -> Any:
    """Sine of phi = 4 arctan q."""
    return 4 * q * (1 - q**2) / (1 + q**2) ** 2


def slopes(a: Any, c: Any) -> tuple[Any, Any]:
    """Derivatives phi_u and phi_v."""
    angle = 4 * sp.atan(quarter_tangent(a, c))
    return sp.diff(angle, U), sp.diff(angle, V)


def mixed(a: Any, c: Any) -> Any:
    """Mixed derivative phi_uv."""
    return sp.diff(slopes(a, c)[0], V)
