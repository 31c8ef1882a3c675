"""Taylor segments of the solution of PIII from the origin, up to a place or to the first maximum.

Reference route, in mpmath: all numbers are mpf at the precision in force.
"""

from collections.abc import Callable, Iterator
from typing import Any

from mpmath import mp

from theory.errors import PastFirstMaximumError
from theory.painleve_series import Segment, origin, step
from theory.reference_precision import Magnified


def segments(phi0: Any, end: Any) -> Iterator[Segment]:
    """Taylor segments from 0 to end, mpf > 0, one after the other."""
    segment = origin(phi0, end)
    yield segment
    while segment.end < end:
        place, longest = segment.end, 2 * (segment.end - segment.start)
        segment = step(place, segment.angle(place), segment.slope(place), end, longest=longest)
        yield segment


def rising(phi0: Any) -> Iterator[tuple[Segment, Any]]:
    """Segments up to the first maximum, each with its end; the last ends at the maximum."""
    for segment in segments(phi0, mp.inf):
        if segment.slope(segment.end) <= 0:
            yield segment, _top(segment)
            return
        yield segment, segment.end


def place_of_angle(segment: Segment, end: Any, level: Any) -> Any:
    """First z <= end in the segment with phi(z) = level, where phi rises to it."""
    return _rising_zero(
        lambda z: segment.angle(z) - level, segment.slope, (segment.start, end), scale=level
    )


def place_of_path(segment: Segment, end: Any, length: Any) -> Any:
    """First z <= end at which the integral of cos(phi/2) from the segment's start is length."""
    return _rising_zero(
        lambda z: segment.path(z) - length,
        lambda z: mp.cos(segment.angle(z) / 2),
        (segment.start, end),
        scale=length,
    )


def _top(segment: Segment) -> Any:
    """Place of the maximum in a segment at whose end the angle falls."""
    return _rising_zero(
        lambda z: -segment.slope(z),
        lambda z: -segment.bend(z),
        (segment.start, segment.end),
        scale=segment.angle(segment.start),
    )


def reaching(phi0: Any, level: Any) -> tuple[Segment, Any]:
    """Segment in which phi rises to the level, and an end of it before the first maximum."""
    for segment, end in rising(phi0):
        if segment.angle(end) >= level:
            return segment, end
    highest = segment.angle(end)
    if level - highest < mp.ldexp(level, 40 - mp.prec):
        raise Magnified
    raise PastFirstMaximumError(
        f"level {mp.nstr(level, 15)} is above the first maximum of the angle, "
        f"{mp.nstr(highest, 15)}"
    )


def _rising_zero(
    function: Callable[[Any], Any],
    derivative: Callable[[Any], Any],
    bracket: tuple[Any, Any],
    *,
    scale: Any,
) -> Any:
    """Zero of a function that rises through 0 in the bracket: Newton, halving where it leaves.

    scale: size of what cancels in the function. Raises Magnified where rounding hides the zero.
    """
    low, high = bracket
    z = high
    for _ in range(2 * mp.prec):
        value = function(z)
        if abs(value) <= mp.ldexp(scale, 8 - mp.prec):
            return z
        low, high = (z, high) if value < 0 else (low, z)
        rise = derivative(z)
        z = z - value / rise if rise > 0 else low
        if not low < z < high:
            z = (low + high) / 2
    raise Magnified
