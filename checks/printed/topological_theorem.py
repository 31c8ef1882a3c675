"""The lemma on the normal near a point and the theorem on branch points, as printed."""

from typing import Any

import sympy as sp


def radius_bound(k_max: Any, *, numerator: Any = 1, divisor: int = 6) -> Any:
    """Radius eta(k_max) = pi/(6 k_max) of the proof of (lem:maximal), used by (thm:branched)."""
    return numerator * sp.pi / (divisor * k_max)


def common_radius(first: Any, second: Any) -> Any:
    """Bound min(eta, delta) of epsilon in the proof of (thm:branched)."""
    return sp.Min(first, second)


def sector_radius(radii: list[Any], *, rule: str = "min") -> Any:
    """Radius delta of all sectors at p from those of each, in the proof of (lem:injective)."""
    return sp.Min(*radii) if rule == "min" else sp.Max(*radii)


def sectors(order: int, *, offset: int = 0) -> int:
    """Number of the radii delta_0, ..., delta_{2m-1} in the proof of (lem:injective)."""
    return 2 * order + offset


def limit_order(*, order: int = 2) -> int:
    """Order of saddleness of the limit at every point, theorem (thm:branched)."""
    return order
