r"""Certified values of Minding's bobbin in elliptic functions (ex:bobbin, eq:econs, eq:c2energy).

Its arc length s from the throat obeys s'^2 = (kappa^2 - sinh^2 s)/(kappa^2 + 1) in xi = u + v; here
s(0) = 0, s'(0) > 0. With y = sinh s and k^2 = m = kappa^2/(kappa^2 + 1),

    y'^2 = (1 + y^2)(kappa^2 - y^2)/(kappa^2 + 1),  so that  y = k sd(xi | m),

because sd'^2 = (1 + m sd^2)(1 - (1 - m) sd^2). The height has z' = k (1 - y^2/kappa^2), which is
k sn^2(xi + K), so that k z = xi - (integral of dn^2 from K to xi + K) = xi - eps(xi) + m sn cd,
eps(xi) the integral of dn^2 from 0. s has the period 4 K and turns at the odd multiples of K.
Real arguments and the keywords digits and limit are those of theory.painleve.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import acb, arb

from theory.enclosure import Enclosure
from theory.errors import DomainError, UndecidedError
from theory.precision import Real, ball_of, certified


def arc_length(kappa: Real, xi: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Signed arc length s(xi) from the throat along a meridian, for kappa > 0 (eq:econs).

    >>> arc_length(1, 1, digits=20).decimal(20)
    '0.64428195791045334582'
    """
    return _along(kappa, xi, lambda orbit: orbit.sinh_arc().asinh(), digits, limit)


