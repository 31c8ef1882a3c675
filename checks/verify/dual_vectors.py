"""Identities of stars: dual vectors, the coordinates that they give, asymptotic coordinates.

From line 480 to (eq:sector-coords) the paper calls S_i the sector between s_i and s_(i+1), to which
(def:sectors) gives the number i + 1. ahead: what is added to an index of those lines for the number
in (def:sectors); 1 is the reading in which they are right, 0 takes the numbers as they stand.
"""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import m_stars as printed
from checks.verify.m_stars import ALPHA, ETA, RAY, XI, angle, gap, ray
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


def dual_product_angle(setting: Setting, *, ahead: int = 1, half: bool = False) -> Evidence:
    """Sine of beta_(i+1) - beta_i against that of alpha_i, the angle of the sector called S_i."""
    stated = ALPHA[RAY + ahead] / 2 if half else ALPHA[RAY + ahead]
    return identities(
        setting,
        {"sine": sp.sin(angle(RAY + 1) - angle(RAY)) - sp.sin(stated)},
        shown="beta_(i+1) - beta_i is the angle of the sector between s_i and s_(i+1)",
    )


def dual_product_sign(setting: Setting, *, beyond: int = 0, nonzero_angle: bool = True) -> Evidence:
    """Sign of the sine of an angle 2 atan(t) in (0, pi), t > 0, and the square of the product.

    beyond: right angles added to the angle; nonzero_angle: whether 0 is excluded.
    """
    t = sp.Symbol("t", positive=True)
    turn = (2 * sp.atan(t) if nonzero_angle else sp.Integer(0)) + beyond * sp.pi / 2
    squared = printed.dual_product(ray, RAY) ** 2 - sp.sin(ALPHA[RAY + 1]) ** 2
    return combined(
        {
            "sine": positivity(
                setting, {"sine of the angle": sp.expand_trig(sp.sin(turn))}, shown="positive"
            ),
            "square of the product": identities(setting, {"square": squared}, shown="square"),
        },
        shown="the sine of an angle in (0, pi) is 2t/(1 + t^2) > 0 with t = tan(angle/2), and "
        "(s*_(i+1).s_i)^2 is its square: the product is not 0 and the quotient is defined",
    )


def dual_coordinates(
    setting: Setting, *, ahead: int = 1, sign: int = -1, exchanged: bool = False
) -> Evidence:
    """Display for (xi_i, eta_i) on the sector called S_i, where eta_i >= 0 if ahead is 1."""
    if ahead:
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
        "the sector between these rays, where eta_i >= 0",
    )


def closure(setting: Setting, *, ahead: int = 1, constant: int = 1) -> Evidence:
    """The display on a closed sector: right there, linear, gradients of length 1/sin of its angle.

    constant: over the squared sine.
    """
    extends = dual_coordinates(setting, ahead=ahead)
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
        shown="on the closed sector between s_i and s_(i+1) the display is linear in x, with "
        "gradients of length 1/sin of its angle: its Lipschitz constant",
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


def sector_coordinates(setting: Setting, *, ahead: int = 1, even: int = 0) -> Evidence:
    """(eq:sector-coords) against the coefficients of x along the even and the odd ray.

    even: parity that is called even.
    """
    c, d = sp.symbols("c d", positive=True)
    residuals: dict[str, Any] = {}
    for i in (1, 2):
        x = printed.sector_point(ray, i + ahead, c, d)
        xi, eta = (c, d) if ahead else (d, -c)
        residuals[f"coordinates of the pair, i = {i}"] = gap(
            x, printed.pair_point(ray, i, xi, eta, positive=bool(ahead))
        )
        stated = printed.sector_coordinates(i, xi, eta, even=even)
        wanted = (d, c) if (i + ahead) % 2 == 0 else (c, d)
        residuals[f"u, i = {i}"] = stated[0] - wanted[0]
        residuals[f"v, i = {i}"] = stated[1] - wanted[1]
    return identities(
        setting,
        residuals,
        shown="on the sector between s_i and s_(i+1) the coefficient of x along the ray of even "
        "index is u_i >= 0, along that of odd index v_i >= 0, as the ranges of the next sentence "
        "and the directions (e_u, e_v) of the boundary data ask",
    )
