"""Checks of Minding's bobbin: profile, metric, curvature, singular edge, topology."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.order import order_of_zero
from checks.positivity import positivity
from checks.printed import bobbin_metric as printed
from theory import bobbin, equidistant_strip
from theory import surface_of_revolution as revolution
from theory.bobbin import KAPPA, THETA, S
from theory.vectors import derivative


def profile(setting: Setting, *, rate: int = 1, total: int = 1) -> Evidence:
    """Agreement of the printed radius with that of K = -1 and throat curvature kappa."""
    rho = printed.radius(S, KAPPA, rate=rate)
    curve = revolution.meridian(rho, S)
    return identities(
        setting,
        {
            "rho": rho - bobbin.radius(),
            "arc length": printed.meridian_speed(curve.rho_s, curve.z_s, total=total),
            "Gauss curvature": revolution.gauss_curvature(curve, THETA) + 1,
        },
        shown="the surface exists, is unit speed along its meridians and has curvature -1",
    )


def throat(setting: Setting, *, factor: int = 1) -> Evidence:
    """Curvature in R^3 of the equator."""
    circle = revolution.curvature_of_parallel(bobbin.bobbin(), THETA).subs(S, 0)
    return identities(
        setting,
        {"squared curvature": circle - printed.throat_curvature(KAPPA, factor=factor) ** 2},
        shown="|r' x r''|/|r'|^3 along the circle s = 0 is kappa",
    )


def metric(setting: Setting, *, power: int = 2) -> Evidence:
    """Induced metric of every surface of revolution by arc length, and of the bobbin."""
    residuals = {}
    for name, curve in (("any meridian", revolution.generic_meridian()), ("bobbin", _bobbin())):
        expected = printed.induced_metric(curve.rho, power=power)
        for entry, found, wanted in zip(
            "EFG", revolution.first_form(curve, THETA), expected, strict=True
        ):
            residuals[f"{name}: {entry}"] = found - wanted
    return identities(setting, residuals, shown="E, F, G of the embedded surface are 1, 0, rho^2")


def _bobbin() -> revolution.Meridian:
    return bobbin.bobbin()


def gauss(setting: Setting, *, sign: int = -1, value: int = -1) -> Evidence:
    """Gauss curvature of every surface of revolution by its radius, and its value here."""
    generic, curve = revolution.generic_meridian(), _bobbin()
    return identities(
        setting,
        {
            "any meridian": revolution.gauss_curvature(generic, THETA)
            - printed.gauss_curvature(generic.rho, generic.rho_ss, sign=sign),
            "bobbin": printed.gauss_curvature(curve.rho, curve.rho_ss, sign=sign) - value,
        },
        shown="det II / det I is -rho''/rho for any unit-speed meridian, and -1 on the bobbin",
    )


def singular_edge(setting: Setting, *, inverse: str = "asinh") -> Evidence:
    """Slopes at the ends, impossibility beyond, and unbounded curvature before them."""
    curve = _bobbin()
    end = printed.edge(KAPPA, inverse=inverse)
    slopes = {"L": end - bobbin.half_length()}
    for side in (1, -1):
        at = {S: side * end}
        slopes[f"rho' at {side:+d} L"] = curve.rho_s.subs(at) - side
        slopes[f"z' at {side:+d} L"] = curve.z_s.subs(at)
    beyond, length = sp.symbols("d L", positive=True)
    z_squared = (curve.z_s**2).subs({S: length + beyond, KAPPA: sp.sinh(length)})
    longitudinal, _ = bobbin.squared_curvatures()
    before = (1 / longitudinal).subs(S, end)
    return combined(
        {
            "slopes": identities(setting, slopes, shown="rho' = +-1 and z' = 0 at s = +-L"),
            "beyond": positivity(setting, {"-z'^2 at L + d": -z_squared}, shown="no real z beyond"),
            "curvature": identities(setting, {"1/k^2 at L": before}, shown="curvature unbounded"),
        },
        shown="at s = +-L the slopes are +-1 and 0; beyond, z'^2 < 0; the longitudinal curvature "
        "is unbounded there, so that no C^2 immersion continues the surface",
    )


def cylinder(setting: Setting, *, turn: str = "2", ring: str = "throat") -> Evidence:
    """Whether the surface is an embedded cylinder: (theta mod 2 pi, s), for |s| < L.

    turn: period over pi; ring: `throat` for the bobbin, `cone` for radius sinh(s)/kappa.
    """
    rho = {"throat": bobbin.radius(), "cone": sp.sinh(S) / KAPPA}[ring]
    curve = revolution.meridian(rho, S)
    here = revolution.rotated(curve.rho, S, THETA)
    there = revolution.rotated(curve.rho, S, THETA + sp.Rational(turn) * sp.pi)
    first_e, first_f, first_g = revolution.first_form(curve, THETA)
    area = (first_e * first_g - first_f**2).subs(THETA, 0)
    up, to_edge = sp.symbols("s_up d", positive=True)
    inside = {S: up, KAPPA: sp.sinh(up + to_edge)}
    return combined(
        {
            "period": identities(
                setting,
                {f"r{i}": a - b for i, (a, b) in enumerate(zip(here, there, strict=True))},
                shown="r(s, theta) has the period",
            ),
            "immersed": positivity(
                setting,
                {
                    "squared area element": sp.simplify(area).subs(S, up),
                    "at the throat": sp.simplify(area).subs(S, 0),
                },
                shown="the area element is positive",
            ),
            "injective": positivity(
                setting, {"z'^2": (curve.z_s**2).subs(inside)}, shown="z increases with s"
            ),
        },
        shown="r is 2 pi-periodic in theta and immersed; z increases with s and rho > 0, hence "
        "one point for each (theta mod 2 pi, s): an embedded cylinder S^1 x (-L, L)",
    )


def universal_cover(setting: Setting, *, stretch: int = 1) -> Evidence:
    """Isometry of R x (-L, L), with the bobbin's metric, onto the strip about a geodesic of H^2.

    stretch: factor of tau = theta/kappa.
    """
    s, theta = S, THETA
    x = equidistant_strip.point(s, stretch * theta / KAPPA)
    x_s, x_theta = derivative(x, s), derivative(x, theta)
    inner = equidistant_strip.minkowski
    curve = _bobbin()
    first_e, first_f, first_g = revolution.first_form(curve, theta)
    back = equidistant_strip.coordinates(x)
    return identities(
        setting,
        {
            "on the hyperboloid": inner(x, x) + 1,
            "E": inner(x_s, x_s) - first_e,
            "F": inner(x_s, x_theta) - first_f,
            "G": inner(x_theta, x_theta) - first_g,
            "s recovered": back[0] - sp.sinh(s),
            "theta recovered": back[1] - sp.tanh(theta / KAPPA),
        },
        shown="(theta, s) -> H^2 is an isometry of the plane strip onto |distance to a geodesic| "
        "< L, with inverse; R x (-L, L) is simply connected, theta -> theta mod 2 pi covers",
    )


def longitudinal(setting: Setting, *, numerator: str = "cosh", power: str = "-1/2") -> Evidence:
    """Rate of turn of the meridian's tangent, and the surface's principal curvature along it."""
    curve = _bobbin()
    stated = printed.longitudinal_curvature(S, KAPPA, numerator=numerator, power=power)
    along, across = revolution.principal_curvatures(curve, THETA)
    return identities(
        setting,
        {
            "d/ds arcsin rho'": _same_root(sp.diff(sp.asin(curve.rho_s), S)) - stated,
            "second form": _same_root(along) + stated,
            "times the azimuthal": along * across + 1,
        },
        shown="d/ds arcsin rho' is the printed quotient, and so is, up to the normal's side, the "
        "normal curvature of the meridian; its product with the azimuthal one is -1",
    )


def _same_root(expr: sp.Expr) -> sp.Expr:
    """Write sqrt(1 - sinh^2/kappa^2) by the root of kappa^2 - sinh^2: kappa is positive."""
    inner = 1 - sp.sinh(S) ** 2 / KAPPA**2
    root = sp.sqrt(KAPPA**2 - sp.sinh(S) ** 2) / KAPPA
    return expr.replace(
        lambda e: e.is_Pow and e.base == inner and e.exp.is_Rational and e.exp.q == 2,
        lambda e: root ** (2 * e.exp),
    )


def divergence(setting: Setting, *, power: str = "-1/2") -> Evidence:
    """Order of vanishing at the edge of the inverse square of the longitudinal curvature."""
    squared, _ = bobbin.squared_curvatures()
    end = bobbin.half_length()
    order = order_of_zero(1 / squared, S, end)
    slope = sp.diff(1 / squared, S).subs(S, end)
    found = -sp.Rational(order, 2)
    return combined(
        {
            "coefficient": identities(
                setting, {"d(1/k^2)/ds at L": slope + 2 * sp.tanh(end)}, shown="-2 tanh L"
            ),
            "power": statement(
                found == sp.Rational(power),
                shown="1/k^2 has a simple zero",
                witness=f"the curvature grows as the distance to the power {found}, not {power}",
            ),
        },
        shown="1/k^2 has a simple zero of slope -2 tanh L at s = L, so k ~ (2 tanh L)^(-1/2) "
        "(L - s)^(-1/2)",
    )


def willmore(setting: Setting, *, growth: str = "log", power: int = 2) -> Evidence:
    """Pole at the edge of the sum of the powers of the curvatures, per d theta d(sinh s).

    The pole is looked for in w, w^2 = sinh L - sinh s, as odd powers have roots there.
    growth: `bounded`, `log` or `power` of the integral as the edge is approached.
    """
    w = sp.Symbol("w", positive=True)
    density = bobbin.bending_density(KAPPA - w**2, power=power)
    order = sp.Rational(order_of_zero(sp.cancel(1 / density), w, sp.Integer(0)), 2)
    found = "log" if order == 1 else "bounded" if order < 1 else "power"
    if found != growth:
        return statement(
            False,
            shown="",
            witness=f"the density has a pole of order {order} in sinh L - sinh s, so the integral "
            f"is of growth {found!r}, not {growth!r}",
        )
    residue = sp.cancel(density * w**2).subs(w, 0)
    return combined(
        {
            "residue": identities(
                setting,
                {"residue": residue - (KAPPA**2 + 1) / (2 * KAPPA**2)},
                shown="(kappa^2 + 1)/(2 kappa^2)",
            ),
            "positive": positivity(setting, {"residue": residue}, shown="not 0"),
        },
        shown="the density has a simple pole in sinh s at the edge: the Willmore energy of a box "
        "of angle a that stops at distance t grows as a (kappa^2 + 1)/(2 kappa^2) log(1/t)",
    )


def azimuthal_bound(setting: Setting, *, at: str = "throat") -> Evidence:
    """Azimuthal curvature: at most kappa, its value at the throat."""
    longitudinal_squared, azimuthal = bobbin.squared_curvatures()
    place = {"throat": sp.Integer(0), "edge": bobbin.half_length(), "half-way": sp.asinh(KAPPA / 2)}
    here = place[at]
    s = sp.Symbol("s_up", positive=True)
    return combined(
        {
            "bound": identities(
                setting,
                {
                    "azimuthal": sp.simplify(azimuthal.subs(S, here)) - KAPPA**2,
                    "longitudinal": longitudinal_squared.subs(S, 0) - 1 / KAPPA**2,
                },
                shown="kappa and 1/kappa",
            ),
            "elsewhere less": positivity(
                setting, {"kappa^2 - azimuthal^2": KAPPA**2 - azimuthal.subs(S, s)}, shown="less"
            ),
        },
        shown="the azimuthal curvature is kappa at s = 0 and smaller elsewhere, 0 at the edge; the "
        "longitudinal one is 1/kappa at the throat: the bound kappa is the throat's",
    )
