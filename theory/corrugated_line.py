"""Isometric C^1 curve in the plane near a shortened line: Nash and Kuiper for m = 1, n = 2.

The line is s -> (ratio s, 0). The curve is a chain of circular arcs of one radius whose tangent
turns from the angle 0 to b, back to -b and to 0 again; each quarter has the length b radius, and
ratio = sin(b)/b makes curve and line advance alike.
"""

from typing import Any

import sympy as sp

Point = tuple[Any, Any]


def ratio(amplitude: Any) -> Any:
    """Length of the line per length of the curve, below 1."""
    return sp.sin(amplitude) / amplitude


def line(s: Any, amplitude: Any) -> Point:
    """Point of the shortened line at the parameter s."""
    return (ratio(amplitude) * s, sp.Integer(0))


def first_quarter(s: Any, radius: Any) -> Point:
    """Point of the curve at arc length s, up to s = amplitude radius."""
    return (radius * sp.sin(s / radius), radius * (1 - sp.cos(s / radius)))


def second_quarter(s: Any, radius: Any, amplitude: Any) -> Point:
    """Point of the curve at arc length s from amplitude radius to twice that."""
    angle = 2 * amplitude - s / radius
    return (
        radius * (2 * sp.sin(amplitude) - sp.sin(angle)),
        radius * (1 + sp.cos(angle) - 2 * sp.cos(amplitude)),
    )


def distance_bound(radius: Any, amplitude: Any) -> Any:
    """Upper bound of the distance of curve and line at equal parameters.

    Along the line they differ by at most radius (b - sin b), as sin x <= x; across it the height
    is greatest after two quarters.
    """
    return radius * (amplitude - sp.sin(amplitude) + 2 * (1 - sp.cos(amplitude)))
