"""Largest value of a function of one real variable over an interval, enclosed by subdivision."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from flint import arb, fmpq
from mpmath import mp

MOST_CELLS = 20_000


def cell(low: Fraction, high: Fraction) -> Any:
    """Ball that contains the interval."""
    return _ball(low).union(_ball(high))


def reference_ball(value: Any, *, digits: int = 28) -> Any:
    """Ball of no great width about a decimal of this length, cut from an mpf: no proof."""
    return arb(mp.nstr(value, digits))


def largest(
    function: Callable[[Any], Any], low: Fraction, high: Fraction, *, width: Fraction
) -> Any:
    """Ball around the largest value over [low, high], wider than width by rounding at most.

    function: encloses its values over a ball, at the precision in force. The cells whose upper
    bound is below a value taken elsewhere are dropped, the others halved: also those without a
    finite bound. ArithmeticError where too many are left.
    """
    cells, best, wanted = [(low, high)], function(_ball(low)), _ball(width)
    while len(cells) <= MOST_CELLS:
        best = _highest(best, [function(_ball((a + b) / 2)).lower() for a, b in cells])
        tops = [(function(cell(a, b)).upper(), a, b) for a, b in cells]
        kept = [(top, a, b) for top, a, b in tops if not top < best]
        above = _highest(best, [top for top, _, _ in kept])
        finite = all(top.is_finite() for top, _, _ in kept)
        if finite and above - best < wanted:
            return best.union(above)
        halves = [((a, (a + b) / 2), ((a + b) / 2, b)) for _, a, b in kept]
        cells = [part for pair in halves for part in pair]
    raise ArithmeticError(f"more than {MOST_CELLS} cells are left")


def _highest(start: Any, values: list[Any]) -> Any:
    found = start.lower()
    for value in values:
        if value > found:
            found = value
    return found


def _ball(number: Fraction) -> Any:
    return arb(fmpq(number.numerator, number.denominator))
