r"""Minding's bobbin: the pseudospherical surface of revolution with a throat (ex:bobbin).

It is the solution of rho_ss = rho that is even about its throat, a circle of curvature kappa. Its
principal curvatures multiply to -1; with a = kappa^2 + 1 their squares at height s are

    azimuthal a / cosh^2 s - 1,  longitudinal the reciprocal,

so that on a geodesic disk the first is largest nearest the throat, the second nearest the edge.
"""

from typing import Any

import sympy as sp

from theory.pseudospherical_revolution import PSI, Flow
from theory.surface_of_revolution import Meridian, meridian, principal_curvatures

KAPPA = sp.Symbol("kappa", positive=True)
S, THETA = sp.symbols("s theta", real=True)


def radius() -> Any:
    """Radius rho(s): the solution of rho_ss = rho with rho(0) = 1/kappa and rho_s(0) = 0."""
    start, slope = 1 / KAPPA, sp.Integer(0)
    return start * sp.cosh(S) + slope * sp.sinh(S)


def bobbin() -> Meridian:
    """Meridian of the bobbin at arc length S from the throat; real for |S| <= L."""
    return meridian(radius(), S)


def half_length() -> Any:
    """Arc length L from the throat to the singular edge, where the meridian is horizontal."""
    (sinh_edge,) = sp.solve(sp.Eq(_slope_by_sinh(), 1), sp.Symbol("y"))
    return sp.asinh(sinh_edge)


def _slope_by_sinh() -> Any:
    """Slope rho_s as an expression of y = sinh s."""
    return sp.diff(radius(), S).subs(sp.sinh(S), sp.Symbol("y"))


def squared_curvatures() -> tuple[Any, Any]:
    """Squares of the longitudinal and the azimuthal principal curvature at arc length S.

    Taken at azimuth 0: the rotations are isometries.
    """
    longitudinal, azimuthal = principal_curvatures(bobbin(), sp.Integer(0))
    return sp.factor(sp.expand(longitudinal**2)), sp.factor(sp.expand(azimuthal**2))


def largest_on_disk(kappa: Any, nearest: Any, farthest: Any) -> tuple[Any, Any]:
    """Squares of the largest longitudinal and azimuthal curvature on nearest <= |s| <= farthest.

    The first grows with |s| and the second falls, their product being 1: both are taken at an end.
    """
    longitudinal, azimuthal = squared_curvatures()
    return (
        longitudinal.subs({KAPPA: kappa, S: farthest}),
        azimuthal.subs({KAPPA: kappa, S: nearest}),
    )


def bending_density(y: Any, *, power: int = 2) -> Any:
    """Sum of a power of |curvatures| times the area element, per d theta dy, where y = sinh s."""
    at = {S: sp.asinh(y)}
    longitudinal, azimuthal = (sp.factor(square.subs(at)) for square in squared_curvatures())
    half = sp.Rational(power, 2)
    area = (radius() / sp.diff(sp.sinh(S), S)).subs(at)
    return (longitudinal**half + azimuthal**half) * area


def bobbin_flow(*, sense: int = 1) -> Flow:
    """Asymptotic lines of the bobbin; sense is the sign of d theta/du.

    From sinh s = kappa rho_s = kappa cos psi, and 1/alpha^2 = 1 + rho^2 - rho_s^2.
    """
    rho = radius().subs(S, arc_length())
    alpha = 1 / sp.sqrt(sp.together(sp.expand(1 + rho**2 - sp.cos(PSI) ** 2)))
    return Flow(alpha=alpha, rho=rho, sense=sense)


def arc_length() -> Any:
    """Signed arc length s from the throat at inclination PSI, for every psi."""
    return sp.asinh(KAPPA * sp.cos(PSI))
