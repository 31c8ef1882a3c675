"""K-surfaces from the lengths and angles of a hyperbolic net: planar vertex stars, moved along.

At each vertex the edges lie in the tangent plane at the angles of the net on H^2; along a u-edge
the normal turns about the edge by -s, along a v-edge by +s, s the Gudermannian of its length.
"""

import numpy as np
import numpy.typing as npt

from discrete.sector import Sector
from discrete.space_frame import SpaceFrame, turned

FloatArray = npt.NDArray[np.float64]


def _moved(
    point: FloatArray, normal: FloatArray, along: FloatArray, length: FloatArray, twist: int
) -> tuple[FloatArray, FloatArray]:
    """Points and normals at the other ends of the edges; arrays (..., 3), lengths on H^2."""
    d = np.tanh(length)[..., np.newaxis]
    cosine = 1 / np.cosh(length)[..., np.newaxis]
    return point + d * along, cosine * normal + twist * d * np.cross(along, normal)


def star_surface(sector: Sector, frame: SpaceFrame) -> tuple[FloatArray, FloatArray]:
    """Positions and normals of a sector, arrays (3, n + 1, m + 1), with the frame at its apex."""
    n, m = sector.shape
    points, normals = (np.empty((n + 1, m + 1, 3)) for _ in range(2))
    along = np.empty((n + 1, 3))
    points[0, 0], normals[0, 0], along[0] = frame.point, frame.normal, frame.along_u
    for i in range(n):
        if i:
            turn = np.float64(-frame.side * sector.u_turns[i - 1])
            along[i] = turned(along[i - 1], normals[i, 0], turn)
        points[i + 1, 0], normals[i + 1, 0] = _moved(
            points[i, 0], normals[i, 0], along[i], sector.u_lengths[i], -1
        )
    along[n] = along[n - 1]
    for j in range(m):
        _advance_row(sector, frame.side, points, normals, along, j)
    return np.moveaxis(points, 2, 0), np.moveaxis(normals, 2, 0)


def _advance_row(
    sector: Sector, side: int, points: FloatArray, normals: FloatArray, along: FloatArray, j: int
) -> None:
    """Fill row j + 1 from row j, and turn the directions of the u-edges into those of row j + 1.

    The last vertex of a row has no u-edge onwards: there the direction is that of arrival, and its
    angle to the v-edge is pi - B = A + D.
    """
    a, b = sector.angles[:, j], sector.other_angles[:, j]
    before, after = np.append(a, np.pi - b[-1]), np.append(np.pi - b, a[-1])
    along_v = turned(along, normals[:, j], side * before)
    points[:, j + 1], normals[:, j + 1] = _moved(
        points[:, j], normals[:, j], along_v, sector.v_lengths[j], 1
    )
    along[:] = turned(along_v, normals[:, j + 1], -side * after)
