"""Checks of the lemma on Minding's bobbin and the mechanical analogy (eq:econs, eq:sg-soln)."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import bobbin_orbit as printed
from checks.verify.bobbin_branches import BRANCHES, SIGNS, inside, solved_rate
from checks.zero import vanishes
from theory.bobbin import KAPPA, S, arc_length, bobbin_flow, half_length
from theory.pseudospherical_revolution import PSI, THETA, asymptotic_tangents
from theory.vectors import cross, dot

COMBINATIONS = tuple((sigma, slope) for sigma in SIGNS for slope in SIGNS)


def _name(sigma: int, slope: int) -> str:
    return f"sigma = {sigma:+d}, s' {'>' if slope == 1 else '<'} 0, kappa^2 = sinh^2 s + w^2"


def energy_equation(setting: Setting, *, shift: int = 1, sign: int = 1) -> Evidence:
    """First-order equation along the asymptotic lines of the surface, through the edges."""
    flow = bobbin_flow()
    forms = {"shift": shift, "sign": sign}
    along_lines = printed.energy(arc_length(), flow.s_rate, KAPPA, **forms)
    ds = sp.Symbol("p", real=True)
    speed = ds**2 + flow.alpha**2 * (sp.cosh(S) / KAPPA) ** 2 - 1
    return identities(
        setting,
        {
            "along the lines": along_lines,
            "unit speed": printed.energy(S, ds, KAPPA, **forms) - speed,
        },
        shown="it is the condition |r_u| = 1, and holds along every asymptotic line, also beyond "
        "the edges",
    )


def angle_formula(setting: Setting, *, shift: int = 1, exchanged: bool = False) -> Evidence:
    """Agreement of the printed angle with sigma r_u . r_v and |r_u x r_v|, for each sigma."""
    flow = bobbin_flow()
    r_u, r_v = asymptotic_tangents(flow)
    normal = cross(r_u, r_v)
    inner, area = dot(r_u, r_v), dot(normal, normal)
    residuals = {}
    for sigma in SIGNS:
        for branch in BRANCHES:
            phi = printed.angle(arc_length(), KAPPA, sigma, shift=shift, exchanged=exchanged)
            name = f"sigma = {sigma:+d}, {branch.name}"
            cosine, sine = sp.expand_trig(sp.cos(phi)), sp.expand_trig(sp.sin(phi))
            residuals[f"cos ({name})"] = branch.value(cosine - sigma * inner.subs(THETA, 0))
            residuals[f"sin^2 ({name})"] = branch.value(sine**2 - area.subs(THETA, 0))
    return identities(
        setting,
        residuals,
        shown="cos phi = sigma r_u . r_v and sin phi = |r_u x r_v| on all quarter periods; twice "
        "an arcsine or arccosine of a number in (0, 1] lies in [0, pi]",
    )


def _rates(sigma: int, slope: int) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """s', phi and phi' on the solutions with this sign of s', as expressions of s."""
    ds = solved_rate(printed.energy(S, sp.Integer(0), KAPPA), slope)
    phi = printed.angle(S, KAPPA, sigma)
    return ds, phi, ds * sp.diff(phi, S)


def lemma(
    setting: Setting,
    *,
    shift: int = 1,
    angle_shift: int = 1,
    exchanged: bool = False,
    right: int = 1,
) -> Evidence:
    """Sine-Gordon for phi(s(u + v)), s' of either sign by the printed equation."""
    residuals = {}
    for sigma, slope in COMBINATIONS:
        ds = solved_rate(printed.energy(S, sp.Integer(0), KAPPA, shift=shift), slope)
        phi = printed.angle(S, KAPPA, sigma, shift=angle_shift, exchanged=exchanged)
        phi_uv = ds * sp.diff(ds * sp.diff(phi, S), S)
        sine = sp.expand_trig(sp.sin(phi))
        residuals[_name(sigma, slope)] = inside(phi_uv - right * sigma * sine)
    return identities(
        setting,
        residuals,
        shown="phi_uv = phi'' = sigma sin phi by the chain rule and s'^2 = 1 - cosh^2 s/(kappa^2 "
        "+ 1), for both sigma, both signs of s', all s",
    )


