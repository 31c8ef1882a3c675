"""Reference values of Minding's bobbin in elliptic functions, by mpmath (ex:bobbin).

kappa > 0 is the curvature of the throat; xi = u + v runs along the asymptotic lines from s = 0 with
s' > 0. From (s')^2 + cosh^2(s)/(kappa^2 + 1) = 1 (eq:econs), y = sinh s obeys
(y')^2 = (1 + y^2)(kappa^2 - y^2)/(kappa^2 + 1), the equation of k sd(xi | m) with the parameter
m = k^2 = kappa^2/(kappa^2 + 1); then cosh s = nd(xi | m).
"""

from collections.abc import Callable
from typing import Any

from mpmath import mp

from theory.errors import DomainError
from theory.reference_precision import Magnified, Real, close, mpf_of, settled

LARGEST_RADIUS = 1000


def arc_length(kappa: Real, xi: Real, *, digits: int = 30) -> Any:
    """Signed arc length s(xi) from the throat along a meridian, |s| <= asinh kappa (eq:econs).

    Raises DomainError, InsufficientPrecisionError.

    >>> print(mp.nstr(arc_length(1, 1), 10))
    0.6442819579
    """

    def at(a: Any, x: Any) -> tuple[Any, Any]:
        if x == 0:
            return mp.zero, mp.one
        found = mp.asinh(mp.sqrt(_parameter(a)) * _elliptic("sd", a, x))
        return found, _lost(a, x, found)

    return settled(lambda: at(_throat(kappa), mpf_of(xi)), digits=digits)


def radius(kappa: Real, xi: Real, *, digits: int = 30) -> Any:
    """Distance rho = cosh(s(xi))/kappa from the axis. Raises DomainError.

    >>> print(mp.nstr(radius(2, 0), 12))
    0.5
    """

    def at(a: Any, x: Any) -> tuple[Any, Any]:
        return _elliptic("nd", a, x) / a, _lost(a, x, x)

    return settled(lambda: at(_throat(kappa), mpf_of(xi)), digits=digits)


def height(kappa: Real, xi: Real, *, digits: int = 30) -> Any:
    """Height z(xi) along the axis, from z' = (kappa^2 - sinh^2 s)/(kappa sqrt(kappa^2 + 1)) >= 0.

    That is k cd^2(xi | m), whose integral is (xi - E(xi) + m sn cd)/k (eq:zprime).

    >>> print(mp.nstr(height(2, 0), 12))
    0.0
    """

    def at(a: Any, x: Any) -> tuple[Any, Any]:
        if x == 0:
            return mp.zero, mp.one
        m, quarter = _parameter(a), _quarter(a)
        turns = mp.nint(x / (2 * quarter))
        rest = x - 2 * turns * quarter
        sn, cn, dn = (mp.ellipfun(name, rest, m=m) for name in ("sn", "cn", "dn"))
        amplitude = mp.atan2(sn, cn)
        arc = mp.ellipe(amplitude, m) + 2 * turns * mp.ellipe(m)
        found = (x - arc + m * sn * cn / dn) / mp.sqrt(m)
        # For a small m the difference is as small as m.
        return found, _lost(a, x, found) / mp.sqrt(m)

    return settled(lambda: at(_throat(kappa), mpf_of(xi)), digits=digits)


def period(kappa: Real, *, digits: int = 30) -> Any:
    """Period 4 K(m) of s(xi); s turns at odd multiples of a quarter of it.

    >>> print(mp.nstr(period(1), 12), mp.nstr(4 * mp.ellipk(mp.mpf(1) / 2), 12))
    7.41629870921 7.41629870921
    """
    return settled(lambda: (4 * _quarter(_throat(kappa)), 1 + _throat(kappa) ** 2), digits=digits)


def half_length(kappa: Real, *, digits: int = 30) -> Any:
    """Arc length L from the throat to the singular edge, where s turns (ex:bobbin).

    >>> print(mp.nstr(half_length(lambda: mp.sinh(3)), 12))
    3.0
    """
    return settled(lambda: (mp.asinh(_throat(kappa)), mp.one), digits=digits)


