"""Precision of certified values: exact inputs, bits that rise by themselves, a stated cap.

flint keeps its precision and the length of its power series in one context for the whole process.
Both are set here for the length of a computation and put back whatever happens, so that neither a
caller who changed them nor one who is interrupted sees a difference.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from math import ceil
from typing import Any, TypeAlias

from flint import arb, ctx, fmpq, fmpz

from theory.enclosure import Enclosure
from theory.errors import DomainError, InsufficientPrecisionError, UndecidedError

#: int, Fraction, fmpz, fmpq, an exact ball, or a function without arguments that returns a ball
#: at the precision in force (``lambda: arb.pi() / 100`` is the number pi/100, to any precision).
Real: TypeAlias = Any

MOST_DIGITS = 10_000
MOST_BITS = 2**20
CAP_FACTOR = 64


@contextmanager
def working(bits: int, *, series_length: int = 10) -> Iterator[None]:
    """Precision and series length of flint for a block; what was in force comes back after it."""
    length = ctx.cap
    try:
        with ctx.workprec(bits):
            ctx.cap = series_length
            yield
    finally:
        ctx.cap = length


def ball_of(value: Real) -> Any:
    """Ball around an exact real, as small as the precision in force allows.

    TypeError for a float or a text, which seldom are the number that was meant: write
    ``Fraction("0.1")``. DomainError for what is not finite.
    """
    found = value() if callable(value) else value
    if isinstance(found, bool) or not isinstance(found, int | Fraction | fmpz | fmpq | arb):
        raise TypeError(f"not an exact real number: {type(found).__name__}")
    if isinstance(found, Fraction):
        found = fmpq(found.numerator, found.denominator)
    ball = found if isinstance(found, arb) else arb(found)
    if not ball.is_finite():
        raise DomainError("not a finite number")
    return ball


def bits_of(digits: int) -> int:
    """Bits that hold this many decimal digits; DomainError outside 1, ..., MOST_DIGITS."""
    if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= MOST_DIGITS:
        raise DomainError(f"digits must be an integer from 1 to {MOST_DIGITS}, not {digits!r}")
    return ceil(digits * 3.3219280948873626) + 1


def certified(
    compute: Callable[[], Any],
    *,
    inputs: Sequence[Real] = (),
    digits: int,
    guard: int = 40,
    limit: int | None = None,
) -> Enclosure:
    """Enclosure accurate to 10^-digits of itself that also decides its decimal of that length.

    compute: gives a ball at the precision in force, or raises UndecidedError. guard: bits that it
    is expected to lose. limit: most bits to try, by default 64 times those of the digits, at most
    2^20. Raises InsufficientPrecisionError, with the last enclosure, at the limit or as soon as
    more bits no longer make an inexact input smaller.
    """
    needed = bits_of(digits)
    most = min(MOST_BITS, CAP_FACTOR * needed) if limit is None else limit
    bits, last, widths = min(needed + guard, most), None, [float("inf")] * len(inputs)
    while True:
        with working(bits):
            balls = [ball_of(value) for value in inputs]
            try:
                ball = compute()
                missing = needed - ball.rel_accuracy_bits() if ball.is_finite() else bits
            except UndecidedError as undecided:
                ball, missing, last = None, bits, undecided.enclosure or last
        if ball is not None and ball.is_finite():
            last = Enclosure.of(ball)
            if last.is_accurate_to(digits) and last.decimal(digits) is not None:
                return last
        radii = [_log_radius(value) for value in balls]
        stuck = any(new > old - 1 for new, old in zip(radii, widths, strict=True))
        if bits >= most or stuck:
            cause = "an input is known no better" if stuck else f"the limit is {most} bits"
            raise InsufficientPrecisionError(f"{digits} digits not reached: {cause}", last)
        widths = radii
        bits = min(most, bits + max(32, bits // 8, min(missing, bits) + 16))


def _log_radius(ball: Any) -> float:
    """Binary logarithm of the radius, roughly; -inf for an exact ball."""
    mantissa, exponent = ball.rad().man_exp()
    return float(int(mantissa).bit_length() + int(exponent)) if mantissa else float("-inf")


def coarse(value: float, *, bits: int = 8) -> Any:
    """Exact ball of the positive float cut to this many leading bits, at most the float."""
    mantissa, exponent = _split(value, bits)
    return arb((mantissa, exponent))


def _split(value: float, bits: int) -> tuple[int, int]:
    numerator, denominator = value.as_integer_ratio()
    shift = numerator.bit_length() - denominator.bit_length() - bits
    scaled = Fraction(numerator, denominator) / Fraction(2) ** shift
    return int(scaled), shift
