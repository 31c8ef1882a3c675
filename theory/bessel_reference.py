"""Reference values around the modified Bessel function I_0, by mpmath's besseli and findroot.

Arguments are exact (see reference_precision.Real), results are mpf: good digits, no proof.
"""

from collections.abc import Callable
from typing import Any

from mpmath import mp

from theory.errors import DomainError
from theory.reference_precision import Magnified, Real, close, mpf_of, same, settled

LARGEST_ARGUMENT = 10**4

MOST_DIGITS = 2000
"""Most digits of this route: ten thousand take mpmath minutes."""


def i0(x: Real, *, digits: int = 30) -> Any:
    """Value I_0(x), for 0 <= x <= 10^4. Raises DomainError, InsufficientPrecisionError.

    >>> print(mp.nstr(i0(1), 12))
    1.26606587775
    """

    def compute() -> tuple[Any, Any]:
        at = _argument(x)
        return mp.besseli(0, at), 1 + at

    return settled(compute, digits=digits, most_digits=MOST_DIGITS)


def i1(x: Real, *, digits: int = 30) -> Any:
    """Value I_1(x), for 0 <= x <= 10^4. Raises DomainError, InsufficientPrecisionError.

    >>> print(mp.nstr(i1(1), 12))
    0.565159103992
    """

    def compute() -> tuple[Any, Any]:
        at = _argument(x)
        return mp.besseli(1, at), 1 + at

    return settled(compute, digits=digits, most_digits=MOST_DIGITS)


def inverse_i0(y: Real, *, digits: int = 30) -> Any:
    """Inverse x >= 0 of I_0, I_0(x) = y, for y >= 1 (lem:amsler_recursion).

    Raises DomainError, InsufficientPrecisionError.

    >>> print(mp.nstr(inverse_i0(lambda: mp.besseli(0, 2)), 12))
    2.0
    """

    def compute() -> tuple[Any, Any]:
        value = mpf_of(y)
        if same(y, 1):
            return mp.zero, mp.one
        if close(value, mp.one):
            raise Magnified
        if value < 1:
            raise DomainError(f"I_0 takes values of 1 or more, not {mp.nstr(value, 15)}")
        log = mp.log(value)
        start = 2 * mp.sqrt(value - 1) if value < 3 else log + mp.log(2 * mp.pi * (log + 1)) / 2
        x = _newton(
            lambda x: mp.besseli(0, x) / value - 1, lambda x: mp.besseli(1, x) / value, start
        )
        return x, value / (x * mp.besseli(1, x))

    return settled(compute, digits=digits, most_digits=MOST_DIGITS)


def fixed_point(*, digits: int = 30) -> Any:
    """Solution x of I_0(x) = 3: the recursion leaves the angle as it is (rem:amsler_scaling).

    >>> print(mp.nstr(fixed_point(), 6))
    2.37835
    """
    return inverse_i0(3, digits=digits)


def supporting_argument(*, digits: int = 30) -> Any:
    """Place w > 0 where the supporting quadratic touches I_0(2 w^2)/3: 2 w^2 I_1 = I_0 there.

    >>> print(mp.nstr(supporting_argument(), 6))
    0.896738
    """
    return settled(
        lambda: (mp.sqrt(_touching() / 2), mp.one), digits=digits, most_digits=MOST_DIGITS
    )


def supporting_constant(*, digits: int = 30) -> Any:
    """Least value of I_0(2 w^2)/(3 w^2) over w > 0, the constant of the supporting quadratic.

    With t = 2 w^2 it is the least 2 I_0(t)/(3 t), reached where t I_1(t) = I_0(t).

    >>> print(mp.nstr(supporting_constant(), 6))
    0.729143
    """

    def compute() -> tuple[Any, Any]:
        t = _touching()
        return 2 * mp.besseli(0, t) / (3 * t), mp.one

    return settled(compute, digits=digits, most_digits=MOST_DIGITS)


def supporting_scale(*, digits: int = 30) -> Any:
    """Largest value alpha* of w/sqrt(I_0(2 w^2)/3): the supporting quadratic is (w/alpha*)^2.

    >>> print(mp.nstr(supporting_scale() ** -2, 6))
    0.729143
    """

    def compute() -> tuple[Any, Any]:
        t = _touching()
        return mp.sqrt(3 * t / (2 * mp.besseli(0, t))), mp.one

    return settled(compute, digits=digits, most_digits=MOST_DIGITS)


def _touching() -> Any:
    def excess(t: Any) -> Any:
        return t * mp.besseli(1, t) - mp.besseli(0, t)

    return _newton(excess, lambda t: t * mp.besseli(0, t) - mp.besseli(1, t), mp.mpf(2))


def _argument(x: Real) -> Any:
    found = mpf_of(x)
    if not 0 <= found <= LARGEST_ARGUMENT:
        raise DomainError(f"x must lie in [0, {LARGEST_ARGUMENT}], not {mp.nstr(found, 15)}")
    return found


def _newton(function: Callable[[Any], Any], derivative: Callable[[Any], Any], start: Any) -> Any:
    try:
        return mp.findroot(function, start, df=derivative, solver="newton", tol=mp.eps**2 * 2**40)
    except (ValueError, ZeroDivisionError) as error:
        raise Magnified from error
