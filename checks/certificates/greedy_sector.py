"""One sector of a certificate of the greedy algorithm, swept again: cut, witnesses, daughters.

See checks.certificates.greedy_rows for the rule.
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb

from checks.certificates.greedy_format import Ball, Cut, Extreme, Sector
from checks.certificates.greedy_rows import (
    Disk,
    Line,
    OpenError,
    Point,
    Row,
    WrongError,
    decided,
    rational,
    rows,
)

#: An enclosure may be this wide at most; a wider one would say little and overlap everything.
WIDEST = Fraction(1, 2**48)


@dataclass(frozen=True, kw_only=True, eq=False)
class Room:
    """Sector to be checked: its place in the tree, its sides, the angle between them."""

    path: str
    copies: int
    mirrored: bool
    opening: Any
    first: Line
    second: Line


def initial_room(disk: Disk, sectors: int, phi0: Any) -> Room:
    """First sector at the centre."""
    origin = (arb(1), arb(0), arb(0))
    sides = []
    for c, s in ((arb(1), arb(0)), (phi0.cos(), phi0.sin())):
        sides.append(_geodesic(disk, origin, (arb(0), c, s), Fraction(0)))
    return Room(path="", copies=sectors, mirrored=True, opening=phi0, first=sides[0],
                 second=sides[1])  # fmt: skip


def _geodesic(disk: Disk, p: Point, e: Point, start: Fraction | None = None) -> Line:
    """Points at multiples of the step from p on along a unit tangent e."""
    points = [p]
    while not points[-1][0] > disk.far:
        t = rational(disk.step * len(points))
        c, s = t.cosh(), t.sinh()
        points.append((p[0] * c + e[0] * s, p[1] * c + e[1] * s, p[2] * c + e[2] * s))
        if not points[-1][0].is_finite():
            raise OpenError
    return Line(points=points, start=start)


def require(condition: bool, message: str) -> None:
    """Raises WrongError with the message where the condition does not hold."""
    if not condition:
        raise WrongError(message)


def matches(ball: Any, said: Ball, what: str) -> None:
    """Whether the number in a ball lies in the interval said. Raises WrongError, OpenError."""
    require(said.high - said.low <= WIDEST, f"{what}: the enclosure is too wide to say anything")
    low, high = rational(said.low), rational(said.high)
    inside = decided(ball >= low and ball <= high, ball < low or ball > high)
    require(inside, f"{what} is {ball.mid().str(12, radius=False)}, outside its enclosure")


Seen = list[tuple[tuple[int, int], Any]]


def checked_sector(disk: Disk, room: Room, sector: Sector) -> tuple[list[Any], list[Room]]:
    """Cosines of the extremes and daughters of a sector that is as the certificate says."""
    name = f"sector {room.path!r}"
    matches(room.opening, sector.opening, f"{name}: opening")
    kept, low, bad = _swept(disk, room.first, room.second)
    daughters: list[Room] = []
    require((bad is None) == (sector.cut is None), f"{name}: whether it is cut")
    if bad is not None and sector.cut is not None:
        k = len(kept)
        require(sector.cut.k == k, f"{name}: k* is {k}")
        line = Line(points=low, start=room.first.start if k == 0 else None)
        side = _beyond(disk, room.second, k)
        columns, up, worse = _swept(disk, side, line)
        i = len(columns)
        require(sector.cut.i == i, f"{name}: i* is {i}")
        if worse is None:
            raise WrongError(f"{name}: no column is bad, though a row is")
        _witnesses(disk, sector.cut, bad, worse, name, room.mirrored)
        column = Line(points=up, start=side.start if i == 0 else None)
        daughters = _cut(disk, room, sector.cut, _beyond(disk, line, i), column)
    else:
        columns, k = [], 0
    quads = sum(row.end - row.start + 1 for row in (*kept, *columns))
    require(sector.quads == quads, f"{name}: it has {quads} quads")
    vertices: Seen = [((i, j), c) for j, row in enumerate(kept) for i, c in row.cosines]
    vertices += [((i, k + n), c) for i, row in enumerate(columns) for n, c in row.cosines]
    return _extremes(vertices, sector, name), daughters


def _swept(disk: Disk, first: Line, second: Line) -> tuple[list[Row], Any, tuple[int, Row] | None]:
    """Rows below the last row of points before a bad one, those points, and the bad row."""
    kept: list[Row] = []
    lines: list[Any] = []
    for low, row in rows(disk, first, second):
        lines = [*lines[-1:], low]
        if row.folds(disk):
            return kept[:-1], lines[0], (len(kept), row)
        kept.append(row)
    return kept, None, None


def _beyond(disk: Disk, line: Line, n: int) -> Line:
    start = None if line.start is None else line.start + n * disk.step
    return Line(points=line.points[n:], start=start)


def _witnesses(
    disk: Disk, cut: Cut, bad: tuple[int, Row], worse: tuple[int, Row], name: str, mirrored: bool
) -> None:
    """Whether the witnesses said lie in the first bad row and column and exceed the cutoff."""
    j, row = bad
    _witness(disk, cut.row, cut.row.vertex[1] == j, row, cut.row.vertex[0], name)
    i, column = worse
    if mirrored:
        # The witness of the column is the mirror image of that of the row.
        at = cut.column.vertex
        require(at == cut.row.vertex[::-1], f"{name}: its witnesses are no mirror images")
        require(cut.column.angle == cut.row.angle, f"{name}: its witnesses differ in angle")
        return
    n = cut.column.vertex[1] - cut.k
    _witness(disk, cut.column, cut.column.vertex[0] == i, column, n, name)


def _witness(disk: Disk, said: Extreme, placed: bool, row: Row, n: int, name: str) -> None:
    cosines, flipped = dict(row.cosines), dict(row.flipped)
    require(
        placed and n in cosines | flipped, f"{name}: its witness {said.vertex} is in no bad line"
    )
    cosine = (cosines | flipped)[n]
    if n in cosines:
        require(
            decided(cosine < disk.cutoff, cosine >= disk.cutoff), f"{name}: its witness is good"
        )
    # Angles are counted beyond pi as well, where the cosine grows again.
    turn = cosine.acos()
    beyond = rational(said.angle.low) > arb.pi()
    matches(2 * arb.pi() - turn if beyond else turn, said.angle, f"{name}: witness")


def _extremes(vertices: Seen, sector: Sector, name: str) -> list[Any]:
    """Cosines of the largest and the smallest angle, which are where the sector says."""
    if not vertices:
        require(sector.largest is None and sector.smallest is None, f"{name}: has no vertex")
        return []
    found = []
    for said, sign, what in ((sector.largest, -1, "largest"), (sector.smallest, 1, "smallest")):
        require(said is not None, f"{name}: its {what} angle is missing")
        best, at = sign * vertices[0][1], vertices[0][0]
        for vertex, cosine in vertices[1:]:
            value = sign * cosine
            if value > best:
                best, at = value, vertex
            elif not value < best:
                best = best.max(value)
        if said is not None:
            require(said.vertex == at, f"{name}: its {what} angle is at {at}")
            matches((sign * best).acos(), said.angle, f"{name}: {what} angle")
        found.append(sign * best)
    return found


def _cut(disk: Disk, room: Room, said: Cut, row: Line, column: Line) -> list[Room]:
    """Daughters at a cut, after its angle and place have been compared with what is said.

    A cut at the centre itself is said to be at the distance and in the direction 0.
    """
    name = f"sector {room.path!r}"
    p = row.points[0]
    e, f = (_direction(disk, p, line.points[1]) for line in (row, column))
    cosine = e[1] * f[1] + e[2] * f[2] - e[0] * f[0]
    angle = cosine.acos()
    matches(angle, said.angle, f"{name}: cut angle")
    central = said.i == said.k == 0 and row.start == 0
    matches(arb(0) if central else p[0].acosh(), said.rho, f"{name}: rho")
    matches(arb(0) if central else arb.atan2(p[2], p[1]), said.theta, f"{name}: theta")
    sine = (1 - cosine**2).sqrt()
    g = tuple((y - cosine * x) / sine for x, y in zip(e, f, strict=True))
    start = Fraction(0) if central else None
    sides = []
    for n in (1, 2):
        c, s = (n * angle / 3).cos(), (n * angle / 3).sin()
        turned = (c * e[0] + s * g[0], c * e[1] + s * g[1], c * e[2] + s * g[2])
        sides.append(_geodesic(disk, p, turned, start))
    near, far = sides
    pairs = {"u": (row, near), "A": (far, near), "v": (far, column)}
    return [
        Room(
            path=room.path + letter,
            copies=room.copies * (2 if room.mirrored and letter == "u" else 1),
            mirrored=room.mirrored and letter == "A",
            opening=angle / 3,
            first=first,
            second=second,
        )
        for letter, (first, second) in pairs.items()
        if not (room.mirrored and letter == "v")
    ]


def _direction(disk: Disk, p: Point, to: Point) -> Point:
    """Unit tangent at p towards a point one step away."""
    x, y, z = ((b - disk.cosh * a) / disk.sinh for a, b in zip(p, to, strict=True))
    return x, y, z
