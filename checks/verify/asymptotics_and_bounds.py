"""Checks of the matched asymptotics against the bounds, and of the constant C = 1 (appendix A)."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from flint import arb

from checks.evidence import Evidence, Setting
from checks.printed import painleve_asymptotics as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.matched_asymptotics import ThirdLine


def better_than_bounds(
    setting: Setting,
    *,
    amplitude: str = "printed",
    coefficient: str = "1/4",
    third: str = "1",
    share: str = "1",
) -> Evidence:
    """Error of each line on its range against a part of the gap between the bounds, phi* = 3.

    The part is share times 1/15, for line 1 z^2/15, as its error z^4/64 is to the gap (1 - C^2)
    z^2/4 with C^2 = sin 3/3, and for line 3 1/40. third: a factor of the amplitude of line 3.
    """
    del setting

    def rows() -> Iterator[Row]:
        constant = (arb(3).sin() / 3).sqrt()
        for name in ("pi/100", "1e-6", "1e-12"):
            phi0 = initial_angles.ball(name)
            last = ThirdLine(amplitude=amplitude, name=name, share=third)
            one, two, three = (initial_angles.crossing(name, level) for level in (1, 2, 3))
            forms = [
                ("1", z, printed.inner(phi0, z, coefficient=coefficient), z * z / 15)
                for z in (arb(1) / 8, arb(1))
            ]
            forms += [
                ("2", z, printed.outer(phi0, z, BALLS), arb(1) / 15) for z in (arb(2), arb(3), one)
            ]
            forms += [("3", z, last(z), arb(1) / 40) for z in (two, three)]
            for line, z, form, part in forms:
                gap = phi0 * (z.bessel_i(0) - (constant * z).bessel_i(0))
                phi = initial_angles.angle(name, z)
                place = f"error of line {line} over the gap, z = {_short(z)}, phi0 = {name}"
                yield place, abs(form - phi) / gap, part * initial_angles.fraction(share)

    return bounded(
        rows(),
        shown="each line errs by less than a fifteenth of the gap of the bounds: line 1 by less "
        "than z^2/15 of it, line 3 by less than a fortieth",
        sampled=True,
    )


def upper_bound_nearer(setting: Setting, *, line: int = 1) -> Evidence:
    """Whether the upper bound phi0 I_0(z) alone is nearer to phi than a line of (eqa5) is."""
    del setting

    def rows() -> Iterator[Row]:
        for name in ("pi/100", "1e-6"):
            phi0, third = initial_angles.ball(name), ThirdLine(amplitude="2 - 2/z*", name=name)
            z = {1: arb(1), 2: arb(3), 3: third.crossing - arb(1) / 8}[line]
            phi = initial_angles.angle(name, z)
            form = {
                1: printed.inner(phi0, z),
                2: printed.outer(phi0, z, BALLS),
                3: third(z),
            }[line]
            place = f"error of the upper bound, z = {_short(z)}, phi0 = {name}"
            yield place, abs(phi0 * z.bessel_i(0) - phi), abs(form - phi)

    return bounded(rows(), shown=f"phi0 I_0(z) is nearer to phi than line {line} at these places")


def optimal_constant(
    setting: Setting,
    *,
    lag: str = "0",
    level: str = "9/4",
    initials: str = "1e-2 1e-4 1e-12",
    scale: str = "1",
) -> Evidence:
    """Lower bound of the lemma, phi(z) >= phi_n I_0(C z), with C = scale (1 - lag/z_n).

    z_n: first z with phi = phi* = level; at six places in (0, z_n] for each phi_n.
    """
    del setting

    def rows() -> Iterator[Row]:
        for name in initials.split():
            last = initial_angles.crossing(name, Fraction(level))
            constant = initial_angles.fraction(scale) * (1 - initial_angles.fraction(lag) / last)
            for part in (16, 15, 14, 12, 8, 4):
                z = last * part / 16
                bound = initial_angles.ball(name) * (constant * z).bessel_i(0)
                place = f"phi_n I_0(C z) against phi, z = {_short(z)}, phi_n = {name}"
                yield place, bound, initial_angles.angle(name, z)

    return bounded(
        rows(), shown=f"the bound holds with C = 1 - {lag}/z_n, which tends to 1", sampled=True
    )


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
