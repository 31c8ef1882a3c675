"""Search for a complete surface of curvature K <= -1 among surfaces with a screw symmetry.

The metric ds^2 + U(s)^2 dt^2 of curvature -q(s), q >= 1 on panels, is that of a screw surface of
pitch c as long as U^2 (1 - U'^2) >= c^2 (Bour); c = 0 is a surface of revolution. Efimov's theorem
says that both ends of the meridian, s > 0 and s < 0, cannot be infinite. The search maximises the
shorter of the two, in units of arcsinh(1/U(0)), which U'' >= U and |U'| <= 1 make an upper bound.
"""

from collections.abc import Callable
from math import asinh, cosh, exp, log, sinh, sqrt
from typing import Any

import numpy as np

from checks.searches.maximise import from_the_faces

SOURCES = ("checks/searches/efimov.py", "checks/searches/maximise.py")
PANELS = 5
STEPS = 400
SMALLEST_RADIUS = 0.01


def reach(radius: float, slope: float, pitch: float, extra: np.ndarray) -> float:
    """Length of the immersed meridian s > 0 in units of its upper bound arcsinh(1/radius).

    extra: the values q - 1 >= 0 on panels of equal length up to the bound. U^2 (1 - U'^2) - c^2 is
    followed over STEPS exact steps up to the bound, and interpolated where it turns negative.
    """
    h = asinh(1 / radius) / STEPS
    u, v = radius, slope
    room = u * u * (1 - v * v) - pitch * pitch
    for node in range(2 * STEPS):
        k = sqrt(1 + float(extra[min(node * PANELS // STEPS, PANELS - 1)]))
        c, s = cosh(k * h), sinh(k * h)
        u, v = u * c + v * s / k, u * k * s + v * c
        left = u * u * (1 - v * v) - pitch * pitch if u > 0 else -1.0
        if left < 0:
            return (node + room / (room - left)) / STEPS
        room = left
    return 2.0


def shorter_end(point: np.ndarray) -> float:
    """Shorter of the two ends in units of the bound; 0 where s = 0 is not immersed."""
    radius, slope, pitch = exp(float(point[0])), float(point[1]), float(point[2])
    if radius**2 * (1 - slope**2) <= pitch**2:
        return 0.0
    ahead, behind = point[3 : 3 + PANELS] ** 2, point[3 + PANELS :] ** 2
    return min(reach(radius, slope, pitch, ahead), reach(radius, -slope, pitch, behind))


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Largest shorter end found; margin is what it falls short of the bound, relative to it."""
    bounds = (
        (log(SMALLEST_RADIUS), log(2.0)),
        (-0.99, 0.99),
        (0.0, 1.0),
        *(((0.0, 3.0),) * (2 * PANELS)),
    )
    best = from_the_faces(
        shorter_end, bounds, seed=seed, population=60, generations=180, progress=progress
    )
    # The last step that ends inside: what is certainly reached, without interpolation.
    nodes = int(best.value * STEPS)
    return {
        "evaluations": best.evaluations,
        "margin": 1 - nodes / STEPS,
        "point": list(best.point),
        "nodes": nodes,
        "steps": STEPS,
    }
