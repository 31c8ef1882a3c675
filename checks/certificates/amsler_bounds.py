r"""Checker of the stored certificate of the Bessel bounds on Amsler sectors (boundCphi*).

For every phi_n of a column [low, high], at every z up to where phi > top, top < pi: with U =
phi/phi_n, s = sin phi/phi and f(w) = I_0(2 sqrt w),

    f(lower^2 s x) <= U <= f(upper^2 x),  x = z^2/4,

lower = upper = 1 being the bounds of the lemma for all phi* <= top at once. The exact zeros at
x = 0 and phi_n = 0 are divided out: e = phi_n^2, c = sin phi_n/phi_n,

    (x W')' = W + U^3 T,  W = (f(x) - U)/e,  and  U - f(s x) = e (x^2 q F - M),
    (x M')' = c M + x q U,  M = (f(c x) - U)/e,  x q = (c - s)/e,

F = (f(c x) - f(s x))/(x (c - s)), T = (1 - s)/phi^2. M is bounded step by step from these
integral inequalities, on the tube of checks.certificates.painleve_tube; the run that made the
certificate summed Bessel's kernel over cells. Imports neither theory nor discrete.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import factorial
from typing import Any

from flint import arb

from checks.certificates.painleve_tube import Step, Stretch, rational, tube

TERMS = 24


@dataclass(frozen=True, kw_only=True)
class Verdict:
    """Outcome on a column: proved, refuted with a witness, or open with the place.

    gap, quotient: the least of U^3 T (so W >= that times f(x) - 1) and of x^2 q F/M, rounded down.
    """

    refuted: str = ""
    open: str = ""
    stretches: int = 0
    gap: float = 0.0
    quotient: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Excess:
    """Upper bounds at z: M, and K = z dM/dz; most: the largest q U so far. Exact balls."""

    m: Any
    k: Any
    most: Any


def verdict(
    low: Fraction,
    high: Fraction,
    *,
    top: Fraction,
    steps: Sequence[Step],
    lower: Fraction = Fraction(1),
    upper: Fraction = Fraction(1),
    constant: str = "at phi",
) -> Verdict:
    """Verdict on a column. constant: `at phi` for s, `at phi_n` for c in its place.

    Raises NotEnclosedError where a step is too wide.
    """
    phi0, limit = rational(low).union(rational(high)), rational(top)
    e = phi0**2
    c = phi0.sin() / phi0
    excess, gap, quotient, count = None, arb(1), arb(10) ** 6, 0
    for stretch in tube(phi0, steps):
        if stretch.box > limit:
            break
        count += 1
        family = _Family(stretch=stretch, phi0=phi0, e=e, c=c)
        if refuted := _refuted(family, lower, upper, constant):
            return Verdict(refuted=refuted)
        excess = family.excess(excess)
        gap, quotient = gap.min(family.gap()), quotient.min(family.quotient(excess))
        if not (gap > 0 and quotient > 1):
            return Verdict(open=f"phi_n in [{low}, {high}], z near {_text(stretch.high)}")
    else:
        return Verdict(open=f"phi_n in [{low}, {high}]: phi does not reach {top}")
    if lower > 1 or upper < 1 or constant != "at phi":
        return Verdict(open=f"phi_n in [{low}, {high}]: neither proved nor refuted")
    if not count:
        return Verdict(open=f"phi_n in [{low}, {high}] begins above {top}: nothing to prove")
    return Verdict(stretches=count, gap=_below(gap), quotient=_below(quotient))


def _refuted(family: _Family, lower: Fraction, upper: Fraction, constant: str) -> str:
    """Where a bound fails at the end of the stretch for the whole family; empty if nowhere.

    The bounds with lower <= 1 <= upper follow from those with 1, as f grows.
    """
    x, u = family.x_high, 1 + family.stretch.growth / family.phi0
    s = family.stretch.phi.sin() / family.stretch.phi if constant == "at phi" else family.c
    below = (rational(lower) ** 2 * s * x).hypgeom_0f1(1)
    above = (rational(upper) ** 2 * x).hypgeom_0f1(1)
    where = f"phi_n = {_text(family.phi0)}, z = {_text(family.stretch.high)}"
    if below > u:
        return f"{where}: phi/phi_n = {_text(u)} < {_text(below)}"
    if u > above:
        return f"{where}: phi/phi_n = {_text(u)} > {_text(above)}"
    return ""


@dataclass(frozen=True, kw_only=True)
class _Family:
    """Quantities of a stretch, as upper and lower bounds for the whole column."""

    stretch: Stretch
    phi0: Any
    e: Any
    c: Any

    @property
    def x_low(self) -> Any:
        return self.stretch.low**2 / 4

    @property
    def x_high(self) -> Any:
        return self.stretch.high**2 / 4

    def gap(self) -> Any:
        """Lower bound of U^3 T; T falls with phi as long as phi < 4."""
        u = 1 + self.stretch.grown / self.phi0
        return (u.lower() ** 3 * _defect(arb((self.stretch.box**2).upper()))).lower()

    def q(self) -> Any:
        """Ball around q = (U + 1)((U - 1)/x) D, D = (c - s)/(phi^2 - e)."""
        u = 1 + self.stretch.grown / self.phi0
        square = self.stretch.box**2
        small = _quotient(arb(square.upper()), arb(self.e.upper()))
        large = _quotient(arb(square.lower()), arb(self.e.lower()))
        return (u + 1) * self.stretch.rise / self.phi0 * small.union(large)

    def excess(self, before: Excess | None) -> Excess:
        """Bounds at the end of the stretch from those at its start.

        M and K grow. With A >= q U on the stretch, w = integral of (a + t) log((a + h)/(a + t)) dt
        and v = integral of (a + t) dt over the step, and x^2/z dz = dx x/2 at the origin:
        K <= K(a) + v (c M + x A), M <= M(a) + K(a) log(1 + h/a) + w (c M + x A).
        """
        height = (self.q() * (1 + self.stretch.grown / self.phi0)).upper()
        x, c = self.x_high, arb(self.c.upper())
        if before is None:
            # (x M')' = c M + x q U: x M' <= c x M + A x^2/2 and M <= c x M + A x^2/4.
            m = (height * x**2 / 4 / (1 - c * x)).upper()
            return Excess(m=m, k=(2 * x * (c * m + height * x / 2)).upper(), most=height)
        a, z = self.stretch.low, self.stretch.high
        log = (z / a).log()
        v = (z**2 - a**2) / 2
        w = (z**2 - a**2) / 4 - a**2 / 2 * log
        m = ((before.m + before.k * log + w * x * height) / (1 - c * w)).upper()
        k = (before.k + v * (c * m + x * height)).upper()
        return Excess(m=m, k=k, most=before.most.max(height))

    def quotient(self, excess: Excess) -> Any:
        """Lower bound of x^2 q F/M on the stretch; F is a mean of f', convex and growing."""
        x, far = self.x_low, self.x_high
        c = arb(self.c.lower())
        s = (self.stretch.box.sin() / self.stretch.box).lower().max(arb(0))
        shape = (x * (c + s) / 2).lower().hypgeom_0f1(2).lower()
        if x * (c - s) > 1:
            direct = ((x * c).hypgeom_0f1(1) - (x * s).hypgeom_0f1(1)) / (x * (c - s))
            shape = shape.max(direct.lower())
        over_square = (excess.most / 4 / (1 - self.c * far)).upper() if self.c * far < 1 else None
        if x > 0:
            direct = (excess.m / x**2).upper()
            over_square = direct if over_square is None else over_square.min(direct)
        if over_square is None:  # the first stretch of a column too wide for any bound
            return arb(0)
        return (self.q().lower() * shape / over_square).lower()


