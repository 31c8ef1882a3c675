"""Hamburger polygons: simple closed paths of u- and v-edges, whose arcs alternate, in a disk."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import MemberError, PolygonError
from discrete.members import integers, require_faces
from discrete.signed_graph import BoolArray, IntArray, components


@dataclass(frozen=True, kw_only=True, eq=False)
class HamburgerPolygon:
    """Simple closed path of edges of a disk, made of u- and v-arcs that alternate at its corners.

    path: its vertices in cyclic order. A vertex at which the family changes is a corner, inside it
    are an odd number q of quads; elsewhere q = 2, for the arc is one asymptotic curve. Raises
    PolygonError for any other path, naming the vertex or edge at fault.
    """

    complex: AsymptoticComplex
    path: IntArray

    def __post_init__(self) -> None:
        try:
            path = integers(self.path, "the vertices of the path")
        except MemberError as error:
            raise PolygonError(str(error)) from error
        if path.ndim != 1 or len(path) < 4:
            raise PolygonError(f"a path of the shape {path.shape}: give four vertices or more")
        path.setflags(write=False)
        object.__setattr__(self, "path", path)
        if not self.complex.is_disk:
            raise PolygonError("the complex is no disk: a closed path need not bound a domain")
        self._refuse_no_path()
        self._refuse_no_arcs()

    def _refuse_no_path(self) -> None:
        absent = self.path[(self.path < 0) | (self.path >= self.complex.vertex_count)]
        if len(absent):
            raise PolygonError(f"vertex {absent[0]} of the path is not in the complex")
        found, counts = np.unique(self.path, return_counts=True)
        if (counts > 1).any():
            raise PolygonError(f"the path meets vertex {found[np.argmax(counts > 1)]} twice")
        if (self.edges < 0).any():
            at = int(np.argmax(self.edges < 0))
            ends = int(self.path[at]), int(self.path[(at + 1) % len(self.path)])
            raise PolygonError(f"no edge joins the vertices {ends} of the path")

    def _refuse_no_arcs(self) -> None:
        q = self.quads[self.path]
        wrong = np.flatnonzero(~self.is_corner & (q != 2))
        if len(wrong):
            at = wrong[0]
            family = "u" if self.complex.edge_is_u[self.edges[at]] else "v"
            raise PolygonError(
                f"at vertex {self.path[at]} a {family}-arc meets a {family}-arc at an angle, with "
                f"{q[at]} quads inside: arcs of the two families must alternate"
            )

    @cached_property
    def edges(self) -> IntArray:
        """Edge from each vertex of the path to the next."""
        return self.complex.edge_between(self.path, np.roll(self.path, -1))

    @cached_property
    def is_corner(self) -> BoolArray:
        """Whether the family of edges changes at each vertex of the path."""
        family = self.complex.edge_is_u[self.edges]
        return np.asarray(family != np.roll(family, 1))

    @cached_property
    def corners(self) -> IntArray:
        """Vertices of the path at which the family of edges changes."""
        return np.asarray(self.path[self.is_corner])

    @cached_property
    def is_counterclockwise(self) -> bool:
        """Whether the path turns as (p, p_u, p_uv, p_v) in face 0, with the inside on its left."""
        face, side = (int(n[0]) for n in np.nonzero(self._inner_sides == self.edges[0]))
        along = self.complex.faces[face, side] == self.path[0]
        signs = self.complex.orientation
        return signs is not None and bool((signs[face] > 0) == along)

    @cached_property
    def _inner_sides(self) -> IntArray:
        """Edge that each side of an enclosed face is, -1 for the other faces."""
        return np.where(self.inside[:, np.newaxis], self.complex.sides.edge_of, -1)

    @cached_property
    def corner_signs(self) -> IntArray:
        """Sign of each corner, + where a u-arc begins counterclockwise (eq:sg-hamburger)."""
        begins = self.complex.edge_is_u[self.edges[self.is_corner]]
        return np.where(begins == self.is_counterclockwise, 1, -1)

    @cached_property
    def inside(self) -> BoolArray:
        """Whether each face is enclosed."""
        on_path = np.zeros(len(self.complex.edges), dtype=np.bool_)
        on_path[self.edges] = True
        edge_of = self.complex.sides.edge_of.ravel()
        sides, outer = self.complex.sides.matched, len(self.complex.faces)
        links = sides[~on_path[edge_of[sides[:, 0]]]] // 4
        free = (self.complex.neighbour.ravel() < 0) & ~on_path[edge_of]
        rim = np.flatnonzero(free) // 4
        to_outside = np.stack([rim, np.full(len(rim), outer)], axis=1)
        _, part = components(outer + 1, np.concatenate([links, to_outside]))
        return np.asarray(part[:outer] != part[outer])

    @cached_property
    def quads(self) -> IntArray:
        """Number q of enclosed faces at each vertex of the complex."""
        corners = self.complex.faces[self.inside].ravel()
        return np.bincount(corners, minlength=self.complex.vertex_count)

    @cached_property
    def enclosed_vertices(self) -> IntArray:
        """Vertices inside the polygon, not on it."""
        seen = self.quads > 0
        seen[self.path] = False
        return np.flatnonzero(seen)

    @cached_property
    def enclosed_branch_points(self) -> IntArray:
        """Branch points inside the polygon, not on it."""
        order = self.complex.saddle_order[self.enclosed_vertices]
        return np.asarray(self.enclosed_vertices[order != 2])


def polygon_around(complex_: AsymptoticComplex, inside: BoolArray) -> HamburgerPolygon:
    """Hamburger polygon that bounds the union of the chosen faces.

    inside: whether each face is chosen. Raises FaceError for another array, PolygonError if their
    boundary is not one simple closed path, or no such polygon.
    """
    inside = require_faces(complex_, inside)
    edge_of = complex_.sides.edge_of[inside].ravel()
    counts = np.bincount(edge_of, minlength=len(complex_.edges))
    following: dict[int, list[int]] = {}
    for one, other in complex_.edges[counts == 1]:
        following.setdefault(int(one), []).append(int(other))
        following.setdefault(int(other), []).append(int(one))
    if not following:
        raise PolygonError("no faces are chosen, or their union has no boundary")
    if forks := [v for v, ends in following.items() if len(ends) != 2]:
        raise PolygonError(f"the boundary of the faces meets itself at vertex {min(forks)}")
    path = [min(following), following[min(following)][0]]
    while (step := next(v for v in following[path[-1]] if v != path[-2])) != path[0]:
        path.append(step)
    if len(path) != len(following):
        lost = min(following.keys() - set(path))
        raise PolygonError(
            f"the boundary of the faces is not one path: vertex {lost} is on another"
        )
    return HamburgerPolygon(complex=complex_, path=np.array(path, dtype=np.int64))