def turning_point(kappa: Real, *, digits: int = 30) -> Any:
    """Least xi > 0 where s turns, the quarter period K(m) (eq:econs).

    >>> print(mp.nstr(arc_length(1, turning_point(1)), 12), mp.nstr(half_length(1), 12))
    0.88137358702 0.88137358702
    """
    return settled(lambda: (_quarter(_throat(kappa)), 1 + _throat(kappa) ** 2), digits=digits)


def disk_max_curvature(kappa: Real, disk_radius: Real, *, digits: int = 30) -> Any:
    """Largest principal curvature on the disk of this geodesic radius about a point of the throat.

    By rho = cosh(s)/kappa and z_s^2 = 1 - rho_s^2 the curvatures are z_s/rho about the axis, which
    is largest at the throat, and rho_ss/z_s along the meridian, largest at the rim (eq:c2energy).
    Raises DomainError where the disk meets the singular edge.

    >>> print(mp.nstr(disk_max_curvature(2, 1), 12))
    2.0
    """

    def compute() -> tuple[Any, Any]:
        a, r = _throat(kappa), _radius(disk_radius)
        room = a**2 - mp.sinh(r) ** 2
        if close(a, mp.sinh(r)):
            raise Magnified
        if room <= 0:
            raise DomainError("the disk meets the singular edge")
        rim = mp.cosh(r) / mp.sqrt(room)
        return max(a, rim), (1 + r) * (1 + a**2 / room)

    return settled(compute, digits=digits)


def least_max_curvature(disk_radius: Real, *, digits: int = 30) -> Any:
    """Least of the largest curvatures on a disk of this radius about the throat (eq:c2energy).

    The curvature kappa of the throat balances that of the meridian at the rim,
    cosh(R)/sqrt(kappa^2 - sinh^2 R): solved here as it stands. Raises DomainError.

    >>> print(mp.nstr(least_max_curvature(1), 12), mp.nstr(mp.cosh(1), 12))
    1.54308063482 1.54308063482
    """

    def compute() -> tuple[Any, Any]:
        r = _radius(disk_radius)
        # c = kappa/cosh R solves c^4 = c^2 tanh^2 R + sech^2 R; from the right Newton is monotone.
        square = mp.tanh(r) ** 2
        c = _zero(
            lambda c: c**4 - c**2 * square - mp.sech(r) ** 2,
            lambda c: 4 * c**3 - 2 * c * square,
            mp.mpf(2),
        )
        return c * mp.cosh(r), 1 + r

    return settled(compute, digits=digits)


def _throat(kappa: Real) -> Any:
    found = mpf_of(kappa)
    if not found > 0:
        raise DomainError(f"kappa must be positive, not {mp.nstr(found, 15)}")
    return found


def _radius(disk_radius: Real) -> Any:
    found = mpf_of(disk_radius)
    if not 0 < found <= LARGEST_RADIUS:
        raise DomainError(f"radius must lie in (0, {LARGEST_RADIUS}], not {mp.nstr(found, 15)}")
    return found


def _parameter(kappa: Any) -> Any:
    return kappa**2 / (kappa**2 + 1)


def _quarter(kappa: Any) -> Any:
    return mp.ellipk(_parameter(kappa))


def _elliptic(name: str, kappa: Any, x: Any) -> Any:
    return mp.ellipfun(name, x, m=_parameter(kappa))


def _lost(kappa: Any, x: Any, value: Any) -> Any:
    """Magnification of relative errors: 1 - m = 1/(kappa^2 + 1) and the phase suffer most."""
    if value == 0:
        if x != 0:
            raise Magnified
        return mp.one
    return (1 + kappa**2) * (1 + abs(x)) * max(abs(x / value), mp.one)


def _zero(function: Callable[[Any], Any], derivative: Callable[[Any], Any], start: Any) -> Any:
    try:
        return mp.findroot(function, start, df=derivative, solver="newton", tol=mp.eps**2 * 2**40)
    except (ValueError, ZeroDivisionError) as error:
        raise Magnified from error
