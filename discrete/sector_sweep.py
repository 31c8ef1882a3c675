"""Sweep of a sector in strips of skewed rows: angles, heights and sums, without keeping the net.

The height of a vertex is the hyperbolic cosine of its distance from the centre. Row j of quads lies
between the rows j and j + 1 of vertices. Quad (i, j) needs (i - 1, j) and (i, j - 1): in a strip of
LANES rows step t advances quad (t - r, top + r) of every row r at once, and the compiler vectorises
over r. All states of a step lie in one flat array with constant offsets, so that it sees that no
two of them overlap. A row leaves to the strip above it the angles A, half defects D and heights.
"""

import math
from typing import Any

from discrete.clipped_quads import clipped_area
from discrete.plain_functions import cosine, sine, small_arc_tangent

LANES = 8

# Offsets of the states of a step; slot r of BELOW_* is the row below lane r, slot r + 1 lane r.
_S = 2 * LANES
BELOW_A, BELOW_D, BELOW_H, BELOW_OLD = 0, _S, 2 * _S, 3 * _S
RISE, OWN_D, OWN_H = 4 * _S, 5 * _S, 6 * _S
NEW_A, NEW_D, NEW_H = 7 * _S, 8 * _S, 9 * _S
AREA, WILLMORE, LARGEST, SMALLEST, RIM, SINE_A, COSINE_A = (k * _S for k in range(10, 17))
FROM, TO = 17 * _S, 18 * _S
STATES = 19 * _S

# Constants of a run, in this order.
Q, COSH_R, COSH_FAR, COSH_OUTER, CUTOFF, COSH_L, SINH_L = range(7)
CONSTANTS = 7

# Sums of a row of quads, in this order: over the part of it in the disk.
SUM_AREA, SUM_WILLMORE, ROW_LARGEST, ROW_SMALLEST, ROW_FROM, ROW_TO = range(6)
SUMS = 6

#: A column beyond all others.
NO_COLUMN = 1e9

# What a sweep finds, and how it ends.
ROWS, SIDE, LAST_TOP, LAST_WIDTH, BEFORE_TOP, BEFORE_WIDTH = range(6)
FOUND = 6
ALL, BAD, NARROW = range(3)

#: An angle above all others, for the least angle of nothing.
NO_ANGLE = 4.0


def advance(w: Any, run: Any, t: int, width: int, rows: int) -> None:
    """Advance every lane by one quad; lanes that are not under way compute what nobody reads."""
    q, cosh_r, cosh_far = run[Q], run[COSH_R], run[COSH_FAR]
    for r in range(LANES):
        i = t - r
        ok = (i >= 0) & (i < width) & (r < rows)
        column = float(i)
        rise = w[RISE + r] + (w[BELOW_D + r] + w[OWN_D + r])
        a = w[BELOW_A + r] + rise
        sn = sine(0.5 * a)
        cs = cosine(0.5 * a)
        s = 2 * sn * cs
        c = 1 - 2 * sn * sn
        e = 1 - q * c
        f = q * s
        norm = e * e + f * f
        d = 2 * small_arc_tangent(f / e)
        h = w[BELOW_OLD + r]
        h1 = w[BELOW_H + r]
        h2 = w[OWN_H + r]
        h12 = h1 + h2 - h + (2 * q * (c - q) / norm) * (h1 + h2)
        top = max(max(h, h1), max(h2, h12))
        low = min(min(h, h1), min(h2, h12))
        follows = (w[TO + r] < 0) | (w[TO + r] == column - 1)
        near = ok & follows & (low < cosh_far)
        inside = near & (top <= cosh_r)
        node = near & ((h <= cosh_r) | (a >= math.pi))  # a quad that flips is bad wherever it is
        g = c - q
        area = 2 * d
        density = 2 * (norm + g * g) / (s * s)
        w[AREA + r] += area if inside else 0.0
        w[WILLMORE + r] += area * density if inside else 0.0
        w[LARGEST + r] = max(w[LARGEST + r], a if node else 0.0)
        w[SMALLEST + r] = min(w[SMALLEST + r], a if node else NO_ANGLE)
        w[FROM + r] = min(w[FROM + r], column if near else NO_COLUMN)
        w[TO + r] = column if near else w[TO + r]
        w[RIM + r] = density if near & (top > cosh_r) else 0.0
        w[RISE + r] = rise
        w[OWN_D + r] = d
        w[NEW_A + r] = a
        w[NEW_D + r] = d
        w[NEW_H + r] = h12
        w[SINE_A + r] = s
        w[COSINE_A + r] = c


