"""Isometric immersions of low regularity in section 2: what Nash-Kuiper and W^{2,2} ask for."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import elasticity as plates
from checks.printed import isometries as printed
from checks.verify.closed_forms import sign
from theory import bobbin, corrugated_line, curvature, energy_well, surface_of_revolution

X, Y = sp.symbols("x y", real=True)
ARC_LENGTH, RADIUS = sp.symbols("s r", positive=True)
AMPLITUDE = sp.pi / 3


def isometry_equation(setting: Setting, *, factor: str = "1", metric_factor: str = "1") -> Evidence:
    """Whether g(v, w) = <df v, df w> holds for all v, w on the bobbin, and not for its double.

    g = ds^2 + cosh^2(s)/kappa^2 dtheta^2, as K = -1 gives it.
    """
    meridian = bobbin.bobbin()
    tangents = surface_of_revolution.tangents(meridian, bobbin.THETA)
    differential = sp.Matrix(tangents).T
    radius = sp.cosh(bobbin.S) / bobbin.KAPPA
    v, w = (sp.Matrix(sp.symbols(f"{name}1 {name}2", real=True)) for name in "vw")
    metric = sp.Rational(metric_factor) * sp.diag(1, radius**2)
    near_miss = printed.isometry_defect(
        sp.diag(1, 4 * radius**2), differential, v, w, factor=factor
    )
    at = {bobbin.S: 0, bobbin.KAPPA: 1, bobbin.THETA: 0, v[0]: 0, v[1]: 1, w[0]: 0, w[1]: 1}
    shown = "<df v, df w> = g(v, w) for all tangent vectors of the bobbin, not of one twice as wide"
    return combined(
        {
            "bobbin": identities(
                setting,
                {"defect": printed.isometry_defect(metric, differential, v, w, factor=factor)},
                shown=shown,
            ),
            "near miss": statement(
                near_miss.subs(at) != 0, shown=shown, witness="a metric twice as wide is accepted"
            ),
        },
        shown=shown,
    )


def _farthest(
    arcs: tuple[corrugated_line.Point, ...], radius: sp.Rational, derivatives: int
) -> tuple[sp.Expr, sp.Expr]:
    """Distance of the two curves where it is large, and an upper bound of it along them.

    For the derivatives, where the tangent is steepest, the distance is its own bound.
    """
    arc, quarters = (arcs[0], 1) if derivatives else (arcs[1], 2)
    place = {ARC_LENGTH: quarters * AMPLITUDE * RADIUS}
    distance = printed.distance(
        *(
            [c.diff(ARC_LENGTH, derivatives).subs(place) for c in curve]
            for curve in (arc, corrugated_line.line(ARC_LENGTH, AMPLITUDE))
        )
    ).subs(RADIUS, radius)
    bound = distance if derivatives else corrugated_line.distance_bound(radius, AMPLITUDE)
    if sign(bound - distance) < 0:
        raise ArithmeticError(f"{distance} exceeds its bound {bound}")
    return distance, bound


def uniform_closeness(setting: Setting, *, derivatives: int = 0, radius: str = "1/200") -> Evidence:
    """Whether an isometric C^1 curve lies within epsilon = 1/100 of a shortened line.

    derivatives: 1 compares the derivatives instead of the points; radius: of the curve's arcs.
    """
    epsilon, amplitude = sp.Rational(1, 100), AMPLITUDE
    s, r = ARC_LENGTH, RADIUS
    arcs = (
        corrugated_line.first_quarter(s, r),
        corrugated_line.second_quarter(s, r, amplitude),
    )
    joint = {s: amplitude * r}
    speeds = [sum(c.diff(s) ** 2 for c in arc) - 1 for arc in arcs]
    jumps = [
        (a.diff(s, n) - b.diff(s, n)).subs(joint)
        for a, b in zip(*arcs, strict=True)
        for n in (0, 1)
    ]
    distance, bound = _farthest(arcs, sp.Rational(radius), derivatives)
    shown = (
        "a C^1 chain of arcs of unit speed stays within 1/100 of a line of length 0.83 of its own"
    )
    return combined(
        {
            "isometry and C^1": identities(
                setting, {"speed": speeds, "jumps at the joint": jumps}, shown=shown
            ),
            "closeness": statement(
                sign(epsilon - bound) > 0,
                shown=shown,
                witness=f"the distance is {sp.N(distance, 6)}, epsilon is {epsilon}",
            ),
        },
        shown=shown,
    )


def hessian_energy(setting: Setting, *, of_mean: str = "4", of_gauss: str = "-2") -> Evidence:
    """Whether 4 H^2 - 2 K is the squared norm of the second derivatives of the immersion.

    Those are covariant in the induced metric, a smooth one for an isometry of a smooth g.
    """
    r = (X, Y, sp.Function("w")(X, Y))
    shape = curvature.shape_operator(
        curvature.first_form(r, (X, Y)), curvature.second_form(r, (X, Y))
    )
    density = plates.bending_density(
        shape.trace() / 2, shape.det(), of_mean=of_mean, of_gauss=of_gauss
    )
    return identities(
        setting,
        {"density": density - curvature.covariant_hessian_squared(r, (X, Y))},
        shown="the bending density of a graph is the squared norm of its covariant Hessian, so E_2 "
        "is finite exactly for immersions with square-integrable second derivatives",
    )


def _unrolled(kappa: sp.Rational, unrolled: bool) -> tuple[sp.Expr, sp.Expr]:
    """Coefficient of dpsi^2 in the bobbin's metric, and its bending density, at y = sinh s."""
    y = sp.Symbol("y", real=True)
    scale = kappa if unrolled else sp.Integer(1)
    radius = bobbin.radius().subs(bobbin.KAPPA, kappa).subs(bobbin.S, sp.asinh(y))
    first, second = (
        sp.sympify(value).subs(bobbin.KAPPA, kappa).subs(bobbin.S, sp.asinh(y))
        for value in bobbin.squared_curvatures()
    )
    return sp.simplify((scale * radius) ** 2), sp.simplify(first + second)


