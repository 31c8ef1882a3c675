"""Frames of surfaces in space: a point, a unit normal and a unit direction in the tangent plane."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from discrete.errors import NotFiniteError, ShapeError

FloatArray = npt.NDArray[np.float64]
#: Deviation of the inner products of a frame's axes that rounding along a large net explains.
ORTHONORMAL = 1e-6


def turned(direction: FloatArray, normal: FloatArray, angle: FloatArray | float) -> FloatArray:
    """Directions (..., 3) turned counterclockwise about the normals, seen from their tips."""
    c, s = np.cos(angle)[..., np.newaxis], np.sin(angle)[..., np.newaxis]
    return np.asarray(c * direction + s * np.cross(normal, direction))


@dataclass(frozen=True, kw_only=True, eq=False)
class SpaceFrame:
    """Frame of a net at a vertex: arrays (3,) point, normal, and direction of its u-edge.

    side: +1 where the v-edge lies to the left of the u-edge, seen from the normal's tip, else -1.
    Raises NotFiniteError, or ShapeError where normal and direction are not orthonormal to within
    ORTHONORMAL or side is no sign.
    """

    point: FloatArray
    normal: FloatArray
    along_u: FloatArray
    side: int

    def __post_init__(self) -> None:
        for name in ("point", "normal", "along_u"):
            found = np.asarray(getattr(self, name))
            if found.shape != (3,) or not np.issubdtype(found.dtype, np.number):
                raise ShapeError(f"{name} has the type {found.dtype} and the shape {found.shape}: "
                                 "give three numbers")  # fmt: skip
            if not np.isfinite(found).all():
                raise NotFiniteError(f"{name} of a frame is not finite: {found.tolist()}")
        axes = np.stack([self.normal, self.along_u])
        if np.abs(axes @ axes.T - np.eye(2)).max() > ORTHONORMAL:
            raise ShapeError(f"the normal {self.normal} and the direction {self.along_u} are not "
                             "orthonormal")  # fmt: skip
        if self.side not in (1, -1):
            raise ShapeError(f"the side is {self.side}: give +1 or -1")

    def along_v(self, angle: float) -> FloatArray:
        """Direction of the v-edge at this angle to the u-edge."""
        return turned(self.along_u, self.normal, np.float64(self.side * angle))


STANDARD = SpaceFrame(
    point=np.zeros(3),
    normal=np.array([0.0, 0.0, 1.0]),
    along_u=np.array([1.0, 0.0, 0.0]),
    side=1,
)
