r"""Dini's surfaces: pseudospherical, with a screw symmetry, and embedded on one side of their edge.

The point (a sin v cos u, a sin v sin u, a (cos v + log tan(v/2)) + b u), a = tanh w and b = sech w,
w > 0, with x = tan(v/2) in (0, 1) for v. With sin v = sinh s/sinh w the metric is that of the strip
0 < s < w of H^2 between a geodesic and an equidistant line, s being the distance to the geodesic.
"""

from typing import Any

import sympy as sp

from theory.vectors import Vector

U = sp.Symbol("u", real=True)
X = sp.Symbol("x", positive=True)
WIDTH = sp.Symbol("w", positive=True)


def radius_and_pitch(width: Any) -> tuple[Any, Any]:
    """Radius a of the edge and pitch b, the height gained per radian; a^2 + b^2 = 1."""
    return sp.tanh(width), sp.sech(width)


def _sine_and_cosine() -> tuple[Any, Any]:
    return 2 * X / (1 + X**2), (1 - X**2) / (1 + X**2)


def distance_to_axis(radius: Any) -> Any:
    """Distance a sin v of the point from the axis."""
    return radius * _sine_and_cosine()[0]


def point(radius: Any, pitch: Any) -> Vector:
    """Point of the surface at (U, X)."""
    rho = distance_to_axis(radius)
    height = radius * (_sine_and_cosine()[1] + sp.log(X)) + pitch * U
    return (rho * sp.cos(U), rho * sp.sin(U), height)


def sinh_distance(width: Any) -> Any:
    """Hyperbolic sine of the distance s to the geodesic, which the end x = 0 approaches."""
    return sp.sinh(width) * _sine_and_cosine()[0]


def squared_distance_rate(width: Any) -> Any:
    """Square of ds/dx."""
    sinh = sinh_distance(width)
    return sp.diff(sinh, X) ** 2 / (1 + sinh**2)