def many_isometries(
    setting: Setting, *, first: str = "1", second: str = "2", unrolled: bool = True
) -> Evidence:
    """Whether bobbins of two throats are isometric, of different bending energy.

    unrolled: psi = theta / kappa is the common coordinate; else theta.
    """
    values = [_unrolled(sp.Rational(kappa), unrolled) for kappa in (first, second)]
    shown = "all bobbins have the metric ds^2 + cosh^2(s) dpsi^2, and different bending energies"
    density = [sp.simplify(value[1].subs(sp.Symbol("y", real=True), 0)) for value in values]
    return combined(
        {
            "metric": identities(setting, {"dpsi^2": values[0][0] - values[1][0]}, shown=shown),
            "energy at the throat": statement(
                density[0] != density[1],
                shown=shown,
                witness=f"both have kappa_1^2 + kappa_2^2 = {density[0]} at the throat",
            ),
        },
        shown=shown,
    )


def no_equilibrium(setting: Setting, *, variation: str = "bobbins") -> Evidence:
    """Whether an isometry of finite energy need not be an equilibrium, on |sinh s| < 1/2.

    The bobbins form an isometric variation of the bobbin kappa = 1 along which E_2 changes at a
    non-zero rate. variation: `rotation` turns the surface about its axis instead.
    """
    y = sp.Symbol("y", real=True)
    parameter = {"bobbins": bobbin.KAPPA, "rotation": bobbin.THETA}[variation]
    # Per unit of psi, where theta = kappa psi.
    density = bobbin.KAPPA * bobbin.bending_density(y)
    slope = density.diff(parameter).subs(bobbin.KAPPA, 1)
    rate = 2 * sp.integrate(sp.apart(sp.together(slope), y), (y, 0, sp.S.Half))
    return statement(
        sign(rate) != 0,
        shown=f"dE_2/dkappa = {sp.N(rate, 6)} per unit of psi at kappa = 1: finite energy, no "
        "equilibrium",
        witness="the energy does not change along this variation",
    )


def wrinkling_rate(setting: Setting, *, exponent: str = "4/3", regular: str = "2") -> Evidence:
    """Whether a least energy of order h^exponent excludes isometries of finite bending energy.

    Energies per thickness: an isometry of bending energy B costs B h^regular, so one would put the
    least energy below it.
    """
    h = sp.Symbol("h", positive=True)
    growth = sp.limit(h ** (sp.Rational(exponent) - sp.Rational(regular)), h, 0, "+")
    return statement(
        growth == sp.oo,
        shown="the least energy over h^2 grows like h^(-2/3), so no bound B on the bending energy "
        "of the minimisers, or of an isometry in the class, survives h -> 0",
        witness=f"h^{exponent} / h^{regular} tends to {growth}: bounded bending is not excluded",
    )


