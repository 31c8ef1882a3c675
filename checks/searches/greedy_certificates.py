"""Certificates of the greedy algorithm beyond a right angle, on the disk of radius 6."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from checks.grow.certificate import certificate_of
from discrete.certified_greedy import certified_tree
from discrete.exact_angle import ExactAngle
from discrete.greedy_parameters import GreedyParameters

#: Radius, step, sectors and cutoff in half turns.
RUNS = ((6, "1/25", 4, "3/4"), (6, "1/25", 8, "4/5"))

SOURCES = (
    "checks/grow/certificate.py",
    "checks/searches/greedy_certificates.py",
    *(
        f"discrete/{name}.py"
        for name in (
            "certified_area",
            "certified_cut",
            "certified_greedy",
            "certified_sides",
            "certified_sweep",
            "certified_tree",
            "clipped_quads",
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


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Certificates of RUNS; margin: the number of runs that ended (seed unused)."""
    found = []
    for run in RUNS:
        progress(f"radius {run[0]}, step {run[1]}, {run[2]} sectors, cutoff {run[3]} pi")
        found.append(certificate_of(certified_tree(parameters(*run))))
    return {
        "evaluations": sum(certificate["totals"]["quads"] for certificate in found),
        "margin": len(found),
        "certificates": found,
    }
