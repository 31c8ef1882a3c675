"""Area in the disk of what a sector keeps, by its boundary: no quad is looked at.

Sectors and triangles with the centre, signed: inside the disk an edge gives the area of its
triangle with the centre, outside the circular sector under which it is seen. The lines that bound
a sector end outside; what closes it there gives circular sectors, whatever it is.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from flint import ctx

from checks.certificates.greedy_rows import Disk, Line, Point, decided, orientation

#: Points with thousands of bits are taken to this precision.
BITS = 512


def sector_area(disk: Disk, first: Line, second: Line, cut: tuple[Line, Line] | None) -> Any:
    """Area in the disk of a sector between two lines from its corner.

    cut: the lines from there on along which it was cut, in the order in which they are met from the
    first side; None for a sector that is whole.
    """
    with ctx.workprec(min(BITS, int(ctx.prec))):
        hand = orientation((first.points[0], first.points[1], second.points[1]))
        found = _line(disk, first.points) - _line(disk, second.points)
        if cut is None:
            found += _arc(disk, first, second)
        else:
            found += _line(disk, cut[1].points) - _line(disk, cut[0].points)
            found += _arc(disk, first, cut[0]) + _arc(disk, cut[1], second)
        return found if decided(hand > 0, hand < 0) else -found


def _arc(disk: Disk, start: Line, end: Line) -> Any:
    return (disk.rim - 1) * seen(start.points[-1], end.points[-1])


def _line(disk: Disk, points: Sequence[Point]) -> Any:
    return sum(_edge(disk, a, b) for a, b in pairwise(points))


def seen(a: Point, b: Point) -> Any:
    """Angle from a to b as seen from the centre, in (-pi, pi]."""
    return type(a[0]).atan2(a[1] * b[2] - a[2] * b[1], a[1] * b[1] + a[2] * b[2])


def triangle(a: Point, b: Point, cosh: Any) -> Any:
    """Area of the triangle of the centre, a and b, positive where they lie counterclockwise."""
    return 2 * ((a[1] * b[2] - a[2] * b[1]) / (1 + a[0] + b[0] + cosh)).atan()


def _edge(disk: Disk, a: Point, b: Point) -> Any:
    """Area in the disk of the triangle of the centre and an edge.

    In general both ends are moved along the geodesic into the disk or, where it passes by, to the
    point nearest to the centre; t: distances from that point.
    """
    if a[0] < disk.rim and b[0] < disk.rim:
        return triangle(a, b, disk.cosh)
    slope = (b[0] - a[0] * disk.cosh) / disk.sinh
    nearest = (a[0] * a[0] - slope * slope).sqrt()
    t_a = (slope / nearest).asinh()
    length = disk.sinh.asinh()
    reach = 2 * _root(((disk.rim / nearest).max(1) - 1) / 2).asinh()
    low, high = (t.max(-reach).min(reach) for t in (t_a, t_a + length))
    p, q = (_between(disk, a, b, t - t_a, length) for t in (low, high))
    found = triangle(p, q, (high - low).cosh())
    for start, end, moved in ((a, p, a[0] < disk.rim), (q, b, b[0] < disk.rim)):
        if not moved:
            found += (disk.rim - 1) * seen(start, end)
    return found


def _between(disk: Disk, a: Point, b: Point, t: Any, length: Any) -> Point:
    """Point of the geodesic through a and b at the distance t from a towards b."""
    u, v = (length - t).sinh() / disk.sinh, t.sinh() / disk.sinh
    return (u * a[0] + v * b[0], u * a[1] + v * b[1], u * a[2] + v * b[2])


def _root(x: Any) -> Any:
    """Square root of a number of which it is known that it is not negative."""
    if x > 0:
        return x.sqrt()
    upper = x.abs_upper().sqrt()
    return upper.union(-upper)