def _defect(w: Any) -> Any:
    """Ball around T = (1 - sin t/t)/t^2 at the exact w = t^2 in (0, 20)."""
    if w > 1:
        t = w.sqrt()
        return (1 - t.sin() / t) / w
    return _series(w, arb(0))


def _quotient(w: Any, v: Any) -> Any:
    """Ball around D(w, v) = (S(v) - S(w))/(w - v) at exact w, v, S(t^2) = sin t/t.

    It falls in both, as S is convex up to t = 5.76 (S'' is a positive multiple of j_2).
    """
    if w - v > 1:
        first, second = w.sqrt(), v.sqrt()
        return (second.sin() / second - first.sin() / first) / (w - v)
    return _series(w, v)


def _series(w: Any, v: Any) -> Any:
    """Sum of (-1)^k h_k/(2 k + 3)!, h_k the sum of w^i v^(k - i): D(w, v), and T(w) for v = 0."""
    total, h = arb(0), arb(1)
    for k in range(TERMS):
        total += (-h if k % 2 else h) / factorial(2 * k + 3)
        h = w * h + v ** (k + 1)
    # |h_k| <= (k + 1) 20^k: what is left out is less than twice its first term.
    return total + arb(0, (2 * h / factorial(2 * TERMS + 3)).upper())


def _text(ball: Any) -> str:
    return str(ball.mid().str(8, radius=False))


def _below(number: Any) -> float:
    """Float at or below an exact ball."""
    return float((number - abs(number) * arb(2) ** -50).lower())
