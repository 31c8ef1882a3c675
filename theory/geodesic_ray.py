"""Geodesic ray from a point of the disk of radius R to its rim (eq:hyp_radius).

The ray leaves a point at distance d < R of the centre at the angle alpha to the direction away from
the centre. With X0 = cosh of the distance from the centre, X0'' = X0 along the ray.
"""

from typing import Any

import sympy as sp

D, R, L = sp.symbols("d R l", positive=True)
ALPHA = sp.Symbol("alpha", real=True)


def cosh_distance(length: Any, distance: Any, alpha: Any) -> Any:
    """Hyperbolic cosine of the distance from the centre after this length along the ray."""
    point, tangent = _start(distance, alpha)
    moved = point * sp.cosh(length) + tangent * sp.sinh(length)
    return sp.expand(moved[0])


def _start(distance: Any, alpha: Any) -> tuple[sp.Matrix, sp.Matrix]:
    """Point of the hyperboloid on the first axis, and the unit tangent at alpha to the axis."""
    point = sp.Matrix([sp.cosh(distance), sp.sinh(distance), 0])
    outward = sp.Matrix([sp.sinh(distance), sp.cosh(distance), 0])
    return point, outward * sp.cos(alpha) + sp.Matrix([0, 0, 1]) * sp.sin(alpha)


def least_cosine() -> Any:
    """Least cos(alpha) for which the ray is at most R long: -tanh(d/2)/tanh R."""
    c = sp.Symbol("c", real=True)
    reached = cosh_distance(R, D, ALPHA).subs(sp.cos(ALPHA), c) - sp.cosh(R)
    return sp.solve(reached, c)[0]
