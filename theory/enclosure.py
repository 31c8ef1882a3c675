"""Enclosures as plain data: integer mantissas and exponents that any process can read.

A ball of flint can be neither pickled nor written to JSON. Its exact midpoint and radius can, as
pairs (m, e) that stand for m 2^e, without a bit gained or lost.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb

Dyadic = tuple[int, int]

SPARE_BITS = 40


@dataclass(frozen=True, kw_only=True)
class Enclosure:
    """Real number known to lie within radius of midpoint, both exact dyadic numbers (m, e).

    >>> third = Enclosure(midpoint=(85, -8), radius=(1, -9))
    >>> third.decimal(2), third.decimal(3)
    ('0.33', None)
    """

    midpoint: Dyadic
    radius: Dyadic

    def __post_init__(self) -> None:
        if self.radius[0] < 0:
            raise ValueError(f"negative radius {self.radius}")

    @classmethod
    def of(cls, ball: Any) -> Enclosure:
        """Exact midpoint and radius of a finite ball; ValueError for another."""
        if not ball.is_finite():
            raise ValueError("not a finite ball")
        middle, radius = (_dyadic(part) for part in (ball.mid(), ball.rad()))
        return cls(midpoint=middle, radius=radius)

    @classmethod
    def if_finite(cls, ball: Any) -> Enclosure | None:
        """Enclosure of the ball, or None where it is not finite."""
        return cls.of(ball) if ball.is_finite() else None

    def ball(self) -> Any:
        """Ball of flint with this midpoint and radius, whatever the precision in force.

        Radii of flint have 30 bits; a longer one is rounded up.
        """
        mantissa, exponent = self.radius
        if mantissa:
            # flint adds a unit to the last of the 30 bits it is given, also where they are exact.
            shrunk = arb(self.midpoint, ((mantissa << SPARE_BITS) - 1, exponent - SPARE_BITS))
            if _fraction(_dyadic(shrunk.rad())) >= _fraction(self.radius):
                return shrunk
        return arb(self.midpoint, self.radius)

    def ends(self) -> tuple[Fraction, Fraction]:
        """Lower and upper end, exact."""
        middle, radius = _fraction(self.midpoint), _fraction(self.radius)
        return middle - radius, middle + radius

    def contains(self, value: Fraction | int) -> bool:
        """Whether the rational number lies in the enclosure."""
        low, high = self.ends()
        return low <= value <= high

    def is_accurate_to(self, digits: int) -> bool:
        """Whether radius <= 10^-digits |x| for every number x of the enclosure."""
        low, high = self.ends()
        least = max(low, -high, Fraction(0))
        return bool(_fraction(self.radius) * 10**digits <= least)

    def decimal(self, digits: int) -> str | None:
        """Decimal of the enclosed number rounded to nearest, digits significant digits, or None.

        None where the enclosure does not decide it. An exact tie goes to the even digit.
        """
        first, second = (_rounded(end, digits) for end in self.ends())
        return _written(*first, digits) if first == second else None

    def decimal_error(self, digits: int) -> str | None:
        """Bound on |x - decimal(digits)| for every x enclosed: three digits, rounded up."""
        if self.decimal(digits) is None:
            return None
        low, high = self.ends()
        mantissa, exponent = _rounded(low, digits)
        shown = mantissa * Fraction(10) ** exponent
        error = max(abs(low - shown), abs(high - shown))
        return _rounded_up(error)


def _dyadic(number: Any) -> Dyadic:
    mantissa, exponent = number.man_exp()
    return int(mantissa), int(exponent)


def _fraction(number: Dyadic) -> Fraction:
    mantissa, exponent = number
    return Fraction(mantissa << exponent) if exponent >= 0 else Fraction(mantissa, 1 << -exponent)


def _magnitude(value: Fraction) -> int:
    """Exponent e with 10^e <= |value| < 10^(e + 1), value not 0."""
    bits = value.numerator.bit_length() - value.denominator.bit_length()
    guess = bits * 30103 // 100000 - 1
    while Fraction(10) ** (guess + 1) <= abs(value):
        guess += 1
    while Fraction(10) ** guess > abs(value):
        guess -= 1
    return guess


def _rounded(value: Fraction, digits: int) -> tuple[int, int]:
    """Mantissa of that many digits and exponent of ten of the nearest decimal."""
    if value == 0:
        return 0, 0
    exponent = _magnitude(value) - digits + 1
    mantissa = round(value / Fraction(10) ** exponent)
    if abs(mantissa) == 10**digits:
        return mantissa // 10, exponent + 1
    return mantissa, exponent


def _written(mantissa: int, exponent: int, digits: int) -> str:
    """Decimal with all its digits; with an exponent where the point would be far from them."""
    if mantissa == 0:
        return "0"
    sign, figures = "-" * (mantissa < 0), _figures(abs(mantissa))
    point = len(figures) + exponent
    if 0 < point <= digits:
        whole, part = figures[:point], figures[point:]
    elif -5 < point <= 0:
        whole, part = "0", "0" * -point + figures
    else:
        whole, part = figures[:1], figures[1:]
    tail = "" if -5 < point <= digits else f"e{point - 1:+d}"
    return sign + whole + ("." + part if part else "") + tail


def _figures(mantissa: int) -> str:
    """Decimal digits of a natural number of any size, which str refuses past 4300 digits."""
    half = 2000
    if mantissa < 10**half:
        return str(mantissa)
    high, low = divmod(mantissa, 10**half)
    return _figures(high) + str(low).rjust(half, "0")


def _rounded_up(value: Fraction) -> str:
    """Decimal of three digits at or above value >= 0."""
    if value == 0:
        return "0"
    exponent = _magnitude(value) - 2
    mantissa = -(-value // Fraction(10) ** exponent)
    return f"{float(mantissa) / 100:.2f}e{exponent + 2:+d}"
