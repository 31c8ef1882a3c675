"""Checks of the lemma on asymptotic complexes: checkerboard, even degrees, cycles of the dual."""

from collections.abc import Callable, Iterator
from itertools import combinations, permutations, product

import numpy as np

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed import asymptotic_complexes as printed
from checks.verify.asymptotic_complexes_samples import Samples, samples
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.dual_cycles import Cycle, crossings, fundamental_cycles, simple_cycles
from discrete.signed_graph import signs
from discrete.vertex_fan import vertex_fan

_LONGEST = 8
"""Length up to which every cycle of the dual graph is tried, beside a basis of all."""
_MOST_FACES = 16
_NODES = 5


def _over(found: Samples, objection: Callable[[AsymptoticComplex], str], shown: str) -> Evidence:
    """Evidence from exact arithmetic on each complex; the first objection is the witness."""
    for tried, (name, complex_) in enumerate(found.items(), start=1):
        if witness := objection(complex_):
            return Evidence(
                outcome="fail",
                grade="exact",
                tried=tried,
                met=tried,
                witness=f"{name}: {witness}",
            )
    return Evidence(
        outcome="pass", grade="exact", residual="0", tried=len(found), met=len(found), shown=shown
    )


def checkerboard(
    setting: Setting, *, simply_connected: bool = False, across: str = "edge"
) -> Evidence:
    """Colouring in two colours by the double cover, against the lengths of all dual cycles.

    across: what two faces of different colours have in common, an edge or a vertex.
    """

    def objection(complex_: AsymptoticComplex) -> str:
        odd = [cycle for cycle in fundamental_cycles(complex_) if len(cycle) % 2]
        colours = complex_.checkerboard
        if colours is None:
            around = " ".join(map(str, complex_.odd_dual_cycle or []))
            return f"the faces {around} form a closed ring of odd length" if odd else "no colours"
        pairs = complex_.dual_links if across == "edge" else _touching(complex_)
        same = np.flatnonzero(colours[pairs[:, 0]] == colours[pairs[:, 1]])
        if odd or len(same):
            return f"the faces {pairs[same[0]].tolist()} have one colour" if len(same) else "odd"
        return ""

    return _over(
        samples(setting, simply_connected=simply_connected),
        objection,
        "in a disk the cycles of the dual graph are sums modulo 2 of the links of interior "
        "vertices, which are even: two colours are found by the double cover of the dual graph, "
        "and differ across each edge",
    )


def _touching(complex_: AsymptoticComplex) -> np.ndarray:
    """Pairs of faces with a common vertex."""
    pairs = {
        pair
        for vertex in range(complex_.vertex_count)
        for pair in combinations(np.flatnonzero((complex_.faces == vertex).any(axis=1)).tolist(), 2)
    }
    return np.array(sorted(pairs), dtype=np.int64).reshape(-1, 2)


def even_degree(setting: Setting, *, modulus: int = 2, interior: bool = True) -> Evidence:
    """Degrees of the vertices, counted edge by edge; a corner of a face joins both families."""

    def objection(complex_: AsymptoticComplex) -> str:
        one_of_each = all(
            complex_.edge_is_u[faces[corner]] != complex_.edge_is_u[faces[corner - 1]]
            for faces in complex_.sides.edge_of
            for corner in range(4)
        )
        if not one_of_each:
            return "a corner of a face has two edges of one family"
        for vertex in range(complex_.vertex_count):
            degree = int((complex_.edges == vertex).sum())
            if degree % modulus and not (interior and complex_.is_boundary[vertex]):
                return f"vertex {vertex} has the degree {degree}"
        return ""

    return _over(
        samples(setting, simply_connected=False),
        objection,
        "each corner of a face joins a u- to a v-edge, so the family changes from edge to edge and "
        "a closed round has an even number of them; no simple connectedness is needed",
    )


def edges_alternate(setting: Setting, *, step: int = 1, cyclic: bool = False) -> Evidence:
    """Families of the edges around each vertex, in the order of its fan.

    step: how far apart the edges of different families are; cyclic: whether the first and the last
    edge at a boundary vertex count as neighbours too.
    """

    def objection(complex_: AsymptoticComplex) -> str:
        for vertex in range(complex_.vertex_count):
            fan = vertex_fan(complex_, vertex)
            families = ["u" if complex_.edge_is_u[edge] else "v" for edge in fan.edges]
            if fan.closed or cyclic:
                fine = printed.alternates(families, step=step)
            else:
                fine = all(a != b for a, b in zip(families, families[step:], strict=False))
            if not fine:
                return f"around vertex {vertex} the families are {' '.join(families)}"
        return ""

    return _over(
        samples(setting, simply_connected=False),
        objection,
        "around every vertex u- and v-edges alternate, on the boundary in the order of its fan",
    )


def _cycles(complex_: AsymptoticComplex) -> Iterator[Cycle]:
    if len(complex_.faces) <= _MOST_FACES:
        yield from simple_cycles(complex_, longest=_LONGEST)
    yield from fundamental_cycles(complex_)


