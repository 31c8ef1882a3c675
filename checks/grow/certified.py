"""Certified run for a user: the tree in balls, compared with that in floats, its certificate."""

from fractions import Fraction
from typing import Any

from checks.grow.bar import share_bar
from checks.grow.certificate import certificate_of
from checks.grow.computing import Undecided
from discrete.certified_greedy import certified_tree
from discrete.certified_tree import CertifiedTree
from discrete.complex_errors import SurgeryError
from discrete.errors import InsufficientPrecisionError, ShapeError
from discrete.greedy_tree import GreedyTree


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
    if cuts_of(found) != _cuts_in_floats(tree):
        raise Undecided("no certificate: rounding misplaced a cut of the run in floats")
    return certificate_of(found)


def cuts_of(tree: CertifiedTree) -> dict[str, tuple[int, int] | None]:
    """Place of the cut of each sector by its path, None where it is not cut."""
    return {s.path: None if s.cut is None else (s.cut.i, s.cut.k) for s in tree.sectors}


def _cuts_in_floats(tree: GreedyTree) -> dict[str, tuple[int, int] | None]:
    return {
        path: (int(row["i_cut"]), int(row["k_cut"])) if row["cut"] else None
        for row, path in zip(tree.sectors, tree.paths, strict=True)
    }


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
