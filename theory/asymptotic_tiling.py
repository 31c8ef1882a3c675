"""Disks tiled by asymptotic rectangles with several branch points, as plain combinatorics.

A face is the tuple of its four vertices counter-clockwise, its first side being a u-arc. A star of
blocks is laid out about a centre; inside a block a quadrant may be replaced by an odd number of
smaller blocks, which makes its corner a branch point, and so on.
"""

from collections import Counter
from collections.abc import Sequence, Set
from dataclasses import dataclass
from functools import cached_property
from random import Random
from typing import Any

Vertex = Any
Face = tuple[Vertex, Vertex, Vertex, Vertex]
Side = tuple[Vertex, Vertex]


@dataclass(frozen=True, kw_only=True)
class Tiling:
    """Tiled disk; faces as in the module's docstring."""

    faces: tuple[Face, ...]

    @cached_property
    def sides(self) -> dict[Side, int]:
        """Face to the left of each directed side."""
        return {
            (face[k], face[(k + 1) % 4]): index
            for index, face in enumerate(self.faces)
            for k in range(4)
        }

    @cached_property
    def rim(self) -> dict[Vertex, Vertex]:
        """Next vertex on the boundary, counter-clockwise, of each boundary vertex."""
        return {a: b for a, b in self.sides if (b, a) not in self.sides}

    @cached_property
    def degrees(self) -> Counter[Vertex]:
        """Number of faces at each vertex."""
        return Counter(vertex for face in self.faces for vertex in face)

    @cached_property
    def inner(self) -> list[Vertex]:
        """Interior vertices."""
        return [vertex for vertex in self.degrees if vertex not in self.rim]

    @cached_property
    def branch_points(self) -> dict[Vertex, int]:
        """Orders m of the interior vertices with 2m > 4 faces."""
        orders = {vertex: self.degrees[vertex] // 2 for vertex in self.inner}
        return {vertex: order for vertex, order in orders.items() if order > 2}

    def is_disk(self) -> bool:
        """Whether the boundary is one cycle and Euler's number is 1."""
        start = next(iter(self.rim))
        seen, here = {start}, self.rim[start]
        while here not in seen:
            seen.add(here)
            here = self.rim[here]
        edges = {frozenset(side) for side in self.sides}
        one_cycle = here == start and len(seen) == len(self.rim)
        return one_cycle and len(self.degrees) - len(edges) + len(self.faces) == 1

    def family(self, a: Vertex, b: Vertex) -> str:
        """Family of the directed side from a to b, a face being to its left."""
        return "uv"[self.faces[self.sides[(a, b)]].index(a) % 2]

    def branch_rays(self) -> set[Vertex]:
        """Vertices on the asymptotic curves that leave a branch point, up to their ends."""
        found: set[Vertex] = set()
        for centre in self.branch_points:
            for a, b in self.sides:
                if a == centre:
                    found.update(self._ray(a, b))
        return found

    def _ray(self, before: Vertex, here: Vertex) -> list[Vertex]:
        """Vertices met by going straight on from a side, to the rim or a branch point.

        At a reflex corner of the rim it stops: beyond it the curve is part of the boundary.
        """
        passed = [here]
        while here not in self.rim and self.degrees[here] == 4:
            face = self.faces[self.sides[(here, before)]]
            turned = face[face.index(here) - 1]
            face = self.faces[self.sides[(here, turned)]]
            before, here = here, face[face.index(here) - 1]
            passed.append(here)
        return passed

    def trimmed(self, rng: Random, times: int, *, spare: Set[Vertex] = frozenset()) -> "Tiling":
        """Take away random faces at the rim, one by one, so that a disk is left.

        spare: interior vertices that are to stay in the interior.
        """
        tiling = self
        for _ in range(times):
            loose = [face for face in tiling.faces if tiling._removable(face, spare)]
            if not loose or len(tiling.faces) < 4:
                break
            gone = rng.choice(loose)
            tiling = Tiling(faces=tuple(face for face in tiling.faces if face != gone))
        return tiling

    def _removable(self, face: Face, spare: Set[Vertex]) -> bool:
        """Whether a disk is left without the face: it meets the rim in one path of sides."""
        on_rim = [self.rim.get(face[k]) == face[(k + 1) % 4] for k in range(4)]
        starts = sum(on_rim[k] and not on_rim[k - 1] for k in range(4))
        touched = {face[k] for k in range(4) if on_rim[k]}
        touched |= {face[(k + 1) % 4] for k in range(4) if on_rim[k]}
        others = set(face) - touched
        if starts != 1 or any(vertex in self.rim for vertex in others):
            return False
        return not others & spare

    def refined(self) -> "Tiling":
        """Each face in four."""
        faces: list[Face] = []
        for face in self.faces:
            middles = [frozenset((face[k], face[(k + 1) % 4])) for k in range(4)]
            for k in range(4):
                small = (face[k], middles[k], ("middle", face), middles[k - 1])
                faces.append(_turned(small, k))
        return Tiling(faces=tuple(faces))


def _turned(face: Face, k: int) -> Face:
    """Face whose side 0 is of the family of side k of a parent: begin with a u-arc."""
    return face if k % 2 == 0 else (face[3], face[0], face[1], face[2])


def star(order: int, rng: Random, *, longest: int = 3, depth: int = 2) -> Tiling:
    """Star of 2 order blocks with random lengths, some of their quadrants replaced in turn."""
    faces: list[Face] = []
    rays = [
        ["centre", *((("ray", k), i) for i in range(1, rng.randint(2, longest) + 1))]
        for k in range(2 * order)
    ]
    _fan(("star",), rays, 0, faces, rng, longest, depth)
    return Tiling(faces=tuple(faces))


def _fan(
    name: tuple[Any, ...],
    rays: Sequence[Sequence[Vertex]],
    family: int,
    faces: list[Face],
    rng: Random,
    longest: int,
    depth: int,
    *,
    closed: bool = True,
) -> None:
    """Blocks between neighbouring rays, the first ray being of this family (0 for u)."""
    for k in range(len(rays) - (0 if closed else 1)):
        first, second = rays[k], rays[(k + 1) % len(rays)]
        _block((*name, k), first, second, (family + k) % 2, faces, rng, longest, depth)


def _block(
    name: tuple[Any, ...],
    first: Sequence[Vertex],
    second: Sequence[Vertex],
    family: int,
    faces: list[Face],
    rng: Random,
    longest: int,
    depth: int,
) -> None:
    """Grid on two axes that share their first vertex, a quadrant of it perhaps replaced."""

    def at(i: int, j: int) -> Vertex:
        return first[i] if j == 0 else second[j] if i == 0 else (name, i, j)

    width, height = len(first) - 1, len(second) - 1
    cut = depth > 0 and width > 1 and height > 1 and rng.random() < 0.6
    p, q = (rng.randint(1, width - 1), rng.randint(1, height - 1)) if cut else (width, height)
    for i in range(width):
        for j in range(height):
            if not (cut and i >= p and j >= q):
                face = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1))
                faces.append(_turned(face, family))
    if cut:
        rays = [[at(i, q) for i in range(p, width + 1)]]
        for ray in range(rng.choice((2, 2, 4, 6, 8))):
            count = rng.randint(1, longest)
            rays.append([at(p, q), *(((*name, "ray", ray), i) for i in range(1, count + 1))])
        rays.append([at(p, j) for j in range(q, height + 1)])
        inner = (*name, "cut")
        _fan(inner, rays, family, faces, rng, longest, depth - 1, closed=False)
