"""Gluing of asymptotic complexes along boundary edges of one family; grids of rectangles, stars."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import GluingError
from discrete.members import integers, whole_number
from discrete.signed_graph import IntArray, components

Path = Sequence[int] | IntArray
SideName = Literal["v = 0", "u = n", "v = n", "u = 0"]


@dataclass(frozen=True, kw_only=True)
class Seam:
    """Boundary path of one piece and the path of another that is glued to it, vertex by vertex.

    The order of the vertices is the orientation of the attaching map: reversing one path reverses
    it. first, second: numbers of the pieces.
    """

    first: int
    path: Path
    second: int
    onto: Path


@dataclass(frozen=True, kw_only=True, eq=False)
class Glued:
    """Complex glued from pieces; places: for each piece, the vertices that its own have become."""

    complex: AsymptoticComplex
    places: tuple[IntArray, ...]


def _boundary_families(piece: AsymptoticComplex, path: IntArray, where: str) -> list[bool]:
    """Whether each edge of a path is a u-edge; refuses a path that is not in the boundary."""
    if path.ndim != 1 or len(path) < 2 or path.min() < 0 or path.max() >= piece.vertex_count:
        raise GluingError(f"{where}: the path {path.tolist()} needs two vertices of the piece")
    edges = piece.edge_between(path[:-1], path[1:])
    for at, edge in enumerate(edges):
        ends = (int(path[at]), int(path[at + 1]))
        if edge < 0:
            raise GluingError(f"{where}: no edge joins the vertices {ends}")
        if piece.sides.counts[edge] == 2:
            raise GluingError(f"{where}: edge {ends} is inside; glue along the boundary")
    return [bool(piece.edge_is_u[edge]) for edge in edges]


def _refuse_mismatch(pieces: Sequence[AsymptoticComplex], number: int, seam: Seam) -> None:
    names = f"seam {number}, piece {seam.first}", f"seam {number}, piece {seam.second}"
    for piece in (seam.first, seam.second):
        if not 0 <= whole_number(piece, f"the piece of seam {number}") < len(pieces):
            raise GluingError(f"seam {number}: there is no piece {piece}")
    one = _boundary_families(pieces[seam.first], integers(seam.path, names[0]), names[0])
    other = _boundary_families(pieces[seam.second], integers(seam.onto, names[1]), names[1])
    if len(one) != len(other):
        raise GluingError(f"seam {number}: {len(one)} edges cannot be glued to {len(other)}")
    for at, (is_u, onto_u) in enumerate(zip(one, other, strict=True)):
        if is_u != onto_u:
            raise GluingError(
                f"seam {number}: its edge {at} is a {'u' if is_u else 'v'}-edge of piece "
                f"{seam.first} and not of piece {seam.second}: glue edges of one family"
            )


def _refuse_reuse(seams: Sequence[Seam]) -> None:
    seen: set[tuple[int, int, int]] = set()
    for number, seam in enumerate(seams):
        for piece, path in ((seam.first, seam.path), (seam.second, seam.onto)):
            for one, other in pairwise(path):
                low, high = sorted((int(one), int(other)))
                if (piece, low, high) in seen:
                    raise GluingError(
                        f"seam {number}: edge {(low, high)} of piece {piece} is glued already"
                    )
                seen.add((piece, low, high))


def glued(pieces: Sequence[AsymptoticComplex], seams: Sequence[Seam]) -> Glued:
    """Complex made of the pieces by identifying the vertices along each seam.

    Raises GluingError for seams that do not fit, and the errors of AsymptoticComplex where what
    comes out is none.
    """
    if not pieces:
        raise GluingError("no pieces are given: nothing to glue")
    for number, seam in enumerate(seams):
        _refuse_mismatch(pieces, number, seam)
    _refuse_reuse(seams)
    starts = np.cumsum([0, *(piece.vertex_count for piece in pieces)])
    links = [
        np.stack([starts[s.first] + np.asarray(s.path), starts[s.second] + np.asarray(s.onto)], 1)
        for s in seams
    ]
    none = np.zeros((0, 2), dtype=np.int64)
    _, place = components(int(starts[-1]), np.concatenate([none, *links]))
    faces = [piece.faces + start for piece, start in zip(pieces, starts[:-1], strict=True)]
    return Glued(
        complex=AsymptoticComplex(faces=place[np.concatenate(faces)]),
        places=tuple(np.split(place, starts[1:-1])),
    )


def grid(n_u: int, n_v: int) -> IntArray:
    """Vertices of a grid of n_u by n_v rectangles, by their places: (n_u + 1, n_v + 1)."""
    n_u, n_v = whole_number(n_u, "the number of u-edges"), whole_number(n_v, "that of v-edges")
    if n_u < 1 or n_v < 1:
        raise GluingError(
            f"a grid of {n_u} by {n_v} rectangles is empty: take one or more each way"
        )
    return np.arange((n_u + 1) * (n_v + 1), dtype=np.int64).reshape(n_u + 1, n_v + 1)


def rectangle(n_u: int, n_v: int) -> AsymptoticComplex:
    """Grid of n_u by n_v rectangles, all turned the same way."""
    v = grid(n_u, n_v)
    corners = [v[:-1, :-1], v[1:, :-1], v[1:, 1:], v[:-1, 1:]]
    return AsymptoticComplex(faces=np.stack(corners, axis=-1).reshape(-1, 4))


def side(n_u: int, n_v: int, name: SideName) -> IntArray:
    """Vertices of a side of the grid, as u or v grows; v = 0 and v = n are u-sides.

    Raises GluingError for a name of no side.
    """
    v = grid(n_u, n_v)
    named: dict[SideName, IntArray] = {
        "v = 0": v[:, 0],
        "v = n": v[:, -1],
        "u = 0": v[0],
        "u = n": v[-1],
    }
    if name not in named:
        raise GluingError(f"a grid has no side {name!r}: its sides are {', '.join(named)}")
    return named[name]


def fan(lengths: Sequence[int]) -> tuple[list[AsymptoticComplex], list[Seam], list[IntArray]]:
    """Sectors between rays of these lengths from one point, the seams between them, and the rays.

    Ray i is a u-ray for even i; sector i lies between the rays i and i + 1. The rays returned are
    paths from the point: the first as a path of the first sector, then ray i of sector i - 1.
    Raises GluingError for less than two rays or a ray without edges.
    """
    if len(lengths) < 2:
        raise GluingError(f"{len(lengths)} rays bound no sector: give two or more")
    sectors, rays, starts = [], [], []
    for i, (length, following) in enumerate(pairwise(lengths)):
        n = (length, following) if i % 2 == 0 else (following, length)
        u_ray, v_ray = side(*n, "v = 0"), side(*n, "u = 0")
        sectors.append(rectangle(*n))
        starts.append(u_ray if i % 2 == 0 else v_ray)
        rays.append(v_ray if i % 2 == 0 else u_ray)
    seams = [
        Seam(first=i, path=rays[i], second=i + 1, onto=starts[i + 1])
        for i in range(len(sectors) - 1)
    ]
    return sectors, seams, [starts[0], *rays]


def star(lengths: Sequence[int]) -> AsymptoticComplex:
    """Star of 2m sectors around vertex 0, its rays of these numbers of edges; u-rays are even.

    Raises GluingError unless the number of rays is even and at least 4.
    """
    if len(lengths) < 4 or len(lengths) % 2:
        raise GluingError(f"{len(lengths)} rays: u- and v-rays alternate, at least two of each")
    sectors, seams, rays = fan([*lengths, lengths[0]])
    closing = Seam(first=len(sectors) - 1, path=rays[-1], second=0, onto=rays[0])
    return glued(sectors, [*seams, closing]).complex
