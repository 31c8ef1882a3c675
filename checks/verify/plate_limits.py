"""Limits of vanishing thickness of section 2: the Kirchhoff regime, Gamma-convergence."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import plate_limits as printed
from theory import energy_well, plate_energy

H, YOUNG = sp.symbols("h Y", positive=True)
KAPPA_1, KAPPA_2 = sp.symbols("kappa_1 kappa_2", real=True)


def gamma_limit_prefactor(
    setting: Setting, *, prefactor: str = "24", modulus_power: int = -1, second_sign: int = 1
) -> Evidence:
    """Whether the left side of (eqn:gammalimit) tends to E_2 along the Kirchhoff-Love extension.

    For an isometry of a sheet whose metric is the identity in the coordinates used.
    """
    energy = plate_energy.extension_energy(KAPPA_1, KAPPA_2, H)
    left = printed.rescaled_energy(
        energy, H, YOUNG, prefactor=prefactor, modulus_power=modulus_power
    )
    right = printed.limit_density(KAPPA_1, KAPPA_2, second_sign=second_sign)
    return identities(
        setting,
        {"rescaled energy minus integrand of E_2": left - right},
        shown="the extension of an isometry has I = h^3/12 int (kappa_1^2 + kappa_2^2) dA exactly",
    )


def gamma_limit_charts(
    setting: Setting, *, distance: str = "to the well", chart: str = "any", area: str = "dA"
) -> Evidence:
    """Whether the bending part of (eq:hyperelastic) is h^3/12 int (kappa_1^2 + kappa_2^2) dA.

    distance: `to the well` is dist(F, SO(3) A) dx as printed, `relative` dist(F A^-1, SO(3)) dV;
    chart: `any` metric of the coordinates, or `conformal` ones; area: `dA`, or `dx`. The
    coefficient is the least over all corrections linear in the thickness.
    """
    a, b = sp.symbols("a b", positive=True)
    root = {"any": sp.diag(a, b), "conformal": sp.diag(a, a)}[chart]
    # The matrix A^-1 h A^-1 has the principal curvatures as eigenvalues.
    second = sp.Matrix(2, 2, sp.symbols("m1 m2 m2 m3", real=True))
    if distance == "relative":
        density = root.det() * plate_energy.bending_coefficient(second, sp.eye(2))
    else:
        density = plate_energy.bending_coefficient(second, root)
    element = root.det() if area == "dA" else sp.Integer(1)
    return identities(
        setting,
        {
            "bending minus (kappa_1^2 + kappa_2^2) dA": density
            - energy_well.squared_norm(second) * element
        },
        shown="in a chart with g = diag(a^2, b^2) the density is a b (kappa_1^2 + kappa_2^2)",
    )


def stretched_chart(setting: Setting, *, scale: str = "2") -> Evidence:
    """Whether I of a cylinder is h^3/12 int kappa^2 dA in the chart x -> (x / scale, y).

    The extension's gradient, the metric and its root are computed from the map itself.
    """
    x, y, t = sp.symbols("x y t", real=True)
    radius, s = sp.symbols("R s", positive=True)
    a = sp.Rational(scale)
    arc = a * x / radius
    lifted = sp.Matrix([(radius + t) * sp.sin(arc), y, (radius + t) * sp.cos(arc)])
    gradient = lifted.jacobian([x, y, t])
    root = sp.diag(a, 1, 1)
    gram = (gradient.T * gradient).applyfunc(sp.trigsimp)
    stretched = root * sp.diag(s, 1, 1)
    density = energy_well.distance_squared(stretched, root).subs(s, 1 + t / radius)
    energy = sp.integrate(sp.expand(density), (t, -H / 2, H / 2))
    return identities(
        setting,
        {
            "Gram matrix": gram - (stretched**2).subs(s, 1 + t / radius),
            "I per area minus h^3 kappa^2 / 12": energy / root.det() - H**3 / (12 * radius**2),
        },
        shown="a cylinder of radius R has I = scale h^3/(12 R^2) times its area in this chart",
    )


def kirchhoff_regime(setting: Setting, *, power: int = 3) -> Evidence:
    """Whether I of the extension of an isometry is C h^power with 0 < C finite, at K = -1."""
    kappa = sp.Symbol("kappa", positive=True)
    energy = plate_energy.extension_energy(kappa, -1 / kappa, H)
    bound = sp.limit(energy / H**power, H, 0, "+")
    return statement(
        bool(bound.is_finite and bound.is_positive),
        shown="I = C h^3 along the extension, C = E_2 / 12 finite and positive",
        witness=f"I / h^{power} tends to {bound}",
    )


def gamma_limit_determined(
    setting: Setting, *, recovery: bool = True, lower_bound: bool = False
) -> Evidence:
    """Whether the description of Gamma-convergence determines the limit of f_h(x) = cos(x / h).

    Recovery of a constant c: x_h = h (arccos c + 2 pi n), n = floor(x / (2 pi h)), tends to x and
    f_h(x_h) = c. lower_bound: also ask that no sequence has a smaller limit, that is c <= -1.
    """
    n = sp.Symbol("n", integer=True)
    candidates = [sp.Rational(c) for c in ("-2", "-1", "0", "1/2", "1", "2")]

    def is_recovered(c: sp.Rational) -> bool:
        return abs(c) <= 1 and bool(sp.cos(sp.acos(c) + 2 * sp.pi * n).simplify() == c)

    limits = [
        c for c in candidates if (is_recovered(c) or not recovery) and (c <= -1 or not lower_bound)
    ]
    return statement(
        len(limits) == 1,
        shown="with the lower bound the limit of cos(x/h) is -1, the least value recovered",
        witness=f"f_h(x) = cos(x/h) has each of the constants {limits} as its limit energy",
    )


def hierarchy(setting: Setting, *, first: int = 1, second: int = 3) -> Evidence:
    """Whether the limit spaces for I <= C h^first and I <= C h^second differ.

    The map x -> stretch x of the centre surface is tested. Above: the energy of its extension.
    Below: a line of length 1 along e1 stretched by s costs at least (s - 1)^2 for every map with
    the same ends, as dist(F, SO(3)) >= |F e1| - 1 and its average is at least s - 1 (Jensen).
    """
    s = sp.Symbol("s", positive=True)
    above = plate_energy.extension_energy(0, 0, H, stretch=1 + s)
    below = H * s**2
    finite = sp.limit(above / H**first, H, 0, "+")
    excluded = sp.limit(below / H**second, H, 0, "+")
    # dist >= |F e1| - 1, tested where it is sharp and where it is not.
    gap = energy_well.distance_squared(sp.diag(1 + s, 1, 1), sp.eye(3)) - s**2
    shown = "a stretched sheet has limit energy 2 s^2 per area for h^1 and is excluded for h^3"
    return combined(
        {
            "distance along a line": identities(setting, {"gap": gap}, shown=shown),
            "allowed": statement(
                bool(finite.is_finite), shown=shown, witness=f"I / h^{first} tends to {finite}"
            ),
            "excluded": statement(
                excluded == sp.oo, shown=shown, witness=f"I / h^{second} may stay below {excluded}"
            ),
        },
        shown=shown,
    )


def cell_problem(setting: Setting, *, curvature_factor: str = "1") -> Evidence:
    """Whether no correction linear in the thickness lowers the bending energy of an isometry.

    curvature_factor: the least coefficient claimed, in units of kappa_1^2 + kappa_2^2.
    """
    second = sp.Matrix(2, 2, sp.symbols("m1 m2 m2 m3", real=True))
    least = plate_energy.bending_coefficient(second, sp.eye(2))
    claimed = sp.Rational(curvature_factor) * energy_well.squared_norm(second)
    return identities(
        setting,
        {"least coefficient": least - claimed},
        shown="rotations and directors linear in t cannot lower |M|^2: the extension is optimal",
    )