def measured_angle(setting: Setting, *, right: int = 1) -> Evidence:
    """Sine-Gordon for the angle measured between r_u and r_v, for both sigma and signs of s'."""
    flow = bobbin_flow()
    r_u, r_v = asymptotic_tangents(flow)
    inner = sp.simplify(dot(r_u, r_v).subs(THETA, 0))
    residuals = {}
    for sigma, slope in COMBINATIONS:
        sine = slope * 2 * flow.alpha * flow.rho * flow.s_rate
        first = -flow.along(sigma * inner) / sine
        residuals[_name(sigma, slope)] = flow.along(first) - right * sigma * sine
        residuals[f"Pythagoras, {_name(sigma, slope)}"] = sine**2 + inner**2 - 1
    return identities(
        setting, residuals, shown="phi = arccos(sigma r_u . r_v) satisfies phi'' = sigma sin phi"
    )


def proof_first(setting: Setting, *, signed: bool = False, about: int = 1) -> Evidence:
    """Whether every solution, with its angle, satisfies eq:bobbin.

    signed: whether the first right side is multiplied by sgn s'.
    """
    residuals = {}
    alpha = printed.alpha(KAPPA)
    for sigma, slope in COMBINATIONS:
        ds, phi, _ = _rates(sigma, slope)
        climb, turn = printed.first_order(
            sp.cos(phi / 2), sp.sin(phi / 2), sigma, along=slope if signed else 1, about=about
        )
        residuals[f"first, {_name(sigma, slope)}"] = inside(ds - climb)
        residuals[f"second, {_name(sigma, slope)}"] = inside(alpha / KAPPA * sp.cosh(S) - turn)
    return identities(setting, residuals, shown="both equations, for both sigma and signs of s'")


def proof_smooth(setting: Setting, *, through_edge: bool = False) -> Evidence:
    """Rate of phi as a smooth function of s, sigma being constant.

    through_edge: whether the two one-sided derivatives at a turning point are compared as well.
    """
    root = sp.sqrt(KAPPA**2 + 1)
    residuals = {}
    for sigma, slope in COMBINATIONS:
        _, _, dphi = _rates(sigma, slope)
        residuals[_name(sigma, slope)] = inside(dphi - slope * 2 * sigma * sp.sinh(S) / root)
    if through_edge:
        before, after = (slope * 2 * sp.sinh(half_length()) / root for slope in SIGNS)
        residuals["one-sided derivatives at s = L, sigma = +1"] = before - after
    return identities(
        setting,
        residuals,
        shown="phi' = +-2 sigma sinh s/sqrt(kappa^2 + 1) where s' != 0, smooth as s is",
    )


def proof_product(setting: Setting, *, signed: bool = False, factor: str = "1/2") -> Evidence:
    """First display of the proof; signed: whether its right side is multiplied by sgn s'."""
    residuals = {}
    for sigma, slope in COMBINATIONS:
        ds, phi, _ = _rates(sigma, slope)
        left = ds * sp.diff(sp.sinh(S) / sp.sqrt(KAPPA**2 + 1), S)
        middle, right = printed.product_step(S, ds, sp.Symbol("phi"), KAPPA, factor=factor)
        right = right.subs(sp.sin(sp.Symbol("phi")), sp.expand_trig(sp.sin(phi)))
        residuals[f"middle, {_name(sigma, slope)}"] = inside(left - middle)
        side = slope if signed else 1
        residuals[f"right, {_name(sigma, slope)}"] = inside(middle - side * right)
    return identities(setting, residuals, shown="both equalities, for both sigma and signs of s'")


def proof_quotient(setting: Setting, *, signed: bool = False, weight: int = -1) -> Evidence:
    """Second display of the proof; signed: whether its right sides are multiplied by sgn s'."""
    left = sp.sinh(S) / sp.sqrt(KAPPA**2 + 1)
    residuals = {}
    for sigma, slope in COMBINATIONS:
        _, phi, dphi = _rates(sigma, slope)
        middle, right = printed.quotient_step(
            sp.cos(phi / 2), sp.sin(phi / 2), sigma, dphi, weight=weight
        )
        side = slope if signed else 1
        residuals[f"middle, {_name(sigma, slope)}"] = inside(middle - right)
        residuals[f"left, {_name(sigma, slope)}"] = inside(left - side * right)
    return identities(setting, residuals, shown="both equalities, for both sigma and signs of s'")


