"""The sectors into which a quadratic form divides the plane, by its sign."""

from itertools import pairwise
from typing import Any

import sympy as sp


def null_slopes(form: tuple[Any, Any, Any]) -> list[Any]:
    """Real t with a + 2 m t + n t^2 = 0 for form = (a, m, n), in increasing order.

    The directions (1, t) are those where a x^2 + 2 m x y + n y^2 vanishes; n must not be 0.
    Raises ValueError if it is.
    """
    a, m, n = form
    if n == 0:
        raise ValueError("the y-axis is a null direction: turn the form first")
    discriminant = m**2 - a * n
    if discriminant < 0:
        return []
    roots = {(-m - sp.sqrt(discriminant)) / n, (-m + sp.sqrt(discriminant)) / n}
    return sorted(roots)


def count_sectors(form: tuple[Any, Any, Any]) -> tuple[int, int]:
    """Count the sectors of positive and of negative values, all round the origin."""
    a, m, n = form
    slopes = null_slopes(form)
    ends = [slopes[0] - 1, *slopes, slopes[-1] + 1] if slopes else [0, 0]
    middles = [(a + b) / 2 for a, b in pairwise(ends)]
    values = [sp.sympify(a + 2 * m * t + n * t**2) for t in middles]
    signs = [1 if value > 0 else -1 for value in values if value != 0]
    if len(signs) > 1 and signs[0] == signs[-1]:
        signs.pop()
    closed = len(signs) == 1 and not slopes
    weight = 1 if closed else 2
    return weight * signs.count(1), weight * signs.count(-1)
