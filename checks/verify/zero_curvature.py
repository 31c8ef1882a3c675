"""Checks of section 3.1, item (J): the zero-curvature condition and the sine-Gordon equation."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import asymptotic_frames as frames
from checks.printed import fundamental_forms as printed
from checks.verify.nets import (
    ROUTES,
    all_nets,
    explicit_nets,
    general_nets,
    minus,
    over_nets,
    system_defects,
)
from theory.asymptotic_net import AsymptoticNet
from theory.forms import brioschi, first_form
from theory.frames import connection, u_frame, v_frame
from theory.sine_gordon import corner_difference, generic_matrix, mixed_gap, soliton_angle
from theory.surfaces import pseudosphere
from theory.vectors import added, scaled


def cross_derivative_u(
    setting: Setting,
    *,
    upper_sine: int = -1,
    upper_cosine: int = 1,
    lower_sine: int = 1,
    lower_cosine: int = -1,
    sigma_power: int = 1,
) -> Evidence:
    """Display of item (J): the v-derivative of (r_u, N x r_u, N), row by row."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        frame = frames.frame(net.r_u, net.normal, net.calculus.cross)
        matrix = printed.cross_derivative_u(
            net.cos_phi,
            net.sin_phi,
            net.sigma,
            upper_sine=upper_sine,
            upper_cosine=upper_cosine,
            lower_sine=lower_sine,
            lower_cosine=lower_cosine,
            sigma_power=sigma_power,
        )
        return system_defects([net.d(a, "v") for a in frame], matrix, frame)

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"the v-derivative of the frame of the u-lines is as displayed, {ROUTES}",
    )


def cross_derivative_v(
    setting: Setting, *, upper_sine: int = -1, upper_cosine: int = -1, sigma_power: int = 1
) -> Evidence:
    """Analogue of the display of item (J): the u-derivative of (r_v, N x r_v, N).

    Both cosines have the other sign than in the display; the rest is the same.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        frame = frames.frame(net.r_v, net.normal, net.calculus.cross)
        matrix = printed.cross_derivative_u(
            net.cos_phi,
            net.sin_phi,
            net.sigma,
            upper_sine=upper_sine,
            upper_cosine=upper_cosine,
            lower_sine=-upper_sine,
            lower_cosine=-upper_cosine,
            sigma_power=sigma_power,
        )
        return system_defects([net.d(a, "u") for a in frame], matrix, frame)

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"the u-derivative of the frame of the v-lines has the opposite cosines, {ROUTES}",
    )


def zero_curvature(setting: Setting, *, derivative: int = -1, commutator: int = 1) -> Evidence:
    """Item (J): F_uv = F_vu is equivalent to A_v - B_u + [A, B] = 0.

    For any matrices A, B and F of functions, the gap of the mixed derivatives is the left side
    times F, and a frame F is invertible; derivative, commutator: the printed signs.
    """
    u, v = sp.symbols("u v", real=True)
    a, b, frame = (generic_matrix(name, u, v) for name in ("a", "b", "f"))
    stated = printed.zero_curvature(
        a, b, a.diff(v), b.diff(u), derivative=derivative, commutator=commutator
    )
    gap = mixed_gap(a, b, frame, u, v) - stated * frame
    return identities(
        setting,
        {"gap - Z F": gap.applyfunc(sp.expand)},
        shown="the gap of the mixed derivatives of F is (A_v - B_u + [A, B]) F for any A, B, F",
    )


def _compatibility(net: AsymptoticNet, along: str) -> tuple[sp.Matrix, sp.Expr]:
    """Zero-curvature matrix of the frame of the "u"- or "v"-lines with unknown kappa, and kappa."""
    u, v = sp.symbols("u v", real=True)
    kappa = sp.Function("kappa", real=True)(u, v)
    own, other, system, frame = {
        "u": (u, v, frames.frenet_u, u_frame(net)),
        "v": (v, u, frames.frenet_v, v_frame(net)),
    }[along]
    a = sp.Matrix(system(kappa))
    b = connection(net, frame, "v" if along == "u" else "u")
    return printed.zero_curvature(a, b, a.diff(other), b.diff(own)), kappa


def _curvature_conditions(net: AsymptoticNet, along: str, stated: Any) -> dict[str, Any]:
    """Z = 0 forces kappa to be as stated, and this makes all of Z vanish but the (1, 2) entry."""
    z, kappa = _compatibility(net, along)
    turn = 1 if along == "u" else -1
    forced = net.cos_phi * z[0, 2] + turn * net.sin_phi * z[1, 2]
    settled = z.subs(kappa, stated).doit()
    rest = [settled[i, j] for i in range(3) for j in range(3) if {i, j} != {0, 1}]
    return {
        f"{along}-frame: Z forces kappa": forced - turn * net.sigma * (kappa - stated),
        f"{along}-frame: other entries": rest,
        f"{along}-frame: antisymmetry": settled[0, 1] + settled[1, 0],
    }


def curvatures(setting: Setting, *, sign_u: int = -1, sign_v: int = 1) -> Evidence:
    """(eq:sg), first line: kappa^u = -phi_u and kappa^v = phi_v.

    From the zero-curvature conditions of both frames with an unknown kappa, in both directions,
    and from the geodesic curvatures of Gauss-Weingarten and of explicit surfaces.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        stated_u = printed.curvature_u(net.angle_rate("u"), sign=sign_u)
        stated_v = printed.curvature_v(net.angle_rate("v"), sign=sign_v)
        found = {
            "kappa^u": net.geodesic_curvature("u") - stated_u,
            "kappa^v": net.geodesic_curvature("v") - stated_v,
        }
        if net.cos_phi.has(sp.core.function.AppliedUndef):
            found |= _curvature_conditions(net, "u", stated_u)
            found |= _curvature_conditions(net, "v", stated_v)
        return found

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown="the zero-curvature conditions of the "
        "two frames force kappa^u = -phi_u and kappa^v = phi_v, and conversely these "
        "leave one entry of each; they are the geodesic curvatures, "
        f"{ROUTES}",
    )


