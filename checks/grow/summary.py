"""What a run of the greedy algorithm found, as plain data and as a table."""

import math
from collections.abc import Iterator
from typing import Any

from discrete.greedy_parameters import GreedyParameters
from discrete.greedy_tree import BranchPoint, GreedyTree


def plain(tree: GreedyTree, seconds: float) -> dict[str, Any]:
    """Data of a run for the whole disk; seconds: of computing, with kernels that are warm.

    The extremes of the angle are null where a partial tree keeps no vertex at all. The branch
    points are an iterator: there may be millions.
    """
    run = tree.parameters
    low, high, curvature = _extremes(tree)
    return {
        **in_floats(run),
        "sectors": tree.sector_count,
        "branch_points": tree.branch_point_count,
        "generations": tree.generations,
        "min_angle": low,
        "max_angle": high,
        "max_curvature": curvature,
        "willmore": tree.willmore,
        "area": tree.area,
        "area_expected": run.area,
        "terminated": tree.terminated,
        "seconds": round(seconds, 6),
        "branch": branch(tree),
        "exact": as_texts(run),
    }


def _extremes(tree: GreedyTree) -> tuple[float | None, float | None, float | None]:
    if tree.min_angle > tree.max_angle:
        return None, None, None
    return tree.min_angle, tree.max_angle, tree.max_curvature


def branch(tree: GreedyTree) -> Iterator[dict[str, Any]]:
    """Branch points of the whole disk, the centre first if more than four sectors meet there."""
    yield from centre(tree.parameters)
    yield from map(_entry, tree.branch_points())


def in_floats(run: GreedyParameters) -> dict[str, float]:
    """Parameters of a run, rounded."""
    return {name: float(getattr(run, name)) for name in ("radius", "phi0", "cutoff", "step")}


def as_texts(run: GreedyParameters) -> dict[str, str]:
    """Parameters of a run, exact."""
    return {name: str(getattr(run, name)) for name in ("radius", "step", "phi0", "cutoff")}


def centre(run: GreedyParameters) -> list[dict[str, Any]]:
    """Entry of the centre, which is a branch point where more than four sectors meet."""
    entry = {
        "generation": 0,
        "path": "",
        "parent": None,
        "rho": 0.0,
        "theta": 0.0,
        "angle": float(run.phi0),
        "cut_angle": None,
        "distance_to_rim": float(run.radius),
    }
    return [entry] * (run.sectors > 4)


def _entry(point: BranchPoint) -> dict[str, Any]:
    return {
        "generation": point.generation,
        "path": point.path,
        "parent": point.parent,
        "rho": point.rho,
        # A direction that rounding puts just below 0 comes out as 2 pi itself.
        "theta": point.theta if point.theta < 2 * math.pi else 0.0,
        "angle": point.angle,
        "cut_angle": point.cut_angle,
        "distance_to_rim": point.distance_to_rim,
    }


def table(tree: GreedyTree, seconds: float) -> list[str]:
    """Lines for a reader."""
    run = tree.parameters
    low, high, curvature = _extremes(tree)
    rows = [
        ("disk", f"radius {run.radius}, {run.sectors} initial sectors of angle {run.phi0}"),
        ("net", f"step {run.step}, cutoff {run.cutoff}"),
        ("sectors", f"{tree.sector_count}"),
        ("branch points", f"{tree.branch_point_count}, generations {tree.generations}"),
        ("angles", "none" if low is None else f"{low:.10g} to {high:.10g}"),
        ("max curvature", "none" if curvature is None else f"{curvature:.10g}"),
        ("willmore", f"{tree.willmore:.10g}"),
        ("area", f"{tree.area:.10g}, expected {run.area:.10g}"),
        ("terminated", "yes" if tree.terminated else "no, the tree is partial"),
        ("computed in", f"{seconds:.3g} s"),
    ]
    width = max(len(name) for name, _ in rows)
    return [f"{name:<{width}}  {text}" for name, text in rows]
