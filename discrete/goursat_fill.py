"""Goursat fill: the Chebyshev net on a rectangle from its values on two sides (fig:goursat).

Node (i, j) lies i edges along the first side and j along the second; node (0, 0) is their common
corner. The generic body takes scalars of any kind; discrete.goursat_kernel does the same in
compiled float64, with the same roundings.
"""

from collections.abc import Sequence
from math import isfinite

from discrete.errors import NotFiniteError, OffSpaceError, ShapeError
from discrete.quad_rule import close_quad, require_not_antipodal, require_on_space
from discrete.space_forms import Product, SpaceForm, Triple

#: Residual <p, p> - K at which a net filled in float64 has lost its digits; on H^2 rounding alone
#: reaches it at a distance of about 11 from (1, 0, 0).
LOST = 1e-6


def next_row(dot: Product, row: Sequence[Triple], start: Triple) -> list[Triple]:
    """Row of nodes after `row`, given its first node."""
    filled = [start]
    for j in range(1, len(row)):
        filled.append(close_quad(dot, row[j - 1], filled[j - 1], row[j]))
    return filled


def fill(dot: Product, first: Sequence[Triple], second: Sequence[Triple]) -> list[list[Triple]]:
    """Nodes [i][j] of the net with first[i] = node (i, 0) and second[j] = node (0, j).

    The polylines start at the same vertex; their edges may have any lengths, equal or not.
    Undefined where a quad has two antipodal neighbours (S^2): see `filled_rectangle`.
    """
    rows = [list(second)]
    for i in range(1, len(first)):
        rows.append(next_row(dot, rows[i - 1], first[i]))
    return rows


def require_sides(space: SpaceForm, first: Sequence[Triple], second: Sequence[Triple]) -> None:
    """Refuse float polylines that are no two sides of a rectangle in the space.

    Raises ShapeError, NotFiniteError, OffSpaceError, naming the vertex.
    """
    for name, side in (("first", first), ("second", second)):
        if len(side) < 2:
            raise ShapeError(f"the {name} side has {len(side)} vertices; it needs two at least")
        for i, vertex in enumerate(side):
            require_on_space(space, vertex, f"{i} of the {name} side")
    if tuple(first[0]) != tuple(second[0]):
        raise ShapeError(
            f"the sides start at different vertices, {tuple(first[0])} and {tuple(second[0])}: "
            "both must start at node (0, 0)"
        )


def require_node(space: SpaceForm, p: Triple, i: int, j: int) -> None:
    """Refuse a node of a filled float net that is not on the space any more.

    Raises NotFiniteError for NaN or an overflow, OffSpaceError where the digits are lost.
    """
    if abs(space.residual(p)) <= LOST:  # false for NaN
        return
    error = OffSpaceError if all(isfinite(entry) for entry in p) else NotFiniteError
    raise error(
        f"node ({i}, {j}) = {tuple(p)} has left {space.name}; hyperbolic nets that reach so "
        "far from (1, 0, 0) need discrete.angle_advance"
    )


def require_nodes(
    space: SpaceForm, nodes: Sequence[Sequence[Triple]], *, first_row: int = 0
) -> None:
    """Refuse a filled float net where one node has left the space or two neighbours are antipodal.

    first_row: number of the first row given. Raises NotFiniteError, OffSpaceError, AntipodalError,
    naming the first node at fault.
    """
    for k, row in enumerate(nodes):
        i = first_row + k
        for j, p in enumerate(row):
            require_node(space, p, i, j)
            if k > 0 and j > 0:
                names = f"({i - 1}, {j}) and ({i}, {j - 1})"
                require_not_antipodal(space, nodes[k - 1][j], row[j - 1], names)


def filled_rectangle(
    space: SpaceForm, first: Sequence[Triple], second: Sequence[Triple]
) -> list[list[Triple]]:
    """Nodes [i][j] of the float net on a user's sides, every vertex checked.

    Raises ShapeError, NotFiniteError, OffSpaceError, AntipodalError, naming the vertex.
    """
    require_sides(space, first, second)
    nodes = fill(space.dot, first, second)
    require_nodes(space, nodes)
    return nodes
