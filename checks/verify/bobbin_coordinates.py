"""Checks of the asymptotic coordinates on pseudospherical surfaces of revolution (eq:bobbin)."""

from itertools import product

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import bobbin_orbit as printed
from checks.verify.bobbin_branches import BRANCHES, SIGNS
from theory import surface_of_revolution as revolution
from theory.bobbin import KAPPA, arc_length, bobbin_flow, half_length
from theory.pseudospherical_revolution import (
    PSI,
    THETA,
    U,
    V,
    asymptotic_tangents,
    meridian_normal,
    pseudospherical_flow,
    torsions,
)
from theory.vectors import Vector, added, dot, scaled

ALPHA = sp.Symbol("alpha", positive=True)


def _difference(a: Vector, b: Vector) -> Vector:
    return added(a, scaled(-1, b))


def _mirrored(a: Vector, mirror: str) -> Vector:
    """Vector reflected in the plane of the meridians theta = 0, pi, or in a horizontal plane."""
    signs = {"meridians": (1, -1, 1), "horizontal": (1, 1, -1)}[mirror]
    return (signs[0] * a[0], signs[1] * a[1], signs[2] * a[2])


def _at_opposite_azimuth(a: Vector) -> Vector:
    return (a[0].subs(THETA, -THETA), a[1].subs(THETA, -THETA), a[2].subs(THETA, -THETA))


def reflection(
    setting: Setting, *, mirror: str = "meridians", torsion: int = -1, angular: int = -1
) -> Evidence:
    """Effect of the reflection on s, d/d theta, the asymptotic lines and their torsion."""
    flow = pseudospherical_flow(ALPHA)
    r_u, r_v = asymptotic_tangents(flow)
    along, about = revolution.tangents(flow.meridian, THETA)
    torsion_u, torsion_v = torsions(flow)
    return identities(
        setting,
        {
            "d/ds": _difference(_mirrored(along, mirror), _at_opposite_azimuth(along)),
            "d/d theta": _difference(
                _mirrored(about, mirror), scaled(angular, _at_opposite_azimuth(about))
            ),
            "u to v": _difference(_mirrored(r_u, mirror), _at_opposite_azimuth(r_v)),
            "torsions": torsion_u - torsion * torsion_v,
            "unit torsion": torsion_u**2 - 1,
        },
        shown="for every alpha > 0 the reflection keeps d/ds, reverses d/d theta and takes r_u to "
        "r_v; the torsions of the two families are +-1, of opposite sign",
    )


def parallel_fields(setting: Setting, *, sign: int = 1) -> Evidence:
    """Sum and difference of r_u and r_v along the meridian and the parallel."""
    flow = pseudospherical_flow(ALPHA)
    r_u, r_v = asymptotic_tangents(flow)
    along, about = revolution.tangents(flow.meridian, THETA)
    total = added(r_u, scaled(sign, r_v))
    rest = added(r_u, scaled(-sign, r_v))
    return identities(
        setting,
        {
            "d/ds": _difference(total, scaled(2 * flow.s_rate, along)),
            "d/d theta": _difference(rest, scaled(2 * flow.sense * flow.alpha, about)),
        },
        shown="r_u + r_v = 2 (ds/dxi) r_s and r_u - r_v = 2 alpha r_theta",
    )


def proportional_azimuth(setting: Setting, *, power: int = 1) -> Evidence:
    """Rate of the azimuth along unit-speed asymptotic lines where rho'' = rho^power."""
    curve = revolution.generic_meridian()
    rho, rho_s = curve.rho, curve.rho_s
    _, rate = revolution.asymptotic_rates(curve, THETA)
    rate = rate.subs(curve.rho_ss, rho**power)
    change = rho_s * sp.diff(rate, rho) + rho**power * sp.diff(rate, rho_s)
    return identities(
        setting,
        {
            "rate": rate - 1 / (1 + rho**2 - rho_s**2),
            "change of the rate along a meridian": change,
        },
        shown="on any surface of revolution with K = -1, (d theta/dl)^2 = 1/(1 + rho^2 - rho'^2) "
        "along an asymptotic line, and this is the same at every height: theta_u and -theta_v "
        "are one constant",
    )


