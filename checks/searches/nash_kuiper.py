"""Search for a short map whose corrugation does not bring the metric nearer.

Over linear maps of the plane into R^3 and the metric each is to reach, the search maximises the
ratio of the two frequencies that halves the metric defect. A short map for which no ratio did so
would contradict the step on which the theorem of Nash and Kuiper rests.
"""

from collections.abc import Callable
from math import log, log2
from typing import Any

import numpy as np

from checks.searches.maximise import from_the_faces
from theory.corrugation import ShortMap, defect

SOURCES = (
    "checks/searches/maximise.py",
    "checks/searches/nash_kuiper.py",
    "theory/corrugation.py",
)
LARGEST_LOG_RATIO = 20
NODES = 16
BOUNDS = (
    (log(0.05), log(2.0)),
    (log(0.05), log(2.0)),
    (0.0, float(np.pi) / 2),
    (log(1e-3), log(4.0)),
    (log(1e-3), log(4.0)),
)


def short_map(point: np.ndarray) -> ShortMap:
    """Map of these singular values (logarithms) and angle, with this missing metric (logarithms).

    The angle is that between the directions of the singular values and of the missing metric.
    """
    first, second, missing_1, missing_2 = (float(np.exp(point[i])) for i in (0, 1, 3, 4))
    c, s = float(np.cos(point[2])), float(np.sin(point[2]))
    return ShortMap(
        p=np.array([first * c, -second * s, 0.0]),
        q=np.array([first * s, second * c, 0.0]),
        missing=(missing_1, missing_2),
    )


def log_ratio_needed(point: np.ndarray) -> float:
    """Binary logarithm of the frequency ratio at which half of the metric defect is left.

    Extrapolated from the largest ratio admitted, where the defect left is inverse to the ratio.
    """
    short = short_map(point)
    largest = 2.0**LARGEST_LOG_RATIO
    left = defect(short, largest, nodes=NODES) / float(np.linalg.norm(short.missing))
    return log2(2 * largest * left)


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Most stubborn short map found; margin is 1 - (log of its ratio) / (log of the largest)."""
    best = from_the_faces(
        log_ratio_needed,
        BOUNDS,
        seed=seed,
        population=50,
        generations=190,
        polish=1000,
        progress=progress,
    )
    return {
        "evaluations": best.evaluations,
        "margin": 1 - best.value / LARGEST_LOG_RATIO,
        "point": list(best.point),
        "log_ratio": best.value,
    }
