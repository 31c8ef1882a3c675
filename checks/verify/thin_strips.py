"""Checks of thin rectangles about the rays of a branch point, and of phi on small sectors."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.printed import branched_sine_gordon as printed
from checks.verify.nets import general_nets, over_nets
from checks.verify.star_fields import over_fields
from theory import amsler
from theory.asymptotic_net import AsymptoticNet
from theory.forms import coordinate_line_curvatures
from theory.star_field import StarField

EPSILON = sp.Symbol("epsilon", positive=True)


NEAR, FAR = sp.symbols("a b", positive=True)


def _strip_angles(field: StarField, ray: int) -> tuple[Any, Any, Any, Any]:
    """Angles at r+, r-, q-, q+ of the strip about a ray."""
    q_minus, r_minus, r_plus, q_plus = field.strip(ray, (NEAR, FAR), EPSILON)
    return (
        field.angle(r_plus),
        field.angle(r_minus),
        field.angle(q_minus),
        field.angle(q_plus),
    )


def strip_formula(setting: Setting, *, sign: int = 1, rays: str = "u") -> Evidence:
    """Formula for the thin rectangle against the sum with the signs of (eq:sg-hamburger).

    rays: family of the curve that the rectangle straddles.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        return {
            f"ray {k}": printed.strip_difference(*_strip_angles(field, k), sign=sign)
            - field.alternating_sum(field.strip(k, (NEAR, FAR), EPSILON))
            for k in range(field.size)
            if field.family(k) == rays
        }

    return over_fields(
        setting, residuals, shown="about every u-ray of stars of order 2 to 5, q- before r-"
    )


def strip_differences(setting: Setting, *, least: int = 1, matched: bool = True) -> Evidence:
    """Differences of phi along the sides of a strip, less those along the ray in between.

    They are sigma times the area between. least: order in eps to which they are to vanish, decided
    on the Taylor series of a solution whose rays have curvature, up to degree 4.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        found = {}
        for k in range(field.size):
            before = (k - 1) % field.size
            r_plus, r_minus, q_minus, q_plus = _strip_angles(field, k)
            ray_plus = field.angle((k, FAR, 0)) - field.angle((k, NEAR, 0))
            ray_minus = field.angle((before, 0, FAR)) - field.angle((before, 0, NEAR))
            plus = field.sigma(k) * field.area(k, (NEAR, FAR), (0, EPSILON))
            minus = field.sigma(before) * field.area(before, (0, EPSILON), (NEAR, FAR))
            found[f"+ of ray {k}"] = r_plus - q_plus - ray_plus - plus
            found[f"- of ray {k}"] = r_minus - q_minus - ray_minus - minus
            found[f"along ray {k}"] = ray_plus - ray_minus
        return found

    u, v = amsler.U, amsler.V
    phi = amsler.goursat_series(4, u / 2 + u**2, v / 3)
    side = sp.expand((phi - phi.subs(v, 0)).subs(u, 1) - (phi - phi.subs(v, 0)).subs(u, 0))
    vanishing = [sp.expand(side.coeff(v, n)) for n in range(least)]
    return combined(
        {
            "area": over_fields(setting, residuals, shown="", matched=matched),
            "order": _all_zero(vanishing, f"coefficients below eps^{least}"),
        },
        shown="the differences exceed the integral along the ray by sigma times the area between, "
        "which vanishes like eps",
    )


def _all_zero(values: list[Any], what: str) -> Evidence:
    return statement(
        all(sp.expand(value) == 0 for value in values),
        shown="",
        witness=f"{what}: {', '.join(map(str, values))}",
    )


def curvatures_match(
    setting: Setting, *, along: str = "u", sign: int = 1, one_normal: bool = True
) -> Evidence:
    """Slope of phi along a curve and its geodesic curvature, on nets of either sigma.

    sign: kappa^u = -sign phi_u, kappa^v = sign phi_v; one_normal: whether curvatures are
    measured with N for both sectors, else with the orientation of (u, v) in each.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        slope = net.angle_rate(along)
        stated = (-sign if along == "u" else sign) * slope
        forms = (sp.Integer(1), net.sigma * net.cos_phi, sp.Integer(1))
        orientation = net.sigma if one_normal else 1
        by_metric = coordinate_line_curvatures(forms, orientation * net.sin_phi, net.calculus.rate)[
            0 if along == "u" else 1
        ]
        return {
            "by the frame": net.geodesic_curvature(along) - stated,
            "by the metric": by_metric - stated,
        }

    return over_nets(
        setting,
        general_nets(),
        residuals,
        shown="for an unknown angle and either sign of sigma, N the same: the slope of phi along "
        "the curve is its geodesic curvature up to one sign, whatever the sector",
    )


