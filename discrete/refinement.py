"""Refinement of a complex: each rectangle divided into four."""

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex


def refined(complex_: AsymptoticComplex) -> AsymptoticComplex:
    """Complex with each face divided into four; the old vertices keep their numbers."""
    vertices, edges = complex_.vertex_count, len(complex_.edges)
    middle = vertices + complex_.sides.edge_of
    centre = vertices + edges + np.arange(len(complex_.faces))
    p, p_u, p_uv, p_v = complex_.faces.T
    parts = [
        (p, middle[:, 0], centre, middle[:, 3]),
        (p_u, middle[:, 0], centre, middle[:, 1]),
        (p_uv, middle[:, 2], centre, middle[:, 1]),
        (p_v, middle[:, 2], centre, middle[:, 3]),
    ]
    return AsymptoticComplex(faces=np.concatenate([np.stack(part, axis=1) for part in parts]))
