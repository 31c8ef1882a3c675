"""Reduced energies of plates of section 2: Foeppl-von Karman, finite thickness, bending."""

import sympy as sp
from sympy.calculus.euler import euler_equations

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import elasticity as printed
from theory import curvature, energy_well, plate_energy

X, Y = sp.symbols("x y", real=True)
H = sp.Symbol("h", positive=True)
YOUNG = sp.Symbol("Y", positive=True)
DEFECT = sp.Matrix(2, 2, sp.symbols("d1 d2 d2 d3", real=True))
SECOND = sp.Matrix(2, 2, sp.symbols("b1 b2 b2 b3", real=True))


def _graph() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    return (X, Y, sp.Function("w")(X, Y))


def _at_contact(m: sp.Matrix) -> sp.Matrix:
    """Value where the graph touches the plane of its coordinates, its derivatives being symbols.

    Every point of a surface is such a point, for the graph over its tangent plane there.
    """
    calls = m.atoms(sp.Derivative, sp.core.function.AppliedUndef)
    slopes = {call for call in calls if call.is_Derivative and call.derivative_count == 1}
    return m.xreplace(
        {
            call: sp.Integer(0) if call in slopes else sp.Symbol(str(call), real=True)
            for call in calls
        }
    )


def displacement_scaling(
    setting: Setting,
    *,
    in_plane: str = "1/2",
    out_of_plane: str = "1",
    length: str = "0",
    terms: str = "strain",
) -> Evidence:
    """Whether the scaled displacements balance two terms: both strains, or stretching and bending.

    terms: `strain` compares the linear with the quadratic strain, `energy` the stretching with the
    bending energy of a sheet of thickness h.
    """
    exponents = printed.displacement_exponents(
        in_plane=in_plane, out_of_plane=out_of_plane, length=length
    )

    def order(name: str) -> sp.Expr:
        monomials = plate_energy.membrane_orders()[name]
        return min(sum(n * e for n, e in zip(m, exponents, strict=True)) for m in monomials)

    linear, quadratic = order("linear"), order("quadratic")
    shown = (
        f"with displacements O(h^{exponents[0]}) in and O(h^{exponents[1]}) out of plane, over "
        f"lengths O(h^{exponents[2]}), the linear strain is O(h^{linear}), the quadratic one "
        f"O(h^{quadratic})"
    )
    if terms == "strain":
        return statement(linear == quadratic, shown=shown, witness=shown)
    stretching, bending = 1 + 2 * min(linear, quadratic), 3 + 2 * order("bending")
    shown += f"; stretching costs O(h^{stretching}), bending O(h^{bending})"
    return statement(stretching == bending, shown=shown, witness=shown)


def fvk_powers(setting: Setting, *, stretching_power: int = 1, bending_power: int = 3) -> Evidence:
    """Whether (FvK) has the powers of h of the energy of the Kirchhoff-Love extension.

    Without bending the energy is its stretching term; on an isometry it is the bending term and a
    remainder of higher order.
    """
    flat, bent = (
        plate_energy.thickness_energy(first, second, H, young=YOUNG)
        for first, second in ((sp.eye(2) + DEFECT, sp.zeros(2)), (sp.eye(2), SECOND))
    )
    bending = YOUNG * sp.integrate(X**2, (X, -sp.S.Half, sp.S.Half)) / 2
    bending *= energy_well.squared_norm(SECOND)
    powers = {"stretching_power": stretching_power, "bending_power": bending_power}
    remainder = sp.expand(bent - printed.fvk_energy(H, 0, bending, **powers))
    return identities(
        setting,
        {
            "stretching": flat - printed.fvk_energy(H, flat.subs(H, 1), 0, **powers),
            "remainder on isometries, coefficients up to h^3": [
                remainder.coeff(H, n) for n in range(4)
            ],
        },
        shown="the extension costs h E_s without bending, h^3 E_b + O(h^5) on an isometry",
    )


def fvk_equations(setting: Setting, *, geometric: int = 1) -> Evidence:
    """Whether the equilibrium equations of the energy (FvK) are coupled partial equations.

    geometric: factor of the quadratic strain; without it the membrane and the plate decouple.
    """
    u, v, w = (sp.Function(name)(X, Y) for name in "uvw")
    slope = sp.Matrix([w.diff(X), w.diff(Y)])
    gradient = sp.Matrix([[u.diff(X), u.diff(Y)], [v.diff(X), v.diff(Y)]])
    strain = (gradient + gradient.T + geometric * slope * slope.T) / 2
    bending = sp.hessian(w, (X, Y))
    energy = printed.fvk_energy(
        H, energy_well.squared_norm(strain), energy_well.squared_norm(bending) / 12
    )
    found = [equation.lhs for equation in euler_equations(energy, [u, v, w], [X, Y])]
    membrane = [2 * H * (strain[i, 0].diff(X) + strain[i, 1].diff(Y)) for i in range(2)]
    force = geometric * strain * slope
    plate = H**3 * (w.diff(X, 4) + 2 * w.diff(X, 2, Y, 2) + w.diff(Y, 4)) / 6
    plate -= 2 * H * (force[0].diff(X) + force[1].diff(Y))
    shown = (
        "the variations of (FvK) are div stress = 0 and h^3 Delta^2 w / 6 = div(stress grad w); "
        "each holds derivatives of all three displacements"
    )
    residuals = {"membrane": sp.Matrix(found[:2]) + sp.Matrix(membrane), "plate": found[2] - plate}
    alone = [n for n, equation in enumerate(found) if not all(map(equation.has, (u, v, w)))]
    return combined(
        {
            "coupled": statement(
                not alone, shown=shown, witness=f"the equations {alone} lack a displacement"
            ),
            "divergence form": identities(setting, residuals, shown=shown),
        },
        shown=shown,
    )


