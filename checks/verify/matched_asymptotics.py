"""Checks of the three lines of the matched asymptotics on the solution itself (eqa5)."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any

import sympy as sp
from flint import arb, ctx

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.printed import painleve_asymptotics as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from theory import painleve_matching

FINEST_CELL = Fraction(1, 256)
AMPLITUDES = ("printed", "with phi0^4", "2", "2 - 2/z*")


@dataclass(frozen=True, kw_only=True)
class ThirdLine:
    """Third line of (eqa5) for one phi0, with one of the AMPLITUDES.

    `printed` and `with phi0^4` have the running z under the root, the others are constant.
    share: a factor of the amplitude, 1 for the formula itself.
    """

    amplitude: str
    name: str
    share: str = "1"

    def __post_init__(self) -> None:
        if self.amplitude not in AMPLITUDES:
            raise ValueError(f"unknown amplitude {self.amplitude!r}")

    @cached_property
    def crossing(self) -> Any:
        """Ball of z*."""
        return initial_angles.crossing(self.name)

    @cached_property
    def _friction(self) -> int:
        return int(painleve_matching.crossing_slope().coeff(painleve_matching.EPSILON))

    def factor(self, z: Any) -> Any:
        """Factor of sin(z* - z), over the ball z."""
        return initial_angles.fraction(self.share) * self._amplitude(z)

    def _amplitude(self, z: Any) -> Any:
        if self.amplitude == "2":
            return arb(2)
        if self.amplitude == "2 - 2/z*":
            return 2 + self._friction / self.crossing
        power = 4 if self.amplitude == "with phi0^4" else 0
        phi0 = initial_angles.ball(self.name)
        return printed.third_amplitude(phi0, z, BALLS, phi0_power=power)

    def __call__(self, z: Any) -> Any:
        """Value of the line."""
        return printed.pendulum(z, self.crossing, self.factor(z), BALLS)


def third_algebra(
    setting: Setting, *, phi0_power: int = 0, coefficient: str = "1/192", under: str = "2"
) -> Evidence:
    """Root of the third line against A = 2 sqrt(1 + delta^4/48)."""
    phi0, z = sp.symbols("phi_0 z", positive=True)
    line = printed.third_amplitude(phi0, z, sp, phi0_power=phi0_power, coefficient=coefficient)
    matched = printed.amplitude(printed.growth(phi0, z, sp, under=under), sp)
    return identities(
        setting,
        {"squared amplitudes": sp.expand(line**2 - matched**2)},
        shown="delta^4/48 = phi0^4 e^(4 z)/(192 pi^2 z^2)",
    )


def third_line(setting: Setting, *, amplitude: str = "printed", share: str = "1") -> Evidence:
    """Relative error of pi - phi in the third line, for t = z* - z up to 1/2.

    Allowed: t/(2 z*), by which friction bends the swing, t^4/30 of the separatrix, 3/(4 z*^2) of
    the amplitude, and 5 % at most; share: a factor of the amplitude.
    """
    del setting

    def rows() -> Iterator[Row]:
        for name in ("pi/100", "1e-4", "1e-12"):
            line = ThirdLine(amplitude=amplitude, name=name, share=share)
            for gap in ("1/16", "1/4", "1/2"):
                t = initial_angles.fraction(gap)
                z = line.crossing - t
                allowed = t / (2 * line.crossing) + t**4 / 30 + 3 / (4 * line.crossing**2)
                true = arb.pi() - initial_angles.angle(name, z)
                claimed = arb.pi() - line(z)
                place = f"relative error of pi - phi at z = z* - {gap}, phi0 = {name}"
                yield place, abs(claimed / true - 1), allowed.min(arb(1) / 20)

    return bounded(
        rows(),
        shown=f"with amplitude {amplitude} within t/(2 z*) + t^4/30 + 3/(4 z*^2), and 5 %, for "
        "t = z* - z <= 1/2",
        sampled=True,
    )


def figure(
    setting: Setting,
    *,
    amplitude: str = "printed",
    coefficient: str = "1/4",
    correction: str = "1/8",
    share: str = "1",
) -> Evidence:
    """Each line of (eqa5) for phi0 = pi/100 on its own range.

    Line 1 for z <= 1, z^4/64 allowed as in I_0; line 2 from z = 2 to phi = 1, 3 % allowed; line 3
    where pi - phi <= 1, 2 % allowed; share: a factor of the amplitude of line 3.
    """
    del setting
    name = "pi/100"

    def lines() -> Iterator[tuple[int, Any, Any]]:
        phi0 = initial_angles.ball(name)
        third = ThirdLine(amplitude=amplitude, name=name, share=share)
        for z in (arb(1) / 4, arb(1) / 2, arb(1)):
            yield 1, z, printed.inner(phi0, z, coefficient=coefficient)
        for z in (arb(2), arb(3), arb(4), initial_angles.crossing(name, 1)):
            yield 2, z, printed.outer(phi0, z, BALLS, correction=correction)
        for gap in (0, 1, 2, 4, 5):
            z = third.crossing - arb(gap) / 8
            yield 3, z, third(z)

    def rows() -> Iterator[Row]:
        for line, z, form in lines():
            place = f"relative error of line {line} at z = {z.str(5, radius=False)}"
            allowed = {1: z**4 / 64, 2: arb(3) / 100, 3: arb(1) / 50}[line]
            yield place, abs(form / initial_angles.angle(name, z) - 1), allowed

    return bounded(
        rows(),
        shown="line 1 within z^4/64 on z <= 1, line 2 within 3 % up to phi = 1, line 3 within 2 % "
        "for pi - phi <= 1",
        sampled=True,
    )


def coverage(
    setting: Setting, *, amplitude: str = "printed", initial: str = "pi/100", most: str = "1/10"
) -> Evidence:
    """Whether at every z in [0, z*] one of the three lines is within `most` of phi, relatively.

    On a cell [a, b] all of phi, line 1, line 2 (for a >= 1) and sin(z* - z) (for z* - a < pi/2) are
    monotone; the ball of the amplitude covers the cell. Cells are halved until they are decided.
    """
    del setting
    with ctx.workprec(128):
        lines = _Lines(third=ThirdLine(amplitude=amplitude, name=initial))
        bound = initial_angles.fraction(most)
        cells, done = lines.first_cells(), 0
        while cells:
            low, high = cells.pop()
            if lines.covers(low, high, bound):
                done += 1
                continue
            if place := lines.refuted(low, bound) or lines.refuted(high, bound):
                return Evidence(
                    outcome="fail",
                    grade="certified",
                    witness=place,
                    tried=done + 1,
                    met=done + 1,
                    shown="one of the lines everywhere",
                )
            if high - low < initial_angles.fraction(str(FINEST_CELL)):
                return Evidence(
                    outcome="undecided",
                    grade="certified",
                    shown=f"not decided about {low.str(8, radius=False)}",
                )
            middle = ((low + high) / 2).mid()
            cells += [(low, middle), (middle, high)]
    return Evidence(
        outcome="pass",
        grade="certified",
        tried=done,
        met=done,
        shown=f"phi0 = {initial}: on each of {done} cells that cover [0, z*] one line is within "
        f"{most} of phi",
    )


@dataclass(frozen=True, kw_only=True)
class _Lines:
    """The three lines for one phi0, and their relative errors on cells and at places."""

    third: ThirdLine
    known: dict[str, Any] = field(default_factory=dict)

    @cached_property
    def phi0(self) -> Any:
        return initial_angles.ball(self.third.name)

    def first_cells(self) -> list[tuple[Any, Any]]:
        """Cells of length 1/8 from 0, the last one up to z*."""
        count = int((8 * self.third.crossing).floor().unique_fmpz())
        places = [arb(n) / 8 for n in range(count + 1)]
        return [*pairwise(places), (places[-1], self.third.crossing)]

    def angle(self, z: Any) -> Any:
        """Ball of phi(z), computed once."""
        key = z.str(30)
        if key not in self.known:
            self.known[key] = initial_angles.angle(self.third.name, z, digits=12)
        return self.known[key]

    def ends(self, low: Any, high: Any) -> Iterator[tuple[Any, Any]]:
        """Values at both ends of each line that is monotone on the cell."""
        yield printed.inner(self.phi0, low), printed.inner(self.phi0, high)
        if low >= 1:
            yield printed.outer(self.phi0, low, BALLS), printed.outer(self.phi0, high, BALLS)
        crossing = self.third.crossing
        if low > 0 and crossing - low < arb.pi() / 2:
            factor = self.third.factor(low.union(high))
            yield (
                printed.pendulum(low, crossing, factor, BALLS),
                printed.pendulum(high, crossing, factor, BALLS),
            )

    def covers(self, low: Any, high: Any, bound: Any) -> bool:
        """Whether one line is certainly within the bound on all of the cell."""
        first, last = self.angle(low), self.angle(high)
        return any(
            bool(above / first - 1 <= bound and 1 - below / last <= bound)
            for below, above in self.ends(low, high)
        )

    def refuted(self, z: Any, bound: Any) -> str:
        """Place where all the lines are certainly off, in words; else empty."""
        if not z > 0:
            return ""
        forms = (printed.inner(self.phi0, z), printed.outer(self.phi0, z, BALLS), self.third(z))
        errors = [abs(form / self.angle(z) - 1) for form in forms]
        if not all(error > bound for error in errors):
            return ""
        shown = ", ".join(error.str(3, radius=False) for error in errors)
        return f"relative errors {shown} at z = {z.str(8, radius=False)}, phi0 = {self.third.name}"
