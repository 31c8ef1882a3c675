"""Closed surfaces of curvature -1 and genus g >= 2, and why none of them lies in R^3.

Such a surface is a regular polygon of H^2 with 4g sides and corner angles 2 pi/(4g), its sides
glued in pairs: the 4g corners become one point of total angle 2 pi.
"""

from typing import Any

import sympy as sp


def corner_count(genus: int) -> int:
    """Return the number of corners of the polygon that gives the closed surface of this genus."""
    return 4 * genus


def side_and_diagonal(corners: int, cosh_radius: Any) -> tuple[Any, Any]:
    """Hyperbolic cosines of the side and of the diagonal across one corner of a regular polygon.

    cosh_radius: hyperbolic cosine of the circumradius. Law of cosines at the centre.
    """
    sinh_squared = cosh_radius**2 - 1
    step = 2 * sp.pi / corners
    side = cosh_radius**2 - sinh_squared * sp.cos(step)
    diagonal = cosh_radius**2 - sinh_squared * sp.cos(2 * step)
    return side, diagonal


def corner_cosine(corners: int, cosh_radius: Any) -> Any:
    """Cosine of the corner angle of the regular polygon: law of cosines for two equal sides."""
    side, diagonal = side_and_diagonal(corners, cosh_radius)
    return sp.simplify((side**2 - diagonal) / (side**2 - 1))


def cosh_circumradius(corners: int) -> Any:
    """Hyperbolic cosine of the circumradius at which the corner angles add up to 2 pi.

    The right triangle centre, corner, middle of a side has the angles pi/corners (twice) and pi/2.
    """
    half = sp.pi / corners
    return sp.radsimp(sp.cot(half) * sp.cot(half))


def euler_characteristic(genus: int) -> int:
    """One vertex, half as many edges as the polygon has sides, and one face."""
    return 1 - corner_count(genus) // 2 + 1


def area_by_angles(corners: int, corner_angle: Any) -> Any:
    """Area of a polygon of H^2 by its angle defect."""
    return (corners - 2) * sp.pi - corners * corner_angle


def curvature_at_farthest_point(distance: Any, excess: tuple[Any, Any]) -> Any:
    """Gauss curvature of a closed C^2 surface of R^3 where it is farthest from the origin.

    There |y|^2 has a maximum, so that y is normal and its Hessian 2 (g - distance h) is not
    positive, h being taken along -y: both principal curvatures exceed 1/distance, by excess >= 0.
    """
    return (1 / distance + excess[0]) * (1 / distance + excess[1])
