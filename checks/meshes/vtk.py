"""Legacy VTK, binary: quads as polygons, fields and normals at the points."""

from typing import IO

import numpy as np

from checks.meshes.mesh import Mesh


def write_vtk(stream: IO[bytes], mesh: Mesh) -> None:
    """Write PolyData; numbers are big-endian, as the format asks."""
    count, faces = len(mesh.points), len(mesh.quads)

    def block(header: str, values: object, kind: str) -> None:
        stream.write(header.encode("ascii") + b"\n")
        stream.write(np.ascontiguousarray(values, dtype=kind).tobytes() + b"\n")

    stream.write(b"# vtk DataFile Version 3.0\nsurface of curvature -1\nBINARY\nDATASET POLYDATA\n")
    block(f"POINTS {count} double", mesh.points, ">f8")
    polygons = np.hstack([np.full((faces, 1), 4), mesh.quads])
    block(f"POLYGONS {faces} {5 * faces}", polygons, ">i4")
    stream.write(f"POINT_DATA {count}\n".encode("ascii"))
    block("NORMALS normals double", mesh.normals, ">f8")
    for name, values in mesh.fields.items():
        whole = np.issubdtype(values.dtype, np.integer)
        header = f"SCALARS {name} {'int' if whole else 'double'} 1\nLOOKUP_TABLE default"
        block(header, values, ">i4" if whole else ">f8")
