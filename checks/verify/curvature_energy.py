"""Checks of the principal curvatures by the angle, their divergence, and the margin delta."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import curvature_energy as printed
from checks.zero import vanishes
from theory import bobbin, curvature, forms, surface_of_revolution
from theory.asymptotic_net import general_net
from theory.vectors import scaled

RADIUS = sp.Symbol("R", positive=True)


def principal_curvatures(
    setting: Setting, *, half: str = "1/2", second: str = "cot", opposite: bool = True
) -> Evidence:
    """Trace and determinant of the shape operator, for both sigma and both normals."""
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        net = general_net(sigma)
        calculus = net.calculus
        phi = next(iter(net.cos_phi.atoms(sp.core.function.AppliedUndef)))
        first = forms.first_form(calculus, net.r_u, net.r_v)
        for side in (1, -1):
            normal = scaled(sp.Integer(side), net.normal)
            second_form = forms.second_form(calculus, net.r_u, net.r_v, normal)
            trace = forms.twice_mean_curvature(first, second_form)
            gauss = forms.determinant(second_form) / forms.determinant(first)
            pairs = [
                printed.principal_curvatures(
                    phi, upper, half=half, second=second, opposite=opposite
                )
                for upper in (1, -1)
            ]
            fits = [pair for pair in pairs if vanishes(sum(pair) - trace)]
            pair = fits[0] if fits else pairs[0]
            name = f"sigma = {sigma:+d}, normal {side:+d}"
            residuals[f"trace, {name}"] = sum(pair) - trace
            residuals[f"product, {name}"] = pair[0] * pair[1] - gauss
    return identities(
        setting,
        residuals,
        shown="for both sigma and both normals one reading of the sign gives trace and determinant "
        "of the shape operator of the net",
    )


def max_curvature(setting: Setting, *, ends: str = "edges", of: str = "larger") -> Evidence:
    """Limits of the larger curvature at phi = 0 and pi, and that nothing else makes it diverge.

    ends: `edges`, or `middle` for phi = pi/2; of: the `larger` or the `smaller` curvature.
    """
    phi = sp.Symbol("phi", positive=True)
    first, second = printed.principal_curvatures(phi, 1)
    # max(t, 1/t) = (t + 1/t + |t - 1/t|)/2 for t = tan(phi/2); cos phi >= 0 near 0, <= 0 near pi.
    sign = {"larger": 1, "smaller": -1}[of]
    places = {
        "edges": ((sp.Integer(0), "+", 1), (sp.pi, "-", -1)),
        "middle": ((sp.pi / 2, "-", 1), (sp.pi / 2, "+", -1)),
    }
    limits = [
        sp.limit((1 + sign * size * sp.cos(phi)) / sp.sin(phi), phi, at, side)
        for at, side, size in places[ends]
    ]
    t, d = sp.symbols("t d", positive=True)
    # A margin: with w = tan(delta/2) < 1, tan(phi/2) = w + (1/w - w) x, 0 < x < 1.
    w, x = 1 / (1 + d), t / (1 + t)
    inside = w + (1 / w - w) * x
    shown = (
        "max(tan, cot)(phi/2) = (1 + |cos phi|)/sin phi tends to infinity as phi tends to 0 or pi, "
        "and is less than cot(delta/2) for delta < phi < pi - delta"
    )
    return combined(
        {
            "in sines and cosines": identities(
                setting,
                {
                    "sum of the sizes": first - second - 2 / sp.sin(phi),
                    "their difference": -second - first - 2 * sp.cos(phi) / sp.sin(phi),
                },
                shown=shown,
            ),
            "limits": statement(
                limits == [sp.oo, sp.oo], shown=shown, witness=f"the limits are {limits}"
            ),
            "inside": positivity(
                setting, {"tan": 1 / w - inside, "cot": 1 / w - 1 / inside}, shown=shown
            ),
        },
        shown=shown,
    )


def _bobbin_range() -> tuple[sp.Expr, sp.Expr]:
    """Least and greatest phi on the best bobbin disk of radius log 2, by tan(phi/2) there."""
    squared = bobbin.squared_curvatures()[0].subs(bobbin.KAPPA, sp.Rational(5, 4))
    throat, rim = (
        sp.sqrt(sp.cancel(squared.subs(bobbin.S, s).rewrite(sp.exp))) for s in (0, sp.log(2))
    )
    return 2 * sp.atan(throat), sp.pi - 2 * sp.atan(1 / rim)


def margin(setting: Setting, *, side: str = "both") -> Evidence:
    """Largest delta of some ranges of phi by the printed inequalities, and near-misses of it.

    The ranges: a disk of the bobbin, and parts of an Amsler sector bounded from below or above;
    near-misses: delta 1 % more, and an edge touched below or above.
    """
    del setting
    eighth, more = sp.pi / 8, sp.Rational(101, 100)
    least, greatest = _bobbin_range()
    instances = (
        ("bobbin, R = log 2", least, least, greatest, True),
        ("bobbin, delta 1 % more", least * more, least, greatest, False),
        ("phi from pi/4 to 5 pi/8", 2 * eighth, 2 * eighth, 5 * eighth, True),
        ("phi from pi/4 to 7 pi/8", eighth, 2 * eighth, 7 * eighth, True),
        ("phi from pi/4 to 7 pi/8, 1 % more", eighth * more, 2 * eighth, 7 * eighth, False),
        ("phi from 0", sp.Integer(0), sp.Integer(0), eighth, False),
        ("phi up to pi", eighth, 2 * eighth, sp.pi, False),
    )
    for name, delta, least, greatest, valid in instances:
        if printed.is_margin(delta, least, greatest, side=side) != valid:
            verb = "refused" if valid else "accepted"
            return statement(False, shown="", witness=f"{name}: delta = {delta} is {verb}")
    return statement(
        True,
        shown="min(least phi, pi - greatest phi) is the largest delta: it is accepted for three "
        "ranges, and a larger one, or any at an edge, is refused",
        witness="",
    )


def energy_of_margin(setting: Setting, *, half: str = "1") -> Evidence:
    """E_inf by delta: the curvatures at phi = delta and pi - delta, and on the best bobbin disk."""
    delta = sp.Symbol("delta", positive=True)
    claimed = printed.max_curvature_of_margin(delta, half=half)
    pair = curvature.principal_curvatures(delta)
    mirrored = curvature.principal_curvatures(sp.pi - delta)
    right = sp.pi / 2
    at_right = [abs(k) for k in printed.principal_curvatures(right, 1)]
    value = printed.max_curvature_of_margin(right, half=half)
    shown = "both ends of delta <= phi <= pi - delta have the larger curvature cot(delta/2)"
    longitudinal, azimuthal = bobbin.largest_on_disk(sp.cosh(RADIUS), sp.Integer(0), RADIUS)
    # cos phi at the throat by the asymptotic directions: cos^2 of half the angle to the meridian.
    squared_speed, _ = surface_of_revolution.asymptotic_rates(bobbin.bobbin(), sp.Integer(0))
    half_cosine = squared_speed.subs({bobbin.S: 0, bobbin.KAPPA: sp.cosh(RADIUS)})
    tangent = 1 / sp.cosh(RADIUS)
    return combined(
        {
            "delta = pi/2": statement(
                bool(sp.Max(*at_right) == value),
                shown=shown,
                witness=f"delta = pi/2, phi = pi/2: the curvatures are {at_right[0]} and "
                f"-{at_right[1]}, but cot({half} delta) = {value}",
            ),
            "ends": identities(
                setting,
                {
                    "at delta": (claimed - pair[0]) * (claimed + pair[1]),
                    "at pi - delta": (claimed - mirrored[0]) * (claimed + mirrored[1]),
                },
                shown=shown,
            ),
            "bobbin": identities(
                setting,
                {
                    "throat": azimuthal - sp.cosh(RADIUS) ** 2,
                    "rim": longitudinal - sp.cosh(RADIUS) ** 2,
                    "angle at the throat": half_cosine - 1 / (1 + tangent**2),
                },
                shown=shown,
            ),
        },
        shown=shown + "; on the best bobbin disk cot(delta/2) = cosh R",
    )  # fmt: skip
