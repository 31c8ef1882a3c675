"""Linear relations between the angles of all surfaces over a tiling, and what follows from them.

The unknowns are the limits of phi at the corners of each face from within it, and pi. With + at a
corner where the boundary of its face goes on along a u-arc and - where it goes on along a v-arc:

* the area of a face is the alternating sum over its corners (Hazzidakis' formula, either sigma);
* phi changes by as much along a side seen from both its faces: the geodesic curvature is one;
* at an interior point with 2m faces the angles of the faces, phi where + and pi - phi where -, add
  up to 2 pi;
* phi is continuous at reflex corners of the boundary on no curve that leaves a branch point.

Anywhere else it may jump across a line, as it does on curves that leave branch points outside.

A relation that raises the rank of these is not implied by them.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import fmpz_mat

from theory.asymptotic_tiling import Tiling, Vertex

Relation = Mapping[Any, int]
"""Coefficients of the unknowns (face index, position) and of "pi"."""

PI = "pi"


def added(*relations: Relation) -> dict[Any, int]:
    """Sum of relations."""
    total: dict[Any, int] = {}
    for relation in relations:
        for unknown, coefficient in relation.items():
            total[unknown] = total.get(unknown, 0) + coefficient
    return total


def scaled(factor: int, relation: Relation) -> dict[Any, int]:
    """Multiple of a relation."""
    return {unknown: factor * coefficient for unknown, coefficient in relation.items()}


@dataclass(frozen=True, kw_only=True)
class TilingAngles:
    """Linear relations of the surfaces over a tiling.

    matched: whether the two faces at a side agree on its geodesic curvature; continuous: whether
    the last relations are used.
    """

    tiling: Tiling
    matched: bool = True
    continuous: bool = True

    @cached_property
    def corners(self) -> dict[Vertex, list[tuple[int, int]]]:
        """Corners (face index, position) at each vertex."""
        found: dict[Vertex, list[tuple[int, int]]] = {}
        for index, face in enumerate(self.tiling.faces):
            for position, vertex in enumerate(face):
                found.setdefault(vertex, []).append((index, position))
        return found

    @staticmethod
    def sign(corner: tuple[int, int]) -> int:
        """+1 where the boundary of the face goes on along a u-arc, else -1."""
        return 1 if corner[1] % 2 == 0 else -1

    def face_sum(self, index: int) -> dict[Any, int]:
        """Alternating sum over a face, its area."""
        return {(index, position): self.sign((index, position)) for position in range(4)}

    def area(self) -> dict[Any, int]:
        """Area of the whole tiling."""
        return added(*(self.face_sum(index) for index in range(len(self.tiling.faces))))

    def fan_sum(self, vertex: Vertex) -> dict[Any, int]:
        """Alternating sum of the angles round a vertex."""
        return {corner: self.sign(corner) for corner in self.corners[vertex]}

    def vertex_sum(self, vertex: Vertex, choice: str = "middle") -> dict[Any, int]:
        """Term of a corner of the boundary in the sum over the polygon, with its sign.

        choice: of phi where it has several limits, "middle" for that from the middle one of the
        faces at the corner, "first" for that from the face at the outgoing side.
        """
        onwards = self.tiling.rim[vertex]
        around = self._counter_clockwise(vertex, onwards)
        corner = around[len(around) // 2 if choice == "middle" else 0]
        return {corner: self.sign(around[0])}

    def _counter_clockwise(self, vertex: Vertex, onwards: Vertex) -> list[tuple[int, int]]:
        """Corners at a boundary vertex in order, from the outgoing side on."""
        sides, faces = self.tiling.sides, self.tiling.faces
        found: list[tuple[int, int]] = []
        while (vertex, onwards) in sides:
            index = sides[(vertex, onwards)]
            position = faces[index].index(vertex)
            found.append((index, position))
            onwards = faces[index][position - 1]
        return found

    def rim_corners(self) -> list[Vertex]:
        """Vertices of the boundary where it passes from one family to the other."""
        before = {b: a for a, b in self.tiling.rim.items()}
        family = self.tiling.family
        return [
            vertex
            for vertex, onwards in self.tiling.rim.items()
            if family(before[vertex], vertex) != family(vertex, onwards)
        ]

    def rim_sum(self, choice: str = "middle") -> dict[Any, int]:
        """Alternating sum of phi over the vertices of the boundary."""
        return added(*(self.vertex_sum(vertex, choice) for vertex in self.rim_corners()))

    def side_relations(self) -> Iterable[dict[Any, int]]:
        """Equal increments of phi along each inner side from both its faces."""
        faces, sides = self.tiling.faces, self.tiling.sides
        for (a, b), left in sides.items():
            right = sides.get((b, a))
            if right is not None and left < right:
                yield added(
                    {(left, faces[left].index(b)): 1},
                    {(left, faces[left].index(a)): -1},
                    {(right, faces[right].index(b)): -1},
                    {(right, faces[right].index(a)): 1},
                )

    def point_relations(self, *, branched: bool = True) -> Iterable[dict[Any, int]]:
        """Angles round each interior vertex, also the branch points if branched."""
        for vertex in self.tiling.inner:
            order = self.tiling.degrees[vertex] // 2
            if branched or order == 2:
                yield added(self.fan_sum(vertex), {PI: order - 2})

    def continuity_relations(self) -> Iterable[dict[Any, int]]:
        """Equal limits of phi at the reflex corners of the boundary off the branch rays."""
        on_rays = self.tiling.branch_rays() | set(self.tiling.branch_points)
        for vertex in self.tiling.rim:
            if self.continuous and self.tiling.degrees[vertex] > 2 and vertex not in on_rays:
                first, *others = self.corners[vertex]
                for other in others:
                    yield {first: 1, other: -1}

    def relations(self, *, branched: bool = True) -> list[dict[Any, int]]:
        """All relations, those at branch points only if branched."""
        found = [*self.point_relations(branched=branched), *self.continuity_relations()]
        return [*found, *self.side_relations()] if self.matched else found

    def implies(self, relation: Relation, *, branched: bool = True) -> bool:
        """Whether the relation follows: it does not raise the rank of the others."""
        rows = self.relations(branched=branched)
        return self._rank([*rows, relation]) == self._rank(rows)

    def is_consistent(self) -> bool:
        """Whether the relations leave pi alone: contradictory ones would imply anything."""
        return not self.implies({PI: 1})

    def _rank(self, rows: list[Any]) -> int:
        unknowns = [corner for corners in self.corners.values() for corner in corners]
        place = {unknown: n for n, unknown in enumerate([*unknowns, PI])}
        matrix = [[0] * len(place) for _ in rows]
        for row, relation in zip(matrix, rows, strict=True):
            for unknown, coefficient in relation.items():
                row[place[unknown]] = coefficient
        return int(fmpz_mat(matrix).rank())
