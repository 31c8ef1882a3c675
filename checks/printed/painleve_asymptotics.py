"""The asymptotics of Painleve III as printed (appendix A, eqa5).

`field` stands for the numbers: it has `exp`, `log`, `sqrt`, `sin`, `cos` and `pi` (sympy, mpmath,
balls). Parameters that are fractions are texts, so that no field rounds them.
"""

from fractions import Fraction
from math import factorial
from typing import Any

import sympy as sp


def _times(number: str, value: Any) -> Any:
    exact = Fraction(number)
    return exact.numerator * value / exact.denominator


def linear_operator(
    f: Any, df: Any, ddf: Any, z: Any, *, damping: int = 1, linear: int = -1
) -> Any:
    """Left side of the linearised equation."""
    return ddf + damping * df / z + linear * f


def linear_coefficient(k: Any, *, order: int = 0, sign: int = 1, rate: str = "1") -> Any:
    """Coefficient of z^(2 k + order) in phi/phi0 for phi = phi0 I_order(rate z), k a symbol."""
    scale = sp.Rational(rate) / 2
    return sign**k * scale ** (2 * k + order) / (sp.factorial(k) * sp.factorial(k + order))


def linear_solution(phi0: Any, z: Any, field: Any, *, rate: str = "1", terms: int = 60) -> Any:
    """Partial sum of the series of phi0 I_0(rate z)."""
    x = _times(rate, z) * _times(rate, z) / 4
    return phi0 * sum(x**k / field.mpf(factorial(k)) ** 2 for k in range(terms))


def inner(phi0: Any, z: Any, *, coefficient: str = "1/4", power: int = 2) -> Any:
    """Expansion for small z without its error term (phi_inner, eqa5 line 1)."""
    return phi0 * (1 + _times(coefficient, z**power))


def growth(phi0: Any, z: Any, field: Any, *, under: str = "2", factor: str = "1") -> Any:
    """Leading term delta for large z, in which the data are matched."""
    return _times(factor, phi0 * field.exp(z) / field.sqrt(_times(under, field.pi * z)))


def outer(
    phi0: Any, z: Any, field: Any, *, correction: str = "1/8", under: str = "2", factor: str = "1"
) -> Any:
    """Expansion for large z without its error term (phi_outer, eqa5 line 2)."""
    leading = growth(phi0, z, field, under=under, factor=factor)
    return leading * (1 + _times(correction, 1 / z))


def pendulum_sides(f: Any, df: Any, ddf: Any, z: Any, *, damping: int = -1, sine: int = -1) -> Any:
    """Left and right side of the weakly damped pendulum equation."""
    return ddf + sine * sp.sin(f), damping * df / z


def pendulum(
    z: Any, crossing: Any, amplitude: Any, field: Any, *, rate: str = "1", centre: str = "1"
) -> Any:
    """Angle phi_pend; centre in units of pi."""
    swing = field.sin(_times(rate, crossing - z))
    return _times(centre, field.pi) - amplitude * swing


def energy(f: Any, df: Any, field: Any, *, potential: int = 1, kinetic: str = "1/2") -> Any:
    """Energy of the pendulum."""
    return _times(kinetic, df**2) + potential * field.cos(f)


def data_energy(delta: Any, *, level: int = 1, coefficient: str = "1/24", power: int = 4) -> Any:
    """Energy of the data (delta, delta) as expanded."""
    return level + _times(coefficient, delta**power)


def rate_of_angle(a: Any, da: Any, sine: Any, cosine: Any, *, rate_sign: int = 1) -> Any:
    """Bracket of the first three lines of the substitution, in place of phi'."""
    return rate_sign * da * sine + a * cosine


def near_pi(angle: Any, field: Any, *, level: int = -1, coefficient: str = "1/2") -> Any:
    """Potential of the second line of the substitution."""
    return level + _times(coefficient, (field.pi - angle) ** 2)


def third_line(a: Any, sine: Any, *, coefficient: str = "1/2", power: int = 2) -> Any:
    """Term (pi - phi)^2/2 in the third line of the substitution."""
    return _times(coefficient, (a * sine) ** power)


def fourth_line(
    a: Any, da: Any, sine: Any, cosine: Any, *, joined: str = "product", mixed: int = -2
) -> Any:
    """Fourth line of the substitution; joined: what stands between -1 and the bracket."""
    bracket = (da**2 * sine**2 + mixed * da * a * sine * cosine + a**2) / 2
    return -bracket if joined == "product" else -1 + bracket


def amplitude(delta: Any, field: Any, *, coefficient: str = "1/48", power: int = 4) -> Any:
    """Amplitude A of the pendulum."""
    return 2 * field.sqrt(1 + _times(coefficient, delta**power))


def third_amplitude(
    phi0: Any, z: Any, field: Any, *, phi0_power: int = 0, coefficient: str = "1/192"
) -> Any:
    """Factor of sin(z* - z) in (eqa5), line 3."""
    delta4 = phi0**phi0_power * field.exp(4 * z) / (field.pi * z) ** 2
    return 2 * field.sqrt(1 + _times(coefficient, delta4))


def crossing_estimate(
    phi0: Any,
    crossing: Any,
    field: Any,
    *,
    slow: str = "0",
    constant: str = "1",
    inverse: str = "0",
) -> Any:
    """Estimate of z* (eqa5, line 3): -log phi0 as printed.

    slow: factor of log(2 pi z*); constant: number whose logarithm is added; inverse: factor of
    1/z*.
    """
    unit = crossing / crossing
    estimate = -field.log(phi0) + field.log(_times(constant, unit))
    estimate += _times(slow, field.log(2 * field.pi * crossing))
    return estimate + _times(inverse, unit / crossing)