def normalised(setting: Setting, *, weight: int = -1) -> Evidence:
    """Tangents built from s(u + v) and the printed azimuth: unit speed and asymptotic."""
    flow = pseudospherical_flow(ALPHA)
    curve = flow.meridian
    theta = printed.azimuth(U, V, ALPHA, weight=weight)
    along, about = revolution.tangents(curve, THETA)
    built = [added(scaled(flow.s_rate, along), scaled(sp.diff(theta, x), about)) for x in (U, V)]
    r_u, r_v = asymptotic_tangents(flow)
    normal = meridian_normal()
    ds, dtheta = revolution.asymptotic_rates(curve, THETA)
    return identities(
        setting,
        {
            "r_u": _difference(built[0], r_u),
            "r_v": _difference(built[1], r_v),
            "|r_u|": dot(built[0], built[0]) - 1,
            "|r_v|": dot(built[1], built[1]) - 1,
            "r_uu . N": dot(flow.vector_u(r_u), normal),
            "r_vv . N": dot(flow.vector_v(r_v), normal),
            "ds/dl": ds - flow.s_rate**2,
            "d theta/dl": dtheta - flow.alpha**2,
        },
        shown="with s = s(u + v) and theta = alpha u - alpha v both families are asymptotic and of "
        "unit speed, for every alpha > 0",
    )


def elliptic(setting: Setting, *, modulus: str = "alpha", function: str = "cn") -> Evidence:
    """Arc length as arcsinh(kappa f(xi, m)), f a Jacobi function of parameter m.

    modulus: `alpha` for m = kappa^2/(kappa^2 + 1), `complement` for 1 - m; function: cn or sn.
    """
    amplitude = sp.Symbol("chi", real=True)
    m = {"alpha": KAPPA**2, "complement": sp.Integer(1)}[modulus] / (KAPPA**2 + 1)
    rate_squared = 1 - m * sp.sin(amplitude) ** 2
    y = KAPPA * {"cn": sp.cos, "sn": sp.sin}[function](amplitude)
    ds = sp.sqrt(sp.diff(y, amplitude) ** 2 * rate_squared / (1 + y**2))
    flow = bobbin_flow()
    inclination = flow.psi_rate**2 - rate_squared.subs(amplitude, PSI)
    return identities(
        setting,
        {
            "energy equation": printed.energy(sp.asinh(y), ds, KAPPA),
            "inclination is the amplitude": inclination,
        },
        shown="sinh s = kappa cn(xi, m), m = alpha^2 = kappa^2/(kappa^2 + 1): the meridian's "
        "inclination is Jacobi's amplitude",
    )


def killing(setting: Setting, *, factor: str = "1/2", sign: int = -1) -> Evidence:
    """Field factor/alpha (d_u + sign d_v): its action on theta, s and the metric."""
    flow = pseudospherical_flow(ALPHA)
    r_u, r_v = asymptotic_tangents(flow)

    def field(expr: sp.Expr) -> sp.Expr:
        total = flow.along_u(expr) + sign * flow.along_v(expr)
        return sp.Rational(factor) / flow.alpha * total

    entries = {"g_uu": dot(r_u, r_u), "g_uv": dot(r_u, r_v), "g_vv": dot(r_v, r_v)}
    residuals = {f"Lie derivative of {name}": field(entry) for name, entry in entries.items()}
    return identities(
        setting,
        {"of theta": field(THETA) - 1, "of psi": field(PSI), **residuals},
        shown="(d_u - d_v)/(2 alpha) takes theta to 1 and s to 0, so it is d/d theta; having "
        "constant coefficients and leaving E, F, G fixed, it is a Killing field",
    )


def invariant_scalars(setting: Setting, *, sign: int = -1) -> Evidence:
    """Scalars fixed by d_u + sign d_v, in general and for s and the angle."""
    xi, eta = sp.symbols("xi eta", real=True)
    scalar = sp.Function("q")(xi, eta)
    by_u = sp.diff(scalar, xi) + sp.diff(scalar, eta)
    by_v = sp.diff(scalar, xi) - sp.diff(scalar, eta)
    flow = bobbin_flow()
    r_u, r_v = asymptotic_tangents(flow)

    def field(expr: sp.Expr) -> sp.Expr:
        return flow.along_u(expr) + sign * flow.along_v(expr)

    return identities(
        setting,
        {
            "any scalar": by_u + sign * by_v - 2 * sp.diff(scalar, eta),
            "s": field(arc_length()),
            "r_u . r_v": field(dot(r_u, r_v)),
            "ds/dxi": field(flow.s_rate),
        },
        shown="(d_u - d_v) q = 2 dq/d(u - v): a fixed scalar depends on u + v only, and s, "
        "s', r_u . r_v are fixed",
    )


