"""Growth laws of the abstract, as printed there."""

from typing import Any

import sympy as sp


def branched_exponent(radius: Any, c: Any, *, tenths: int = 5) -> Any:
    """Exponent c sqrt(R) of the growth with branch points; tenths: ten times the power of R."""
    return c * radius ** sp.Rational(tenths, 10)


def smooth_exponent(radius: Any, c: Any) -> Any:
    """Exponent c' R of the growth without branch points."""
    return c * radius