def radius(kappa: Real, xi: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Distance rho = cosh(s)/kappa from the axis (ex:bobbin).

    >>> radius(1, 1, digits=20).decimal(20)
    '1.2148291743873789587'
    """
    return _along(
        kappa, xi, lambda orbit: (1 + orbit.sinh_arc() ** 2).sqrt() / orbit.kappa, digits, limit
    )


def height(kappa: Real, xi: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Height z(xi) along the axis above the throat, which never falls (eq:zprime).

    >>> height(1, 1, digits=20).decimal(20)
    '0.59172857336179414949'
    """
    return _along(kappa, xi, lambda orbit: orbit.height(), digits, limit)


def turning_point(kappa: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Least xi > 0 where s turns, at the singular edge: the quarter period K (eq:econs).

    >>> turning_point(1, digits=20).decimal(20)
    '1.8540746773013719184'
    """
    return _along(kappa, 0, lambda orbit: orbit.quarter, digits, limit)


def period(kappa: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Least period 4 K of s(xi) (eq:econs).

    >>> period(1, digits=20).decimal(20)
    '7.4162987092054876737'
    """
    return _along(kappa, 0, lambda orbit: 4 * orbit.quarter, digits, limit)


def half_length(kappa: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Arc length asinh(kappa) from the throat to the singular edge (ex:bobbin).

    >>> half_length(1, digits=20).decimal(20)
    '0.88137358701954302523'
    """
    return certified(lambda: positive(kappa).asinh(), inputs=(kappa,), digits=digits, limit=limit)


def disk_max_curvature(
    kappa: Real, disk_radius: Real, *, digits: int = 15, limit: int | None = None
) -> Enclosure:
    """Largest principal curvature on the disk of this geodesic radius about a point of the throat.

    The larger of kappa at the throat and cosh R/sqrt(kappa^2 - sinh^2 R) at distance R from it
    (eq:c2energy). Raises DomainError where the disk meets the singular edge, sinh R >= kappa.

    >>> disk_max_curvature(2, 1).ends()
    (Fraction(2, 1), Fraction(2, 1))
    """

    def compute() -> Any:
        throat, distance = positive(kappa), positive(disk_radius)
        room = throat**2 - distance.sinh() ** 2
        if room <= 0:
            raise DomainError("the disk meets the singular edge", Enclosure.if_finite(room))
        if not room > 0:
            raise UndecidedError(
                "the disk is too near the singular edge", Enclosure.if_finite(room)
            )
        return throat.max(distance.cosh() / room.sqrt())

    return certified(compute, inputs=(kappa, disk_radius), digits=digits, limit=limit)


def least_max_curvature(
    disk_radius: Real, *, digits: int = 15, limit: int | None = None
) -> Enclosure:
    """Least max curvature over bobbins that contain a disk of this radius: cosh R (eq:c2energy).

    A disk about height s_0 >= 0 takes the heights |s - s_0| <= R; let c, C be the least and the
    largest cosh^2 s on it and a = kappa^2 + 1. The squares of the curvatures are a/cosh^2 s - 1 and
    its reciprocal, so that the largest are a/c - 1 and 1/(a/C - 1). The first grows with a, the
    second falls, and they meet at a = c + C in C/c: the least of the larger one. Now C =
    cosh^2(s_0 + R), and c = 1 for s_0 <= R, else cosh^2(s_0 - R). So C/c grows with s_0, in the
    second case as tanh(s_0 + R) > tanh(s_0 - R), and is least at s_0 = 0: cosh^2 R, for a =
    1 + cosh^2 R, kappa = cosh R.

    >>> least_max_curvature(1, digits=20).decimal(20)
    '1.5430806348152437785'
    """
    return certified(
        lambda: positive(disk_radius).cosh(), inputs=(disk_radius,), digits=digits, limit=limit
    )


def positive(value: Real) -> Any:
    """Ball around a positive real; DomainError where it is certainly not positive."""
    ball = ball_of(value)
    if ball <= 0:
        raise DomainError("not positive", Enclosure.if_finite(ball))
    if not ball > 0:
        raise UndecidedError("too near 0", Enclosure.if_finite(ball))
    return ball


class _Orbit:
    """Jacobi's functions at xi with the modulus of the bobbin, by theta functions."""

    def __init__(self, kappa: Any, xi: Any) -> None:
        self.kappa, self.xi = kappa, xi
        self.m = kappa**2 / (kappa**2 + 1)
        self.quarter = acb(self.m).elliptic_k().real
        other = acb(1 / (kappa**2 + 1)).elliptic_k().real
        self.tau = acb(0, other / self.quarter)

    def jacobi(self, xi: Any) -> tuple[Any, Any, Any]:
        """Balls around sn, cn and dn at xi."""
        place = acb(xi / (2 * self.quarter))
        t1, t2, t3, t4 = (theta.real for theta in acb.modular_theta(place, self.tau))
        _, z2, z3, z4 = (theta.real for theta in acb.modular_theta(acb(0), self.tau))
        return z3 * t1 / (z2 * t4), z4 * t2 / (z2 * t4), z4 * t3 / (z3 * t4)

    def sinh_arc(self) -> Any:
        """Ball around sinh s = k sd."""
        sn, _, dn = self.jacobi(self.xi)
        return self.m.sqrt() * sn / dn

    def height(self) -> Any:
        """Ball around z: the integral of dn^2 gains 2 E in 2 K, as often as fits near xi."""
        half_periods = (self.xi / (2 * self.quarter) + arb("0.5")).mid().floor().unique_fmpz()
        sn, cn, dn = self.jacobi(self.xi - 2 * half_periods * self.quarter)
        within = acb.elliptic_e_inc(acb(arb.atan2(sn, cn)), acb(self.m)).real
        whole = 2 * half_periods * acb(self.m).elliptic_e().real
        return (self.xi - whole - within + self.m * sn * cn / dn) / self.m.sqrt()


def _along(
    kappa: Real, xi: Real, value: Callable[[_Orbit], Any], digits: int, limit: int | None
) -> Enclosure:
    """Certified value of a function of the orbit at xi."""

    def compute() -> Any:
        return value(_Orbit(positive(kappa), ball_of(xi)))

    return certified(compute, inputs=(kappa, xi), digits=digits, limit=limit)
