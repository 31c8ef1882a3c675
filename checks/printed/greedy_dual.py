"""Formulas of the dual of the greedy algorithm as the paper prints them, items 1 to 6 of 4.1.

Parameters that are fractions are texts: no number type rounds them.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any


def data_ordered(on_u: Sequence[Any], on_v: Sequence[Any], *, needs: str = "axes") -> bool:
    """Hypothesis of the comparison principle on w = phi_2 - phi_1, sampled on both axes (item 5).

    on_u, on_v: values of w from the common corner on; needs: `axes`, w >= 0 there, as printed, or
    `mixed sum`, w(u, 0) + w(0, v) - w(0, 0) >= 0 for all u, v.
    """
    if needs == "axes":
        return bool(min(on_u) >= 0 and min(on_v) >= 0)
    return bool(min(on_u) + min(on_v) - on_u[0] >= 0)


def saddle_order_scale(radius: Any, exp: Any, *, power: str = "0") -> Any:
    """What m_0 is said to be like, e^R R^power (before item 1)."""
    exact = Fraction(power)
    root: Any = radius ** (exact.numerator * radius**0 / exact.denominator)
    return exp(radius) * root


def is_generations(g: int, m: int, order: int, *, shift: int = 0, closed: bool = False) -> bool:
    """Whether 3^(g-1) m < m_0 <= 3^g m, order being m_0 (item 1).

    shift: of g; closed: <= on both sides.
    """
    low, high = Fraction(3) ** (g - 1 + shift) * m, Fraction(3) ** (g + shift) * m
    return (low <= order if closed else low < order) and order <= high


def single_order(g: int, m: int, *, base: int = 3) -> int:
    """Order 3^g m of the branch point that the dual starts from (item 1)."""
    return int(base**g * m)


def first_step(
    g: int, m: int, *, daughters: int = 2, degree_shift: int = 0, added: int = 0
) -> tuple[int, int]:
    """Number 2 m of the daughters of the first step, and the degree 3^g of each (item 2).

    degree_shift: of the exponent; added: to the degree.
    """
    return daughters * m, int(3 ** (g + degree_shift)) + added


def stage(
    k: int, g: int, m: int, *, degree_shift: int = 0, added: int = 0, number_shift: int = 0
) -> tuple[int, int]:
    """Number 2 3^(k-1) m of the daughters of stage k, and the degree 3^(g-k) of each (item 3)."""
    return 2 * 3 ** (k - 1 + number_shift) * m, int(3 ** (g - k + degree_shift)) + added


def most_sectors(g: int, m: int) -> int:
    """Bound 2 3^g m of the number of sectors (item 6)."""
    return int(2 * 3**g * m)


def least_angle(g: int, m: int, pi: Any) -> Any:
    """Bound 3^-g pi/m of the angles (item 6)."""
    return pi / (3**g * m)
