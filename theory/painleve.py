"""Certified values of PIII, phi'' + phi'/z = sin phi with phi(0) = phi0, phi'(0) = 0 (PIII).

Everything returned is proved by ball arithmetic: series at z = 0 and Taylor steps whose remainders
rest on a-priori enclosures in complex disks (theory.majorant), roots by interval Newton.

An angle phi0 is an exact real in (0, pi) (see theory.precision.Real), or a ball of flint with a
positive radius: then the result encloses the values for every phi0 of the ball, up to the first
crossing of pi. This rests on comparison: with w = d phi/d phi0 and D = z d/dz,

    D^2 w = z^2 cos phi w,  D^2 sin phi = z^2 cos phi sin phi - sin phi (D phi)^2,

so that W = w D sin phi - sin phi D w has D W = -w sin phi (D phi)^2 and W = 0 at z = 0. While w > 0
and phi < pi, W < 0, hence w/sin phi grows from 1/sin phi0 and w > 0 remains true; at phi = pi,
W = -w D phi < 0 gives w > 0 there too. So phi(z; phi0) grows with phi0 as long as it is at most pi,
its crossings of a level come earlier, and the integral of cos(phi/2) shrinks.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb

from theory.enclosure import Enclosure
from theory.errors import DomainError, PastFirstCrossingError, UndecidedError
from theory.painleve_passage import angle_passage
from theory.painleve_path import piece_at
from theory.precision import Real, ball_of, certified

LARGEST_Z = 1000
#: Bits that a ball loses per unit of z: the solution may spread like exp(z).
LOSS = 1.5


def angle(phi0: Real, z: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Angle phi(z), radians, for z in [0, 1000] (PIII).

    digits: significant digits, 1 to 10000; limit: most bits of precision. Raises DomainError,
    InsufficientPrecisionError; PastFirstCrossingError for a ball phi0 beyond its first crossing.

    >>> from flint import arb
    >>> angle(lambda: arb.pi() / 100, 5, digits=20).decimal(20)
    '0'
    """

    def at(initial: Any) -> Any:
        place = position(z)
        return initial if place == 0 else _value(initial, place)

    return over_family(phi0, at, (z,), digits=digits, guard=_guard(z), limit=limit, rising=True)
