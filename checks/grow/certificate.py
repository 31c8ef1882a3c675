"""Certificate of a run of the greedy algorithm as plain data: see certificates.greedy_format."""

from typing import Any

from discrete.certified_tree import CertifiedTree, Extreme
from discrete.enclosure import Enclosure, fraction_of

FORMAT = "kminusone greedy certificate 1"


def certificate_of(tree: CertifiedTree) -> dict[str, Any]:
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
                "area": ball(sector.area),
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
            "area": ball(tree.area),
            "largest": ball(max(largest, key=lambda x: fraction_of(x.midpoint))),
            "smallest": ball(min(smallest, key=lambda x: fraction_of(x.midpoint))),
        },
    }


def ball(value: Enclosure) -> str:
    """Midpoint and radius as four integers."""
    return " ".join(str(n) for n in (*value.midpoint, *value.radius))


def _extreme(value: Extreme | None) -> list[Any] | None:
    return None if value is None else [ball(value.angle), list(value.vertex)]
