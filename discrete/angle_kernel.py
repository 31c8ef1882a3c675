"""Compiled advance of the angles of a Chebyshev net in float64: the body of discrete.angle_advance.

One transcendental step a quad dominates, so the loop runs row by row. The angles are those of the
generic body on floats up to the last places of sine and arc tangent.
"""

import inspect
import math
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

from discrete.angle_advance import fill_angles, half_tangents
from discrete.parallelograms import half_defect
from discrete.space_forms import SpaceForm


def float_half_defect(q: float, angle: float) -> float:
    """Half defect of a quad in float64."""
    return float(half_defect(math, q, angle))


def kernel_body(stamp: str) -> Callable[..., None]:
    """Uncompiled kernel; stamp: text that renews the code which numba has stored."""

    def fill(
        u: Any, v: Any, corner: float, u_turns: Any, v_turns: Any, angles: Any, defects: Any
    ) -> None:
        _ = stamp
        fill_angles(float_half_defect, u, v, corner, u_turns, v_turns, angles, defects)

    return fill


@cache
def compiled() -> Callable[..., None]:
    """Compiled kernel, from numba's store where nothing has changed since."""
    from numba import njit
    from numba.extending import register_jitable

    bodies = (half_defect, float_half_defect, fill_angles)
    for body in bodies:
        register_jitable(error_model="numpy")(body)
    stamp = "".join(inspect.getsource(body) for body in bodies)
    found: Callable[..., None] = njit(cache=True, error_model="numpy")(kernel_body(stamp))
    return found


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
    compiled()(*as_array[:2], float(corner_angle), *as_array[2:], angles, defects)
    return angles, defects
