"""Checks of section 3.1, items (G) to (I): the invariant angle, the forms, the Moutard equation."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import asymptotic_frames as frames
from checks.printed import fundamental_forms as printed
from checks.verify.nets import all_nets, minus, over_nets, squared_norm
from theory.asymptotic_net import AsymptoticNet
from theory.forms import first_form, second_form, third_form, third_from_others
from theory.reparametrisation import Change, changed
from theory.surfaces import pseudosphere
from theory.vectors import cross, dot

_ROUTES = (
    "derived from Gauss-Weingarten for an unknown angle and either sign of sigma, and on the "
    "pseudosphere, Dini's and Kuen's surface on both sides of their edges"
)

_FLIPS: dict[str, Change] = {
    "u": ((-1, 0), (0, 1)),
    "v": ((1, 0), (0, -1)),
    "both": ((-1, 0), (0, -1)),
    "exchange": ((0, 1), (1, 0)),
}


def _triple(net: AsymptoticNet) -> Any:
    """(r_u x r_v).N."""
    return net.calculus.dot(net.calculus.cross(net.r_u, net.r_v), net.normal)


def naive_angle(setting: Setting, *, flips: str = "u,v", sigma: bool = False) -> Evidence:
    """Item (G): each flip sends r_u.r_v to -r_u.r_v, so cos phi = r_u.r_v is not invariant.

    flips: names of the flips, with commas between; sigma: whether to multiply by sigma first.
    """

    def value(net: AsymptoticNet) -> Any:
        product = net.calculus.dot(net.r_u, net.r_v)
        return printed.cosine(product, net.sigma) if sigma else printed.naive_cosine(product)

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        return {
            f"flip {name}": value(changed(net, _FLIPS[name])) + value(net)
            for name in flips.split(",")
        }

    return over_nets(setting, all_nets(), residuals, shown="each flip reverses the sign of "
                     f"r_u.r_v, {_ROUTES}; it is not 0 there")  # fmt: skip


def invariant_angle(
    setting: Setting, *, flips: str = "u,v,both", cosine_power: int = 1, sine_power: int = 1
) -> Evidence:
    """Item (G): sigma r_u.r_v, -sigma N_u.N_v and sigma (r_u x r_v).N are invariant under flips.

    N is kept, sigma is the sign of (r_u x r_v).N for it; cosine_power, sine_power: of sigma.
    """

    def values(net: AsymptoticNet) -> tuple[Any, Any, Any]:
        product = net.calculus.dot
        normals = product(net.d(net.normal, "u"), net.d(net.normal, "v"))
        return (
            printed.cosine(product(net.r_u, net.r_v), net.sigma, sigma_power=cosine_power),
            printed.cosine_of_normals(normals, net.sigma, sigma_power=cosine_power),
            printed.sine(_triple(net), net.sigma, sigma_power=sine_power),
        )

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        before = values(net)
        return {
            f"flip {name}": minus(values(changed(net, _FLIPS[name])), before)
            for name in flips.split(",")
        }

    return over_nets(setting, all_nets(), residuals, shown="both cosines and the sine are the same "
                     f"after u -> -u, v -> -v and both, {_ROUTES}")  # fmt: skip


def angle_cosine(setting: Setting, *, sigma_power: int = 1, swapped: bool = False) -> Evidence:
    """(eq:def_phi), first equality: cos phi = sigma r_u.r_v; swapped: sin phi on the left.

    The angle is that of Gauss-Weingarten, and on explicit surfaces that of the soliton.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        stated = printed.cosine(
            net.calculus.dot(net.r_u, net.r_v), net.sigma, sigma_power=sigma_power
        )
        return {"cos phi": (net.sin_phi if swapped else net.cos_phi) - stated}

    return over_nets(setting, all_nets(), residuals,
                     shown=f"cos phi = sigma r_u.r_v, {_ROUTES}")  # fmt: skip


def angle_cosine_of_normals(
    setting: Setting, *, sign: int = -1, sigma_power: int = 1
) -> Evidence:
    """(eq:def_phi), second equality: sigma r_u.r_v = -sigma N_u.N_v.

    N_u.N_v both differentiated and as the third form 2H II - K I of the other two.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        left = printed.cosine(net.calculus.dot(net.r_u, net.r_v), net.sigma)
        first = first_form(net.calculus, net.r_u, net.r_v)
        second = second_form(net.calculus, net.r_u, net.r_v, net.normal)
        products = {
            "differentiated": third_form(net.calculus, net.normal)[1],
            "from the other forms": third_from_others(first, second)[1],
        }
        return {
            where: left
            - printed.cosine_of_normals(value, net.sigma, sign=sign, sigma_power=sigma_power)
            for where, value in products.items()
        }

    return over_nets(setting, all_nets(), residuals,
                     shown=f"sigma r_u.r_v = -sigma N_u.N_v, {_ROUTES}")  # fmt: skip


def angle_sine(setting: Setting, *, sign: int = 1, sigma_power: int = 1) -> Evidence:
    """(eq:def_phi), second line: sin phi = sigma (r_u x r_v).N, the sine of the same angle."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        stated = printed.sine(_triple(net), net.sigma, sign=sign, sigma_power=sigma_power)
        cosine = printed.cosine(net.calculus.dot(net.r_u, net.r_v), net.sigma)
        return {
            "sin phi": net.sin_phi - stated,
            "cos^2 + sin^2 - 1": cosine**2 + stated**2 - 1,
        }

    return over_nets(setting, all_nets(), residuals,
                     shown=f"sin phi = sigma (r_u x r_v).N, {_ROUTES}")  # fmt: skip


