"""Checks of the matched asymptotics on the solution itself (eqa5, fig:painleveasymptotics)."""

from collections.abc import Iterator
from fractions import Fraction
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


def third_amplitude(form: str, phi0: Any, z: Any, crossing: Any) -> Any:
    """Factor of sin(z* - z): `printed`, `with phi0^4` at the running z, `2`, or `2 - 2/z*`."""
    if form == "printed":
        return printed.third_amplitude(phi0, z, BALLS)
    if form == "with phi0^4":
        return printed.third_amplitude(phi0, z, BALLS, phi0_power=4)
    if form == "2":
        return arb(2)
    if form == "2 - 2/z*":
        slope = painleve_matching.crossing_slope().coeff(painleve_matching.EPSILON)
        return 2 + int(slope) / crossing
    raise ValueError(f"unknown amplitude {form!r}")


def _third(form: str, phi0: Any, z: Any, crossing: Any) -> Any:
    return printed.pendulum(z, crossing, third_amplitude(form, phi0, z, crossing), BALLS)


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


def third_line(setting: Setting, *, amplitude: str = "printed") -> Evidence:
    """Relative error of pi - phi in the third line, 5 % allowed, for z* - z up to 1/2."""
    del setting

    def rows() -> Iterator[Row]:
        for name in ("pi/100", "1e-4", "1e-12"):
            crossing, phi0 = initial_angles.crossing(name), initial_angles.ball(name)
            for gap in ("1/16", "1/4", "1/2"):
                z = crossing - initial_angles.fraction(gap)
                true = arb.pi() - initial_angles.angle(name, z)
                claimed = arb.pi() - _third(amplitude, phi0, z, crossing)
                place = f"relative error of pi - phi at z = z* - {gap}, phi0 = {name}"
                yield place, abs(claimed / true - 1), arb(1) / 20

    return bounded(rows(), shown=f"with amplitude {amplitude} within 5 % for z* - z <= 1/2")


