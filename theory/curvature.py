"""Curvatures of a surface in R^3, from its fundamental forms and from its metric alone.

A form is a symmetric 2x2 sympy matrix in the coordinates at hand. The normal is
r_x cross r_y / |r_x cross r_y| and the second form is h_ij = N . r_ij, so that a sphere seen along
its inward normal has positive curvatures.
"""

from typing import Any

import sympy as sp

from theory.vectors import Vector, added, cross, derivative, dot, scaled

Coordinates = tuple[sp.Symbol, sp.Symbol]


def unit_normal(r: Vector, coordinates: Coordinates) -> Vector:
    """Give the unit normal of the immersion r, along the product of its coordinate derivatives."""
    x, y = coordinates
    n = cross(derivative(r, x), derivative(r, y))
    return scaled(1 / sp.sqrt(dot(n, n)), n)


def first_form(r: Vector, coordinates: Coordinates) -> sp.Matrix:
    """First fundamental form dr . dr of the immersion r."""
    steps = [derivative(r, x) for x in coordinates]
    return sp.Matrix(2, 2, lambda i, j: dot(steps[i], steps[j]))


def second_form(r: Vector, coordinates: Coordinates) -> sp.Matrix:
    """Second fundamental form N . d^2 r of the immersion r."""
    normal = unit_normal(r, coordinates)
    return sp.Matrix(2, 2, lambda i, j: dot(normal, derivative(r, coordinates[i], coordinates[j])))


def shape_operator(first: sp.Matrix, second: sp.Matrix) -> sp.Matrix:
    """Matrix of the shape operator, whose eigenvalues are the principal curvatures."""
    return first.adjugate() * second / first.det()


def principal_pair(first: sp.Matrix, second: sp.Matrix) -> tuple[sp.Expr, sp.Expr]:
    """Both roots k of det(second - k first) = 0, the larger first where they are real."""
    k = sp.Dummy("k")
    square, linear, constant = sp.Poly((second - k * first).det(), k).all_coeffs()
    root = sp.sqrt(linear**2 - 4 * square * constant)
    return (-linear + root) / (2 * square), (-linear - root) / (2 * square)


def christoffel(metric: sp.Matrix, coordinates: Coordinates) -> list[sp.Matrix]:
    """Christoffel symbols of the metric: entry k is the matrix of Gamma^k_ij."""
    inverse = metric.adjugate() / metric.det()
    lowered = [
        sp.Matrix(
            2,
            2,
            lambda i, j, m=m: (
                (
                    metric[m, i].diff(coordinates[j])
                    + metric[m, j].diff(coordinates[i])
                    - metric[i, j].diff(coordinates[m])
                )
                / 2
            ),
        )
        for m in range(2)
    ]
    return [inverse[k, 0] * lowered[0] + inverse[k, 1] * lowered[1] for k in range(2)]


def intrinsic_curvature(metric: sp.Matrix, coordinates: Coordinates) -> sp.Expr:
    """Gauss curvature of a metric, R_1212 / det: no normal and no second form enters."""
    gamma = christoffel(metric, coordinates)
    x, y = coordinates
    riemann = [
        gamma[k][1, 1].diff(x)
        - gamma[k][0, 1].diff(y)
        + sum(gamma[k][0, m] * gamma[m][1, 1] - gamma[k][1, m] * gamma[m][0, 1] for m in range(2))
        for k in range(2)
    ]
    return (metric[0, 0] * riemann[0] + metric[0, 1] * riemann[1]) / metric.det()


def covariant_hessian_squared(r: Vector, coordinates: Coordinates) -> sp.Expr:
    """Squared norm, in the induced metric, of the covariant Hessian of the map r."""
    metric = first_form(r, coordinates)
    gamma = christoffel(metric, coordinates)
    inverse = metric.adjugate() / metric.det()
    steps = [derivative(r, x) for x in coordinates]

    def entry(i: int, j: int) -> Vector:
        flat = derivative(r, coordinates[i], coordinates[j])
        tangential = added(scaled(gamma[0][i, j], steps[0]), scaled(gamma[1][i, j], steps[1]))
        return added(flat, scaled(-1, tangential))

    pairs = [(i, j) for i in range(2) for j in range(2)]
    return sum(
        inverse[i, k] * inverse[j, m] * dot(entry(i, j), entry(k, m))
        for i, j in pairs
        for k, m in pairs
    )


def asymptotic_forms(half_tangent: sp.Symbol) -> tuple[sp.Matrix, sp.Matrix]:
    """Fundamental forms, at curvature -1, of unit asymptotic directions at the angle 2 atan(t).

    half_tangent: a positive symbol t. Both directions have no normal curvature, and the mixed
    entry m of the second form follows from Gauss: -m^2 = -1 times the determinant of the first.
    The normal is the one for which m > 0.
    """
    cosine = (1 - half_tangent**2) / (1 + half_tangent**2)
    first = sp.Matrix([[1, cosine], [cosine, 1]])
    mixed = sp.sqrt(sp.factor(first.det()))
    return first, sp.Matrix([[0, mixed], [mixed, 0]])


def principal_curvatures(phi: Any) -> tuple[sp.Expr, sp.Expr]:
    """Positive and negative principal curvature where asymptotic lines meet at the angle phi.

    Curvature -1; phi: sympy expression in (0, pi), radians. The eigenvalues of the shape operator,
    in terms of tan(phi/2); the opposite normal exchanges their signs.
    """
    t = sp.Dummy("t", positive=True)
    operator = shape_operator(*asymptotic_forms(t)).applyfunc(sp.cancel)
    found = [sp.cancel(value) for value in operator.eigenvals()]
    positive = next(value for value in found if value.is_positive)
    negative = next(value for value in found if value.is_negative)
    tangent = sp.tan(sp.sympify(phi) / 2)
    return positive.subs(t, tangent), negative.subs(t, tangent)
