"""Asymptotic coordinates of the faces of a complex, and the attaching maps between them."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isfinite

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import GluingError, MemberError
from discrete.members import require_face

Point = tuple[Fraction, Fraction]


@dataclass(frozen=True, kw_only=True, eq=False)
class FaceCoordinates:
    """Rectangles [0, u_k] x [0, v_k] of the faces, equal along common edges (def:A-complex).

    The corners p, p_u, p_uv, p_v of face k are (0, 0), (u_k, 0), (u_k, v_k), (0, v_k). Raises
    GluingError for a side that is not positive, or of different lengths in two faces.
    """

    complex: AsymptoticComplex
    sizes: Sequence[Point]

    def __post_init__(self) -> None:
        if len(self.sizes) != len(self.complex.faces):
            raise GluingError(f"{len(self.sizes)} sizes for {len(self.complex.faces)} faces")
        for face, size in enumerate(self.sizes):
            if len(size) != 2:
                raise GluingError(f"face {face} has {len(size)} sides: give u_k and v_k")
            u, v = size
            if not (u > 0 and v > 0 and isfinite(u) and isfinite(v)):
                raise GluingError(f"face {face} has the sides {u} and {v}: give positive numbers")
        for one, other in self.complex.sides.matched.tolist():
            first, second = (self.sizes[s // 4][s % 2] for s in (one, other))
            if first != second:
                raise GluingError(
                    f"faces {one // 4} and {other // 4} have a common edge of the lengths "
                    f"{first} and {second}"
                )

    def corner(self, face: int, corner: int) -> Point:
        """Coordinates of a corner of a face."""
        u, v = self.sizes[require_face(self.complex, face)]
        if corner not in range(4):
            raise MemberError(f"a face has no corner {corner}: they are 0 to 3")
        zero = Fraction(0)
        return ((zero, zero), (u, zero), (u, v), (zero, v))[corner]

    def on_edge(self, face: int, ends: tuple[int, int], part: Fraction) -> Point:
        """Coordinates in a face of the point that divides one of its edges in this proportion.

        ends: the vertices from which and to which the proportion counts.
        """
        corners = self.complex.faces[require_face(self.complex, face)].tolist()
        if absent := [end for end in ends if end not in corners]:
            raise MemberError(f"vertex {absent[0]} is no corner of face {face}: {corners}")
        places = [corners.index(end) for end in ends]
        start, end = (self.corner(face, place) for place in places)
        return (
            start[0] + part * (end[0] - start[0]),
            start[1] + part * (end[1] - start[1]),
        )
