"""Pseudospherical surfaces in unit-speed asymptotic coordinates, as data for vector calculus."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import sympy as sp

from theory.gauss_weingarten import NORMAL, R_U, R_V, GaussWeingarten
from theory.vectors import Vector, cross, dot


class VectorCalculus(Protocol):
    """Products and derivatives of vector fields along a surface; along is "u" or "v"."""

    def dot(self, a: Vector, b: Vector) -> Any:
        """Inner product."""

    def cross(self, a: Vector, b: Vector) -> Vector:
        """Cross product."""

    def reduced(self, expr: Any) -> Any:
        """Scalar field in the form that the calculus keeps."""

    def rate(self, scalar: Any, along: str) -> Any:
        """Partial derivative of a scalar field."""

    def derivative(self, a: Vector, along: str) -> Vector:
        """Partial derivative of a vector field."""


@dataclass(frozen=True, kw_only=True)
class Cartesian:
    """Vector calculus with triples in R^3 that depend on the symbols of the coordinates.

    symbols: those on which the expressions depend; rates: for "u" and "v", the derivatives of the
    symbols along that coordinate.
    """

    symbols: tuple[sp.Symbol, ...]
    rates: dict[str, Sequence[Any]]

    def dot(self, a: Vector, b: Vector) -> Any:
        """Inner product."""
        return dot(a, b)

    def cross(self, a: Vector, b: Vector) -> Vector:
        """Cross product."""
        return cross(a, b)

    def reduced(self, expr: Any) -> Any:
        """Scalar field, as it is."""
        return expr

    def rate(self, scalar: Any, along: str) -> Any:
        """Partial derivative of a scalar field, by the chain rule."""
        pairs = zip(self.symbols, self.rates[along], strict=True)
        return sum((q * sp.sympify(scalar).diff(s) for s, q in pairs), sp.Integer(0))

    def derivative(self, a: Vector, along: str) -> Vector:
        """Partial derivative of a vector field, entry by entry."""
        return (self.rate(a[0], along), self.rate(a[1], along), self.rate(a[2], along))


@dataclass(frozen=True, kw_only=True)
class AsymptoticNet:
    """Surface of curvature -1 in unit-speed asymptotic coordinates (u, v).

    calculus: its products and derivatives; r_u, r_v, normal: vector fields; sigma: the sign of
    (r_u x r_v).N; cos_phi, sin_phi: of the angle whose sine is positive, of which nothing else is
    assumed. Along the u-lines N turns with torsion -1, along the v-lines with torsion +1.
    """

    name: str
    calculus: VectorCalculus
    r_u: Vector
    r_v: Vector
    normal: Vector
    sigma: int
    cos_phi: Any
    sin_phi: Any

    def d(self, a: Vector, *along: str) -> Vector:
        """Partial derivative of a vector field along each of the coordinates in turn."""
        for coordinate in along:
            a = self.calculus.derivative(a, coordinate)
        return a

    def angle_rate(self, along: str) -> Any:
        """Partial derivative of the angle, from d phi = cos phi d(sin phi) - sin phi d(cos phi)."""
        rate = self.calculus.rate
        return self.calculus.reduced(
            self.cos_phi * rate(self.sin_phi, along) - self.sin_phi * rate(self.cos_phi, along)
        )

    def geodesic_curvature(self, along: str) -> Any:
        """Signed geodesic curvature of the "u"- or "v"-lines, positive where they bend to N x T."""
        tangent = self.r_u if along == "u" else self.r_v
        bent = self.d(tangent, along)
        return self.calculus.dot(bent, self.calculus.cross(self.normal, tangent))


def general_net(sigma: int) -> AsymptoticNet:
    """Return the net of an unknown angle phi(u, v), with sigma = +1 or -1, from Gauss-Weingarten.

    Unit speed gives E = G = 1, the angle F and the area (r_u x r_v).N = sigma sin phi; asymptotic
    coordinates give e = g = 0, curvature -1 gives f^2 = area^2, and torsion -1 of the u-lines
    f = -area. Whether derivatives commute is a condition on phi.
    """
    u, v = sp.symbols("u v", real=True)
    phi = sp.Function("phi", positive=True)(u, v)
    area = sigma * sp.sin(phi)
    zero, one = sp.Integer(0), sp.Integer(1)
    fields = GaussWeingarten(
        u=u, v=v, E=one, F=sigma * sp.cos(phi), G=one, e=zero, f=-area, g=zero, area=area
    )
    return AsymptoticNet(
        name=f"any phi, sigma = {sigma:+d}",
        calculus=fields,
        r_u=R_U,
        r_v=R_V,
        normal=NORMAL,
        sigma=sigma,
        cos_phi=sp.cos(phi),
        sin_phi=sp.sin(phi),
    )
