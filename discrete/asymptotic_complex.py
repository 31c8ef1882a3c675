"""Asymptotic complexes: surfaces glued from rectangles along u- and v-edges (def:A-complex)."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from discrete import quad_graph
from discrete.complex_errors import FaceError, LabelError, RegularityError, SurfaceError
from discrete.quad_graph import Sides, sides
from discrete.signed_graph import BoolArray, IntArray, components, odd_cycle, signs


@dataclass(frozen=True, kw_only=True, eq=False)
class AsymptoticComplex:
    """Strongly regular quad-graph with two families of edges that alternate around each face.

    faces: integer array (n, 4) of the corners p, p_u, p_uv, p_v of each face; the vertices are
    0, 1, ... without gaps. Raises FaceError, SurfaceError, LabelError or RegularityError, which
    name the face, edge or vertex at fault.
    """

    faces: IntArray

    def __post_init__(self) -> None:
        try:
            faces = np.array(self.faces)
        except ValueError as error:
            raise FaceError("faces with different numbers of corners: give four each") from error
        if faces.ndim != 2 or faces.shape[1:] != (4,) or not len(faces):
            raise FaceError(f"faces have the shape {faces.shape}: give (n, 4) corners, n > 0")
        if not np.issubdtype(faces.dtype, np.integer):
            raise FaceError(f"corners of type {faces.dtype}: give vertex numbers as integers")
        faces = faces.astype(np.int64)
        faces.setflags(write=False)
        object.__setattr__(self, "faces", faces)
        self._refuse_gaps()
        self._refuse_irregular()

    def _refuse_gaps(self) -> None:
        if self.faces.min() < 0:
            raise FaceError(f"vertex {self.faces.min()} is negative: number them from 0")
        used = np.unique(self.faces)
        gaps = np.flatnonzero(used != np.arange(len(used)))
        if len(gaps):
            raise FaceError(f"vertex {gaps[0]} is in no face: number the vertices without gaps")

    def _refuse_irregular(self) -> None:
        faces = self.faces
        if (face := quad_graph.repeated_corner(faces)) is not None:
            raise FaceError(f"face {face} has a vertex twice: {faces[face].tolist()}")
        if (edge := quad_graph.crowded_edge(self.sides)) is not None:
            raise SurfaceError(f"edge {edge} is in three faces: glue at most two along an edge")
        if (edge := quad_graph.mislabelled_edge(self.sides)) is not None:
            raise LabelError(f"edge {edge} is a u-edge of one face and a v-edge of another")
        if (pair := quad_graph.double_contact(faces)) is not None:
            raise RegularityError(f"faces {pair[0]} and {pair[1]} meet in more than an edge")
        if (vertex := quad_graph.pinched_vertex(self.sides)) is not None:
            raise SurfaceError(f"the faces at vertex {vertex} are not one fan: separate the fans")

    @cached_property
    def sides(self) -> Sides:
        """Sides of the faces and the edges that they are."""
        return sides(self.faces)

    @cached_property
    def vertex_count(self) -> int:
        """Number of vertices."""
        return self.sides.vertices

    @property
    def edges(self) -> IntArray:
        """Ends of each edge: an array (k, 2)."""
        return self.sides.edges

    @cached_property
    def edge_is_u(self) -> BoolArray:
        """Whether each edge is of the u-family."""
        family = np.zeros(len(self.edges), dtype=np.bool_)
        family[self.sides.edge_of[:, ::2].ravel()] = True
        return family

    @cached_property
    def neighbour(self) -> IntArray:
        """Side, numbered 4 face + side, across each side; -1 at the boundary: an array (n, 4)."""
        across = np.full(4 * len(self.faces), -1, dtype=np.int64)
        one, other = self.sides.matched.T
        across[one], across[other] = other, one
        return across.reshape(-1, 4)

    @cached_property
    def dual_links(self) -> IntArray:
        """Pairs of faces with a common edge: an array (k, 2)."""
        return np.asarray(self.sides.matched // 4)

    @cached_property
    def boundary_edges(self) -> IntArray:
        """Ends of the edges in one face only: an array (k, 2)."""
        return np.asarray(self.edges[self.sides.counts == 1])

    @cached_property
    def degree(self) -> IntArray:
        """Number of edges at each vertex."""
        return np.bincount(self.edges.ravel(), minlength=self.vertex_count)

    @cached_property
    def face_count(self) -> IntArray:
        """Number of faces at each vertex: the degree inside, one less on the boundary."""
        return np.bincount(self.faces.ravel(), minlength=self.vertex_count)

    @cached_property
    def is_boundary(self) -> BoolArray:
        """Whether each vertex is on the boundary."""
        flags = np.zeros(self.vertex_count, dtype=np.bool_)
        flags[self.boundary_edges.ravel()] = True
        return flags

    @cached_property
    def is_corner(self) -> BoolArray:
        """Whether each vertex has a u- and a v-edge in the boundary (def:corner)."""
        outer = self.sides.counts == 1
        flags = np.ones(self.vertex_count, dtype=np.bool_)
        for family in (self.edge_is_u, ~self.edge_is_u):
            seen = np.zeros(self.vertex_count, dtype=np.bool_)
            seen[self.edges[outer & family].ravel()] = True
            flags &= seen
        return flags

    @cached_property
    def saddle_order(self) -> IntArray:
        """Order of saddleness m, half the degree, at each interior vertex; 0 on the boundary."""
        return np.where(self.is_boundary, 0, self.degree // 2)

    @cached_property
    def branch_points(self) -> IntArray:
        """Interior vertices with m other than 2."""
        return np.flatnonzero(~self.is_boundary & (self.saddle_order != 2))

    @cached_property
    def euler_characteristic(self) -> int:
        """Vertices minus edges plus faces."""
        return self.vertex_count - len(self.edges) + len(self.faces)

    @cached_property
    def is_connected(self) -> bool:
        """Whether any two faces are joined by faces with common edges."""
        return components(len(self.faces), self.dual_links)[0] == 1

    @cached_property
    def boundary_circles(self) -> int:
        """Number of circles that the boundary consists of."""
        on = np.flatnonzero(self.is_boundary)
        place = np.searchsorted(on, self.boundary_edges)
        return components(len(on), place)[0] if len(on) else 0

    @property
    def is_disk(self) -> bool:
        """Whether it is a closed disk: connected, one boundary circle, Euler characteristic 1."""
        return self.is_connected and self.boundary_circles == 1 and self.euler_characteristic == 1

    @property
    def is_simply_connected(self) -> bool:
        """Whether it is simply connected: a disk or a sphere."""
        closed = self.is_connected and self.boundary_circles == 0
        return self.is_disk or (closed and self.euler_characteristic == 2)

    @cached_property
    def checkerboard(self) -> IntArray | None:
        """Colours +1 and -1 of the faces that differ across every edge, or None."""
        links = self.dual_links
        return signs(len(self.faces), links, np.ones(len(links), dtype=np.bool_))

    @cached_property
    def odd_dual_cycle(self) -> list[int] | None:
        """Faces of an odd cycle of the dual graph: why there is no checkerboard; else None."""
        return odd_cycle(len(self.faces), self.dual_links)

    @cached_property
    def orientation(self) -> IntArray | None:
        """Sign of each face by which (p, p_u, p_uv, p_v) turns as in face 0; None if one-sided."""
        return signs(len(self.faces), self.dual_links, self.sides.same_direction)

    def edge_between(self, one: IntArray, other: IntArray) -> IntArray:
        """Edge that joins each two vertices; -1 where there is none."""
        keys = quad_graph.pair_keys(np.asarray(one), np.asarray(other), self.vertex_count)
        at = np.minimum(np.searchsorted(self.sides.keys, keys), len(self.sides.keys) - 1)
        return np.where(self.sides.keys[at] == keys, at, -1)
