"""Checks of section 3.1, items (A) and (B): asymptotic coordinates, unit speed, torsions."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities, statement
from checks.positivity import positivity
from checks.printed import asymptotic_frames as printed
from checks.verify.nets import explicit_nets, minus, squared_norm
from theory.asymptotic_net import Cartesian
from theory.forms import brioschi, determinant, first_form, second_form
from theory.frames import line_torsion, torsion
from theory.gauss_weingarten import R_U, R_V, GaussWeingarten, codazzi_defects
from theory.moutard import Series, column, curve_normals, goursat_series
from theory.surfaces import dini, pseudosphere
from theory.vectors import Vector, added, cross, dot, scaled


def _asymptotic_surface(**changes: Any) -> GaussWeingarten:
    """Surface in asymptotic coordinates of any speed, all coefficients unknown functions."""
    u, v = sp.symbols("u v", real=True)
    E, F, G, f = (sp.Function(name, real=True)(u, v) for name in "EFGf")
    fields = {"u": u, "v": v, "E": E, "F": F, "G": G, "e": 0, "f": f, "g": 0}
    fields["area"] = sp.sqrt(E * G - F**2)
    return GaussWeingarten(**{**fields, **changes})


def _torsions(fields: GaussWeingarten) -> tuple[Any, Any]:
    """Torsions of the coordinate lines as space curves, from three derivatives of position."""
    found = []
    for tangent, along in ((R_U, "u"), (R_V, "v")):
        second = fields.derivative(tangent, along)
        found.append(torsion(fields, tangent, second, fields.derivative(second, along)))
    return found[0], found[1]


def asymptotic_directions(setting: Setting, *, sign: int = -1) -> Evidence:
    """Support of item (A): f^2 - eg = -K (EG - F^2) on any graph, so two directions where K < 0."""
    x, y = sp.symbols("x y", real=True)
    w = sp.Function("w", real=True)(x, y)
    graph = Cartesian(symbols=(x, y), rates={"u": (1, 0), "v": (0, 1)})
    r_x, r_y = (1, 0, w.diff(x)), (0, 1, w.diff(y))
    normal = scaled(1 / sp.sqrt(1 + w.diff(x) ** 2 + w.diff(y) ** 2), cross(r_x, r_y))
    first = first_form(graph, r_x, r_y)
    second = second_form(graph, r_x, r_y, normal)
    e, f, g = sp.symbols("e f g", real=True)
    root = sp.sqrt(f**2 - e * g)
    residuals: dict[str, Any] = {
        "discriminant": -determinant(second)
        - sign * brioschi(first, graph.rate) * determinant(first),
    }
    for which in (1, -1):
        p = -f + which * root
        residuals[f"direction {which:+d}"] = e * p**2 + 2 * f * p * e + g * e**2
    for net in explicit_nets():
        residuals[f"{net.name}: N.r_uu"] = net.calculus.dot(net.normal, net.d(net.r_u, "u"))
        residuals[f"{net.name}: N.r_vv"] = net.calculus.dot(net.normal, net.d(net.r_v, "v"))
    return identities(
        setting,
        residuals,
        shown="the second form has two real null directions "
        "exactly where K < 0, by discriminant -K (EG - F^2) on every graph; they "
        "are coordinate directions on explicit surfaces",
    )


_COLUMNS = 7


def _side(slope: int, v: sp.Symbol) -> dict[str, Vector]:
    """One-sided values on u = 0 for the data phi(u, 0) = pi/2 + slope u, phi(0, v) = pi/2."""
    unit = sp.eye(3)
    along_v = sp.Matrix([unit.row(1), -unit.row(0), unit.row(2)])
    normal: Series = goursat_series(
        curve_normals(unit, -slope, -1, order=2), curve_normals(along_v, 0, 1, order=_COLUMNS)
    )
    n, n_u, n_uu = (column(normal, row, v) for row in range(3))
    n_v = (sp.diff(n[0], v), sp.diff(n[1], v), sp.diff(n[2], v))
    return {
        "N": n,
        "N_u": n_u,
        "N_v": n_v,
        "r_u": cross(n_u, n),
        "r_v": scaled(-1, cross(n_v, n)),
        "N_uu": n_uu,
        "r_uu": cross(n_uu, n),
    }


def _truncated(expr: Any, v: sp.Symbol) -> Any:
    """Terms of a polynomial in v of an order that the series determines."""
    kept = sp.Poly(expr, v).terms()
    return sum((c * v**n for (n,), c in kept if n < _COLUMNS), sp.Integer(0))


def asymptotic_condition(setting: Setting, *, quantity: str = "r_uu") -> Evidence:
    """Item (A) for a C^2 surface: the derivative in the asymptotic condition has to exist.

    The surface carries an angle with a kink, phi(u, 0) = pi/2 + |u|; quantity: the derivative that
    the condition uses, "r_uu" in N.r_uu = 0 as printed, "N_u" in the equivalent N_u.r_u = 0.
    """
    v = sp.Symbol("v", real=True)
    right, left = _side(1, v), _side(-1, v)
    partner = "r_u" if quantity.startswith("N") else "N"
    residuals: dict[str, Any] = {}
    for name in dict.fromkeys(("N", "N_u", "N_v", "r_u", "r_v", quantity)):
        jump = minus(right[name], left[name])
        residuals[f"jump of {name}"] = tuple(_truncated(entry, v) for entry in jump)
    for name, side in (("right", right), ("left", left)):
        product = dot(side[quantity], side[partner])
        residuals[f"{partner}.{quantity} on the {name}"] = _truncated(product, v)
    return identities(
        setting,
        residuals,
        shown=f"on the C^2 surface with phi(u, 0) = pi/2 + |u|, "
        f"phi(0, v) = pi/2, {quantity} is continuous across u = 0 to order "
        f"{_COLUMNS - 1} in v as r_u, r_v, N, N_u and N_v are, and "
        f"{partner}.{quantity} = 0",
    )


def either_normal(setting: Setting, *, second: str = "v", perpendicular: bool = True) -> Evidence:
    """Item (A): both N = +- r_u x r_v / |r_u x r_v| satisfy N.r_uu = N.r_vv = 0.

    second: coordinate by which r_v is differentiated again; perpendicular: whether the cross
    product is that of r_u and r_v, not the sum of the two.
    """
    residuals: dict[str, Any] = {}
    for net in (pseudosphere().net(1), dini(2).net(-1)):
        times = net.calculus.cross
        norm = sp.sqrt(squared_norm(net, times(net.r_u, net.r_v)))
        for sign in (1, -1):
            normal = printed.unit_normal(net.r_u, net.r_v, norm, times, sign=sign)
            if not perpendicular:
                normal = scaled(sign / norm, added(net.r_u, net.r_v))
            where = f"{net.name}, sign {sign:+d}"
            residuals[f"{where}: N.N - 1"] = dot(normal, normal) - 1
            residuals[f"{where}: N.r_u"] = dot(normal, net.r_u)
            residuals[f"{where}: N.r_uu"] = dot(normal, net.d(net.r_u, "u"))
            residuals[f"{where}: N.r_vv"] = dot(normal, net.d(net.r_v, second))
    return identities(
        setting,
        residuals,
        shown="N is a unit normal and satisfies both asymptotic "
        "conditions, whichever sign is chosen",
    )


def normal_across(setting: Setting, *, crosses_edge: bool = False) -> Evidence:
    """Item (A): where r_u x r_v does not vanish, it stays on one side of a continuous normal.

    On the pseudosphere and Dini's surface, whose normal is smooth across the edge e^chi = 1 where
    r_u x r_v vanishes: (r_u x r_v).N at any two places on one side has the same sign;
    crosses_edge: take the two places on either side of the edge instead.
    """
    x = sp.Symbol("exp_chi", positive=True)
    near, far = sp.symbols("t s", positive=True)
    above, below = (1 + near, 1 + far), (1 / (1 + near), 1 / (1 + far))
    pairs = ((above[0], below[1]),) if crosses_edge else (above, below)
    products = {}
    for front in (pseudosphere(), dini(2)):
        net = front.net(1)
        along = net.calculus.dot(net.calculus.cross(net.r_u, net.r_v), net.normal)
        for first, second in pairs:
            where = f"{front.name}, (r_u x r_v).N at e^chi = {first} times that at {second}"
            products[where] = sp.cancel(along.subs(x, first) * along.subs(x, second))
    return positivity(
        setting,
        products,
        shown="(r_u x r_v).N, with the smooth normal N, has one "
        "sign on all of either side of the edge of the pseudosphere and of Dini's "
        "surface, so one choice serves a whole immersed piece",
    )


def unit_speed(
    setting: Setting, *, constant_curvature: bool = True, asymptotic: bool = True
) -> Evidence:
    """Item (B): with K = -1, Codazzi gives E_v = G_u = 0, so both speeds become 1 at once.

    Then r_u.r_u depends on u alone and r_v.r_v on v alone. constant_curvature: whether f^2 =
    EG - F^2, or this times the square of a function; asymptotic: whether e = 0.
    """
    u, v = sp.symbols("u v", real=True)
    E, F, G = (sp.Function(name, real=True)(u, v) for name in "EFG")
    factor = 1 if constant_curvature else sp.Function("tau", real=True)(u, v)
    normal_part = 0 if asymptotic else sp.Function("e", real=True)(u, v)
    fields = _asymptotic_surface(f=factor * sp.sqrt(E * G - F**2), e=normal_part)
    slots = sp.symbols("E_v G_u")
    marked = [
        defect.doit().subs({E.diff(v): slots[0], G.diff(u): slots[1]})
        for defect in codazzi_defects(fields)
    ]
    solved = sp.solve(marked, slots, dict=True)
    if len(solved) != 1:
        return statement(False, shown="", witness=f"E_v and G_u are not determined: {solved}")
    residuals = {str(slot): solved[0].get(slot, slot) for slot in slots}
    residuals["determinant of these equations, plus 1"] = (
        sp.Matrix(marked).jacobian(slots).det() + 1
    )
    return identities(
        setting,
        residuals,
        shown="the Codazzi equations of asymptotic coordinates "
        "with K = -1 have E_v = G_u = 0 as their only solution",
    )


def torsions(setting: Setting, *, magnitude: int = 1, opposite: bool = True) -> Evidence:
    """Item (B), Beltrami-Enneper: where K = -1 the torsions are +-1, opposite to each other.

    On any surface in asymptotic coordinates of any speed, where f^2 = EG - F^2, and on explicit
    surfaces; magnitude: of the torsion; opposite: whether the two families differ in sign.
    """
    relation = 1 if opposite else -1
    residuals: dict[str, Any] = {}
    general = _asymptotic_surface()
    torsion_u, torsion_v = _torsions(general)
    curvature = -(general.f**2) / (general.E * general.G - general.F**2)
    residuals["any K: torsion^2 + K"] = torsion_u**2 + magnitude**2 * curvature
    residuals["any K: sum of torsions"] = torsion_u + relation * torsion_v
    for front in (pseudosphere(), dini(2)):
        net = front.net(1)
        residuals[f"{front.name}: torsion along u"] = line_torsion(net, "u") + magnitude
        residuals[f"{front.name}: torsion along v"] = line_torsion(net, "v") - relation * magnitude
    return identities(
        setting,
        residuals,
        shown="tau^2 = -K along every asymptotic line, with "
        "opposite signs for the two families; +-1 where K = -1",
    )


def labelling(setting: Setting, *, exchange: bool = True, flip: bool = False) -> Evidence:
    """Item (B): the names u and v can be given so that the torsions are -1 and +1.

    From a net with torsions +1 along u and -1 along v; exchange: exchange u and v; flip: u -> -u.
    """
    start = _asymptotic_surface()
    start = _asymptotic_surface(f=start.area)
    before = _torsions(start)
    forms = {"E": start.E, "F": start.F, "G": start.G, "f": start.f, "area": start.area}
    if exchange:
        forms |= {"E": start.G, "G": start.E, "area": -start.area}
    if flip:
        forms |= {"F": -forms["F"], "f": -forms["f"], "area": -forms["area"]}
    after = _torsions(_asymptotic_surface(**forms))
    residuals = {
        "torsion along u before": before[0] - 1,
        "torsion along v before": before[1] + 1,
        "torsion along u after": after[0] + 1,
        "torsion along v after": after[1] - 1,
    }
    return identities(
        setting,
        residuals,
        shown="exchanging the names of u and v exchanges the "
        "torsions, so torsion -1 along u and +1 along v can be had",
    )
