"""Formulas of the opening of section 5 as the paper prints them."""

from typing import Any

import sympy as sp

_LIMIT_SIDES = {"lower": ("lower",), "upper": ("upper",), "both": ("lower", "upper")}


def principal_curvatures(
    phi: Any, upper: int, *, half: str = "1/2", second: str = "cot", opposite: bool = True
) -> tuple[Any, Any]:
    """Principal curvatures by the angle (section 5, line 1422); upper is 1 or -1, the sign read."""
    angle = sp.Rational(half) * phi
    other = {"cot": sp.cot, "tan": sp.tan}[second](angle)
    return upper * sp.tan(angle), (-upper if opposite else upper) * other


def max_curvature_of_margin(delta: Any, *, half: str = "1") -> Any:
    """E_inf by delta (section 5, line 1422): cot(half * delta), printed with half = 1."""
    return sp.cot(sp.Rational(half) * delta)


def is_margin(delta: Any, least: Any, greatest: Any, *, side: str = "both") -> bool:
    """Whether 0 < delta <= phi <= pi - delta < pi for all phi from least to greatest (line 1422).

    side: `both`, or only the bound from `below`.
    """
    below = bool(delta > 0) and bool(delta <= least)
    return below and (side == "below" or bool(greatest <= sp.pi - delta))


def is_comparable(
    a: Any, b: Any, radius: sp.Symbol, *, least_radius: str = "0", side: str = "both"
) -> bool:
    """Whether a ~ b (section 5, line 1429): C^-1 b <= a <= C b for all radii, printed from 0 on.

    a, b: positive and continuous for radius > 0, so that only the limits of a/b at the ends of the
    range count; side: `both` bounds or one of them.
    """
    start = sp.Rational(least_radius)
    ends = [sp.limit(a / b, radius, sp.oo)]
    ends.append(sp.limit(a / b, radius, 0, "+") if start == 0 else (a / b).subs(radius, start))
    sides = _LIMIT_SIDES[side]
    return ("lower" not in sides or all(end != 0 for end in ends)) and (
        "upper" not in sides or all(end != sp.oo for end in ends)
    )


def separation_exponent(radius: Any, first: Any, second: Any, *, power: str = "1/2") -> Any:
    """Log of the quotient of the two energies, where (e2) and (ebs) have these constants.

    The least that they leave: log E >= first R for smooth immersions, log E <= second R^power for
    branched ones (lines 1426, 1455).
    """
    return first * radius - second * radius ** sp.Rational(power)
