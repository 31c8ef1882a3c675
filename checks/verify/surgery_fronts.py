"""Checks of section 3.4 for all data: speeds, fronts along glued edges, immersion, edges in R^3."""

from fractions import Fraction
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import surgery as printed
from checks.verify.nets import general_nets, minus
from checks.verify.surgery_gluing import samples
from theory import frames, fronts
from theory.vectors import Vector, added, cross, derivative, dot, scaled

U, V = fronts.U, fronts.V
_STEP = sp.Symbol("h", real=True)
_PLACE = sp.symbols("z_1:4", real=True)


def _moutard(entries: Vector) -> list[Any]:
    """Entries at azimuth 0, with the mixed derivatives of a Moutard normal put in."""
    rules = fronts.moutard_rules()
    return [sp.sympify(e).doit().subs(rules) for e in fronts.at_azimuth_0(entries)]


def data_at_the_point(setting: Setting, *, shift: bool = False, second: str = "v") -> Evidence:
    """t_u and t_v are perpendicular to n_1, for every unit normal.

    shift: whether n_1 is the normal at a point slightly off along the other coordinate; second:
    "v" for t_v, "uv" for the mixed derivative of r in its place.
    """
    normal = fronts.generic_normal()
    t_u, t_v = fronts.front_rates(normal)
    if second == "uv":
        t_v = cross(derivative(normal, U), derivative(normal, V))
    off_u, off_v = (
        added(normal, scaled(_STEP if shift else 0, derivative(normal, x))) for x in (V, U)
    )
    return identities(
        setting,
        {
            "n_1.n_1 - 1": dot(normal, normal) - 1,
            "t_u.n_1": dot(t_u, off_u),
            "t_v.n_1": dot(t_v, off_v),
        },
        shown="t_u and t_v, from the Lelieuvre equations, are perpendicular to the unit normal at "
        "the same point, for every normal",
    )


def conserved_speeds(
    setting: Setting, *, harmonic: bool = True, crosswise: bool = True
) -> Evidence:
    """Along the other coordinate N_u.N_u and N_v.N_v do not change, and N stays a unit vector.

    harmonic: whether N_uv is parallel to N; crosswise: along the other coordinate or the same.
    """
    normal = fronts.generic_normal()
    rates = {U: derivative(normal, U), V: derivative(normal, V)}
    residuals: dict[str, Any] = {}
    for along, other, name in ((U, V, "u"), (V, U, "v")):
        changed = derivative(rates[along], other if crosswise else along)
        first = _moutard(changed) if harmonic else fronts.at_azimuth_0(changed)
        second = fronts.at_azimuth_0(rates[along])
        residuals[f"N_{name}.N_{name}"] = dot((first[0], first[1], first[2]), second)
    free = _any_field()
    speed = dot(derivative(free, U), derivative(free, V))
    defect = minus(derivative(free, U, V), scaled(-speed, free))
    excess = dot(free, free) - 1
    residuals["(N.N - 1)_uv"] = sp.diff(excess, U, V) - 2 * dot(free, defect) + 2 * speed * excess
    return identities(
        setting,
        residuals,
        shown="where N_uv = -(N_u.N_v) N the excess e = N.N - 1 obeys e_uv = -2 (N_u.N_v) e, so it "
        "stays 0 with the data, and the speeds of N are those of the data: N never comes to rest",
    )


def _any_field() -> Vector:
    first, second, third = (sp.Function(f"n{i}", real=True)(U, V) for i in range(3))
    return (first, second, third)


def two_solutions(setting: Setting, *, last: bool = True, sign: int = -1) -> Evidence:
    """Two solutions with the same data: their difference D obeys a linear homogeneous equation.

    last: whether the term (M_u.M_v) D is there; sign: of N_uv = sign (N_u.N_v) N.
    """
    n, x, y = ((sp.symbols(f"{a}_1:4", real=True)) for a in "NXY")
    m, p, q = ((sp.symbols(f"{a}_1:4", real=True)) for a in "MPQ")
    gap = minus(scaled(sign * dot(x, y), n), scaled(sign * dot(p, q), m))
    terms = added(scaled(dot(minus(x, p), y), n), scaled(dot(p, minus(y, q)), n))
    linear = scaled(-1, added(terms, scaled(dot(p, q) if last else 0, minus(n, m))))
    return identities(
        setting,
        {"D_uv": minus(gap, linear)},
        shown="D_uv = -(D_u.N_v) N - (M_u.D_v) N - (M_u.M_v) D for the difference of two "
        "solutions N and M: bounded coefficients, so by Gronwall D = 0 with its data",
    )


