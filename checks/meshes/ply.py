"""Binary PLY with the quads as they are and the fields as properties of the vertices."""

from typing import IO

import numpy as np

from checks.meshes.mesh import Mesh


def write_ply(stream: IO[bytes], mesh: Mesh) -> None:
    """Write vertices (double), normals (float), fields (float or int) and quads."""
    columns = [(name, "<f8", mesh.points[:, k]) for k, name in enumerate("xyz")]
    columns += [(f"n{name}", "<f4", mesh.normals[:, k]) for k, name in enumerate("xyz")]
    for name, values in mesh.fields.items():
        kind = "<i4" if np.issubdtype(values.dtype, np.integer) else "<f4"
        columns.append((name, kind, values))
    vertices = np.empty(len(mesh.points), dtype=[(name, kind) for name, kind, _ in columns])
    for name, _, values in columns:
        vertices[name] = values
    faces = np.empty(len(mesh.quads), dtype=[("count", "u1"), ("at", "<i4", 4)])
    faces["count"], faces["at"] = 4, mesh.quads
    named = {"<f8": "double", "<f4": "float", "<i4": "int"}
    lines = [
        *("ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"),
        *(f"property {named[kind]} {name}" for name, kind, _ in columns),
        *(f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"),
    ]
    stream.write(("\n".join(lines) + "\n").encode("ascii"))
    stream.write(vertices.tobytes())
    stream.write(faces.tobytes())
