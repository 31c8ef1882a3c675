"""The unit sphere S^2 and the hyperbolic plane H^2 as surfaces of triples.

A point is a triple (x0, x1, x2) of scalars with <x, x> = K: on S^2, K = 1, the product is the
Euclidean one; on H^2, K = -1, it is Minkowski's with signature -++ and x0 > 0 (hyperboloid model).
The point (1, 0, 0) is the origin of both; x1, x2 are the first two directions there, and a turn
from x1 to x2 is positive. Lengths in units of curvature +-1, angles in radians.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

#: Scalar: float, array, arb, mpf or sympy expression. Triple of such, indexable.
Scalar: TypeAlias = Any
Triple: TypeAlias = Any
Product: TypeAlias = Callable[[Triple, Triple], Scalar]

ORIGIN = (1, 0, 0)


def dot_s2(a: Triple, b: Triple) -> Scalar:
    """Euclidean product; <x, x> = 1 on S^2."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def dot_h2(a: Triple, b: Triple) -> Scalar:
    """Minkowski product, signature -++; <x, x> = -1 and x0 > 0 on H^2."""
    return -a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross_s2(a: Triple, b: Triple) -> Triple:
    """Vector c with <c, x> = det(a, b, x) for the Euclidean product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def cross_h2(a: Triple, b: Triple) -> Triple:
    """Vector c with <c, x> = det(a, b, x) for the Minkowski product."""
    return (
        a[2] * b[1] - a[1] * b[2],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@dataclass(frozen=True, kw_only=True)
class SpaceForm:
    """A simply connected surface of constant curvature +1 or -1 with its model in triples.

    dot: the bilinear form; cross: the vector product that belongs to it. Compare by name.
    """

    name: str
    curvature: int
    dot: Product
    cross: Callable[[Triple, Triple], Triple]

    def cosine(self, functions: Any, length: Scalar) -> Scalar:
        """Function cos of a length on S^2, cosh on H^2."""
        return functions.cos(length) if self.curvature > 0 else functions.cosh(length)

    def sine(self, functions: Any, length: Scalar) -> Scalar:
        """Function sin of a length on S^2, sinh on H^2."""
        return functions.sin(length) if self.curvature > 0 else functions.sinh(length)

    def tangent(self, functions: Any, length: Scalar) -> Scalar:
        """Function tan of a length on S^2, tanh on H^2."""
        return functions.tan(length) if self.curvature > 0 else functions.tanh(length)

    def residual(self, p: Triple) -> Scalar:
        """Defect <p, p> - K, zero for a point of the space."""
        return self.dot(p, p) - self.curvature


S2 = SpaceForm(name="S2", curvature=1, dot=dot_s2, cross=cross_s2)
H2 = SpaceForm(name="H2", curvature=-1, dot=dot_h2, cross=cross_h2)
SPACE_FORMS = (S2, H2)
