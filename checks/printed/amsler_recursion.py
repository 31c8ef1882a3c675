"""The recursion on Amsler sectors as printed (section 5.1): lemma, proof and remark.

`field` stands for the numbers: it has `sin`, `sqrt`, `tan`, `cot` (sympy, balls). Parameters that
are fractions are texts, so that no field rounds them; X stands for I_0^{-1}(phi*/phi_n).
"""

from fractions import Fraction
from typing import Any

import sympy as sp


def _times(number: str, value: Any) -> Any:
    exact = Fraction(number)
    return exact.numerator * value / exact.denominator


def integral_equation(
    f: Any, phi_n: Any, z: Any, *, weight: int = 1, outer: int = -1, sign: int = 1
) -> Any:
    """Right side of the integral equation (eq:integral); f: function of one variable."""
    w, xi = sp.symbols("w xi", positive=True)
    inner = sp.Integral(sp.sin(f(xi)) * xi**weight, (xi, 0, w))
    return phi_n + sign * sp.Integral(inner * w**outer, (w, 0, z))


def constant_squared(
    level: Any, field: Any, *, scale: str = "1", root: bool = True, at: Any = None
) -> Any:
    """Square of the constant C(phi*) (eq:defC); at: angle that stands for phi*."""
    angle = level if at is None else at
    quotient = _times(scale, field.sin(angle) / angle)
    return quotient if root else quotient * quotient


def linear_side(
    f: Any, df: Any, ddf: Any, z: Any, c: Any, *, damping: int = 1, power: int = 2
) -> Any:
    """Left minus right side of the linear equation of the proof of lem:amsler_recursion."""
    return ddf + damping * df / z - c**power * f


def cut(
    x: Any, u_max: Any, v_max: Any, *, factor: str = "4", power: int = 2, swapped: bool = False
) -> tuple[Any, Any]:
    """Corner (u_n*, v_n*) of the cut, as set in the proof of lem:amsler_recursion."""
    over = (u_max, v_max) if swapped else (v_max, u_max)
    return x**power / _times(factor, over[0]), x**power / _times(factor, over[1])


def zeta(x: Any, u_max: Any, v_max: Any, field: Any, *, factor: str = "2", power: int = 2) -> Any:
    """Argument zeta_n of the lower bound (lem:amsler_recursion)."""
    return x**power / _times(factor, field.sqrt(u_max * v_max))


def ratio_bound(
    c: Any, x: Any, length: Any, *, daughters: str = "3", factor: str = "2", power: int = 2
) -> tuple[Any, Any]:
    """Argument of I_0, and what divides it, in the bound on phi_{n+1}/phi_n (rem:amsler_scaling).

    length: sqrt(u_max v_max) in the first inequality, R in the second.
    """
    return c * x**power / _times(factor, length), _times(daughters, length / length)


def least_angle(level: Any, rate: Any, root: Any, bessel: Any, *, divisor: str = "1") -> Any:
    """Angle phi_min of rem:amsler_scaling; rate: C', root: sqrt(R), bessel: the function I_0."""
    exact = Fraction(divisor)
    return level * exact.denominator / exact.numerator / bessel(rate * root)


def energies(
    least: Any, level: Any, field: Any, *, share: str = "1", exchanged: bool = False
) -> Any:
    """Two entries whose maximum is E_infinity (ebound); least: smallest angle at a branch point."""
    half, cutoff = least / 2, _times(share, level) / 2
    if exchanged:
        return field.tan(half), field.cot(cutoff)
    return field.cot(half), field.tan(cutoff)


def daughter_angle(angle: Any, *, daughters: str = "3") -> Any:
    """Angle phi_{n+1} of the next generation, by the angle at the branch point."""
    exact = Fraction(daughters)
    return angle * exact.denominator / exact.numerator


def cutoff_contour(level_place: Any, length: Any, *, factor: str = "4") -> Any:
    """Coordinate at which the contour z = z* meets a line at this length along the other axis."""
    return level_place**2 / _times(factor, length)
