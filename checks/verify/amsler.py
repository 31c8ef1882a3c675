"""Amsler sectors: sine-Gordon from the corner, its reduction, and where the front is immersed."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities, statement
from checks.printed import amsler as printed
from theory import amsler
from theory.bobbin import KAPPA, S, bobbin
from theory.curvature import intrinsic_curvature
from theory.surface_of_revolution import asymptotic_rates

U, V, PHI0 = amsler.U, amsler.V, amsler.PHI0
ORDER = 6


def _angle() -> Any:
    """Unknown angle of a net, positive, so that a witness takes it from (0, pi)."""
    return sp.Function("phi", positive=True)(U, V)


def _with_corner(expr: Any) -> Any:
    """Expression by phi_0 where it was by sin phi_0 and cos phi_0."""
    return expr.subs({amsler.S0: sp.sin(PHI0), amsler.C0: sp.cos(PHI0)})


def _curvatures_of_edges(on_u: Any, on_v: Any) -> tuple[Any, Any]:
    """Curvatures of the edges v = 0 and u = 0 with phi - phi_0 = on_u, on_v there, sigma = 1."""
    phi = _angle()
    found = []
    for curvature, data in zip(amsler.edge_curvatures(phi, sigma=1), (on_u, on_v), strict=True):
        slopes = {
            sp.diff(phi, U): sp.diff(data, U),
            sp.diff(phi, V): sp.diff(data, V),
            phi: PHI0 + data,
        }
        found.append(sp.simplify(curvature.subs(slopes)))
    return found[0], found[1]


_SECTORS = (
    ("constant angle on both edges", sp.Integer(0), sp.Integer(0), 2),
    ("angle phi_0 + u on the u-edge", U, sp.Integer(0), 1),
    ("angle phi_0 + v^2 on the v-edge", sp.Integer(0), V**2, 1),
    ("angles phi_0 + u and phi_0 - v", U, -V, 0),
)


def amsler_sector(setting: Setting, *, straight_edges: int = 2) -> Evidence:
    """Instances and near-misses of an Amsler sector, by the curvature of their edges."""
    return _sorted_out(printed.is_amsler_sector, 2, straight_edges)


def pseudo_amsler_sector(setting: Setting, *, straight_edges: int = 1) -> Evidence:
    """Instances and near-misses of a pseudo-Amsler sector, by the curvature of their edges."""
    return _sorted_out(printed.is_pseudo_amsler_sector, 1, straight_edges)


def _sorted_out(accepts: Any, wanted: int, straight_edges: int) -> Evidence:
    wrong = [
        name
        for name, on_u, on_v, straight in _SECTORS
        if accepts(_curvatures_of_edges(on_u, on_v), straight_edges=straight_edges)
        != (straight >= wanted)
    ]
    return statement(
        not wrong,
        shown=f"of four sectors with Goursat data at hand, those with at least {wanted} straight "
        "edges are accepted and the others are refused",
        witness=f"decided wrongly: {', '.join(wrong)}",
    )


def construction(setting: Setting, *, sign: int = 1, tilt_u: int = 0, tilt_v: int = 0) -> Evidence:
    """Curvature -1 from the sine-Gordon equation, and straight edges from constant data."""
    phi = _angle()
    metric = amsler.chebyshev_metric(phi, sigma=1)
    curvature = intrinsic_curvature(metric, (U, V)).subs(
        sp.diff(phi, U, V), printed.sine_gordon(phi, sign=sign)
    )
    data = printed.boundary_data(PHI0, U, V, tilt_u=tilt_u, tilt_v=tilt_v) - PHI0
    edges = _curvatures_of_edges(data.subs(V, 0), data.subs(U, 0))
    return identities(
        setting,
        {"Gauss curvature + 1": curvature + 1, "curvatures of the edges": edges},
        shown="phi_uv = sin phi gives K = -1, hence (fundamental theorem of surfaces used) a "
        "front, and constant phi on the axes two straight edges",
    )


def self_similar(setting: Setting, *, power_v: int = 1, combination: str = "product") -> Evidence:
    """Goursat solution as a function of z alone: symmetry of the problem, and its series."""
    shift = sp.Symbol("c", positive=True)
    z = printed.similarity_variable(U, V, power_v=power_v, combination=combination)
    moved = z.subs({U: shift * U, V: V / shift}, simultaneous=True)
    series = _with_corner(amsler.goursat_series(ORDER))
    along_level = sp.diff(series, U) * sp.diff(z**2, V) - sp.diff(series, V) * sp.diff(z**2, U)
    return identities(
        setting,
        {
            "z^2 is unchanged by (u, v) -> (c u, v/c)": moved**2 - z**2,
            "phi is constant along the lines z = const": sp.expand(along_level),
        },
        shown="z has the symmetry (u, v) -> (c u, v/c) of the problem, and the Taylor series of "
        f"phi to degree {ORDER} in each variable, found without the ansatz, depends on z only",
    )


def operator(setting: Setting, *, first: int = 1, second: int = 1, scale: int = 2) -> Evidence:
    """Mixed derivative of an unknown function of z, by the chain rule."""
    u, v, z = sp.symbols("u v z", positive=True)
    f = sp.Function("f")
    at = printed.similarity_variable(u, v, scale=scale)
    claimed = printed.mixed_operator(f(z), z, first=first, second=second).doit()
    first_derivative, second_derivative = sp.symbols("f1 f2", real=True)

    def flattened(expr: Any) -> Any:
        return expr.subs(
            {sp.diff(f(z), z, 2): second_derivative, sp.diff(f(z), z): first_derivative}
        )

    chain = second_derivative * sp.diff(at, u) * sp.diff(at, v) + first_derivative * sp.diff(
        at, u, v
    )
    return identities(
        setting,
        {"chain rule minus operator": chain - flattened(claimed).subs(z, at)},
        shown="on functions of z = 2 sqrt(u v), d_uv is d_zz + d_z/z",
    )


def reduction(setting: Setting, *, damping: int = 1, sine: int = -1) -> Evidence:
    """PIII for functions of z, by the chain rule from phi_uv = sin phi."""
    u, v = sp.symbols("u v", positive=True)
    f, df, ddf = sp.symbols("f f1 f2", real=True)
    at = 2 * sp.sqrt(u * v)
    mixed = ddf * sp.diff(at, u) * sp.diff(at, v) + df * sp.diff(at, u, v)
    claimed = printed.painleve(f, df, ddf, at, damping=damping, sine=sine)
    return identities(
        setting,
        {"phi_uv - sin phi minus PIII": mixed - sp.sin(f) - claimed},
        shown="on functions of z the sine-Gordon equation is PIII",
    )


def painleve_series(setting: Setting, *, damping: int = 1, sine: int = -1) -> Evidence:
    """PIII on the double Taylor series of the Goursat problem, set to u = v = z/2."""
    z = sp.Symbol("z", positive=True)
    psi = sp.expand(amsler.goursat_series(ORDER).subs({U: z / 2, V: z / 2}))
    f = PHI0 + psi
    left = printed.painleve(f, sp.diff(f, z), sp.diff(f, z, 2), z, damping=damping, sine=0)
    step, power, sines = sp.Poly(psi, z), sp.Poly(1, z), sp.Poly(0, z)
    for k in range(2 * ORDER):
        sines += power * (amsler.S0, amsler.C0, -amsler.S0, -amsler.C0)[k % 4]
        power = (power * step * sp.Rational(1, k + 1)).rem(sp.Poly(z ** (2 * ORDER), z))
    residual = sp.Poly(sp.expand(left), z) + sine * sines
    low = [_with_corner(residual.coeff_monomial(z**k)) for k in range(2 * ORDER - 1)]
    return identities(
        setting,
        {"Taylor coefficients of PIII": low},
        shown=f"the Goursat series satisfies PIII to order z^{2 * ORDER - 2}",
    )


def painleve_normal_form(setting: Setting, *, damping: int = 1, halves: int = 1) -> Evidence:
    """Find the constants of Painleve III for w = exp(i phi halves/2), if there are any.

    w''/w - (w'/w)^2 + w'/(z w) = i m (phi'' + phi'/z) and sin phi = (w^(1/m) - w^(-1/m))/(2 i),
    to be compared with (alpha w + beta/w)/z + gamma w^2 + delta/w^2.
    """
    z, w = sp.symbols("z w", positive=True)
    df = sp.Symbol("f1", real=True)
    m = sp.Rational(halves, 2)
    constants = sp.symbols("alpha beta gamma delta")
    phi_2 = sp.solve(
        printed.painleve(sp.Symbol("f"), df, sp.Symbol("g"), z, damping=damping), sp.Symbol("g")
    )[0]
    sine = (w ** (1 / m) - w ** (-1 / m)) / (2 * sp.I)
    left = sp.expand(sp.I * m * (phi_2.subs(sp.sin(sp.Symbol("f")), sine) + df / z))
    alpha, beta, gamma, delta = constants
    right = (alpha * w + beta / w) / z + gamma * w**2 + delta / w**2
    equations = sp.Poly(sp.expand((left - right) * w**4 * z), w, z, df).coeffs()
    solution = sp.solve(equations, constants, dict=True)
    values = ", ".join(f"{c} = {solution[0][c]}" for c in constants) if solution else ""
    return statement(
        bool(solution),
        shown=f"w = exp(i phi/2) satisfies Painleve III with {values}",
        witness=f"no constants fit: i m (phi'' + phi'/z) = {left} is no combination of w/z, "
        "1/(w z), w^2, 1/w^2",
    )


def preimage(setting: Setting, *, combination: str = "product") -> Evidence:
    """Zeros of z^2, factored over the rationals."""
    z = printed.similarity_variable(U, V, combination=combination)
    factors = {factor for factor, _ in sp.factor_list(sp.expand(z**2))[1]}
    return statement(
        factors == {U, V},
        shown="z^2 = 4 u v vanishes where u = 0 or v = 0 and nowhere else",
        witness=f"the factors of z^2 are {sorted(map(str, factors))}",
    )


def constant_on_axes(setting: Setting, *, combination: str = "product") -> Evidence:
    """Value of z on each axis."""
    z = printed.similarity_variable(U, V, combination=combination)
    return identities(
        setting,
        {"z on u = 0": z.subs(U, 0), "z on v = 0": z.subs(V, 0)},
        shown="z = 0 on both axes, so that a function of z is constant there",
    )


def neighbourhood(setting: Setting, *, shape: str = "hyperbola", corner: str = "") -> Evidence:
    """Region about the axes on which phi = F(u v) stays in (0, pi).

    shape: `hyperbola` for u v < c, `strip` for a width c that does not shrink;
    corner: `0` or `pi` to admit a degenerate corner angle.
    """
    bound = _bound_of_angle(setting)
    if bound.outcome != "pass":
        return bound
    corners = [sp.pi / 6, sp.pi / 3, sp.pi / 2, 5 * sp.pi / 6]
    corners += [sp.sympify(corner)] if corner else []
    for phi_0 in corners:
        if phi_0 == 0 or phi_0 == sp.pi:
            return statement(False, shown="", witness=f"phi = {phi_0} on the axes: no immersion")
        below, above = amsler.edge_of_regularity(phi_0)
        reach = sp.oo if shape == "strip" else below
        if reach >= above:
            return statement(
                False,
                shown="",
                witness=f"for phi_0 = {phi_0} the region holds points with u v > {above}, "
                "and phi has reached pi at one with smaller u v",
            )
    return statement(
        True,
        shown="phi = F(u v) with (x F')' = sin F; integrating 0 <= sin F <= 1 twice (by hand) "
        "gives phi_0 <= phi <= phi_0 + u v, so that the front is an immersion where "
        "u v < pi - phi_0: an open set about both axes, unbounded along each",
        witness="",
    )


def _bound_of_angle(setting: Setting) -> Evidence:
    """Equation of F in x = u v, by the chain rule, and the x at which phi_0 + x reaches pi."""
    df, ddf, x = sp.symbols("f1 f2 x", real=True)
    f, at = sp.Function("F")(x), U * V
    mixed = ddf * sp.diff(at, U) * sp.diff(at, V) + df * sp.diff(at, U, V)
    in_x = sp.diff(x * f.diff(x), x).subs(f.diff(x, 2), ddf).subs(f.diff(x), df)
    below, _ = amsler.edge_of_regularity(PHI0)
    return identities(
        setting,
        {
            "phi_uv - (x F')'": mixed - in_x.subs(x, at),
            "phi_0 + largest u v - pi": PHI0 + below - sp.pi,
        },
        shown="(x F')' = sin F, and the bound",
    )


def bobbin_reaches_edge(setting: Setting, *, constant: int = 1) -> Evidence:
    """Length of an asymptotic line from the throat of a bobbin to its edge.

    With x = sinh(s)/kappa it is the integral over 0 < x < 1 of f/sqrt(1 - x^2), f bounded:
    f^2 <= kappa^2 + constant.
    """
    x = sp.Symbol("x", positive=True)
    rate = asymptotic_rates(bobbin(), sp.Integer(0))[0]
    per_x = (sp.diff(sp.sinh(S) / KAPPA, S) ** 2 * rate).rewrite(sp.sinh)
    squared = sp.simplify((1 - (sp.sinh(S) / KAPPA) ** 2) / per_x)
    in_x = sp.factor(sp.simplify(squared.rewrite(sp.exp).subs(S, sp.asinh(KAPPA * x))))
    room = sp.fraction(sp.together(sp.expand(KAPPA**2 + constant) - in_x))
    top = sp.Poly(sp.expand(room[0]), x, KAPPA)
    bottom = sp.Poly(sp.expand(room[1]), x, KAPPA)
    positive = all(c >= 0 for c in top.coeffs()) and all(c >= 0 for c in bottom.coeffs())
    return statement(
        positive,
        shown="an asymptotic line of the bobbin runs from the throat to the edge within the "
        "length (pi/2) sqrt(kappa^2 + 1)",
        witness=f"f^2 = {in_x} exceeds kappa^2 + {constant} near x = 0",
    )
