"""Rectangles on the pseudosphere in balls: its angle is 4 arctan e^(u + v), below pi for u + v < 0.

The area is the integral of sin phi as a rational function of e^x, in rigorous quadrature; that phi
solves the sine-Gordon equation is not used. Call under `with ctx.workprec(...)`.
"""

from fractions import Fraction
from typing import Any

from flint import acb, arb, fmpq

Rectangle = tuple[Fraction, Fraction, Fraction, Fraction]
"""Ends u_0, u_1, v_0, v_1 with u_1 + v_1 <= 0."""


def _ball(value: Fraction) -> Any:
    return arb(fmpq(value.numerator, value.denominator))


def angle(u: Fraction, v: Fraction) -> Any:
    """Ball of the angle in (0, pi] at u + v <= 0."""
    return 4 * _ball(u + v).exp().atan()


def sine(x: Any) -> Any:
    """Sine of 4 arctan e^x, rational in e^x."""
    t = x.exp()
    return 4 * t * (1 - t**2) / (1 + t**2) ** 2


def area(rectangle: Rectangle) -> Any:
    """Ball of the integral of sin phi over a rectangle, by the lengths of the lines u + v = x."""
    u0, u1, v0, v1 = rectangle
    short = min(u1 - u0, v1 - v0)
    low, high = u0 + v0, u1 + v1
    pieces = (
        (low, low + short, lambda x: x - _ball(low)),
        (low + short, high - short, lambda x: _ball(short)),
        (high - short, high, lambda x: _ball(high) - x),
    )
    total = arb(0)
    for start, end, chord in pieces:
        if start < end:
            total += _integral(chord, start, end)
    return total


def _integral(chord: Any, start: Fraction, end: Fraction) -> Any:
    def integrand(z: Any, analytic: bool) -> Any:
        return sine(z) * chord(z)

    return acb.integral(integrand, acb(_ball(start)), acb(_ball(end))).real
