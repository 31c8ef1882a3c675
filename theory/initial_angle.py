"""Initial angles of PIII: one exact number in (0, pi), or a whole interval of them.

Comparison in phi0, for the family phi(z; phi0) and with w = d phi/d phi0, D = z d/dz:

    D^2 w = z^2 cos phi w,  D^2 sin phi = z^2 cos phi sin phi - sin phi (D phi)^2,

so that W = w D sin phi - sin phi D w has D W = -w sin phi (D phi)^2, and W = 0 at z = 0. While
w > 0 and phi < pi, W < 0, hence w/sin phi grows from 1/sin phi0 > 0 and w stays positive; where phi
first is pi, W = w D sin phi = -w D phi < 0 gives w > 0 there too. So phi(z; phi0) grows with phi0
while it is at most pi; a level up to pi is met the earlier, and cos(phi/2), which falls with phi,
has the smaller integral. For every z, |w| <= I_0 and |D w| <= z I_1, as |cos phi| <= 1 in the
integral equation D w = integral of z cos phi w.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb

from theory.enclosure import Enclosure
from theory.errors import DomainError, UndecidedError
from theory.precision import Real, ball_of, working

HULL_BITS = 64


def is_interval(phi0: Real) -> bool:
    """Whether phi0 is a ball with a positive radius, which stands for all its numbers."""
    return isinstance(phi0, arb) and not phi0.is_exact()


def ends(phi0: Any) -> tuple[Any, Any]:
    """Exact ends of the interval, rounded outwards past 64 bits more than its midpoint has."""
    with working(phi0.bits() + HULL_BITS):
        return phi0.lower(), phi0.upper()


def interval_inside(phi0: Any) -> None:
    """Refuse an interval that is not certainly in (0, pi) by DomainError."""
    with working(phi0.bits() + HULL_BITS):
        if not (phi0 > 0 and phi0 < arb.pi()):
            raise DomainError("phi0 must lie between 0 and pi", Enclosure.if_finite(phi0))


def inside(phi0: Real) -> Any:
    """Ball around phi0 that lies in (0, pi); DomainError where it is certainly not there."""
    ball = ball_of(phi0)
    if ball > 0 and ball < arb.pi():
        return ball
    if ball <= 0 or ball >= arb.pi():
        raise DomainError("phi0 must lie between 0 and pi", Enclosure.if_finite(ball))
    raise UndecidedError("phi0 is too near 0 or pi", Enclosure.if_finite(ball))


def over(phi0: Real, value: Callable[[Real], Enclosure]) -> Enclosure:
    """Enclosure of a monotone function of the initial angle, at one or over an interval of them.

    Over an interval it is the hull of the enclosures at its ends, its radius rounded up to 30 bits.
    """
    if not is_interval(phi0):
        return value(phi0)
    first, second = (value(end).ball() for end in ends(phi0))
    with working(max(first.bits(), second.bits()) + HULL_BITS):
        return Enclosure.of(first.union(second))
