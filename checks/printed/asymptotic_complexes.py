"""Asymptotic complexes of section 3.3 as printed: conditions on cells, attaching maps, counts."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any

import sympy as sp

Face = Sequence[int]
Edge = frozenset[int]


def edges_of(face: Face) -> list[Edge]:
    """Sides of a face as unordered pairs of its corners, in cyclic order."""
    return [frozenset((face[i], face[(i + 1) % len(face)])) for i in range(len(face))]


def is_regular_face(face: Face, *, edges: bool = True, vertices: bool = True) -> bool:
    """Item (i) of strong regularity: edges and vertices of a face are pairwise distinct."""
    sides = edges_of(face)
    return (not edges or len(set(sides)) == len(sides)) and (
        not vertices or len(set(face)) == len(face)
    )


def meet_regularly(one: Face, other: Face, *, most_vertices: int = 1, most_edges: int = 1) -> bool:
    """Item (ii): two faces meet in nothing, in one vertex, or in the closure of one edge."""
    vertices = set(one) & set(other)
    edges = set(edges_of(one)) & set(edges_of(other))
    if not edges:
        return len(vertices) <= most_vertices
    return len(edges) <= most_edges and vertices == set().union(*edges)


def is_surface(faces: Sequence[Face], *, most: int = 2, fans: int = 1) -> bool:
    """Faces of a surface: at most two at an edge, and those at a vertex make one fan."""
    sides = [side for face in faces for side in edges_of(face)]
    if any(sides.count(side) > most for side in sides):
        return False
    return all(
        _fans(faces, vertex) <= fans for vertex in {corner for face in faces for corner in face}
    )


def _fans(faces: Sequence[Face], vertex: int) -> int:
    """Parts into which the faces at a vertex fall when only edges at it join them."""
    parts: list[set[Edge]] = []
    for face in faces:
        sides = {side for side in edges_of(face) if vertex in side}
        if sides:
            touching = [part for part in parts if part & sides]
            parts = [part for part in parts if not part & sides]
            parts.append(sides.union(*touching))
    return len(parts)


def is_quad_graph(
    faces: Sequence[Face],
    *,
    corners: int = 4,
    most: int = 2,
    fans: int = 1,
    regular: bool = True,
) -> bool:
    """Definition of a quad-graph: strongly regular cells of a surface, all quadrilaterals."""
    if any(len(face) != corners for face in faces):
        return False
    cells = all(map(is_regular_face, faces))
    pairs = all(meet_regularly(one, other) for one, other in combinations(faces, 2))
    return is_surface(faces, most=most, fans=fans) and (not regular or (cells and pairs))


def alternates(families: Sequence[Any], *, step: int = 1) -> bool:
    """Whether edges that are neighbours in this cyclic order are of different families."""
    return all(families[i] != families[i - step] for i in range(len(families)))


def is_asymptotic_complex(
    faces: Sequence[Face],
    sizes: Sequence[tuple[Any, Any]],
    *,
    regular: bool = True,
    families: bool = True,
    lengths: bool = True,
) -> bool:
    """Definition (def:A-complex) for faces p, p_u, p_uv, p_v with rectangles of these sizes.

    Sides 0 and 2 of a face are u-edges; each edge has one family and one length in its faces.
    """
    found: dict[Edge, set[tuple[int, Any]]] = {}
    for face, size in zip(faces, sizes, strict=True):
        for side, edge in enumerate(edges_of(face)):
            found.setdefault(edge, set()).add((side % 2, size[side % 2]))
    one_family = all(len({family for family, _ in seen}) == 1 for seen in found.values())
    one_length = all(len({length for _, length in seen}) == 1 for seen in found.values())
    return (
        is_quad_graph(faces, regular=regular)
        and (one_family or not families)
        and (one_length or not lengths)
    )


def attached(
    coordinate: Any, length: Any, *, reversed_: bool = False, sign: int = -1, share: str = "1"
) -> Any:
    """Attaching map along an edge, item (iii): the coordinate u, or u_k - u."""
    return Fraction(share) * length + sign * coordinate if reversed_ else coordinate


def sector_count(order: int, *, per_order: int = 1, offset: int = 0) -> int:
    """Number of angles of sectors at a point of this order of saddleness m_p (line 661)."""
    return per_order * order + offset


def is_branch_point(order: int, *, regular: int = 2) -> bool:
    """Whether a point of this order of saddleness is a branch point (line 616)."""
    return order != regular


def sector_domain(u_0: Any, v_0: Any, *, sides: str = "none") -> Any:
    """Domain of the front r in the definition of a sector: the open rectangle, without its sides.

    sides: which are added, `none`, `u` for the side v = 0 without its ends, or `both` with (0, 0).
    """
    interval = {False: sp.Interval.open, True: sp.Interval.Ropen}
    return sp.ProductSet(
        interval[sides == "both"](0, u_0), interval[sides in ("u", "both")](0, v_0)
    )
