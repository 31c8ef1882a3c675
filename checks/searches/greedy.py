"""Certificates of the greedy algorithm beyond a right angle, on the disk of radius 6."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from discrete.certified_greedy import certified_tree
from discrete.certified_tree import CertifiedTree, Extreme
from discrete.enclosure import Enclosure, fraction_of
from discrete.exact_angle import ExactAngle
from discrete.greedy_parameters import GreedyParameters

FORMAT = "kminusone greedy certificate 1"
#: Radius, step, sectors and cutoff in half turns.
RUNS = ((6, "1/25", 4, "3/4"), (6, "1/25", 8, "4/5"))

SOURCES = (
    "checks/searches/greedy.py",
    *(
        f"discrete/{name}.py"
        for name in (
            "certified_cut",
            "certified_greedy",
            "certified_sides",
            "certified_sweep",
            "certified_tree",
            "elementary",
            "enclosure",
            "exact_angle",
            "greedy_parameters",
            "sl2_frames",
        )
    ),
)


def parameters(radius: object, step: str, sectors: int, cutoff: str) -> GreedyParameters:
    """Parameters with a cutoff in half turns."""
    return GreedyParameters(
        radius=Fraction(str(radius)),
        step=Fraction(step),
        sectors=sectors,
        cutoff=ExactAngle(half_turns=Fraction(cutoff)),
    )


def written(tree: CertifiedTree) -> dict[str, Any]:
    """Certificate as plain data: see checks.certificates.greedy_format."""
    given = tree.parameters
    largest = [x.largest.angle for x in tree.sectors if x.largest]
    smallest = [x.smallest.angle for x in tree.sectors if x.smallest]
    return {
        "format": FORMAT,
        "parameters": {
            "radius": str(given.radius),
            "step": str(given.step),
            "sectors": given.sectors,
            "cutoff": [str(given.cutoff.radians), str(given.cutoff.half_turns)],
        },
        "bits": tree.bits,
        "sectors": [
            {
                "path": sector.path,
                "opening": ball(sector.opening),
                "quads": sector.quads,
                "largest": _extreme(sector.largest),
                "smallest": _extreme(sector.smallest),
                "cut": None
                if (cut := sector.cut) is None
                else {
                    "i": cut.i,
                    "k": cut.k,
                    **{name: ball(getattr(cut, name)) for name in ("angle", "rho", "theta")},
                    "row": _extreme(cut.row),
                    "column": _extreme(cut.column),
                },
            }
            for sector in tree.sectors
        ],
        "totals": {
            "sectors": tree.sector_count,
            "branch_points": tree.branch_point_count,
            "quads": tree.quad_count,
            "generations": tree.generations,
            "largest": ball(max(largest, key=lambda x: fraction_of(x.midpoint))),
            "smallest": ball(min(smallest, key=lambda x: fraction_of(x.midpoint))),
        },
    }


def ball(value: Enclosure) -> str:
    """Midpoint and radius as four integers."""
    return " ".join(str(n) for n in (*value.midpoint, *value.radius))


def _extreme(value: Extreme | None) -> list[Any] | None:
    return None if value is None else [ball(value.angle), list(value.vertex)]


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Certificates of RUNS; margin: the number of runs that ended (seed unused)."""
    found = []
    for run in RUNS:
        progress(f"radius {run[0]}, step {run[1]}, {run[2]} sectors, cutoff {run[3]} pi")
        found.append(written(certified_tree(parameters(*run))))
    return {
        "evaluations": sum(certificate["totals"]["quads"] for certificate in found),
        "margin": len(found),
        "certificates": found,
    }