def strips_vanish(
    setting: Setting, *, rays: str = "u", matched: bool = True, least: int = 1, percent: int = 100
) -> Evidence:
    """Sum over a strip about a ray: its area, and 0 <= area <= 2 eps (b - a).

    rays: families of the rays, "u", "v" or "uv"; least: order in eps to which the sum is to
    vanish, decided on Taylor series up to degree 4; percent: of the area.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        ends = (NEAR, FAR)
        return {
            f"ray {k}": field.alternating_sum(field.strip(k, ends, EPSILON))
            - sp.Rational(percent, 100) * field.strip_area(k, ends, EPSILON)
            for k in range(field.size)
            if field.family(k) in rays
        }

    u, v = amsler.U, amsler.V
    phi = amsler.goursat_series(4, u / 2, v / 3)
    area = sp.expand(phi.subs(u, 1) - phi.subs(u, 0) - (phi.subs(u, 1) - phi.subs(u, 0)).subs(v, 0))
    vanishing = [sp.expand(area.coeff(v, n)) for n in range(least)]
    return combined(
        {
            "area": over_fields(setting, residuals, shown="", matched=matched),
            "order": _all_zero(vanishing, f"coefficients below eps^{least}"),
        },
        shown="on unknown surfaces over stars of order 2 to 5 the sum over the strip is its area, "
        "at most 2 eps times its length as sin phi <= 1",
    )


def v_strips_vanish(setting: Setting, *, matched: bool = True, least: int = 1) -> Evidence:
    """Sum over a strip about a v-ray."""
    return strips_vanish(setting, rays="v", matched=matched, least=least)


def all_strips_vanish(setting: Setting, *, matched: bool = True, least: int = 1) -> Evidence:
    """Sum over a strip about any ray."""
    return strips_vanish(setting, rays="uv", matched=matched, least=least)


def v_curvatures_match(setting: Setting, *, sign: int = 1, one_normal: bool = True) -> Evidence:
    """Slope of phi along a v-curve and its geodesic curvature."""
    return curvatures_match(setting, along="v", sign=sign, one_normal=one_normal)


def far_corner(setting: Setting, *, least: int = 1, lipschitz: bool = True) -> Evidence:
    """Taylor series of phi(eps, eps) - phi_0 where the edges have curvature.

    least: order in eps to which it is to vanish; lipschitz: else phi grows like the square root of
    the length along an edge, continuous but no more.
    """
    u, v = amsler.U, amsler.V
    phi = amsler.goursat_series(4, u / 2 + u**2, v / 3)
    # With eps = h^2 the square root of eps is h: order 2 in h is order 1 in eps.
    h = sp.Symbol("h", positive=True)
    extra = sp.Integer(0) if lipschitz else h
    series = sp.expand(phi.subs({u: h**2, v: h**2}) + extra)
    return _all_zero_shown(
        [series.coeff(h, n) for n in range(2 * least)],
        f"coefficients of phi - phi_0 below eps^{least}, by powers of sqrt(eps)",
        "for a Goursat problem with smooth data phi at the far corner is phi_0 + 5 eps/6 + ..., "
        "not better than O(eps)",
    )


def _all_zero_shown(values: list[Any], what: str, shown: str) -> Evidence:
    found = _all_zero(values, what)
    return statement(found.outcome == "pass", shown=shown, witness=found.witness or what)
