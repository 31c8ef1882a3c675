"""Winding number of a closed polygon about the origin of the plane, in exact arithmetic."""

from collections.abc import Sequence
from typing import Any

Points = Sequence[tuple[Any, Any]]


def cross(one: tuple[Any, Any], other: tuple[Any, Any]) -> Any:
    """Signed area of the parallelogram of two vectors."""
    return one[0] * other[1] - one[1] * other[0]


def winding(points: Points) -> int:
    """Times that the closed polygon goes round the origin, counted by its crossings of a ray.

    points: of integers or fractions, joined by segments. Raises ValueError for a segment through
    the origin.
    """
    total = 0
    for one, other in zip(points, [*points[1:], points[0]], strict=True):
        turn = cross(one, other)
        if turn == 0 and one[0] * other[0] + one[1] * other[1] <= 0:
            raise ValueError(f"the segment from {one} to {other} meets the origin")
        total += one[1] < 0 <= other[1] and turn > 0
        total -= other[1] < 0 <= one[1] and turn < 0
    return total
