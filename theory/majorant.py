"""A-priori enclosures of complex solutions on a disk, by a real majorant along its rays.

|sin(phi_0 + w)| <= S(|w|) with S(u) = |sin phi_0| cosh u + |cos phi_0| sinh u, which grows with u
and is convex. So on every ray from the centre the deviation |phi - phi_0| and its rate are at most
the solution (u, v) of a real system that is monotone and convex, and `grown` steps an upper bound
of that from one distance to the next. Without such a bound the coefficients of a Taylor series say
nothing about its remainder.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from flint import arb

from theory.errors import UndecidedError

MAJORANT_BITS = 64
#: Bound u on |phi - phi_0| at which a disk is large enough: its edge is then within about
#: exp(-u/2) of where the majorant blows up.
FAR_ENOUGH = 6
REFINEMENTS = 3


@dataclass(frozen=True, kw_only=True)
class State:
    """Bounds at distance s from the centre: deviation u >= |phi - phi_0|, rate v of its growth."""

    s: Any
    u: Any
    v: Any


@dataclass(frozen=True, kw_only=True)
class SineBound:
    """Bound S(u) on |sin(phi_0 + w)| for |w| <= u and every phi_0 of a ball."""

    sine: Any
    cosine: Any

    @classmethod
    def about(cls, angle: Any) -> SineBound:
        """S for the balls of sines and cosines of the angles."""
        sine, cosine = angle.sin_cos()
        return cls(sine=abs(sine).upper(), cosine=abs(cosine).upper())

    def __call__(self, u: Any) -> Any:
        """S(u), rounded up."""
        sinh, cosh = u.sinh_cosh()
        return (self.sine * cosh + self.cosine * sinh).upper()


def grown(state: State, s: Any, clock: Any, force: Callable[[Any, Any, Any], Any]) -> State | None:
    r"""Bounds at distance s > state.s, or None if the candidate is not proved.

    In a clock tau in which both obey u_tau <= v, v_tau <= f(s, u, v), with f(s(tau), u, v)
    nonnegative, growing in u and v and convex in tau along convex growing u, v; clock: upper bound
    D on the time from state.s to s. Candidate: V, and U = u + D (v + V)/2, with

        v + D/2 (f(s_0, u, v) + f(s, U, V)) <= V.

    It is a supersolution: take V(tau) the chord from v to V and U(tau) its integral, both convex
    and growing. Then f along them is convex, its integral from the start is convex, hence below
    the chord between its ends, and the end is bounded by the trapezium: Picard's operator maps
    (U, V)(tau) below itself. It is monotone, so what satisfies the integral inequalities with <=
    stays below, as long as it exists; and it exists, being bounded.
    """
    here, rate = force(state.s, state.u, state.v), state.v
    for _ in range(12):
        deviation = (state.u + clock * (state.v + rate) / 2).upper()
        needed = (state.v + clock * (here + force(s, deviation, rate)) / 2).upper()
        if needed <= rate:
            return State(s=s, u=deviation, v=rate)
        rate = (needed + (needed - rate) / 16).upper()
    return None


def least_disk(sine: SineBound, radius: Any) -> Any:
    """M with radius S(M) <= M: |F - phi_0| <= M on |x| <= radius if x F'' + F' = sin F.

    As long as |F - phi_0| <= M, |x F'| <= integral of S(M) = |x| S(M), so that |F - phi_0| <=
    |x| S(M) <= M: the bound cannot be left before |x| = radius. Then it holds for radius S(M) too.
    """
    bound = (2 * radius * sine(arb(0))).upper()
    if not radius * sine(bound) <= bound:
        raise UndecidedError("no a-priori enclosure on the first disk")
    for _ in range(REFINEMENTS):
        bound = (radius * sine(bound)).upper()
    return bound
