"""Compiled Goursat fill in float64: strips of rows, skewed so that the compiler vectorises.

Node (i, j) needs (i - 1, j - 1), (i - 1, j), (i, j - 1). Row by row each node waits for the one
before it. In a strip of ROWS rows, step t fills the nodes (i, t - i) of all its rows at once: they
need only the steps t - 1 and t - 2, kept side by side, so that the lanes are independent. STEPS
steps are kept and then written out along the rows. The half-turn is `close_quad` itself, without
reordering or contraction: the nodes are those of `goursat_fill.fill` bit by bit.
"""

from functools import cache
from typing import Any

from discrete.compilation import Kernel, compiled, stamp_of
from discrete.errors import ShapeError
from discrete.goursat_fill import LOST, require_nodes, require_sides
from discrete.quad_rule import NEARLY_ANTIPODAL, close_quad
from discrete.space_forms import Product, SpaceForm

#: Found by timing on a Xeon: of 32 rows writing out takes three times as long as computing, of 16
#: about as long. Each row lies on memory pages of its own.
ROWS = 16
STEPS = 64


def advance_lanes(dot: Product, new: Any, last: Any, before: Any) -> None:
    """Set the lanes 1, ..., ROWS of a step from the two steps before; each is (3, ROWS + 1)."""
    for r in range(ROWS):
        p = (before[0, r], before[1, r], before[2, r])
        p1 = (last[0, r + 1], last[1, r + 1], last[2, r + 1])
        p2 = (last[0, r], last[1, r], last[2, r])
        q = close_quad(dot, p, p1, p2)
        new[0, r + 1] = q[0]
        new[1, r + 1] = q[1]
        new[2, r + 1] = q[2]


def take_sides(step: Any, nodes: Any, top: int, rows: int, t: int) -> None:
    """Put into step t the nodes that are known: of column 0, and of the row above the strip."""
    for c in range(3):
        if t < rows:
            step[c, t + 1] = nodes[c, top + t, 0]
        if t + 1 < nodes.shape[2]:
            step[c, 0] = nodes[c, top - 1, t + 1]


def write_rows(nodes: Any, steps: Any, top: int, rows: int, start: int) -> None:
    """Write the steps start, ..., start + STEPS - 1 out along the rows of the strip."""
    width = nodes.shape[2]
    for c in range(3):
        for r in range(rows):
            row = nodes[c, top + r]
            shift = start - r
            for s in range(max(0, -shift), min(STEPS, width - shift)):
                row[shift + s] = steps[s + 2, c, r + 1]


def kernel_body(dot: Product, stamp: str) -> Kernel:
    """Uncompiled kernel of one space; stamp: text that renews the code which numba has stored."""

    def fill(nodes: Any, steps: Any) -> None:
        _ = stamp
        height, width = nodes.shape[1], nodes.shape[2]
        for top in range(1, height, ROWS):
            rows = min(ROWS, height - top)
            steps[:] = 1.0  # lanes still outside the net compute numbers that nobody reads
            for c in range(3):
                steps[1, c, 0] = nodes[c, top - 1, 0]
            for start in range(0, width + rows - 1, STEPS):
                if start > 0:
                    steps[:2] = steps[STEPS:]
                for s in range(STEPS):
                    advance_lanes(dot, steps[s + 2], steps[s + 1], steps[s])
                    take_sides(steps[s + 2], nodes, top, rows, start + s)
                write_rows(nodes, steps, top, rows, start)

    return fill


@cache
def kernel(space: SpaceForm) -> Kernel:
    """Compiled kernel of one space."""
    stamp = stamp_of(space.dot, close_quad, advance_lanes, take_sides, write_rows)
    return compiled(kernel_body(space.dot, stamp))


def fill_nodes(space: SpaceForm, nodes: Any) -> None:
    """Fill a float64 array (3, n, m) in place: nodes[:, i, j] is node (i, j) of the net.

    Column 0 and row 0 hold the two sides. Nothing is checked: see `filled_array`. Raises ShapeError
    for an array of another shape or kind.
    """
    import numpy as np

    if nodes.ndim != 3 or nodes.shape[0] != 3 or nodes.dtype != np.float64:
        raise ShapeError(f"expected float64 of shape (3, n, m), not {nodes.dtype} {nodes.shape}")
    kernel(space)(nodes, np.empty((STEPS + 2, 3, ROWS + 1)))


def filled_array(space: SpaceForm, first: Any, second: Any, *, out: Any = None) -> Any:
    """Array (3, n, m) of the net on a user's sides, arrays (3, n) and (3, m), every node checked.

    first[:, i] is node (i, 0), second[:, j] is node (0, j); out: where to put the nodes.
    Raises ShapeError, NotFiniteError, OffSpaceError, AntipodalError, naming the vertex.
    """
    import numpy as np

    sides = [np.asarray(side, dtype=float) for side in (first, second)]
    for name, side in zip(("first", "second"), sides, strict=True):
        if side.ndim != 2 or side.shape[0] != 3:
            raise ShapeError(f"the {name} side has the shape {side.shape}, expected (3, n)")
    require_sides(space, *([tuple(map(float, p)) for p in side.T] for side in sides))
    shape = (3, sides[0].shape[1], sides[1].shape[1])
    nodes = np.empty(shape) if out is None else out
    if nodes.shape != shape:
        raise ShapeError(f"out has the shape {nodes.shape}, expected {shape}")
    nodes[:, :, 0], nodes[:, 0, :] = sides
    fill_nodes(space, nodes)
    _require_nodes(space, nodes)
    return nodes


def _require_nodes(space: SpaceForm, nodes: Any) -> None:
    """Refuse a filled net that `goursat_fill.require_nodes` refuses, row by row."""
    import numpy as np

    with np.errstate(invalid="ignore", over="ignore"):
        for i in range(nodes.shape[1]):
            kept = bool((np.abs(space.residual(nodes[:, i])) <= LOST).all())
            if i > 0 and space.curvature > 0:
                s = nodes[:, i - 1, 1:] + nodes[:, i, :-1]
                kept = kept and bool((space.dot(s, s) >= NEARLY_ANTIPODAL).all())
            if not kept:
                top = max(0, i - 1)
                rows = nodes[:, top : i + 1].transpose(1, 2, 0).tolist()
                require_nodes(space, rows, first_row=top)
