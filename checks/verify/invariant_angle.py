"""Checks of section 3.1, item (G): the invariant angle between the asymptotic directions."""

from typing import Any

import sympy as sp

from checks.ball import nonzero_point
from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import asymptotic_frames as frames
from checks.printed import fundamental_forms as printed
from checks.verify.nets import ROUTES, all_nets, minus, over_nets, squared_norm
from theory.asymptotic_net import AsymptoticNet
from theory.forms import first_form, second_form, third_form, third_from_others
from theory.reparametrisation import Change, changed
from theory.surfaces import pseudosphere
from theory.vectors import cross, dot

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

    reversed_sign = over_nets(setting, all_nets(), residuals, shown="")
    found = nonzero_point(value(pseudosphere().net(1)), setting.random())
    not_zero = statement(found is not None, shown="", witness="r_u.r_v = 0 on the pseudosphere")
    return combined(
        {"flips": reversed_sign, "value": not_zero},
        shown=f"each flip reverses the sign of r_u.r_v, {ROUTES}, and r_u.r_v is not 0 at a "
        "rational point of the pseudosphere",
    )


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

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"both cosines and the sine are the same after u -> -u, v -> -v and both, {ROUTES}",
    )


def angle_cosine(setting: Setting, *, sigma_power: int = 1, swapped: bool = False) -> Evidence:
    """(eq:def_phi), first equality: cos phi = sigma r_u.r_v; swapped: sin phi on the left.

    The angle is that of Gauss-Weingarten, and on explicit surfaces that of the soliton.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        stated = printed.cosine(
            net.calculus.dot(net.r_u, net.r_v), net.sigma, sigma_power=sigma_power
        )
        return {"cos phi": (net.sin_phi if swapped else net.cos_phi) - stated}

    return over_nets(setting, all_nets(), residuals, shown=f"cos phi = sigma r_u.r_v, {ROUTES}")


def angle_cosine_of_normals(setting: Setting, *, sign: int = -1, sigma_power: int = 1) -> Evidence:
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

    return over_nets(
        setting, all_nets(), residuals, shown=f"sigma r_u.r_v = -sigma N_u.N_v, {ROUTES}"
    )


def angle_sine(setting: Setting, *, sign: int = 1, sigma_power: int = 1) -> Evidence:
    """(eq:def_phi), second line: sin phi = sigma (r_u x r_v).N, the sine of the same angle."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        stated = printed.sine(_triple(net), net.sigma, sign=sign, sigma_power=sigma_power)
        cosine = printed.cosine(net.calculus.dot(net.r_u, net.r_v), net.sigma)
        return {
            "sin phi": net.sin_phi - stated,
            "cos^2 + sin^2 - 1": cosine**2 + stated**2 - 1,
        }

    return over_nets(
        setting, all_nets(), residuals, shown=f"sin phi = sigma (r_u x r_v).N, {ROUTES}"
    )


def angle_norm(setting: Setting, *, power: int = 1) -> Evidence:
    """(eq:def_phi), third line, squared: sin^2 phi = |r_u x r_v|^2; power: of the right side."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        norm = squared_norm(net, net.calculus.cross(net.r_u, net.r_v))
        return {"sin^2 phi": net.sin_phi**2 - printed.sine_squared(norm, power=power)}

    return over_nets(setting, all_nets(), residuals, shown=f"sin^2 phi = |r_u x r_v|^2, {ROUTES}")


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
    return positivity(
        setting,
        values,
        shown="sigma (r_u x r_v).N is positive on both sides of the edge of the pseudosphere",
    )


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

    return over_nets(
        setting, all_nets(), residuals, shown=f"r_uv = N_u x N_v = -sigma sin phi N, {ROUTES}"
    )


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
    return combined(
        parts,
        shown="|r_u x r_v|^2 = sin^2 phi for unit vectors at the angle phi, and "
        "the sine vanishes in [0, pi] at 0 and pi only",
    )
