"""Derivatives of the moving basis (r_u, r_v, N) of a surface, from its two fundamental forms.

A vector field along the surface is the triple of its coefficients in (r_u, r_v, N). The tangential
derivatives follow from the metric by the product rule, the normal ones from the second form
(Gauss), those of N from its unit length (Weingarten); the surface itself is never integrated.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from theory.vectors import Vector


@dataclass(frozen=True, kw_only=True)
class GaussWeingarten:
    """Vector calculus in the moving basis of a surface with given fundamental forms.

    u, v: symbols; E, F, G: r_u.r_u, r_u.r_v, r_v.r_v; e, f, g: N.r_uu, N.r_uv, N.r_vv;
    area: (r_u x r_v).N, of either sign, with area^2 = EG - F^2. Undefined where area is 0.
    Derivatives commute only where the forms satisfy the equations of Gauss and Codazzi.
    """

    u: sp.Symbol
    v: sp.Symbol
    E: Any
    F: Any
    G: Any
    e: Any
    f: Any
    g: Any
    area: Any

    def dot(self, a: Vector, b: Vector) -> Any:
        """Inner product of two coefficient triples."""
        tangential = a[0] * b[0] * self.E + a[1] * b[1] * self.G
        mixed = (a[0] * b[1] + a[1] * b[0]) * self.F
        return tangential + mixed + a[2] * b[2]

    def cross(self, a: Vector, b: Vector) -> Vector:
        """Cross product of two coefficient triples, from r_u x r_v = area N and N.N = 1."""
        uv = a[0] * b[1] - a[1] * b[0]
        vn = (a[1] * b[2] - a[2] * b[1]) / self.area
        nu = (a[2] * b[0] - a[0] * b[2]) / self.area
        return (self.G * vn - self.F * nu, self.E * nu - self.F * vn, self.area * uv)

    def reduced(self, expr: Any) -> Any:
        """Scalar field, as it is."""
        return expr

    def rate(self, scalar: Any, along: str) -> Any:
        """Partial derivative of a scalar field along "u" or "v"."""
        return sp.sympify(scalar).diff(self._symbol(along))

    def derivative(self, a: Vector, along: str) -> Vector:
        """Partial derivative of a coefficient triple along "u" or "v"."""
        rows = self.matrices[along]
        own = tuple(self.rate(entry, along) for entry in a)
        turned = tuple(sum(a[i] * rows[i][j] for i in range(3)) for j in range(3))
        return (own[0] + turned[0], own[1] + turned[1], own[2] + turned[2])

    @cached_property
    def matrices(self) -> dict[str, tuple[Vector, Vector, Vector]]:
        """Rows are the derivatives of r_u, r_v, N along "u" and along "v"."""
        E, F, G = (sp.sympify(entry) for entry in (self.E, self.F, self.G))
        half = sp.Rational(1, 2)
        uu = (E.diff(self.u) * half, F.diff(self.u) - E.diff(self.v) * half)
        uv = (E.diff(self.v) * half, G.diff(self.u) * half)
        vv = (F.diff(self.v) - G.diff(self.u) * half, G.diff(self.v) * half)
        r_uu = (*self._raised(uu), self.e)
        r_uv = (*self._raised(uv), self.f)
        r_vv = (*self._raised(vv), self.g)
        n_u = (*self._raised((-self.e, -self.f)), sp.Integer(0))
        n_v = (*self._raised((-self.f, -self.g)), sp.Integer(0))
        return {"u": (r_uu, r_uv, n_u), "v": (r_uv, r_vv, n_v)}

    def _raised(self, products: tuple[Any, Any]) -> tuple[Any, Any]:
        """Coefficients of the tangent vector with these inner products with r_u and r_v."""
        a, b = products
        square = self.area**2
        return (self.G * a - self.F * b) / square, (self.E * b - self.F * a) / square

    def _symbol(self, along: str) -> sp.Symbol:
        return {"u": self.u, "v": self.v}[along]


R_U: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
R_V: Vector = (sp.Integer(0), sp.Integer(1), sp.Integer(0))
NORMAL: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(1))


def codazzi_defects(fields: GaussWeingarten) -> tuple[Any, Any]:
    """Return the normal parts of r_uuv - r_uvu and r_vvu - r_vuv; both vanish on a surface."""
    along_u = fields.derivative(fields.derivative(R_U, "u"), "v")[2]
    back_u = fields.derivative(fields.derivative(R_U, "v"), "u")[2]
    along_v = fields.derivative(fields.derivative(R_V, "v"), "u")[2]
    back_v = fields.derivative(fields.derivative(R_V, "u"), "v")[2]
    return along_u - back_u, along_v - back_v