def sine_gordon(
    setting: Setting, *, sign: int = 1, sigma_power: int = 1, swapped: bool = False
) -> Evidence:
    """(eq:sg), second line, from three sources: zero curvature, Gauss-Weingarten, the metric.

    For an unknown angle each of them is (phi_uv - right side) times a factor without zeros; the
    integers are those of the right side, swapped: cos phi in place of sin phi.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        rate = net.calculus.rate
        phi_u, phi_v = net.angle_rate("u"), net.angle_rate("v")
        right = printed.sine_gordon(
            net.sin_phi, net.cos_phi, net.sigma, sign=sign, sigma_power=sigma_power, swapped=swapped
        )
        gap = rate(phi_u, "v") - right
        found = {}
        for along, stated in (
            ("u", printed.curvature_u(phi_u)),
            ("v", printed.curvature_v(phi_v)),
        ):
            z, kappa = _compatibility(net, along)
            entry = z[0, 1].subs(kappa, stated).doit()
            found[f"zero curvature of the {along}-frame"] = entry + (gap if along == "u" else -gap)
        commuted = minus(net.d(net.r_u, "u", "v"), net.d(net.r_u, "v", "u"))
        turned = net.calculus.cross(net.normal, net.r_u)
        found["r_uuv - r_uvu"] = added(commuted, scaled(gap, turned))
        metric = first_form(net.calculus, net.r_u, net.r_v)
        found["K + 1"] = (brioschi(metric, rate) + 1) * net.sin_phi + net.sigma * gap
        return found

    return over_nets(
        setting,
        general_nets(),
        residuals,
        shown="the remaining condition of each "
        "frame, the gap r_uuv - r_uvu and the Gauss curvature of the metric plus 1 "
        "are multiples of phi_uv - sigma sin phi, so each vanishes exactly with "
        "it",
    )


def sine_gordon_on_surfaces(
    setting: Setting,
    *,
    sign_u: int = -1,
    sign_v: int = 1,
    sign: int = 1,
    sigma_power: int = 1,
    swapped: bool = False,
) -> Evidence:
    """(eq:sg), second line, each equality on explicit surfaces, and K = -1 from their metrics."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        rate = net.calculus.rate
        right = printed.sine_gordon(
            net.sin_phi, net.cos_phi, net.sigma, sign=sign, sigma_power=sigma_power, swapped=swapped
        )
        metric = first_form(net.calculus, net.r_u, net.r_v)
        return {
            "-kappa^u_v": sign_u * rate(net.geodesic_curvature("u"), "v") - right,
            "kappa^v_u": sign_v * rate(net.geodesic_curvature("v"), "u") - right,
            "phi_uv": rate(net.angle_rate("u"), "v") - right,
            "phi_vu": rate(net.angle_rate("v"), "u") - right,
            "K + 1": net.calculus.reduced(brioschi(metric, rate)) + 1,
        }

    return over_nets(
        setting,
        explicit_nets(),
        residuals,
        shown="-kappa^u_v = kappa^v_u = phi_uv = "
        "sigma sin phi and K = -1 on the pseudosphere and Dini's surface (both sides of "
        "their edges) and Kuen's",
    )