def add_rim(w: Any, run: Any) -> None:
    """Add the parts in the disk of the quads that its boundary crosses."""
    for r in range(LANES):
        if w[RIM + r] > 0:
            heights = (w[BELOW_OLD + r], w[BELOW_H + r], w[NEW_H + r], w[OWN_H + r])
            s, c = w[SINE_A + r], w[COSINE_A + r]
            area = clipped_area(run[COSH_L], run[SINH_L], run[COSH_R], s, c, heights)
            w[AREA + r] += area
            w[WILLMORE + r] += area * w[RIM + r]


def keep(w: Any, kept: Any, t: int) -> None:
    """Write the step out, and let each lane be the row below the next one."""
    for r in range(LANES):
        kept[0, t, r] = w[NEW_A + r]
        kept[1, t, r] = w[NEW_D + r]
        kept[2, t, r] = w[NEW_H + r]
    for r in range(LANES):
        w[BELOW_OLD + r] = w[BELOW_H + r]
        w[OWN_H + r] = w[NEW_H + r]
    for r in range(LANES - 1):
        w[BELOW_A + 1 + r] = w[NEW_A + r]
        w[BELOW_D + 1 + r] = w[NEW_D + r]
        w[BELOW_H + 1 + r] = w[NEW_H + r]


def start_lane(w: Any, r: int, second_h: Any, second_t: Any, j: int) -> None:
    """Prepare lane r for its first quad (0, j), on the second side."""
    w[RISE + r] = second_t[j]
    w[OWN_D + r] = 0.0
    w[OWN_H + r] = second_h[j + 1]
    w[BELOW_OLD + r] = second_h[j]


def take_below(w: Any, below: Any, first_h: Any, first_t: Any, top: int, t: int) -> None:
    """Give lane 0 the row below it: of the strip before, or the first side."""
    if top == 0:
        w[BELOW_A] = 0.0
        w[BELOW_D] = first_t[t]
        w[BELOW_H] = first_h[t + 1]
    else:
        w[BELOW_A] = below[0, t + LANES - 1, LANES - 1]
        w[BELOW_D] = below[1, t + LANES - 1, LANES - 1]
        w[BELOW_H] = below[2, t + LANES - 1, LANES - 1]


def sweep_strip(
    run: Any, first_h: Any, first_t: Any, second_h: Any, second_t: Any,
    top: int, width: int, rows: int, w: Any, below: Any, kept: Any, sums: Any,
) -> None:  # fmt: skip
    """Sweep the rows top, ..., top + rows - 1 of `width` quads each."""
    for k in range(STATES):
        w[k] = 1.0
    for r in range(LANES):
        w[AREA + r] = 0.0
        w[WILLMORE + r] = 0.0
        w[LARGEST + r] = 0.0
        w[SMALLEST + r] = NO_ANGLE
        w[FROM + r] = NO_COLUMN
        w[TO + r] = -1.0
    for t in range(width + rows - 1):
        if t < rows:
            start_lane(w, t, second_h, second_t, top + t)
        if t < width:
            take_below(w, below, first_h, first_t, top, t)
        advance(w, run, t, width, rows)
        add_rim(w, run)
        keep(w, kept, t)
    for r in range(rows):
        sums[top + r, SUM_AREA] = w[AREA + r]
        sums[top + r, SUM_WILLMORE] = w[WILLMORE + r]
        sums[top + r, ROW_LARGEST] = w[LARGEST + r]
        sums[top + r, ROW_SMALLEST] = w[SMALLEST + r]
        sums[top + r, ROW_FROM] = w[FROM + r]
        sums[top + r, ROW_TO] = w[TO + r]


