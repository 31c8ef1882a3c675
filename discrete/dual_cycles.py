"""Cycles of the dual graph of a complex, and the u- and v-edges that they cross."""

from collections.abc import Iterator

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import MemberError
from discrete.members import require_face

Cycle = tuple[int, ...]


def _neighbours(complex_: AsymptoticComplex) -> list[list[int]]:
    found: list[list[int]] = [[] for _ in range(len(complex_.faces))]
    for one, other in complex_.dual_links.tolist():
        found[one].append(other)
        found[other].append(one)
    return found


def _tree(near: list[list[int]]) -> list[int]:
    """Parent of each face in a breadth-first forest, -1 at its roots."""
    parents = [-2] * len(near)
    for root in range(len(near)):
        if parents[root] != -2:
            continue
        parents[root], queue = -1, [root]
        for face in queue:
            for other in near[face]:
                if parents[other] == -2:
                    parents[other] = face
                    queue.append(other)
    return parents


def fundamental_cycles(complex_: AsymptoticComplex) -> list[Cycle]:
    """One cycle of the dual graph for each link outside a spanning forest, as faces in order.

    Every cycle is a sum modulo 2 of these, so that what is additive modulo 2 is decided on them.
    """
    parents = _tree(_neighbours(complex_))
    cycles = []
    for one, other in complex_.dual_links.tolist():
        if parents[one] == other or parents[other] == one:
            continue
        first, second = [one], [other]
        for path in (first, second):
            while parents[path[-1]] >= 0:
                path.append(parents[path[-1]])
        while len(first) > 1 and len(second) > 1 and first[-2] == second[-2]:
            first.pop()
            second.pop()
        cycles.append(tuple(first + second[-2::-1]))
    return cycles


def simple_cycles(complex_: AsymptoticComplex, *, longest: int) -> Iterator[Cycle]:
    """Every simple cycle of the dual graph of at most that length, once, from its least face."""
    near = _neighbours(complex_)

    def onwards(path: list[int]) -> Iterator[Cycle]:
        for face in near[path[-1]]:
            if face == path[0] and len(path) > 2 and path[1] < path[-1]:
                yield tuple(path)
            elif face > path[0] and face not in path and len(path) < longest:
                yield from onwards([*path, face])

    for start in range(len(near)):
        yield from onwards([start])


def crossings(complex_: AsymptoticComplex, cycle: Cycle) -> tuple[int, int]:
    """Numbers of u-edges and of v-edges that a cycle of faces crosses.

    Raises MemberError where two faces in turn have no common edge.
    """
    crossed = 0
    for face, other in zip(cycle, cycle[1:] + cycle[:1], strict=True):
        across = complex_.neighbour[require_face(complex_, face)] // 4
        common = np.flatnonzero(across == require_face(complex_, other))
        if not len(common):
            raise MemberError(f"faces {face} and {other} have no common edge: this is no cycle")
        crossed += int(common[0]) % 2 == 0
    return crossed, len(cycle) - crossed
