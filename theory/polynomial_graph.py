"""Normal map of the graph of a polynomial w(x, y) along small circles, for indices of normals.

The upward normal is (-w_x, -w_y, 1), of any positive length. Points are triples of balls.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp
from flint import arb, fmpq

from theory.vectors import Vector
from theory.winding import X, Y


def real_power(order: int) -> Any:
    """Harmonic saddle of this order, the real part of (x + i y)^order."""
    return sp.expand(sp.re(sp.expand((X + sp.I * Y) ** order)))


@dataclass(frozen=True, kw_only=True)
class PolynomialGraph:
    """Graph of a polynomial height with rational coefficients in X and Y."""

    height: Any

    @cached_property
    def gradient(self) -> tuple[Any, Any]:
        """Both partial derivatives."""
        return sp.diff(self.height, X), sp.diff(self.height, Y)

    @cached_property
    def hessian_determinant(self) -> Any:
        """Determinant of the Hessian, of the sign of the Gauss curvature."""
        return sp.hessian(self.height, (X, Y)).det()

    @cached_property
    def _terms(self) -> tuple[list[tuple[tuple[int, int], fmpq]], ...]:
        return tuple(
            [(powers, fmpq(int(c.p), int(c.q))) for powers, c in sp.Poly(entry, X, Y).terms()]
            for entry in self.gradient
        )

    def normal(self, x: arb, y: arb) -> Vector:
        """Upward normal at a point given by balls."""
        first, second = (
            sum((arb(c) * x**j * y**k for (j, k), c in terms), arb(0)) for terms in self._terms
        )
        return -first, -second, arb(1)


def circle(t: arb, radius: fmpq, *, turns: int = 1) -> tuple[arb, arb]:
    """Point at parameter t in [0, 1] of a circle about the origin, run through this many times."""
    angle = 2 * arb.pi() * turns * t
    return radius * angle.cos(), radius * angle.sin()
