"""Linear changes of the asymptotic coordinates of a net, and the reversal of its normal."""

from dataclasses import dataclass
from typing import Any

from theory.asymptotic_net import AsymptoticNet, Cartesian, VectorCalculus
from theory.surfaces import Front
from theory.vectors import Vector, added, scaled

Change = tuple[tuple[int, int], tuple[int, int]]


@dataclass(frozen=True, kw_only=True)
class Changed:
    """Vector calculus in new coordinates, by the chain rule.

    base: the old calculus; change: rows are du, dv by the new coordinates (u, v).
    """

    base: VectorCalculus
    change: Change

    def dot(self, a: Vector, b: Vector) -> Any:
        """Inner product."""
        return self.base.dot(a, b)

    def cross(self, a: Vector, b: Vector) -> Vector:
        """Cross product."""
        return self.base.cross(a, b)

    def reduced(self, expr: Any) -> Any:
        """Scalar field in the form that the old calculus keeps."""
        return self.base.reduced(expr)

    def rate(self, scalar: Any, along: str) -> Any:
        """Partial derivative of a scalar field along a new coordinate."""
        p, q = self._column(along)
        return p * self.base.rate(scalar, "u") + q * self.base.rate(scalar, "v")

    def derivative(self, a: Vector, along: str) -> Vector:
        """Partial derivative of a vector field along a new coordinate."""
        p, q = self._column(along)
        return added(
            scaled(p, self.base.derivative(a, "u")), scaled(q, self.base.derivative(a, "v"))
        )

    def _column(self, along: str) -> tuple[int, int]:
        index = {"u": 0, "v": 1}[along]
        return self.change[0][index], self.change[1][index]


def changed(net: AsymptoticNet, change: Change, *, normal_sign: int = 1) -> AsymptoticNet:
    """Return the same surface in new coordinates, with N or -N as its normal.

    sigma becomes the sign of (r_u x r_v).N for the new fields; cos_phi and sin_phi are kept. The
    result is a net in the sense of the class only for changes that keep what the class demands.
    """
    (a, b), (c, d) = change
    turned = a * d - b * c
    return AsymptoticNet(
        name=net.name,
        calculus=Changed(base=net.calculus, change=change),
        r_u=added(scaled(a, net.r_u), scaled(c, net.r_v)),
        r_v=added(scaled(b, net.r_u), scaled(d, net.r_v)),
        normal=scaled(normal_sign, net.normal),
        sigma=net.sigma * normal_sign * (1 if turned > 0 else -1),
        cos_phi=net.cos_phi,
        sin_phi=net.sin_phi,
    )


def substituted(
    front: Front, change: Change, u: Any, v: Any, *, normal_sign: int = 1
) -> tuple[Cartesian, Vector, Vector]:
    """Calculus, position and normal of a front with its coordinates replaced, nothing more.

    u, v: symbols of the new coordinates, in which the expressions are differentiated directly.
    """
    (a, b), (c, d) = change
    old_u, old_v = a * u + b * v, c * u + d * v
    calculus = Cartesian(symbols=(u, v), rates={"u": (1, 0), "v": (0, 1)})
    position = front.at(front.position, old_u, old_v)
    return calculus, position, scaled(normal_sign, front.at(front.normal, old_u, old_v))
