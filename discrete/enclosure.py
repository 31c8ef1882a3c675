"""Enclosures as plain data: a ball of flint can be neither pickled nor written to JSON.

Its exact midpoint and radius can, as pairs (m, e) of integers that stand for m 2^e.
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Dyadic = tuple[int, int]


@dataclass(frozen=True, kw_only=True)
class Enclosure:
    """Real number within `radius` of `midpoint`, both exact dyadic numbers (m, e)."""

    midpoint: Dyadic
    radius: Dyadic

    def __post_init__(self) -> None:
        if self.radius[0] < 0:
            raise ValueError(f"negative radius {self.radius}")

    @classmethod
    def of(cls, ball: Any) -> "Enclosure":
        """Exact midpoint and radius of a finite ball. Raises ValueError for another."""
        if not ball.is_finite():
            raise ValueError("not a finite ball")
        middle, radius = (
            (int(mantissa), int(exponent))
            for mantissa, exponent in (ball.mid().man_exp(), ball.rad().man_exp())
        )
        return cls(midpoint=middle, radius=radius)

    @classmethod
    def between(cls, low: Fraction, high: Fraction) -> "Enclosure":
        """Interval between two dyadic numbers."""
        middle, radius = (low + high) / 2, (high - low) / 2
        return cls(midpoint=dyadic(middle), radius=dyadic(radius))

    def ends(self) -> tuple[Fraction, Fraction]:
        """Lower and upper end, exact."""
        middle, radius = fraction_of(self.midpoint), fraction_of(self.radius)
        return middle - radius, middle + radius

    def contains(self, value: Fraction | int) -> bool:
        """Whether the rational number lies in the enclosure."""
        low, high = self.ends()
        return low <= value <= high

    def __float__(self) -> float:
        return float(fraction_of(self.midpoint))


def fraction_of(number: Dyadic) -> Fraction:
    """Rational number m 2^e."""
    mantissa, exponent = number
    return Fraction(mantissa << exponent) if exponent >= 0 else Fraction(mantissa, 1 << -exponent)


def dyadic(number: Fraction | int) -> Dyadic:
    """Pair (m, e) of a rational number m 2^e. Raises ValueError for another."""
    number = Fraction(number)
    exponent = number.denominator.bit_length() - 1
    if number.denominator != 1 << exponent:
        raise ValueError(f"{number} is no dyadic number")
    return number.numerator, -exponent
