"""Checks of section 3.1, item (D): when the Lelieuvre equations can be integrated."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.printed import asymptotic_frames as printed
from checks.verify.nets import ROUTES, all_nets, minus, over_nets
from theory.asymptotic_net import AsymptoticNet
from theory.one_form import primitive_defect, radial_integral
from theory.vectors import Vector, added, cross, derivative, scaled


def _symbols() -> tuple[sp.Symbol, sp.Symbol]:
    u, v = sp.symbols("u v", real=True)
    return u, v


def _any_normal() -> Vector:
    """Any vector field N(u, v) in R^3, of unit length or not."""
    u, v = _symbols()
    first, second, third = (sp.Function(f"n{i}", real=True)(u, v) for i in (1, 2, 3))
    return (first, second, third)


def _polynomial_normal() -> Vector:
    """Vector field a + b u + c v + d u v with any coefficients; N x N_uv is any multiple of it."""
    u, v = _symbols()

    def entry(i: int) -> Any:
        a, b, c, d = sp.symbols(f"a{i} b{i} c{i} d{i}", real=True)
        return a + b * u + c * v + d * u * v

    return (entry(1), entry(2), entry(3))


def _tangents(normal: Vector, *, sign_v: int = -1) -> tuple[Vector, Vector]:
    """Right sides of the two Lelieuvre equations for a normal field."""
    u, v = _symbols()
    return (
        printed.lelieuvre_u(derivative(normal, u), normal, cross),
        printed.lelieuvre_v(derivative(normal, v), normal, cross, sign=sign_v),
    )


def integrability(setting: Setting, *, relation: int = 1) -> Evidence:
    """Item (D): r with r_u = p, r_v = q exists if and only if p_v = q_u.

    p and q are the right sides of (eq:lelieuvre) for polynomial N. If r exists, r_uv = r_vu; if
    p_v = q_u, the integral of p du + q dv along segments from the origin has defects r_u - p and
    r_v - q proportional to integrals of p_v - q_u. relation: the factor k in p_v = k q_u.
    """
    u, v = _symbols()
    p, q = _tangents(_polynomial_normal())
    gap = added(derivative(p, v), scaled(-relation, derivative(q, u)))
    mean = radial_integral(gap, u, v, weight=1)
    defect_u, defect_v = primitive_defect(p, q, u, v)
    residuals = {
        "r_u - p": added(defect_u, scaled(v, mean)),
        "r_v - q": minus(defect_v, scaled(u, mean)),
    }
    return identities(
        setting,
        residuals,
        shown="r_u - p and r_v - q are -v and u times a mean of "
        "p_v - q_u, for every N of bidegree 1: no gap, a solution",
    )


def lorentz_harmonic(setting: Setting, *, by: str = "v", sign_v: int = -1) -> Evidence:
    """(eq:lorentz_harmonic): p_v - q_u is -2 N x N_uv for every field N, so both vanish together.

    by: the second coordinate in N_uv; sign_v: the sign of the second Lelieuvre equation.
    """
    u, v = _symbols()
    normal = _any_normal()
    p, q = _tangents(normal, sign_v=sign_v)
    gap = minus(derivative(p, v), derivative(q, u))
    twice = derivative(derivative(normal, u), {"u": u, "v": v}[by])
    stated = printed.lorentz_harmonic(normal, twice, cross)
    return identities(
        setting,
        {"gap": added(gap, scaled(2, stated))},
        shown="the gap of the Lelieuvre equations is -2 N x N_uv for every twice differentiable N",
    )


def lorentz_harmonic_on_surfaces(setting: Setting, *, by: str = "v") -> Evidence:
    """(eq:lorentz_harmonic) on pseudospherical surfaces; by: the second coordinate in N_uv."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        twice = net.d(net.normal, "u", by)
        return {"N x N_uv": printed.lorentz_harmonic(net.normal, twice, net.calculus.cross)}

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"the normal is Lorentz harmonic, {ROUTES}",
    )


def mixed_derivative(setting: Setting, *, sign: int = 1) -> Evidence:
    """Item (D): r_uv = N_u x N_v, from the Lelieuvre equations and (eq:lorentz_harmonic).

    For every field N, the two derivatives minus N_u x N_v are -N x N_uv and N x N_uv.
    """
    u, v = _symbols()
    normal = _any_normal()
    p, q = _tangents(normal)
    n_u, n_v = derivative(normal, u), derivative(normal, v)
    stated = printed.mixed_derivative(n_u, n_v, cross, sign=sign)
    harmonic = printed.lorentz_harmonic(normal, derivative(n_u, v), cross)
    residuals = {
        "r_uv": added(minus(derivative(p, v), stated), harmonic),
        "r_vu": minus(minus(derivative(q, u), stated), harmonic),
    }
    return identities(
        setting,
        residuals,
        shown="r_uv = N_u x N_v and r_vu = N_u x N_v wherever "
        "N x N_uv = 0, for every twice differentiable N",
    )


def mixed_derivative_on_surfaces(setting: Setting, *, sign: int = 1) -> Evidence:
    """Item (D): r_uv = N_u x N_v on pseudospherical surfaces, differentiated directly."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        n_u, n_v = net.d(net.normal, "u"), net.d(net.normal, "v")
        stated = printed.mixed_derivative(n_u, n_v, net.calculus.cross, sign=sign)
        return {
            "r_uv": minus(net.d(net.r_u, "v"), stated),
            "r_vu": minus(net.d(net.r_v, "u"), stated),
        }

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"r_uv = N_u x N_v, {ROUTES}",
    )
