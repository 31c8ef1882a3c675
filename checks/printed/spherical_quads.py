"""Section 4, one quad of the normal field, as printed: (eq:householder) and (eq:d_chebyshev).

Vectors are triples of scalars of any kind, the product is that of R^3.
"""

from typing import Any

from theory.vectors import Vector, added, dot, scaled


def moutard(n_0: Vector, n_1: Vector, n_2: Vector, nu: Any, *, sign: int = -1) -> Vector:
    """Display before the quadratic equation: N_12 = nu (N_1 + N_2) - N_0."""
    return added(scaled(nu, added(n_1, n_2)), scaled(sign, n_0))


def squared_norm(
    n_0: Vector, n_1: Vector, n_2: Vector, nu: Any, *, middle: int = -2, power: int = 2
) -> Any:
    """First line for <N_12, N_12>; middle: coefficient of nu; power: exponent of nu before it."""
    s = added(n_1, n_2)
    return nu**power * dot(s, s) + middle * nu * dot(s, n_0) + dot(n_0, n_0)


def squared_norm_unit(
    n_0: Vector, n_1: Vector, n_2: Vector, nu: Any, *, middle: int = -2, constant: int = 1
) -> Any:
    """Second line for <N_12, N_12>, where N_0 is a unit vector."""
    s = added(n_1, n_2)
    return nu**2 * dot(s, s) + middle * nu * dot(s, n_0) + constant


def quadratic(n_0: Vector, n_1: Vector, n_2: Vector, nu: Any, *, middle: int = -2) -> Any:
    """Third line: nu (nu |N_1 + N_2|^2 - 2 <N_1 + N_2, N_0>), which vanishes."""
    s = added(n_1, n_2)
    return nu * (nu * dot(s, s) + middle * dot(s, n_0))


def root(n_0: Vector, n_1: Vector, n_2: Vector, *, factor: Any = 2) -> Any:
    """Root nu = 2 <N_1 + N_2, N_0> / <N_1 + N_2, N_1 + N_2>."""
    s = added(n_1, n_2)
    return factor * dot(s, n_0) / dot(s, s)


def householder(
    n_0: Vector, n_1: Vector, n_2: Vector, *, factor: Any = 1, identity: int = -1
) -> Vector:
    """Right side of (eq:householder); factor: of the matrix of rank one, identity: of I."""
    s = added(n_1, n_2)
    return added(scaled(factor * dot(s, n_0) / dot(s, s), s), scaled(identity, n_0))


def rhombus_sum(
    n_1: Vector, n_2: Vector, n_12: Vector, nu: Any, cosine: Any, *, twice: Any = 2
) -> Any:
    """First line of the proof of lem:Chebyshev: nu (<N_12, N_1 + N_2> - 2 cos delta)."""
    return nu * (dot(n_12, added(n_1, n_2)) - twice * cosine)


def rhombus_difference(n_1: Vector, n_2: Vector, other: Vector, nu: Any, *, sign: int = -1) -> Any:
    """Second line of that proof: nu <other, N_1 - N_2>, other being N_1 + N_2, then N_12."""
    return nu * dot(other, added(n_1, scaled(sign, n_2)))


def edge_length(sine: Any) -> Any:
    """Length of the edges of r after lem:Chebyshev: sin delta."""
    return sine
