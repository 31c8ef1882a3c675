"""Rows of a hyperbolic Chebyshev net as triples of balls, each vertex by a half-turn of another.

Hyperboloid model, <x, y> = x0 y0 - x1 y1 - x2 y2: the half-turn about the middle of p1 and p2 takes
p to k (p1 + p2) - p, k = 2 cosh l/(1 + <p1, p2>); the angle at p has the cosine
(cosh^2 l - <p1, p2>)/sinh^2 l. The rule of what belongs to the disk: of a row of quads, the first
unbroken run of those with a vertex nearer to the centre than `reach` allows; the rows end where a
run does not touch the one below.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from flint import arb, fmpq

Point = tuple[Any, Any, Any]


class OpenError(ArithmeticError):
    """A ball is too wide at the precision in force."""


class WrongError(ValueError):
    """What a certificate says is refuted; the message says where."""


def rational(value: Fraction) -> Any:
    """Ball around a rational number."""
    return arb(fmpq(value.numerator, value.denominator))


def decided(yes: Any, no: Any) -> bool:
    """The certain one of two contrary comparisons. Raises OpenError where neither is."""
    if yes:
        return True
    if no:
        return False
    raise OpenError


@dataclass(frozen=True, kw_only=True, eq=False)
class Line:
    """Points of a side from its corner on; start: see `Disk.holds`, None off the axes."""

    points: Sequence[Point]
    start: Fraction | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Disk:
    """Numbers of a run as balls; cutoff: the cosine of it."""

    radius: Fraction
    step: Fraction
    rim: Any
    reach: Any
    far: Any
    cosh: Any
    sinh: Any
    cutoff: Any

    @classmethod
    def of(cls, radius: Fraction, step: Fraction, cutoff: tuple[Fraction, Fraction]) -> "Disk":
        """Numbers at the precision in force; points are made up to 1/4 beyond the rim."""
        length, r = rational(step), rational(radius)
        return cls(
            radius=radius,
            step=step,
            rim=r.cosh(),
            reach=((r + length / 2).cosh() + (r - length / 2).cosh()) / 2,
            far=(r + arb(1) / 4 + 4 * length).cosh(),
            cosh=length.cosh(),
            sinh=length.sinh(),
            cutoff=(rational(cutoff[0]) + arb.pi() * rational(cutoff[1])).cos(),
        )

    def holds(self, p: Point, n: int, line: Line | None) -> bool:
        """Whether p lies in the closed disk; on a line through the centre n says it exactly."""
        if line is not None and line.start is not None:
            return line.start + n * self.step <= self.radius
        return decided(p[0] <= self.rim, p[0] > self.rim)


@dataclass(kw_only=True, eq=False)
class Row:
    """Row of quads: the points above it, its run, and cosines at the corners of its quads.

    cosines: at the vertices in the disk; flipped: of the quads that are flipped, wherever they are
    (their angle lies beyond pi, which a cosine does not tell).
    """

    top: list[Point] = field(default_factory=list)
    start: int = -1
    end: int = -1
    ended: bool = False
    cosines: list[tuple[int, Any]] = field(default_factory=list)
    flipped: list[tuple[int, Any]] = field(default_factory=list)

    def folds(self, disk: Disk) -> bool:
        """Whether an angle exceeds the cutoff, or a quad of the run is flipped."""
        if self.flipped:
            return True
        found = False
        for _, c in self.cosines:
            if c < disk.cutoff:
                return True
            found = found or not c >= disk.cutoff
        if found:
            raise OpenError
        return False


def orientation(corner: tuple[Point, Point, Point]) -> Any:
    """Determinant of three points, positive where they lie counterclockwise."""
    a, b, c = corner
    return (
        a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
    )


def is_flipped(corner: tuple[Point, Point, Point], hand: Any) -> bool:
    """Whether the corner p, p1, p2 of a quad is oriented against the corner of its sector."""
    turn = orientation(corner) * hand
    return not decided(turn > 0, turn <= 0)


def next_row(
    disk: Disk, low: Sequence[Point], below: Row | None, j: int, sides: Any, hand: Any
) -> Row:
    """Row of quads above a row of points; hand: the orientation at the corner of the sector."""
    first, second = sides
    p2 = second.points[j + 1]
    row, p, twice = Row(top=[p2]), low[0], 2 * disk.cosh
    square, sine2 = disk.cosh**2, disk.sinh**2
    for i in range(len(low) - 1):
        p1 = low[i + 1]
        s0, s1, s2 = p1[0] + p2[0], p1[1] + p2[1], p1[2] + p2[2]
        d = p1[0] * p2[0] - p1[1] * p2[1] - p1[2] * p2[2]
        k = twice / (1 + d)
        p12 = (k * s0 - p[0], k * s1 - p[1], k * s2 - p[2])
        if not row.ended:
            corners = (p[0], p1[0], p2[0], p12[0])
            near = p[0] < disk.reach or decided(
                any(h < disk.reach for h in corners), all(h >= disk.reach for h in corners)
            )
            if near:
                row.start, row.end = (i if row.start < 0 else row.start), i
                line, n = (first, i) if j == 0 else (second, j) if i == 0 else (None, 0)
                if is_flipped((p, p1, p2), hand):
                    row.flipped.append((i, (square - d) / sine2))
                elif disk.holds(p, n, line):
                    row.cosines.append((i, (square - d) / sine2))
            elif row.start >= 0:
                row.ended = True
            elif below is not None and i > below.end:
                return row
        row.top.append(p12)
        if row.ended and p12[0] > disk.far:
            return row
        p, p2 = p1, p12
    return row


def rows(disk: Disk, first: Line, second: Line) -> Iterator[tuple[Sequence[Point], Row]]:
    """Rows of the disk, each with the points below it, up to the first that is not reached."""
    low: Sequence[Point] = first.points
    below: Row | None = None
    hand = orientation((first.points[0], first.points[1], second.points[1]))
    for j in range(len(second.points) - 1):
        row = next_row(disk, low, below, j, (first, second), hand)
        if row.start < 0:
            return
        if below is not None and (row.start > below.end + 1 or row.end < below.start - 1):
            return
        yield low, row
        if not row.ended:
            raise WrongError("a line ends before the disk does")
        low, below = row.top, row
    raise WrongError("a side ends before the disk does")