def half_angles(setting: Setting, *, factor: int = 2, exchanged: bool = False) -> Evidence:
    """Metric in asymptotic coordinates and its two cases, for both sigma."""
    du, dv, phi = sp.symbols("du dv phi", real=True)
    flow = bobbin_flow()
    r_u, r_v = asymptotic_tangents(flow)
    step = added(scaled(du, r_u), scaled(dv, r_v))
    inner, squared = dot(r_u, r_v).subs(THETA, 0), dot(step, step).subs(THETA, 0)
    residuals = {}
    for sigma in SIGNS:
        stated = printed.metric(du, dv, phi, sigma, factor=factor)
        cases = printed.metric_by_half_angles(du, dv, phi, sigma, exchanged=exchanged)
        residuals[f"cases, sigma = {sigma}"] = stated - cases
        measured = stated.subs(sp.cos(phi), sigma * inner)
        residuals[f"induced, sigma = {sigma}"] = measured - squared
    return identities(
        setting, residuals, shown="both equalities hold for sigma = +1 and for sigma = -1"
    )


def first_order(setting: Setting, *, signed: bool = False, about: int = 1) -> Evidence:
    """Both equations for both sigma, where cos phi = sigma r_u . r_v with phi in [0, pi].

    signed: whether the first right side is multiplied by sgn s'.
    """
    flow = bobbin_flow()
    r_u, r_v = asymptotic_tangents(flow)
    inner = dot(r_u, r_v).subs(THETA, 0)
    azimuthal = flow.alpha / KAPPA * sp.cosh(arc_length())
    residuals = {}
    for sigma, branch in product(SIGNS, BRANCHES):
        cos_phi = branch.value(sigma * inner)
        cos_half, sin_half = (_root_of(1 + cos_phi), _root_of(1 - cos_phi))
        climb, turn = printed.first_order(
            cos_half, sin_half, sigma, along=branch.slope if signed else 1, about=about
        )
        name = f"sigma = {sigma:+d}, {branch.name}"
        residuals[f"ds/dxi ({name})"] = branch.value(flow.s_rate) - climb
        residuals[f"(alpha/kappa) cosh s ({name})"] = branch.value(azimuthal) - turn
    return identities(
        setting,
        residuals,
        shown="both equations on the four quarter periods and for both sigma, with the angle "
        "measured between r_u and r_v",
    )


def _root_of(twice_square: sp.Expr) -> sp.Expr:
    return sp.sqrt(sp.factor(twice_square / 2))


def alpha_from_edge(setting: Setting, *, shift: int = 1) -> Evidence:
    """Rate alpha for which (alpha/kappa) cosh s = 1 at the edge, on both sides of it."""
    stated = printed.alpha(KAPPA, shift=shift)
    flow = bobbin_flow()
    r_u, r_v = asymptotic_tangents(flow)
    at_edge = dot(r_u, r_v).subs({PSI: 0, THETA: 0})
    residuals = {
        "azimuthal speed at the edge": stated / KAPPA * sp.cosh(half_length()) - 1,
        "rate of the asymptotic lines": stated - flow.alpha,
    }
    for sigma in SIGNS:
        half_angle_squared = (1 - sigma * (sigma * at_edge)) / 2
        residuals[f"limit from sigma = {sigma}"] = half_angle_squared - 1
    return combined(
        {
            "edge": identities(setting, residuals, shown="alpha = kappa/sqrt(kappa^2 + 1)"),
            "unique": positivity(
                setting, {"cosh L / kappa": (KAPPA**2 + 1) / KAPPA**2}, shown="factor not 0"
            ),
        },
        shown="alpha = kappa/sqrt(kappa^2 + 1) is the only rate with (alpha/kappa) cosh L = 1, and "
        "the one that the asymptotic lines have; sin(phi/2) resp. cos(phi/2) tends to 1",
    )
