"""The class C^{1M}, weakly harmonic normals, and the fronts that they integrate to."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import fronts as printed
from checks.zero import vanishes
from theory import fronts
from theory.bobbin import bobbin_flow
from theory.moutard import Series, curve_normals, goursat_series
from theory.pseudospherical_revolution import PSI, asymptotic_tangents, meridian_normal
from theory.ridge_functions import Ridge, Ridges, derivative, has_second, pulled_back
from theory.vectors import Vector, added, cross, dot, scaled
from theory.vectors import derivative as vector_derivative

U, V = fronts.U, fronts.V


def _ridge(power: Any, direction: tuple[int, int], *, odd: bool = False) -> Ridge:
    return Ridge(coefficient=sp.Integer(1), direction=direction, power=sp.Rational(power), odd=odd)


def _bumps(power: sp.Rational) -> list[Ridge]:
    """Build |u|^power + |v|^power + (u + v)^2."""
    return [_ridge(power, (1, 0)), _ridge(power, (0, 1)), _ridge(2, (1, 1))]


_CANDIDATES: tuple[tuple[str, Ridges, bool], ...] = (
    ("|u|^(3/2) + |v|^(3/2) + (u+v)^2", _bumps(sp.Rational(3, 2)), True),
    ("|u+v|^(5/2)", (_ridge("5/2", (1, 1)),), True),
    ("|u+v|^(3/2), whose mixed derivative is unbounded", (_ridge("3/2", (1, 1)),), False),
    ("(u-v)|u-v|, whose mixed derivative jumps", (_ridge(2, (1, -1), odd=True),), False),
    ("|u|, whose derivative jumps", (_ridge(1, (1, 0)),), False),
)


def c1m(setting: Setting, *, first: bool = True, mixed: bool = True) -> Evidence:
    """Instances of C^{1M} accepted and near-misses refused."""
    wrong = [
        name
        for name, terms, member in _CANDIDATES
        if printed.is_c1m(terms, first=first, mixed=mixed) != member
    ]
    return statement(
        not wrong,
        shown="two functions of class C^{1M} are accepted; three that fail in one derivative are "
        "refused",
        witness=f"decided wrongly: {', '.join(wrong)}",
    )


def c1m_not_c2(setting: Setting, *, halves: int = 3) -> Evidence:
    """Take |u|^p + |v|^p + (u + v)^2 of class C^{1M}, p = halves/2, at its kinks."""
    power = sp.Rational(halves, 2)
    terms = _bumps(power)
    h = sp.Symbol("h", positive=True)
    slope = derivative(terms[0], 0)
    quotient = sp.limit(slope.coefficient * h**slope.power / h, h, 0)
    second = [has_second(terms, axis) for axis in (0, 1)]
    return statement(
        printed.is_c1m(terms) and not any(second) and quotient == sp.oo,
        shown="for |u|^(3/2) + |v|^(3/2) + (u+v)^2, of class C^{1M}, the difference quotient of "
        "f_u at u = 0 is infinite, and so is that of f_v at v = 0",
        witness=f"with the power {power} the second derivatives exist: the quotient tends to "
        f"{quotient}",
    )


def reparametrised(setting: Setting, *, halves: int = 3, mixing: int = 1) -> Evidence:
    """Take |u|^p, p = halves/2, after u = r + mixing s, v = mixing r - s."""
    terms = [_ridge(sp.Rational(halves, 2), (1, 0))]
    images = ((1, mixing), (mixing, -1))
    determinant = -1 - mixing**2
    moved = pulled_back(terms, images)
    return statement(
        determinant != 0 and printed.is_c1m(terms) and not printed.is_c1m(moved),
        shown="|u|^(3/2) is C^{1M}; after the linear change u = r + s, v = r - s its mixed "
        "derivative is 3/4 |r+s|^(-1/2)",
        witness="the function stays in C^{1M}: its mixed derivative has the power "
        f"{moved[0].power - 2} and the factor {moved[0].direction[0] * moved[0].direction[1]}",
    )


def composite_variable(setting: Setting, *, second: str = "z") -> Evidence:
    """Composite of a product with a rotation, both sides at independent r, s, z."""
    r, s, z = sp.symbols("r s z", real=True)
    left, right = printed.composite(
        lambda u, v: u * v, lambda a, b: (a + b, a - b), r, s, z, second=second
    )
    return identities(
        setting,
        {"h - f o g for f = u v, g = (r + s, r - s)": left - right},
        shown="the two sides are functions of the same variables",
    )


def _normals() -> tuple[tuple[str, Vector, bool], ...]:
    flat = (sp.cos(U), sp.sin(U), sp.Integer(0))
    tilted = (
        sp.Rational(3, 5) * sp.cos(U + V),
        sp.Rational(3, 5) * sp.sin(U + V),
        sp.Rational(4, 5),
    )
    return (
        ("the normal of the pseudosphere", fronts.tractrix_front()[1], True),
        ("(cos(u-v), sin(u-v), 0)", fronts.degenerate_normal(), True),
        ("(cos u, sin u, 0), at rest in v", flat, False),
        ("(3 cos(u+v), 3 sin(u+v), 4)/5", tilted, False),
    )


def _constant(expr: Any) -> Any:
    """Value of an expression of u, v that does not depend on them; raises ValueError if it does."""
    value = expr.subs({U: 0, V: 0})
    if not vanishes(expr - value):
        raise ValueError(f"expected a constant, got {expr}")
    return value


def _squared_speeds(normal: Vector) -> tuple[Any, Any]:
    n_u, n_v = vector_derivative(normal, U), vector_derivative(normal, V)
    return _constant(dot(n_u, n_u)), _constant(dot(n_v, n_v))


def normal_speeds(setting: Setting, *, families: int = 2) -> Evidence:
    """Instances of property 1 accepted and a near-miss, at rest along v, refused."""
    wrong = [
        name
        for name, normal, _ in _normals()
        if printed.speeds_are_positive(_squared_speeds(normal), families=families)
        != ("at rest" not in name)
    ]
    return statement(
        not wrong,
        shown="three normals that move along u and along v are accepted, one that moves along u "
        "only is refused",
        witness=f"decided wrongly: {', '.join(wrong)}",
    )


def _is_weakly_harmonic(normal: Vector, *, speeds: bool, moutard: bool) -> bool:
    mixed = vector_derivative(normal, U, V)
    if speeds and not printed.speeds_are_positive(_squared_speeds(normal)):
        return False
    residual = printed.moutard_residual(normal, mixed, dot(normal, mixed))
    return not moutard or all(vanishes(entry) for entry in residual)


def weakly_harmonic(setting: Setting, *, speeds: bool = True, moutard: bool = True) -> Evidence:
    """Instances of weakly harmonic normals accepted and near-misses refused."""
    wrong = [
        name
        for name, normal, member in _normals()
        if _is_weakly_harmonic(normal, speeds=speeds, moutard=moutard) != member
    ]
    return statement(
        not wrong,
        shown="the normal of the pseudosphere and one of rank 1 are accepted; a map at rest along "
        "v and one onto a small circle are refused",
        witness=f"decided wrongly: {', '.join(wrong)}",
    )


def _reduced(vector: Vector, *, harmonic: bool) -> list[Any]:
    """Entries of a vector at azimuth 0, with theta_uv, psi_uv of a Moutard normal put in."""
    rules = fronts.moutard_rules() if harmonic else {}
    return [sp.sympify(entry).doit().subs(rules) for entry in fronts.at_azimuth_0(vector)]


def moutard(setting: Setting, *, sign: int = -1, harmonic: bool = True) -> Evidence:
    """Factor nu of the Moutard equation, for every N with N x N_uv = 0."""
    normal = fronts.generic_normal()
    n_u, n_v = vector_derivative(normal, U), vector_derivative(normal, V)
    mixed = vector_derivative(normal, U, V)
    nu = sign * dot(n_u, n_v)
    residual = printed.moutard_residual(normal, mixed, nu)
    return identities(
        setting,
        {"N_uv - nu N": _reduced(residual, harmonic=harmonic)},
        shown="where N_uv is parallel to N the factor is nu = -N_u . N_v, continuous with N of "
        "class C^1",
    )


def front_exists(
    setting: Setting, *, sign_v: int = -1, harmonic: bool = True, simply_connected: bool = True
) -> Evidence:
    """Lelieuvre form of a weakly harmonic normal: closed, and exact on a simply connected D.

    simply_connected: without it, the cylinder (u, v) = (u + 2 pi, v) is admitted too.
    """
    normal = fronts.generic_normal()
    n_u, n_v = vector_derivative(normal, U), vector_derivative(normal, V)
    rates = printed.lelieuvre(normal, n_u, n_v, sign_v=sign_v)
    gap = fronts.closure(rates)
    mixed = added(vector_derivative(rates[0], V), scaled(-1, cross(n_u, n_v)))
    parts = {
        "closed": identities(
            setting,
            {
                "r_uv - r_vu": _reduced(gap, harmonic=harmonic),
                "r_uv - N_u x N_v": _reduced(mixed, harmonic=harmonic),
            },
            shown="the form is closed",
        )
    }
    if not simply_connected:
        loop = fronts.period(fronts.front_rates(fronts.degenerate_normal()), (2 * sp.pi, 0))
        parts["loop"] = identities(setting, {"period along u": loop}, shown="no periods")
    return combined(
        parts,
        shown="r_u du + r_v dv is closed for every N with N x N_uv = 0, so that r exists on a "
        "simply connected D; its mixed derivative N_u x N_v is continuous",
    )


def weakly_regular(setting: Setting, *, sign_v: int = -1, stretch: int = 1) -> Evidence:
    """Speeds of the front against those of an arbitrary unit normal."""
    normal = fronts.generic_normal()
    n_u, n_v = vector_derivative(normal, U), vector_derivative(normal, V)
    r_u, r_v = printed.lelieuvre(normal, n_u, n_v, sign_v=sign_v)
    return identities(
        setting,
        {
            "r_u . r_u - N_u . N_u": dot(r_u, r_u) - stretch * dot(n_u, n_u),
            "r_v . r_v - N_v . N_v": dot(r_v, r_v) - stretch * dot(n_v, n_v),
        },
        shown="r_u . r_u = N_u . N_u and r_v . r_v = N_v . N_v: the front is weakly regular",
    )


def immersion(setting: Setting, *, sign: int = -1, sign_v: int = -1) -> Evidence:
    """Cross product r_u x r_v of a front against sign N_u x N_v."""
    normal = fronts.generic_normal()
    n_u, n_v = vector_derivative(normal, U), vector_derivative(normal, V)
    r_u, r_v = printed.lelieuvre(normal, n_u, n_v, sign_v=sign_v)
    gap = added(cross(r_u, r_v), scaled(-sign, cross(n_u, n_v)))
    return identities(
        setting,
        {"r_u x r_v + N_u x N_v": gap},
        shown="r_u x r_v = -N_u x N_v for every unit N: r is an immersion exactly where N is",
    )


def _from_axes(curvature: int, *, order: int) -> Series:
    """Goursat series of N from a u-axis of this curvature and a straight v-axis, at acos(3/5)."""
    along_u = sp.Matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    along_v = sp.Matrix([[3, 4, 0], [-4, 3, 0], [0, 0, 5]]) / 5
    return goursat_series(
        curve_normals(along_u, curvature, -1, order=order),
        curve_normals(along_v, 0, 1, order=order),
    )


def _glue(curvature: int, *, order: int = 3) -> tuple[bool, bool]:
    """Whether the series for curvature 0 and for this one share N and N_u on u = 0, and N_uu."""
    first, second = _from_axes(0, order=order), _from_axes(curvature, order=order)
    same = [all(first[i, j] == second[i, j] for j in range(order + 1)) for i in range(3)]
    return same[0] and same[1], same[2]


def generalises(
    setting: Setting, *, halves: int = 3, straight: bool = False, curvature: int = 1
) -> Evidence:
    """Weakly harmonic normals of class C^{1M} that are not C^2, on both sides of the kink.

    The rank-one normal with u replaced by u + |u|^p, p = halves/2; straight: u itself, instead.
    And normals of rank two whose u-axis has the curvature 0 for u < 0, and curvature for u > 0.
    """
    power = sp.Rational(halves, 2)
    kink = [] if straight else [_ridge(power, (1, 0))]
    terms = [_ridge(1, (1, 0), odd=True), *kink]
    f = sp.Function("f")(U)
    normal = (sp.cos(f - V), sp.sin(f - V), sp.Integer(0))
    parallel = cross(normal, vector_derivative(normal, U, V))
    smooth = all(has_second([term], 0) for term in kink)
    meets, meets_twice = _glue(curvature)
    return statement(
        all(vanishes(entry) for entry in parallel)
        and printed.is_c1m(terms)
        and meets
        and not smooth
        and not meets_twice,
        shown="N = (cos(f(u) - v), sin(f(u) - v), 0) is weakly harmonic for every increasing f of "
        "class C^1, and not C^2 for f = u + |u|^(3/2) near 0; two normals of rank 2 whose u-axes "
        "start with the curvatures 0 and 1 share N and N_u on u = 0 (to order 3 in v), not N_uu, "
        "so that glued there they are no C^2 map",
        witness="this normal is C^2: nothing new",
    )


def pseudosphere(setting: Setting, *, sign_v: int = -1, at: int = 0) -> Evidence:
    """Tractrix front: Lelieuvre equations, unit speeds, and rank one on the circle u + v = at."""
    front, normal = fronts.tractrix_front()
    n_u, n_v = vector_derivative(normal, U), vector_derivative(normal, V)
    rates = printed.lelieuvre(normal, n_u, n_v, sign_v=sign_v)
    r_u, r_v = vector_derivative(front, U), vector_derivative(front, V)
    on_edge = [entry.subs(V, at - U) for entry in cross(r_u, r_v)]
    return identities(
        setting,
        {
            "r_u - N_u x N": added(r_u, scaled(-1, rates[0])),
            "r_v + N_v x N": added(r_v, scaled(-1, rates[1])),
            "r_u . r_u - 1": dot(r_u, r_u) - 1,
            "r_u x r_v on the edge": on_edge,
        },
        shown="the pseudosphere with its edge is a front on the whole plane, regular along both "
        "families and no immersion on u + v = 0",
    )


def bobbin(setting: Setting, *, sign_v: int = -1, inclination: int = 0) -> Evidence:
    """Bobbin through its edges, in the inclination psi of the meridian; 12 psi = pi inclination.

    Lelieuvre equations with the normal that is smooth across the edge, unit speeds, and rank one
    at the edge psi = 0.
    """
    flow = bobbin_flow(sense=-1)
    normal = meridian_normal()
    n_u, n_v = flow.vector_u(normal), flow.vector_v(normal)
    r_u, r_v = asymptotic_tangents(flow)
    rates = printed.lelieuvre(normal, n_u, n_v, sign_v=sign_v)
    angle = sp.pi * sp.Rational(inclination, 12)
    return identities(
        setting,
        {
            "r_u - N_u x N": added(r_u, scaled(-1, rates[0])),
            "r_v + N_v x N": added(r_v, scaled(-1, rates[1])),
            "r_u . r_u - 1": dot(r_u, r_u) - 1,
            "r_u x r_v at the edge": [e.subs(PSI, angle) for e in cross(r_u, r_v)],
        },
        shown="the bobbin is a front through its edges, regular along both families and no "
        "immersion where the meridian is horizontal",
    )
