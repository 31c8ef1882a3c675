"""Goursat fill: the Chebyshev net on a rectangle from its values on two sides (fig:goursat).

Node (i, j) lies i edges along the first side and j along the second; node (0, 0) is their common
corner. The generic body takes scalars of any kind; discrete.goursat_kernel does the same in
compiled float64, with the same roundings.
"""

from collections.abc import Sequence

from discrete.errors import AntipodalError, NotFiniteError, ShapeError
from discrete.quad_rule import close_quad, require_on_space
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

    Raises AntipodalError where the half-turn broke down, NotFiniteError for an overflow on H^2.
    """
    if abs(space.residual(p)) <= LOST:  # false for NaN
        return
    if space.curvature > 0:
        raise AntipodalError(
            f"node ({i}, {j}): its neighbours ({i - 1}, {j}) and ({i}, {j - 1}) are antipodal, or "
            "so nearly that no digit is left; take shorter edges or stop the net before"
        )
    raise NotFiniteError(
        f"node ({i}, {j}) has left the hyperboloid: {tuple(p)}; so far from (1, 0, 0) the net "
        "needs discrete.angle_advance"
    )


def filled_rectangle(
    space: SpaceForm, first: Sequence[Triple], second: Sequence[Triple]
) -> list[list[Triple]]:
    """Nodes [i][j] of the float net on a user's sides, every vertex checked.

    Raises ShapeError, NotFiniteError, OffSpaceError, AntipodalError.
    """
    require_sides(space, first, second)
    nodes = fill(space.dot, first, second)
    for i, row in enumerate(nodes):
        for j, p in enumerate(row):
            require_node(space, p, i, j)
    return nodes
