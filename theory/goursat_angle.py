"""Angle of a sector between two edges of constant geodesic curvature, in float64.

theta_uv = sin theta with theta = alpha + a u on v = 0 and alpha + b v on u = 0, by a scheme of
second order on a square grid; the curvatures are kappa^u = -sigma a, kappa^v = sigma b.
"""

from typing import Any

import numpy as np

from theory.errors import DomainError

SWEEPS = 4


def goursat_angle(alpha: float, a: float, b: float, length: float, *, steps: int) -> Any:
    """Angles on a grid of steps + 1 nodes in both directions, row by u, column by v.

    >>> float(goursat_angle(1.0, 0.5, 0.0, 1.0, steps=4)[2, 0])
    1.25

    Raises DomainError where the length or the steps are not positive.
    """
    if not length > 0 or steps < 1:
        raise DomainError(f"length and steps must be positive, not {length} and {steps}")
    t = np.linspace(0, length, steps + 1)
    theta = np.zeros((steps + 1, steps + 1))
    theta[:, 0], theta[0, :] = alpha + a * t, alpha + b * t
    area = (length / steps) ** 2
    for k in range(2, 2 * steps + 1):
        i = np.arange(max(1, k - steps), min(steps, k - 1) + 1)
        j = k - i
        corner, first, second = theta[i - 1, j - 1], theta[i, j - 1], theta[i - 1, j]
        value = first + second - corner
        for _ in range(SWEEPS):
            value = first + second - corner + area * np.sin((corner + first + second + value) / 4)
        theta[i, j] = value
    return theta
