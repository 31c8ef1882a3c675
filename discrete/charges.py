r"""Charges of branch points: the exact balance of angles in a polygon of a hyperbolic net.

Let Gamma be a set of quads of an asymptotic complex, a face k of which has four corner angles whose
sum is 2 pi - A_k: with geodesic sides in curvature -1, A_k is its area. Let q_b be the number of
quads of Gamma, and Theta_b the sum of their angles, at a vertex b on its boundary; let the angles
around a vertex inside, of degree 2m, add up to 2 pi. Count the 4 F corners of its F quads,

    4 F = sum_inside 2 m + sum_b q_b,

and add up their angles,

    2 pi F - sum_k A_k = sum_inside 2 pi + sum_b Theta_b.

The difference, with a weight of pi/2 on the first line, is the balance of the charges,

    sum_b (pi q_b / 2 - Theta_b) = sum_k A_k - pi sum_inside (m - 2),

in which a branch point has the charge -pi (m - 2) and every other vertex inside none. The sum on
the left is over all vertices of the boundary. No geometry but the two sums of angles enters.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from discrete.complex_errors import AngleSumError
from discrete.hamburger import HamburgerPolygon
from discrete.index import Angles, angle_sums, require_straight_angle
from discrete.signed_graph import IntArray


@dataclass(frozen=True, kw_only=True)
class Charges:
    """Balance of a polygon: boundary = area + branching, in the unit of the angles.

    boundary: sum of pi q_b / 2 - Theta_b over its vertices; area: sum of 2 pi minus the angle sum
    over its quads; branching: -pi times the sum of m - 2 over the vertices inside.
    """

    boundary: Any
    area: Any
    branching: Any

    @property
    def residual(self) -> Any:
        """Boundary term minus area minus branching: 0, to within rounding."""
        return self.boundary - self.area - self.branching


def _total(values: Angles) -> Any:
    """Sum of an array of any numbers; of float64 pairwise, so that rounding stays small."""
    return values.sum() if values.dtype == np.float64 else sum(values.ravel().tolist())


def open_vertex(
    polygon: HamburgerPolygon, sums: Angles, *, straight_angle: Any, tolerance: float = 0.0
) -> int | None:
    """First vertex inside whose angles certainly do not add up to a full turn, or None."""
    for vertex in polygon.enclosed_vertices:
        if abs(sums[vertex] - 2 * straight_angle) > tolerance:
            return int(vertex)
    return None


def _inside(polygon: HamburgerPolygon, angles: Angles) -> Angles:
    """The angles, 0 on faces that are not enclosed, whose angles do not count."""
    if angles.shape != polygon.complex.faces.shape or not _adds(angles.dtype):
        raise AngleSumError(
            f"angles of type {angles.dtype} and shape {angles.shape}: give numbers of the shape "
            f"{polygon.complex.faces.shape}"
        )
    found: Angles = np.where(polygon.inside[:, np.newaxis], angles, 0)
    return found


def _adds(dtype: Any) -> bool:
    return bool(np.issubdtype(dtype, np.object_) or np.issubdtype(dtype, np.number))


def charges(
    polygon: HamburgerPolygon, angles: Angles, *, straight_angle: Any, tolerance: float = 0.0
) -> Charges:
    """Boundary term, area and branching of a polygon from the corner angles of its complex.

    angles: array (faces, 4) of float64 or of objects (Fraction, arb, sympy.Expr); straight_angle:
    pi in their unit and type; tolerance: allowed deviation of the sums inside from 2 pi. Raises
    AngleSumError naming a vertex whose angles do not add up; of balls it takes what may add up.
    """
    require_straight_angle(straight_angle, tolerance)
    angles = np.asarray(angles)
    sums = angle_sums(polygon.complex, _inside(polygon, angles))
    vertex = open_vertex(polygon, sums, straight_angle=straight_angle, tolerance=tolerance)
    if vertex is not None:
        raise AngleSumError(
            f"the angles at vertex {vertex} add up to {sums[vertex]}, not to two straight angles"
        )
    return _balance(polygon, angles, sums, straight_angle)


def _balance(polygon: HamburgerPolygon, angles: Angles, sums: Angles, pi: Any) -> Charges:
    on = polygon.path
    quads: list[int] = polygon.quads[on].tolist()
    # Halves of pi come from sums of integers, so that any type of number can be used.
    boundary = pi * sum(quads) / 2 - _total(sums[on])
    enclosed = angles[polygon.inside]
    area = 2 * len(enclosed) * pi - _total(enclosed)
    order: IntArray = polygon.complex.saddle_order[polygon.enclosed_vertices]
    return Charges(boundary=boundary, area=area, branching=-int((order - 2).sum()) * pi)
