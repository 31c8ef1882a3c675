"""A net to a file, in the format that the name of the file says."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import IO, Any

from checks.errors import BadInput
from checks.files import replacing

FORMATS = ("ply", "obj", "stl", "glb", "vtk", "npz")


def require_format(name: str, known: tuple[str, ...] = FORMATS) -> str:
    """Extension of a file name; raises BadInput for one that is not known."""
    found = Path(name).suffix[1:].lower()
    if found not in known:
        raise BadInput(f"cannot write {name}: expected a name that ends in .{', .'.join(known)}")
    return found


def write_mesh(name: str, net: Any) -> None:
    """Write a discrete.greedy_net.GreedyNet whole or not at all; raises BadInput."""
    kind = require_format(name)
    from checks.meshes.glb import write_glb
    from checks.meshes.mesh import mesh_of
    from checks.meshes.npz import write_npz
    from checks.meshes.obj import write_obj
    from checks.meshes.ply import write_ply
    from checks.meshes.stl import write_stl
    from checks.meshes.vtk import write_vtk

    writers: Mapping[str, Callable[[IO[bytes], Any], None]] = {
        "ply": write_ply,
        "obj": write_obj,
        "stl": write_stl,
        "glb": write_glb,
        "vtk": write_vtk,
    }
    try:
        with replacing(Path(name).resolve()) as stream:
            if kind == "npz":
                write_npz(stream, net)
            else:
                writers[kind](stream, mesh_of(net))
    except OSError as error:
        raise BadInput(f"cannot write {name}: {error.strerror or error}") from error
