"""Frames of H^2 at the vertices of a branched net, sector by sector, in float64 arrays.

All are seen from the apex of sector 0, its u-edge being the direction x1: products of steps along
the edges (discrete.sl2_frames), a daughter starting from the frame of her apex in her parent. A
sector whose v-edges lie to the right of its u-edges has the angles of its mirror image.
"""

from typing import Any

import numpy as np
import numpy.typing as npt

from discrete.branched_net import BranchedNet
from discrete.elementary import array_functions
from discrete.net_frames import Step, followed
from discrete.sector import Sector
from discrete.sl2_frames import IDENTITY, Frame, distance_from_start, turned

FloatArray = npt.NDArray[np.float64]


def sector_frames(sector: Sector, side: int, start: Frame) -> FloatArray:
    """Frames (4, n + 1, m + 1) of a sector from the one at its apex, along its u-edge."""
    functions: Any = array_functions()
    n, m = sector.shape
    near = side * sector.angles
    far = side * (sector.angles + np.asarray(sector.net.half_defects))
    frames = np.empty((4, n + 1, m + 1))
    frames[:, 0, 0] = start
    for i in range(n):
        turn = near[i, 0] - near[i + 1, 0] + far[i, 0] - near[i, 0] if i + 1 < n else 0.0
        step: Step = (0.0, sector.u_lengths[i], turn)
        frames[:, i + 1, 0] = followed(functions, tuple(frames[:, i, 0]), step)
    for j in range(m):
        # On the last column the frame points straight on from the edge that arrives.
        before = np.append(near[:, j], far[-1, j])
        after = np.append(far[:, j], near[-1, j])
        step = (before, np.full(n + 1, sector.v_lengths[j]), -after)
        frames[:, :, j + 1] = followed(functions, tuple(frames[:, :, j]), step)
    return frames


def placed_frames(net: BranchedNet) -> list[FloatArray]:
    """Frames of all sectors, seen from the apex of sector 0; also where their quads are cut out."""
    functions: Any = array_functions()
    found: list[FloatArray] = []
    for placed in net.placed:
        i, j = placed.apex
        apex = IDENTITY if placed.parent < 0 else tuple(found[placed.parent][:, i, j])
        start = turned(functions, apex, placed.bearing)
        found.append(sector_frames(placed.sector, placed.side, start))
    return found


def placed_distances(net: BranchedNet) -> list[FloatArray]:
    """Distances (n + 1, m + 1) of the vertices of each sector from the apex of sector 0."""
    functions: Any = array_functions()
    frames = placed_frames(net)
    return [np.asarray(distance_from_start(functions, tuple(g))) for g in frames]
