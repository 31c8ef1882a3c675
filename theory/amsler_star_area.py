"""Area of stars of Amsler sectors by the midpoint rule, from the Taylor series of the angle.

In a sector whose angle at the centre is alpha the angle between the curves that leave it is
F(s t), s and t the lengths along its rays, (x F')' = sin F, F(0) = alpha. Float64.
"""

from collections.abc import Sequence
from math import cos, sin
from typing import Any

import numpy as np

TERMS = 40


def similarity_coefficients(alpha: float, terms: int = TERMS) -> list[float]:
    """Taylor coefficients of F, from k^2 a_k = [x^(k-1)] sin F."""
    a, sine, cosine = [alpha], [sin(alpha)], [cos(alpha)]
    for k in range(1, terms + 1):
        a.append(sine[k - 1] / k**2)
        sine.append(sum(j * a[j] * cosine[k - j] for j in range(1, k + 1)) / k)
        cosine.append(-sum(j * a[j] * sine[k - j] for j in range(1, k + 1)) / k)
    return a


def angle(alpha: float, x: Any) -> Any:
    """Angle F(x) for 0 <= x <= 1, elementwise."""
    return np.polynomial.polynomial.polyval(x, similarity_coefficients(alpha))


def rectangle_area(
    alpha: float, first: tuple[float, float], second: tuple[float, float], cells: int
) -> float:
    """Midpoint rule with cells x cells cells for the integral of sin F over a rectangle."""
    (a, b), (c, d) = first, second
    middles = (np.arange(cells) + 0.5) / cells
    s, t = a + (b - a) * middles, c + (d - c) * middles
    values = np.sin(angle(alpha, np.outer(s, t)))
    return float(values.mean() * (b - a) * (d - c))


def star_area(angles: Sequence[float], lengths: Sequence[float], cells: int) -> float:
    """Midpoint rule for the area of a star with these sector angles and lengths of the rays."""
    size = len(angles)
    return sum(
        rectangle_area(angles[j], (0.0, lengths[j]), (0.0, lengths[(j + 1) % size]), cells)
        for j in range(size)
    )
