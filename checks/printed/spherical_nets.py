"""Section 4, spherical nets as printed: (eq:unramified), discrete assembly, discrete surgery.

Angles are in units of pi, so that whole multiples are integers. Vectors are triples of scalars.
"""

from typing import Any

from theory.vectors import Vector, added, scaled

Node = tuple[int, int]


def interior_sum(m: Any, *, factor: Any = 2, first: Any = 1) -> Any:
    """First line of (eq:unramified): 2 (1 - m) at an interior vertex of degree 2m."""
    return factor * (first - m)


def boundary_range(d: Any, *, low: Any = 1, high: Any = 3) -> tuple[Any, Any]:
    """Second line of (eq:unramified): ((1 - d), (3 - d)), before the minimum with 0 is taken."""
    return low - d, high - d


def in_boundary_range(total: Any, d: int, *, low: int = 1, high: int = 3, cap: int = 0) -> bool:
    """Whether a sum of angles is certainly in ((1 - d), min(3 - d, 0)) at a vertex of degree d."""
    lower, upper = boundary_range(d, low=low, high=high)
    return bool(total > lower) and bool(total < upper) and bool(total < cap)


def attaching_map(k: int, previous: int, *, onto: str = "previous") -> Node:
    """chi_i : (k, 0) in J_i to (l_(i-1), k) in J_(i-1); previous: l_(i-1).

    onto: "previous" for that first entry, "0" for 0.
    """
    return (previous, k) if onto == "previous" else (int(onto), k)


def domain(i: int, lengths: tuple[int, ...], *, back: int = 1) -> tuple[int, int]:
    """Largest entries of J_i = {0, ..., l_(i-1)} x {0, ..., l_i}, i = 1, ..., 2m, l_0 = l_2m."""
    return lengths[(i - back) % len(lengths)], lengths[i % len(lengths)]


def deficit(total: Any, d: Any, *, high: Any = 3) -> Any:
    """Angle missing at a corner of degree d, from 3 alpha + total = -d and the next line."""
    return high - d - total


def surgery_angle(missing: Any, *, parts: Any = 3, shift: Any = -1) -> Any:
    """Alpha = -pi + delta/3 in units of pi, delta the missing angle."""
    return shift + missing / parts


def geodesic_point(
    start: Vector, first: Vector, k: int, angles: Any, *, subtracted: int = 1
) -> Vector:
    """Point gamma_i(k) = N(q) cos(k delta) + (gamma_i(1) - cos delta N(q))/sin delta sin(k delta).

    angles: the pair of functions n to cos(n delta) and n to sin(n delta); subtracted: the factor of
    cos delta N(q).
    """
    cosine, sine = angles
    part = added(first, scaled(-subtracted * cosine(1), start))
    return added(scaled(cosine(k), start), scaled(sine(k) / sine(1), part))
