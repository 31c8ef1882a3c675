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
#: Deviation of the length of a normal from 1 that rounding explains.
UNIT = 1e-8


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
    signs = _face_signs(complex_, orientation)
    normals = _unit_normals(complex_, normals)
    if not tolerance >= 0:
        raise NormalError(f"a tolerance of {tolerance}: give a number that is not negative")
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


def _face_signs(complex_: AsymptoticComplex, orientation: IntArray | None) -> IntArray:
    """Signs of the faces: those given, or those of the complex."""
    signs = complex_.orientation if orientation is None else np.asarray(orientation)
    if signs is None:
        raise NormalError("the complex is one-sided: no winding has a sign on it")
    if signs.shape != (len(complex_.faces),) or not np.isin(signs, (1, -1)).all():
        raise NormalError(f"an orientation of the shape {signs.shape}: give +1 or -1 for each face")
    return signs


def _unit_normals(complex_: AsymptoticComplex, normals: FloatArray) -> FloatArray:
    """Array of the normals; refuses what is no unit vector to each vertex."""
    found = np.asarray(normals)
    if not np.issubdtype(found.dtype, np.floating) or found.shape != (complex_.vertex_count, 3):
        raise NormalError(
            f"normals of type {found.dtype} and shape {found.shape}: give finite (vertices, 3)"
        )
    # Also where a length is NaN.
    wrong = np.flatnonzero(~(np.abs(np.linalg.norm(found, axis=1) - 1) <= UNIT))
    if len(wrong):
        vertex = int(wrong[0])
        raise NormalError(f"the normal {found[vertex].tolist()} at vertex {vertex} is no unit "
                          "vector: give finite normals of length 1")  # fmt: skip
    return found


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


def is_finite(number: Any) -> bool:
    """Whether it is a number (of any type) that is not known to be infinite or NaN."""
    if number is None or isinstance(number, str | bytes):
        return False
    if isinstance(number, float | np.floating):
        return isfinite(number)
    if not hasattr(number, "is_finite"):
        return bool(number - number == 0)  # of mpf or complex: false for NaN and infinities
    # A method of balls, a property (perhaps None, for unknown) of symbols.
    found = number.is_finite
    return (found() if callable(found) else found) is not False


def angle_sums(complex_: AsymptoticComplex, angles: Angles) -> Angles:
    """Sum of the corner angles at each vertex.

    angles: array (faces, 4), angle k of a face at its corner k; of float64, or of objects that add
    (Fraction, arb, sympy.Expr). Raises AngleSumError for another shape, a NaN or no number.
    """
    angles = np.asarray(angles)
    if angles.shape != complex_.faces.shape:
        raise AngleSumError(f"angles of the shape {angles.shape}: give {complex_.faces.shape}")
    fast = angles.dtype == np.float64
    finite = np.isfinite(angles) if fast else np.frompyfunc(is_finite, 1, 1)(angles).astype(bool)
    bad = np.flatnonzero(~finite)
    if len(bad):
        vertex = complex_.faces.ravel()[bad[0]]
        raise AngleSumError(f"the angle of face {bad[0] // 4} at vertex {vertex} is not finite")
    sums = np.zeros(complex_.vertex_count, dtype=angles.dtype)
    np.add.at(sums, complex_.faces, angles)
    return sums


def require_straight_angle(straight_angle: Any, tolerance: Any) -> None:
    """Refuse what is no angle to measure by: NaN, text, a tolerance that is negative or infinite.

    Raises AngleSumError.
    """
    if not is_finite(straight_angle):
        raise AngleSumError(f"the straight angle is {straight_angle!r}: give pi in its unit")
    if not is_finite(tolerance) or tolerance < 0:
        raise AngleSumError(f"a tolerance of {tolerance!r}: give a number that is not negative")


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
    require_straight_angle(straight_angle, tolerance)
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