def constant_sigma(setting: Setting, *, first: int = 1) -> Evidence:
    """Item (J): (eq:sg) needs a constant sigma; integrated over rectangles of the pseudosphere.

    The corner difference of phi minus the integral of sigma sin phi over first <= u <= 4,
    1 <= v <= 3 and over the rectangle opposite to it; sigma changes sign across u + v = 0, which
    the rectangles meet where first < -1. With first = -2 it cuts off one corner, and the two
    differ by -pi and pi.
    """
    front = pseudosphere()
    chi, x = front.chi, sp.Symbol("exp_chi", positive=True)
    primitive = soliton_angle(front, 1)
    residuals: dict[str, Any] = {}
    for side in (1, -1):
        net, angle = front.net(side), soliton_angle(front, side)
        for name, call, field in (("cos", sp.cos, net.cos_phi), ("sin", sp.sin, net.sin_phi)):
            expanded = sp.expand_trig(call(angle))
            residuals[f"{name} phi, sigma = {side:+d}"] = expanded - field.subs(x, sp.exp(chi))
        source = net.sigma * net.sin_phi.subs(x, sp.exp(chi))
        residuals[f"integrand, sigma = {side:+d}"] = primitive.diff(chi, 2) - source

    def invariant(place: Any) -> Any:
        return soliton_angle(front, 1 if place > 0 else -1)

    parts = {"fields": identities(setting, residuals, shown="")}
    defects = {}
    expected = (
        ("constant sigma", (first, 4, 1, 3), sp.Integer(0)),
        ("constant sigma", (-4, -first, -3, -1), sp.Integer(0)),
        ("corner cut off", (-2, 4, 1, 3), -sp.pi),
        ("corner cut off", (-4, 2, -3, -1), sp.pi),
    )
    for kind, rectangle, defect in expected:
        corners = corner_difference(invariant, rectangle, chi)
        integral = corner_difference(lambda _: primitive, rectangle, chi)
        defects[f"{kind}, u0, u1, v0, v1 = {rectangle}"] = corners - integral - defect
    parts["rectangles"] = identities(setting, defects, shown="")
    return combined(
        parts,
        shown="the corner difference of phi equals the integral of sigma sin phi "
        "on rectangles on which sigma is constant, on either side of the edge of the "
        "pseudosphere; across the edge, which cuts off a corner, they differ by pi",
    )
