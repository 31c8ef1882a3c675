"""Formulas of section 5.1 for all sectors, as printed: cut coordinates, quadratic, smallest angle.

`i0` is I_0 and `field` has `exp`, `log`, `sqrt`, for the numbers at hand (balls, mpmath, sympy). x
stands for I_0^(-1)(phi*/phi_n). Parameters that are fractions are texts: no field rounds them.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

Function = Callable[[Any], Any]


def _times(number: str, value: Any) -> Any:
    exact = Fraction(number)
    return exact.numerator * value / exact.denominator


def alpha_squared(x: Any, distance: Any, *, under: str = "4", power: int = 2) -> Any:
    """alpha_n^2 (eq:cut-coordinates)."""
    return x**power / _times(under, distance)


def axes_gap(
    distance: Any, u_max: Any, v_max: Any, *, sense: str = "at least", share: str = "1"
) -> Any:
    """What is said to be at least 0, from s_n^2 >= u_max v_max (5.1.distance-against-axes)."""
    gap = _times(share, distance**2) - u_max * v_max
    return gap if sense == "at least" else -gap


def zeta_of_alpha(alpha_squared: Any, *, factor: str = "2") -> Any:
    """What zeta_n is said to be like (5.1.zeta-against-alpha)."""
    return _times(factor, alpha_squared)


def curve(
    alpha: Any, i0: Function, *, share: str = "1/3", inside: str = "2", power: int = 2
) -> Any:
    """Curve f_1 (5.1.alpha-star)."""
    return _times(share, i0(_times(inside, alpha**power)))


def quotient(w: Any, i0: Function, field: Any, *, inside: str = "2", power: int = 2) -> Any:
    """Quotient whose largest value over w >= 0 is alpha* (5.1.alpha-star)."""
    return w / field.sqrt(curve(w, i0, inside=inside, power=power))


def quadratic(alpha: Any, alpha_star: Any, *, factor: str = "1", power: int = 2) -> Any:
    """Supporting quadratic f_2 (5.1.supporting-quadratic)."""
    return _times(factor, (alpha / alpha_star) ** power)


def least_quotient(
    w: Any, i0: Function, *, under: int = 3, inside: str = "2", power: int = 2
) -> Any:
    """Quotient whose least value over w > 0 is alpha*^(-2) (5.1.infimum-is-alpha-star)."""
    return i0(_times(inside, w**2)) / (under * w**power)


def amsler_bound(alpha_squared: Any, i0: Function, *, inside: str = "2") -> Any:
    """Bound called the best possible one (5.1.best-possible-bound)."""
    return i0(zeta_of_alpha(alpha_squared, factor=inside)) / 3


def smallest_argument(
    alpha_star: Any, radius: Any, field: Any, *, factor: str = "2", under: int = 1
) -> Any:
    """Argument of I_0 in phi_min (5.1.smallest-angle)."""
    return _times(factor, alpha_star * field.sqrt(under * radius))


def smallest_angle(
    level: Any, alpha_star: Any, radius: Any, i0: Function, field: Any, *, factor: str = "2"
) -> Any:
    """Smallest angle phi_min, level standing for phi* (5.1.smallest-angle)."""
    return level / i0(smallest_argument(alpha_star, radius, field, factor=factor))


def decay_exponent(
    alpha_star: Any, radius: Any, field: Any, *, factor: str = "1", under: int = 2
) -> Any:
    """Negative exponent in phi_min ~ exp(-alpha* sqrt(2 R)) (5.1.smallest-angle-decay)."""
    return _times(factor, alpha_star * field.sqrt(under * radius))


def kept_share(alpha_over_star_squared: Any, *, drop: int = 3) -> Any:
    """Two lower bounds of phi_(n+1)/phi_n whose larger one holds (5.1.pseudo-amsler-nodes)."""
    return Fraction(1, drop), alpha_over_star_squared
