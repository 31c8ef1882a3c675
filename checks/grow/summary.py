"""What a run of the greedy algorithm found, as plain data and as a table."""

from typing import Any

from discrete.greedy_tree import GreedyTree


def plain(tree: GreedyTree, seconds: float) -> dict[str, Any]:
    """Data of a run for the whole disk; seconds: of computing, with kernels that are warm.

    The centre is generation 0, and a branch point only where more than four sectors meet there.
    """
    run = tree.parameters
    return {
        "radius": float(run.radius),
        "phi0": float(run.phi0),
        "cutoff": float(run.cutoff),
        "step": float(run.step),
        "sectors": tree.sector_count,
        "branch_points": tree.branch_point_count,
        "generations": tree.generations,
        "min_angle": tree.min_angle,
        "max_angle": tree.max_angle,
        "max_curvature": tree.max_curvature,
        "willmore": tree.willmore,
        "area": tree.area,
        "area_expected": run.area,
        "terminated": tree.terminated,
        "seconds": seconds,
        "branch": branch(tree),
        "exact": {
            "radius": str(run.radius),
            "phi0": str(run.phi0),
            "cutoff": str(run.cutoff),
            "step": str(run.step),
        },
    }


def branch(tree: GreedyTree) -> list[dict[str, Any]]:
    """Branch points of the whole disk, the centre first."""
    run = tree.parameters
    centre: list[dict[str, Any]] = []
    if run.sectors > 4:
        centre.append(
            {
                "generation": 0,
                "path": "",
                "parent": None,
                "rho": 0.0,
                "theta": 0.0,
                "angle": float(run.phi0),
                "cut_angle": None,
                "distance_to_rim": float(run.radius),
            }
        )
    return centre + [
        {
            "generation": point.generation,
            "path": point.path,
            "parent": point.parent,
            "rho": point.rho,
            "theta": point.theta,
            "angle": point.angle,
            "cut_angle": point.cut_angle,
            "distance_to_rim": point.distance_to_rim,
        }
        for point in tree.branch_points()
    ]


def table(tree: GreedyTree, seconds: float) -> list[str]:
    """Lines for a reader."""
    run = tree.parameters
    rows = [
        ("disk", f"radius {run.radius}, {run.sectors} initial sectors of angle {run.phi0}"),
        ("net", f"edge length {run.step}, cutoff {run.cutoff}"),
        ("sectors", f"{tree.sector_count}"),
        ("branch points", f"{tree.branch_point_count} in {tree.generations} generations"),
        ("angles", f"{tree.min_angle:.10g} to {tree.max_angle:.10g}"),
        ("max curvature", f"{tree.max_curvature:.10g}"),
        ("Willmore energy", f"{tree.willmore:.10g}"),
        ("area", f"{tree.area:.10g}, of a disk of area {run.area:.10g}"),
        ("computed in", f"{seconds:.3g} s"),
    ]
    width = max(len(name) for name, _ in rows)
    return [f"{name:<{width}}  {text}" for name, text in rows]
