"""Geodesic disk about the apex of an Amsler sector, in float64 (fig:cutsketch, def:amsler-sector).

The sector is laid out in the hyperboloid model of H^2: along the geodesic u-axis, then along a
v-line, whose tangent turns against the parallel field r_u at the rate phi_v. Along the line
v = z^2/(4 u), so that it turns by phi'(z) dz. scipy is imported when a function is called; errors
of some 1e-10.
"""

from math import acosh, cos, cosh, pi, sin, sinh, sqrt
from typing import Any

from theory.errors import DomainError

START = 1e-7
TOLERANCE = 1e-12


def distance(phi0: float, u: float, v: float) -> float:
    """Distance of the point (u, v) from the apex, for u, v >= 0 while phi < pi.

    >>> round(distance(1.0, 0.5, 0.0), 12)
    0.5
    """
    if u < 0 or v < 0:
        raise DomainError(f"u and v must not be negative, not {u}, {v}")
    if u == 0 or v == 0:
        return u + v
    point = _along(phi0, u, 2 * sqrt(u * v)).y[2:5, -1]
    return acosh(float(point[0]))


def rim(phi0: float, u: float, radius: float) -> float:
    """Coordinate v at which the v-line through (u, 0) leaves the disk, for 0 < u < R.

    Raises DomainError where phi reaches pi before.
    """
    if not 0 < u < radius:
        raise DomainError(f"u must lie in (0, {radius}), not {u}")

    def left(_z: float, state: Any) -> float:
        return float(state[2]) - cosh(radius)

    def singular(_z: float, state: Any) -> float:
        return float(state[0]) - pi

    left.terminal = singular.terminal = True  # type: ignore[attr-defined]
    run = _along(phi0, u, 2 * sqrt(2 * u * radius) + 2, events=[left, singular])
    if not len(run.t_events[0]):
        raise DomainError(f"the v-line at u = {u} does not leave the disk before phi = pi")
    return float(run.t_events[0][0]) ** 2 / (4 * u)


def _along(phi0: float, u: float, end: float, **options: Any) -> Any:
    """Angle, slope, point, tangent and normal along the v-line, by z from 0 to its end."""
    from scipy.integrate import solve_ivp

    def move(z: float, state: Any) -> list[float]:
        phi, rate = state[0], state[1]
        point, tangent, normal = state[2:5], state[5:8], state[8:11]
        speed = z / (2 * u)
        return [
            rate,
            sin(phi) - rate / z,
            *(speed * tangent),
            *(speed * point + rate * normal),
            *(-rate * tangent),
        ]

    forward, side = (sinh(u), cosh(u), 0.0), (0.0, 0.0, 1.0)
    tangent = [cos(phi0) * f + sin(phi0) * s for f, s in zip(forward, side, strict=True)]
    normal = [-sin(phi0) * f + cos(phi0) * s for f, s in zip(forward, side, strict=True)]
    start = [phi0, sin(phi0) * START / 2, cosh(u), sinh(u), 0.0, *tangent, *normal]
    return solve_ivp(
        move, (START, end), start, method="DOP853", rtol=TOLERANCE, atol=TOLERANCE, **options
    )