def normal_along_u(
    setting: Setting, *, shifted: bool = True, runs_to: str = "u_max - u*"
) -> Evidence:
    """Data N_1(u, 0) = N_0(chi_1(u, 0)): where they are taken, and the front that they give.

    shifted: whether chi_1 adds u*; runs_to: end of the interval of u.
    """
    for s in samples(setting):
        _, _, chi = printed.attaching_maps(s, fourth=2, shifts="u,v" if shifted else "v")["chi_1"]
        end = {"u_max - u*": s.u_max - s.u, "u_max": s.u_max}[runs_to]
        for u in (Fraction(0), end / 3, end):
            place = chi(u)[1]
            if place != (s.u + u, s.v) or not place[0] <= s.u_max:
                return statement(False, shown="", witness=f"u* = {s.u}, u_max = {s.u_max}: N_1 at "
                                 f"({u}, 0) is taken at {place[0]}, {place[1]}")  # fmt: skip
    return _front_of_tractrix(setting)


def _front_of_tractrix(setting: Setting) -> Evidence:
    """Pseudosphere as r_0: the data N_0(u* + u, v*) give back the u-line of r_0."""
    front, normal = fronts.tractrix_front()
    a, b, u = sp.symbols("u_0 v_0 u", positive=True)
    there = {U: a + u, V: b}
    data = _at(normal, there)
    corner = _at(normal, {U: a, V: b})
    return identities(
        setting,
        {
            "N_1(0, 0) - n_1": minus(_at(data, {u: sp.Integer(0)}), corner),
            "r_1' - r_0'": minus(
                cross(derivative(data, u), data), _at(derivative(front, U), there)
            ),
        },
        shown="chi_1 takes [0, u_max - u*] to the u-edge of Omega^*; on the pseudosphere the "
        "normals copied from there start with n_1 and integrate to its u-line",
    )


def _at(a: Vector, values: dict[Any, Any]) -> Vector:
    x, y, z = (sp.sympify(entry).subs(values, simultaneous=True) for entry in a)
    return (x, y, z)


def value_along_v(
    setting: Setting, *, sign: int = -1, swapped: bool = False, ray: str = "e_v", tilt: int = 0
) -> Evidence:
    """Normal along a straight v-line with direction e_v, from the formula.

    sign: of the sine; swapped: sine and cosine exchanged; ray: the one that the edge follows, e_v
    or e_u; tilt: normal part of e_v.
    """
    v, a, b = sp.symbols("v a b", real=True)
    n: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(1))
    e_v: Vector = (sp.cos(a), sp.sin(a), sp.Integer(tilt))
    edge = e_v if ray == "e_v" else (sp.cos(b), sp.sin(b), sp.Integer(0))
    cosine, sine = (sp.sin(v), sp.cos(v)) if swapped else (sp.cos(v), sp.sin(v))
    normal = printed.straight_normal_v(cosine, sine, n, e_v, sign=sign)
    tangent = scaled(-1, cross(derivative(normal, v), normal))
    twist = minus(derivative(normal, v), scaled(-1, cross(normal, edge)))
    return identities(
        setting,
        {
            "N.N - 1": dot(normal, normal) - 1,
            "r_v - e": minus(tangent, edge),
            "N_v + N x r_v": twist,
            "N(0) - n_1": minus(_at(normal, {v: sp.Integer(0)}), n),
        },
        shown="the formula is a unit normal that starts with n_1, turns by N_v = -N x r_v, and has "
        "the straight line along e_v as its front",
    )


def fronts_agree(
    setting: Setting, *, outer: int = 1, chart: int = 1, start: bool = True
) -> Evidence:
    """N equal along the edge implies r equal, r_outer being composed with chi.

    outer: number of the front that follows chi: 1 as printed, 0 for r_0; chart: number of the
    attaching map; start: whether r_1(0, 0) = r_0(u*, v*).
    """
    domain = "Omega*" if outer == 0 else f"Omega_{outer}"
    for s in samples(setting):
        source, axis, chi = printed.attaching_maps(s, fourth=2)[f"chi_{chart}"]
        lands, (u, v) = chi(Fraction(0))
        if (lands, source) != (domain, "Omega_1"):
            far = printed.new_domains(s)[source][0 if axis == "u" else 1]
            return statement(
                False,
                shown="",
                witness=f"chi_{chart} maps an edge of {source} into {lands}, its first value is "
                f"({u}, {v}) at u* = {s.u}, v* = {s.v}: a function on {domain} cannot follow it, "
                f"the edge being [0, {far}] x {{0}}",
            )
    normal = _along(fronts.generic_normal())
    copied = derivative(normal, U)
    rate_1 = cross(copied, normal)
    rate_0 = _along(fronts.front_rates(fronts.generic_normal())[0])
    first = _PLACE if start else (0, 0, 0)
    return identities(
        setting,
        {"(r_1 - r_0 o chi_1)'": minus(rate_1, rate_0), "at (0, 0)": minus(first, _PLACE)},
        shown="where N_1 = N_0 o chi_1 on the edge, r_1 and r_0 o chi_1 have the same derivative "
        "and the same start, for every N_0",
    )


def _along(a: Vector) -> Vector:
    """Restriction of a field to a u-line, v being held."""
    held = sp.Symbol("v_0", real=True)
    x, y, z = (sp.sympify(entry).doit().subs(V, held) for entry in a)
    return (x, y, z)


