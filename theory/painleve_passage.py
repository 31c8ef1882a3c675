"""First passages of the solution of PIII: of its angle through a level, of its length through one.

phi rises from z = 0 to its first maximum, beyond pi, as z phi' = integral of xi sin phi(xi) is
positive while phi <= pi. That it rises on a stretch is nevertheless certified by balls.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from flint import arb, ctx

from theory.bounded_series import terms_needed
from theory.enclosure import Enclosure
from theory.errors import PastFirstMaximumError, SingularEdgeError, UndecidedError
from theory.interval_newton import root
from theory.painleve_path import pieces
from theory.painleve_piece import Piece
from theory.precision import working

OUTLINE_BITS = 64
CELLS = 8
FINEST_CELL = 2.0**-40


@dataclass(frozen=True, kw_only=True)
class Place:
    """Place on the solution: the piece and the ball of its variable t."""

    piece: Piece
    t: Any

    @property
    def z(self) -> Any:
        """Ball of z."""
        return self.piece.position(self.t)

    @property
    def angle(self) -> Any:
        """Ball of phi."""
        return self.piece.angle(self.t)

    @property
    def length(self) -> Any:
        """Ball of the integral of cos(phi/2) by z from 0."""
        return self.piece.length(self.t)


def risen(piece: Piece) -> tuple[Any, Any | None]:
    """End t of the stretch from 0 where d phi/dt > 0 is certain; t beyond where phi turns, or None.

    Both exact. On a cell either the rate is positive, or d^2 phi/dt^2 < 0 so that the rate is least
    at the far end. Where it is negative there, phi turns in the cell, and once. Raises
    UndecidedError if cells of the least size do not decide.
    """
    with working(OUTLINE_BITS + ctx.prec // 4):
        end = piece.local(piece.end).upper()
        ratio = arb((end / piece.angle.radius).upper())
        outline = piece.outline(terms_needed(piece.angle.bound, abs(piece.angle.terms[0]), ratio))
        t, width = arb(0), end / CELLS
        while t < end:
            if width < end * FINEST_CELL:
                raise UndecidedError(
                    "no certain sign of the slope", Enclosure.if_finite(outline.rate(t))
                )
            far = (t + width).min(end).mid()
            cell, rate = t.union(far), outline.rate(far)
            falling = bool((t > 0 or not piece.at_origin) and outline.second(cell) < 0)
            if falling and rate < 0:
                return t, far
            if outline.rate(cell) > 0 or (falling and rate > 0):
                t, width = far, width * 2
            else:
                width = width / 4
        return end, None


def rise(piece: Piece) -> tuple[Any, Any | None]:
    """End t of the stretch from 0 where phi rises, and the ball of its maximum if it turns then.

    Where phi turns, t is just below the place of the maximum.
    """
    end, beyond = risen(piece)
    if beyond is None:
        return end, None
    turn = root(lambda t: -piece.rate(t), lambda t: -piece.second(t), end, beyond)
    if not (turn >= end and turn <= beyond):
        raise UndecidedError("the maximum meets the end of a cell", Enclosure.if_finite(turn))
    return turn.lower(), piece.angle(turn)


def angle_passage(phi0: Any, level: Any) -> Place:
    """First place with phi = level, for level > phi0 up to the first maximum of phi.

    It is the only one on [0, t], where phi' > 0. Raises PastFirstMaximumError if the level is
    certainly above the maximum.
    """
    for piece in pieces(phi0):
        end, highest = rise(piece)
        if piece.angle(end) > level:
            return _of_angle(piece, level, end)
        if highest is not None and level > highest:
            raise PastFirstMaximumError(
                "level above the first maximum", Enclosure.if_finite(highest)
            )
        if highest is not None or not piece.angle(end) < level:
            raise UndecidedError("a level meets the end of a piece or the first maximum")
    raise UndecidedError("no piece reaches the level")


def length_passage(phi0: Any, length: Any) -> Place:
    """Place before phi = pi where the integral of cos(phi/2) dz is length > 0; it is the only one.

    The integral grows as long as phi < pi. Raises SingularEdgeError if its value at phi = pi is
    certainly less.
    """
    for piece in pieces(phi0, with_length=True):
        end, highest = rise(piece)
        if not piece.angle(end) < arb.pi():
            edge = _of_angle(piece, arb.pi(), end)
            if length > edge.length:
                raise SingularEdgeError(
                    "the singular edge is nearer", Enclosure.if_finite(edge.length)
                )
            end = edge.t.lower()
        reached = piece.length(end)
        if reached > length:
            return _of_length(piece, length, end)
        if highest is not None or not reached < length:
            raise UndecidedError("a length meets the end of a piece", Enclosure.if_finite(reached))
    raise UndecidedError("no piece reaches the length")


def _of_angle(piece: Piece, level: Any, end: Any) -> Place:
    """Place of the level before t = end, up to which phi rises."""
    t = root(lambda t: piece.angle(t) - level, piece.rate, arb(0), end)
    if not (t >= 0 and t <= end):
        raise UndecidedError("the root meets an end of the rise", Enclosure.if_finite(t))
    return Place(piece=piece, t=t)


def _of_length(piece: Piece, length: Any, end: Any) -> Place:
    """Place before t = end where the integral of cos(phi/2) is length, found by z.

    At the origin it grows like z, so that Newton's method in t would leave t > 0.
    """
    z = root(
        lambda z: piece.length(piece.local(z)) - length,
        lambda z: piece.length_rate(piece.local(z)),
        piece.start,
        piece.position(end).mid(),
    )
    t = piece.local(z)
    if not (z >= piece.start and t <= end):
        raise UndecidedError("the root meets an end of the rise", Enclosure.if_finite(t))
    return Place(piece=piece, t=t)
