"""Quad-graphs: quadrilaterals with shared vertices, and what makes them an asymptotic complex.

A quad is the cycle of its four vertices; an edge is the unordered pair of its ends. Everything is
exact and finite: whether the whole is a disk, strongly regular, with edges of two families.
"""

from collections import Counter, defaultdict
from collections.abc import Hashable, Iterable, Mapping, Sequence
from itertools import combinations

Vertex = Hashable
Quad = tuple[Vertex, Vertex, Vertex, Vertex]
Edge = frozenset[Vertex]


def sides(quad: Quad) -> tuple[Edge, Edge, Edge, Edge]:
    """Edges of a quad in order, the edge k joining its vertices k and k + 1."""
    a, b, c, d = quad
    return frozenset((a, b)), frozenset((b, c)), frozenset((c, d)), frozenset((d, a))


def edge_counts(quads: Iterable[Quad]) -> Counter[Edge]:
    """Number of quads at each edge."""
    return Counter(edge for quad in quads for edge in sides(quad))


def degrees(quads: Sequence[Quad]) -> Counter[Vertex]:
    """Number of edges at each vertex."""
    return Counter(vertex for edge in edge_counts(quads) for vertex in edge)


def boundary_vertices(quads: Sequence[Quad]) -> set[Vertex]:
    """Return the vertices on edges that belong to one quad only."""
    return {v for edge, count in edge_counts(quads).items() if count == 1 for v in edge}


def interior_degrees(quads: Sequence[Quad]) -> dict[Vertex, int]:
    """Degree of every vertex that is not on the boundary."""
    rim = boundary_vertices(quads)
    return {v: count for v, count in degrees(quads).items() if v not in rim}


def families(quads: Sequence[Quad]) -> dict[Edge, int] | None:
    """Family 0 or 1 of every edge, alternating round each quad, the first edge of quad 0 in 0.

    None where no such labels exist. The quads must be connected by edges.
    """
    at = defaultdict(list)
    for quad in quads:
        for k, edge in enumerate(sides(quad)):
            at[edge].append((quad, k))
    label = {sides(quads[0])[0]: 0}
    todo = list(label)
    while todo:
        edge = todo.pop()
        for quad, k in at[edge]:
            for other, neighbour in enumerate(sides(quad)):
                wanted = label[edge] ^ ((other - k) % 2)
                if neighbour not in label:
                    label[neighbour] = wanted
                    todo.append(neighbour)
                elif label[neighbour] != wanted:
                    return None
    return label


def defects(quads: Sequence[Quad]) -> list[str]:
    """Say what keeps the quads from being a strongly regular disk with two families of edges."""
    found = [f"the corners of {quad} are not distinct" for quad in quads if len(set(quad)) < 4]
    if found:
        return found
    counts = edge_counts(quads)
    found += [f"edge {_named(e)} is in {n} faces" for e, n in counts.items() if n > 2]
    found += [why for pair in combinations(quads, 2) if (why := _overlap(*pair))]
    links = _links(quads)
    found += [f"the faces at {v} form no fan" for v, link in links.items() if not _is_fan(link)]
    euler = len(links) - len(counts) + len(quads)
    if euler != 1 or not _connected(quads):
        found.append(f"Euler characteristic {euler}, 1 for a disk")
    if not found and families(quads) is None:
        found.append("the edges cannot be labelled u and v so that they alternate")
    return found


def _named(edge: Edge) -> str:
    return " - ".join(sorted(str(v) for v in edge))


def _overlap(one: Quad, other: Quad) -> str:
    """Say how two faces meet, if not in nothing, a vertex or one edge."""
    shared = set(one) & set(other)
    common = set(sides(one)) & set(sides(other))
    if len(shared) <= 1 or (len(shared) == 2 and len(common) == 1):
        return ""
    return f"faces {one} and {other} share {len(shared)} vertices and {len(common)} edges"


def _links(quads: Sequence[Quad]) -> Mapping[Vertex, list[Edge]]:
    """For each vertex, the pairs of neighbours that its quads join."""
    links = defaultdict(list)
    for quad in quads:
        for k, vertex in enumerate(quad):
            links[vertex].append(frozenset((quad[k - 1], quad[(k + 1) % 4])))
    return links


def _is_fan(link: Sequence[Edge]) -> bool:
    """Whether the pairs form one path or one cycle."""
    degree = Counter(v for pair in link for v in pair)
    ends = sum(count == 1 for count in degree.values())
    return max(degree.values()) <= 2 and ends in (0, 2) and _joined([set(p) for p in link])


def _connected(quads: Sequence[Quad]) -> bool:
    return _joined([set(quad) for quad in quads])


def _joined(parts: Sequence[set[Vertex]]) -> bool:
    """Whether sets are connected by common members."""
    reached, rest = set(parts[0]), list(parts[1:])
    while touching := [part for part in rest if part & reached]:
        reached.update(*touching)
        rest = [part for part in rest if part not in touching]
    return not rest
