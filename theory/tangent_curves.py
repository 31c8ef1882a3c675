"""Curves through a point, tangent to a common plane there, and the saddles that can hold them.

To second order a curve of curvature k whose osculating plane makes the angle psi with the common
plane rises above it as k sin(psi) t^2/2. Its torsion does not enter. A surface of curvature -1
that consists of C^2 sectors bounded by asymptotic curves through the point has over each sector of
angle a a height sin(b) sin(a - b)/sin(a) t^2 in the direction b, at most tan(a/2)/2 t^2.
"""

from collections.abc import Sequence
from typing import Any

import sympy as sp


def rise(curvature: Any, tilt: Any) -> Any:
    """Return the normal curvature k sin psi that a curve prescribes to the surface."""
    return curvature * sp.sin(tilt)


def largest_height(angle: Any) -> Any:
    """Largest height over t^2 in a sector of this angle: that on its bisector."""
    return sp.sin(angle / 2) ** 2 / sp.sin(angle)


def least_angle(normal_curvature: Any) -> Any:
    """Least angle of a sector that holds a curve of this normal curvature: 2 atan |k|."""
    return 2 * sp.atan(sp.Abs(normal_curvature))


def total_angle_needed(normal_curvatures: Sequence[Any]) -> Any:
    """Sum of the least angles of the sectors of curves that lie in different sectors."""
    return sum((least_angle(k) for k in normal_curvatures), sp.Integer(0))
