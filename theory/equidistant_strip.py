"""Strip about a geodesic of H^2 in Fermi coordinates, on -x0^2 + x1^2 + x2^2 = -1, x0 > 0.

(s, tau): signed distance from the geodesic x2 = 0, and arc length along it. The metric is
ds^2 + cosh^2(s) d tau^2, that of the universal cover of a bobbin with tau = theta / kappa.
"""

from typing import Any

import sympy as sp

from theory.vectors import Vector, added, scaled


def minkowski(a: Vector, b: Vector) -> Any:
    """Minkowski product of signature -++."""
    return -a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def point(s: Any, tau: Any) -> Vector:
    """Point at distance s from the geodesic, above its point tau."""
    return (sp.cosh(s) * sp.cosh(tau), sp.cosh(s) * sp.sinh(tau), sp.sinh(s))


def coordinates(x: Vector) -> Vector:
    """Fermi coordinates of a point as (sinh s, tanh tau, 0): the inverse of `point`."""
    return (x[2], x[1] / x[0], sp.Integer(0))


def direction(s: Any, tau: Any, angle: Any) -> Vector:
    """Tangent vector of length 1 at the point (s, tau) at this angle from the meridian."""
    across = (sp.sinh(s) * sp.cosh(tau), sp.sinh(s) * sp.sinh(tau), sp.cosh(s))
    along = (sp.sinh(tau), sp.cosh(tau), sp.Integer(0))
    return added(scaled(sp.cos(angle), across), scaled(sp.sin(angle), along))


def geodesic(s: Any, tau: Any, angle: Any, distance: Any) -> Vector:
    """Point at this distance from (s, tau) in the direction of this angle."""
    return added(
        scaled(sp.cosh(distance), point(s, tau)),
        scaled(sp.sinh(distance), direction(s, tau, angle)),
    )
