"""Values of the greedy algorithm as the edge length goes to 0, extrapolated from runs.

A cut is snapped to the grid, and the cuts below it start from there, so that a value has the error
c(Delta) Delta with a bounded c that jumps. A line a + b Delta is fitted, with weights
1/Delta. Since c jumps by as much as its mean, the uncertainty is what the line adds to the value at
the finest edge length, and that edge length times the largest residual over Delta.
"""

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from discrete.errors import ShapeError
from discrete.greedy import grown
from discrete.greedy_parameters import GreedyParameters
from discrete.greedy_tree import GreedyTree


@dataclass(frozen=True, kw_only=True)
class Extrapolation:
    """Value in the limit and its uncertainty, the values at the edge lengths, coarsest first."""

    value: float
    uncertainty: float
    steps: tuple[Fraction, ...]
    values: tuple[float, ...]


def line_at_zero(steps: Sequence[Fraction], values: Sequence[float]) -> Extrapolation:
    """Fit of a line to values at three or more edge lengths, coarsest first. Raises ShapeError."""
    if len(steps) < 3 or len(steps) != len(values) or sorted(steps, reverse=True) != list(steps):
        raise ShapeError(
            f"{len(steps)} edge lengths and {len(values)} values: expected as many, three or more, "
            "coarsest first"
        )
    lengths = np.array([float(step) for step in steps])
    slope, start = np.polyfit(lengths, np.array(values), 1, w=1 / lengths)
    spread = np.abs(np.array(values) - start - slope * lengths) / lengths
    return Extrapolation(
        value=float(start),
        uncertainty=float((abs(slope) + spread.max()) * lengths[-1]),
        steps=tuple(steps),
        values=tuple(values),
    )


def _count(steps: Sequence[Fraction], values: Sequence[int]) -> Extrapolation:
    """Of a whole number: the finest value, and how far it has moved from the one before."""
    return Extrapolation(
        value=float(values[-1]),
        uncertainty=float(abs(values[-1] - values[-2])),
        steps=tuple(steps),
        values=tuple(float(value) for value in values),
    )


def _places(trees: Sequence[GreedyTree]) -> dict[str, list[float]]:
    """Distances from the centre of the cuts that all runs have, by their paths."""
    by_path = [
        {
            path: float(row["cut_rho"])
            for row, path in zip(tree.sectors, tree.paths, strict=True)
            if row["cut"]
        }
        for tree in trees
    ]
    common = set.intersection(*(set(places) for places in by_path))
    return {path: [places[path] for places in by_path] for path in sorted(common)}


def extrapolated(
    parameters: GreedyParameters,
    steps: Sequence[Fraction],
    *,
    executor: Executor | None = None,
    max_cuts: int = 10**6,
) -> dict[str, Extrapolation]:
    """Values for edge length 0: min_angle, max_curvature, willmore, branch_points, rho of each cut.

    steps: three or more edge lengths, coarsest first, in place of the step of the parameters; a cut
    is named `rho` and its path below the initial sector. Raises ShapeError, also where a run is
    not over after max_cuts.
    """
    trees = [
        grown(replace(parameters, step=step), executor=executor, max_cuts=max_cuts)
        for step in steps
    ]
    if not all(tree.terminated for tree in trees):
        raise ShapeError(f"a run is not over after {max_cuts} cuts: raise max_cuts")
    found = {
        name: line_at_zero(steps, [getattr(tree, name) for tree in trees])
        for name in ("min_angle", "max_curvature", "willmore")
    }
    found["branch_points"] = _count(steps, [tree.branch_point_count for tree in trees])
    for path, places in _places(trees).items():
        found[f"rho {path}"] = line_at_zero(steps, places)
    return found
