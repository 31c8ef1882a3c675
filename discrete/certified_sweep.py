"""Sweep of a sector in balls, row by row: which quads belong to the disk, where an angle is bad.

The rule of discrete.sector_sweep. The differences of the heights along a row of quads are carried,
as those of the angles are, so that the radii of the balls grow no faster than the net:

    h12 - h2 = h1 - h + (k - 1)(h1 + h2),  k - 1 = 2 q (cos A - q)/|1 - q e^(iA)|^2.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from discrete.certified_sides import BallConstants, BallSide, UndecidedError
from discrete.sector_cutter import TooNarrowError


@dataclass(frozen=True, kw_only=True, eq=False)
class BallExtreme:
    """Ball around an extreme angle, and the first vertex (i, j) that may have it."""

    angle: Any
    vertex: tuple[int, int]


@dataclass(kw_only=True, eq=False)
class BallRow:
    """Row j of quads: angles, half defects, heights of the vertices above it, and its run.

    start, end: columns of the run of quads that meet the disk, -1 without any; closed: whether the
    quad that ends the run is in the row. bad: the first angle that is certainly beyond the cutoff;
    open: whether another may be, as far as the balls tell.
    """

    angles: list[Any] = field(default_factory=list)
    defects: list[Any] = field(default_factory=list)
    heights: list[Any] = field(default_factory=list)
    start: int = -1
    end: int = -1
    closed: bool = False
    open: bool = False
    bad: BallExtreme | None = None
    largest: BallExtreme | None = None
    smallest: BallExtreme | None = None

    def is_bad(self) -> bool:
        """Whether an angle exceeds the cutoff. Raises UndecidedError."""
        if self.bad is None and self.open:
            raise UndecidedError
        return self.bad is not None


@dataclass(frozen=True, kw_only=True, eq=False)
class BallSweep:
    """Rows of the disk below the first bad one, or all.

    bad: the first bad angle of the bad row and its vertex; line: of the row `kept` of vertices,
    where there is a bad row.
    """

    kept: int
    quads: int
    largest: BallExtreme | None
    smallest: BallExtreme | None
    bad: BallExtreme | None
    line: BallSide | None


def larger(first: BallExtreme | None, second: BallExtreme | None) -> BallExtreme | None:
    """The larger extreme; the first where neither is certainly larger."""
    if first is None or second is None:
        return first or second
    if second.angle > first.angle:
        return second
    if second.angle < first.angle:
        return first
    return BallExtreme(angle=first.angle.max(second.angle), vertex=first.vertex)


def smaller(first: BallExtreme | None, second: BallExtreme | None) -> BallExtreme | None:
    """The smaller extreme; the first where neither is certainly smaller."""
    if first is None or second is None:
        return first or second
    if second.angle < first.angle:
        return second
    if second.angle > first.angle:
        return first
    return BallExtreme(angle=first.angle.min(second.angle), vertex=first.vertex)


def is_near(reach: Any, heights: Sequence[Any]) -> bool:
    """Whether one of the heights is below `reach`. Raises UndecidedError."""
    if any(h < reach for h in heights):
        return True
    if all(h >= reach for h in heights):
        return False
    raise UndecidedError


def is_inside(
    constants: BallConstants, height: Any, vertex: tuple[int, int], sides: tuple[BallSide, BallSide]
) -> bool:
    """Whether a vertex lies in the closed disk: on an axis its distance is compared exactly.

    Raises UndecidedError.
    """
    if height < constants.rim:
        return True
    if height > constants.rim:
        return False
    given = constants.parameters
    for n, other, side in ((*vertex, sides[0]), (*vertex[::-1], sides[1])):
        if other == 0 and side.start is not None:
            return side.start + n * given.step <= given.radius
    raise UndecidedError


def is_flipped(angle: Any) -> bool:
    """Whether a quad is flipped, the angle pi or more: it is bad wherever it is.

    Raises UndecidedError.
    """
    pi = constant_pi()
    if angle < pi:
        return False
    if angle >= pi:
        return True
    raise UndecidedError


def constant_pi() -> Any:
    """Ball around pi at the precision in force."""
    from flint import arb

    return arb.pi()


def advanced_row(
    constants: BallConstants, j: int, below: BallRow, sides: tuple[BallSide, BallSide]
) -> BallRow:
    """Row j above another, up to the end of its run and of the ring, or all that the other allows.

    It is left off where its run cannot touch the one below. Raises UndecidedError.
    """
    q, rim, reach, outer = constants.q, constants.rim, constants.reach, constants.outer
    second, cutoff = sides[1], constants.cutoff
    row = BallRow(heights=[second.heights[j + 1]])
    rise, defect = second.turns[j], 0
    climb = second.heights[j + 1] - second.heights[j]
    twice = 2 * q
    h, h2 = below.heights[0], row.heights[0]
    for i in range(len(below.angles)):
        h1 = below.heights[i + 1]
        rise = rise + (below.defects[i] + defect)
        angle = below.angles[i] + rise
        s, c = angle.sin_cos()
        e, f = 1 - q * c, q * s
        defect = 2 * (f / e).atan()
        climb = climb + twice * (c - q) / (e * e + f * f) * (h1 + h2)
        h12 = h1 + climb
        row.angles.append(angle)
        row.defects.append(defect)
        row.heights.append(h12)
        if not row.closed:
            if h < reach or is_near(reach, (h, h1, h12, h2)):
                row.start = i if row.start < 0 else row.start
                row.end = i
                if h < rim or is_inside(constants, h, (i, j), sides) or is_flipped(angle):
                    here = BallExtreme(angle=angle, vertex=(i, j))
                    row.largest = larger(row.largest, here)
                    row.smallest = smaller(row.smallest, here)
                    if angle > cutoff:
                        row.bad = row.bad or here
                    elif not angle <= cutoff:
                        row.open = True
            elif row.start >= 0:
                row.closed = True
            elif j > 0 and i > below.end:
                return row
        if row.closed and h12 > outer:
            return row
        h, h2 = h1, h12
    return row


def touches(row: BallRow, below: BallRow, j: int) -> bool:
    """Whether the run of row j touches that of the row below it."""
    if row.start < 0:
        return False
    return j == 0 or (row.start <= below.end + 1 and row.end >= below.start - 1)


def swept(constants: BallConstants, first: BallSide, second: BallSide) -> BallSweep:
    """Sweep of the sector between two sides.

    Raises UndecidedError, and TooNarrowError where the lines end before the disk does.
    """
    n = len(first.heights) - 1
    below = BallRow(angles=[0] * n, defects=list(first.turns[:n]), heights=list(first.heights))
    rows = [below]
    done: list[BallRow] = []
    for j in range(len(second.heights) - 1):
        row = advanced_row(constants, j, rows[-1], (first, second))
        if not row.closed and row.start >= 0 and not row.is_bad():
            raise TooNarrowError
        if not touches(row, rows[-1], j):
            return _summed(done, None, None)
        if row.is_bad():
            kept = max(j - 1, 0)
            line = first.with_first_turn(second.turns[0])
            if kept:
                line = row_line(rows[-2], second, kept)
            return _summed(done[:kept], row.bad, line)
        done.append(_summary(row))
        rows = [rows[-1], row]
    raise TooNarrowError


def row_line(row: BallRow, second: BallSide, k: int) -> BallSide:
    """Row k of vertices, above row k - 1 of quads: turns measured above it.

    The first turn is the angle at its vertex on the second side.
    """
    n = len(row.angles)
    turns = [row.angles[0] + row.defects[0] + second.turns[k]]
    turns += [row.angles[i] - row.angles[i - 1] + row.defects[i] for i in range(1, n)]
    return BallSide(heights=row.heights, turns=[*turns, 0])


def _summary(row: BallRow) -> BallRow:
    """Row without its angles and heights."""
    return BallRow(
        start=row.start, end=row.end, closed=row.closed, largest=row.largest, smallest=row.smallest
    )


def _summed(rows: list[BallRow], bad: BallExtreme | None, line: BallSide | None) -> BallSweep:
    largest = smallest = None
    for row in rows:
        largest, smallest = larger(largest, row.largest), smaller(smallest, row.smallest)
    return BallSweep(
        kept=len(rows),
        quads=sum(row.end - row.start + 1 for row in rows),
        largest=largest,
        smallest=smallest,
        bad=bad,
        line=line,
    )