def _edge_angle(setting: Setting, end: sp.Rational) -> Evidence:
    """Angle of Omega_1 at the end of its inherited edge, for a right angle at the point.

    It changes along the edge as the angle of r_0 does, kappa_u being -phi_u for both; end: tangent
    of half the angle of r_0 at the end of the edge, 1 at the point.
    """
    bends = {
        f"kappa_u + phi_u, sigma = {net.sigma:+d}": net.geodesic_curvature("u")
        + net.angle_rate("u")
        for net in general_nets()
    }
    _, e_v = printed.trisecting((1, 0, 0), (0, 1, 0))
    outer = sp.Rational(e_v[1], e_v[0])
    lost = (1 - end**2) / (2 * end)
    return combined(
        {
            "same change": identities(setting, bends, shown="kappa_u = -phi_u"),
            "at the end": statement(
                bool(outer > lost),
                shown="positive",
                witness=f"t_u and t_v at a right angle, an edge along which the angle of r_0 falls "
                f"to 2 atan({end}), by atan({lost}): the angle of r_1 starts with atan({outer}) "
                "and reaches 0 before the end, N_u x N_v vanishes there",
            ),
        },
        shown="N_u x N_v is not 0 on the edge",
    )


def immersed(
    setting: Setting,
    *,
    order: str = "u,v,u,v",
    transversal: bool = True,
    sign: int = -1,
    edge_end: str = "3/4",
) -> Evidence:
    """K = -1, sectors side by side, and a Lipschitz normal, where N_u x N_v is not 0.

    order: families of the rays t_u, e_v, e_u, t_v as the angle grows; transversal: whether t_u and
    t_v are not parallel; sign: of N_u x N_v = sign r_u x r_v; edge_end: where an inherited edge
    ends, so that N_u x N_v does or does not vanish on it.
    """
    normal = fronts.generic_normal()
    n_u, n_v = derivative(normal, U), derivative(normal, V)
    r_u, r_v = fronts.front_rates(normal)
    gauss = identities(
        setting,
        {"N_u x N_v - K r_u x r_v": minus(cross(n_u, n_v), scaled(sign, cross(r_u, r_v)))},
        shown="the Gauss map multiplies areas by -1",
    )
    t = sp.Symbol("t", positive=True)
    slope = t if transversal else sp.Integer(0)
    t_u: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
    t_v: Vector = ((1 - slope**2) / (1 + slope**2), 2 * slope / (1 + slope**2), sp.Integer(0))
    e_u, e_v = printed.trisecting(t_u, t_v)
    between = (e_v, e_u) if order == "u,v,u,v" else (e_u, e_v)
    rays = (t_u, *between, t_v)
    sines = {f"sector {k}": cross(rays[k - 1], rays[k])[2] for k in (1, 2, 3)}
    return combined(
        {
            "curvature": gauss,
            "sectors": positivity(setting, sines, shown="no overlap"),
            "edge": _edge_angle(setting, sp.Rational(edge_end)),
        },
        shown="K = -1 for every front; at the point the three sectors follow one another within "
        "the angle cut out, with r_u x r_v.N of alternating signs: no two overlap, and N, "
        "continuous and C^1 on closed faces, is Lipschitz",
    )


def _reduction(setting: Setting) -> Evidence:
    """On an Amsler surface phi_u grows along v from 0 at the rate x F'' + F' = sin F > 0."""
    x = sp.Symbol("x", real=True)
    unknown = sp.Function("F")
    field = unknown(U * V)
    right = x * unknown(x).diff(x, 2) + unknown(x).diff(x)
    return identities(
        setting,
        {"phi_uv": (field.diff(U, V) - right.subs(x, U * V)).doit(),
         "phi_u on v = 0": field.diff(U).doit().subs(V, 0).doit()},
        shown="phi_u > 0 where v > 0",
    )  # fmt: skip


def inherited_edges(
    setting: Setting, *, on_axis: bool = False, edge: str = "inherited"
) -> Evidence:
    """Curvature in R^3 of the edges at a point of an Amsler surface, off its axes.

    on_axis: whether the point lies on an axis; edge: inherited from r_0, or new and straight.
    """
    parts = {}
    for net in general_nets():
        bend = net.d(net.r_u, "u")
        kappa = net.angle_rate("u")
        squared = frames.curvature_squared(net.calculus, net.r_u, bend)
        parts[f"kappa^2, sigma = {net.sigma:+d}"] = identities(
            setting, {"curvature^2 - phi_u^2": squared - kappa**2}, shown="|phi_u|"
        )
    v, rate = sp.symbols("v F_1", positive=True)
    height = sp.Integer(0) if on_axis else v
    phi_u = height * rate if edge == "inherited" else sp.Integer(0)
    parts["reduction"] = _reduction(setting)
    parts["curved"] = positivity(setting, {"phi_u^2 = (v F'(uv))^2": phi_u**2}, shown="not 0")
    return combined(
        parts,
        shown="an asymptotic line has curvature |phi_u|, which on an Amsler surface is v F'(uv), "
        "positive off the axes: the inherited edges are curved, the new ones straight",
    )
