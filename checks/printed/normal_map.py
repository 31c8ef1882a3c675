"""The ramification index of the normal map and its relation to the order of saddleness, printed."""

from typing import Any

import sympy as sp

from theory.vectors import Vector, added, cross, dot, scaled


def tangential_part(pole: Vector, x: Vector, *, sign: int = -1) -> Vector:
    """Part x_perp of x in definition (def:Jp), the pole being N(p); any number type."""
    return added(x, scaled(sign * dot(pole, x), pole))


def retraction(pole: Vector, x: Vector, *, sign: int = -1, power: int = 1) -> Vector:
    """Retraction pi of the sphere without the two poles to its equator, definition (def:Jp)."""
    part = tangential_part(pole, x, sign=sign)
    return scaled(1 / sp.sqrt(dot(part, part)) ** power, part)


def index(order: Any, *, offset: int = 1, slope: int = -1) -> Any:
    """Ramification index J_p = 1 - m_p of lemma (lem:covering-number)."""
    return offset + slope * order


def is_branch_point(found: Any, *, threshold: int = 1, absolute: bool = True) -> bool:
    """Whether p with this J_p is called a branch point, line 671."""
    return bool((abs(found) if absolute else found) > threshold)


def graph_direction(gradient: tuple[Any, Any], *, sign: int = 1) -> tuple[Any, Any]:
    """Direction of pi(N) for the graph of w, from the gradient of w, line 673 (not normalised)."""
    return sign * gradient[0], sign * gradient[1]


def normal_rates(
    normal: Vector, r_u: Vector, r_v: Vector, *, u_sign: int = 1, v_sign: int = -1
) -> tuple[Vector, Vector]:
    """N_u and N_v in the proof of (lem:covering-number), line 691."""
    return scaled(u_sign, cross(normal, r_u)), scaled(v_sign, cross(normal, r_v))


def rates_product(r_u: Vector, r_v: Vector, *, sign: int = -1) -> Vector:
    """N_u x N_v as printed on line 691."""
    return scaled(sign, cross(r_u, r_v))


def image_angle(beta: Any, i: int, *, even: int = 1, odd: int = -1) -> Any:
    """Angle theta_i of the image of ray i under N, modulo 2 pi, line 691."""
    return beta + (even if i % 2 == 0 else odd) * sp.pi / 2


def two_steps(first: Any, last: Any, *, turns: int = -2) -> Any:
    """theta_{i+2} - theta_i from beta_i and beta_{i+2}, line 691."""
    return last - first + turns * sp.pi


def angle_total(order: Any, *, offset: int = 1, slope: int = -1) -> Any:
    """Sum of all theta_i - theta_{i-1} in the display on line 693."""
    return 2 * (offset + slope * order) * sp.pi
