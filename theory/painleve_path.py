"""The regular solution of PIII as a chain of enclosed pieces,."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from typing import Any

from theory.painleve_origin import origin_piece
from theory.painleve_piece import Piece
from theory.painleve_step import regular_piece

MOST_PIECES = 20_000


def pieces(phi0: Any, *, until: Any = None, with_length: bool = False) -> Iterator[Piece]:
    """Pieces from z = 0 on, each starting where the one before it ends; endless without until.

    until: exact ball, the largest z of interest.
    """
    current = origin_piece(phi0, until=until, with_length=with_length)
    for _ in range(MOST_PIECES):
        yield current
        if until is not None and until <= current.end:
            return
        t = current.local(current.end)
        current = regular_piece(
            current.end,
            current.angle(t),
            current.slope(current.end),
            until=until,
            before=current.length(t) if with_length else None,
        )
    raise ArithmeticError(f"{MOST_PIECES} pieces do not reach the place")


def piece_at(phi0: Any, z: Any, *, with_length: bool = False) -> Piece:
    """Last of the pieces up to the ball z > 0: the one that encloses the solution there."""
    (last,) = deque(pieces(phi0, until=z.upper(), with_length=with_length), maxlen=1)
    return last
