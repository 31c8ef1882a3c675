"""Search for the least k_max at which (lem:maximal) fails, in the limit of small size.

Among translation nets with two points of one normal, on a disk B_3 with 0 < phi < pi where both
points lie in B_2 (item 1), or one is the centre and the other one lies in B_2 (item 2), the search
maximises the least of phi and pi - phi on B_2; k_max is its half's cotangent.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from checks.searches.maximise import Objective, from_the_faces
from checks.searches.translation_nets import (
    bounds,
    folded_corner,
    free_radius,
    inscribed,
    least_angle,
    split,
)

SOURCES = (
    "checks/searches/maximise.py",
    "checks/searches/normal_map.py",
    "checks/searches/translation_nets.py",
)
SIDES = 3
INNER = 2 / 3
LARGEST_OFFSET = 4.0
STARTS = tuple((*folded_corner(k), y) for k in (8.0, 12.0, 16.0, 20.0, 24.0) for y in (0.05, 0.3))


def angle_left(pull: float) -> Objective:
    """Least angle on B_2 of the net at a point; negative where the hypotheses are not met.

    pull: 0 for two points anywhere, 1 for the centre and another point.
    """

    def objective(point: np.ndarray) -> float:
        a, la, b, lb = split(point, SIDES)
        angles, met, radius, _, both = inscribed(a, la, b, lb, 0j, float(np.sinh(point[-1])), pull)
        if not both:
            return -20.0
        whole = free_radius(angles, met, 0.0)
        if radius > INNER * whole:
            return 5 * (INNER - radius / whole)
        return float(least_angle(angles, met, INNER * whole))

    return objective


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Largest angles found for items 1 and 2; margin is the smaller one, positive if both fail."""
    found = {}
    for name, pull in (("one-to-one", 0.0), ("collar", 1.0)):
        found[name] = from_the_faces(
            angle_left(pull),
            (*bounds(SIDES), (-LARGEST_OFFSET, LARGEST_OFFSET)),
            seed=seed,
            known=STARTS,
            population=60,
            generations=600,
            polish=8000,
            progress=progress,
        )
    return {
        "evaluations": sum(best.evaluations for best in found.values()),
        "margin": min(best.value for best in found.values()),
        "points": {name: list(best.point) for name, best in found.items()},
        "angles": {name: best.value for name, best in found.items()},
    }
