"""Frames of surfaces in space: a point, a unit normal and a unit direction in the tangent plane."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]


def turned(direction: FloatArray, normal: FloatArray, angle: FloatArray | float) -> FloatArray:
    """Directions (..., 3) turned counterclockwise about the normals, seen from their tips."""
    c, s = np.cos(angle)[..., np.newaxis], np.sin(angle)[..., np.newaxis]
    return np.asarray(c * direction + s * np.cross(normal, direction))


@dataclass(frozen=True, kw_only=True, eq=False)
class SpaceFrame:
    """Frame of a net at a vertex: arrays (3,) point, normal, and direction of its u-edge.

    side: +1 where the v-edge lies to the left of the u-edge, seen from the normal's tip, else -1.
    """

    point: FloatArray
    normal: FloatArray
    along_u: FloatArray
    side: int

    def along_v(self, angle: float) -> FloatArray:
        """Direction of the v-edge at this angle to the u-edge."""
        return turned(self.along_u, self.normal, np.float64(self.side * angle))


STANDARD = SpaceFrame(
    point=np.zeros(3),
    normal=np.array([0.0, 0.0, 1.0]),
    along_u=np.array([1.0, 0.0, 0.0]),
    side=1,
)
