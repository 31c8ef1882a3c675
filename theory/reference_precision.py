"""Precision of the reference values in mpmath: exact inputs, and digits that cancellation costs.

Nothing here is a proof: each computation says by how much it magnifies a relative error of its
inputs and of its steps, and is repeated with as many more digits.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any, TypeAlias

from mpmath import mp

from theory.errors import DomainError, InsufficientPrecisionError

#: int, Fraction, mpf (the exact dyadic number), or a function without arguments that returns an
#: mpf at the precision in force: ``lambda: mp.pi / 100``, or mp.pi itself.
Real: TypeAlias = Any

MOST_DIGITS = 10_000
GUARD = 20
"""Digits beyond those asked for; thousands of steps lose about four."""


class Magnified(ArithmeticError):
    """No value at this precision: what was asked of it lies within the error."""


def mpf_of(value: Real) -> Any:
    """Nearest mpf to the exact real, at the precision in force.

    TypeError for a float or a text, which seldom are the number that was meant: write
    ``Fraction("0.1")``. DomainError for what is not finite.
    """
    found = value() if callable(value) else value
    if isinstance(found, bool) or not isinstance(found, int | Fraction | mp.mpf | mp.constant):
        raise TypeError(f"not an exact real number: {type(found).__name__}")
    if isinstance(found, Fraction):
        return mp.mpf(found.numerator) / found.denominator
    number = mp.mpf(found)
    if not mp.isfinite(number):
        raise DomainError("not a finite number")
    return +number


def same(first: Real, second: Real) -> bool:
    """Whether two exact reals are the same number for certain: one object, or equal rationals."""
    rational = all(isinstance(value, int | Fraction) for value in (first, second))
    return first is second or (rational and bool(first == second))


def close(first: Any, second: Any) -> bool:
    """Whether rounding at the precision in force may hide which of two mpf is larger."""
    return bool(abs(first - second) <= abs(second) * mp.ldexp(1, 4 - mp.prec))


def settled(
    compute: Callable[[], tuple[Any, Any]], *, digits: int, most_digits: int = MOST_DIGITS
) -> Any:
    """Value of compute() to this many significant digits, as far as its own estimate goes.

    compute: gives the value and the factor by which it magnifies a relative error of its inputs,
    or raises Magnified. DomainError for digits that are no integer from 1 to 10000,
    InsufficientPrecisionError past most_digits, or where four times the digits do not settle it.
    """
    if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= MOST_DIGITS:
        raise DomainError(f"digits must be an integer from 1 to {MOST_DIGITS}, not {digits!r}")
    if digits > most_digits:
        raise InsufficientPrecisionError(
            f"the reference route gives at most {most_digits} digits, not {digits}"
        )
    extra = 0
    while extra <= 3 * digits + 1000:
        with mp.workdps(digits + GUARD + extra):
            try:
                value, magnification = compute()
            except Magnified:
                extra = 2 * extra + GUARD
                continue
            lost = int(mp.ceil(mp.log10(magnification))) if magnification > 1 else 0
        if lost <= extra:
            with mp.workdps(digits + 5):
                return +value
        extra = max(lost + 5, 2 * extra)
    raise InsufficientPrecisionError(f"{digits} digits not reached: {extra} more were not enough")
