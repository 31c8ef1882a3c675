"""Checks of section 3.1, items (H) and (I): the fundamental forms, the Moutard equation."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import asymptotic_frames as frames
from checks.printed import fundamental_forms as printed
from checks.verify.nets import ROUTES, all_nets, minus, over_nets
from theory.asymptotic_net import AsymptoticNet
from theory.forms import first_form, second_form
from theory.vectors import cross, dot


def first_fundamental_form(
    setting: Setting, *, factor: int = 2, sigma_power: int = 1, swapped: bool = False
) -> Evidence:
    """(eq:metrics), first line: g = dr.dr; swapped: sin phi in place of cos phi."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        uu, uv, vv = first_form(net.calculus, net.r_u, net.r_v)
        angle = net.sin_phi if swapped else net.cos_phi
        stated = printed.first_form(angle, net.sigma, factor=factor, sigma_power=sigma_power)
        return dict(zip(("du^2", "du dv", "dv^2"), minus((uu, 2 * uv, vv), stated), strict=True))

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"dr.dr = du^2 + 2 sigma cos phi du dv + dv^2, {ROUTES}",
    )


def second_fundamental_form(
    setting: Setting, *, differential_sign: int = 1, factor: int = -2, sigma_power: int = 1
) -> Evidence:
    """(eq:metrics), second line: h = dN.dr, or -dN.dr where differential_sign is -1.

    dN.dr differentiated, and as -N.d^2 r from the second derivatives of r.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        product = net.calculus.dot
        n_u, n_v = net.d(net.normal, "u"), net.d(net.normal, "v")
        direct = printed.second_form_definition(
            product(n_u, net.r_u),
            product(n_u, net.r_v),
            product(n_v, net.r_u),
            product(n_v, net.r_v),
            sign=differential_sign,
        )
        e, f, g = second_form(net.calculus, net.r_u, net.r_v, net.normal)
        bent = printed.second_form_definition(-e, -f, -f, -g, sign=differential_sign)
        stated = printed.second_form(net.sin_phi, net.sigma, factor=factor, sigma_power=sigma_power)
        return {
            "du^2, du dv, dv^2": minus(direct, stated),
            "du^2, du dv, dv^2 by r_uu, r_uv, r_vv": minus(bent, stated),
        }

    sign = "-" if differential_sign < 0 else ""
    return over_nets(
        setting, all_nets(), residuals, shown=f"{sign}dN.dr = -2 sigma sin phi du dv, {ROUTES}"
    )


def tangential(setting: Setting, *, sign_u: int = 1, sign_v: int = -1) -> Evidence:
    """Item (I): N_u = N x r_u, N_v = -N x r_v, perpendicular to N, in the span of r_u and r_v."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        found: dict[str, Any] = {}
        times, product = net.calculus.cross, net.calculus.dot
        whole = times(net.r_u, net.r_v)
        for along, tangent, sign in (("u", net.r_u, sign_u), ("v", net.r_v, sign_v)):
            turned = net.d(net.normal, along)
            stated = frames.normal_along_u(tangent, net.normal, times, sign=sign)
            found[f"N_{along}"] = minus(turned, stated)
            found[f"N.N_{along}"] = product(net.normal, turned)
            found[f"det(r_u, r_v, N_{along})"] = product(whole, turned)
        return found

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"N_u = N x r_u and N_v = -N x r_v lie in the tangent plane, {ROUTES}",
    )


def rotations(setting: Setting, *, quarters_u: int = 1, quarters_v: int = -1) -> Evidence:
    """Item (I): N_u is r_u turned by pi/2 about N and N_v is r_v turned by -pi/2.

    quarters_u, quarters_v: the angles in units of pi/2.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        found = {}
        for along, tangent, quarters in (("u", net.r_u, quarters_u), ("v", net.r_v, quarters_v)):
            stated = printed.turned(net.normal, tangent, net.calculus.cross, quarters=quarters)
            found[f"N_{along}"] = minus(net.d(net.normal, along), stated)
        return found

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"N_u and N_v are r_u and r_v turned by pi/2 and -pi/2 about N, {ROUTES}",
    )


_EQUALITIES = (
    "N_v x r_u",
    "-(N x r_v) x r_u",
    "N (r_u.r_v) - r_v (r_u.N)",
    "sigma cos phi N",
    "-(N_u.N_v) N",
)


def moutard(
    setting: Setting,
    *,
    first: int = 1,
    second: int = -1,
    third: int = -1,
    fourth: int = 1,
    fifth: int = -1,
    swapped: bool = False,
) -> Evidence:
    """(eq:moutard), each of its five equalities; the integers are the printed signs.

    The third sign stands before a term that vanishes, so its identity is tested for any vectors
    too, where r_u.N is not 0.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        product = net.calculus.dot
        n_u, n_v = net.d(net.normal, "u"), net.d(net.normal, "v")
        products = {
            "r_u.r_v": product(net.r_u, net.r_v),
            "r_u.N": product(net.r_u, net.normal),
            "N_u.N_v": product(n_u, n_v),
            "cos phi": net.cos_phi,
            "sin phi": net.sin_phi,
        }
        chain = printed.moutard_chain(
            net.r_u,
            net.r_v,
            net.normal,
            n_v,
            products,
            net.sigma,
            net.calculus.cross,
            first=first,
            second=second,
            third=third,
            fourth=fourth,
            fifth=fifth,
            swapped=swapped,
        )
        left = net.d(net.normal, "u", "v")
        found = {
            f"N_uv - {name}": minus(left, right)
            for name, right in zip(_EQUALITIES, chain, strict=True)
        }
        found["N_vu - N_uv"] = minus(net.d(net.normal, "v", "u"), left)
        return found

    on_surfaces = over_nets(setting, all_nets(), residuals, shown="")
    parts = {"surfaces": on_surfaces, "any vectors": _double_product(setting, second, third)}
    return combined(parts, shown=f"all five right sides equal N_uv, {ROUTES}")


def _double_product(setting: Setting, second: int, third: int) -> Evidence:
    """Third equality of (eq:moutard) for any three vectors: -(N x r_v) x r_u expanded."""
    vectors = [sp.symbols(f"{name}1:4", real=True) for name in ("p", "q", "n")]
    r_u, r_v, normal = ((a[0], a[1], a[2]) for a in vectors)
    products = {
        "r_u.r_v": dot(r_u, r_v),
        "r_u.N": dot(r_u, normal),
        "N_u.N_v": sp.Integer(0),
        "cos phi": sp.Integer(0),
        "sin phi": sp.Integer(0),
    }
    chain = printed.moutard_chain(
        r_u, r_v, normal, r_v, products, 1, cross, second=second, third=third
    )
    return identities(setting, {"expansion": minus(chain[1], chain[2])}, shown="")
