"""Growth laws of the tree of branch points, as printed at the end of section 5.1 (sympy)."""

from typing import Any

import sympy as sp


def disk_area(radius: Any, *, rate: str = "1") -> Any:
    """What the area of a disk is said to scale like (5.1.area-of-disk)."""
    return sp.exp(sp.Rational(rate) * radius)


def free_size(radius: Any, *, power: str = "1/2") -> Any:
    """Size about which a disk cannot be free of branch points (5.1.branch-free-region)."""
    return radius ** sp.Rational(power)


def free_area_exponent(radius: Any, *, power: str = "1/2") -> Any:
    """Exponent of the largest area free of branch points (5.1.area-free-of-branch-points)."""
    return radius ** sp.Rational(power)


def number_exponent(radius: Any, *, factor: str = "1", power: str = "1/2") -> Any:
    """Exponent of the number of branch points (5.1.number-of-branch-points)."""
    return radius - sp.Rational(factor) * radius ** sp.Rational(power)


def cut_depth(radius: Any, *, factor: str = "1", power: str = "1/2") -> Any:
    """Argument beside 0 of the maximum that the cut depth is like (5.1.cut-depth)."""
    return radius - sp.Rational(factor) * radius ** sp.Rational(power)


def generation_base(*, most: int = 3) -> int:
    """Base of the exponential growth with the generations (5.1.exponential-in-generations)."""
    return most
