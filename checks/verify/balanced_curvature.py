"""Checks of the remark on distributed branch points: curvatures, energies, what they ask for."""

from collections.abc import Iterable
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import branched_sine_gordon as printed
from checks.printed import fundamental_forms
from checks.verify.ball_bounds import bounded
from checks.verify.nets import all_nets, over_nets
from checks.verify.tilings import random_tilings
from theory import asymptotic_polygon, painleve, star_saddle
from theory.asymptotic_net import AsymptoticNet
from theory.forms import determinant, first_form, second_form, twice_mean_curvature
from theory.star_field import StarField
from theory.tiling_angles import TilingAngles

PHI = sp.Symbol("phi", positive=True)
T = sp.Symbol("t", positive=True)
"""Tangent of phi/2, any positive number for phi in (0, pi)."""


def _half_angle(net: AsymptoticNet) -> Any:
    """Tangent of phi/2 from the cosine and sine of a net."""
    return net.sin_phi / (1 + net.cos_phi)


def principal_curvatures(setting: Setting, *, second: int = -1, shape: str = "dN") -> Evidence:
    """Trace and determinant of the shape operator of nets of either sigma, N oriented.

    shape: "dN", as in h = dN . dr of (eq:metrics), or "-dN", whose eigenvalues have other signs.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        half = sp.Symbol("h", positive=True)
        one, two = (
            k.rewrite(sp.tan).subs(sp.tan(PHI / 2), half)
            for k in printed.principal_curvatures(PHI, second=second)
        )
        tangent = _half_angle(net)
        forms = (
            first_form(net.calculus, net.r_u, net.r_v),
            second_form(net.calculus, net.r_u, net.r_v, net.normal),
        )
        trace = (-1 if shape == "dN" else 1) * twice_mean_curvature(*forms)
        product = determinant(forms[1]) / determinant(forms[0])
        return {
            "sum": (one + two).subs(half, tangent) - trace,
            "product": (one * two).subs(half, tangent) - product,
        }

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown="sum and product are those of the shape operator dN for the normal N that omega "
        "orients, for an unknown angle and on explicit surfaces, either sign of sigma",
    )


def curvature_product(setting: Setting, *, second: int = -1, halves: int = 1) -> Evidence:
    """Product of the printed curvatures, halves: of phi in the second one too."""
    one, two = printed.principal_curvatures(PHI, second=second)
    other = printed.principal_curvatures(PHI, second=second, halves=halves)[1]
    return identities(
        setting,
        {"kappa_1 kappa_2 + 1": one * other + 1, "kappa_2": sp.sympify(two - other)},
        shown="tan(phi/2) cot(phi/2) = 1",
    )


def willmore_density(setting: Setting, *, power: int = 2) -> Evidence:
    """Density by the curvatures, and as 4 H^2 - 2 K from the forms of nets; 2 |K| is refused."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        tangent = _half_angle(net)
        density = printed.willmore_density(tangent, -1 / tangent, power=power)
        forms = (
            first_form(net.calculus, net.r_u, net.r_v),
            second_form(net.calculus, net.r_u, net.r_v, net.normal),
        )
        gauss = determinant(forms[1]) / determinant(forms[0])
        return {"density - (4 H^2 - 2 K)": density - twice_mean_curvature(*forms) ** 2 + 2 * gauss}

    density = printed.willmore_density(T, -1 / T, power=power)
    flat = statement(
        not (sp.simplify(density - 2) == 0 or sp.diff(density, T) == 0),
        shown="",
        witness="the density does not depend on the angle",
    )
    return combined(
        {"forms": over_nets(setting, all_nets(), residuals, shown=""), "near-miss": flat},
        shown="tan^2 + cot^2 of phi/2 is 4 H^2 - 2 K; the constant 2 |K| is not the density",
    )


def largest_curvature(setting: Setting, *, absolute: bool = True) -> Evidence:
    """The larger curvature in size is the larger of t = tan(phi/2) and 1/t, at t and at 1/t."""
    wrong = []
    for t in (sp.Rational(1, 7), sp.Rational(4, 5), sp.Integer(1), sp.Rational(9, 2)):
        value = printed.largest_curvature(t, -1 / t, absolute=absolute)
        if value != sp.Max(t, 1 / t):
            wrong.append(f"{value} at tan(phi/2) = {t}")
    return statement(
        not wrong,
        shown="at four angles on both sides of pi/2 it is the larger of tan(phi/2), cot(phi/2); "
        "without absolute values it would not be",
        witness="; ".join(wrong),
    )


def right_angle_optimal(setting: Setting, *, best: int = 1, power: int = 2) -> Evidence:
    """Both energies for tan(phi/2) = best (1 + t) and best/(1 + t) against those for best."""
    claims = {}
    for name, factor in (("above", 1 + T), ("below", 1 / (1 + T))):
        density = printed.willmore_density(best * factor, -1 / (best * factor), power=power)
        at_best = printed.willmore_density(sp.Integer(best), -sp.Rational(1, best), power=power)
        claims[f"bending energy {name}"] = density - at_best
        larger = best * factor if name == "above" else 1 / (best * factor)
        claims[f"larger curvature {name}"] = larger - sp.Max(best, sp.Rational(1, best))
    return positivity(
        setting,
        claims,
        shown="both are larger for every other angle in (0, pi) than for phi = pi/2",
    )


