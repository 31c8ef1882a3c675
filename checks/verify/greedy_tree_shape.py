"""Shape of the tree of branch points: runs to the end, generations, parents, leaves (section 5.1).

Two routes: nets of four edge lengths, and the stored trees of the limit of edge length 0.
"""

from collections import Counter
from fractions import Fraction
from typing import Any

import numpy as np

from checks.evidence import Evidence, Setting
from checks.stored import load
from checks.verify.findings import findings as found
from checks.verify.greedy_samples import TREE, distances, positions, tree_of
from discrete.greedy_tree import GreedyTree
from discrete.greedy_walk import walked

STEPS = ("1/25", "1/50", "1/100", "1/200")
LARGEST = 10

#: Largest turn in radians that is rounding.
STRAIGHT = 1e-11


def stale(*names: str) -> list[str]:
    """Complaints about stored runs that are older than their sources."""
    return [
        f"the stored run {name} is older than its sources" for name in names if load(name).stale
    ]


def limit_cuts(radius: str, sectors: str, cutoff: str) -> list[tuple[str, float, float, float]]:
    """Path, rho, theta, angle at each cut of a stored tree of the limit."""
    wanted = {"radius": radius, "initial": sectors, "cutoff": cutoff}
    for tree in load("greedy_limits").result["trees"]:
        if wanted.items() <= tree.items():
            return [(cut[0], cut[1], cut[2], cut[3]) for cut in tree["cuts"]]
    raise LookupError(f"no stored tree of the limit for {wanted}")


def copies(path: str, sectors: str) -> int:
    """Images of a cut in the whole disk: half of them on the diagonals."""
    return int(sectors) * (1 if set(path) <= {"A"} else 2)


def runs_to_ten(
    setting: Setting,
    *,
    covered: str = "1",
    level: str = "1",
    cuts: int = 10**6,
    beyond: str = "0",
) -> Evidence:
    """Whether the stored runs with R <= 10 end, cover the disk and stay below the cutoff.

    covered: share of the area of the disk; level: in units of phi*; cuts: most cuts of the runs
    that are made again, of radius 6; beyond: only runs of a cutoff beyond so many half turns.
    """
    del setting
    failures, tried, again = stale("greedy_runs"), 0, 0
    for run in load("greedy_runs").result["runs"]:
        radius = Fraction(run["radius"])
        if radius > LARGEST or Fraction(run["cutoff"]) <= Fraction(beyond):
            continue
        tried += 1
        key = (run["radius"], run["step"], run["initial"], run["cutoff"])
        area = 4 * np.pi * np.sinh(float(radius) / 2) ** 2 * float(Fraction(covered))
        most = float(Fraction(run["cutoff"]) * Fraction(level)) * np.pi
        good = run["terminated"] and abs(run["area"] / area - 1) < 1e-9
        if radius == 6 and run["step"] == "1/50":
            again += 1
            tree = tree_of(*key, most=cuts)
            good = good and tree.terminated and tree.branch_point_count == run["branch_points"]
        if not good or run["max_angle"] > most:
            failures.append(f"R = {key[0]}, step {key[1]}, 2 m = {key[2]}, phi* = {key[3]} pi")
    return found(
        failures,
        shown=f"all {tried} runs with R <= 10 end with the area of the disk and no angle above "
        f"phi*; {again} of them made again",
        tried=tried,
    )


def runs_beyond_right_angle(setting: Setting, *, covered: str = "1", cuts: int = 10**6) -> Evidence:
    """Whether those of a cutoff above pi/2 end and cover the disk."""
    return runs_to_ten(setting, covered=covered, cuts=cuts, beyond="1/2")


def _levels(radius: str) -> dict[str, Counter[int]]:
    """Number of branch points by generation, for every edge length and for the limit."""
    levels = {}
    for step in STEPS:
        levels[f"step {step}"] = Counter(
            point.generation for point in tree_of(radius, step, *TREE).branch_points()
        )
    levels["limit"] = Counter()
    for path, *_ in limit_cuts(radius, *TREE):
        levels["limit"][len(path) + 1] += copies(path, TREE[0])
    return levels


def generations(
    setting: Setting, *, number: int = 4, origin: bool = False, radius: str = "4"
) -> Evidence:
    """Number of generations of branch points; origin: whether the centre counts as one."""
    del setting
    failures = stale("greedy_limits")
    levels = _levels(radius)
    for name, level in levels.items():
        if len(level) + origin != number:
            parts = " + ".join(str(level[k]) for k in sorted(level))
            failures.append(
                f"R = {radius}, {name}: {parts} branch points, {len(level)} generations"
            )
    counts = sorted({sum(level.values()) for level in levels.values()})
    return found(
        failures,
        shown=f"{number} generations for every edge length and in the limit, the centre "
        f"{'counted' if origin else 'not counted'}; {counts} branch points",
        tried=len(levels),
    )


def leaves(setting: Setting, *, radius: str = "4") -> Evidence:
    """Whether the leaves of the tree are in more than one generation."""
    del setting
    failures, seen = stale("greedy_limits"), []
    trees: dict[str, list[tuple[str, int]]] = {
        f"step {step}": [
            (p.path, p.generation) for p in tree_of(radius, step, *TREE).branch_points()
        ]
        for step in STEPS
    }
    # One half of an initial sector stands for all in the limit.
    trees["limit"] = [(path, len(path) + 1) for path, *_ in limit_cuts(radius, *TREE)]
    for name, points in trees.items():
        parents = {path[:-1] for path, generation in points if generation > 1}
        depths = Counter(generation for path, generation in points if path not in parents)
        seen.append(sorted(depths))
        if len(depths) < 2:
            failures.append(f"R = {radius}, {name}: all leaves are in generation {seen[-1]}")
    return found(
        failures,
        shown=f"generations of the leaves, by edge length and in the limit: {seen}",
        tried=len(trees),
    )


