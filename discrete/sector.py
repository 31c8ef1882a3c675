"""Sectors: rectangles of a hyperbolic Chebyshev net, given by lengths and turns of two sides."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from discrete.angle_advance import NetAngles, checked_net_angles
from discrete.errors import AngleError, ShapeError
from discrete.space_forms import H2

FloatArray = npt.NDArray[np.float64]


def frozen_array(values: object) -> FloatArray:
    """Read-only array of float64 with one index. Raises ShapeError for other data."""
    try:
        found = np.array(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ShapeError(f"{values!r} is no sequence of real numbers") from error
    if found.ndim != 1:
        raise ShapeError(f"an array of the shape {found.shape}: give a sequence of numbers")
    found.setflags(write=False)
    return found


@dataclass(frozen=True, kw_only=True, eq=False)
class Sector:
    """Rectangle of a net on H^2: its vertex (i, j) lies i u-edges and j v-edges from its apex.

    u_lengths, v_lengths: of the edges of the sides v = 0 and u = 0; corner_angle: at the apex, in
    (0, pi); u_turns, v_turns: excess over pi of the angles of the sides at their inner vertices,
    measured in the sector (0 on a geodesic). Raises the errors of discrete.angle_advance.
    """

    u_lengths: FloatArray
    v_lengths: FloatArray
    corner_angle: float
    u_turns: FloatArray
    v_turns: FloatArray

    def __post_init__(self) -> None:
        for name in ("u_lengths", "v_lengths", "u_turns", "v_turns"):
            object.__setattr__(self, name, frozen_array(getattr(self, name)))
        try:
            object.__setattr__(self, "corner_angle", float(self.corner_angle))
        except (TypeError, ValueError) as error:
            raise AngleError(f"the corner angle {self.corner_angle!r} is no number") from error
        _ = self.net

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of u- and of v-edges."""
        return len(self.u_lengths), len(self.v_lengths)

    @cached_property
    def net(self) -> NetAngles:
        """Angles of the quads: arrays (n, m) of A and of pi - A - B."""
        return checked_net_angles(
            H2,
            self.u_lengths.tolist(),
            self.v_lengths.tolist(),
            self.corner_angle,
            u_turns=self.u_turns.tolist(),
            v_turns=self.v_turns.tolist(),
        )

    @property
    def angles(self) -> FloatArray:
        """Angle A of each quad at its vertices (i, j) and (i + 1, j + 1)."""
        return np.asarray(self.net.angles)

    @property
    def other_angles(self) -> FloatArray:
        """Angle B of each quad at its vertices (i + 1, j) and (i, j + 1)."""
        return np.asarray(np.pi - self.angles - self.net.half_defects)

    def corner_angles(self) -> FloatArray:
        """Angles of the quads at their corners p, p_u, p_uv, p_v: an array (n, m, 4)."""
        a, b = self.angles, self.other_angles
        return np.stack([a, b, a, b], axis=-1)

    def u_line_turns(self, i: int, j: int) -> FloatArray:
        """Turns of the u-line from vertex (i, j) on, measured in the quads above it (v >= j)."""
        inner = slice(i + 1, self.shape[0])
        before = slice(i, self.shape[0] - 1)
        return np.asarray(self.angles[inner, j] + self.other_angles[before, j] - np.pi)

    def v_line_turns(self, i: int, j: int) -> FloatArray:
        """Turns of the v-line from vertex (i, j) on, measured in the quads to its side u >= i."""
        inner = slice(j + 1, self.shape[1])
        before = slice(j, self.shape[1] - 1)
        return np.asarray(self.angles[i, inner] + self.other_angles[i, before] - np.pi)


def amsler_sector(u_lengths: object, v_lengths: object, corner_angle: float) -> Sector:
    """Sector between two geodesics (def:amsler-sector)."""
    first, second = frozen_array(u_lengths), frozen_array(v_lengths)
    return Sector(
        u_lengths=first,
        v_lengths=second,
        corner_angle=corner_angle,
        u_turns=np.zeros(max(len(first) - 1, 0)),
        v_turns=np.zeros(max(len(second) - 1, 0)),
    )
