"""What a caller names in a complex: vertices, faces and sets of faces, checked to be there."""

from typing import TYPE_CHECKING, Any

import numpy as np

from discrete.complex_errors import FaceError, MemberError
from discrete.signed_graph import BoolArray, IntArray

if TYPE_CHECKING:
    from discrete.asymptotic_complex import AsymptoticComplex


def integers(values: Any, name: str) -> IntArray:
    """Array of the integers given; name: what to call them. Raises MemberError for other data."""
    try:
        found = np.array(values)
    except (ValueError, OverflowError) as error:
        raise MemberError(f"{name}: give integers, all rows of one length") from error
    if not np.issubdtype(found.dtype, np.integer):
        raise MemberError(f"{name} of type {found.dtype}: give integers")
    return found.astype(np.int64)


def whole_number(value: Any, name: str) -> int:
    """One integer. Raises MemberError, which tells what was given."""
    if not isinstance(value, int | np.integer) or isinstance(value, bool):
        raise MemberError(f"{name} is {value!r}: give an integer")
    return int(value)


def require_vertex(complex_: "AsymptoticComplex", vertex: Any) -> int:
    """Number of a vertex of the complex. Raises MemberError for any other value."""
    if not 0 <= (found := whole_number(vertex, "the vertex")) < complex_.vertex_count:
        raise MemberError(f"there is no vertex {found}: the last is {complex_.vertex_count - 1}")
    return found


def require_face(complex_: "AsymptoticComplex", face: Any) -> int:
    """Number of a face of the complex. Raises MemberError for any other value."""
    if not 0 <= (found := whole_number(face, "the face")) < len(complex_.faces):
        raise MemberError(f"there is no face {found}: the last is {len(complex_.faces) - 1}")
    return found


def require_faces(complex_: "AsymptoticComplex", chosen: Any) -> BoolArray:
    """Array that says of each face whether it is chosen. Raises FaceError for any other value."""
    found = np.asarray(chosen)
    if found.dtype != np.bool_ or found.shape != (len(complex_.faces),):
        raise FaceError(
            f"a choice of type {found.dtype} and shape {found.shape}: say True or False of each of "
            f"the {len(complex_.faces)} faces"
        )
    return found
