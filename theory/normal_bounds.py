r"""How far the normal of a pseudospherical sector moves from its value at the apex p.

Asymptotic coordinates u, v >= 0 of unit speed from p, t = u + v, the angle phi between phi_0 and
pi - phi_0 on [0, u] x [0, v], where phi_0 = 2 arctan(1/k) for curvatures of at most k. Then:

1. Along the u-axis r_u and N_u turn in the tangent plane by the geodesic curvature, by theta(u),
   and the plane tilts by at most the arc length. So N - N(p) is the integral of unit vectors t_u at
   the angles theta + pi/2 up to u^2/2; along the v-axis, at psi - pi/2 up to v^2/2.
2. |N_uv| = |cos phi| <= 1, so N(u, v) - N(p) is the sum of both up to u v: in all up to t^2/2.
3. kappa^u = -phi_u and kappa^v = phi_v give psi - theta = phi - A, where A is the area of
   [0, u] x [0, v], at most t^2/4. So the angles of all t_u and t_v lie in an interval of length
   pi - phi_0 + A, and the sum of the integrals has at least the length
   t sin((phi_0 - A)/2) >= t sin(phi_0/2) - t^3/8.

Hence |N - N(p)| >= t s - t^2/2 - t^3/8 with s = sin(phi_0/2) = 1/sqrt(1 + k^2). Likewise, r_uv
being of length sin phi <= 1 and psi - theta <= pi - phi_0, |r - r(p)| >= t s - t^2/2. No derivative
of the curvature enters. On sectors that begin with a v-curve phi is the angle pi - phi of
(eq:def_phi), and theta and psi change places. The geodesic
distance d from p satisfies |r - r(p)| <= d <= t.
"""

from typing import Any

import sympy as sp


def cone_slope(k: Any) -> Any:
    """Return s = 1/sqrt(1 + k^2), the sine of half the least angle, for curvatures at most k."""
    return 1 / sp.sqrt(1 + sp.sympify(k) ** 2)


def least_angle(k: Any) -> Any:
    """Least angle 2 arctan(1/k) between asymptotic directions where both curvatures are <= k."""
    return 2 * sp.atan(1 / sp.sympify(k))


def floor(t: Any, slope: Any) -> Any:
    """Lower bound t s - t^2/2 - t^3/8 of |N - N(p)| at u + v = t."""
    return t * slope - t**2 / 2 - t**3 / 8


def distance_floor(t: Any, slope: Any) -> Any:
    """Lower bound t s - t^2/2 of |r - r(p)|, hence of the geodesic distance, at u + v = t."""
    return t * slope - t**2 / 2


def farthest(distance: Any, slope: Any) -> Any:
    """Upper bound 2 d/s of u + v at the distance d < s^2/2, the distance_floor of t = s.

    For distance_floor >= s t/2 up to t = s.
    """
    return 2 * distance / slope


def largest_radius(slope: Any) -> Any:
    """Radius s^2/8 of balls B_epsilon for which floor increases up to the distance 2 epsilon."""
    return slope**2 / 8


def cone_volume(height: Any, steepness: Any) -> Any:
    """Integral over the plane of max(height - steepness |x|, 0).

    A function f >= 0 of Lipschitz constant `steepness` with f(0) = height has at least this
    integral; in the hyperbolic plane, where circles are longer, a fortiori.
    """
    r = sp.Symbol("r", positive=True)
    return sp.integrate(2 * sp.pi * r * (height - steepness * r), (r, 0, height / steepness))