def rigid_motions(setting: Setting, *, motion: str = "rotation") -> Evidence:
    """Whether rigid motions leave the bending energy alone, so that net force and moment vanish.

    motion: `dilation` is none.
    """
    r = (X, Y, sp.Function("w")(X, Y))
    turn = {"rotation": energy_well.rotation((1, 2, 3, 4)), "dilation": 2 * sp.eye(3)}[motion]
    moved = tuple(turn * sp.Matrix(r) + sp.Matrix([1, 2, 3]))

    def energy(surface: tuple[sp.Expr, sp.Expr, sp.Expr]) -> tuple[sp.Expr, sp.Expr]:
        first, second = (
            form(surface, (X, Y)) for form in (curvature.first_form, curvature.second_form)
        )
        shape = curvature.shape_operator(first, second)
        return plates.bending_density(shape.trace() / 2, shape.det()), first.det()

    before, after = energy(r), energy(moved)
    calls = sp.Matrix([*before, *after]).atoms(sp.Derivative, sp.core.function.AppliedUndef)
    names = {call: sp.Symbol(str(call), real=True) for call in calls}
    return identities(
        setting,
        {
            "squared area element": (after[1] - before[1]).xreplace(names),
            "density": (after[0] - before[0]).xreplace(names),
        },
        shown="(4 H^2 - 2 K) dA is the same after a rotation and a translation",
    )


def holder_exponent(setting: Setting, *, primitives: int = 2, exponent: str = "1/5") -> Evidence:
    """Whether convex integration with this many corrugations per stage gives this exponent.

    A stage divides the metric defect by K and multiplies the second derivatives by K^n: C^1 steps
    K^(-q/2) and C^2 norms K^(n q). Interpolating, C^{1,a} converges for a n < (1 - a)/2. In
    conformal coordinates a metric of the plane is the sum of n = 2 squares of differentials.
    """
    a = sp.Symbol("a", positive=True)
    (critical,) = sp.solve(sp.Eq(a * primitives, (1 - a) / 2), a)
    factor = sp.Symbol("lambda", positive=True)
    squares = [sp.Matrix([1, 0]), sp.Matrix([0, 1]), sp.Matrix([1, 1])][:primitives]
    total = sum((factor * d * d.T for d in squares), sp.zeros(2))
    shown = (
        "two corrugations per stage, all that conformal coordinates need, give exponents below 1/5"
    )
    return identities(
        setting,
        {
            "critical exponent": critical - sp.Rational(exponent),
            "sum of squares": total - factor * sp.eye(2),
        },
        shown=shown,
    )


def generic_edge(setting: Setting, *, null_sign: int = 1) -> Evidence:
    """Whether an edge phi = pi is cuspidal wherever phi_u + phi_v does not vanish.

    There r_u = -r_v, so eta = d_u + d_v spans the kernel; null_sign = -1 takes d_u - d_v. The
    criterion asks for a non-zero rate of lambda = sin phi, and motion of N, along eta.
    """
    u, v = sp.symbols("u v", real=True)
    phi = sp.Function("phi")(u, v)
    t = sp.Symbol("t", positive=True)
    first, second = curvature.asymptotic_forms(t)
    third = (second * curvature.shape_operator(first, second)).applyfunc(sp.cancel)
    eta = sp.Matrix([1, null_sign])
    lengths = [
        sp.limit((eta.T * form * eta)[0], t, sp.oo) for form in (first.applyfunc(sp.cancel), third)
    ]
    rate = (sp.sin(phi).diff(u) + null_sign * sp.sin(phi).diff(v)).subs(sp.cos(phi), -1)
    return identities(
        setting,
        {
            "length of df(eta)": lengths[0],
            "length of dN(eta)": lengths[1] - 4,
            "rate of lambda": rate + phi.diff(u) + phi.diff(v),
        },
        shown="at phi = pi: df(eta) = 0, |dN(eta)| = 2, d lambda(eta) = -(phi_u + phi_v)",
    )