def stretching_coefficient(setting: Setting, *, stretching_factor: str = "1/2") -> Evidence:
    """Whether the stretching term of (eqn:finitethicknessenergy) is that of Young's modulus Y.

    Once for any metric defect, from the energy of the extension; once for a strip pulled by the
    strain e, whose energy per volume is Y e^2/2 to second order by the meaning of Y.
    """
    derived = plate_energy.thickness_energy(sp.eye(2) + DEFECT, sp.zeros(2), H, young=YOUNG)
    e = sp.Symbol("e", positive=True)

    def stretching(defect: sp.Matrix) -> sp.Expr:
        size = energy_well.squared_norm(defect)
        return printed.finite_thickness_density(
            H, YOUNG, size, 0, stretching_factor=stretching_factor
        )

    pulled = stretching(sp.diag((1 + e) ** 2 - 1, 0))
    return identities(
        setting,
        {
            "pulled strip": sp.limit(sp.expand(pulled / e**2), e, 0) - YOUNG * H / 2,
            "any metric defect": stretching(DEFECT) - derived,
        },
        shown="stretching costs Y h |dy.dy - g|^2 / 8; a strip pulled by e costs Y h e^2 / 2",
    )


def bending_coefficient(setting: Setting, *, bending_factor: str = "1/24") -> Evidence:
    """Whether the bending term of (eqn:finitethicknessenergy) is the h^3 term on isometries."""
    derived = plate_energy.thickness_energy(sp.eye(2), SECOND, H, young=YOUNG).coeff(H, 3) * H**3
    bending = printed.bending_density(SECOND.trace() / 2, SECOND.det())
    term = printed.finite_thickness_density(H, YOUNG, 0, bending, bending_factor=bending_factor)
    return identities(
        setting,
        {"bending": term - derived},
        shown="on an isometry the h^3 term of the energy is Y h^3 (4 H^2 - 2 K) / 24",
    )


def stretching_measures_defect(setting: Setting, *, form: str = "squares") -> Evidence:
    """Whether the stretching integrand vanishes only where dy.dy = g; form: `trace` takes another.

    In the metric g = A^2 the squared norm of D is a sum of four squares of the entries of
    A^-1 D A^-1; the square of the trace vanishes on traceless defects too.
    """
    a, c = sp.symbols("a c", positive=True)
    b = sp.Symbol("b", real=True)
    root = sp.Matrix([[a, b], [b, c + b**2 / a]])
    metric = root * root
    whitened = root.inv() * DEFECT * root.inv()
    sizes = {
        "squares": printed.squared_norm(DEFECT, metric, norm="metric"),
        "trace": (metric.inv() * DEFECT).trace() ** 2,
    }
    return identities(
        setting,
        {"norm": sizes[form] - energy_well.squared_norm(whitened)},
        shown="|D|^2 is the sum of the squares of the entries of A^-1 D A^-1: 0 only for D = 0",
    )


def willmore(setting: Setting, *, of_mean: str = "4", of_gauss: str = "-2") -> Evidence:
    """Whether 4 H^2 - 2 K is 4 times Willmore's H^2 up to what the metric determines.

    Routes: curvatures from the second form, and K from the metric of a graph.
    """
    r = _graph()
    first, second = curvature.first_form(r, (X, Y)), curvature.second_form(r, (X, Y))
    shape = curvature.shape_operator(_at_contact(first), _at_contact(second))
    density = printed.bending_density(
        shape.trace() / 2, shape.det(), of_mean=of_mean, of_gauss=of_gauss
    )
    intrinsic = _at_contact(sp.Matrix([[curvature.intrinsic_curvature(first, (X, Y))]]))[0]
    return identities(
        setting,
        {"density - 4 H^2 + 2 K[g]": density - shape.trace() ** 2 + 2 * intrinsic},
        shown="4 H^2 - 2 K = 4 H^2 - 2 K[g], K[g] from the metric of a graph alone",
    )


