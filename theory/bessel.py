"""Certified values around the modified Bessel functions I_0 and I_1 of the recursion's bounds.

In w = x^2/4, I_0(x) = sum w^k/k!^2 = f(w) and f' = sum w^k/(k! (k + 1)!) >= 1 for w >= 0: f is
inverted in w, where its slope is positive up to the end w = 0. Real arguments and the keywords
digits and limit are those of theory.painleve.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb

from theory.enclosure import Enclosure
from theory.errors import DomainError, UndecidedError
from theory.interval_newton import root
from theory.precision import Real, ball_of, certified

MOST_DOUBLINGS = 40
LARGEST_X = 10**6


def i0(x: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """I_0(x) for |x| <= 10^6 (boundCphi*).

    >>> i0(1, digits=20).decimal(20)
    '1.2660658777520083356'
    """
    return _at(x, lambda ball: ball.bessel_i(0), digits, limit)


def i1(x: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """I_1(x), the derivative of I_0, for |x| <= 10^6.

    >>> i1(1, digits=20).decimal(20)
    '0.56515910399248502721'
    """
    return _at(x, lambda ball: ball.bessel_i(1), digits, limit)


def inverse_i0(y: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Inverse x >= 0 of I_0, for y >= 1 (lem:amsler_recursion).

    Isolated by interval Newton. Raises DomainError for y < 1.

    >>> inverse_i0(3, digits=20).decimal(20)
    '2.3783546953096879858'
    """

    def compute() -> Any:
        value = ball_of(y)
        if value < 1:
            raise DomainError("I_0 is never below 1", Enclosure.if_finite(value))
        if value == 1:
            return arb(0)
        if value.log() > LARGEST_X:
            raise DomainError(f"the inverse exceeds {LARGEST_X}", Enclosure.if_finite(value))
        if not value > 1:
            raise UndecidedError("y too near 1", Enclosure.if_finite(value))
        return inverse_i0_ball(value)

    return certified(compute, inputs=(y,), digits=digits, limit=limit)


def fixed_point(*, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Solution of I_0(x) = 3, where I_0(x)/3 is 1 (rem:amsler_scaling).

    >>> fixed_point(digits=20).decimal(20)
    '2.3783546953096879858'
    """
    return inverse_i0(3, digits=digits, limit=limit)


def supporting_constant(*, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Least value of I_0(2 w^2)/(3 w^2) over w > 0 (fig:frontier, the supporting quadratic).

    With t = 2 w^2 it is the least value of 2 I_0(t)/(3 t), taken at the touching point.

    >>> supporting_constant(digits=20).decimal(20)
    '0.72914322452764464133'
    """
    return certified(lambda: 2 * _touching().bessel_i(1) / 3, digits=digits, limit=limit)


def supporting_argument(*, digits: int = 15, limit: int | None = None) -> Enclosure:
    """The w > 0 where I_0(2 w^2)/(3 w^2) is least (fig:frontier).

    >>> supporting_argument(digits=20).decimal(20)
    '0.89673838763791061064'
    """
    return certified(lambda: (_touching() / 2).sqrt(), digits=digits, limit=limit)


def supporting_scale(*, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Largest value alpha* of w/sqrt(I_0(2 w^2)/3): the quadratic is (alpha/alpha*)^2.

    >>> supporting_scale(digits=20).decimal(20)
    '1.1710989126473856500'
    """
    return certified(lambda: (2 * _touching().bessel_i(1) / 3).rsqrt(), digits=digits, limit=limit)


def _touching() -> Any:
    """Ball around the only t > 0 with t I_1(t) = I_0(t), where I_0(t)/t is least.

    t I_1 - I_0 is -1 at 0, positive at 2, and its derivative t I_0 - I_1 is at least t I_0/2, as
    I_1 <= t I_0/2; it has the sign of the derivative of I_0(t)/t.
    """
    return root(
        lambda t: t * t.bessel_i(1) - t.bessel_i(0),
        lambda t: t * t.bessel_i(0) - t.bessel_i(1),
        arb(1),
        arb(2),
    )


def inverse_i0_ball(y: Any) -> Any:
    """Ball around the inverse of I_0 at a ball y > 1, at the precision in force.

    I_0(x) <= exp(x) and f(w) <= exp(w) bound the root w of log f(w) = log y from below.
    """

    def excess(w: Any) -> Any:
        return w.hypgeom_0f1(1).log() - log_y

    log_y = y.log()
    low = log_y.max(log_y * log_y / 4).lower()
    high = 2 * low
    for _ in range(MOST_DOUBLINGS):
        if excess(high) > 0:
            break
        high = 2 * high
    else:
        raise UndecidedError("no bracket for the inverse of I_0", Enclosure.if_finite(high))
    w = root(excess, lambda w: w.hypgeom_0f1(2) / w.hypgeom_0f1(1), low / 2, high)
    return 2 * w.sqrt()


def _at(x: Real, function: Callable[[Any], Any], digits: int, limit: int | None) -> Enclosure:
    """Certified value of the function at x."""

    def compute() -> Any:
        place = ball_of(x)
        if abs(place) > LARGEST_X:
            raise DomainError(f"|x| must not exceed {LARGEST_X}", Enclosure.if_finite(place))
        return function(place)

    return certified(compute, inputs=(x,), digits=digits, limit=limit)
