"""Validated Taylor steps of PIII away from its singular origin."""

from __future__ import annotations

from typing import Any

from flint import arb

from theory.errors import UndecidedError
from theory.majorant import FAR_ENOUGH, MAJORANT_BITS, SineBound, State, grown
from theory.painleve_piece import QUOTIENT, Piece, order_for, piece
from theory.precision import coarse, working
from theory.relaxed_sine import solve

PACE = 0.25
NEAREST_TO_ORIGIN = 0.9


def step_disk(z: Any, angle: Any, slope: Any) -> State:
    """Bounds on a complex disk of radius s about z: u >= |phi - angle| and v >= |phi'|.

    For every solution whose angle and slope at z lie in the balls. Along a ray |phi'| grows at most
    at the rate S(u) + v/(z - s), as phi'' = sin phi - phi'/z; the disk stays off z = 0.
    """
    with working(MAJORANT_BITS):
        sine = SineBound.about(angle)

        def force(s: Any, u: Any, v: Any) -> Any:
            return sine(u) + v / (z - s)

        edge = State(s=arb(0), u=arb(0), v=abs(slope).upper())
        pace, farthest = PACE, NEAREST_TO_ORIGIN * float(z)
        while edge.u < FAR_ENOUGH and pace > PACE / 64:
            length = pace / float(edge.u.cosh()) ** 0.5
            following = coarse(min(float(edge.s) + length, farthest), bits=24)
            if not edge.s < following:
                break
            larger = grown(edge, following, (following - edge.s).upper(), force)
            edge, pace = (larger, pace) if larger else (edge, pace / 2)
    if edge.s == 0:
        raise UndecidedError("no a-priori enclosure about this point")
    return edge


def regular_piece(
    z: Any,
    angle: Any,
    slope: Any,
    *,
    until: Any = None,
    before: Any = None,
    order: int | None = None,
) -> Piece:
    """Enclosure of every solution of PIII through the balls angle and slope at the exact z > 0.

    until: exact ball, the largest z of interest; before: integral of cos(phi/2) up to z, if it is
    to be carried on; order: number of terms, chosen by itself if left out.
    """
    edge = step_disk(z, angle, slope)
    end = (z + coarse(QUOTIENT * float(edge.s), bits=10)).mid()
    if until is not None and until < end:
        end = until
    count = order or order_for(angle, edge, end - z)
    r, inverse = edge.s, edge.s / z

    def following(a: list[Any], sines: list[Any]) -> None:
        k = len(sines) - 1
        forcing = sines[k] + inverse * sines[k - 1] if k else sines[0]
        a.append((r * r * forcing - inverse * (k + 1) ** 2 * a[k + 1]) / ((k + 1) * (k + 2)))

    a = solve([angle, r * slope], count, following)
    return piece(a, start=z, end=end, edge=edge, rate_bound=edge.v, before=before)
