"""K-surfaces in space of branched hyperbolic nets, sector by sector (eq:d_lelieuvre, K-surface)."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.branched_net import BranchedNet, Placed
from discrete.errors import NotFiniteError
from discrete.lelieuvre import lelieuvre_surface
from discrete.sector import Sector
from discrete.space_frame import STANDARD, SpaceFrame, turned

FloatArray = npt.NDArray[np.float64]
#: Positions and normals (3, n + 1, m + 1) of a sector with a frame at its apex.
Route = Callable[[Sector, SpaceFrame], tuple[FloatArray, FloatArray]]


@dataclass(frozen=True, kw_only=True, eq=False)
class KSurface:
    """Discrete K-surface: arrays (vertices, 3) of points and unit normals on a complex.

    mismatch: the largest distance between the two places that neighbouring sectors give to a
    vertex of their common line, as far as it was computed by both.
    """

    complex: AsymptoticComplex
    points: FloatArray
    normals: FloatArray
    mismatch: float

    def edge_vectors(self) -> FloatArray:
        """Vectors along the edges of the complex: an array (edges, 3)."""
        ends = self.complex.edges
        return np.asarray(self.points[ends[:, 1]] - self.points[ends[:, 0]])


def k_surface(
    net: BranchedNet, *, route: Route = lelieuvre_surface, frame: SpaceFrame = STANDARD
) -> KSurface:
    """Surface of a net, by one of the routes lelieuvre_surface, star_surface, sym_surface.

    frame: point and normal at the apex of sector 0, and the direction from which bearings count.
    Raises NotFiniteError naming a vertex where a route has lost all digits.
    """
    count = net.complex.vertex_count
    points, normals = np.full((count, 3), np.nan), np.full((count, 3), np.nan)
    mismatch = 0.0
    grids: list[tuple[FloatArray, FloatArray]] = []
    for placed, place in zip(net.placed, net.places, strict=True):
        found = route(placed.sector, _apex_frame(placed, grids, frame))
        grids.append(found)
        kept = place >= 0
        at, r, n = place[kept], found[0][:, kept].T, found[1][:, kept].T
        gap = np.linalg.norm(points[at] - r, axis=1)
        mismatch = max(mismatch, float(np.nanmax(gap, initial=0.0)))
        points[at], normals[at] = r, n
    _refuse_nan(points, normals)
    return KSurface(complex=net.complex, points=points, normals=normals, mismatch=mismatch)


def _refuse_nan(points: FloatArray, normals: FloatArray) -> None:
    wrong = np.flatnonzero(~np.isfinite(points + normals).all(axis=1))
    if len(wrong):
        raise NotFiniteError(f"vertex {wrong[0]} has no finite point and normal: shorten the edges")


def _apex_frame(
    placed: Placed, grids: list[tuple[FloatArray, FloatArray]], frame: SpaceFrame
) -> SpaceFrame:
    """Frame at the apex of a sector, from the surface of its parent."""
    if placed.parent < 0:
        point, normal, along = frame.point, frame.normal, frame.along_u
    else:
        points, normals = grids[placed.parent]
        i, j = placed.apex
        point, normal = points[:, i, j], normals[:, i, j]
        along = points[:, i + 1, j] - point
        along = along / np.linalg.norm(along)
    own = turned(along, normal, np.float64(placed.bearing))
    return SpaceFrame(point=point, normal=normal, along_u=own, side=placed.side)
