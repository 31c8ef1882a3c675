"""Quads of a greedy net: their edges, and their angles at each corner in space."""

from typing import Any

import numpy as np
import numpy.typing as npt

from discrete.greedy_net import GreedyNet

Integers = npt.NDArray[np.int64]


def edges_of(quads: Integers) -> tuple[Integers, Integers]:
    """Edges (E, 2) of quads (Q, 4), and the number of quads at each."""
    sides = np.concatenate([quads[:, [k, (k + 1) % 4]] for k in range(4)])
    edges, count = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
    return edges, count


def space_angles(net: GreedyNet, k: int) -> Any:
    """Angle in space at corner k of each quad, in radians."""
    corners = net.points[net.quads]
    a = corners[:, k - 1] - corners[:, k]
    b = corners[:, (k + 1) % 4] - corners[:, k]
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.einsum("ij,ij->i", a, b))
