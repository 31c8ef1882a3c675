"""The hyperbolic plane H^2 in the Poincare disk (def:H2): metric, curvature, symmetries, circles.

The metric is induced by the hyperboloid -X0^2 + X1^2 + X2^2 = -1, seen from the point (-1, 0, 0).
A conformal metric is given by its factor f: g = f (dx^2 + dy^2).
"""

from typing import Any

import sympy as sp

X, Y = sp.symbols("x y", real=True)


def hyperboloid_point(x: Any, y: Any) -> tuple[Any, Any, Any]:
    """Point of the hyperboloid that is projected to (x, y), where x^2 + y^2 < 1.

    The second intersection with the line that leaves (-1, 0, 0) in the direction (1, x, y).
    """
    t = sp.Dummy("t")
    on_hyperboloid = -((t - 1) ** 2) + t**2 * (x**2 + y**2) + 1
    distance = sp.solve(sp.cancel(on_hyperboloid / t), t)[0]
    return (distance - 1, distance * x, distance * y)


def disk_metric() -> sp.Matrix:
    """Metric of the disk in the coordinates (X, Y), induced by the hyperboloid."""
    point = hyperboloid_point(X, Y)
    steps = [[sp.diff(entry, s) for entry in point] for s in (X, Y)]
    return sp.Matrix(
        2,
        2,
        lambda i, j: sp.factor(
            -steps[i][0] * steps[j][0] + steps[i][1] * steps[j][1] + steps[i][2] * steps[j][2]
        ),
    )


def conformal_curvature(factor: Any) -> Any:
    """Gauss curvature of factor (dx^2 + dy^2): minus half the Laplacian of log factor, over it."""
    gradient = [sp.diff(factor, s) for s in (X, Y)]
    laplacian = sum(sp.diff(factor, s, 2) for s in (X, Y))
    slope = sum(entry**2 for entry in gradient)
    return (slope - factor * laplacian) / (2 * factor**3)


def killing_fields(factor: Any, *, degree: int) -> list[tuple[Any, Any]]:
    """Basis of the Killing fields of factor (dx^2 + dy^2) with polynomial entries up to degree.

    factor: rational in X, Y. The flow of (a, b) preserves the metric where it is conformal,
    a_x = b_y and a_y = -b_x, and where a f_x + b f_y + f (a_x + b_y) = 0.
    """
    powers = [X**i * Y**j for i in range(degree + 1) for j in range(degree + 1 - i)]
    unknowns = sp.symbols(f"k0:{2 * len(powers)}")
    a = sum(c * p for c, p in zip(unknowns, powers, strict=False))
    b = sum(c * p for c, p in zip(unknowns[len(powers) :], powers, strict=True))
    growth = a * sp.diff(factor, X) + b * sp.diff(factor, Y)
    equations = [
        sp.diff(a, X) - sp.diff(b, Y),
        sp.diff(a, Y) + sp.diff(b, X),
        growth + factor * (sp.diff(a, X) + sp.diff(b, Y)),
    ]
    coefficients = [
        c
        for equation in equations
        for c in sp.Poly(sp.fraction(sp.together(equation))[0], X, Y).coeffs()
    ]
    system = sp.Matrix([[sp.diff(c, k) for k in unknowns] for c in coefficients])
    return [
        (
            sp.expand(a.subs(dict(zip(unknowns, vector, strict=True)))),
            sp.expand(b.subs(dict(zip(unknowns, vector, strict=True)))),
        )
        for vector in system.nullspace()
    ]


def boundary_pole(factor: Any) -> int:
    """Order of the pole of a rational rotationally symmetric factor on the circle x^2 + y^2 = 1.

    The radial length of the disk, the integral of sqrt(factor), is infinite if it is 2 or more.
    """
    along = sp.cancel(factor.subs({X: 1 - Y, Y: sp.Integer(0)}, simultaneous=True))
    top, bottom = (sp.Poly(part, Y) for part in sp.fraction(along))
    return _order(bottom) - _order(top)


def _order(polynomial: sp.Poly) -> int:
    return min(int(power) for (power,) in polynomial.monoms())


def euclidean_radius(radius: Any) -> Any:
    """Radius in the disk of the circle about the centre at this geodesic distance.

    The distance d from (1, 0, 0) has cosh d = X0 on the hyperboloid.
    """
    return sp.tanh(radius / 2)


def perimeter(radius: Any) -> Any:
    """Length of the geodesic circle of this radius: on the hyperboloid it is a Euclidean circle."""
    return 2 * sp.pi * hyperboloid_point(euclidean_radius(radius), 0)[1]


def area(radius: Any) -> Any:
    """Area of the geodesic disk of this radius, by integration of the area element."""
    t = sp.Symbol("t", positive=True)
    density = disk_metric()[0, 0].subs({X: t, Y: 0}) * t
    primitive = sp.integrate(density, t)
    return 2 * sp.pi * (primitive.subs(t, euclidean_radius(radius)) - primitive.subs(t, 0))


def jacobi_perimeter(radius: Any, *, curvature: int) -> Any:
    """Length of the geodesic circle where K is -1, 0 or 1: 2 pi L with L'' = -K L, L'(0) = 1."""
    t = sp.Dummy("t", positive=True)
    length = sp.Function("L")
    start = {length(0): 0, length(t).diff(t).subs(t, 0): 1}
    solution = sp.dsolve(length(t).diff(t, 2) + curvature * length(t), length(t), ics=start)
    return 2 * sp.pi * solution.rhs.subs(t, radius)
