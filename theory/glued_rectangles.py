"""Rectangles in named coordinate domains, glued along edges by attaching maps.

Two rectangles of one domain meet where their coordinates agree; an attaching map identifies an edge
of one domain with an edge of another, end with end. Lengths and coordinates are exact.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from theory.quad_complex import Quad

Point = tuple[Fraction, Fraction]
Place = tuple[str, Point]
Segment = tuple[Place, Place]


@dataclass(frozen=True, kw_only=True)
class Rectangle:
    """Closed rectangle of a domain with the corners low and high, low below high in both."""

    domain: str
    low: Point
    high: Point

    def corners(self) -> tuple[Place, Place, Place, Place]:
        """Corners in cyclic order, from low along u."""
        (a, b), (c, d) = self.low, self.high
        name = self.domain
        return (name, (a, b)), (name, (c, b)), (name, (c, d)), (name, (a, d))

    def contains(self, point: Point) -> bool:
        """Whether the point lies in the closed rectangle."""
        pairs = zip(self.low, point, self.high, strict=True)
        return all(least <= x <= most for least, x, most in pairs)


def edges(rectangles: Iterable[Rectangle]) -> set[frozenset[Place]]:
    """Return the edges of all rectangles as unordered pairs of ends."""
    found = set()
    for rectangle in rectangles:
        a, b, c, d = rectangle.corners()
        found |= {frozenset(pair) for pair in ((a, b), (b, c), (c, d), (d, a))}
    return found


def family(segment: Segment) -> str:
    """Name the coordinate that varies along an edge: u or v; empty if it is no edge."""
    (_, (a, b)), (_, (c, d)) = segment
    return "u" if b == d and a != c else "v" if a == c and b != d else ""


def length(segment: Segment) -> Fraction:
    """Length of an edge."""
    (_, (a, b)), (_, (c, d)) = segment
    return abs(c - a) + abs(d - b)


def attachment_defects(
    rectangles: Sequence[Rectangle], attachments: Mapping[str, tuple[Segment, Segment]]
) -> list[str]:
    """Say why maps are no bijections of whole edges of one family, each edge being used once."""
    known, used, found = edges(rectangles), [], []
    for name, (source, target) in attachments.items():
        for which, segment in (("source", source), ("target", target)):
            if frozenset(segment) not in known:
                found.append(f"{name}: the {which} {shown(segment)} is no edge")
            used.append((frozenset(segment), name))
        if family(source) != family(target):
            found.append(f"{name} takes a {family(source)}-edge to a {family(target)}-edge")
        if length(source) != length(target):
            found.append(f"{name} takes length {length(source)} to {length(target)}")
    for k, (edge, name) in enumerate(used):
        found += [f"{first} and {name} share an edge" for other, first in used[:k] if other == edge]
    return found


def shown(segment: Segment) -> str:
    """Segment as text."""
    (name, (a, b)), (_, (c, d)) = segment
    return f"({a}, {b})-({c}, {d}) of {name}"


def quotient(
    rectangles: Sequence[Rectangle], attachments: Iterable[tuple[Segment, Segment]]
) -> list[Quad]:
    """Quads of the glued complex; a vertex is the least of the places identified with it."""
    parent: dict[Place, Place] = {}

    def root(place: Place) -> Place:
        while (above := parent.get(place, place)) != place:
            place = above
        return place

    for source, target in attachments:
        for a, b in zip(source, target, strict=True):
            low, high = sorted((root(a), root(b)))
            parent[high] = low
    quads: list[Quad] = []
    for rectangle in rectangles:
        a, b, c, d = (root(corner) for corner in rectangle.corners())
        quads.append((a, b, c, d))
    return quads
