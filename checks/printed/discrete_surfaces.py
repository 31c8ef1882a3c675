"""Section 4 up to the compatibility condition, as printed: grids and discrete Lelieuvre equations.

Vectors are triples of scalars of any kind; the products are those of R^3.
"""

from collections.abc import Callable
from typing import Any

from theory.vectors import Vector, added, cross, scaled

Node = tuple[int, int]


def grid_nodes(i_k: int, j_k: int, *, first_u: int = 0, first_v: int = 1) -> set[Node]:
    """Grid M_k in units of epsilon: {0, ..., i_k} x {1, ..., j_k}; first_u, first_v: the starts."""
    return {(i, j) for i in range(first_u, i_k + 1) for j in range(first_v, j_k + 1)}


def u_curve(i_k: int, j_0: int, *, first: int = 0) -> set[Node]:
    """Discrete u-curve {(i, j_0) : 0 <= i <= i_k} in units of epsilon."""
    return {(i, j_0) for i in range(first, i_k + 1)}


def v_curve(i_0: int, j_k: int, *, first: int = 0) -> set[Node]:
    """Discrete v-curve {(i_0, j) : 0 <= j <= j_k} in units of epsilon."""
    return {(i_0, j) for j in range(first, j_k + 1)}


def grid_face(i: int, j: int, *, width: int = 1) -> tuple[Node, Node, Node, Node]:
    """Corners of the face [i, i + 1] x [j, j + 1] in units of epsilon, counterclockwise."""
    return (i, j), (i + width, j), (i + width, j + width), (i, j + width)


def shifted(
    f: Callable[[int, int], Any], i: int, j: int, *, first: Node = (1, 0), second: Node = (0, 1)
) -> tuple[Any, Any, Any, Any]:
    """Values f_0, f_1, f_2, f_12 of f on an elementary quad; first, second: the two shifts."""
    return (
        f(i, j),
        f(i + first[0], j + first[1]),
        f(i + second[0], j + second[1]),
        f(i + first[0] + second[0], j + first[1] + second[1]),
    )


def step_u(n_0: Vector, n_1: Vector, *, sign: int = 1) -> Vector:
    """First half of (eq:d_lelieuvre): r_1 - r_0 = N_1 x N_0."""
    return scaled(sign, cross(n_1, n_0))


def step_v(n_0: Vector, n_2: Vector, *, sign: int = -1) -> Vector:
    """Second half of (eq:d_lelieuvre): r_2 - r_0 = -N_2 x N_0."""
    return scaled(sign, cross(n_2, n_0))


def far_by_1(
    r_0: Vector, n_0: Vector, n_1: Vector, n_12: Vector, *, first: int = 1, second: int = -1
) -> Vector:
    """Vertex r_12 along 0 - 1 - 12: r_0 + N_1 x N_0 - N_12 x N_1."""
    return added(r_0, added(scaled(first, cross(n_1, n_0)), scaled(second, cross(n_12, n_1))))


def far_by_2(
    r_0: Vector, n_0: Vector, n_2: Vector, n_12: Vector, *, first: int = -1, second: int = 1
) -> Vector:
    """Vertex r_12 along 0 - 2 - 12: r_0 - N_2 x N_0 + N_12 x N_2."""
    return added(r_0, added(scaled(first, cross(n_2, n_0)), scaled(second, cross(n_12, n_2))))


def gap_of_paths(n_0: Vector, n_1: Vector, n_2: Vector, n_12: Vector, *, last: int = 1) -> Vector:
    """Left side of (eq:d_compatible); last: sign of N_12 x N_2 inside the bracket."""
    first = added(cross(n_1, n_0), scaled(-1, cross(n_12, n_1)))
    bracket = added(scaled(-1, cross(n_2, n_0)), scaled(last, cross(n_12, n_2)))
    return added(first, scaled(-1, bracket))


def product_of_sums(
    n_0: Vector, n_1: Vector, n_2: Vector, n_12: Vector, *, sign: int = 1
) -> Vector:
    """Middle of (eq:d_compatible): (N_1 + N_2) x (N_0 + N_12); sign: of N_2."""
    return cross(added(n_1, scaled(sign, n_2)), added(n_0, n_12))


def discretised(
    n_0: Vector, n_1: Vector, n_2: Vector, n_12: Vector, *, quarter: Any, difference: int = -1
) -> Vector:
    """First line of (eqn:discreteconstantcurvaturepde).

    quarter: 1/4 in the type of the scalars; difference: sign of N_1 + N_2 in the first factor.
    """
    mixed = added(added(n_12, n_0), scaled(difference, added(n_1, n_2)))
    return cross(mixed, scaled(quarter, added(added(n_0, n_1), added(n_2, n_12))))


def expanded(
    n_0: Vector, n_1: Vector, n_2: Vector, n_12: Vector, *, half: Any, last: int = -1
) -> Vector:
    """Second line of (eqn:discreteconstantcurvaturepde); half: 2/4; last: sign of N_2 x N_0."""
    first = added(cross(n_0, n_1), scaled(-1, cross(n_1, n_12)))
    second = added(cross(n_12, n_2), scaled(last, cross(n_2, n_0)))
    return scaled(half, added(first, second))


def factored(
    n_0: Vector, n_1: Vector, n_2: Vector, n_12: Vector, *, half: Any, sign: int = 1
) -> Vector:
    """Third line of (eqn:discreteconstantcurvaturepde): half (N_0 + N_12) x (N_1 + N_2)."""
    return scaled(half, cross(added(n_0, scaled(sign, n_12)), added(n_1, n_2)))
