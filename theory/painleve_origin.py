"""Series of PIII at its singular origin, with a proved tail (PIII, eq:integral).

In x = z^2/4 = u v the equation is (x F')' = x F'' + F' = sin F, F(0) = phi_0, and
F = sum a_k x^k with k^2 a_k = [x^(k-1)] sin F.
"""

from __future__ import annotations

from typing import Any

from flint import arb

from theory.majorant import FAR_ENOUGH, MAJORANT_BITS, SineBound, State, grown, least_disk
from theory.painleve_piece import QUOTIENT, Piece, order_for, piece
from theory.precision import coarse, working
from theory.relaxed_sine import solve

FIRST_RADIUS = 0.125
PACE = 0.2


def origin_disk(phi0: Any, *, wanted: float = float("inf")) -> State:
    """Bounds on a complex disk |x| <= s about 0: u >= |F - phi_0| and v >= |x F'|.

    Starts from the disk where s S(M) <= M, and grows it by the majorant in the clock log s, in
    which u_tau <= v and v_tau <= s S(u), until u is large or s is wanted.
    """
    with working(MAJORANT_BITS):
        sine, first = SineBound.about(phi0), arb(FIRST_RADIUS)
        deviation = least_disk(sine, first)
        edge = State(s=first, u=deviation, v=(first * sine(deviation)).upper())
        pace = PACE
        while edge.u < FAR_ENOUGH and float(edge.s) < wanted and pace > PACE / 64:
            part = pace / max(1.0, float(edge.s) * float(edge.u.cosh())) ** 0.5
            following = coarse(float(edge.s) * (1 + part), bits=24)
            clock = (following / edge.s).log().upper()
            larger = grown(edge, following, clock, lambda s, u, _: s * sine(u))
            edge, pace = (larger, pace) if larger else (edge, pace / 2)
    return edge


def origin_piece(
    phi0: Any, *, until: Any = None, with_length: bool = False, order: int | None = None
) -> Piece:
    """Enclosure of the regular solution with phi(0) = phi0, from z = 0 as far as is economical.

    phi0: ball; until: exact ball, the largest z of interest; order: number of terms, chosen by
    itself if left out (any number gives an enclosure).
    """
    wanted = float("inf") if until is None else 16 * float(until) ** 2
    edge = origin_disk(phi0, wanted=wanted)
    end = coarse(2 * (QUOTIENT * float(edge.s)) ** 0.5, bits=16)
    if until is not None and until < end:
        end = until
    count = order or order_for(phi0, edge, end * end / 4)

    def following(a: list[Any], sines: list[Any]) -> None:
        k = len(a)
        a.append(edge.s * sines[-1] / (k * k))

    a = solve([phi0], count, following)
    return piece(
        a,
        start=arb(0),
        end=end,
        edge=edge,
        rate_bound=(edge.v / edge.s).upper(),
        before=arb(0) if with_length else None,
    )
