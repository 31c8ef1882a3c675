"""Curves through a point, tangent to a common plane there, and the saddles that can hold them.

To second order a curve of curvature k whose osculating plane makes the angle psi with the common
plane rises above it as k sin(psi) t^2/2. Its torsion does not enter. A surface of curvature -1
that consists of C^2 sectors bounded by asymptotic curves through the point has over each sector of
angle a a height sin(b) sin(a - b)/sin(a) t^2 in the direction b, at most tan(a/2)/2 t^2.
"""

from collections.abc import Sequence
from typing import Any

import sympy as sp

from theory.vectors import Vector, added, cross, dot, scaled


def rise(curvature: Any, tilt: Any) -> Any:
    """Return the normal curvature k sin psi that a curve prescribes to the surface."""
    return curvature * sp.sin(tilt)


def largest_height(angle: Any) -> Any:
    """Largest height over t^2 in a sector of this angle: that on its bisector."""
    return sp.sin(angle / 2) ** 2 / sp.sin(angle)


def least_angle(normal_curvature: Any) -> Any:
    """Least angle of a sector that holds a curve of this normal curvature: 2 atan |k|."""
    return 2 * sp.atan(sp.Abs(normal_curvature))


def total_angle_needed(normal_curvatures: Sequence[Any]) -> Any:
    """Sum of the least angles of the sectors of curves that lie in different sectors."""
    return sum((least_angle(k) for k in normal_curvatures), sp.Integer(0))


def corner_residuals(angle: Any, torsions: tuple[int, int]) -> dict[str, Any]:
    """Conditions at the corner of a sector between two curves with these torsions, +1 or -1.

    The common plane is the osculating plane of both at the corner, so that its normal N is their
    binormal and N' = -torsion (N x tangent), by Frenet. Each curve is an asymptotic line if its
    tangent is -torsion (N' x N). For a front that contains both, N_uv is parallel to N, so that
    r_uv = r_vu asks the cross products of N_u and N_v in the two equations to match.
    """
    normal: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(1))
    tangents: tuple[Vector, Vector] = (
        (sp.Integer(1), sp.Integer(0), sp.Integer(0)),
        (sp.cos(angle), sp.sin(angle), sp.Integer(0)),
    )
    rates = [
        scaled(-torsion, cross(normal, tangent))
        for torsion, tangent in zip(torsions, tangents, strict=True)
    ]
    lines = [
        added(scaled(-torsion, cross(rate, normal)), scaled(-1, tangent))
        for torsion, rate, tangent in zip(torsions, rates, tangents, strict=True)
    ]
    mixed = added(
        scaled(-torsions[0], cross(rates[0], rates[1])),
        scaled(torsions[1], cross(rates[1], rates[0])),
    )
    areas = dot(normal, cross(*rates)) + dot(normal, cross(*tangents))
    return {
        "r_u minus tangent": lines[0],
        "r_v minus tangent": lines[1],
        "r_uv minus r_vu": mixed,
        "K + 1 times the area": areas,
    }
