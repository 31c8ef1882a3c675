"""The isometry problem, its exterior system and the hyperbolic plane: the opening of section 3."""

from typing import Any

import sympy as sp

from theory.vectors import Vector, cross, dot, scaled, triple


def is_w22_isometry(
    metric_gap: Any, gradient_jumps: bool, *, isometric: bool = True, sobolev: bool = True
) -> bool:
    """Problem W22isometry for a map that is smooth on both sides of a curve.

    metric_gap: dy . dy - g on the two sides; gradient_jumps: whether dy jumps across the curve,
    which is what keeps a continuous piecewise smooth map out of W^{2,2}_loc.
    """
    return (not isometric or all(e == 0 for e in metric_gap)) and (
        not sobolev or not gradient_jumps
    )


def gauss_normal(first: Vector, second: Vector, *, order: int = 1) -> Vector:
    """Gauss normal map of a C^1 map, from its coordinate derivatives."""
    normal = cross(first, second)
    return scaled(order / sp.sqrt(dot(normal, normal)), normal)


def exterior_system(
    normal: Vector,
    steps: tuple[Vector, Vector],
    normal_steps: tuple[Vector, Vector],
    kappa: Any,
    area: Any,
    *,
    sign: int = 1,
    area_power: int = 1,
) -> dict[str, Any]:
    """Residuals of thmegrg: N . dy = 0 and N^*(d Omega) = kappa dA, area being dA/(dx dy)."""
    return {
        "N . dy": [dot(normal, steps[0]), dot(normal, steps[1])],
        "N^*(d Omega) - kappa dA": triple(normal, *normal_steps) - sign * kappa * area**area_power,
    }


def poincare_factor(x: Any, y: Any, *, numerator: int = 4, power: int = 2) -> Any:
    """Factor of dx^2 + dy^2 in the metric of definition def:H2."""
    return numerator / (1 - (x**2 + y**2)) ** power