def proof_end(setting: Setting, *, first: int = 1, second: int = 1) -> Evidence:
    """Sine-Gordon from X' = first/2 sin phi and X = second sigma phi'/2."""
    xi = sp.Symbol("xi", real=True)
    phi = sp.Function("phi")(xi)
    mixed = sp.diff(sp.Function("f")(sp.Symbol("u") + sp.Symbol("v")), sp.Symbol("u"))
    mixed = sp.diff(mixed, sp.Symbol("v"))
    twice = sp.diff(sp.Function("f")(xi), xi, 2)
    residuals = {"phi_uv": mixed.doit().subs(sp.Symbol("u"), xi - sp.Symbol("v")).doit() - twice}
    for sigma in SIGNS:
        x = second * sigma * sp.diff(phi, xi) / 2
        equation = sp.diff(x, xi) - sp.Rational(first, 2) * sp.sin(phi)
        solved = sp.solve(equation, sp.diff(phi, xi, 2))[0]
        residuals[f"sigma = {sigma:+d}"] = solved - sigma * sp.sin(phi)
    return identities(
        setting,
        residuals,
        shown="the two displays give phi'' = sigma sin phi, and still do when both change sign",
    )


def conservation(setting: Setting, *, factor: str = "1/2") -> Evidence:
    """Kinetic plus potential energy of the unit mass, and its equation of motion."""
    ds = sp.Symbol("p", real=True)
    height = printed.potential(S, KAPPA, factor=factor)
    flow = bobbin_flow()
    force = -sp.diff(height, S).subs(S, arc_length())
    return identities(
        setting,
        {
            "energy": 2 * (ds**2 / 2 + height) - 1 - printed.energy(S, ds, KAPPA),
            "conserved": flow.along(flow.s_rate**2 / 2 + height.subs(S, arc_length())),
            "Newton": flow.along(flow.s_rate) - force,
        },
        shown="the equation is s'^2/2 + V = 1/2, and along the surface's asymptotic lines "
        "s'' = -V'(s)",
    )


def _resting_is_a_solution(law: str, factor: str) -> bool:
    """Whether s = L for all xi solves the energy equation, and Newton's where law asks for it."""
    end = half_length()
    energy = printed.energy(end, sp.Integer(0), KAPPA)
    force = -sp.diff(printed.potential(S, KAPPA, factor=factor), S).subs(S, end)
    return vanishes(energy) and (law == "energy" or vanishes(force))


def _reaches_rest() -> bool:
    """Whether the moving orbit meets the resting ones, s = +-L, at velocity 0."""
    flow = bobbin_flow()
    ends = ((1, sp.Integer(0)), (-1, sp.pi))
    return all(
        vanishes(flow.s_rate.subs(PSI, psi))
        and vanishes(arc_length().subs(PSI, psi) - side * half_length())
        for side, psi in ends
    )


def orbits(setting: Setting, *, law: str = "newton", sign: int = 1) -> Evidence:
    """Whether all orbits of energy 1/2 are bounded and periodic.

    law: `newton` for the orbits of the unit mass, `energy` for all solutions of eq:econs.
    """
    if _resting_is_a_solution(law, "1/2") and _reaches_rest():
        return statement(
            False,
            shown="",
            witness="s = L for xi <= 0, from there the descent to s = -L, and s = -L ever after: "
            "s' = 0 at both joints, so it is C^1 and solves eq:econs, and it is not periodic",
        )
    flow = bobbin_flow()
    solution = printed.energy(arc_length(), flow.s_rate, KAPPA, sign=sign)
    around = arc_length().subs(PSI, PSI + 2 * sp.pi)
    force = -sp.diff(printed.potential(S, KAPPA), S).subs(S, arc_length())
    return identities(
        setting,
        {
            "solution": solution,
            "Newton": flow.along(flow.s_rate) - force,
            "period": around - arc_length(),
            "steady turning": flow.psi_rate**2 - (1 + KAPPA**2 * sp.cos(PSI) ** 2) / (KAPPA**2 + 1),
            "bound": KAPPA**2 - sp.sinh(arc_length()) ** 2 - (KAPPA * sp.sin(PSI)) ** 2,
        },
        shown="sinh s = kappa cos psi is an orbit of the unit mass, |psi'| >= 1/sqrt(kappa^2 + 1): "
        "psi runs through 2 pi in a finite time, the period; it fills the energy's level in the "
        "phase plane, so that (uniqueness used) every orbit is this one, shifted",
    )


