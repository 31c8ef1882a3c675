r"""Surfaces of curvature -1 near a folded corner, of every small size: bounds in balls.

The Goursat problem phi_uv = sin phi with phi = beta(0) - alpha(u) and beta(v) - alpha(0) on the
axes, alpha and beta smoothed, has a solution for all (u, v), and a surface with normal N. With
S = |u| + |v|, from the Taylor remainders of the frames along the axes and N_uv = +-cos phi N,
r_uv = +-sin phi N in R^3, X_uv = cos phi X on the hyperboloid H^2 in R^3:
    |phi - (beta - alpha)| <= |u v|,  |N - e3 - i (A - B)| <= S^2 / 2,
    |X - X(0, 0) - (A + B)| <= e^S - 1 - S,  |X - X(0, 0)| <= e^S - 1  (Euclidean norms).
X is an immersion where 0 < phi < pi, so it maps a region onto every disk that the image of the
region's boundary does not meet, and the part over that disk one-to-one. N takes the value of one
double point near the other, because the degree of N - N(first) on a box around it is not 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb, fmpq

from theory.folded_corner import FoldedCorner


def ball(value: Fraction) -> Any:
    """Ball of a rational number at the precision in force."""
    return arb(fmpq(value.numerator, value.denominator))


@dataclass(frozen=True, kw_only=True)
class CornerSurfaces:
    """All surfaces of scale lambda in (0, scale], u = lambda times the u of the net.

    net: the translation net, to first order; step: length over which alpha and beta turn, in the
    units of the net. The fields below are balls at the precision in force that hold for every
    lambda, lengths in units of lambda.
    """

    net: FoldedCorner
    scale: Fraction
    step: Fraction

    @property
    def size(self) -> Any:
        """Ball that contains every lambda."""
        half = ball(self.scale) / 2
        return arb(half, half)

    def smoothing(self) -> Any:
        """Bound on what turning over a length displaces A + B and A - B, two steps each."""
        return 8 * ball(self.step)

    def largest_curvature(self) -> Any:
        """Bound on both principal curvatures on Q in the square, cot(phi/2) at the least phi."""
        least = 4 * ball(self.net.t).atan() - (self.size * ball(self.net.extent)) ** 2
        return (least / 2).cot()

    def position_error(self) -> Any:
        """Bound on the distance of X in H^2 from the net, in the square."""
        span = 2 * ball(self.net.extent)
        return self.size * span**2 / 2 * (self.size * span).exp() + self.smoothing()

    def normal_error(self) -> Any:
        """Bound on the distance of N from that of the net, at both double points and the box."""
        span = ball(self.net.arm + 1 + 2 * self.net.spare)
        return self.size * span**2 / 2 + self.smoothing()

    def box_margin(self) -> Any:
        """Least distance of N - N(first) from 0 on the rim of the box: positive is a proof.

        The box has the half-side spare about the second double point; N is linear there.
        """
        return ball(self.net.spare * self.net.sine) - 2 * self.normal_error()

    def _shrunk(self, length: Any) -> Any:
        """Lower bound on the distance in H^2 of two points with this distance of their shadows."""
        span = 2 * ball(self.net.extent) * self.size
        slope = (span.exp() - 1) ** 2
        return length * (1 - slope).sqrt() * (1 - (self.size * length) ** 2 / 24)

    def room(self) -> Any:
        """Lower bound on the radius of a geodesic disk about the first double point inside Q."""
        return self._shrunk(ball(self.net.squared_room()).sqrt() - 2 * self.position_error())

    def separation(self) -> tuple[Any, Any]:
        """Lower and upper bound on the distance of the double points in H^2."""
        off = 2 * ball(self.net.spare) + 2 * self.position_error()
        middle = ball(self.net.separation())
        return self._shrunk(middle - off), middle + off


def surfaces(t: Fraction) -> CornerSurfaces:
    """Family with curvatures at most 1/(2 t), its sizes small enough for the bounds to decide."""
    net = FoldedCorner(t=t, spare=t / 4)
    return CornerSurfaces(net=net, scale=t**2 / 10, step=t**2 / 1000)
