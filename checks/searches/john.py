"""Search for a map of bounded length distortion that breaks John's inequality too near the centre.

The normal N = i (A - B) of a translation net with phi0 <= phi <= pi - phi0 is an L-BLD map of its
plane, after a reflection, with L = cot(phi0/2). On a disk B_r of such nets, two points w, z with
|w - z| > L |N(w) - N(z)| are sought as near to the centre as can be: John's theorem says that one
of them is at least r/L^2 away. The search minimises that distance times L^2/r.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from checks.searches.maximise import from_the_faces
from checks.searches.translation_nets import bounds, folded_corner, free_radius, inscribed, split

SOURCES = (
    "checks/searches/john.py",
    "checks/searches/maximise.py",
    "checks/searches/translation_nets.py",
)
SIDES = 3
LARGEST_OFFSET = 4.0
#: Natural logarithm of the largest L.
LARGEST_L = 4.0
#: Share of |w - z|/L that |N(w) - N(z)| may reach: below 1, so that the inequality is broken.
BROKEN = 0.95
STARTS = tuple(
    (*folded_corner(k), y, 0.0, 0.0, float(np.log(1.01 * k)))
    for k in (3.0, 6.0, 12.0, 20.0, 40.0)
    for y in (0.0, 0.3)
)


def relative_distance(point: np.ndarray) -> float:
    """Distance of the farther point times L^2/r; large where the net is void.

    The last coordinates: offset of the centre, size and argument of N(w) - N(z), log of L.
    """
    a, la, b, lb = split(point, SIDES)
    offset, size, argument, log = (float(x) for x in point[4 * SIDES :])
    distortion = float(np.exp(log))
    largest = 2 * BROKEN / (distortion + BROKEN)
    gap = size * largest * complex(np.cos(argument), np.sin(argument))
    angles, met, radius, _, both = inscribed(a, la, b, lb, gap, float(np.sinh(offset)), 0.0)
    if not both:
        return 1e3
    free = free_radius(angles, met, 2 * float(np.arctan(1 / distortion)))
    if free == 0.0:
        return 1e3
    if free < radius:
        return 500.0 * (2 - free / radius)
    return radius / free * distortion**2


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Nearest pair found; margin is its distance times L^2/r, minus 1."""
    last = ((-LARGEST_OFFSET, LARGEST_OFFSET), (0.0, 1.0), (-3.2, 3.2), (0.05, LARGEST_L))
    best = from_the_faces(
        lambda point: -float(np.log(relative_distance(point))),
        (*bounds(SIDES), *last),
        seed=seed,
        known=STARTS,
        population=80,
        generations=1200,
        polish=40000,
        progress=progress,
    )
    return {
        "evaluations": best.evaluations,
        "margin": relative_distance(np.array(best.point)) - 1,
        "point": list(best.point),
    }