def one_parent(setting: Setting, *, step: str = "1/100", dropped: int = 1) -> Evidence:
    """Whether every branch point lies within one sector, at whose corner its only parent is.

    dropped: letters taken off the path to find the parent.
    """
    del setting
    failures: list[str] = []
    tried = 0
    for radius, sectors, cutoff in (
        ("4", *TREE),
        ("6", *TREE),
        ("5", "8", "4/5"),
        ("4", "12", "1/2"),
    ):
        tree = tree_of(radius, step, sectors, cutoff)
        if tree.unresolved_cuts:
            failures.append(f"R = {radius}: {tree.unresolved_cuts} cuts on a side of two sectors")
        points, places = positions(tree)
        tried += len(points)
        by_path = {point.path: k for k, point in enumerate(points)}
        for k, point in enumerate(points):
            gap = distances(places[k], np.delete(places, k, axis=0)).min()
            if gap < 2 * float(Fraction(step)):
                failures.append(f"two branch points {gap:.3g} apart")
            if point.generation == 1:
                continue
            parent = by_path.get(point.path[:-dropped])
            if parent is None or points[parent].generation != point.generation - 1:
                failures.append(f"{point.path} has no parent in the generation before")
    return found(
        failures,
        shown=f"{tried} branch points, no two at one place, each inside one sector",
        tried=tried,
    )


def daughters(setting: Setting, *, most: int = 3, origin: bool = False) -> Evidence:
    """Largest number of daughters of a branch point; origin: whether the centre is one."""
    del setting
    failures: list[str] = []
    tried = 0
    for radius, sectors, cutoff in (
        ("4", *TREE),
        ("7", *TREE),
        ("6", "8", "4/5"),
        ("6", "12", "1/2"),
    ):
        number = Counter(
            point.parent if point.generation > 1 else "the centre"
            for point in tree_of(radius, "1/50", sectors, cutoff).branch_points()
        )
        if not origin:
            del number["the centre"]
        tried += len(number)
        failures += [f"{path} has {n}" for path, n in number.items() if n > most]
    return found(failures, shown=f"at most {most} daughters at {tried} parents", tried=tried)


def amsler_nodes(setting: Setting, *, share: str = "1", origin: bool = True) -> Evidence:
    """Mean distance of successive Amsler nodes on a diagonal against that of the other pairs.

    share: of the mean for Amsler nodes; origin: whether the way from the centre counts.
    """
    del setting
    failures, told = [], []
    for step in STEPS:
        points, places = positions(tree_of("4", step, *TREE))
        by_path = {point.path: k for k, point in enumerate(points)}
        lengths: dict[bool, list[float]] = {True: [], False: []}
        for k, point in enumerate(points):
            diagonal = set(point.path[1:]) <= {"A"}
            if point.generation > 1:
                gap: Any = distances(places[k], places[by_path[point.parent]])
                lengths[diagonal].append(float(gap))
            elif origin:
                lengths[True].append(point.rho)
        amsler, other = (float(np.mean(lengths[key])) for key in (True, False))
        told.append(f"{amsler:.3f} and {other:.3f}")
        if not amsler * float(Fraction(share)) > other:
            failures.append(f"step {step}: means {amsler:.4f} and {other:.4f}")
    return found(
        failures,
        shown=f"means for Amsler and other pairs at four edge lengths: {', '.join(told)}",
        tried=len(STEPS),
    )


def geodesic_sides(tree: GreedyTree) -> Counter[int]:
    """Attached sectors of the whole disk by the number of their sides that are geodesics.

    The turns of the sides are looked at, not how the sectors came about; a line of nonzero geodesic
    curvature turns by that times the edge length.
    """
    number: Counter[int] = Counter()
    for path, sector, _ in walked(tree):
        if path:
            sides = (sector.first_turns[1:], sector.second_turns[1:])
            straight = sum(bool(np.abs(turns).max(initial=0) < STRAIGHT) for turns in sides)
            number[straight] += sector.copies
    return number


RUNS = (("4", *TREE), ("8", *TREE), ("8", "12", "4/5"))


def amsler_share(setting: Setting, *, share: str = "1/3", most: str = "1/2") -> Evidence:
    """Share, below `most`, of the sectors between two geodesics among those attached at a cut."""
    del setting
    failures: list[str] = []
    tried = 0
    for radius, sectors, cutoff in RUNS:
        number = geodesic_sides(tree_of(radius, "1/50", sectors, cutoff))
        whole = number.total()
        tried += whole
        found_share = Fraction(number[2], whole)
        if found_share != Fraction(share) or not found_share < Fraction(most):
            failures.append(f"R = {radius}: {number[2]} of {whole} lie between two geodesics")
    return found(failures, shown=f"a third of {tried} attached sectors", tried=tried)


def one_geodesic(setting: Setting, *, sides: int = 1) -> Evidence:
    """Whether every attached sector not between two geodesics has this many geodesic sides."""
    del setting
    failures: list[str] = []
    tried = 0
    for radius, sectors, cutoff in RUNS:
        number = geodesic_sides(tree_of(radius, "1/50", sectors, cutoff))
        del number[2]
        tried += number.total()
        if set(number) != {sides}:
            failures.append(
                f"R = {radius}: sectors by geodesic sides {dict(sorted(number.items()))}"
            )
    return found(failures, shown=f"one geodesic side at each of {tried} sectors", tried=tried)
