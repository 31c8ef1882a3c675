"""Surgery on complexes: cut out the quadrant of a vertex, put an odd number of sectors in."""

from collections.abc import Sequence

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import SurgeryError
from discrete.gluing import Seam, fan, glued
from discrete.members import require_face, require_faces, require_vertex
from discrete.signed_graph import BoolArray, IntArray


def restricted(complex_: AsymptoticComplex, keep: BoolArray) -> tuple[AsymptoticComplex, IntArray]:
    """Complex of the faces that are kept, and the new number of each vertex (-1 if it is lost).

    keep: whether each face is kept. Raises FaceError for another array, and the errors of
    AsymptoticComplex where what is left is none.
    """
    keep = require_faces(complex_, keep)
    used = np.flatnonzero(np.bincount(complex_.faces[keep].ravel()))
    place = np.full(complex_.vertex_count, -1, dtype=np.int64)
    place[used] = np.arange(len(used))
    return AsymptoticComplex(faces=place[complex_.faces[keep]]), place


def boundary_segment(complex_: AsymptoticComplex, corner: int, *, along_u: bool) -> IntArray:
    """Vertices of the maximal boundary segment of one family that starts at a corner vertex.

    Raises SurgeryError if the vertex is no corner, MemberError if it is no vertex.
    """
    if not complex_.is_corner[require_vertex(complex_, corner)]:
        raise SurgeryError(f"vertex {corner} is no corner: its boundary edges are of one family")
    outer = complex_.sides.counts == 1
    edges = complex_.edges[outer & (complex_.edge_is_u == along_u)]
    path, before = [corner], -1
    while True:
        at = edges[(edges == path[-1]).any(axis=1)]
        onwards = [int(v) for v in at.ravel() if v != path[-1] and v != before]
        if not onwards or onwards[0] == corner:
            return np.array(path, dtype=np.int64)
        before = path[-1]
        path.append(onwards[0])


def attached(
    complex_: AsymptoticComplex, corner: int, lengths: Sequence[int]
) -> tuple[AsymptoticComplex, IntArray]:
    """Complex with sectors put in at a corner vertex, and the new number of each old vertex.

    lengths: numbers of edges of the new rays, an even number 2k, between which and the two maximal
    boundary segments of the corner lie 2k + 1 new sectors. Raises SurgeryError.
    """
    if len(lengths) % 2:
        raise SurgeryError(f"{len(lengths)} new rays at vertex {corner}: an even number is needed")
    along_u, along_v = (boundary_segment(complex_, corner, along_u=u) for u in (True, False))
    sectors, seams, rays = fan([len(along_u) - 1, *lengths, len(along_v) - 1])
    last = len(sectors)
    outer = [
        Seam(first=last, path=along_u, second=0, onto=rays[0]),
        Seam(first=last, path=along_v, second=last - 1, onto=rays[-1]),
    ]
    found = glued([*sectors, complex_], [*seams, *outer])
    return found.complex, found.places[-1]


def _along_ray(complex_: AsymptoticComplex, face: int, corner: int) -> tuple[list[int], list[int]]:
    """Faces along the u-line that leaves a corner of a face, and their sides on that line."""
    faces, sides, seen = [], [], set()
    while face not in seen:
        seen.add(face)
        u_side, v_side = sorted((corner, (corner - 1) % 4), key=lambda s: s % 2)
        faces.append(face)
        sides.append(u_side)
        # The u-side leads from this corner to the next vertex of the line.
        onwards = (u_side + 1) % 4 if u_side == corner else u_side
        vertex = complex_.faces[face, onwards]
        across = int(complex_.neighbour[face, (v_side + 2) % 4])
        if across < 0:
            return faces, sides
        face = across // 4
        corner = int(np.flatnonzero(complex_.faces[face] == vertex)[0])
    raise SurgeryError(f"the row of faces from face {faces[0]} closes up: it is no quadrant")


def _is_row(complex_: AsymptoticComplex, row: IntArray) -> bool:
    """Whether faces are neighbours across v-edges, one after the other, up to the boundary."""
    across = complex_.neighbour[row][:, 1::2] // 4
    ends = bool((across[-1] < 0).any())
    return ends and bool((across[:-1] == row[1:, np.newaxis]).any(axis=1).all())


def _rows(complex_: AsymptoticComplex, face: int, corner: int) -> list[IntArray] | None:
    """Rows of faces that lie on each other, the first on a u-line; None if they are no grid."""
    first, sides = _along_ray(complex_, face, corner)
    rows: list[IntArray] = []
    row, entries = np.array(first), np.array(sides)
    while len(rows) < len(complex_.faces):
        rows.append(row)
        across = complex_.neighbour[row, (entries + 2) % 4]
        if not _is_row(complex_, row):
            return None
        if (across < 0).all():
            return rows
        if (across < 0).any():
            return None
        row, entries = across // 4, across % 4
    return None


def quadrant(complex_: AsymptoticComplex, vertex: int, face: int) -> IntArray:
    """Faces of the quadrant that a face begins at a vertex: the grid between its two rays.

    The rays are the u- and the v-line from the vertex along that face, up to the boundary; rows of
    the array run along u. Raises SurgeryError if the faces between them are no grid.
    """
    corners = np.flatnonzero(complex_.faces[require_face(complex_, face)] == vertex)
    if not len(corners):
        raise SurgeryError(f"face {face} does not meet vertex {vertex}")
    rows = _rows(complex_, face, int(corners[0]))
    if rows is None or np.bincount(np.concatenate(rows)).max() > 1:
        raise SurgeryError(
            f"the quadrant of vertex {vertex} at face {face} is no grid of rectangles: a branch "
            "point or a step of the boundary is in it"
        )
    return np.array(rows, dtype=np.int64)


def surgery(
    complex_: AsymptoticComplex, vertex: int, face: int, lengths: Sequence[int]
) -> tuple[AsymptoticComplex, int]:
    """Complex with the quadrant of a vertex at a face replaced by sectors, and the vertex in it.

    lengths: edges of the 2k new rays; the order of saddleness of the vertex grows by k. Raises
    SurgeryError for a vertex on the boundary or a quadrant that is no grid, and the errors of
    AsymptoticComplex where what is left is none.
    """
    if complex_.is_boundary[require_vertex(complex_, vertex)]:
        raise SurgeryError(f"vertex {vertex} is on the boundary: attach sectors there instead")
    keep = np.ones(len(complex_.faces), dtype=np.bool_)
    keep[quadrant(complex_, vertex, face)] = False
    rest, place = restricted(complex_, keep)
    result, places = attached(rest, int(place[vertex]), lengths)
    if complex_.is_disk and not result.is_disk:
        raise SurgeryError(f"without the quadrant of vertex {vertex} the rest falls apart")
    return result, int(places[place[vertex]])
