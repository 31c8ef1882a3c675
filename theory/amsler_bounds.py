r"""Bessel bounds on a family of solutions of PIII, certified cell by cell (boundCphi*, eq:defC).

U = phi/phi_n for every phi_n of an interval, x = z^2/4, e = phi_n^2, f(w) = I_0(2 sqrt w), and
S, D of theory.sinc_quotients, s = S(phi^2), c = S(e). For all phi* at once the bounds say

    f(s x) <= U <= f(x)  as long as 0 < phi <= phi* < pi,

because s = sin phi/phi falls as phi rises: at z, C(phi*)^2 <= s for each phi* >= phi(z), and s =
C(phi*)^2 for phi* = phi(z). Both touch at x = 0, and the upper gap is tiny where phi_n is. So the
zeros are divided out, exactly, with W = (f(x) - U)/e, q = (U^2 - 1) D(phi^2, e)/x = (c - s)/(e x):

    upper gap   f(x) - U   = e x G1,    G1 = W/x,           (x W')' = W + U^3 T(phi^2),
    lower gap   U - f(s x) = e x^2 G2,  G2 = q F - M/x^2,   (x M')' = c M + x q U,
    F = (f(c x) - f(s x))/(x (c - s)),  M = (f(c x) - U)/e,  W(0) = M(0) = 0.

Both are regular as e tends to 0, so intervals of phi_n with a relative width of some percent do.
The kernel of theory.bessel_kernel is positive: W >= (f(x) - 1) inf U^3 T and, by the same,
M <= x^2 unit_response(c x) sup q U, or sharper, by cells.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from flint import arb, arb_poly

from theory.bessel_kernel import LinearResponse, quotient_from_below, unit_response
from theory.bounded_series import geometric_tail, symmetric
from theory.enclosure import Enclosure
from theory.errors import DomainError, UndecidedError
from theory.painleve_path import pieces
from theory.painleve_piece import Piece
from theory.precision import ball_of, working
from theory.sinc_quotients import LARGEST_SQUARE, sinc, sinc_defect, sinc_quotient

BITS = 64


@dataclass(frozen=True, kw_only=True)
class Cell:
    """Stretch low <= z <= high of the family: balls of phi, U and (U - 1)/x, and exact ends."""

    low: Any
    high: Any
    phi: Any
    ratio: Any
    rise: Any


@dataclass(frozen=True, kw_only=True)
class GapCell:
    """Bounds on a cell: gap <= G1, quotient <= q F/(M/x^2), all exact; the latter > 1 is G2 > 0."""

    low: Any
    high: Any
    phi: Any
    gap: Any
    quotient: Any

    @property
    def proved(self) -> bool:
        """Whether both bounds hold on the whole cell, strictly except at z = 0."""
        return bool(self.gap > 0 and self.quotient > 1)


@dataclass(frozen=True, kw_only=True)
class Column:
    """What is proved for low <= phi_n <= high and 0 <= z up to where phi > top for all of them.

    reach: that z, or where the enclosures became too wide to go on, if not complete; gap,
    quotient: the least over the proved cells; open: the cells not proved, as pairs of z. All floats
    are bounds on the safe side, the ends of phi_n are exact.
    """

    low: Fraction
    high: Fraction
    cells: int
    reach: float
    gap: float
    quotient: float
    open: tuple[tuple[float, float], ...]
    complete: bool

    @property
    def proved(self) -> bool:
        """Whether the bounds hold for the whole column."""
        return self.complete and not self.open


def column(low: Fraction, high: Fraction, *, top: Fraction, step: Fraction) -> Column:
    """Bounds for all phi_n in [low, high] and all z until phi > top, on cells of about this width.

    0 < low < high <= top < pi in radians; DomainError otherwise.
    """
    if not 0 < low < high <= top or not top < Fraction(22, 7):
        raise DomainError(f"0 < low < high <= top < pi is needed, not {low}, {high}, {top}")
    found, complete = [], True
    with working(BITS):
        try:
            for cell in gap_cells(ball_of(low).union(ball_of(high)), step=step):
                if cell.phi > ball_of(top):
                    break
                found.append(cell)
        except UndecidedError:
            complete = False
    proved = [cell for cell in found if cell.proved]
    return Column(
        low=low,
        high=high,
        cells=len(found),
        reach=float(found[-1].high.upper()) if found else 0.0,
        gap=min((_below(cell.gap) for cell in proved), default=0.0),
        quotient=min((_below(cell.quotient) for cell in proved), default=0.0),
        open=tuple((float(c.low), float(c.high)) for c in found if not c.proved),
        complete=complete,
    )


def gap_cells(phi0: Any, *, step: Fraction) -> Iterator[GapCell]:
    """Cells from z = 0 on with bounds on both gaps, for all phi_n of the ball phi0; endless.

    Raises UndecidedError where the enclosure of phi has become too wide.
    """
    e = phi0**2
    c = sinc(e)
    response = LinearResponse.at_origin(arb(c.upper()))
    least, most = arb(1), arb(0)
    for cell in cells(phi0, step=step):
        square = cell.phi**2
        if not square <= LARGEST_SQUARE:
            raise UndecidedError("the enclosure of phi is too wide", Enclosure.if_finite(cell.phi))
        source = cell.ratio**3 * sinc_defect(square)
        q = (cell.ratio + 1) * cell.rise * sinc_quotient(square, e)
        height = (q * cell.ratio).upper()
        least, most = least.min(source.lower()), most.max(height)
        response = response.advanced(cell.high, height)
        excess = _excess(response, cell, most)
        s = sinc(square)
        x = cell.low**2 / 4
        # F grows with c, s and x; where phi <= pi, as is claimed, s >= 0.
        shape = quotient_from_below((x * c.lower()).lower(), (x * s.lower().max(arb(0))).lower())
        yield GapCell(
            low=cell.low,
            high=cell.high,
            phi=cell.phi,
            gap=least.lower(),
            quotient=(q.lower() * shape / excess).lower(),
        )


def _excess(response: LinearResponse, cell: Cell, most: Any) -> Any:
    """Upper bound of M/x^2 on the cell: M grows with x, and so does unit_response."""
    far = cell.high**2 / 4
    bound = (most * unit_response((response.c * far).upper())).upper()
    if cell.low > 0:
        bound = bound.min((response.value() / (cell.low**2 / 4) ** 2).upper())
    return bound


def cells(phi0: Any, *, step: Fraction) -> Iterator[Cell]:
    """Cells of about this width in z, with the family of solutions enclosed on each; endless."""
    low = arb(0)
    for piece in pieces(phi0):
        width = float(piece.end - piece.start)
        count = max(1, int(width / float(step)) + 1)
        for k in range(1, count + 1):
            high = piece.end if k == count else (piece.start + width * arb(k) / count).mid()
            yield _cell(piece, phi0, low, high)
            low = high


def _cell(piece: Piece, phi0: Any, low: Any, high: Any) -> Cell:
    """One cell: phi by the mean value from its middle, (U - 1)/x by the series at the origin."""
    local, middle = piece.local(low.union(high)), piece.local(((low + high) / 2).mid())
    phi = piece.angle(middle) + piece.rate(local) * (local - middle)
    ratio = phi / phi0
    if piece.at_origin:
        rise = _rise_at_origin(piece, local) / phi0
    else:
        rise = (ratio - 1) / (low.union(high) ** 2 / 4)
    return Cell(low=low, high=high, phi=phi, ratio=ratio, rise=rise)


def _rise_at_origin(piece: Piece, x: Any) -> Any:
    """Ball around (phi - phi_n)/x on the origin's piece: its series without the first term."""
    series = piece.angle
    quotient = arb((abs(x) / series.radius).upper())
    rest = geometric_tail(series.bound, quotient, len(series.terms) - 1) / series.radius
    return arb_poly(list(series.terms[1:]))(x / series.radius) / series.radius + symmetric(rest)


def _below(number: Any) -> float:
    """Float at or below an exact ball."""
    return float((number - abs(number) * arb(2) ** -50).lower())
