"""NPZ of numpy: points, normals, places in the disk (complex), quads, and the fields by name."""

from typing import IO

import numpy as np

from checks.meshes.mesh import mesh_of
from discrete.greedy_net import GreedyNet


def write_npz(stream: IO[bytes], net: GreedyNet) -> None:
    """Write all arrays, those of the quads too; exact parameters as text.

    quads: vertices p, p_u, p_uv, p_v, so that the first edge is a u-edge, on either side round.
    """
    mesh, run = mesh_of(net), net.parameters
    np.savez(
        stream,
        allow_pickle=False,
        points=mesh.points,
        normals=mesh.normals,
        disk=net.disk,
        quads=net.quads,
        quad_angle=net.quad_angles,
        quad_generation=net.quad_generations,
        quad_sector=net.quad_sectors,
        parameters=np.array([str(run.radius), str(run.phi0), str(run.cutoff), str(run.step)]),
        **mesh.fields,
    )