def figure(
    setting: Setting, *, amplitude: str = "printed", coefficient: str = "1/4", correction: str = "1/8"
) -> Evidence:  # fmt: skip
    """Each line of (eqa5) for phi0 = pi/100 on its own range, 5 % allowed.

    Line 1 for z <= 1, line 2 from z = 2 to phi = 1, line 3 where pi - phi <= 1.
    """
    del setting
    name = "pi/100"

    def lines() -> Iterator[tuple[int, Any, Any]]:
        phi0, crossing = initial_angles.ball(name), initial_angles.crossing(name)
        for z in (arb(1) / 4, arb(1) / 2, arb(1)):
            yield 1, z, printed.inner(phi0, z, coefficient=coefficient)
        for z in (arb(2), arb(3), arb(4), initial_angles.crossing(name, 1)):
            yield 2, z, printed.outer(phi0, z, BALLS, correction=correction)
        for gap in (0, 1, 2, 4, 5):
            z = crossing - arb(gap) / 8
            yield 3, z, _third(amplitude, phi0, z, crossing)

    def rows() -> Iterator[Row]:
        for line, z, form in lines():
            place = f"relative error of line {line} at z = {z.str(5, radius=False)}"
            yield place, abs(form / initial_angles.angle(name, z) - 1), arb(1) / 20

    return bounded(
        rows(), shown="lines 1, 2 and 3 within 5 % on z <= 1, up to phi = 1, and for pi - phi <= 1"
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
        lines = _Lines(initial, amplitude)
        bound = initial_angles.fraction(most)
        cells = [(arb(n) / 4, arb(n + 1) / 4) for n in range(lines.quarters)]
        cells.append((arb(lines.quarters) / 4, lines.crossing))
        done = 0
        while cells:
            low, high = cells.pop()
            if lines.covers(low, high, bound):
                done += 1
                continue
            if place := lines.refuted(low, bound) or lines.refuted(high, bound):
                return Evidence(outcome="fail", grade="certified", witness=place, tried=done + 1,
                                met=done + 1, shown="one of the lines everywhere")  # fmt: skip
            if high - low < initial_angles.fraction(str(FINEST_CELL)):
                return Evidence(outcome="undecided", grade="certified",
                                shown=f"not decided about {low.str(8, radius=False)}")  # fmt: skip
            middle = ((low + high) / 2).mid()
            cells += [(low, middle), (middle, high)]
    return Evidence(
        outcome="pass", grade="certified", tried=done, met=done,
        shown=f"phi0 = {initial}: on each of {done} cells that cover [0, z*] one line is within "
        f"{most} of phi",
    )  # fmt: skip


class _Lines:
    """The three lines for one phi0, and their relative errors on cells and at places."""

    def __init__(self, name: str, amplitude: str) -> None:
        self.name, self.amplitude = name, amplitude
        self.phi0, self.crossing = initial_angles.ball(name), initial_angles.crossing(name)
        self.quarters = int((4 * self.crossing).floor().lower().unique_fmpz())
        self._known: dict[str, Any] = {}

    def angle(self, z: Any) -> Any:
        """Ball of phi(z), computed once."""
        key = z.str(30)
        if key not in self._known:
            self._known[key] = initial_angles.angle(self.name, z, digits=12)
        return self._known[key]

    def ends(self, low: Any, high: Any) -> Iterator[tuple[Any, Any]]:
        """Values of each line that applies on the whole cell, at both ends."""
        yield printed.inner(self.phi0, low), printed.inner(self.phi0, high)
        if low >= 1:
            yield (
                printed.outer(self.phi0, low, BALLS),
                printed.outer(self.phi0, high, BALLS),
            )
        if self.crossing - low < arb.pi() / 2 and low > 0:
            a = third_amplitude(self.amplitude, self.phi0, low.union(high), self.crossing)
            yield (
                printed.pendulum(low, self.crossing, a, BALLS),
                printed.pendulum(high, self.crossing, a, BALLS),
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
        forms = [
            printed.inner(self.phi0, z),
            printed.outer(self.phi0, z, BALLS),
            _third(self.amplitude, self.phi0, z, self.crossing),
        ]
        errors = [abs(form / self.angle(z) - 1) for form in forms]
        if not all(error > bound for error in errors):
            return ""
        shown = ", ".join(error.str(3, radius=False) for error in errors)
        return f"relative errors {shown} at z = {z.str(8, radius=False)}, phi0 = {self.name}"


def crossing_number(setting: Setting, *, value: str = "9", initial: str = "pi/100") -> Evidence:
    """First crossing of pi against a number, to half a unit of its last place, by two routes."""
    del setting
    places = len(value.partition(".")[2])

    def rows() -> Iterator[Row]:
        z = initial_angles.crossing(initial)
        claimed = initial_angles.fraction(value)
        other = arb(str(initial_angles.reference_crossing(initial, digits=25)))
        place = f"distance of z* = {z.str(10, radius=False)} from {value}, phi0 = {initial}"
        yield place, abs(z - claimed), arb(1) / (2 * 10**places)
        yield "distance of the two routes", abs(z - other), arb(10) ** -20

    return bounded(rows(), shown=f"z* = {value} to the digits shown, by both routes")


def angle_of_crossing(
    setting: Setting, *, z: str = "9", low: str = "0.003790746", high: str = "0.003790747"
) -> Evidence:
    """Initial angles on either side of the one whose first crossing is at z."""
    del setting

    def rows() -> Iterator[Row]:
        at = initial_angles.fraction(z)
        yield f"z - z*({low})", at - initial_angles.crossing(low), arb(0)
        yield f"z*({high}) - z", initial_angles.crossing(high) - at, arb(0)

    return bounded(rows(), shown=f"z* = {z} for an angle between {low} and {high}, about pi/829")


def better_than_bounds(
    setting: Setting, *, amplitude: str = "printed", share: str = "1/2"
) -> Evidence:
    """Error of each line on its range against a share of the gap between the bounds, phi* = 3."""
    del setting

    def rows() -> Iterator[Row]:
        constant = (arb(3).sin() / 3).sqrt()
        for name in ("pi/100", "1e-6", "1e-12"):
            phi0, crossing = initial_angles.ball(name), initial_angles.crossing(name)
            one, two = (initial_angles.crossing(name, level) for level in (1, 2))
            forms = [("1", z, printed.inner(phi0, z)) for z in (arb(1) / 8, arb(1))]
            forms += [("2", z, printed.outer(phi0, z, BALLS)) for z in (arb(2), arb(3), one)]
            late = (two, initial_angles.crossing(name, 3))
            forms += [("3", z, _third(amplitude, phi0, z, crossing)) for z in late]
            for line, z, form in forms:
                gap = phi0 * (z.bessel_i(0) - (constant * z).bessel_i(0))
                phi = initial_angles.angle(name, z)
                place = f"error of line {line} over the gap, z = {_short(z)}, phi0 = {name}"
                yield place, abs(form - phi) / gap, initial_angles.fraction(share)

    return bounded(rows(), shown=f"each line errs by less than {share} of the gap of the bounds")


def upper_bound_nearer(setting: Setting, *, line: int = 1) -> Evidence:
    """Whether the upper bound phi0 I_0(z) alone is nearer to phi than a line of (eqa5) is."""
    del setting

    def rows() -> Iterator[Row]:
        for name in ("pi/100", "1e-6"):
            phi0, crossing = initial_angles.ball(name), initial_angles.crossing(name)
            z = {1: arb(1), 2: arb(3), 3: crossing - arb(1) / 8}[line]
            phi = initial_angles.angle(name, z)
            form = {
                1: printed.inner(phi0, z),
                2: printed.outer(phi0, z, BALLS),
                3: _third("2 - 2/z*", phi0, z, crossing),
            }[line]
            place = f"error of the upper bound, z = {_short(z)}, phi0 = {name}"
            yield place, abs(phi0 * z.bessel_i(0) - phi), abs(form - phi)

    return bounded(rows(), shown=f"phi0 I_0(z) is nearer to phi than line {line} at these places")


def optimal_constant(
    setting: Setting, *, lag: str = "0", level: str = "9/4", initials: str = "1e-2 1e-4 1e-12"
) -> Evidence:
    """Lower bound of the lemma, phi(z) >= phi_n I_0(C z), with C = 1 - lag/z_n.

    z_n: first z with phi = phi* = level; at six places in (0, z_n] for each phi_n.
    """
    del setting

    def rows() -> Iterator[Row]:
        for name in initials.split():
            last = initial_angles.crossing(name, Fraction(level))
            constant = 1 - initial_angles.fraction(lag) / last
            for part in (4, 8, 12, 14, 15, 16):
                z = last * part / 16
                bound = initial_angles.ball(name) * (constant * z).bessel_i(0)
                place = f"phi_n I_0(C z) against phi, z = {_short(z)}, phi_n = {name}"
                yield place, bound, initial_angles.angle(name, z)

    return bounded(rows(), shown=f"the bound holds with C = 1 - {lag}/z_n, which tends to 1")


def strict_upper_bound(setting: Setting, *, constant: str = "1") -> Evidence:
    """Whether phi(6) < phi_n I_0(constant * 6) for phi_n = 1/100, and so for smaller ones."""
    del setting

    def rows() -> Iterator[Row]:
        for name, at in (("1e-2", 6), ("1e-2", 1), ("1e-6", 6)):
            z = arb(at)
            bound = initial_angles.ball(name) * (initial_angles.fraction(constant) * z).bessel_i(0)
            phi = initial_angles.angle(name, z)
            yield f"phi({at}) = {_short(phi)} for phi_n = {name}", phi, bound

    return bounded(rows(), shown="phi(z) < phi_n I_0(z): C = 1 is refuted at z = 6, phi_n = 0.01")


def uniform_constant(setting: Setting, *, constant: str = "7/10", initial: str = "2") -> Evidence:
    """Whether C = constant is refuted for phi* = 9/4 by phi_n = initial, as C bounds all phi_n."""
    del setting

    def rows() -> Iterator[Row]:
        z = initial_angles.crossing(initial, Fraction(9, 4))
        bound = initial_angles.ball(initial) * (initial_angles.fraction(constant) * z).bessel_i(0)
        yield f"phi against phi_n I_0(C z) at z = {_short(z)}", arb(9) / 4, bound

    return bounded(rows(), shown=f"C = {constant} is too large for phi_n = {initial}, phi* = 9/4")


def _short(ball: Any) -> str:
    return str(ball.str(7, radius=False))
