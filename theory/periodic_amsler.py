r"""Certified max curvature of periodic Amsler surfaces on geodesic disks (eq:c2energy, ebound).

The disk of radius R is cut at its centre into 2 m sectors of opening pi/m, each an Amsler sector:
phi = phi(2 sqrt(u v)), phi(0) = pi/m =: phi_0 (PIII). The curvatures are tan(phi/2) and cot(phi/2).

*Where phi is extreme.* It is least, phi_0, on the edges of the sectors. On the disk it is largest
at the rim of the mirror lines u = v. Proof, with phi < pi throughout. Let a unit-speed geodesic
leave the apex at the angle a_0 < phi_0/2 from the u-edge; a, b are its angles to r_u and from it to
r_v, a + b = phi, so that u' = sin b/sin phi, v' = sin a/sin phi. In a Chebyshev net r_u is parallel
along v-lines and turns by -phi_u along u-lines: a' = phi_u u', b' = phi_v v', where phi_u =
2 v phi'(z)/z, phi_v = 2 u phi'(z)/z with phi'(z) > 0. So a, b stay positive, phi grows, and with
B = u v' - v u'

    (b - a)' = 2 phi'(z)/z B,   B(0) = 0,
    (log v'/u')' = a' cot a - b' cot b = 2 phi'(z)/(z sin phi) (v sin b cot a - u sin a cot b).

Where B = 0, v/u = v'/u' = sin a/sin b, and the second line is positive if b > a: there B' =
u u' (v'/u')' > 0. At the start v'/u' grows likewise, so B > 0 near 0; b - a cannot vanish before B
does, nor B before b - a. Hence b > a and B > 0 for ever: v/u < v'/u' = sin a/sin b < 1. Turning the
ray about the apex moves its point at distance s by sinh(s) along the normal, of components
-cos b/sin phi and cos a/sin phi, so that

    dz/da_0 = 2 sinh(s)/(z sin phi) (u cos a - v cos b) > 0,

as v cos b < u sin a cos b/sin b < u cos a if cos b > 0 (sin(b - a) > 0), and trivially otherwise.
At each distance z, hence phi, is largest on the mirror line, where the distance is the integral of
cos(phi/2) dz (theory.painleve.diagonal). While R is less than its value at phi = pi, no ray has met
the singular edge.

*Best number of sectors.* For larger m, phi_0 is smaller, so at each z phi is smaller and the
distance larger (theory.initial_angle): phi at the rim is smaller. So tan(phi_rim/2) falls with m
and cot(phi_0/2) grows; the least maximum is at the first m with cot(phi_0/2) >= tan(phi_rim/2) or
at the one before. That first m, where phi_rim <= pi - phi_0, is found by bisection.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb

from theory.bobbin_values import positive
from theory.enclosure import Enclosure
from theory.errors import DomainError, InsufficientPrecisionError, SingularEdgeError, UndecidedError
from theory.painleve_passage import length_passage
from theory.precision import Real, certified, working

GUARD = 60
LARGEST_RADIUS = 50


def max_curvature(
    radius: Real, sectors: int | None = None, *, digits: int = 15, limit: int | None = None
) -> Enclosure:
    """Largest principal curvature on the disk of geodesic radius R, for 2 m sectors in all.

    radius: in (0, 50]; sectors: the even number 2 m >= 4, by default the best one for the disk.
    Raises SingularEdgeError where the disk reaches phi = pi, with the distance of that edge.

    >>> max_curvature(1, 4, digits=20).decimal(20)
    '1.9509170522203045100'
    """
    half = _half(best_sectors(radius) if sectors is None else sectors)

    def compute() -> Any:
        return _curvature_at_centre(half).max(_curvature_at_rim(half, _distance(radius)))

    return certified(compute, inputs=(radius,), digits=digits, guard=_guard(half), limit=limit)


def rim_angle(
    radius: Real, sectors: int, *, digits: int = 15, limit: int | None = None
) -> Enclosure:
    """Largest angle phi on the disk, taken at its rim on the mirror lines; radians.

    >>> rim_angle(1, 8, digits=20).decimal(20)
    '1.0106238048877598693'
    """
    half = _half(sectors)
    return certified(
        lambda: _rim_angle(half, _distance(radius)),
        inputs=(radius,),
        digits=digits,
        guard=_guard(half),
        limit=limit,
    )


def best_sectors(radius: Real) -> int:
    """Number 2 m of sectors with the least max curvature on the disk; certified.

    >>> best_sectors(1)
    6
    """
    first = _first_balanced(radius)

    def earlier_is_better() -> bool | None:
        try:
            before = _curvature_at_rim(first - 1, _distance(radius))
        except SingularEdgeError:
            return False
        return _less(before, _curvature_at_centre(first))

    return 2 * (first - 1 if _decide(earlier_is_better) else first)


def _first_balanced(radius: Real) -> int:
    """Least m with phi_rim <= pi - phi_0; above 2, where this says phi_rim <= phi_0."""

    def is_balanced(half: int) -> bool:
        def answer() -> bool | None:
            try:
                rim = _rim_angle(half, _distance(radius))
            except SingularEdgeError:
                return False
            return _less(rim, arb.pi() - arb.pi() / half)

        return _decide(answer)

    low, high = 2, 4
    while not is_balanced(high):
        low, high = high, 2 * high
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if is_balanced(middle) else (middle, high)
    return high


def _curvature_at_centre(half: int) -> Any:
    return (arb.pi() / (2 * half)).cot()


def _curvature_at_rim(half: int, radius: Any) -> Any:
    return (_rim_angle(half, radius) / 2).tan()


def _rim_angle(half: int, radius: Any) -> Any:
    return length_passage(arb.pi() / half, radius).angle


def _half(sectors: int) -> int:
    """Half the number of sectors, if that is even and at least 4."""
    if isinstance(sectors, bool) or not isinstance(sectors, int) or sectors < 4 or sectors % 2:
        raise DomainError(f"sectors must be an even number from 4 on, not {sectors!r}")
    return sectors // 2


def _distance(radius: Real) -> Any:
    """Ball of the radius, in (0, 50]."""
    ball = positive(radius)
    if ball > LARGEST_RADIUS:
        raise DomainError(f"the radius must not exceed {LARGEST_RADIUS}", Enclosure.if_finite(ball))
    return ball


def _less(first: Any, second: Any) -> bool | None:
    """Whether first <= second; None where the balls do not decide."""
    return True if first <= second else False if first > second else None


def _decide(answer: Callable[[], bool | None]) -> bool:
    """First answer that is not None as the bits double; InsufficientPrecisionError past 2^14."""
    for power in range(7, 15):
        with working(2**power):
            try:
                found = answer()
            except UndecidedError:
                found = None
        if found is not None:
            return found
    raise InsufficientPrecisionError("2^14 bits do not decide the number of sectors")


def _guard(half: int) -> int:
    """Bits lost up to the place where the diagonal has this length: about the first crossing."""
    return GUARD + 2 * half.bit_length()
