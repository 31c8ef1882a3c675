"""Sectors that fill a removed sector at a branch point (eq:trisect, 5.1.trisection).

The removed sector lies between a u-line and a v-line. The rays between its daughters are u- and
v-lines in turn, so that the torsion changes sign from each to the next.
"""

from typing import Any

import sympy as sp

from theory import amsler


def rays(daughters: int) -> str:
    """Families of the rays from the u-edge on, in the positive sense, one letter each."""
    return "".join("uv"[k % 2] for k in range(daughters + 1))


def closes(daughters: int) -> bool:
    """Whether the last ray is of the family of the v-edge, as it must be."""
    return rays(daughters)[-1] == "v"


def orientations(daughters: int) -> list[int]:
    """Orientation of (r_u, r_v) in each daughter against that of the parent."""
    names = rays(daughters)
    return [1 if names[k] == "u" else -1 for k in range(daughters)]


def slope_on_shared_edge(orientation: int, *, family: str) -> Any:
    """Slope of phi of a daughter along the edge that it takes from its parent, by the parent's p.

    family: `u` or `v`, that of the edge. The curve has one geodesic curvature on the surface, which
    each net gives by its own Christoffel symbols: orientation times that of `edge_curvatures`,
    whose normal follows the net.
    """
    phi = sp.Function("phi", positive=True)(amsler.U, amsler.V)
    parent, own = sp.symbols("p q", real=True)
    along_u, along_v = amsler.edge_curvatures(phi, sigma=1)
    curvature, place = (along_u, amsler.U) if family == "u" else (along_v, amsler.V)
    slope = sp.diff(phi, place)
    given = sp.simplify(curvature)
    shared = sp.expand(orientation * given.subs(slope, own) - given.subs(slope, parent))
    return sp.solve(shared, own)[0]
