"""Complexes for the checks of section 4: unlabelled faces, ribbons, faces divided into grids."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_surgery import attached
from discrete.gluing import rectangle, star
from discrete.signed_graph import BoolArray, IntArray, components, signs

Corner = tuple[int, int]


def corpus() -> dict[str, AsymptoticComplex]:
    """Disks: a rectangle, stars of orders 2, 3 and 5, and the results of surgery."""
    return {
        "rectangle": rectangle(3, 2),
        "star of order 2": star([3, 2, 4, 1]),
        "monkey star": star([2] * 6),
        "star of order 5": star([2, 1] * 5),
        "closed corner": attached(rectangle(3, 2), 0, [2, 1])[0],
        "closed corner of a star": attached(
            star([2] * 6), int(np.flatnonzero(star([2] * 6).is_corner)[0]), [1, 2]
        )[0],
    }


def ring(length: int) -> IntArray:
    """Faces of a ring of quads, u-edges around it: (length, 4) corners p, p_u, p_uv, p_v."""
    lower = np.arange(length)
    after = np.roll(lower, -1)
    return np.stack([lower, after, after + length, lower + length], axis=1)


def odd_star(sectors: int) -> IntArray:
    """Faces of a star of quads around vertex 0, one quad to a sector, for any number of sectors."""
    around = np.arange(sectors)
    ray, tip = 1 + around, 1 + sectors + around
    return np.stack([0 * ray, ray, tip, np.roll(ray, -1)], axis=1)


def face_links(faces: IntArray) -> tuple[IntArray, BoolArray]:
    """Pairs of faces with a common edge, and whether the edge has sides of like parity in both."""
    seen: dict[Corner, list[tuple[int, int]]] = {}
    for face, corners in enumerate(faces.tolist()):
        for side in range(4):
            low, high = sorted((corners[side], corners[(side + 1) % 4]))
            seen.setdefault((low, high), []).append((face, side))
    pairs = [tuple(found) for found in seen.values() if len(found) == 2]
    links = np.array([(a[0], b[0]) for a, b in pairs], dtype=np.int64).reshape(-1, 2)
    alike = np.array([(a[1] - b[1]) % 2 == 0 for a, b in pairs], dtype=np.bool_)
    return links, alike


def colourings(faces: IntArray) -> int:
    """Number of colourings of the faces with two colours that differ across every edge."""
    links, _ = face_links(faces)
    found = signs(len(faces), links, np.ones(len(links), dtype=np.bool_))
    return 0 if found is None else 2 ** components(len(faces), links)[0]


def labellings(faces: IntArray) -> int:
    """Number of divisions of the edges into two families that alternate around every face.

    A face is known by the family of its side 0; across an edge with sides of like parity the next
    face has the same one.
    """
    links, alike = face_links(faces)
    found = signs(len(faces), links, ~alike)
    return 0 if found is None else 2 ** components(len(faces), links)[0]


def ribbons(complex_: AsymptoticComplex) -> IntArray:
    """Ribbon of each edge: edges that are opposite in some face have one ribbon."""
    opposite = np.concatenate(
        [complex_.sides.edge_of[:, [0, 2]], complex_.sides.edge_of[:, [1, 3]]]
    )
    return components(len(complex_.edges), opposite)[1]


def divided(
    complex_: AsymptoticComplex, counts: Sequence[int], *, nodes: Any
) -> tuple[IntArray, int]:
    """Faces of the quads of a complex each of whose faces has become a grid, and their vertices.

    counts: number of parts of each edge, alike on opposite edges; nodes: function of two counts
    that gives the set of grid nodes of a face, which must not be all of them. Quads that lack a
    node are left out. The order in a face is p, p_u, p_uv, p_v.
    """
    numbers: dict[Any, int] = {}
    faces = []
    for face, corners in enumerate(complex_.faces.tolist()):
        n, m = (counts[complex_.sides.edge_of[face, side]] for side in (0, 1))
        known = nodes(n, m)
        for i in range(n):
            for j in range(m):
                around = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                if set(around) <= known:
                    keys = [_node(corners, face, n, m, at) for at in around]
                    faces.append([numbers.setdefault(key, len(numbers)) for key in keys])
    return np.array(faces, dtype=np.int64).reshape(-1, 4), len(numbers)


def _node(corners: Sequence[int], face: int, n: int, m: int, at: Corner) -> Any:
    """What a node of a face's grid is in the complex: a corner, a place on an edge, or its own."""
    i, j = at
    ends: Mapping[Corner, int] = {
        (0, 0): corners[0], (n, 0): corners[1], (n, m): corners[2], (0, m): corners[3]
    }  # fmt: skip
    if at in ends:
        return ("vertex", ends[at])
    sides = ((j == 0, 0, 1, i, n), (j == m, 3, 2, i, n), (i == 0, 0, 3, j, m), (i == n, 1, 2, j, m))
    for on, start, end, place, total in sides:
        if on:
            one, other = corners[start], corners[end]
            return ("edge", *((one, other, place) if one < other else (other, one, total - place)))
    return ("face", face, i, j)
