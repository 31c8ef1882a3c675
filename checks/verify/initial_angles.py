"""Initial angles phi0 by name, for the certified and for the reference route."""

from fractions import Fraction
from typing import Any

from flint import arb
from mpmath import mp

from theory import painleve, painleve_reference

#: Certified digits of z* and of angles and slopes at it.
DIGITS = 30


def certified(name: str) -> Any:
    """Exact real for theory.painleve: `pi/100`, or a decimal such as `1e-12`."""
    if name == "pi/100":
        return lambda: arb.pi() / 100
    return Fraction(name)


def reference(name: str) -> Any:
    """Exact real for theory.painleve_reference."""
    if name == "pi/100":
        return lambda: mp.pi / 100
    return Fraction(name)


def ball(name: str) -> Any:
    """Ball of phi0 at the precision in force."""
    if name == "pi/100":
        return arb.pi() / 100
    exact = Fraction(name)
    return arb(exact.numerator) / exact.denominator


def crossing(name: str, level: Any = arb.pi, *, digits: int = DIGITS) -> Any:
    """Ball of the first z with phi(z) = level."""
    return painleve.crossing(certified(name), level, digits=digits).ball()


def angle_and_slope(name: str, z: Any, *, digits: int = 20) -> tuple[Any, Any]:
    """Balls of phi(z) and phi'(z) at the ball z, good to more digits than asked for."""
    return angle(name, z, digits=digits), slope(name, z, digits=digits)


def angle(name: str, z: Any, *, digits: int = 20) -> Any:
    """Ball of phi(z) at the ball z."""
    return painleve.angle(certified(name), z, digits=digits).ball()


def slope(name: str, z: Any, *, digits: int = 20) -> Any:
    """Ball of phi'(z) at the ball z."""
    return painleve.slope(certified(name), z, digits=digits).ball()


def fraction(text: str) -> Any:
    """Ball of a rational number, at the precision in force."""
    exact = Fraction(text)
    return arb(exact.numerator) / exact.denominator


def reference_crossing(name: str, *, digits: int = 20) -> Any:
    """First z with phi(z) = pi, as an mpf."""
    return painleve_reference.crossing(reference(name), lambda: +mp.pi, digits=digits)


def reference_crossing_ball(name: str) -> Any:
    """Ball of no width about the reference value of z*, a decimal of 25 digits."""
    return arb(mp.nstr(reference_crossing(name, digits=25), 25))
