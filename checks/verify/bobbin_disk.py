"""Checks of the geodesic disks in Minding's bobbin and of their largest curvature (eq:c2energy)."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import bobbin_metric as printed
from theory import bobbin, equidistant_strip
from theory.bobbin import KAPPA, S

RADIUS = sp.Symbol("R", positive=True)
HYPERBOLIC = {"sinh": sp.sinh, "cosh": sp.cosh, "exp": sp.exp}


def largest_disk(setting: Setting, *, factor: int = 2) -> Evidence:
    """Heights that a disk of radius t about height s0 takes in the strip, and its diameter."""
    s0, t, angle = sp.symbols("s0 t a", real=True)
    inner = equidistant_strip.minkowski
    centre = equidistant_strip.point(s0, 0)
    rim = equidistant_strip.geodesic(s0, 0, angle, t)
    opposite = equidistant_strip.geodesic(s0, 0, angle + sp.pi, t)
    room = sp.sinh(t) * sp.cosh(s0)
    return identities(
        setting,
        {
            "distance from the centre": inner(centre, rim) + sp.cosh(t),
            "distance across": inner(rim, opposite) + sp.cosh(2 * t),
            "below s0 + t": sp.sinh(s0 + t) - rim[2] - room * (1 - sp.cos(angle)),
            "above s0 - t": rim[2] - sp.sinh(s0 - t) - room * (1 + sp.cos(angle)),
            "bound": printed.largest_diameter(KAPPA, factor=factor) - 2 * bobbin.half_length(),
        },
        shown="a disk of radius R about height s0 takes exactly the heights |s - s0| <= R, so it "
        "stays in |s| < L iff R <= L - |s0|: the least bound on its diameter 2 R is 2 L",
    )


def _rational(expr: sp.Expr) -> sp.Expr:
    """Value of a hyperbolic expression of logarithms of rationals."""
    return sp.cancel(sp.sympify(expr).rewrite(sp.exp))


def _broken_chain(
    radius: sp.Expr, centre: sp.Expr, kappa: sp.Expr, *, strict: bool, lower: str
) -> str:
    """How the chain fails on one disk, in exact numbers; empty where it does not."""
    nearest = centre - radius if centre > radius else sp.Integer(0)
    entries = bobbin.largest_on_disk(kappa, nearest, centre + radius)
    largest = sp.Max(*(_rational(entry) for entry in entries))
    least = _rational(HYPERBOLIC[lower](radius))
    where = f"disk of radius {radius} at height {centre} in the bobbin kappa = {kappa}"
    if kappa <= least:
        return f"{where}: kappa <= {lower} R = {least}"
    if largest < kappa**2 or (strict and largest == kappa**2):
        return f"{where}: the largest curvature is {sp.sqrt(largest)}"
    return ""


def curvature_chain(
    setting: Setting, *, strict: bool = True, meets_throat: bool = False, lower: str = "sinh"
) -> Evidence:
    """Chain E_inf > kappa > sinh R for the disks of radius R with bounded curvature.

    strict: whether the first inequality is strict; meets_throat: whether only the disks that meet
    the throat are meant; lower: function of R at the end of the chain.
    """
    two, four = sp.log(2), sp.log(4)
    disks = [(two, sp.Integer(0), sp.Integer(k)) for k in (1, 2, 3)]
    disks += [(two, sp.log(sp.Rational(3, 2)), sp.Integer(5)), (two, four, sp.Integer(10))]
    met = [disk for disk in disks if not meets_throat or disk[1] <= disk[0]]
    for disk in met:
        if witness := _broken_chain(*disk, strict=strict, lower=lower):
            return statement(False, shown="", witness=witness)
    margin = sp.Symbol("d", positive=True)
    centred = bobbin.largest_on_disk(KAPPA, 0, RADIUS)
    excess = (centred[0] - centred[1]) * (KAPPA**2 - sp.sinh(RADIUS) ** 2)
    return combined(
        {
            "at the throat": identities(
                setting, {"azimuthal^2": centred[1] - KAPPA**2}, shown="kappa"
            ),
            "equality": identities(
                setting,
                {"excess": excess + (KAPPA**2 + 1) * (KAPPA**2 - sp.cosh(RADIUS) ** 2)},
                shown="E_inf = kappa iff kappa >= cosh R on the centred disk",
            ),
            "room": positivity(
                setting,
                {"sinh L - sinh R": sp.sinh(RADIUS + margin) - HYPERBOLIC[lower](RADIUS)},
                shown="L > R",
            ),
        },
        shown="a disk that meets the throat has E_inf >= kappa, one of bounded curvature has "
        "L > R; on the centred disk E_inf = kappa exactly where kappa >= cosh R",
    )


def _extremes_at_the_ends(setting: Setting) -> Evidence:
    """On s > 0 the longitudinal curvature grows and the azimuthal one falls."""
    s, room = sp.symbols("s_up d", positive=True)
    longitudinal, azimuthal = (square.subs(S, s) for square in bobbin.squared_curvatures())
    inside = {KAPPA: sp.sqrt(sp.sinh(s) ** 2 + room)}
    return positivity(
        setting,
        {
            "longitudinal": sp.diff(longitudinal, s).subs(inside),
            "azimuthal": -sp.diff(azimuthal, s).subs(inside),
        },
        shown="largest where |s| is largest and least",
    )


def _every_disk(setting: Setting) -> Evidence:
    """E_inf >= cosh M / cosh m on the heights m <= |s| <= M, whatever kappa."""
    nearest, farthest = sp.symbols("m M", positive=True)
    longitudinal, azimuthal = bobbin.largest_on_disk(KAPPA, nearest, farthest)
    low, high = sp.cosh(nearest) ** 2, sp.cosh(farthest) ** 2
    excess = (KAPPA**2 + 1 - low - high) / low
    room = (KAPPA**2 - sp.sinh(farthest) ** 2) / high
    return identities(
        setting,
        {
            "azimuthal": azimuthal - high / low - excess,
            "longitudinal": room * (longitudinal - high / low) + excess,
        },
        shown="one of the two squares is at least cosh^2 M / cosh^2 m, both where kappa^2 + 1 = "
        "cosh^2 m + cosh^2 M",
    )


def _every_centre(setting: Setting) -> Evidence:
    """Cosh M / cosh m is least, cosh R, for the disk centred on the throat."""
    offset = sp.Symbol("x", positive=True)
    meets = sp.cosh(RADIUS + offset) ** 2 - sp.cosh(RADIUS) ** 2
    misses = sp.cosh(2 * RADIUS + offset) ** 2 - (sp.cosh(RADIUS) * sp.cosh(offset)) ** 2
    touches = sp.cosh(2 * RADIUS) ** 2 - sp.cosh(RADIUS) ** 2
    return positivity(
        setting,
        {"centre within R of the throat": meets, "throat missed by x": misses, "touched": touches},
        shown="every other disk of radius R has E_inf > cosh R",
    )


def c2_bound(
    setting: Setting, *, throat: str = "1", numerator: str = "cosh", power: str = "-1/2"
) -> Evidence:
    """Both sides of eq:c2energy: the maximum's infimum, and that of every disk of radius R."""
    forms = {"throat": throat, "numerator": numerator, "power": power}
    first, second = printed.c2_energies(KAPPA, RADIUS, **forms)
    longitudinal, azimuthal = bobbin.largest_on_disk(KAPPA, 0, RADIUS)
    least = sp.cosh(RADIUS)
    q, room = sp.symbols("q d", positive=True)
    rates = [sp.diff((a**2).subs(KAPPA, sp.sqrt(q)), q) for a in (first, second)]
    rises, falls = (rate.subs(q, sp.sinh(RADIUS) ** 2 + room) for rate in rates)
    return combined(
        {
            "entries": identities(
                setting,
                {"throat": first**2 - azimuthal, "edge": second**2 - longitudinal},
                shown="largest azimuthal and longitudinal curvature of the centred disk",
            ),
            "crossing": identities(
                setting,
                {
                    "throat": first.subs(KAPPA, least) ** 2 - least**2,
                    "edge": second.subs(KAPPA, least) ** 2 - least**2,
                },
                shown="both are cosh R at kappa = cosh R",
            ),
            "monotone": positivity(
                setting,
                {"throat rises": rises, "edge falls": -falls},
                shown="with kappa^2 one rises, the other falls",
            ),
            "ends": _extremes_at_the_ends(setting),
            "every kappa": _every_disk(setting),
            "every centre": _every_centre(setting),
        },
        shown="the right side is cosh R, attained at kappa = cosh R; every disk of radius R in any "
        "bobbin has E_inf >= cosh R, so the two sides are equal",
    )


def balance(setting: Setting, *, function: str = "cosh", factor: str = "1") -> Evidence:
    """Optimal kappa, factor * function(R): the two curvatures agree there and only there."""
    best = sp.Rational(factor) * HYPERBOLIC[function](RADIUS)
    longitudinal, azimuthal = bobbin.largest_on_disk(KAPPA, 0, RADIUS)
    w = sp.Symbol("w", positive=True)
    value = azimuthal.subs(KAPPA, best)
    narrower = {KAPPA: sp.sqrt(sp.sinh(RADIUS) ** 2 + w / (1 + w))}
    wider = {KAPPA: best + w}
    return combined(
        {
            "equal": identities(
                setting, {"squares": longitudinal.subs(KAPPA, best) - value}, shown="balance"
            ),
            "elsewhere more": positivity(
                setting,
                {
                    "longitudinal for smaller kappa": longitudinal.subs(narrower) - value,
                    "azimuthal for larger kappa": azimuthal.subs(wider) - value,
                },
                shown="strictly worse on either side",
            ),
        },
        shown="kappa = cosh R is the only minimiser; there the azimuthal curvature at the throat "
        "and the longitudinal one at the rim s = +-R are both cosh R",
    )
