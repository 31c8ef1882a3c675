"""Wavefront OBJ: vertices, normals and quads; the format has no place for fields."""

from typing import IO

import numpy as np

from checks.meshes.mesh import Mesh


def write_obj(stream: IO[bytes], mesh: Mesh) -> None:
    """Write text that a double survives."""
    np.savetxt(stream, mesh.points, fmt="v %.17g %.17g %.17g")
    np.savetxt(stream, mesh.normals, fmt="vn %.9g %.9g %.9g")
    corners = np.repeat(mesh.quads + 1, 2, axis=1)
    np.savetxt(stream, corners, fmt="f %d//%d %d//%d %d//%d %d//%d")
