"""Section 3.5, the sine-Gordon equation with branch points, as printed."""

from collections.abc import Sequence
from typing import Any

import sympy as sp


def one_form(phi_u: Any, phi_v: Any, *, denominator: int = 2, sign_u: int = -1) -> tuple[Any, Any]:
    """Coefficients of du and dv in alpha = (phi_v dv - phi_u du)/2."""
    return sign_u * phi_u / denominator, phi_v / denominator


def metric(cos_phi: Any, sigma: Any, *, sigma_power: int = 1) -> sp.Matrix:
    """Matrix of g = du^2 + 2 sigma cos phi du dv + dv^2."""
    mixed = sigma**sigma_power * cos_phi
    return sp.Matrix([[1, mixed], [mixed, 1]])


def area_form(sin_phi: Any, sigma: Any, *, sigma_power: int = 1) -> Any:
    """Coefficient of du ^ dv in beta = sigma sin phi du ^ dv."""
    return sigma**sigma_power * sin_phi


def corner_sum(phi00: Any, phi01: Any, phi11: Any, phi10: Any, *, sign: int = -1) -> Any:
    """Left side of (eq:hazzidakis), phi_ij the angle at (u_i, v_j)."""
    return phi00 + sign * phi01 + phi11 + sign * phi10


def rectangle_area(area: Any, sigma: Any, *, sigma_power: int = 0, percent: int = 100) -> Any:
    """Right side of (eq:hazzidakis): A(R)."""
    return sigma**sigma_power * area * sp.Rational(percent, 100)


def area_bound(*, hundredths: int = 200) -> Any:
    """Bound on the area of an immersed asymptotic quadrilateral: 2 pi."""
    return sp.pi * sp.Rational(hundredths, 100)


def vertex_signs(families: Sequence[str], *, initial: str = "u") -> list[int]:
    """Signs (-1)^l_i of (eq:sg-hamburger): +1 at the initial vertex of each u-arc, else -1.

    families: of the arc that leaves each vertex, along the orientation.
    """
    return [1 if family == initial else -1 for family in families]


def is_hamburger_polygon(
    kinds: Sequence[str], simple: bool, *, mixed: bool = False, crossing: bool = False
) -> bool:
    """Definition: a Jordan curve of arcs that are u- or v-asymptotic curves.

    kinds: "u", "v" or "other" of each arc; mixed: whether other arcs are allowed too; crossing:
    whether the curve may cross itself.
    """
    return (simple or crossing) and (mixed or all(kind in ("u", "v") for kind in kinds))


def concentration(order: Any, *, sign: int = -1, regular: int = 2, percent: int = 100) -> Any:
    """Concentration -(m - 2) pi of Delta at a point of order m."""
    return sign * sp.Rational(percent, 100) * (order - regular) * sp.pi


def star_difference(area: Any, order: Any, *, area_sign: int = 1, **charge: int) -> Any:
    """Right side of the lemma (lem:m-star): A - (m - 2) pi."""
    return area_sign * area + concentration(order, **charge)


def strip_difference(r_plus: Any, r_minus: Any, q_minus: Any, q_plus: Any, *, sign: int = 1) -> Any:
    """Delta of the thin rectangle: phi(r+) - phi(r-) + phi(q-) - phi(q+); sign: of the q's."""
    return r_plus - r_minus + sign * (q_minus - q_plus)


def sector_angle(alpha: Any, counter_clockwise: bool, *, whole: Any = 1) -> Any:
    """Angle phi_j: alpha_j where r_u turns into r_v counter-clockwise, else pi - alpha_j."""
    return alpha if counter_clockwise else whole * sp.pi - alpha


def sector_angle_by_parity(alpha: Any, j: int, *, even: int = 0) -> Any:
    """Caption of (fig:concentrations): alpha_j on even sectors, pi - alpha_j on odd ones."""
    return alpha if j % 2 == even else sp.pi - alpha


def star_sum(phis: Sequence[Any], star: int, *, exponent: str = "i") -> Any:
    """Sum over j of (-1)^i phi_j, i the index of the branch point; exponent: by i and j."""
    powers = {"i": (star, 0), "2i": (2 * star, 0), "j": (0, 1), "j+1": (1, 1)}
    constant, slope = powers[exponent]
    return sum((-1) ** (constant + slope * j) * phi for j, phi in enumerate(phis))


def principal_curvatures(phi: Any, *, second: int = -1, halves: int = 1) -> tuple[Any, Any]:
    """Principal curvatures kappa_1 = tan phi/2 and kappa_2 = -cot phi/2."""
    half = halves * phi / 2
    return sp.tan(half), second * sp.cot(half)


def willmore_density(first: Any, second: Any, *, power: int = 2) -> Any:
    """Density kappa_1^2 + kappa_2^2 of the Willmore energy."""
    return first**power + second**power


def largest_curvature(first: Any, second: Any, *, absolute: bool = True) -> Any:
    """The larger of |kappa_1| and |kappa_2|."""
    return sp.Max(sp.Abs(first), sp.Abs(second)) if absolute else sp.Max(first, second)


def area_per_branch_point(order: int, *, percent: int = 100) -> Any:
    """Area pi that a branch point of order 3 makes up for; (m - 2) pi in general."""
    return (order - 2) * sp.pi * sp.Rational(percent, 100)
