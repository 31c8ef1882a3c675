"""Energies of thin plates, from a three-dimensional density and the Kirchhoff-Love extension.

The extension of an immersion r of the centre surface is r + t N, |t| < h/2. Forms are 2x2 sympy
matrices in an orthonormal frame of the reference metric, unless coordinates are given.
"""

from typing import Any

import sympy as sp

from theory.curvature import Coordinates, unit_normal
from theory.energy_well import distance_squared, squared_norm
from theory.vectors import Vector, added, derivative, dot, scaled


def lame_moduli(young: Any, poisson: Any) -> tuple[sp.Expr, sp.Expr]:
    """Lame's moduli lambda, mu of the material of Young's modulus and Poisson ratio given.

    They follow from the uniaxial test: under the strain e along one axis, the lateral strains that
    minimise the energy are -poisson e, and the energy is then young e^2 / 2 per volume.
    """
    lam, mu, lateral = sp.symbols("lambda mu lateral")
    density = quadratic_density(sp.diag(1, lateral, lateral), lam, mu)
    free = sp.Eq(sp.diff(density, lateral).subs(lateral, -poisson), 0)
    measured = sp.Eq(density.subs(lateral, -poisson), sp.sympify(young) / 2)
    (solution,) = sp.solve([free, measured], [lam, mu], dict=True)
    return solution[lam], solution[mu]


def quadratic_density(strain: sp.Matrix, lam: Any, mu: Any) -> sp.Expr:
    """Isotropic energy per volume, quadratic in the strain."""
    return mu * squared_norm(strain) + lam * strain.trace() ** 2 / 2


def normal_strain(in_plane: sp.Matrix, poisson: Any) -> sp.Expr:
    """Strain across the thickness that minimises the energy of a strain in the plane."""
    across = sp.Symbol("across")
    lam, mu = lame_moduli(1, poisson)
    strain = sp.diag(in_plane, across)
    (best,) = sp.solve(sp.diff(quadratic_density(strain, lam, mu), across), across)
    return best


def kirchhoff_love_gram(r: Vector, coordinates: Coordinates, t: sp.Symbol) -> sp.Matrix:
    """Gram matrix, in the coordinates and t, of the Kirchhoff-Love extension r + t N."""
    lifted = added(r, scaled(t, unit_normal(r, coordinates)))
    steps = [derivative(lifted, x) for x in (*coordinates, t)]
    return sp.Matrix(3, 3, lambda i, j: dot(steps[i], steps[j]))


def parallel_metric(first: sp.Matrix, second: sp.Matrix, t: Any) -> sp.Matrix:
    """First form of the parallel surface r + t N: first (1 - t S)^2, S = first^-1 second."""
    shape = first.inv() * second
    return first * (sp.eye(2) - t * shape) ** 2


def thickness_energy(
    first: sp.Matrix, second: sp.Matrix, thickness: sp.Symbol, *, young: Any
) -> sp.Expr:
    """Energy per reference area of the extension, at Poisson ratio 0, a polynomial in thickness.

    The strain is half the metric of the parallel surface minus the identity, the reference metric.
    """
    t = sp.Symbol("t", real=True)
    lam, mu = lame_moduli(young, 0)
    strain = (parallel_metric(first, second, t) - sp.eye(2)) / 2
    density = quadratic_density(sp.diag(strain, 0), lam, mu)
    return sp.expand(sp.integrate(sp.expand(density), (t, -thickness / 2, thickness / 2)))


def extension_energy(
    kappa_1: Any, kappa_2: Any, thickness: sp.Symbol, *, stretch: Any = 1
) -> sp.Expr:
    """Squared distance to SO(3) of the Kirchhoff-Love extension, integrated over the thickness.

    Per reference area, for principal curvatures kappa_i before the centre surface is scaled in its
    tangent plane by stretch (1 for an isometry). Exact while every principal stretch
    stretch (1 - t kappa_i) is positive, that is |kappa_i| thickness < 2.
    """
    t = sp.Symbol("t", real=True)
    stretches = sp.symbols("s1 s2", positive=True)
    density = distance_squared(sp.diag(*stretches, 1), sp.eye(3))
    found = (stretch * (1 - t * kappa_1), stretch * (1 - t * kappa_2))
    at = dict(zip(stretches, found, strict=True))
    return sp.integrate(sp.expand(density.subs(at)), (t, -thickness / 2, thickness / 2))


def bending_coefficient(curvature: sp.Matrix, root: sp.Matrix) -> sp.Expr:
    """Least coefficient of t^2 in the squared distance of R (A - t M A + t d (x) e3) to SO(3) A.

    curvature: symmetric 2x2 matrix M, bordered by zeros; root: A, bordered by 1. Minimised over the
    third column d, which an extension may choose, and over the skew part of the rotation.
    """
    x, y, z, *column = sp.symbols("x y z d1:4", real=True)
    skew = sp.Matrix([[0, x, y], [-x, 0, z], [-y, -z, 0]])
    rate = (sp.diag(curvature, 0) - skew) * sp.diag(root, 1)
    rate[:, 2] += sp.Matrix(column)
    cost = squared_norm(rate)
    unknowns = [x, y, z, *column]
    (best,) = sp.linsolve([sp.diff(cost, u) for u in unknowns], unknowns)
    least = cost.subs(dict(zip(unknowns, best, strict=True)), simultaneous=True)
    return sp.cancel(least)


def membrane_orders() -> dict[str, set[tuple[int, int, int]]]:
    """Powers (i, j, k) of in-plane size a, out-of-plane size b and length c in a bent sheet.

    The map (x, y) + a (U, V), b W of a flat sheet, U, V, W functions of x/c and y/c: `linear` and
    `quadratic` hold the lowest terms of the strain in the in-plane and in the out-of-plane
    displacement, `bending` those of the second form.
    """
    a, b, rate = sp.symbols("a b rate", positive=True)
    x, y = sp.symbols("x y", real=True)
    u, v, w = (sp.Function(name)(x, y) for name in "uvw")
    r = (x / rate + a * u, y / rate + a * v, b * w)
    step, bend = scaled(rate, derivative(r, x)), scaled(rate**2, derivative(r, x, x))
    gram = sp.Poly(sp.expand(dot(step, step) - 1), a, b, rate).monoms()
    bending = sp.Poly(sp.expand(dot((0, 0, 1), bend)), a, b, rate).monoms()
    return {
        "linear": {(i, j, -k) for i, j, k in gram if j == 0 and i == 1},
        "quadratic": {(i, j, -k) for i, j, k in gram if i == 0},
        "bending": {(i, j, -k) for i, j, k in bending},
    }
