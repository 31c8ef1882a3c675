"""K-surfaces by discrete Lelieuvre formulas from the Chebyshev net of their normals on S^2.

r_1 - r = N_1 x N along u-edges and r_2 - r = N x N_2 along v-edges (eq:d_lelieuvre). They close
around a quad exactly if (N_1 + N_2) x (N + N_12) = 0, which the half-turn rule grants.
"""

import math

import numpy as np
import numpy.typing as npt

from discrete import geodesics
from discrete.edge_lengths import spherical_length
from discrete.errors import NotFiniteError, ShapeError
from discrete.goursat_kernel import fill_nodes
from discrete.sector import Sector
from discrete.space_forms import S2, Triple
from discrete.space_frame import SpaceFrame

FloatArray = npt.NDArray[np.float64]


def walked(start: Triple, along: Triple, lengths: FloatArray, turns: FloatArray) -> FloatArray:
    """Polyline on S^2, an array (3, n + 1), that leaves `start` with the unit tangent `along`.

    lengths: of its n edges; turns: its n - 1 left turns.
    """
    points = [start]
    for k, length in enumerate(lengths.tolist()):
        if k:
            along = geodesics.turned_direction(S2, math, points[-1], along, turns[k - 1])
        points.append(geodesics.point_along(S2, math, points[-1], along, length))
        along = _carried(points[-2], points[-1])
    return np.array(points).T


def _carried(before: Triple, point: Triple) -> Triple:
    """Unit tangent at a point straight on from the one before."""
    back = geodesics.direction(S2, math, point, before)
    return (-back[0], -back[1], -back[2])


def sector_normals(sector: Sector, frame: SpaceFrame) -> FloatArray:
    """Normals of a sector, an array (3, n + 1, m + 1) filled by the half-turn rule.

    The normal moves at a right angle to the edge in space: to its left along u-edges, to its right
    along v-edges; so it turns as the edges do.
    """
    normal = frame.normal
    along_u = np.cross(normal, frame.along_u)
    along_v = -np.cross(normal, frame.along_v(sector.corner_angle))
    sides = [
        walked(
            tuple(normal.tolist()),
            tuple(along.tolist()),
            np.array([spherical_length(math, a) for a in lengths.tolist()]),
            turns,
        )
        for along, lengths, turns in (
            (along_u, sector.u_lengths, -frame.side * sector.u_turns),
            (along_v, sector.v_lengths, frame.side * sector.v_turns),
        )
    ]
    nodes = np.empty((3, *(n + 1 for n in sector.shape)))
    nodes[:, :, 0], nodes[:, 0, :] = sides
    fill_nodes(S2, nodes)
    return nodes


def _require_normals(normals: FloatArray) -> None:
    """Refuse what is no array (3, n + 1, m + 1) of finite numbers with one quad or more."""
    if normals.ndim != 3 or len(normals) != 3 or min(normals.shape[1:]) < 2:
        raise ShapeError(f"normals of the shape {normals.shape}: give (3, n + 1, m + 1), n, m > 0")
    if normals.dtype == object:  # exact scalars: symbols, balls, elements of a field
        return
    wrong = np.argwhere(~np.isfinite(normals).all(axis=0))
    if len(wrong):
        raise NotFiniteError(f"the normal at vertex ({wrong[0, 0]}, {wrong[0, 1]}) is not finite")


def positions(normals: FloatArray, point: FloatArray) -> FloatArray:
    """Positions (3, n + 1, m + 1) of a net with these normals; `point` is that of vertex (0, 0).

    Arrays of float64, or of objects that add and multiply exactly. Raises ShapeError,
    NotFiniteError naming the vertex.
    """
    _require_normals(normals)
    found = np.empty_like(normals)
    found[:, 0, 0] = point
    first = normals[:, :, 0]
    along_u = np.cross(first[:, 1:], first[:, :-1], axis=0)
    found[:, 1:, 0] = point[:, np.newaxis] + np.cumsum(along_u, axis=1)
    along_v = np.cross(normals[:, :, :-1], normals[:, :, 1:], axis=0)
    found[:, :, 1:] = found[:, :, :1] + np.cumsum(along_v, axis=2)
    return found


def closure(normals: FloatArray) -> float:
    """Largest gap between both ways around a quad to its far vertex.

    Raises ShapeError, NotFiniteError naming the vertex.
    """
    _require_normals(normals)
    n, n1, n2, n12 = (
        normals[:, :-1, :-1],
        normals[:, 1:, :-1],
        normals[:, :-1, 1:],
        normals[:, 1:, 1:],
    )
    gap = np.cross(n1 + n2, n + n12, axis=0)
    return float(np.abs(gap).max())


def lelieuvre_surface(sector: Sector, frame: SpaceFrame) -> tuple[FloatArray, FloatArray]:
    """Positions and normals of a sector, arrays (3, n + 1, m + 1), with the frame at its apex."""
    normals = sector_normals(sector, frame)
    return positions(normals, frame.point), normals
