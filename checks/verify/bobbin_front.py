"""Checks of Minding's bobbin as a front, its normals and the Lelieuvre equations (eq:NFront)."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import bobbin_front as printed
from checks.verify import bobbin_turning
from checks.verify.bobbin_branches import BRANCHES, SIGNS, W, unit_cross
from theory.bobbin import KAPPA, arc_length, bobbin_flow
from theory.pseudospherical_revolution import (
    PSI,
    THETA,
    U,
    V,
    Z,
    asymptotic_tangents,
    meridian_normal,
    torsion,
)
from theory.vectors import Vector, added, cross, dot, scaled

AZIMUTH = sp.atan(sp.Rational(4, 3))


def _azimuth(sense: int, shift: int = 1) -> sp.Expr:
    return printed.azimuth(U, V, KAPPA, sense=sense, shift=shift)


def _at(a: Vector, sense: int, azimuth: Any = AZIMUTH) -> Vector:
    """Vector of u, v and psi at v = 0 and the u for which the printed azimuth has this value.

    What is printed turns with u - v about the axis, so that one azimuth stands for all; AZIMUTH has
    the cosine 3/5 and the sine 4/5, and tells them apart.
    """
    place = {V: 0, U: sense * azimuth * sp.sqrt(KAPPA**2 + 1) / KAPPA}
    x, y, z = (entry.subs(place, simultaneous=True) for entry in a)
    return (x, y, z)


def _point(sense: int, shift: int = 1) -> Vector:
    return printed.front(bobbin_flow().rho, Z, _azimuth(sense, shift))


def _tangents(sense: int, azimuth: Any = AZIMUTH) -> tuple[Vector, Vector]:
    """Tangents r_u and r_v of the printed front, at this azimuth."""
    flow, r = bobbin_flow(), _point(sense)
    return _at(flow.vector_u(r), sense, azimuth), _at(flow.vector_v(r), sense, azimuth)


def front_surface(setting: Setting, *, sense: int = 1, speed: int = 1, shift: int = 1) -> Evidence:
    """Properties of the printed map: unit speed, asymptotic, the metric of the bobbin."""
    flow, r = bobbin_flow(), _point(sense, shift)
    first_u, first_v = flow.vector_u(r), flow.vector_v(r)
    r_u, r_v = _at(first_u, sense), _at(first_v, sense)
    r_uu = _at(flow.vector_u(first_u), sense)
    r_vv = _at(flow.vector_v(first_v), sense)
    normal = _placed(meridian_normal())
    inner = flow.s_rate**2 - flow.alpha**2 * flow.rho**2
    return identities(
        setting,
        {
            "|r_u|": dot(r_u, r_u) - speed,
            "|r_v|": dot(r_v, r_v) - speed,
            "r_u . r_v": dot(r_u, r_v) - inner,
            "N . r_u": dot(normal, r_u),
            "N . r_v": dot(normal, r_v),
            "N . r_uu": dot(normal, r_uu),
            "N . r_vv": dot(normal, r_vv),
        },
        shown="the map is smooth on R^2, its curves are asymptotic and of unit speed, and it "
        "induces ds^2 + rho^2 d theta^2",
    )


def front_torsions(setting: Setting, *, sense: int = 1, first: int = -1) -> Evidence:
    """Torsions of the printed curves: first on the u-curves, its negative on the v-curves.

    On one quarter period: r and its torsion are analytic in psi.
    """
    flow, r, quarter = bobbin_flow(), _point(sense), BRANCHES[0]
    residuals = {}
    for name, step, wanted in (("u", flow.vector_u, first), ("v", flow.vector_v, -first)):
        jet = [step(r)]
        for _ in range(2):
            jet.append(step(jet[-1]))
        velocity, acceleration, jerk = (quarter.vector(_at(a, sense, 0)) for a in jet)
        found = torsion(velocity, acceleration, jerk)
        residuals[f"{name}-curves, {quarter.name}"] = found - wanted
    return identities(
        setting,
        residuals,
        shown="torsion -1 on the u-curves and +1 on the v-curves, the convention of section 3.1",
    )


def _placed(a: Vector) -> Vector:
    """Vector of theta and psi at the azimuth AZIMUTH."""
    return (a[0].subs(THETA, AZIMUTH), a[1].subs(THETA, AZIMUTH), a[2].subs(THETA, AZIMUTH))


def not_immersed(setting: Setting, *, at: str = "edge") -> Evidence:
    """Where r_u x r_v vanishes, and what the curves u + v = const become; at: edge or throat."""
    r_u, r_v = _tangents(1)
    flow, normal = bobbin_flow(), cross(r_u, r_v)
    places = (0, sp.pi) if at == "edge" else (sp.pi / 2,)
    residuals = {
        "|r_u x r_v|^2": dot(normal, normal) - (2 * flow.alpha * flow.rho * flow.s_rate) ** 2
    }
    for psi in places:
        for i, entry in enumerate(normal):
            residuals[f"(r_u x r_v)[{i}] at psi = {psi}"] = entry.subs(PSI, psi)
    c = sp.Symbol("c", positive=True)
    radius = {
        "rho^2": (flow.rho**2).subs(sp.cos(PSI), c),
        "at the throat": flow.rho.subs(PSI, sp.pi / 2),
    }
    r = _point(1)
    along_circle = added(flow.vector_u(r), scaled(-1, flow.vector_v(r)))
    residuals["circle"] = dot(along_circle, along_circle) - (2 * flow.alpha * flow.rho) ** 2
    residuals["circle's height"] = along_circle[2]
    return combined(
        {
            "singular": identities(setting, residuals, shown="singular at the edges"),
            "only there": positivity(setting, radius, shown="rho > 0"),
        },
        shown="|r_u x r_v| = 2 alpha rho |s'| vanishes exactly where s' = 0; each curve u + v = "
        "const is a circle of constant height and radius rho",
    )


def smooth_curves(setting: Setting, *, speed: int = 1) -> Evidence:
    """Speed 1 through the edges; the radius never vanishes, so that the flow is analytic."""
    r_u, r_v = _tangents(1)
    flow = bobbin_flow()
    c = sp.Symbol("c", positive=True)
    radicand = (flow.rho**2).subs(sp.cos(PSI), c)
    return combined(
        {
            "speed": identities(
                setting,
                {"|r_u|^2": dot(r_u, r_u) - speed, "|r_v|^2": dot(r_v, r_v) - speed},
                shown="unit speed",
            ),
            "analytic": positivity(setting, {"rho^2": radicand}, shown="no root vanishes"),
        },
        shown="along each asymptotic curve r is analytic in the parameter, as psi' = -alpha rho "
        "and rho = sqrt(1 + kappa^2 cos^2 psi)/kappa > 0 are, and |r_u| = |r_v| = 1 everywhere",
    )


def normal_direction(
    setting: Setting, *, multiple: int = 1, sense: int = 1, height: int = 1
) -> Evidence:
    """r_u x r_v as a positive multiple, 2 alpha rho, of the printed vector."""
    flow = bobbin_flow()
    length = 2 * flow.alpha * flow.rho
    stated = printed.normal_direction(
        arc_length(), flow.s_rate, sp.sin(PSI), AZIMUTH, KAPPA, multiple=multiple, height=height
    )
    return identities(
        setting,
        {
            "dz/ds": sp.sin(PSI) * flow.s_rate - flow.z_rate,
            "r_u x r_v": added(cross(*_tangents(sense)), scaled(-length, stated)),
        },
        shown="r_u x r_v is 2 alpha rho > 0 times the vector",
    )


def flips(setting: Setting, *, factor: str = "1") -> Evidence:
    """One-sided limits of the unit vector along r_u x r_v at the turning points.

    factor: `1`, or `sgn s'`, by which the vector is multiplied.
    """
    flow = bobbin_flow()
    r_u, r_v = (_placed(a) for a in asymptotic_tangents(flow))
    residuals = {"dz/ds at the edge": sp.sin(PSI).subs(PSI, 0)}
    for side in SIGNS:
        limits = []
        for branch in (b for b in BRANCHES if b.side == side):
            unit = unit_cross(r_u, r_v, flow, branch)
            sign = 1 if factor == "1" else branch.slope
            x, y, z = (sp.cancel(entry).subs(W, 0) for entry in unit)
            residuals[f"horizontal part, {branch.name}"] = x**2 + y**2
            residuals[f"vertical part, {branch.name}"] = z**2 - 1
            limits.append(sign * z)
        residuals[f"limits at s = {side:+d} L"] = limits[0] + limits[1]
    return identities(
        setting,
        residuals,
        shown="the two one-sided limits at s = +L are e_3 and -e_3, and at s = -L again: the unit "
        "vector along r_u x r_v jumps at every turning point",
    )


def continuous_normal(setting: Setting, *, factor: str = "sgn s'") -> Evidence:
    """Factor times the unit vector along r_u x r_v, on all four quarters, against one analytic map.

    factor: `sgn s'` or `1`.
    """
    flow = bobbin_flow()
    r_u, r_v = (_placed(a) for a in asymptotic_tangents(flow))
    smooth = meridian_normal()
    residuals = {}
    for branch in BRANCHES:
        unit = unit_cross(r_u, r_v, flow, branch)
        signed = scaled(branch.slope if factor == "sgn s'" else 1, unit)
        analytic = scaled(flow.sense, branch.vector(_placed(smooth)))
        residuals[f"same side ({branch.name})"] = added(signed, analytic)
    mixed = added(
        flow.vector_u(flow.vector_v(smooth)), scaled(-1, flow.vector_v(flow.vector_u(smooth)))
    )
    return identities(
        setting,
        {**residuals, "mixed derivatives": _placed(mixed)},
        shown="sgn(s') r_u x r_v/|r_u x r_v| is, on all quarters, one analytic unit vector: "
        "(z_s, -rho_s) in the meridian's plane, or its negative if d theta/du < 0; so it is C^{1M}",
    )


def slope_sign(setting: Setting, *, factor: str = "sgn s'") -> Evidence:
    """dz/ds = z'/s' against factor times its absolute value; factor: `sgn s'` or `1`."""
    flow = bobbin_flow()
    size = sp.sqrt(1 - (sp.sinh(arc_length()) / KAPPA) ** 2)
    residuals = {}
    for branch in BRANCHES:
        sign = branch.slope if factor == "sgn s'" else 1
        residuals[branch.name] = branch.value(flow.z_rate / flow.s_rate - sign * size)
    return identities(
        setting, residuals, shown="z'/s' = sgn(s') sqrt(1 - sinh^2 s/kappa^2) on all quarters"
    )


def _printed_normal(slope: int, sense: int, *, radial: int, power: int, function: str) -> Vector:
    """Vector printed where sgn s' = slope, as a function of u, v and psi: |sin psi| resolved."""
    n_z = printed.normal_height(arc_length(), KAPPA, function=function)
    a = printed.normal(n_z, _azimuth(sense), slope, radial=radial, power=power)
    size = {sp.sqrt(1 - sp.cos(PSI) ** 2): slope * sp.sin(PSI)}
    return (a[0].xreplace(size), a[1].xreplace(size), a[2])


