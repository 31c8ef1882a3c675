r"""The quadratic saddle over a star: what a surface of curvature -1 looks like at a branch point.

Rays leave the origin at the angles beta_0 = 0 < beta_1 < ... < beta_2m = 2 pi; between two rays the
height w is the quadratic form that vanishes on both and has Hessian determinant -1, its sign
changing from sector to sector. A star is given by the angles of its sectors, rational multiples
of pi with sum 2 pi, each below pi.
"""

from collections.abc import Sequence
from typing import Any

import sympy as sp

Angles = Sequence[Any]


def regular_star(order: int) -> tuple[Any, ...]:
    """2m equal angles of the star of this order m."""
    return (sp.pi / order,) * (2 * order)


def ray_angle(angles: Angles, i: int) -> Any:
    """Polar angle of ray i, the first ray of sector i."""
    return sum(angles[:i], sp.Integer(0))


def direction(angle: Any) -> sp.Matrix:
    """Return the unit vector of the plane at this polar angle."""
    return sp.Matrix([sp.cos(angle), sp.sin(angle)])


def sector_hessian(angles: Angles, i: int) -> sp.Matrix:
    """Hessian of the height on sector i, positive inside the sectors of even i.

    A form that vanishes on both rays is a multiple of the product of their normals.
    """
    first = direction(ray_angle(angles, i) + sp.pi / 2)
    second = direction(ray_angle(angles, i + 1) - sp.pi / 2)
    product = first * second.T + second * first.T
    sign = 1 if i % 2 == 0 else -1
    return sign * product / sp.sin(angles[i])


def middle_height(angles: Angles, i: int) -> Any:
    """Height on the bisector of sector i, at distance 1 from the origin."""
    bisector = direction(ray_angle(angles, i) + angles[i] / 2)
    return (bisector.T * sector_hessian(angles, i) * bisector)[0, 0] / 2


def count_sides(angles: Angles) -> tuple[int, int]:
    """Count the sectors above and below the tangent plane, by the exact sign of the height."""
    heights = [middle_height(angles, i) for i in range(len(angles))]
    return sum(bool(h > 0) for h in heights), sum(bool(h < 0) for h in heights)


def gradient_jump(angles: Angles, i: int) -> sp.Matrix:
    """Jump of the gradient of the height across ray i, at distance 1 from the origin."""
    ray = direction(ray_angle(angles, i))
    return (sector_hessian(angles, i) - sector_hessian(angles, i - 1 + _turn(angles, i))) * ray


def hessian_jump(angles: Angles, i: int) -> Any:
    """Jump across ray i of the second derivative along its normal."""
    normal = direction(ray_angle(angles, i) + sp.pi / 2)
    change = sector_hessian(angles, i) - sector_hessian(angles, i - 1 + _turn(angles, i))
    return sp.simplify((normal.T * change * normal)[0, 0])


def _turn(angles: Angles, i: int) -> int:
    return len(angles) if i == 0 else 0


def gradient_angle(angles: Angles, i: int) -> Any:
    """Polar angle of the gradient on ray i: normal to the ray, of alternating sense."""
    return ray_angle(angles, i) + sp.pi / 2 + (i % 2) * sp.pi


def winding_number(angles: Angles) -> Any:
    """Count the turns of the gradient along a circuit of the origin.

    On a sector it is a linear map of determinant -1: it turns backwards, by less than pi.
    """
    total = sum(
        sp.Mod(gradient_angle(angles, i + 1) - gradient_angle(angles, i), 2 * sp.pi) - 2 * sp.pi
        for i in range(len(angles))
    )
    return sp.nsimplify(sp.simplify(total / (2 * sp.pi)))


def asymptotic_angles(angles: Angles) -> list[Any]:
    """Angle phi on each sector at the centre, rays of even number being u-curves.

    cos phi = sigma r_u . r_v with both tangents leaving the centre, sigma the sign of their
    orientation: +1 on the sectors that begin with a u-curve, counter-clockwise. Each sector is
    turned so that its first ray is the x-axis.
    """
    found = []
    for i, angle in enumerate(angles):
        first, second = direction(sp.Integer(0)), direction(angle)
        r_u, r_v = (first, second) if i % 2 == 0 else (second, first)
        sigma = sp.sign(r_u[0] * r_v[1] - r_u[1] * r_v[0])
        found.append(sp.acos(sigma * (r_u.T * r_v)[0, 0]))
    return found