def _no_double_cover(complex_: AsymptoticComplex) -> str:
    """Objection of the other route: the double cover of the dual graph does not fall apart."""
    return "" if complex_.checkerboard is not None else "the double cover of the dual is connected"


def dual_cycles_equal(
    setting: Setting, *, modulus: int = 0, simply_connected: bool = False
) -> Evidence:
    """Numbers of u- and v-edges that the cycles of the dual graph cross: equal, or by a modulus."""

    def objection(complex_: AsymptoticComplex) -> str:
        for cycle in _cycles(complex_):
            u, v = crossings(complex_, cycle)
            if (u - v) % modulus if modulus else u != v:
                return f"the faces {' '.join(map(str, cycle))} cross {u} u- and {v} v-edges"
        return _no_double_cover(complex_) if modulus == 2 else ""

    found = samples(setting, simply_connected=simply_connected)
    if modulus == 0:
        # The block of 2 by 3 shows that simple connectedness would not help.
        found = {"block of 2 by 3": found["block of 2 by 3"]} | found
    return _over(
        found,
        objection,
        "on every cycle of a basis of the dual cycles, and so on every cycle, the numbers of u- "
        "and v-edges crossed are of one parity, as the double cover of the dual graph confirms; on "
        "the small complexes every short cycle is tried",
    )


def dual_cycles_even(
    setting: Setting, *, divisor: int = 2, simply_connected: bool = False
) -> Evidence:
    """Lengths of the cycles of the dual graph."""

    def objection(complex_: AsymptoticComplex) -> str:
        for cycle in _cycles(complex_):
            if len(cycle) % divisor:
                return f"the faces {' '.join(map(str, cycle))} form a ring of {len(cycle)}"
        return _no_double_cover(complex_) if divisor == 2 else ""

    return _over(
        samples(setting, simply_connected=simply_connected),
        objection,
        "every cycle of a basis of the cycles of the dual graph is even, and so every cycle is, as "
        "its double cover confirms; on the small complexes every short cycle is tried",
    )


def link(setting: Setting, *, extra: int = 0, interior: bool = True) -> Evidence:
    """Faces around each interior vertex: a cycle of the dual graph, as long as the degree."""

    def objection(complex_: AsymptoticComplex) -> str:
        near = {frozenset(pair) for pair in complex_.dual_links.tolist()}
        for vertex in range(complex_.vertex_count):
            if interior and complex_.is_boundary[vertex]:
                continue
            faces = vertex_fan(complex_, vertex).faces
            round_ = zip(faces, faces[1:] + faces[:1], strict=True)
            simple = len(set(faces)) == len(faces) > 2
            if not (simple and all(frozenset(pair) in near for pair in round_)):
                return f"the faces {faces} at vertex {vertex} are no cycle of the dual graph"
            degree = int((complex_.edges == vertex).sum()) + extra
            if len(faces) != degree:
                return f"vertex {vertex} has {len(faces)} faces around it, not {degree}"
        return ""

    return _over(
        samples(setting, simply_connected=False),
        objection,
        "around every interior vertex the faces are distinct and each shares an edge with the "
        "next; there are as many as edges",
    )


def bipartite(setting: Setting, *, parity: int = 0, longest: int = _NODES) -> Evidence:
    """Every graph on 5 nodes: if all its cycles are even, two colours are found and found right.

    parity: of the lengths that cycles may have; longest: up to which length they are looked at.
    """
    pairs = list(combinations(range(_NODES), 2))
    cycles = _all_cycles(longest)
    met = 0
    for chosen in product((False, True), repeat=len(pairs)):
        links = [pair for pair, taken in zip(pairs, chosen, strict=True) if taken]
        graph = {frozenset(pair) for pair in links}
        if any(len(c) % 2 != parity and c <= graph for c in cycles):
            continue
        met += 1
        if witness := _not_coloured(links):
            return statement(False, shown="", witness=witness)
    return Evidence(
        outcome="pass",
        grade="exact",
        residual="0",
        tried=2 ** len(pairs),
        met=met,
        shown="each of the 1024 graphs on 5 nodes either has an odd cycle or is coloured in two "
        "colours that differ along every link; in general the parity of the distance in a spanning "
        "tree colours, unless a link closes an odd cycle",
    )


def _all_cycles(longest: int) -> set[frozenset[frozenset[int]]]:
    """Every cycle on the nodes, as the set of its links."""
    return {
        frozenset(frozenset(pair) for pair in zip(path, path[1:] + path[:1], strict=True))
        for length in range(3, longest + 1)
        for path in permutations(range(_NODES), length)
    }


def _not_coloured(links: list[tuple[int, int]]) -> str:
    array = np.array(links, dtype=np.int64).reshape(-1, 2)
    colours = signs(_NODES, array, np.ones(len(links), dtype=np.bool_))
    by_hand = any(
        all(trial[a] != trial[b] for a, b in links) for trial in product((0, 1), repeat=_NODES)
    )
    if colours is None or not by_hand:
        return f"the graph with the links {links} has no colouring in two colours"
    if any(colours[a] == colours[b] for a, b in links):
        return f"the colours {colours.tolist()} agree along one of the links {links}"
    return ""
