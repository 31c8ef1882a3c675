"""Isomorphisms of complexes: found from the image of one face, by going across the edges."""

from itertools import product

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.signed_graph import IntArray

_SYMMETRIES = ((0, 1, 2, 3), (1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0))
"""Maps of the corners of a rectangle to themselves that keep its u- and v-sides."""


def _extended(
    one: AsymptoticComplex, other: AsymptoticComplex, face: int, turn: tuple[int, ...]
) -> IntArray | None:
    """Vertex map that takes face 0 of one to a face of the other with a symmetry, or None."""
    images = np.full(one.vertex_count, -1, dtype=np.int64)
    image_of, turns, queue = {0: face}, {0: turn}, [0]
    for at in queue:
        corners = other.faces[image_of[at]][list(turns[at])]
        known = images[one.faces[at]]
        if ((known >= 0) & (known != corners)).any():
            return None
        images[one.faces[at]] = corners
        for side in range(4):
            across = int(one.neighbour[at, side])
            # The side's ends go to the ends of a side of the image.
            ends = {turns[at][side], turns[at][(side + 1) % 4]}
            image_side = next(s for s in range(4) if {s, (s + 1) % 4} == ends)
            across_image = int(other.neighbour[image_of[at], image_side])
            if (across < 0) != (across_image < 0):
                return None
            if across < 0 or across // 4 in image_of:
                continue
            ends_image = images[one.faces[at][[side, (side + 1) % 4]]]
            fitting = _fitting(one, other, (at, side), across // 4, across_image // 4, ends_image)
            if fitting is None:
                return None
            image_of[across // 4], turns[across // 4] = across_image // 4, fitting
            queue.append(across // 4)
    whole = len(set(image_of.values())) == len(one.faces) and len(np.unique(images)) == len(images)
    return images if whole else None


def _fitting(
    one: AsymptoticComplex,
    other: AsymptoticComplex,
    entered: tuple[int, int],
    face: int,
    image: int,
    ends_image: IntArray,
) -> tuple[int, ...] | None:
    """Symmetry by which a face goes to its image so that an edge goes where it went already."""
    at, side = entered
    ends = one.faces[at][[side, (side + 1) % 4]]
    places = [int(np.flatnonzero(one.faces[face] == end)[0]) for end in ends]
    for turn in _SYMMETRIES:
        if all(
            other.faces[image][turn[p]] == end for p, end in zip(places, ends_image, strict=True)
        ):
            return turn
    return None


def isomorphism(one: AsymptoticComplex, other: AsymptoticComplex) -> IntArray | None:
    """Image of each vertex under an isomorphism that keeps the two families, or None.

    Both are connected; every image of face 0 is tried, which determines the rest.
    """
    if one.faces.shape != other.faces.shape or one.vertex_count != other.vertex_count:
        return None
    for face, turn in product(range(len(other.faces)), _SYMMETRIES):
        if (images := _extended(one, other, face, turn)) is not None:
            return images
    return None
