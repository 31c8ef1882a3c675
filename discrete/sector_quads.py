"""Quads that a sector of the greedy algorithm contributes to the disk, and where they lie.

Positions are triples of the hyperboloid around the corner of the sector, with the u-edge there
along x1 and v to its left, so that they keep their digits; `from_corner` carries them to the disk.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from discrete.goursat_kernel import fill_nodes
from discrete.greedy_parameters import GreedyParameters
from discrete.sector_cutter import CutSector
from discrete.sector_sides import Place, SectorSides
from discrete.side_kernel import hyperbolic_side_kernel
from discrete.space_forms import H2

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]


@dataclass(frozen=True, kw_only=True, eq=False)
class SectorQuads:
    """Vertices (3, n + 1, m + 1) around the corner, heights (n + 1, m + 1) seen from the centre.

    kept: whether each quad (n, m) is kept and meets the disk.
    """

    place: Place
    vertices: FloatArray
    heights: FloatArray
    kept: BoolArray

    def corners(self) -> FloatArray:
        """Corners p, p_u, p_uv, p_v of the kept quads: an array (quads, 4, 3)."""
        x = np.moveaxis(self.vertices, 0, -1)
        corners = (x[:-1, :-1], x[1:, :-1], x[1:, 1:], x[:-1, 1:])
        return np.stack([corner[self.kept] for corner in corners], axis=1)


def polyline(step: float, start: float, left_turns: FloatArray) -> FloatArray:
    """Vertices (3, n + 1) of a side from the origin, in this direction; left_turns[0] is unused."""
    found = np.empty((3, len(left_turns)))
    hyperbolic_side_kernel()(step, start, left_turns, found)
    return found


def to_centre(place: Place) -> FloatArray:
    """Matrix (3, 3) from triples around the corner to those around the centre."""

    def rotation(angle: float) -> FloatArray:
        c, s = math.cos(angle), math.sin(angle)
        return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])

    c, s = math.cosh(place.rho), math.sinh(place.rho)
    boost = np.array([[c, s, 0], [s, c, 0], [0, 0, 1]])
    reflection = np.diag([1.0, 1.0, float(place.hand)])
    return np.asarray(rotation(place.theta) @ boost @ rotation(place.heading) @ reflection)


def first_runs(near: BoolArray) -> BoolArray:
    """Of each row near[:, j] the first run, up to a row that the one below does not reach."""
    n = len(near)
    starts = np.vstack([near[:1], near[1:] & ~near[:-1]])
    runs = near & (np.cumsum(starts, axis=0) == 1)
    first, last = np.argmax(runs, axis=0), n - 1 - np.argmax(runs[::-1], axis=0)
    for j in range(near.shape[1]):
        apart = j > 0 and (first[j] > last[j - 1] + 1 or last[j] < first[j - 1] - 1)
        if apart or not runs[:, j].any():
            runs[:, j:] = False
            break
    return np.asarray(runs)


def sector_quads(
    parameters: GreedyParameters, sector: SectorSides, found: CutSector
) -> SectorQuads:
    """Fill a sector and select the quads that it contributes."""
    step = float(parameters.step)
    first = polyline(step, 0.0, -sector.first_turns)
    second = polyline(step, sector.opening, sector.second_turns)
    vertices = np.empty((3, first.shape[1], second.shape[1]))
    vertices[:, :, 0], vertices[:, 0, :] = first, second
    fill_nodes(H2, vertices)
    heights = np.tensordot(to_centre(sector.place)[0], vertices, axes=1)
    low = np.minimum(
        np.minimum(heights[:-1, :-1], heights[1:, :-1]),
        np.minimum(heights[:-1, 1:], heights[1:, 1:]),
    )
    near = low < math.cosh(float(parameters.radius)) * math.cosh(step / 2)
    kept = np.zeros_like(near)
    i, k = found.cut or near.shape
    kept[:, :k] = first_runs(near[:, :k])
    if found.cut is not None:
        kept[:i, k:] = first_runs(near[:i, k:].T).T
    return SectorQuads(place=sector.place, vertices=vertices, heights=heights, kept=kept)


def disk_points(place: Place, triples: FloatArray) -> Any:
    """Points of the Poincare disk, complex, of triples (..., 3) around the corner of a sector."""
    x = triples @ to_centre(place).T
    return (x[..., 1] + 1j * x[..., 2]) / (1 + x[..., 0])