def sum_of_squares(setting: Setting, *, of_mean: str = "4", of_gauss: str = "-2") -> Evidence:
    """Whether 4 H^2 - 2 K is the sum of the squared principal curvatures."""
    kappa = curvature.principal_pair(sp.eye(2), SECOND)
    mean, gauss = printed.mean_curvature(*kappa), printed.gauss_curvature(*kappa)
    density = printed.bending_density(mean, gauss, of_mean=of_mean, of_gauss=of_gauss)
    return identities(
        setting,
        {
            "density": density - kappa[0] ** 2 - kappa[1] ** 2,
            "norm of the second form": density - energy_well.squared_norm(SECOND),
        },
        shown="4 H^2 - 2 K is kappa_1^2 + kappa_2^2 and the squared norm of the second form",
    )


def mean_curvature(setting: Setting, *, factor: str = "1/2") -> Evidence:
    """Whether H is half the trace of the shape operator, and 1/R on a sphere of radius R."""
    radius = sp.Symbol("R", positive=True)
    first = sp.Matrix(2, 2, sp.symbols("g1 g2 g2 g3", real=True))
    pair = curvature.principal_pair(first, SECOND)
    sphere = curvature.principal_pair(radius**2 * sp.eye(2), radius * sp.eye(2))
    return identities(
        setting,
        {
            "half trace": printed.mean_curvature(*pair, factor=factor)
            - curvature.shape_operator(first, SECOND).trace() / 2,
            "sphere": printed.mean_curvature(*sphere, factor=factor) - 1 / radius,
        },
        shown="(kappa_1 + kappa_2)/2 is half the trace of the shape operator, 1/R on a sphere",
    )


def gauss_curvature(setting: Setting, *, sign: int = 1) -> Evidence:
    """Whether K = kappa_1 kappa_2 is the curvature of the metric, on any graph."""
    r = _graph()
    first, second = curvature.first_form(r, (X, Y)), curvature.second_form(r, (X, Y))
    pair = curvature.principal_pair(_at_contact(first), _at_contact(second))
    product = printed.gauss_curvature(*pair, sign=sign)
    intrinsic = _at_contact(sp.Matrix([[curvature.intrinsic_curvature(first, (X, Y))]]))[0]
    return identities(
        setting,
        {"K": product - intrinsic},
        shown="the product of the roots of det(h - k g) is R_1212 / det g on every graph",
    )


def isometries_cost_h_cubed(setting: Setting, *, power: int = 3, stretch: str = "1") -> Evidence:
    """Whether the energy of an isometry at K = -1 over h^power tends to a positive number.

    By the printed energy, and by the energy of the extension in three dimensions. stretch: factor
    by which the centre surface is scaled, so that it is no isometry unless 1.
    """
    kappa = sp.Symbol("kappa", positive=True)
    factor = sp.Rational(stretch)
    defect = 2 * (factor**2 - 1) ** 2
    bending = printed.bending_density((kappa - 1 / kappa) / 2, -1)
    energies = {
        "plate": printed.finite_thickness_density(H, 1, defect, bending),
        "bulk": plate_energy.extension_energy(kappa, -1 / kappa, H, stretch=factor),
    }
    shown = (
        "E^h / h^3 tends to Y (kappa^2 + kappa^-2) / 24, which is positive; so does the energy of "
        "the extension in three dimensions, to twice that for Y = 1"
    )
    limits = {name: sp.limit(e / H**power, H, 0, "+") for name, e in energies.items()}
    parts = {
        name: statement(
            bool(value.is_finite and value.is_positive),
            shown=shown,
            witness=f"the {name} energy over h^{power} tends to {value}",
        )
        for name, value in limits.items()
    }
    return combined(parts, shown=shown)


def kirchhoff_love(setting: Setting, *, lift: int = 1) -> Evidence:
    """Whether the extension maps fibres to unit speed normals, through parallel surfaces.

    lift: multiple of the distance to the centre surface at which the fibre's points are put.
    """
    t = sp.Symbol("t", real=True)
    r = _graph()
    first, second = (
        _at_contact(form(r, (X, Y))) for form in (curvature.first_form, curvature.second_form)
    )
    gram = _at_contact(plate_energy.kirchhoff_love_gram(r, (X, Y), t))
    scale = sp.diag(1, 1, lift)
    lifted = scale * gram.subs(t, lift * t) * scale
    parallel = plate_energy.parallel_metric(first, second, t)
    return identities(
        setting,
        {
            "fibres": lifted[:, 2] - sp.Matrix([0, 0, 1]),
            "parallel surface": lifted[:2, :2] - parallel,
        },
        shown="r + t N has Gram matrix (g (1 - t S)^2, 1): fibres stay normal and of unit speed",
    )


def isometric_fibres(setting: Setting, *, poisson: str = "0") -> Evidence:
    """Whether fibres keep their length in the extension of least energy, at this Poisson ratio."""
    strain = plate_energy.normal_strain(DEFECT, sp.Rational(poisson))
    return identities(
        setting,
        {"strain across the thickness": strain},
        shown="the strain across the thickness of least energy is -nu/(1 - nu) times the trace of "
        "the strain in the plane: 0 for nu = 0",
    )