def angle_norm(setting: Setting, *, power: int = 1) -> Evidence:
    """(eq:def_phi), third line, squared: sin^2 phi = |r_u x r_v|^2; power: of the right side."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        norm = squared_norm(net, net.calculus.cross(net.r_u, net.r_v))
        return {"sin^2 phi": net.sin_phi**2 - printed.sine_squared(norm, power=power)}

    return over_nets(setting, all_nets(), residuals,
                     shown=f"sin^2 phi = |r_u x r_v|^2, {_ROUTES}")  # fmt: skip


def sine_positive(setting: Setting, *, sigma_power: int = 1) -> Evidence:
    """(eq:def_phi), third line: sigma (r_u x r_v).N >= 0, on both sides of an edge.

    On the pseudosphere with its smooth normal, e^chi = 1 + t on one side of the edge and
    1/(1 + t) on the other, t > 0; sigma_power: of sigma.
    """
    t, x = sp.Symbol("t", positive=True), sp.Symbol("exp_chi", positive=True)
    values = {}
    for side, place in ((1, 1 + t), (-1, 1 / (1 + t))):
        net = pseudosphere().net(side)
        stated = printed.sine(_triple(net), net.sigma, sigma_power=sigma_power)
        values[f"sine for sigma = {side:+d}"] = sp.cancel(stated.subs(x, place))
    return positivity(setting, values, shown="sigma (r_u x r_v).N is positive on both sides of the "
                      "edge of the pseudosphere")  # fmt: skip


def mixed_derivative(
    setting: Setting, *, sign: int = -1, sigma_power: int = 1, swapped: bool = False
) -> Evidence:
    """(eq:def_phi), fourth line: r_uv = N_u x N_v = -sigma sin phi N; swapped: cos for sin."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        angle = net.cos_phi if swapped else net.sin_phi
        stated = printed.mixed_derivative(
            angle, net.normal, net.sigma, sign=sign, sigma_power=sigma_power
        )
        n_u, n_v = net.d(net.normal, "u"), net.d(net.normal, "v")
        product = frames.mixed_derivative(n_u, n_v, net.calculus.cross)
        return {
            "r_uv": minus(net.d(net.r_u, "v"), stated),
            "r_vu": minus(net.d(net.r_v, "u"), stated),
            "N_u x N_v": minus(product, stated),
        }

    return over_nets(setting, all_nets(), residuals,
                     shown=f"r_uv = N_u x N_v = -sigma sin phi N, {_ROUTES}")  # fmt: skip


def _by_half_tangent(function: str, t: Any) -> Any:
    """Sine or cosine of phi as a rational function of t = tan(phi/2)."""
    return {"sin": 2 * t, "-sin": -2 * t, "cos": 1 - t**2}[function] / (1 + t**2)


def _signs(setting: Setting, function: str) -> Evidence:
    """Evidence that the function is positive on (0, pi), negative on (-pi, 0), 0 at 0 and pi."""
    x, t = sp.Symbol("phi", real=True), sp.Symbol("t", positive=True)
    call = {"sin": sp.sin(x), "-sin": -sp.sin(x), "cos": sp.cos(x)}[function]
    exact = {
        "by the half tangent": call - _by_half_tangent(function, sp.tan(x / 2)),
        "at 0": call.subs(x, 0),
        "at pi": call.subs(x, sp.pi),
    }
    inside = {
        "on (0, pi)": _by_half_tangent(function, t),
        "minus itself on (-pi, 0)": -_by_half_tangent(function, -t),
    }
    parts = {
        "signs": positivity(setting, inside, shown=""),
        "values": identities(setting, exact, shown=""),
    }
    return combined(parts, shown="")


def angle_range(setting: Setting, *, function: str = "sin") -> Evidence:
    """Item (G): among -pi < phi <= pi, sin phi >= 0 holds exactly for 0 <= phi <= pi.

    function: "sin", "-sin" or "cos", of which the statement is tested.
    """
    shown = "sin is positive on (0, pi), negative on (-pi, 0), 0 at 0 and pi: tan(phi/2) > 0 or < 0"
    return combined({function: _signs(setting, function)}, shown=shown)


