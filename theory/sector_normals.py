"""Normals of a pseudospherical sector from its two bounding curves, by Picard iteration (float64).

The curves leave p, where N = e_3, in the directions of two angles, with geodesic curvatures that
are constant on equal panels; the u-curve has torsion -1, the v-curve +1. N solves
N(u, v) = N(u, 0) + N(0, v) - N(p) - integral of (N_u . N_v) N over [0, u] x [0, v].
"""

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

from theory.errors import UndecidedError

Array = NDArray[np.float64]


def curve_normals(
    angle: float, torsion: float, bending: Array, *, cells: int, step: float
) -> Array:
    """Normals at equal steps of a curve, by the exponential of its Frenet matrix."""
    c, s = np.cos(angle), np.sin(angle)
    frame = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    normals = [frame[2]]
    turns = [
        expm(step * np.array([[0, k, 0], [-k, 0, torsion], [0, -torsion, 0]])) for k in bending
    ]
    for i in range(cells):
        frame = turns[i * len(bending) // cells] @ frame
        normals.append(frame[2])
    return np.array(normals)


def sector_normals(
    angles: tuple[float, float], bend_u: Array, bend_v: Array, length: float, cells: int
) -> Array:
    """Normals at the nodes of a square grid of this side; rows along u, columns along v.

    angles: of the u-curve and of the v-curve at p. Of second order in the step. Raises
    UndecidedError where the iteration does not converge.
    """
    step = length / cells
    along_u = curve_normals(angles[0], -1.0, bend_u, cells=cells, step=step)
    along_v = curve_normals(angles[1], 1.0, bend_v, cells=cells, step=step)
    free: Array = along_u[:, None] + along_v[None, :] - along_u[0]
    normals = free
    for _ in range(200):
        a, b = np.diff(normals, axis=0), np.diff(normals, axis=1)
        product = np.sum((a[:, 1:] + a[:, :-1]) * (b[1:] + b[:-1]), axis=2) / 4
        middle = (normals[1:, 1:] + normals[1:, :-1] + normals[:-1, 1:] + normals[:-1, :-1]) / 4
        total = np.zeros_like(normals)
        total[1:, 1:] = np.cumsum(np.cumsum(-product[..., None] * middle, axis=0), axis=1)
        following: Array = free + total
        if np.max(np.abs(following - normals)) < 1e-13:
            return following
        normals = following
    raise UndecidedError("the iteration of the integral equation did not converge")
