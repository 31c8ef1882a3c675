"""Runs of the greedy algorithm (alg:greedy-cuts) over radii, steps, initial sectors and cutoffs.

No search: nothing is maximised. A run is reduced to what section 5 speaks of: numbers of branch
points and sectors, generations, extreme angles, energies, and the sectors of smallest angle.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import numpy as np

from discrete.exact_angle import ExactAngle
from discrete.greedy import grown
from discrete.greedy_parameters import GreedyParameters
from discrete.greedy_tree import GreedyTree

SOURCES = (
    "checks/searches/greedy_runs.py",
    "discrete/clipped_quads.py",
    "discrete/exact_angle.py",
    "discrete/greedy.py",
    "discrete/greedy_parameters.py",
    "discrete/greedy_tree.py",
    "discrete/plain_functions.py",
    "discrete/sector_cut.py",
    "discrete/sector_cutter.py",
    "discrete/sector_sides.py",
    "discrete/sector_sweep.py",
    "discrete/sl2_frames.py",
)

#: Initial sectors, and cutoff in half turns: the three of (fig:frontier) and one for m = 6.
SETS = (("4", "3/4"), ("8", "4/5"), ("12", "4/5"), ("12", "1/2"))

#: Edge lengths, and the largest radius for each.
STEPS = (("1/25", 13), ("1/50", 12), ("1/100", 11), ("1/200", 10))

#: Largest radius for the cutoff pi/2, which makes many more cuts.
RIGHT_ANGLE = 10

#: Paths of smallest angle that are kept.
KEPT = 12

MAX_CUTS = 4 * 10**6


def run_parameters(radius: str, step: str, sectors: str, cutoff: str) -> GreedyParameters:
    """Parameters of a run from texts, the cutoff in half turns."""
    return GreedyParameters(
        radius=Fraction(radius),
        step=Fraction(step),
        sectors=int(sectors),
        cutoff=ExactAngle(half_turns=Fraction(cutoff)),
    )


def summary(tree: GreedyTree) -> dict[str, Any]:
    """What is kept of a run; least: cuts of the first initial sector with the smallest angles."""
    sectors = tree.sectors
    cut = np.flatnonzero(sectors["cut"])
    first = cut[np.argsort(sectors["cut_angle"][cut], kind="stable")[:KEPT]]
    depth = np.bincount(sectors["generation"][cut] + 1, weights=sectors["copies"][cut], minlength=1)
    return {
        "branch_points": tree.branch_point_count,
        "sectors": tree.sector_count,
        "generations": tree.generations,
        "by_generation": [int(number) for number in depth],
        "min_angle": tree.min_angle,
        "max_angle": tree.max_angle,
        "willmore": tree.willmore,
        "area": tree.area,
        "unresolved": tree.unresolved_cuts,
        "terminated": tree.terminated,
        "least": [tree.paths[k] for k in first],
    }


def plan() -> Iterator[tuple[str, str, str, str]]:
    """Radius, step, sectors and cutoff of each run."""
    for sectors, cutoff in SETS:
        for step, largest in STEPS:
            most = min(largest, RIGHT_ANGLE) if cutoff == "1/2" else largest
            for half in range(2, 2 * most + 1):
                yield str(Fraction(half, 2)), step, sectors, cutoff


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """All runs of the plan; margin is the least share of the area covered; seed is not used."""
    del seed
    runs = []
    margin = 1.0
    for radius, step, sectors, cutoff in plan():
        given = run_parameters(radius, step, sectors, cutoff)
        tree = grown(given, max_cuts=MAX_CUTS)
        margin = min(margin, tree.area / given.area)
        named = {"radius": radius, "step": step, "initial": sectors, "cutoff": cutoff}
        runs.append({**named, **summary(tree)})
        progress(f"{sectors} {cutoff} {step} R = {radius}: {tree.branch_point_count}")
    return {"evaluations": len(runs), "margin": margin, "runs": runs}
