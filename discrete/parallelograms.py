"""Angles of a Chebyshev parallelogram: sides a, b, and at its vertices the angles A, B, A, B.

The triangle with the sides a, b and the angle A between them has two angles of sum B, so that
Napier's analogy gives tan(A/2) tan(B/2) = (1 - q)/(1 + q), with q = tanh(a/2) tanh(b/2) on H^2 and
q = -tan(a/2) tan(b/2) on S^2; for a rhombus 1/cosh a and 1/cos a. Hence B = pi - A - D, where
D = 2 arctan(q sin A/(1 - q cos A)) = 2 arg(1 - q e^(-iA)), odd and 2 pi-periodic in A, is half the
area of the quad times -K. No term cancels where the edges or the angle are small.
"""

from typing import Any

from discrete.space_forms import Scalar, SpaceForm


def side_product(space: SpaceForm, functions: Any, a: Scalar, b: Scalar) -> Scalar:
    """Number q of the sides a and b; |q| < 1 for all sides on H^2, for a + b < pi on S^2."""
    return -space.curvature * space.tangent(functions, a / 2) * space.tangent(functions, b / 2)


def half_defect(functions: Any, q: Scalar, angle: Scalar) -> Scalar:
    """Angle D = pi - A - B by which two neighbouring angles of the quad miss pi; |q| < 1."""
    return 2 * functions.atan(q * functions.sin(angle) / (1 - q * functions.cos(angle)))


def neighbour_angle(functions: Any, q: Scalar, angle: Scalar) -> Scalar:
    """Angle B of the quad beside the angle A; signed where A is: a flipped quad has A < 0."""
    return functions.pi - angle - half_defect(functions, q, angle)


def quad_area(space: SpaceForm, functions: Any, q: Scalar, angle: Scalar) -> Scalar:
    """Signed area of the quad with the angle A, by Gauss-Bonnet."""
    return -space.curvature * 2 * half_defect(functions, q, angle)
