"""A stretch of a solution of PIII with the power series that encloses it, and how it is read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import arb, arb_series, ctx

from theory.bounded_series import BoundedSeries, terms_needed
from theory.errors import UndecidedError
from theory.majorant import SineBound, State
from theory.precision import working

#: Reach of a piece as a part of the radius of its disk: near exp(-1.2), which balances the number
#: of pieces against the number of terms where n terms cost about n^1.2.
QUOTIENT = 0.3


@dataclass(frozen=True, kw_only=True)
class Piece:
    """Solution of PIII on start <= z <= end by t = z - start, or by t = z^2/4 at the origin.

    start, end: exact balls, start 0 at the origin; angle, rate: series of phi and of d phi/dt;
    half_cosine: series of cos(phi/2) and before: its integral by z up to start, or None where not
    wanted.
    """

    start: Any
    end: Any
    angle: BoundedSeries
    rate: BoundedSeries
    half_cosine: BoundedSeries | None = None
    before: Any = None

    @property
    def at_origin(self) -> bool:
        """Whether t is z^2/4."""
        return bool(self.start == 0)

    def local(self, z: Any) -> Any:
        """Value of t at z >= start."""
        return z * z / 4 if self.at_origin else z - self.start

    def position(self, t: Any) -> Any:
        """Value of z at t >= 0."""
        return 2 * t.sqrt() if self.at_origin else self.start + t

    def slope(self, z: Any) -> Any:
        """Derivative of phi by z, at z."""
        rate = self.rate(self.local(z))
        return rate * z / 2 if self.at_origin else rate

    def second(self, t: Any) -> Any:
        """Second derivative of phi by t > 0, from the equation."""
        sine, rate = self.angle(t).sin(), self.rate(t)
        return (sine - rate) / t if self.at_origin else sine - rate / (self.start + t)

    def outline(self, order: int) -> Piece:
        """Same stretch with at most this many terms, without cos(phi/2)."""
        return Piece(
            start=self.start,
            end=self.end,
            angle=self.angle.truncated(order),
            rate=self.rate.truncated(order),
        )

    def length(self, t: Any) -> Any:
        """Integral of cos(phi/2) by z from z = 0 to the place of t."""
        series = self._cosines()
        return self.before + (series.integral_by_root(t) if self.at_origin else series.integral(t))

    def length_rate(self, t: Any) -> Any:
        """Derivative cos(phi/2) of length by z, at the place of t."""
        return self._cosines()(t)

    def _cosines(self) -> BoundedSeries:
        if self.half_cosine is None:
            raise ValueError("this piece was made without cos(phi/2)")
        return self.half_cosine


def order_for(angle: Any, edge: State, t: Any) -> int:
    """Number of terms whose tail at t is about 2^-prec of the angle."""
    return terms_needed(edge.u, abs(angle).lower(), t / edge.s)


def piece(
    a: list[Any],
    *,
    start: Any,
    end: Any,
    edge: State,
    rate_bound: Any,
    before: Any = None,
) -> Piece:
    """Piece with the coefficients a_k edge.s^k of phi on the disk |t| <= edge.s.

    edge.u bounds |phi - phi(start)| and rate_bound |d phi/dt| on that disk. before: the integral
    of cos(phi/2) up to start, if it is to be carried on.
    """
    rates = tuple(k * term / edge.s for k, term in enumerate(a))[1:]
    cosines = None if before is None else _half_cosines(a, edge)
    return Piece(
        start=start,
        end=end,
        angle=BoundedSeries(terms=tuple(a), radius=edge.s, bound=edge.u),
        rate=BoundedSeries(terms=rates, radius=edge.s, bound=rate_bound),
        half_cosine=cosines,
        before=before,
    )


def _half_cosines(a: list[Any], edge: State) -> BoundedSeries:
    """Series of cos(phi/2), bounded on the disk where |phi - phi(start)| <= u."""
    order = len(a)
    with working(ctx.prec, series_length=order):
        series = arb_series([term / 2 for term in a], prec=order).cos()
    if series.prec < order:
        raise UndecidedError(f"flint cut a series to {series.prec} of {order} terms")
    terms = [*series.coeffs(), *[arb(0)] * order][:order]
    bound = SineBound.about((a[0] + arb.pi()) / 2)(edge.u / 2)
    return BoundedSeries(terms=tuple(terms), radius=edge.s, bound=bound)
