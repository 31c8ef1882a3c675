"""Certified values of PIII: phi'' + phi'/z = sin phi, phi(0) = phi0, phi'(0) = 0.

Everything returned is proved by ball arithmetic: a series at z = 0 and Taylor steps whose
remainders rest on a-priori enclosures in complex disks (theory.majorant), and roots by interval
Newton. phi0 is an exact real in (0, pi), or a ball of flint with a positive radius; then the result
encloses the values for all its numbers (theory.initial_angle). Real arguments are int, Fraction,
fmpz, fmpq, arb or functions that give a ball at the precision in force (theory.precision.Real).
Every function takes digits, the significant digits from 1 to 10000, and limit, the most bits to try
(by default 64 times those of the digits, at most 2^20), and raises InsufficientPrecisionError where
these do not do. DomainError stands for arguments that are certainly out of the domain.
"""

from __future__ import annotations

from math import ceil, log
from typing import Any

from flint import arb

from theory.enclosure import Enclosure
from theory.errors import DomainError, PastFirstCrossingError, UndecidedError
from theory.initial_angle import ends, inside, interval_inside, is_interval, over
from theory.painleve_passage import angle_passage
from theory.painleve_path import piece_at
from theory.painleve_piece import Piece
from theory.precision import Real, ball_of, certified, working

LARGEST_Z = 1000
#: Bits that the balls lose per unit of z, in which the solution may spread like exp(z).
LOSS = 1.46
GUARD = 40
PI_BITS = 4096


def angle(phi0: Real, z: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Angle phi(z) in radians for z in [0, 1000] (PIII).

    An interval phi0 is taken up to its first crossing of pi; beyond, PastFirstCrossingError.

    >>> angle(lambda: arb.pi() / 100, 5, digits=20).decimal(20)
    '0.84008936913347406896'
    """

    def value(initial: Real) -> Enclosure:
        def compute() -> Any:
            piece, place = _at(initial, z)
            return inside(initial) if piece is None else piece.angle(piece.local(place))

        return _certified(compute, initial, z, digits, limit)

    _check_family(phi0, z)
    return over(phi0, value)


def slope(phi0: Real, z: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Derivative phi'(z) for z in [0, 1000] (PIII).

    For an interval phi0 = m +- r: within r I_1(z) of the slope for m, which is given to digits.

    >>> slope(lambda: arb.pi() / 100, 5, digits=20).decimal(20)
    '0.72439921513013051000'
    """

    def value(initial: Real) -> Enclosure:
        def compute() -> Any:
            piece, place = _at(initial, z)
            return arb(0) if piece is None else piece.slope(place)

        return _certified(compute, initial, z, digits, limit)

    if not is_interval(phi0):
        return value(phi0)
    interval_inside(phi0)
    middle = value(phi0.mid()).ball()
    with working(middle.bits() + GUARD):
        spread = phi0.rad() * ball_of(z).bessel_i(1)
        return Enclosure.of(middle + arb(0, spread.upper()))


def diagonal(phi0: Real, z: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Integral of cos(phi/2) from 0 to z in [0, 1000], with its sign (PIII, def:amsler-sector).

    As long as phi < pi it is the geodesic distance of the point u = v = z/2 of an Amsler sector
    from its apex: along its mirror line ds^2 = (2 + 2 cos phi) du^2 = cos(phi/2)^2 dz^2. An
    interval phi0 is taken up to its first crossing of pi; beyond, PastFirstCrossingError.

    >>> diagonal(lambda: arb.pi() / 100, 5, digits=20).decimal(20)
    '4.9489110217608716693'
    """

    def value(initial: Real) -> Enclosure:
        def compute() -> Any:
            piece, place = _at(initial, z, with_length=True)
            return arb(0) if piece is None else piece.length(piece.local(place))

        return _certified(compute, initial, z, digits, limit)

    _check_family(phi0, z)
    return over(phi0, value)


def crossing(phi0: Real, level: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """First z with phi(z) = level, for levels from phi0 to the first maximum of phi (PIII).

    The root is unique on a bracket from 0 on which phi' > 0 is certain. Levels above the maximum
    raise PastFirstMaximumError. For an interval phi0 the level must not exceed pi, and one that
    4096 bits do not tell from pi is taken for pi.

    >>> crossing(lambda: arb.pi() / 100, arb.pi, digits=30).decimal(30)
    '6.75417466722776265995483821875'
    """

    def value(initial: Real) -> Enclosure:
        def compute() -> Any:
            start, target = inside(initial), ball_of(level)
            if initial is level or _same_number(initial, level):
                return arb(0)
            if target < start:
                raise DomainError("level below phi0", Enclosure.if_finite(target))
            if not target > start:
                raise UndecidedError("level too near phi0", Enclosure.if_finite(target))
            return angle_passage(start, target).z

        return _certified(compute, initial, level, digits, limit, spread=8 - log(_size(initial)))

    if is_interval(phi0):
        interval_inside(phi0)
        with working(PI_BITS):
            if ball_of(level) > arb.pi():
                raise DomainError("for an interval phi0 the level must not exceed pi")
    return over(phi0, value)


def _at(initial: Real, z: Real, *, with_length: bool = False) -> tuple[Piece | None, Any]:
    """Piece with the solution at z and the ball of z; no piece for z = 0."""
    start, place = inside(initial), ball_of(z)
    if place < 0 or place > LARGEST_Z:
        raise DomainError(f"z must lie between 0 and {LARGEST_Z}", Enclosure.if_finite(place))
    if place == 0:
        return None, place
    if not place > 0:
        raise UndecidedError("z too near 0", Enclosure.if_finite(place))
    return piece_at(start, place, with_length=with_length), place


def _certified(
    compute: Any, initial: Real, other: Real, digits: int, limit: int | None, spread: float = 0
) -> Enclosure:
    """Certified value of compute, with bits for the spread of solutions up to z."""
    guard = GUARD + ceil(LOSS * (spread or _size(other)))
    return certified(compute, inputs=(initial, other), digits=digits, guard=guard, limit=limit)


def _size(value: Real) -> float:
    """Rough float of the real, for estimates; at least 1e-300 and at most LARGEST_Z."""
    with working(GUARD):
        return min(max(float(abs(ball_of(value)).mid()), 1e-300), LARGEST_Z)


def _same_number(first: Real, second: Real) -> bool:
    """Whether two reals are exact numbers and equal."""
    return not (callable(first) or callable(second)) and bool(first == second)


def _check_family(phi0: Real, z: Real) -> None:
    """Refuse an interval of initial angles whose largest has crossed pi before z."""
    if is_interval(phi0):
        interval_inside(phi0)
        first = crossing(ends(phi0)[1], arb.pi)
        with working(2 * GUARD):
            if not ball_of(z) <= first.ball():
                raise PastFirstCrossingError("the largest phi0 crosses pi before z", first)