def width_above(run: Any, kept: Any, start: int, width: int, rows: int) -> int:
    """Quads of the rows above a strip: up to the first vertex beyond the outer disk.

    start: a column from which on to look, within the disk or its last.
    """
    for i in range(start, width):
        if kept[2, i + rows - 1, rows - 1] > run[COSH_OUTER]:
            return i + 1
    return width


def rows_of_disk(sums: Any, top: int, rows: int) -> int:
    """Rows of a strip up to the first that the disk does not reach from the row below."""
    for j in range(top, top + rows):
        start, end = sums[j, ROW_FROM], sums[j, ROW_TO]
        if end < 0 or (
            j > 0 and (start > sums[j - 1, ROW_TO] + 1 or end < sums[j - 1, ROW_FROM] - 1)
        ):
            return j - top
    return rows


def sweep(
    run: Any, first_h: Any, first_t: Any, second_h: Any, second_t: Any,
    width: int, height: int, w: Any, buffers: Any, sums: Any, found: Any,
) -> int:  # fmt: skip
    """Sweep rows until one has a vertex in the disk with an angle beyond the cutoff, or all.

    first_t[i], second_t[j]: turns of the sides at their inner vertices, first_t[0] = 0, second_t[0]
    the angle at the corner. found: rows of the disk below the first bad one; the side of the last
    buffer; start and width of the last two strips. Gives ALL, BAD or NARROW.
    """
    top, side = 0, 0
    for k in range(FOUND):
        found[k] = 0
    while top < height:
        rows = min(LANES, height - top)
        sweep_strip(
            run, first_h, first_t, second_h, second_t, top, width, rows,
            w, buffers[1 - side], buffers[side], sums,
        )  # fmt: skip
        found[BEFORE_TOP], found[BEFORE_WIDTH] = found[LAST_TOP], found[LAST_WIDTH]
        found[LAST_TOP], found[LAST_WIDTH], found[SIDE] = top, width, side
        reached = rows_of_disk(sums, top, rows)
        for r in range(reached):
            found[ROWS] = top + r
            if sums[top + r, ROW_LARGEST] > run[CUTOFF]:
                return BAD
            if sums[top + r, ROW_TO] == width - 1:
                return NARROW
        found[ROWS] = top + reached
        if reached < rows:
            return ALL
        width = width_above(run, buffers[side], int(sums[top + rows - 1, ROW_TO]), width, rows)
        top += rows
        side = 1 - side
    return NARROW


def row_line(
    first_h: Any, first_t: Any, second_h: Any, second_t: Any,
    k: int, buffers: Any, found: Any, line_h: Any, line_t: Any,
) -> Any:  # fmt: skip
    """Heights of row k of vertices and its turns, measured above it; gives its number of edges.

    line_t[0]: the angle at its vertex on the second side. The row lies in one of the last strips.
    """
    line_h[0] = second_h[k]
    if k == 0:
        for i in range(1, len(first_h)):
            line_h[i], line_t[i] = first_h[i], first_t[i]
        line_t[0] = second_t[0]
        return len(first_h) - 1
    side, start, width = found[SIDE], found[LAST_TOP], found[LAST_WIDTH]
    if k - 1 < start:
        side, start, width = 1 - side, found[BEFORE_TOP], found[BEFORE_WIDTH]
    r = k - 1 - start
    a, d, h = buffers[side, 0], buffers[side, 1], buffers[side, 2]
    line_t[0] = (a[r, r] + d[r, r]) + second_t[k]
    for i in range(1, width + 1):
        line_h[i] = h[i - 1 + r, r]
    for i in range(1, width):
        line_t[i] = (a[i + r, r] - a[i - 1 + r, r]) + d[i + r, r]
    line_t[width] = 0.0
    return width
