"""Cut of one sector in balls, and the three sectors put in there (lem:surgery).

The rule of discrete.sector_cut and discrete.sector_sides.daughters.
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from discrete.certified_sides import (
    BallConstants,
    BallSector,
    BallSide,
    UndecidedError,
    frame_at_cut,
    geodesic_side,
)
from discrete.certified_sweep import BallExtreme, larger, smaller, swept
from discrete.certified_tree import CertifiedCut, CertifiedSector, Extreme
from discrete.complex_errors import SurgeryError
from discrete.elementary import ball_functions
from discrete.enclosure import Enclosure
from discrete.sl2_frames import Frame, distance_from_start, triple_of, turned


@dataclass(frozen=True, kw_only=True, eq=False)
class BallCut:
    """Place of a cut and the lines from there on that bound what was cut out."""

    i: int
    k: int
    angle: Any
    frame: Frame
    row: BallSide
    column: BallSide


def cut_sector(
    constants: BallConstants, sector: BallSector
) -> tuple[CertifiedSector, list[BallSector]]:
    """What a sector keeps, with its cut, and its daughters.

    Raises UndecidedError, TooNarrowError; SurgeryError where rows and columns disagree.
    """
    rows = swept(constants, sector.first, sector.second)
    if rows.bad is None:
        return _told(sector, rows.quads, rows.largest, rows.smallest, None), []
    step, k, line = constants.parameters.step, rows.kept, rows.line
    if line is None:
        raise SurgeryError("a bad row without a line below it")
    side = sector.second.from_vertex(k, step, 0)
    columns = swept(constants, side, line)
    if columns.bad is None or columns.line is None:
        raise SurgeryError(f"sector {sector.path!r}: no column of it is bad, though a row is")
    bad, i = _swapped(columns.bad, k), columns.kept
    if sector.mirrored:
        if i < k:
            raise SurgeryError(f"sector {sector.path!r} is symmetric, its cut ({i}, {k}) is not")
        i, bad = k, BallExtreme(angle=rows.bad.angle, vertex=rows.bad.vertex[::-1])
        if columns.kept > k:
            raise SurgeryError(f"sector {sector.path!r} is symmetric, its bad vertices are not")
    cut = BallCut(
        i=i,
        k=k,
        angle=columns.line.turns[0],
        frame=frame_at_cut(sector, step, line, i, k),
        row=line.from_vertex(i, step, 0),
        column=columns.line,
    )
    largest = larger(rows.largest, _swapped(columns.largest, k))
    smallest = smaller(rows.smallest, _swapped(columns.smallest, k))
    told = CertifiedCut(
        i=i, k=k, angle=Enclosure.of(cut.angle), rho=_rho(cut), theta=_theta(cut),
        row=_extreme(rows.bad), column=_extreme(bad),
    )  # fmt: skip
    found = _told(sector, rows.quads + columns.quads, largest, smallest, told)
    return found, _daughters(constants, sector, cut)


def _swapped(found: BallExtreme | None, k: int) -> Any:
    """Extreme of the sweep by columns above row k, its vertex counted in the sector."""
    if found is None:
        return None
    column, i = found.vertex
    return BallExtreme(angle=found.angle, vertex=(i, column + k))


def _extreme(found: BallExtreme) -> Extreme:
    return Extreme(angle=Enclosure.of(found.angle), vertex=found.vertex)


def _told(
    sector: BallSector, quads: int, largest: BallExtreme | None, smallest: BallExtreme | None,
    cut: CertifiedCut | None,
) -> CertifiedSector:  # fmt: skip
    return CertifiedSector(
        path=sector.path,
        copies=sector.copies,
        mirrored=sector.mirrored,
        opening=Enclosure.of(sector.opening),
        quads=quads,
        largest=_extreme(largest) if largest else None,
        smallest=_extreme(smallest) if smallest else None,
        cut=cut,
    )


def _is_at_centre(cut: BallCut) -> bool:
    """Whether the cut is at the centre itself, where balls would not tell its distance from 0."""
    return cut.i == cut.k == 0 and cut.row.start == 0


def _rho(cut: BallCut) -> Enclosure:
    if _is_at_centre(cut):
        return Enclosure(midpoint=(0, 0), radius=(0, 0))
    if not all(entry.is_finite() for entry in cut.frame):
        raise UndecidedError
    rho = distance_from_start(ball_functions(), cut.frame)
    if not rho.is_finite():
        raise UndecidedError
    return Enclosure.of(rho)


def _theta(cut: BallCut) -> Enclosure:
    """Direction of the cut, in (-pi, pi); 0 at the centre itself."""
    if _is_at_centre(cut):
        return Enclosure(midpoint=(0, 0), radius=(0, 0))
    _, x, y = triple_of(cut.frame)
    return Enclosure.of(ball_functions().atan2(y, x))


def _daughters(constants: BallConstants, parent: BallSector, cut: BallCut) -> list[BallSector]:
    """Sectors u, A, v; of a mirrored parent, u and A alone."""
    functions, opening = ball_functions(), cut.angle / 3
    near_frame = turned(functions, cut.frame, parent.hand * opening)
    far_frame = turned(functions, near_frame, parent.hand * opening)
    # New sides go straight away from the centre only where the cut is there.
    start = Fraction(0) if _is_at_centre(cut) else None
    near = geodesic_side(constants, near_frame, opening, start=start)
    far = near.with_first_turn(0)
    if not parent.mirrored:
        far = geodesic_side(constants, far_frame, 0, start=start)
    sides = {
        "u": (cut.frame, parent.hand, cut.row, near),
        "A": (far_frame, -parent.hand, far, near),
        "v": (far_frame, parent.hand, far, cut.column.with_first_turn(opening)),
    }
    return [
        BallSector(
            path=parent.path + letter,
            copies=parent.copies * (2 if parent.mirrored and letter == "u" else 1),
            mirrored=parent.mirrored and letter == "A",
            hand=hand,
            frame=frame,
            first=first,
            second=second,
        )
        for letter, (frame, hand, first, second) in sides.items()
        if not (parent.mirrored and letter == "v")
    ]
