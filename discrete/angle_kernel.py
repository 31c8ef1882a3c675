"""Compiled advance of the angles of a Chebyshev net in float64: the body of discrete.angle_advance.

One transcendental step a quad dominates, so the loop runs row by row. The angles are those of the
generic body on floats up to the last places of sine and arc tangent.
"""

import math
from collections.abc import Sequence
from functools import cache
from typing import Any

from discrete.angle_advance import fill_angles, half_tangents
from discrete.compilation import Kernel, compiled, stamp_of
from discrete.parallelograms import half_defect
from discrete.space_forms import SpaceForm


def float_half_defect(q: float, angle: float) -> float:
    """Half defect of a quad in float64."""
    return float(half_defect(math, q, angle))


def kernel_body(stamp: str) -> Kernel:
    """Uncompiled kernel; stamp: text that renews the code which numba has stored."""

    def fill(
        u: Any, v: Any, corner: float, u_turns: Any, v_turns: Any, angles: Any, defects: Any
    ) -> None:
        _ = stamp
        fill_angles(float_half_defect, u, v, corner, u_turns, v_turns, angles, defects)

    return fill


@cache
def kernel() -> Kernel:
    """Compiled kernel."""
    return compiled(kernel_body(stamp_of(half_defect, float_half_defect, fill_angles)))


def filled_angles(
    space: SpaceForm,
    u_lengths: Sequence[float],
    v_lengths: Sequence[float],
    corner_angle: float,
    u_turns: Sequence[float],
    v_turns: Sequence[float],
) -> tuple[Any, Any]:
    """Arrays (n, m) of the angles A and of the half defects of the quads; nothing is checked."""
    import numpy as np

    u, v = half_tangents(space, math, u_lengths, v_lengths)
    angles, defects = (np.empty((len(u), len(v))) for _ in range(2))
    as_array = [np.asarray(values, dtype=float) for values in (u, v, u_turns, v_turns)]
    kernel()(*as_array[:2], float(corner_angle), *as_array[2:], angles, defects)
    return angles, defects
