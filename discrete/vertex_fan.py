"""The faces around a vertex of a complex in order, and the edges between them."""

from dataclasses import dataclass

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.members import require_vertex


@dataclass(frozen=True, kw_only=True)
class Fan:
    """Faces at a vertex in order, and the edges at it in order.

    Inside, edge k lies between face k and the next one, cyclically; on the boundary there is one
    edge more than faces, and edges k and k + 1 belong to face k.
    """

    faces: tuple[int, ...]
    edges: tuple[int, ...]
    closed: bool


def _other_side(complex_: AsymptoticComplex, face: int, vertex: int, side: int) -> int:
    """The other of the two sides of a face at one of its corners."""
    corner = int(np.flatnonzero(complex_.faces[face] == vertex)[0])
    return corner if side == (corner - 1) % 4 else (corner - 1) % 4


def vertex_fan(complex_: AsymptoticComplex, vertex: int) -> Fan:
    """Faces and edges around a vertex, in order; from one boundary edge to the other if it has.

    Raises MemberError for a number that is no vertex.
    """
    at, corner = np.nonzero(complex_.faces == require_vertex(complex_, vertex))
    ends = [
        (int(face), int(side) % 4)
        for face, c in zip(at, corner, strict=True)
        for side in (c, c - 1)
        if complex_.neighbour[face, side % 4] < 0
    ]
    closed = not ends
    face, entry = (int(at[0]), int(corner[0])) if closed else ends[0]
    edge_of = complex_.sides.edge_of
    faces, edges = [face], [] if closed else [int(edge_of[face, entry])]
    while True:
        leave = _other_side(complex_, faces[-1], vertex, entry)
        edges.append(int(edge_of[faces[-1], leave]))
        across = int(complex_.neighbour[faces[-1], leave])
        if across < 0 or across // 4 == faces[0]:
            return Fan(faces=tuple(faces), edges=tuple(edges), closed=closed)
        faces.append(across // 4)
        entry = across % 4