def immersion(
    setting: Setting, *, sign: int = -1, unit: bool = True, function: str = "sin"
) -> Evidence:
    """Item (G): in [0, pi], r_u and r_v are dependent exactly where phi is 0 or pi.

    Lagrange's identity for any two vectors, |r_u x r_v|^2 = |r_u|^2 |r_v|^2 - (r_u.r_v)^2, and the
    zeros of the sine; sign: in the identity; unit: whether both speeds are 1; function: whose
    zeros are meant.
    """
    a, b = sp.symbols("a1:4", real=True), sp.symbols("b1:4", real=True)
    product = cross((a[0], a[1], a[2]), (b[0], b[1], b[2]))
    lagrange = dot(product, product) - dot(a, a) * dot(b, b) - sign * dot(a, b) ** 2
    x, length = sp.Symbol("phi", real=True), sp.Symbol("r", positive=True)
    speed = 1 if unit else length
    sine_squared = speed**2 + sign * (speed * sp.cos(x)) ** 2 - sp.sin(x) ** 2
    parts = {
        "identities": identities(
            setting, {"Lagrange": lagrange, "|r_u x r_v|^2 - sin^2 phi": sine_squared}, shown=""
        ),
        "zeros": _signs(setting, function),
    }
    return combined(parts, shown="|r_u x r_v|^2 = sin^2 phi for unit vectors at the angle phi, and "
                    "the sine vanishes in [0, pi] at 0 and pi only")  # fmt: skip


def first_fundamental_form(
    setting: Setting, *, factor: int = 2, sigma_power: int = 1, swapped: bool = False
) -> Evidence:
    """(eq:metrics), first line: g = dr.dr; swapped: sin phi in place of cos phi."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        uu, uv, vv = first_form(net.calculus, net.r_u, net.r_v)
        angle = net.sin_phi if swapped else net.cos_phi
        stated = printed.first_form(angle, net.sigma, factor=factor, sigma_power=sigma_power)
        return dict(zip(("du^2", "du dv", "dv^2"), minus((uu, 2 * uv, vv), stated), strict=True))

    return over_nets(setting, all_nets(), residuals, shown="dr.dr = du^2 + 2 sigma cos phi du dv + "
                     f"dv^2, {_ROUTES}")  # fmt: skip


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
            product(n_u, net.r_u), product(n_u, net.r_v), product(n_v, net.r_u),
            product(n_v, net.r_v), sign=differential_sign,
        )  # fmt: skip
        e, f, g = second_form(net.calculus, net.r_u, net.r_v, net.normal)
        bent = printed.second_form_definition(-e, -f, -f, -g, sign=differential_sign)
        stated = printed.second_form(
            net.sin_phi, net.sigma, factor=factor, sigma_power=sigma_power
        )
        return {
            "du^2, du dv, dv^2": minus(direct, stated),
            "du^2, du dv, dv^2 by r_uu, r_uv, r_vv": minus(bent, stated),
        }

    sign = "-" if differential_sign < 0 else ""
    return over_nets(setting, all_nets(), residuals, shown=f"{sign}dN.dr = -2 sigma sin phi du dv, "
                     f"{_ROUTES}")  # fmt: skip


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

    return over_nets(setting, all_nets(), residuals, shown="N_u = N x r_u and N_v = -N x r_v lie in "
                     f"the tangent plane, {_ROUTES}")  # fmt: skip


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

    return over_nets(setting, all_nets(), residuals, shown="N_u and N_v are r_u and r_v turned by "
                     f"pi/2 and -pi/2 about N, {_ROUTES}")  # fmt: skip


_EQUALITIES = (
    "N_v x r_u",
    "-(N x r_v) x r_u",
    "N (r_u.r_v) - r_v (r_u.N)",
    "sigma cos phi N",
    "-(N_u.N_v) N",
)


def moutard(
    setting: Setting, *, first: int = 1, second: int = -1, third: int = -1, fourth: int = 1,
    fifth: int = -1, swapped: bool = False,
) -> Evidence:  # fmt: skip
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
            net.r_u, net.r_v, net.normal, n_v, products, net.sigma, net.calculus.cross,
            first=first, second=second, third=third, fourth=fourth, fifth=fifth, swapped=swapped,
        )  # fmt: skip
        left = net.d(net.normal, "u", "v")
        found = {f"N_uv - {name}": minus(left, right)
                 for name, right in zip(_EQUALITIES, chain, strict=True)}  # fmt: skip
        found["N_vu - N_uv"] = minus(net.d(net.normal, "v", "u"), left)
        return found

    on_surfaces = over_nets(setting, all_nets(), residuals, shown="")
    parts = {"surfaces": on_surfaces, "any vectors": _double_product(setting, second, third)}
    return combined(parts, shown=f"all five right sides equal N_uv, {_ROUTES}")


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
    )  # fmt: skip
    return identities(setting, {"expansion": minus(chain[1], chain[2])}, shown="")

