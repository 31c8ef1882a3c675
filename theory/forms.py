"""The three fundamental forms of a surface, and the Gauss curvature of a metric by itself."""

from collections.abc import Callable
from typing import Any

import sympy as sp

from theory.asymptotic_net import VectorCalculus
from theory.vectors import Vector, triple

Form = tuple[Any, Any, Any]
Rate = Callable[[Any, str], Any]


def first_form(calculus: VectorCalculus, r_u: Vector, r_v: Vector) -> Form:
    """Coefficients E, F, G of dr.dr = E du^2 + 2 F du dv + G dv^2."""
    return calculus.dot(r_u, r_u), calculus.dot(r_u, r_v), calculus.dot(r_v, r_v)


def second_form(calculus: VectorCalculus, r_u: Vector, r_v: Vector, normal: Vector) -> Form:
    """Coefficients e, f, g of N.d^2 r = e du^2 + 2 f du dv + g dv^2, from second derivatives."""
    uu, uv, vv = (
        calculus.derivative(r_u, "u"),
        calculus.derivative(r_u, "v"),
        calculus.derivative(r_v, "v"),
    )
    return calculus.dot(uu, normal), calculus.dot(uv, normal), calculus.dot(vv, normal)


def third_form(calculus: VectorCalculus, normal: Vector) -> Form:
    """Coefficients of dN.dN, the metric of the normal on the sphere, by du^2, 2 du dv, dv^2."""
    n_u, n_v = calculus.derivative(normal, "u"), calculus.derivative(normal, "v")
    return calculus.dot(n_u, n_u), calculus.dot(n_u, n_v), calculus.dot(n_v, n_v)


def determinant(form: Form) -> Any:
    """Return the determinant of a quadratic form given by its three coefficients."""
    return form[0] * form[2] - form[1] ** 2


def twice_mean_curvature(first: Form, second: Form) -> Any:
    """Trace of the shape operator, 2H = k1 + k2, of the surface with these forms."""
    mixed = first[0] * second[2] - 2 * first[1] * second[1] + first[2] * second[0]
    return mixed / determinant(first)


def third_from_others(first: Form, second: Form) -> Form:
    """Third form by the characteristic equation of the shape operator: III = 2H II - K I."""
    trace = twice_mean_curvature(first, second)
    product = determinant(second) / determinant(first)
    return (
        trace * second[0] - product * first[0],
        trace * second[1] - product * first[1],
        trace * second[2] - product * first[2],
    )


def brioschi(first: Form, rate: Rate) -> Any:
    """Gauss curvature of a metric by Brioschi's formula, from the metric and nothing else.

    first: E, F, G; rate: partial derivative of a scalar along "u" or "v". Undefined where the
    metric degenerates.
    """
    E, F, G = (sp.sympify(entry) for entry in first)
    corner = -rate(rate(E, "v"), "v") / 2 + rate(rate(F, "u"), "v") - rate(rate(G, "u"), "u") / 2
    bent = triple(
        (corner, rate(E, "u") / 2, rate(F, "u") - rate(E, "v") / 2),
        (rate(F, "v") - rate(G, "u") / 2, E, F),
        (rate(G, "v") / 2, F, G),
    )
    sheared = triple(
        (0, rate(E, "v") / 2, rate(G, "u") / 2),
        (rate(E, "v") / 2, E, F),
        (rate(G, "u") / 2, F, G),
    )
    return (bent - sheared) / (E * G - F**2) ** 2


def coordinate_line_curvatures(first: Form, area: Any, rate: Rate) -> tuple[Any, Any]:
    """Geodesic curvatures of the u- and v-lines of a metric, from the metric and nothing else.

    area: the square root of EG - F^2 whose sign is that of the orientation of (u, v). From the
    component of the covariant derivative of the tangent across the line.
    """
    E, F, G = (sp.sympify(entry) for entry in first)
    square = E * G - F**2
    across_u = (E * (rate(F, "u") - rate(E, "v") / 2) - F * rate(E, "u") / 2) / square
    across_v = (G * (rate(F, "v") - rate(G, "u") / 2) - F * rate(G, "v") / 2) / square
    return area * across_u / E ** sp.Rational(3, 2), -area * across_v / G ** sp.Rational(3, 2)