def right_angle_sum(setting: Setting, *, extra: int = 0) -> Evidence:
    """Sum over the vertices of six polygons and of 6 tilings if phi = pi/2 at all of them.

    extra: number of vertices of sign + that are added.
    """
    sums: dict[str, Any] = {}
    for name, polygon in asymptotic_polygon.POLYGONS.items():
        kinds = [asymptotic_polygon.family(arc) for arc in asymptotic_polygon.arcs(polygon)]
        sums[name] = sum(printed.vertex_signs(kinds)) + extra
    for n, tiling in enumerate(random_tilings(setting, wanted=6)[0]):
        signs = TilingAngles(tiling=tiling).rim_sum("first").values()
        sums[f"tiling {n}"] = sum(signs) + extra
    return identities(
        setting,
        {name: sp.pi / 2 * total for name, total in sums.items()},
        shown="u- and v-arcs alternate, so there are as many vertices of either sign",
    )


def two_quantities(setting: Setting, *, order: int = 3, percent: int = 100) -> Evidence:
    """Area and sum of charges of regular stars of lengths l = 1/8, 2/8, ..., 8/8, in balls.

    percent: of the charge; the area grows from one to the next by at most m (l'^2 - l^2) 2.
    """
    charge = -printed.concentration(order, percent=percent) / sp.pi
    if not (charge > 0 and charge.is_integer):
        return statement(False, shown="", witness=f"the sum is {charge} pi")

    def rows() -> Iterable[tuple[str, Any, Any]]:
        previous, size = arb(0), 2 * order
        for k in range(1, 9):
            angle = painleve.angle(lambda: arb.pi() / order, arb(k) / 4, digits=20).ball()
            area = size * (angle - arb.pi() / order)
            growth = area - previous
            yield f"l = {k}/8, area grows", -growth, arb(0)
            yield f"l = {k}/8, by little", growth, size * arb(2 * k - 1) / 64
            previous = area

    return bounded(
        rows(),
        sampled=True,
        shown="areas of stars of order 3 by PIII are positive and grow with l by no more than the "
        "integral of 1 over the new part, while the other quantity is pi",
    )


def right_angle_impossible(setting: Setting, *, halves: int = 1) -> Evidence:
    """Sine-Gordon equation for the constant angle halves pi/2, both signs of sigma."""
    phi = sp.pi * halves / 2
    values = [
        sp.diff(phi, T) - fundamental_forms.sine_gordon(sp.sin(phi), sp.cos(phi), sigma)
        for sigma in (1, -1)
    ]
    return statement(
        all(value != 0 for value in values),
        shown="for phi = pi/2 on an open set phi_uv = 0, but sigma sin phi = +-1",
        witness=f"the constant {phi} solves phi_uv = sigma sin phi",
    )


def area_per_branch_point(setting: Setting, *, order: int = 3, percent: int = 100) -> Evidence:
    """Area that cancels the alternating sum at the centre of a star, against pi."""
    field = StarField(order=order)
    derived = sum((-1) ** j * field.centre(j) for j in range(field.size))
    area = printed.area_per_branch_point(3, percent=percent)
    return identities(
        setting,
        {"area + concentration": sp.expand(area + derived)},
        shown="a branch point of order 3 cancels the area pi, whatever the angles",
    )


def sectors_added(setting: Setting, *, added: int = 1, order: int = 3) -> Evidence:
    """Sectors above and below the tangent plane at a regular point and at a branch point."""
    smooth = star_saddle.count_sides(star_saddle.regular_star(2))
    branched = star_saddle.count_sides(star_saddle.regular_star(order))
    gained = (branched[0] - smooth[0], branched[1] - smooth[1])
    return statement(
        gained == (added, added),
        shown="a point of order 3 has one sector more above the tangent plane, and one below",
        witness=f"order {order} has {gained[0]} more above and {gained[1]} more below",
    )


def near_cancellation(setting: Setting, *, per_vertex: int = 100) -> Evidence:
    """Bound on |A - sum (m - 2) pi| where |phi - pi/2| <= delta at the 2j vertices: 2 j delta.

    The sum over the vertices is that of +-(phi - pi/2), on tilings; per_vertex: hundredths of delta
    that each may contribute.
    """
    delta = sp.Symbol("delta", positive=True)
    gaps, sums = {}, {}
    for n, tiling in enumerate(random_tilings(setting, wanted=6)[0]):
        signs = list(TilingAngles(tiling=tiling).rim_sum("first").values())
        largest = sum((abs(sign) for sign in signs), sp.S.Zero) * delta
        sums[f"tiling {n}, sum of the signs"] = sp.Integer(sum(signs))
        gaps[f"tiling {n}, bound - largest sum"] = (
            len(signs) * delta * sp.Rational(per_vertex, 100) - largest
        )
    return combined(
        {
            "signs": identities(setting, sums, shown=""),
            "bound": identities(setting, gaps, shown=""),
            "not constant": right_angle_impossible(setting),
        },
        shown="a max curvature of tan(pi/4 + delta/2) or less keeps |A - sum (m - 2) pi| within 2 "
        "j delta for every Hamburger polygon with 2 j vertices: branch points must nearly cancel "
        "the area of each, as phi = pi/2 everywhere is impossible",
    )
