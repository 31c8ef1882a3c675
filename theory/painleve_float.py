"""The solution of phi'' + phi'/z = sin phi, phi(0) = phi0, phi'(0) = 0 (PIII) in float64, by scipy.

Third route beside the certified and the reference one: a Runge-Kutta method of order 8 that steps
in z from z = 10^-3, where three terms of the series are exact to rounding. Errors of some 1e-12
relative to the angle; scipy is imported when a function is called.
"""

from math import cos, isfinite, pi, sin, sqrt
from typing import Any

from theory.errors import DomainError, PastFirstMaximumError

START = 1e-3
FURTHEST = 200.0
RELATIVE = 1e-13


def angle(phi0: float, z: float) -> float:
    """Angle phi(z), for 0 < phi0 < pi and 0 <= z <= 200 (PIII). Raises DomainError.

    >>> round(angle(1.0, 1e-4) - 1, 12)
    2.104e-09
    """
    return _at(phi0, z)[0]


def slope(phi0: float, z: float) -> float:
    """Give phi'(z), for 0 < phi0 < pi and 0 <= z <= 200 (PIII). Raises DomainError.

    >>> round(slope(1.0, 1e-4), 12)
    4.2073549e-05
    """
    return _at(phi0, z)[1]


def diagonal(phi0: float, z: float) -> float:
    """Signed integral of cos(phi/2) from 0 to z. Raises DomainError.

    >>> round(diagonal(1.0, 1e-4), 12)
    8.7758256e-05
    """
    return _at(phi0, z)[2]


def crossing(phi0: float, level: float) -> float:
    """First z with phi(z) = level, for phi0 <= level up to the first maximum of phi.

    Raises DomainError for a level below phi0, PastFirstMaximumError for one above the maximum.

    >>> round(crossing(1.0, 1.0 + 2.104e-9), 6)
    0.0001
    """
    _require(phi0, 0.0)
    if not phi0 <= level < 2 * pi:
        raise DomainError(f"level must lie in [phi0, 2 pi), not {level}")
    if level <= _series(phi0, START)[0]:
        return 2 * sqrt((level - phi0) / sin(phi0))

    def risen(_z: float, state: Any) -> float:
        return float(state[0]) - level

    def turned(_z: float, state: Any) -> float:
        return float(state[1])

    risen.terminal = turned.terminal = True  # type: ignore[attr-defined]
    solution = _integrated(phi0, FURTHEST, events=[risen, turned])
    crossed, _ = solution.t_events
    if not len(crossed):
        raise PastFirstMaximumError(
            f"level {level} is above the first maximum of the angle, {solution.y[0, -1]}"
        )
    return float(crossed[0])


def _require(phi0: float, z: float) -> None:
    if not (isfinite(phi0) and 0 < phi0 < pi):
        raise DomainError(f"phi0 must lie in (0, pi), not {phi0}")
    if not 0 <= z <= FURTHEST:
        raise DomainError(f"z must lie in [0, {FURTHEST:g}], not {z}")


def _series(phi0: float, z: float) -> tuple[float, float, float]:
    """Angle, slope and diagonal for small z: (k + 1)^2 f_{k+1} = [x^k] sin F, x = z^2/4."""
    x, first = z * z / 4, sin(phi0)
    second = first * cos(phi0) / 4
    return (
        phi0 + x * (first + x * second),
        (first + 2 * x * second) * z / 2,
        z * (cos(phi0 / 2) - x / 3 * first / 2 * sin(phi0 / 2)),
    )


def _force(z: float, state: Any) -> tuple[float, float, float]:
    phi, rate, _ = state
    return rate, sin(phi) - rate / z, cos(phi / 2)


def _integrated(phi0: float, end: float, **options: Any) -> Any:
    from scipy.integrate import solve_ivp

    small = min(phi0, pi - phi0) * RELATIVE
    return solve_ivp(
        _force,
        (START, end),
        _series(phi0, START),
        method="DOP853",
        rtol=RELATIVE,
        atol=small,
        **options,
    )


def _at(phi0: float, z: float) -> tuple[float, float, float]:
    _require(phi0, z)
    if z <= START:
        return _series(phi0, z)
    phi, rate, path = _integrated(phi0, z).y[:, -1]
    return float(phi), float(rate), float(path)
