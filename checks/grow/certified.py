"""Certified run for a user: the tree in balls, compared with that in floats, its certificate."""

from fractions import Fraction
from typing import Any

from checks.grow.bar import share_bar
from checks.grow.certificate import certificate_of
from checks.grow.computing import Undecided
from discrete.certified_greedy import certified_tree
from discrete.certified_tree import CertifiedSector, CertifiedTree
from discrete.complex_errors import SurgeryError
from discrete.enclosure import Enclosure
from discrete.errors import InsufficientPrecisionError, ShapeError
from discrete.greedy_tree import GreedyTree

#: Rounding that angles and distances of a run in floats may have gathered.
ROUNDING = 1e-9


def certified_data(tree: GreedyTree, *, max_cuts: int) -> dict[str, Any]:
    """Certificate of the run that made a tree in floats.

    Raises Undecided where the run in balls does not end, or makes other cuts than that in floats.
    """
    if not tree.terminated:
        raise Undecided(f"no certificate: {max_cuts} cuts do not suffice, raise --max-cuts")
    try:
        with share_bar("sectors certified") as progress:
            found = certified_tree(
                tree.parameters,
                max_cuts=max_cuts,
                progress=lambda done, waiting: progress(done / (done + waiting)),
            )
    except (InsufficientPrecisionError, ShapeError, SurgeryError) as error:
        raise Undecided(f"no certificate: {error}") from None
    if where := difference(found, tree):
        raise Undecided(f"no certificate: rounding misled the run in floats, {where}")
    return certificate_of(found)


def difference(found: CertifiedTree, floats: GreedyTree) -> str:
    """Where a tree in balls is not that in floats, empty if it is: which sector, and in what."""
    told = {sector.path: sector for sector in found.sectors}
    if set(told) != set(floats.paths):
        return "other sectors"
    for row, path in zip(floats.sectors, floats.paths, strict=True):
        sector = told[path]
        counted = (sector.copies, sector.mirrored, sector.quads, _place(sector))
        place = (int(row["i_cut"]), int(row["k_cut"])) if row["cut"] else None
        if counted != (row["copies"], row["mirrored"], row["quads"], place):
            return f"sector {path!r}: copies, symmetry, quads or place of the cut"
        for name, value in _measured(sector).items():
            if not abs(float(value) - row[name]) <= ROUNDING:
                return f"sector {path!r}: {name}"
    return ""


def _place(sector: CertifiedSector) -> tuple[int, int] | None:
    return None if sector.cut is None else (sector.cut.i, sector.cut.k)


def _measured(sector: CertifiedSector) -> dict[str, Enclosure]:
    """Enclosures of a sector by the names that a tree in floats has for them."""
    found = {"opening": sector.opening}
    for name in ("largest", "smallest"):
        extreme = getattr(sector, name)
        found |= {name: extreme.angle} if extreme else {}
    if sector.cut:
        found |= {"cut_angle": sector.cut.angle, "cut_rho": sector.cut.rho}
    return found


def _number(text: str) -> str:
    m, e, r, f = (int(part) for part in text.split(" "))
    middle, radius = m * Fraction(2) ** e, r * Fraction(2) ** f
    return f"{float(middle):.15g} +/- {float(radius):.1e}"


def certificate_lines(certificate: dict[str, Any]) -> list[str]:
    """Lines of the table on a certificate: what is proved."""
    totals = certificate["totals"]
    return [
        f"certified      every comparison decided with {certificate['bits']} bits: the run ends",
        f"               with {totals['branch_points']} branch points and {totals['quads']} quads",
        f"least angle    {_number(totals['smallest'])}",
        f"largest angle  {_number(totals['largest'])}",
    ]
