"""Mesh to be written: vertices and quads of a surface, with fields at its vertices."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from discrete.greedy_net import GreedyNet


@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh:
    """Arrays points, normals (V, 3) of float64, quads (Q, 4), and fields by name, each (V,)."""

    points: Any
    normals: Any
    quads: Any
    fields: Mapping[str, Any]

    def triangles(self) -> Any:
        """Triangles (2 Q, 3): each quad split along its shorter diagonal."""
        p = self.points[self.quads]
        first = np.linalg.norm(p[:, 0] - p[:, 2], axis=1)
        second = np.linalg.norm(p[:, 1] - p[:, 3], axis=1)
        shift = (first > second).astype(int)[:, np.newaxis]
        turned = np.take_along_axis(self.quads, (np.arange(4) + shift) % 4, axis=1)
        return np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]])


def outward(net: GreedyNet) -> Any:
    """Quads with their vertices counterclockwise around the normals."""
    p = net.points[net.quads]
    faces = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    against = np.einsum("ij,ij->i", faces, net.normals[net.quads[:, 0]]) < 0
    quads = net.quads.copy()
    quads[against] = quads[against][:, ::-1]
    return quads


def mesh_of(net: GreedyNet) -> Mesh:
    """Mesh of the K-surface, all normals on one side, with angle, curvature, generation, sector."""
    return Mesh(
        points=net.points,
        normals=net.normals,
        quads=outward(net),
        fields={
            "angle": net.vertex_angles,
            "max_curvature": net.vertex_curvatures,
            "generation": net.first_quad(net.quad_generations),
            "sector": net.first_quad(net.quad_sectors),
        },
    )
