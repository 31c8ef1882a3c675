"""Certified roots of increasing functions by bisection, Newton's method and interval Newton."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb, ctx

from theory.enclosure import Enclosure
from theory.errors import UndecidedError
from theory.precision import working

Function = Callable[[Any], Any]

COARSE_BITS = 64
BISECTIONS = 24


def root(function: Function, slope: Function, low: Any, high: Any) -> Any:
    """Ball around a root in [low, high], the only one in a bracket where the slope is positive.

    function, slope: enclose a function and its derivative at a ball, at the precision in force;
    low, high: exact balls between which the sign changes from - to +. The search is not proved;
    its result Z is, by interval Newton: for the midpoint m of Z, m - f(m)/f'(Z) lies inside Z and
    f'(Z) > 0, so that Z holds one root and it lies in both. Raises UndecidedError where this fails.
    """
    middle = _refined(function, slope, _bisected(function, low, high))
    value = function(middle)
    steepness = slope(middle)
    if not steepness > 0:
        raise UndecidedError("the slope at the root has no certain sign")
    spread = 4 * abs(value / steepness).upper() + abs(middle).upper() * arb((1, 4 - ctx.prec))
    for _ in range(8):
        bracket = arb(middle, spread.upper())
        image = newton_image(value, slope, middle, bracket)
        if image is not None and bracket.contains_interior(image):
            return image
        spread *= 16
    raise UndecidedError("interval Newton does not contract", Enclosure.if_finite(bracket))


def newton_image(value: Any, slope: Function, middle: Any, bracket: Any) -> Any | None:
    """Interval Newton operator m - f(m)/f'(Z); None where f'(Z) > 0 is not certain."""
    steepness = slope(bracket)
    return middle - value / steepness if steepness > 0 else None


def _coarse_bits() -> int:
    """Bits of the search: more where many are in force, as they may cancel near the root."""
    return COARSE_BITS + ctx.prec // 4


def _bisected(function: Function, low: Any, high: Any) -> Any:
    """Point near the root, by bisection on midpoints."""
    with working(_coarse_bits()):
        for _ in range(BISECTIONS):
            middle = ((low + high) / 2).mid()
            if function(middle).mid() < 0:
                low = middle
            else:
                high = middle
        return ((low + high) / 2).mid()


def _refined(function: Function, slope: Function, start: Any) -> Any:
    """Newton's method on midpoints, with twice the bits each time up to those in force."""
    middle, ladder, least = start, [ctx.prec], _coarse_bits()
    while ladder[-1] > least:
        ladder.append(ladder[-1] // 2 + 8)
    warm_up = (least // BISECTIONS).bit_length()
    for bits in (*ladder[-1:] * warm_up, *reversed(ladder), ladder[0]):
        with working(bits):
            steepness = slope(middle)
            if not steepness > 0:
                raise UndecidedError("the slope near the root has no certain sign")
            middle = (middle - function(middle) / steepness).mid()
    return middle
