"""Section 3.2, stars, as printed: sectors, pairs of coordinates, dual vectors (def:m-star).

s: direction of the ray of an index; shifts are added to the printed index i.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import sympy as sp

from theory.vectors import Vector, added, cross, dot, scaled

Rays = Callable[[int], Vector]


def direction(beta: Any, *, quarter_turns: int = 0) -> Vector:
    """Definition (def:m-star): s = cos(beta) e_1 + sin(beta) e_2."""
    angle = beta + quarter_turns * sp.pi / 2
    return (sp.cos(angle), sp.sin(angle), sp.Integer(0))


def partial_angles(angles: Sequence[Any], *, start: int = 0, lag: int = 0) -> list[Any]:
    """Angles beta_0 = 0, beta_i = beta_(i-1) + alpha_i; lag: subtracted from the index of alpha."""
    betas = [sp.Integer(start)]
    for i in range(1, len(angles) + 1):
        betas.append(betas[-1] + angles[(i - lag - 1) % len(angles)])
    return betas


def is_star(
    angles: Sequence[Fraction],
    lengths: Sequence[Fraction],
    *,
    whole_turn: bool = True,
    below_pi: bool = True,
    positive: bool = True,
    even: bool = True,
) -> bool:
    """Whether angles (in units of pi) and lengths are data of an m-star (def:m-star)."""
    return (
        (not whole_turn or sum(angles) == 2)
        and (not below_pi or all(0 < a < 1 for a in angles))
        and (not positive or all(length > 0 for length in lengths))
        and (not even or (len(angles) % 2 == 0 and len(angles) >= 4))
        and len(angles) == len(lengths)
    )


def sector_point(s: Rays, i: int, c: Any, d: Any, *, first: int = -1, second: int = 0) -> Vector:
    """Point of (def:sectors): c s_(i-1) + d s_i."""
    return added(scaled(c, s(i + first)), scaled(d, s(i + second)))


def in_range(value: Any, length: Any, *, closed: bool = False) -> bool:
    """Range 0 <= c < l of (def:sectors)."""
    return bool(0 <= value <= length if closed else 0 <= value < length)


def pair_point(
    s: Rays, i: int, xi: Any, eta: Any, *, positive: bool, sign: int = -1, behind: int = -1
) -> Vector:
    """Point xi s_i + eta s_(i+1) where eta >= 0 (positive), else xi s_i - eta s_(i-1)."""
    if positive:
        return added(scaled(xi, s(i)), scaled(eta, s(i + 1)))
    return added(scaled(xi, s(i)), scaled(sign * eta, s(i + behind)))


def pair_of_sectors(i: int, *, shift: int = 0) -> tuple[int, int]:
    """Sectors S_(i-1), S_i that the coordinates (xi_i, eta_i) are said to cover."""
    return i - 1 + shift, i + shift


def overlap(i: int, *, shift: int = 0) -> int:
    """Sector S^i, read as S_i, in which the patches of i and i + 1 are said to overlap."""
    return i + shift


def transition(xi: Any, eta: Any, *, sign: int = -1) -> tuple[Any, Any]:
    """Coordinates (xi_(i+1), eta_(i+1)) = (eta_i, -xi_i)."""
    return eta, sign * xi


def dual(s: Vector, *, sense: int = 1) -> Vector:
    """Dual vector s* = e_3 x s."""
    return scaled(sense, cross((sp.Integer(0), sp.Integer(0), sp.Integer(1)), s))


def dual_product(s: Rays, i: int) -> Any:
    """Product s*_(i+1) . s_i."""
    return dot(dual(s(i + 1)), s(i))


def dual_coordinates(
    s: Rays, i: int, x: Vector, *, sign: int = -1, exchanged: bool = False
) -> tuple[Any, Any]:
    """Display (s*_(i+1) . s_i)^-1 (s*_(i+1) . x, -s*_i . x) for (xi_i, eta_i)."""
    first, second = dot(dual(s(i + 1)), x), sign * dot(dual(s(i)), x)
    if exchanged:
        first, second = second, first
    return first / dual_product(s, i), second / dual_product(s, i)


def dual_product_value(beta: Any, beta_next: Any, *, sign: int = 1) -> Any:
    """Value sin(beta_(i+1) - beta_i) printed for s*_(i+1) . s_i."""
    return sign * sp.sin(beta_next - beta)


def sector_coordinates(i: int, xi: Any, eta: Any, *, even: int = 0) -> tuple[Any, Any]:
    """Right side of (eq:sector-coords): (xi_i, eta_i) for even i, (eta_i, xi_i) for odd i."""
    return (xi, eta) if i % 2 == even else (eta, xi)
