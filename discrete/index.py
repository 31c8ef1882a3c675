"""Index at the vertices of a complex: order of saddleness, winding of the normal, angle sums."""

from math import isfinite
from typing import Any

import numpy as np
import numpy.typing as npt

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import AngleSumError, NormalError, UndecidedError
from discrete.signed_graph import IntArray

FloatArray = npt.NDArray[np.float64]
Angles = npt.NDArray[Any]


def interior_vertices(complex_: AsymptoticComplex) -> IntArray:
    """Vertices that are not on the boundary."""
    return np.flatnonzero(~complex_.is_boundary)


def ramification_index(complex_: AsymptoticComplex) -> IntArray:
    """Index J = 1 - m at each interior vertex, from its degree 2m (lem:covering-number)."""
    return np.asarray(1 - complex_.saddle_order[interior_vertices(complex_)])


def _turns(at: FloatArray, one: FloatArray, other: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Sine and cosine parts of the angle from one to another normal, seen from a third."""
    sine = np.einsum("ni,ni->n", at, np.cross(one, other))
    dot = np.einsum("ni,ni->n", one, other)
    return sine, dot - np.einsum("ni,ni->n", at, one) * np.einsum("ni,ni->n", at, other)


def normal_winding(
    complex_: AsymptoticComplex,
    normals: FloatArray,
    *,
    orientation: IntArray | None = None,
    tolerance: float = 1e-12,
) -> IntArray:
    """Times that the normals of the neighbours wind around that of each interior vertex (def:Jp).

    normals: unit vectors (vertices, 3); orientation: sign of each face, +1 where p, p_u, p_uv, p_v
    is counterclockwise seen from the normal's side, that of the complex by default. The step from
    each neighbour to the next is below half a turn. Raises NormalError where a step or a direction
    is undecided to within the tolerance.
    """
    signs = complex_.orientation if orientation is None else orientation
    if signs is None:
        raise NormalError("the complex is one-sided: no winding has a sign on it")
    if normals.shape != (complex_.vertex_count, 3) or not np.isfinite(normals).all():
        raise NormalError(f"normals of the shape {normals.shape}: give finite (vertices, 3)")
    at, following = complex_.faces, np.roll(complex_.faces, -1, axis=1)
    before = np.roll(complex_.faces, 1, axis=1)
    flip = (signs < 0)[:, np.newaxis]
    one, other = np.where(flip, before, following), np.where(flip, following, before)
    inside = ~complex_.is_boundary[at].ravel()
    at, one, other = (a.ravel()[inside] for a in (at, one, other))
    sine, cosine = _turns(normals[at], normals[one], normals[other])
    _refuse_undecided(at, one, other, normals, sine, cosine, tolerance)
    turns = np.bincount(at, weights=np.arctan2(sine, cosine), minlength=complex_.vertex_count)
    return np.rint(turns[interior_vertices(complex_)] / (2 * np.pi)).astype(np.int64)


def _refuse_undecided(
    at: IntArray,
    one: IntArray,
    other: IntArray,
    normals: FloatArray,
    sine: FloatArray,
    cosine: FloatArray,
    tolerance: float,
) -> None:
    off_axis = np.linalg.norm(np.cross(normals[at], normals[one]), axis=1)
    if len(found := np.flatnonzero(off_axis <= tolerance)):
        p, q = at[found[0]], one[found[0]]
        raise NormalError(f"the normals at the vertices {p} and {q} are the same or antipodal")
    half_turn = (np.abs(sine) <= tolerance * np.abs(cosine)) & (cosine < 0)
    if len(found := np.flatnonzero(half_turn)):
        p, q, r = at[found[0]], one[found[0]], other[found[0]]
        raise NormalError(f"from vertex {q} to {r} the normal makes half a turn around {p}")


def _finite(number: Any) -> bool:
    if isinstance(number, float):
        return isfinite(number)
    # A method of balls, a property (perhaps None, for unknown) of symbols.
    found = getattr(number, "is_finite", True)
    return (found() if callable(found) else found) is not False


def angle_sums(complex_: AsymptoticComplex, angles: Angles) -> Angles:
    """Sum of the corner angles at each vertex.

    angles: array (faces, 4), angle k of a face at its corner k; of float64, or of objects that add
    (Fraction, arb, sympy.Expr). Raises AngleSumError for another shape or a NaN.
    """
    if angles.shape != complex_.faces.shape:
        raise AngleSumError(f"angles of the shape {angles.shape}: give {complex_.faces.shape}")
    fast = angles.dtype == np.float64
    finite = np.isfinite(angles) if fast else np.frompyfunc(_finite, 1, 1)(angles).astype(np.bool_)
    bad = np.flatnonzero(~finite)
    if len(bad):
        vertex = complex_.faces.ravel()[bad[0]]
        raise AngleSumError(f"the angle of face {bad[0] // 4} at vertex {vertex} is not finite")
    sums = np.zeros(complex_.vertex_count, dtype=angles.dtype)
    np.add.at(sums, complex_.faces, angles)
    return sums


def _below(one: Any, other: Any, vertex: int) -> bool:
    """Whether one number is below another; raises UndecidedError where balls do not tell."""
    if one < other:
        return True
    if one >= other:
        return False
    raise UndecidedError(f"the angle sum at vertex {vertex} is not decided: take more bits")


def ramified_vertex(
    complex_: AsymptoticComplex, angles: Angles, *, straight_angle: Any, tolerance: Any = 0
) -> int | None:
    """First vertex at which the negative angles of a spherical net break (eq:unramified), or None.

    Inside they add up to 2 pi (1 - m) to within the tolerance; at a boundary vertex of degree d
    their sum is between (1 - d) pi and the lesser of (3 - d) pi and 0.
    straight_angle: pi in the unit of the angles. Raises UndecidedError naming the vertex where a
    ball is too wide.
    """
    sums = angle_sums(complex_, angles)
    for vertex in range(complex_.vertex_count):
        degree, total = int(complex_.degree[vertex]), sums[vertex]
        if not complex_.is_boundary[vertex]:
            fine = not _below(tolerance, abs(total - (2 - degree) * straight_angle), vertex)
        else:
            bounds = (0, (3 - degree) * straight_angle)
            fine = _below((1 - degree) * straight_angle, total, vertex) and all(
                _below(total, bound, vertex) for bound in bounds
            )
        if not fine:
            return vertex
    return None
