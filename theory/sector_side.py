"""Sides of a sector of the continuum as Chebyshev series: the angle phi and the points of H^2.

In asymptotic coordinates by arc length phi_uv = sin phi, and each coordinate x of the points in the
hyperboloid (x0^2 - x1^2 - x2^2 = 1) satisfies x_uv = cos(phi) x, since its Hessian is x times the
metric du^2 + 2 cos(phi) du dv + dv^2 and the asymptotic lines are a Chebyshev net.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev


@dataclass(frozen=True, kw_only=True, eq=False)
class Side:
    """Values (nodes, 4) of phi, x0, x1, x2 at the Chebyshev nodes of [0, length], ascending."""

    length: float
    values: Any

    @property
    def series(self) -> Any:
        """Coefficients (nodes, 4) in the Chebyshev polynomials of 2 s/length - 1."""
        return np.linalg.solve(_vandermonde(len(self.values)), self.values)

    def at(self, s: Any) -> Any:
        """Values (..., 4) at arc lengths in [0, length]."""
        found = chebyshev.chebval(2 * np.asarray(s) / self.length - 1, self.series)
        return np.moveaxis(found, 0, -1)

    def rate(self, s: Any) -> Any:
        """Derivatives (..., 4) by arc length."""
        slope = chebyshev.chebder(self.series) * (2 / self.length)
        return np.moveaxis(chebyshev.chebval(2 * np.asarray(s) / self.length - 1, slope), 0, -1)

    def beyond(self, s: float, lowered: float) -> "Side":
        """Side from arc length s on, with this amount taken off the angle."""
        rest = self.length - s
        values = self.at(s + chebyshev_nodes(len(self.values), rest))
        values[:, 0] -= lowered
        return Side(length=rest, values=values)


def chebyshev_nodes(count: int, length: float) -> Any:
    """Chebyshev-Lobatto nodes of [0, length], ascending."""
    return length / 2 * (1 - np.cos(np.pi * np.arange(count) / (count - 1)))


@cache
def _vandermonde(count: int) -> Any:
    return chebyshev.chebvander(chebyshev_nodes(count, 2.0) - 1, count - 1)


@cache
def integration(count: int) -> Any:
    """Matrix (count, count): values at the nodes of [0, 1] to those of the integral from 0."""
    basis = [chebyshev.chebint(row, lbnd=-1) for row in np.eye(count)]
    integrals = np.array([chebyshev.chebval(chebyshev_nodes(count, 2.0) - 1, c) for c in basis]).T
    return np.linalg.solve(_vandermonde(count).T, integrals.T).T / 2


def geodesic_side(length: float, count: int, angle: float, point: Any, tangent: Any) -> Side:
    """Geodesic from a point (3,) with this unit tangent (3,), along which phi is constant."""
    s = chebyshev_nodes(count, length)[:, np.newaxis]
    points = np.cosh(s) * np.asarray(point) + np.sinh(s) * np.asarray(tangent)
    return Side(length=length, values=np.hstack([np.full((count, 1), angle), points]))
