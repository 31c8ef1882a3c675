"""Geodesic rays of an Amsler sector in float64, by the Runge-Kutta method of order four."""

from collections.abc import Callable
from math import sin, sqrt

from theory.painleve_float import angle, slope

State = tuple[float, float, float]


def rim_point(corner: float, part: float, distance: float, *, steps: int) -> tuple[float, float]:
    """(u, v) at this distance from the apex on the ray at the angle part * corner to the u-edge.

    corner in (0, pi) radians, part in (0, 1); the angle phi must stay below pi on the way.
    """
    state, h = (0.0, 0.0, part * corner), distance / steps

    def rates(at: State) -> State:
        u, v, a = at
        z = 2 * sqrt(u * v)
        phi = angle(corner, z) if z else corner
        # F'(z)/z tends to sin(corner)/2 at the apex.
        twist = 2 * slope(corner, z) / z if z else sin(corner)
        along_u = sin(phi - a) / sin(phi)
        return along_u, sin(a) / sin(phi), twist * v * along_u

    for _ in range(steps):
        state = _step(rates, state, h)
    return state[0], state[1]


def _step(rates: Callable[[State], State], at: State, h: float) -> State:
    k1 = rates(at)
    k2 = rates(_moved(at, k1, h / 2))
    k3 = rates(_moved(at, k2, h / 2))
    k4 = rates(_moved(at, k3, h))
    mean = [(a + 2 * b + 2 * c + d) / 6 for a, b, c, d in zip(k1, k2, k3, k4, strict=True)]
    return _moved(at, (mean[0], mean[1], mean[2]), h)


def _moved(at: State, rate: State, h: float) -> State:
    return at[0] + h * rate[0], at[1] + h * rate[1], at[2] + h * rate[2]
