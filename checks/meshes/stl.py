"""Binary STL: triangles with their normals, single precision, as slicers read it."""

from typing import IO

import numpy as np

from checks.meshes.mesh import Mesh


def write_stl(stream: IO[bytes], mesh: Mesh) -> None:
    """Write the triangles; the format has no place for shared vertices or fields."""
    triangles = mesh.triangles()
    corners = mesh.points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    facets = np.zeros(
        len(triangles), dtype=[("normal", "<f4", 3), ("at", "<f4", (3, 3)), ("rest", "<u2")]
    )
    facets["normal"], facets["at"] = normals, corners
    stream.write(b"surface of curvature -1".ljust(80))
    stream.write(np.uint32(len(facets)).astype("<u4").tobytes())
    stream.write(facets.tobytes())