def front_normal(
    setting: Setting, *, sense: int = 1, radial: int = -1, power: int = 2, function: str = "sinh"
) -> Evidence:
    """Agreement of the printed normal with sgn(s') r_u x r_v/|r_u x r_v|, r the printed front."""
    flow = bobbin_flow()
    r_u, r_v = _tangents(sense)
    residuals = {}
    for branch in BRANCHES:
        stated = _printed_normal(branch.slope, sense, radial=radial, power=power, function=function)
        unit = scaled(branch.slope, unit_cross(r_u, r_v, flow, branch))
        here = branch.vector(_at(stated, sense))
        residuals[branch.name] = added(unit, scaled(-1, here))
    return identities(
        setting,
        residuals,
        shown="the printed vector is sigma r_u x r_v/|r_u x r_v| on all quarters",
    )


def lelieuvre(
    setting: Setting, *, sense: int = 1, radial: int = -1, orientation: int = 1
) -> Evidence:
    """Lelieuvre equations for the printed front and normal, on either sign of s'.

    orientation: factor of r_u = N_u x N and r_v = -N_v x N.
    """
    flow = bobbin_flow()
    r_u, r_v = _tangents(sense)
    residuals = {}
    for slope in SIGNS:
        normal = _printed_normal(slope, sense, radial=radial, power=2, function="sinh")
        n_u = _at(flow.vector_u(normal), sense)
        n_v = _at(flow.vector_v(normal), sense)
        here = _at(normal, sense)
        name = f"s' {'>' if slope == 1 else '<'} 0"
        residuals[f"r_u ({name})"] = added(r_u, scaled(-orientation, cross(n_u, here)))
        residuals[f"r_v ({name})"] = added(r_v, scaled(orientation, cross(n_v, here)))
    return identities(
        setting,
        residuals,
        shown="r_u = N_u x N and r_v = -N_v x N for all psi, through the edges",
    )


def figure(
    setting: Setting, *, factor: str = "sgn s'", second: int = 2, third: int = 3
) -> Evidence:
    """Content of the caption: smooth curves, cuspidal edges, a normal continuous on them."""
    return combined(
        {
            "smooth asymptotic curves": smooth_curves(setting),
            "cuspidal edges": bobbin_turning.cusp(setting, second=second, third=third),
            "normal": continuous_normal(setting, factor=factor),
        },
        shown="asymptotic curves analytic through the edges, ordinary cusps of the meridian there, "
        "and a unit normal continuous along the curves",
    )
