"""Binary glTF 2.0: triangles with normals, colours by curvature, and the fields as attributes."""

import json
from typing import IO, Any

import numpy as np

from checks.meshes.mesh import Mesh

FLOAT, UNSIGNED = 5126, 5125
ARRAY, ELEMENTS = 34962, 34963
SHAPES = {1: "SCALAR", 3: "VEC3"}


def colours(curvature: Any) -> Any:
    """Colours (V, 3) from pale blue at curvature 1 to dark red at the largest, by its logarithm."""
    share = np.log(np.maximum(curvature, 1))
    share = (share / max(share.max(), 1e-12))[:, np.newaxis]
    return (1 - share) * np.array([0.75, 0.87, 0.95]) + share * np.array([0.45, 0.02, 0.10])


def _chunk(kind: bytes, data: bytes, fill: bytes) -> bytes:
    data += fill * (-len(data) % 4)
    return len(data).to_bytes(4, "little") + kind + data


def write_glb(stream: IO[bytes], mesh: Mesh) -> None:
    """Write one mesh; fields are the attributes _ANGLE, _MAX_CURVATURE, _GENERATION, _SECTOR."""
    attributes = {
        "POSITION": mesh.points,
        "NORMAL": mesh.normals / np.linalg.norm(mesh.normals, axis=1, keepdims=True),
        "COLOR_0": colours(mesh.fields["max_curvature"]),
        **{f"_{name.upper()}": values for name, values in mesh.fields.items()},
    }
    arrays = [np.ascontiguousarray(values, dtype="<f4") for values in attributes.values()]
    indices = mesh.triangles().astype("<u4").ravel()
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    start = 0
    for array in [*arrays, indices]:
        of_vertices = array is not indices
        views.append(
            {
                "buffer": 0,
                "byteOffset": start,
                "byteLength": array.nbytes,
                "target": ARRAY if of_vertices else ELEMENTS,
            }
        )
        accessors.append(_accessor(len(accessors), array, of_vertices))
        start += array.nbytes
    last = len(arrays)
    primitive = {
        "attributes": {name: k for k, name in enumerate(attributes)},
        "indices": last,
        "mode": 4,
        "material": 0,
    }
    scene = {
        "asset": {"version": "2.0", "generator": "kminusone"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [primitive]}],
        "materials": [{"doubleSided": True, "pbrMetallicRoughness": {"metallicFactor": 0.0}}],
        "buffers": [{"byteLength": start}],
        "bufferViews": views,
        "accessors": accessors,
    }
    body = _chunk(b"JSON", json.dumps(scene).encode("ascii"), b" ")
    body += _chunk(b"BIN\0", b"".join(array.tobytes() for array in [*arrays, indices]), b"\0")
    stream.write(b"glTF" + np.array([2, 12 + len(body)], dtype="<u4").tobytes() + body)


def _accessor(view: int, array: Any, of_vertices: bool) -> dict[str, Any]:
    """Entry for one array; the format asks for the extremes of the positions."""
    width = 1 if array.ndim == 1 else array.shape[1]
    found: dict[str, Any] = {
        "bufferView": view,
        "componentType": FLOAT if of_vertices else UNSIGNED,
        "count": len(array),
        "type": SHAPES[width],
    }
    if view == 0:
        found["min"] = array.min(axis=0).astype(float).tolist()
        found["max"] = array.max(axis=0).astype(float).tolist()
    return found
