"""Identities of stars: dual vectors, the coordinates that they give, asymptotic coordinates."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import m_stars as printed
from checks.verify.m_stars import ALPHA, ETA, RAY, XI, angle, components, gap, ray
from theory.vectors import cross, dot


def dual_vectors(setting: Setting, *, sense: int = 1, of: int = 0) -> Evidence:
    """Dual vectors: of unit length, normal to s_j and a quarter turn ahead of it."""
    s, star = ray(RAY), printed.dual(ray(RAY + of), sense=sense)
    return identities(
        setting,
        {
            "s* . s": dot(star, s),
            "|s*|^2 - 1": dot(star, star) - 1,
            "s x s* - e_3": gap(cross(s, star), (0, 0, 1)),
            "s* . e_3": star[2],
        },
        shown="s* = e_3 x s is the unit vector of the plane a quarter turn ahead of s",
    )


def dual_product(setting: Setting, *, sign: int = 1) -> Evidence:
    """Product s*_(i+1) . s_i by components against the printed sine."""
    stated = printed.dual_product_value(angle(RAY), angle(RAY + 1), sign=sign)
    return identities(
        setting,
        {"product - stated": printed.dual_product(ray, RAY) - stated},
        shown="s*_(i+1) . s_i = -sin(beta_(i+1) - beta_i)",
    )


def dual_product_angle(setting: Setting, *, shift: int = 0, half: bool = False) -> Evidence:
    """Sine of beta_(i+1) - beta_i against sin(alpha_(i+shift))."""
    stated = ALPHA[RAY + shift] / 2 if half else ALPHA[RAY + shift]
    return identities(
        setting,
        {"sine": sp.sin(angle(RAY + 1) - angle(RAY)) - sp.sin(stated)},
        shown="beta_(i+1) - beta_i = alpha_(i+1) by the recursion for beta",
    )


def dual_product_sign(setting: Setting, *, sign: int = 1, nonzero_angle: bool = True) -> Evidence:
    """Sign of s*_(i+1) . s_i for alpha_(i+1) in (0, pi), with tan(alpha/2) = t > 0.

    nonzero_angle: whether 0 is excluded.
    """
    t = sp.Symbol("t", positive=True)
    place = {ALPHA[RAY + 1]: 2 * sp.atan(t) if nonzero_angle else sp.Integer(0)}
    value = sign * sp.expand_trig(sp.trigsimp(printed.dual_product(ray, RAY)).subs(place))
    return positivity(
        setting,
        {f"{sign} times s*_(i+1) . s_i": sp.simplify(value)},
        shown="s*_(i+1) . s_i = -2t/(1 + t^2) with t = tan(alpha_(i+1)/2): negative, so that the "
        "quotient is defined",
    )


def dual_coordinates(
    setting: Setting, *, shift: int = 0, sign: int = -1, exchanged: bool = False
) -> Evidence:
    """Display for (xi_i, eta_i) on the sector S_(i+shift), shift 0 as printed."""
    if shift:
        x = printed.pair_point(ray, RAY, XI, ETA, positive=True)
        wanted = (XI, ETA)
    else:
        x = printed.pair_point(ray, RAY, XI, -ETA, positive=False)
        wanted = (XI, -ETA)
    stated = printed.dual_coordinates(ray, RAY, x, sign=sign, exchanged=exchanged)
    return identities(
        setting,
        {"xi": stated[0] - wanted[0], "eta": stated[1] - wanted[1]},
        where=(sp.pi - ALPHA[1], sp.pi - ALPHA[2]),
        shown="the display gives the coefficients of s_i and s_(i+1), which are (xi_i, eta_i) on "
        "S_(i+1), where eta_i >= 0",
    )


def closure(setting: Setting, *, shift: int = 0, constant: int = 1, norm: bool = True) -> Evidence:
    """The display on a closed sector: right there, linear, gradients of length 1/sin(alpha_(i+1)).

    shift: sector S_(i+shift); norm: whether the length is checked; constant: over the sine.
    """
    extends = dual_coordinates(setting, shift=shift)
    x, y = sp.symbols("x y", real=True)
    stated = printed.dual_coordinates(ray, RAY, (x, y, sp.Integer(0)))
    squares = [
        sp.diff(f, x) ** 2 + sp.diff(f, y) ** 2 - constant / sp.sin(ALPHA[RAY + 1]) ** 2
        for f in stated
    ]
    second = [sp.diff(f, a, b) for f in stated for a in (x, y) for b in (x, y)]
    linear = identities(
        setting, {"second derivatives": second, "squared gradients": squares}, shown="linear"
    )
    return combined(
        {"extends the coordinates": extends, "linear": linear},
        shown="on the closure of S_(i+1) the display is linear in x, with gradients of length "
        "1/sin(alpha_(i+1)): its Lipschitz constant",
    )


def origin(setting: Setting, *, offset: int = 0) -> Evidence:
    """(xi, eta) = (0, 0) exactly at the origin, on both sides; offset: of eta at the origin."""
    xi, eta = sp.symbols("xi eta", real=True)
    residuals: dict[str, Any] = {}
    positive: dict[str, Any] = {}
    for side, i in ((True, RAY + 1), (False, RAY)):
        x = printed.pair_point(ray, RAY, xi, eta, positive=side)
        at = [e.subs({xi: 0, eta: offset}) for e in x]
        residuals[f"x at the origin of the coordinates, eta >= 0 is {side}"] = at
        area = xi * sp.sin(ALPHA[i])
        residuals[f"xi from x, {side}"] = (
            cross(x, ray(RAY + 1 if side else RAY - 1))[2] * (1 if side else -1) - area
        )
        residuals[f"eta from x, {side}"] = cross(ray(RAY), x)[2] - eta * sp.sin(ALPHA[i])
    t = sp.Symbol("t", positive=True)
    positive["sine of an angle in (0, pi)"] = sp.expand_trig(sp.sin(2 * sp.atan(t)))
    return combined(
        {
            "origin": identities(setting, residuals, shown="both ways"),
            "sine": positivity(setting, positive, shown="nonzero"),
        },
        shown="x = 0 at (0, 0), and conversely xi sin(alpha) and eta sin(alpha) are cross products "
        "of x with rays: they vanish with x",
    )


def sector_coordinates(setting: Setting, *, second: str = "eta", even: int = 0) -> Evidence:
    """(eq:sector-coords) on S_i against the coefficients of x along the even and the odd ray.

    second: eta_i as printed, or xi_(i-1); even: parity that is called even.
    """
    c, d = sp.symbols("c d", positive=True)
    residuals: dict[str, Any] = {}
    for i in (1, 2):
        x = printed.sector_point(ray, i, c, d)
        height, xi = components(x, ray(i - 1), ray(i))
        xi_before, _ = components(x, ray(i - 1), ray(i))
        stated = printed.sector_coordinates(i, xi, -height, xi_before, second=second, even=even)
        wanted = (d, c) if i % 2 == 0 else (c, d)
        residuals[f"u, i = {i}"] = stated[0] - wanted[0]
        residuals[f"v, i = {i}"] = stated[1] - wanted[1]
    return identities(
        setting,
        residuals,
        shown="on S_i the coefficient of x along the ray of even index is u_i >= 0, along that of "
        "odd index v_i >= 0, as the ranges of the next sentence and the directions (e_u, e_v) of "
        "the boundary data ask",
    )
