"""Quad-graphs as arrays: sides, edges and links of faces, and what keeps faces from being one.

Faces are an integer array (n, 4): face k has the corners p, p_u, p_uv, p_v in this order. Its sides
0 (p to p_u) and 2 are u-edges, its sides 1 (p_u to p_uv) and 3 are v-edges; an edge is known by its
two ends, as strong regularity allows. A witness is None where there is nothing to object to.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from discrete.signed_graph import BoolArray, IntArray, components

_PAIRS = ((0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (1, 3))
"""Pairs of corners of a face: its four sides, then its two diagonals."""


def pair_keys(one: IntArray, other: IntArray, vertices: int) -> IntArray:
    """Number that stands for the unordered pair of two vertices."""
    low, high = np.minimum(one, other), np.maximum(one, other)
    return np.asarray(low * vertices + high, dtype=np.int64)


@dataclass(frozen=True, kw_only=True, eq=False)
class Sides:
    """The sides of the faces and the edges that they are.

    faces: array (n, 4); edges: array (k, 2) of ends, sorted; edge_of: array (n, 4), the edge that
    each side is; counts: number of sides that are each edge.
    """

    faces: IntArray
    vertices: int
    keys: IntArray
    edge_of: IntArray
    counts: IntArray

    @cached_property
    def edges(self) -> IntArray:
        """Ends of each edge, the lower vertex first."""
        return np.stack([self.keys // self.vertices, self.keys % self.vertices], axis=1)

    @cached_property
    def matched(self) -> IntArray:
        """Pairs of sides, numbered 4 face + side, that are the same edge: an array (k, 2)."""
        flat = self.edge_of.ravel()
        order = np.argsort(flat, kind="stable")
        same = np.flatnonzero(flat[order][1:] == flat[order][:-1])
        return np.stack([order[same], order[same + 1]], axis=1)

    @cached_property
    def same_direction(self) -> BoolArray:
        """Whether the two sides of each matched pair run along their edge the same way."""
        starts = self.faces.ravel()[self.matched]
        return np.asarray(starts[:, 0] == starts[:, 1])


def sides(faces: IntArray) -> Sides:
    """Sides and edges of the faces."""
    vertices = int(faces.max()) + 1
    keys = pair_keys(faces, np.roll(faces, -1, axis=1), vertices)
    found, edge_of, counts = np.unique(keys.ravel(), return_inverse=True, return_counts=True)
    return Sides(
        faces=faces,
        vertices=vertices,
        keys=found,
        edge_of=edge_of.reshape(-1, 4).astype(np.int64),
        counts=counts.astype(np.int64),
    )


def _first(found: BoolArray) -> int | None:
    return int(np.argmax(found)) if found.any() else None


def repeated_corner(faces: IntArray) -> int | None:
    """First face two of whose corners are the same vertex: condition (i) of strong regularity."""
    repeats = np.zeros(len(faces), dtype=np.bool_)
    for one, other in _PAIRS:
        repeats |= faces[:, one] == faces[:, other]
    return _first(repeats)


def crowded_edge(found: Sides) -> tuple[int, int] | None:
    """Ends of the first edge that is a side of three faces or more."""
    at = _first(found.counts > 2)
    return None if at is None else _ends(found, at)


def _ends(found: Sides, edge: int) -> tuple[int, int]:
    return int(found.edges[edge, 0]), int(found.edges[edge, 1])


def mislabelled_edge(found: Sides) -> tuple[int, int] | None:
    """Ends of the first edge that is a u-edge of one face and a v-edge of another."""
    family = np.bincount(found.edge_of[:, ::2].ravel(), minlength=len(found.keys))
    at = _first((family > 0) & (family < found.counts))
    return None if at is None else _ends(found, at)


def double_contact(faces: IntArray) -> tuple[int, int] | None:
    """First two faces that meet in more than one vertex or edge: condition (ii) fails.

    Two faces with two common vertices that are opposite in one of them have no common edge there.
    """
    vertices = int(faces.max()) + 1
    pairs = [pair_keys(faces[:, i], faces[:, j], vertices) for i, j in _PAIRS]
    keys, diagonal = (
        np.concatenate(pairs),
        np.repeat([False, True], [4 * len(faces), 2 * len(faces)]),
    )
    order = np.argsort(keys, kind="stable")
    same = keys[order][1:] == keys[order][:-1]
    # Sides come before diagonals: in each group of equal pairs a diagonal is last.
    at = _first(same & diagonal[order][1:])
    if at is None:
        return None
    one, other = sorted(int(order[at + n]) % len(faces) for n in (0, 1))
    return one, other


def corner_links(found: Sides) -> IntArray:
    """Pairs of corners, numbered 4 face + corner, of two faces that share an edge at a vertex."""
    side = found.matched
    start, end = side, side - side % 4 + (side + 1) % 4
    along = found.same_direction
    first = np.stack([start[:, 0], np.where(along, start[:, 1], end[:, 1])], axis=1)
    second = np.stack([end[:, 0], np.where(along, end[:, 1], start[:, 1])], axis=1)
    return np.concatenate([first, second])


def pinched_vertex(found: Sides) -> int | None:
    """First vertex whose faces are not one fan: removing it separates its neighbourhood."""
    corners = found.faces.ravel()
    fans, fan_of = components(len(corners), corner_links(found))
    if fans == found.vertices:
        return None
    vertex_of_fan = np.zeros(fans, dtype=np.int64)
    vertex_of_fan[fan_of] = corners
    return _first(np.bincount(vertex_of_fan, minlength=found.vertices) > 1)
