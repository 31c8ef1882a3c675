"""Hyperbolic Chebyshev nets as defined in section 4.1 (lines 1195-1196)."""

from collections.abc import Mapping, Sequence
from typing import Any

from checks.printed.poincare_disk import Pair, closed

Edge = frozenset[Any]


def _alternate(face: Sequence[Any], marks: Mapping[Edge, str]) -> bool:
    """Whether the edges of a face are marked u, v, u, v."""
    around = [marks[frozenset((a, b))] for a, b in zip(face, [*face[1:], face[0]], strict=True)]
    return set(around) == {"u", "v"} and all(
        a != b for a, b in zip(around, [*around[1:], around[0]], strict=True)
    )


def is_chebyshev_net(
    places: Mapping[Any, Pair],
    faces: Sequence[Sequence[Any]],
    marks: Mapping[Edge, str],
    field: Any,
    *,
    alternating: bool = True,
    rule: bool = True,
) -> bool:
    """Whether vertices with their places in the disk, faces and marks of edges are such a net.

    A face lists its vertices in order. Each has four, two u- and two v-edges that alternate, and
    the vertices 0, 2 and 1, 3 are opposite in (poincare-ddg).
    """
    if any(len(face) != 4 for face in faces):
        return False
    if alternating and not all(_alternate(face, marks) for face in faces):
        return False
    if not rule:
        return True
    return all(
        closed(places[face[0]], places[face[1]], places[face[3]], field) == places[face[2]]
        for face in faces
    )
