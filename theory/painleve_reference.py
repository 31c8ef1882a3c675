"""Reference values of the solution of phi'' + phi'/z = sin phi, phi(0) = phi0, phi'(0) = 0 (PIII).

A Taylor integrator in mpmath that shares no code with the certified route: the digits are those
that its own estimate of the error promises, not a proof. Arguments are exact (see
reference_precision.Real), results are mpf.
"""

from typing import Any

from mpmath import mp

from theory.errors import DomainError
from theory.painleve_segments import place_of_angle, reaching, rising, segments
from theory.painleve_series import Segment
from theory.reference_precision import Magnified, Real, close, mpf_of, same, settled

FURTHEST = 200
"""Largest z."""

MOST_DIGITS = 500
"""Most digits of this route: Python's integers make a thousand a matter of minutes."""


def angle(phi0: Real, z: Real, *, digits: int = 30) -> Any:
    """Angle phi(z), for 0 < phi0 < pi and 0 <= z <= 200 (PIII).

    Raises DomainError, InsufficientPrecisionError.

    >>> from fractions import Fraction
    >>> import mpmath
    >>> print(mpmath.nstr(angle(Fraction(1, 10), 5), 12))
    2.32457000861
    """

    def at(start: Any, end: Any) -> tuple[Any, Any]:
        return _last(start, end).angle(end), mp.one

    return settled(lambda: at(_initial(phi0), _place(z)), digits=digits, most_digits=MOST_DIGITS)


def slope(phi0: Real, z: Real, *, digits: int = 30) -> Any:
    """Slope phi'(z), for 0 < phi0 < pi and 0 <= z <= 200 (PIII).

    Raises DomainError, InsufficientPrecisionError.

    >>> import mpmath
    >>> print(mpmath.nstr(slope(1, 1), 12))
    0.446401259076
    """

    def at(start: Any, end: Any) -> tuple[Any, Any]:
        last = _last(start, end)
        found = last.slope(end)
        return found, _ratio(last.angle(end) * min(end, mp.one), found)

    return settled(lambda: at(_initial(phi0), _place(z)), digits=digits, most_digits=MOST_DIGITS)


def diagonal(phi0: Real, z: Real, *, digits: int = 30) -> Any:
    """Signed integral of cos(phi/2) from 0 to z: the distance from the apex along the mirror line.

    Raises DomainError, InsufficientPrecisionError.

    >>> import mpmath
    >>> print(mpmath.nstr(diagonal(1, 1), 12))
    0.85944651043
    """

    def at(start: Any, end: Any) -> tuple[Any, Any]:
        total = mp.zero
        for segment in segments(start, end):
            total += segment.path(segment.end)
        return total, _ratio(end, total)

    return settled(lambda: at(_initial(phi0), _place(z)), digits=digits, most_digits=MOST_DIGITS)


def crossing(phi0: Real, level: Real, *, digits: int = 30) -> Any:
    """First z with phi(z) = level, for phi0 <= level up to the first maximum of phi.

    Raises DomainError for a level below phi0, PastFirstMaximumError for one above the maximum,
    InsufficientPrecisionError where more digits do not tell the level from the maximum.

    >>> from mpmath import mp
    >>> print(mp.nstr(crossing(lambda: mp.pi / 100, mp.pi), 12))
    6.75417466723
    """

    def at(start: Any, wanted: Any) -> tuple[Any, Any]:
        if close(wanted, start):
            raise Magnified
        if wanted < start:
            raise DomainError(f"level {mp.nstr(wanted, 15)} is below phi0 = {mp.nstr(start, 15)}")
        segment, end = reaching(start, wanted)
        z = place_of_angle(segment, end, wanted)
        return z, _ratio(wanted, z * segment.slope(z))

    def compute() -> tuple[Any, Any]:
        start = _initial(phi0)
        return (mp.zero, mp.one) if same(phi0, level) else at(start, mpf_of(level))

    return settled(compute, digits=digits, most_digits=MOST_DIGITS)


def first_maximum(phi0: Real, *, digits: int = 30) -> tuple[Any, Any]:
    """First z > 0 with phi'(z) = 0, and the angle there: the largest angle of the solution.

    Raises DomainError, InsufficientPrecisionError.

    >>> from mpmath import mp
    >>> print(*(mp.nstr(x, 10) for x in first_maximum(1)))
    4.63986279 4.050520374
    """

    def place() -> tuple[Any, Any]:
        *_, (segment, z) = rising(_initial(phi0))
        return z, _ratio(segment.angle(z), z * segment.bend(z))

    def height() -> tuple[Any, Any]:
        *_, (segment, z) = rising(_initial(phi0))
        return segment.angle(z), mp.one

    return (
        settled(place, digits=digits, most_digits=MOST_DIGITS),
        settled(height, digits=digits, most_digits=MOST_DIGITS),
    )


def _last(phi0: Any, end: Any) -> Segment:
    *_, last = segments(phi0, end)
    return last


def _initial(phi0: Real) -> Any:
    found = mpf_of(phi0)
    if close(found, mp.pi):
        raise Magnified
    if not 0 < found < mp.pi:
        raise DomainError(f"phi0 must lie in (0, pi), not {mp.nstr(found, 15)}")
    return found


def _place(z: Real) -> Any:
    found = mpf_of(z)
    if not 0 <= found <= FURTHEST:
        raise DomainError(f"z must lie in [0, {FURTHEST}], not {mp.nstr(found, 15)}")
    return found


def _ratio(scale: Any, value: Any) -> Any:
    """Size of scale beside value; Magnified where value is 0 though scale is not."""
    if value == 0 and scale != 0:
        raise Magnified
    return abs(scale / value) if scale else mp.one
