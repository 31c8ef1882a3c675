"""Unit normals of a surface in R^3 and the orientation that each of them induces."""

from dataclasses import dataclass
from typing import Any

import sympy as sp

from theory.vectors import Vector, added, cross, dot, scaled


@dataclass(frozen=True, kw_only=True)
class TangentPlane:
    """Tangent plane of the graph (x_1, x_2, w) at a point where w has any gradient.

    slope_1, slope_2: the partial derivatives of w, real symbols.
    """

    slope_1: sp.Symbol
    slope_2: sp.Symbol

    @property
    def basis(self) -> tuple[Vector, Vector]:
        """Tangent vectors of the coordinate lines of x_1 and x_2."""
        return (
            (sp.Integer(1), sp.Integer(0), self.slope_1),
            (sp.Integer(0), sp.Integer(1), self.slope_2),
        )

    def vector(self, a: Any, b: Any) -> Vector:
        """Tangent vector with these components in the basis."""
        first, second = self.basis
        return added(scaled(a, first), scaled(b, second))

    @property
    def upward_normal(self) -> Vector:
        """Unit vector perpendicular to the plane whose third component is positive."""
        length = sp.sqrt(1 + self.slope_1**2 + self.slope_2**2)
        return (-self.slope_1 / length, -self.slope_2 / length, 1 / length)


def generic_plane() -> TangentPlane:
    """Tangent plane of a graph with unknown gradient."""
    first, second = sp.symbols("w_1 w_2", real=True)
    return TangentPlane(slope_1=first, slope_2=second)


def density(value: Any, x: Vector, y: Vector, normal: Vector) -> Any:
    """Factor beta in omega(X, Y) = beta (X x Y).N, given omega(X, Y) for independent X, Y."""
    return value / dot(cross(x, y), normal)
