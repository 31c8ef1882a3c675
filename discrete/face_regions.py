"""Random disks made of faces of a complex, grown face by face from a seed."""

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.members import require_face
from discrete.signed_graph import BoolArray


def _keeps_a_disk(complex_: AsymptoticComplex, inside: BoolArray, on: BoolArray, face: int) -> bool:
    """Whether a face meets the disk in one path of edges, so that their union is a disk again."""
    across = complex_.neighbour[face] // 4
    shared = int(inside[across[across >= 0]].sum())
    return shared >= 1 and int(on[complex_.faces[face]].sum()) - shared == 1


def grown_disk(
    complex_: AsymptoticComplex, start: int, size: int, rng: np.random.Generator
) -> BoolArray:
    """Faces of a random disk that contains a face: at most size of them, fewer if none fits.

    The complex is a disk; each step adds a face that meets the union in one path of edges.
    """
    inside = np.zeros(len(complex_.faces), dtype=np.bool_)
    on = np.zeros(complex_.vertex_count, dtype=np.bool_)
    rim = {require_face(complex_, start)}
    for _ in range(size):
        order = [int(f) for f in rng.permutation(sorted(rim))]
        fitting = (f for f in order if not inside.any() or _keeps_a_disk(complex_, inside, on, f))
        if (face := next(fitting, None)) is None:
            break
        inside[face] = True
        on[complex_.faces[face]] = True
        rim.discard(face)
        across = complex_.neighbour[face] // 4
        rim |= {int(f) for f in across[across >= 0] if not inside[f]}
    return inside
