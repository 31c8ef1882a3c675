"""Distances between sister branch points, generation by generation: the scales of the pattern."""

from collections import defaultdict
from fractions import Fraction
from functools import cache
from itertools import pairwise

import numpy as np

from checks.evidence import Evidence, Setting
from checks.verify.findings import findings as found
from checks.verify.greedy_samples import distances, positions, tree_of
from discrete.greedy_tree import LETTERS

RUNS = (("8", "4", "3/4"), ("10", "8", "4/5"), ("10", "12", "4/5"), ("9", "12", "1/2"))

#: A generation with fewer parents of sisters does not count: few of its cuts are off the rim.
FEWEST = 20


@cache
def sister_distances(key: tuple[str, str, str], metric: str) -> dict[int, float]:
    """Median distance of neighbouring sisters by the generation of their parent.

    metric: `surface`, that of H^2, or `disk`, that of the plane in which the Poincare disk lies.
    """
    points, places = positions(tree_of(key[0], "1/50", *key[1:]))
    at = {point.path: k for k, point in enumerate(points)}
    in_disk = places[:, 1:] / (1 + places[:, :1])
    gaps: dict[int, list[float]] = defaultdict(list)
    for point in points:
        sisters = [at[p] for c in LETTERS[1:] if (p := point.path + c) in at]
        for a, b in pairwise(sisters):
            if metric == "disk":
                gaps[point.generation].append(float(np.linalg.norm(in_disk[a] - in_disk[b])))
            else:
                gaps[point.generation].append(float(distances(places[a], places[b])))
    return {g: float(np.median(gap)) for g, gap in sorted(gaps.items()) if len(gap) >= FEWEST}


def _ratios(key: tuple[str, str, str], metric: str, first: int) -> tuple[list[float], list[str]]:
    """Quotients of the medians of successive generations from this one on, and as texts."""
    medians = sister_distances(key, metric)
    chain = [value for generation, value in medians.items() if generation >= first]
    quotients = [b / a for a, b in pairwise(chain)]
    return quotients, [f"{q:.2f}" for q in quotients]


def smaller_scales(
    setting: Setting, *, metric: str = "surface", first: int = 2, most: str = "1"
) -> Evidence:
    """Whether the distance of sisters falls from each generation to the next, to a share of it.

    first: generation of the parents from which on it is to fall; most: the share.
    """
    del setting
    failures, told, tried = [], [], 0
    for key in RUNS:
        quotients, texts = _ratios(key, metric, first)
        tried += len(quotients)
        name = f"R = {key[0]}, 2 m = {key[1]}, phi* = {key[2]} pi"
        told.append(f"{name}: {', '.join(texts)}")
        if len(quotients) < 2 or max(quotients) >= float(Fraction(most)):
            failures.append(f"{name}: the distances of sisters change by {', '.join(texts)}")
    where = "on the surface" if metric == "surface" else "in the Poincare disk"
    return found(
        failures,
        shown=f"distances of sisters {where} from one generation to the next: {'; '.join(told)}",
        tried=tried,
    )


def recursion(setting: Setting, *, daughters: int = 3, until: int = 4) -> Evidence:
    """Whether each generation up to this one has so many times the branch points of the last."""
    del setting
    failures, told, tried = [], [], 0
    for key in RUNS:
        tree = tree_of(key[0], "1/50", *key[1:])
        number = np.bincount([point.generation for point in tree.branch_points()])[1 : until + 1]
        quotients = number[1:] / number[:-1]
        tried += len(quotients)
        told.append(", ".join(str(n) for n in number))
        if not (quotients == daughters).all():
            failures.append(f"R = {key[0]}, 2 m = {key[1]}, phi* = {key[2]} pi: {told[-1]}")
    return found(
        failures,
        shown=f"branch points of the first {until} generations: {'; '.join(told)}",
        tried=tried,
    )
