"""K-surface of a sector of the greedy algorithm, with the frames that its daughters start from."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from discrete.goursat_kernel import fill_nodes
from discrete.sector_sides import SectorSides
from discrete.side_kernel import points_kernel, spherical_side_kernel
from discrete.space_forms import S2
from discrete.space_frame import turned

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class CornerFrame:
    """Arrays (3,): position, unit normal and direction of the u-edge at the corner of a sector."""

    point: FloatArray
    normal: FloatArray
    along_u: FloatArray


STANDARD = CornerFrame(
    point=np.zeros(3), normal=np.array([0.0, 0.0, 1.0]), along_u=np.array([1.0, 0.0, 0.0])
)


def sector_surface(
    step: float, sector: SectorSides, frame: CornerFrame
) -> tuple[FloatArray, FloatArray]:
    """Positions and normals (3, n + 1, m + 1) of the vertices of a sector; step: on H^2."""
    hand = sector.place.hand
    along_v = turned(frame.along_u, frame.normal, np.float64(hand * sector.opening))
    normals = np.empty((3, len(sector.first_turns), len(sector.second_turns)))
    for side, along, twist, turns in (
        (normals[:, :, 0], frame.along_u, -1.0, -hand * sector.first_turns),
        (normals[:, 0, :], along_v, 1.0, hand * sector.second_turns),
    ):
        spherical_side_kernel()(step, twist, turns, np.stack([frame.normal, along]), side)
    fill_nodes(S2, normals)
    points = np.empty_like(normals)
    points[:, 0, 0] = frame.point
    points_kernel()(normals, points)
    return points, normals


def daughter_frames(
    sector: SectorSides, cut: tuple[int, int], angle: float, points: FloatArray, normals: FloatArray
) -> dict[int, CornerFrame]:
    """Frames of the daughters, by their letters: the u-edge of the first goes along the row.

    The others have theirs on the second of the two geodesics that trisect the angle at the cut.
    """
    i, k = cut
    point, normal = points[:, i, k], normals[:, i, k]
    along = points[:, i + 1, k] - point
    along = along / np.linalg.norm(along)
    beyond = turned(along, normal, np.float64(sector.place.hand * 2 * angle / 3))
    first, second = (
        CornerFrame(point=point, normal=normal, along_u=edge) for edge in (along, beyond)
    )
    return {1: first, 2: second, 3: second}