def turning_at_edge(setting: Setting, *, shift: int = 1) -> Evidence:
    """Where s' = 0, on any solution of the energy equation."""
    end = half_length()
    at_rest = printed.energy(S, sp.Integer(0), KAPPA, shift=shift) * (KAPPA**2 + shift)
    s, margin = sp.symbols("s_up d", positive=True)
    inside = at_rest.subs({S: s, KAPPA: sp.sinh(s + margin)})
    return combined(
        {
            "at the edges": identities(
                setting,
                {f"{side:+d} L": at_rest.subs(S, side * end) for side in SIGNS},
                shown="at rest",
            ),
            "only there": positivity(
                setting,
                {"s'^2 inside": -inside, "s'^2 at the throat": -at_rest.subs(S, 0)},
                shown="moving inside",
            ),
        },
        shown="s'^2 vanishes at s = +-L and is positive for |s| < L",
    )


def turning_force(setting: Setting, *, law: str = "newton", factor: str = "1/2") -> Evidence:
    """Whether s'' = -V'(s) != 0 wherever s' = 0.

    law: `newton` for the orbits of the unit mass, `energy` for all solutions of eq:econs.
    """
    if _resting_is_a_solution(law, factor):
        return statement(
            False,
            shown="",
            witness="s = L for all xi solves eq:econs: s' = s'' = 0 throughout, while V'(L) = "
            "kappa/sqrt(kappa^2 + 1)",
        )
    flow = bobbin_flow()
    acceleration = flow.along(flow.s_rate)
    slope = sp.diff(printed.potential(S, KAPPA, factor=factor), S)
    residuals, sizes = {}, {}
    for side, psi in ((1, sp.Integer(0)), (-1, sp.pi)):
        residuals[f"s' at {side:+d} L"] = flow.s_rate.subs(PSI, psi)
        force = -slope.subs(S, side * half_length())
        residuals[f"s'' at {side:+d} L"] = acceleration.subs(PSI, psi) - force
        sizes[f"towards the throat from {side:+d} L, squared"] = force**2
    return combined(
        {
            "rest": identities(setting, residuals, shown="s' = 0 and s'' = -V'"),
            "force": positivity(setting, sizes, shown="V' is not 0 at the edges"),
        },
        shown="at s = +-L the orbit has s' = 0 and s'' = -V'(s) = -+kappa/sqrt(kappa^2 + 1)",
    )


def global_solutions(setting: Setting, *, sign: int = 1) -> Evidence:
    """Bounds on s and s' that let no solution end; sign: of cosh^2 in the energy equation."""
    squared = -printed.energy(S, sp.Integer(0), KAPPA, sign=sign)
    length, margin = sp.symbols("L d", positive=True)
    outside = -squared.subs({S: length + margin, KAPPA: sp.sinh(length)})
    return combined(
        {
            "height": positivity(setting, {"-s'^2 for |s| > L": outside}, shown="|s| <= L"),
            "speed": positivity(
                setting, {"1 - s'^2": (1 - squared).subs(S, length)}, shown="|s'| < 1"
            ),
        },
        shown="|s| <= L and |s'| < 1 on every solution, so (continuation of bounded solutions "
        "used) none ends at a finite xi; xi = u + v takes all values on R^2",
    )


def finite_parameter(setting: Setting, *, surface: str = "bobbin") -> Evidence:
    """Least turning rate of the meridian along an asymptotic line.

    surface: `bobbin`, or `pseudosphere` (alpha = 1), whose lines never turn back from the cusp.
    """
    alpha_squared = {"bobbin": bobbin_flow().alpha ** 2, "pseudosphere": sp.Integer(1)}[surface]
    rate_squared = 1 - alpha_squared * sp.sin(PSI) ** 2
    flow = bobbin_flow()
    least = 1 - alpha_squared
    return combined(
        {
            "least": positivity(setting, {"1 - alpha^2": sp.cancel(least)}, shown="positive"),
            "rate": identities(
                setting,
                {
                    "(d psi/du)^2": flow.psi_rate**2 - rate_squared,
                    "above the least": rate_squared - least - alpha_squared * sp.cos(PSI) ** 2,
                },
                shown="d psi/du is bounded away from 0",
            ),
        },
        shown="(d psi/du)^2 = 1 - alpha^2 sin^2 psi >= 1/(kappa^2 + 1), so psi reaches a multiple "
        "of pi, the edge, within a length pi sqrt(kappa^2 + 1) of any u-line or v-line",
    )
