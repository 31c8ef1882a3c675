"""Cut of one sector (alg:greedy-cuts, steps 12 to 14), and the lines that bound what it loses.

The vertices (i, j) in the closed disk whose angle exceeds the cutoff, and the quads that meet the
disk with an angle of pi or more, are all in the rows above k* and the columns beyond i*, the
largest such numbers: the sector keeps the quads with i < i* or j < k*. Where the first row has such
a vertex the step resolves no k*: 0 is taken, and the cut lies on the side; the same for i*. The
first sweep goes over the rows below k*, the second over the columns before i* above it.
"""

import inspect
import math
from functools import cache
from typing import Any

from discrete import clipped_quads, plain_functions, sector_sweep
from discrete.compilation import Kernel, compiled, stamp_of
from discrete.sector_sweep import (
    ALL,
    NARROW,
    ROW_FROM,
    ROW_LARGEST,
    ROW_SMALLEST,
    ROW_TO,
    ROWS,
    SUM_AREA,
    SUM_WILLMORE,
    row_line,
    sweep,
)

#: What became of a sector.
KEPT_WHOLE, CUT, TOO_NARROW, TIE = range(4)

# Entries of `counts` and of `totals`.
I_CUT, K_CUT, ROW_EDGES, COLUMN_EDGES = range(4)
AREA, WILLMORE, LARGEST, SMALLEST, QUADS, CUT_ANGLE = range(6)


def add_rows(sums: Any, rows: int, totals: Any) -> None:
    """Add the sums of rows to the totals of the sector."""
    for j in range(rows):
        totals[AREA] += sums[j, SUM_AREA]
        totals[WILLMORE] += sums[j, SUM_WILLMORE]
        totals[LARGEST] = max(totals[LARGEST], sums[j, ROW_LARGEST])
        totals[SMALLEST] = min(totals[SMALLEST], sums[j, ROW_SMALLEST])
        totals[QUADS] += max(sums[j, ROW_TO] - sums[j, ROW_FROM] + 1, 0.0)


def cut_sector(
    run: Any, first_h: Any, first_t: Any, second_h: Any, second_t: Any, mirrored: bool,
    w: Any, buffers: Any, sums: Any, found: Any,
    row_h: Any, row_t: Any, column_h: Any, column_t: Any, counts: Any, totals: Any,
) -> int:  # fmt: skip
    """Sweep a sector between two sides and find its cut; gives what became of it.

    mirrored: whether the sector is its own mirror image, so that i* = k*. row_h, row_t: the row k*
    of vertices; column_h, column_t: the column i* from the row k* on.
    """
    n, m = len(first_h) - 1, len(second_h) - 1
    for k in range(len(totals)):
        totals[k] = 0.0
    totals[SMALLEST] = sector_sweep.NO_ANGLE
    end = sweep(run, first_h, first_t, second_h, second_t, n, m, w, buffers, sums, found)
    if end == NARROW:
        return TOO_NARROW
    if end == ALL:
        add_rows(sums, found[ROWS], totals)
        return KEPT_WHOLE
    k = max(found[ROWS] - 1, 0)
    add_rows(sums, k, totals)
    edges = row_line(first_h, first_t, second_h, second_t, k, buffers, found, row_h, row_t)
    counts[K_CUT], counts[ROW_EDGES] = k, edges
    side_h = second_h[k:].copy()
    side_t = second_t[k:].copy()
    side_t[0] = 0.0
    end = sweep(
        run, side_h, side_t, row_h[: edges + 1], row_t[: edges + 1],
        m - k, edges, w, buffers, sums, found,
    )  # fmt: skip
    if end == NARROW:
        return TOO_NARROW
    i = max(found[ROWS] - 1, 0)
    if mirrored and i > k:
        i = k
    if end == ALL or (mirrored and i != k):
        return TIE
    add_rows(sums, i, totals)
    counts[I_CUT] = i
    counts[COLUMN_EDGES] = row_line(
        side_h, side_t, row_h, row_t, i, buffers, found, column_h, column_t
    )
    totals[CUT_ANGLE] = column_t[0]
    return CUT


def path_to_cut(
    frame: Any, length: float, opening: float, hand: float,
    second_t: Any, k: int, row_t: Any, i: int,
) -> None:  # fmt: skip
    """Move a frame (a, b, c, d) from the corner, along the u-edge there, to the cut, along the row.

    It goes up the second side and along the row k*. hand: 1 if the v-edges lie to the left.
    """
    turn(frame, hand * opening)
    for j in range(1, k + 1):
        advance_by(frame, length)
        turn(frame, hand * second_t[j])
    turn(frame, -hand * row_t[0])
    for j in range(1, i + 1):
        advance_by(frame, length)
        turn(frame, -hand * row_t[j])


def turn(frame: Any, angle: float) -> None:
    """Turn a frame to the left, as discrete.sl2_frames does."""
    c, s = math.cos(angle / 2), math.sin(angle / 2)
    a, b, p, d = frame[0], frame[1], frame[2], frame[3]
    frame[0], frame[1] = a * c + b * s, b * c - a * s
    frame[2], frame[3] = p * c + d * s, d * c - p * s


def advance_by(frame: Any, length: float) -> None:
    """Move a frame along its direction, as discrete.sl2_frames does."""
    grow = math.exp(length / 2)
    frame[0], frame[1] = frame[0] * grow, frame[1] / grow
    frame[2], frame[3] = frame[2] * grow, frame[3] / grow


def _stamp() -> str:
    parts = (
        *(plain_functions.sine, plain_functions.cosine, plain_functions.small_arc_tangent),
        *(clipped_quads.slopes, clipped_quads.triangle_area, clipped_quads.seen_angle),
        *(clipped_quads.edge_area, clipped_quads.clipped_area),
        *(sector_sweep.advance, sector_sweep.add_rim, sector_sweep.keep, sector_sweep.start_lane),
        *(sector_sweep.take_below, sector_sweep.sweep_strip, sector_sweep.width_above),
        *(sector_sweep.rows_of_disk, sweep, row_line, add_rows, turn, advance_by),
        *(cut_sector, path_to_cut),
    )
    constants = (plain_functions, sector_sweep)
    return stamp_of(*parts) + "".join(inspect.getsource(module) for module in constants)


@cache
def cut_kernel() -> Kernel:
    """Compiled `cut_sector`."""
    stamp = _stamp()

    def cut(
        run: Any, first_h: Any, first_t: Any, second_h: Any, second_t: Any, mirrored: bool,
        w: Any, buffers: Any, sums: Any, found: Any,
        row_h: Any, row_t: Any, column_h: Any, column_t: Any, counts: Any, totals: Any,
    ) -> int:  # fmt: skip
        _ = stamp
        return cut_sector(
            run, first_h, first_t, second_h, second_t, mirrored, w, buffers, sums, found,
            row_h, row_t, column_h, column_t, counts, totals,
        )  # fmt: skip

    return compiled(cut, nogil=True)


@cache
def path_kernel() -> Kernel:
    """Compiled `path_to_cut`."""
    stamp = _stamp()

    def path(
        frame: Any, length: float, opening: float, hand: float,
        second_t: Any, k: int, row_t: Any, i: int,
    ) -> None:  # fmt: skip
        _ = stamp
        path_to_cut(frame, length, opening, hand, second_t, k, row_t, i)

    return compiled(path)
