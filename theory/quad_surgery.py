"""Surgery on a quad-graph: a sector at a vertex gives way to a fan of new sectors.

A sector is a rectangular array of quads with the vertex at its corner, up to the boundary of the
complex on both far sides. New sector k lies between the new rays k and k + 1; the first and the
last of them are the two rays that bounded the old sector.
"""

from collections import defaultdict
from collections.abc import Sequence

from theory.errors import DomainError
from theory.quad_complex import Edge, Quad, Vertex, sides

Grid = list[list[Vertex]]


def square_grid(columns: int, rows: int) -> list[Quad]:
    """Quads of a grid of squares with the vertices (i, j), 0 <= i <= columns, 0 <= j <= rows."""
    return _quads([[(i, j) for j in range(rows + 1)] for i in range(columns + 1)])


def _quads(grid: Grid) -> list[Quad]:
    """Quads between neighbouring columns and rows of a grid of vertices."""
    return [
        (grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1])
        for i in range(len(grid) - 1)
        for j in range(len(grid[0]) - 1)
    ]


def _across(at: dict[Edge, list[Quad]], quad: Quad, edge: Edge) -> Quad | None:
    """Return the other quad at this edge of a quad, if there is one."""
    return next((other for other in at[edge] if other != quad), None)


def _opposite(quad: Quad, edge: Edge) -> tuple[Vertex, Vertex]:
    """Return the other ends of the edges of a quad that leave the two ends of an edge."""
    k = sides(quad).index(edge)
    first, second = quad[(k + 3) % 4], quad[(k + 2) % 4]
    return first, second


def _strip(at: dict[Edge, list[Quad]], quad: Quad, low: Vertex, high: Vertex) -> Grid:
    """Columns of two vertices of the strip that starts at the edge low - high with this quad."""
    columns = [[low, high]]
    here: Quad | None = quad
    while here is not None:
        edge = frozenset((low, high))
        first, second = _opposite(here, edge)
        low, high = (first, second) if here[sides(here).index(edge)] == low else (second, first)
        columns.append([low, high])
        here = _across(at, here, frozenset((low, high)))
    return columns


def sector_grid(quads: Sequence[Quad], quad: Quad, vertex: Vertex) -> Grid:
    """Vertices of the sector with this corner that starts with this quad, column by column.

    Raises DomainError where the strips of quads have different lengths: no rectangle is there.
    """
    at: dict[Edge, list[Quad]] = defaultdict(list)
    for other in quads:
        for edge in sides(other):
            at[edge].append(other)
    k = quad.index(vertex)
    low, high = vertex, quad[(k + 3) % 4]
    here: Quad | None = quad
    grid: Grid = []
    while here is not None:
        strip = _strip(at, here, low, high)
        if not grid:
            grid = [[column[0]] for column in strip]
        if [column[0] for column in strip] != [column[-1] for column in grid]:
            raise DomainError(f"the sector at {vertex} is no rectangle: its strips part at {low}")
        for column, entry in zip(grid, strip, strict=True):
            column.append(entry[1])
        edge = frozenset((strip[0][1], strip[1][1]))
        here, low = _across(at, here, edge), strip[0][1]
        if here is not None:
            high = next(iter(_far(here, edge, low)))
    return grid


def _far(quad: Quad, edge: Edge, low: Vertex) -> set[Vertex]:
    """Return the neighbour of low in a quad that is not on the edge."""
    k = quad.index(low)
    return {quad[k - 1], quad[(k + 1) % 4]} - edge


def replaced(
    quads: Sequence[Quad],
    quad: Quad,
    vertex: Vertex,
    *,
    sectors: int = 3,
    ray: int = 2,
    reach: int | None = None,
    name: str = "new",
) -> list[Quad]:
    """Quads after surgery: the sector of this quad at this vertex gives way to `sectors` new ones.

    ray: length of every new ray, in edges; reach: how many rows and columns of the sector are cut
    out, all of them if None; name: tells the new vertices from those of earlier surgeries.
    Raises DomainError where the sector is no rectangular array.
    """
    if sectors < 1 or ray < 1:
        raise DomainError("surgery takes at least one sector and rays of at least one edge")
    whole = sector_grid(quads, quad, vertex)
    grid = whole if reach is None else [column[: reach + 1] for column in whole[: reach + 1]]
    removed = {frozenset(face) for face in _quads(grid)}
    kept = [face for face in quads if frozenset(face) not in removed]
    rays = [[column[0] for column in grid]]
    for k in range(1, sectors):
        rays.append([vertex, *((name, k, 0, i) for i in range(1, ray + 1))])
    rays.append(grid[0])
    for k in range(sectors):
        kept += _quads(_new_grid(rays[k], rays[k + 1], (name, k)))
    return kept


def _new_grid(first: Sequence[Vertex], second: Sequence[Vertex], name: tuple[str, int]) -> Grid:
    """Grid with these vertices on its two axes and new ones inside."""
    return [
        [second[j] if i == 0 else first[i] if j == 0 else (*name, i, j) for j in range(len(second))]
        for i in range(len(first))
    ]
