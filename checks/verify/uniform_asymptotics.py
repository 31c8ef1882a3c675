"""Check that an asymptotic description of PIII covers [0, z*] with an error that vanishes."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.printed import painleve_asymptotics as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.matched_asymptotics import ThirdLine
from theory import painleve_matching

PLACES = ("1/2", "9/8", "2", "4")
LEVELS = ("1/20", "3/10", "3/5", "7/5", "3")

Lines = list[Callable[[Any], Any]]


def _rational(expr: sp.Expr) -> Callable[[Any, Any], Any]:
    """Rational function of x and t with rational coefficients, for balls."""
    symbols = (painleve_matching.X, painleve_matching.T)
    top, bottom = (
        sp.Poly(sp.expand(part), *symbols).terms() for part in sp.fraction(sp.together(expr))
    )

    def polynomial(terms: Any, x: Any, t: Any) -> Any:
        return sum(arb(int(c.p)) / int(c.q) * x**i * t**j for (i, j), c in terms)

    return lambda x, t: polynomial(top, x, t) / polynomial(bottom, x, t)


def _printed_lines(name: str, amplitude: str) -> Lines:
    phi0 = initial_angles.ball(name)
    third = ThirdLine(amplitude=amplitude, name=name)
    return [lambda z: printed.inner(phi0, z), lambda z: printed.outer(phi0, z, BALLS), third]


def _matched_lines(name: str, *, friction: bool) -> Lines:
    """Linear solution, and separatrix through pi at z* with its first correction by friction."""
    phi0, crossing = initial_angles.ball(name), initial_angles.crossing(name)
    correction = _rational(painleve_matching.damped_correction() if friction else sp.Integer(0))

    def separatrix(z: Any) -> Any:
        t = z - crossing
        return 4 * t.exp().atan() + correction(t.exp(), t) / crossing

    return [lambda z: phi0 * z.bessel_i(0), separatrix]


def complete(
    setting: Setting, *, lines: str = "printed", share: str = "1/6", power: int = 1
) -> Evidence:
    """Least relative error among the lines at places of [0, z*]: at most share/z*^power.

    lines: `printed`, `2 - 2/z*` for a third line with that amplitude, `matched` for phi0 I_0(z)
    with the corrected separatrix, `undamped` for the separatrix without correction.
    """
    del setting

    def chosen(name: str) -> Lines:
        if lines in ("matched", "undamped"):
            return _matched_lines(name, friction=lines == "matched")
        return _printed_lines(name, lines)

    def rows() -> Iterator[Row]:
        for name in ("1e-6", "1e-20"):
            forms, crossing = chosen(name), initial_angles.crossing(name)
            early = [
                (z, initial_angles.angle(name, z)) for z in map(initial_angles.fraction, PLACES)
            ]
            late = [
                (initial_angles.crossing(name, Fraction(level)), initial_angles.fraction(level))
                for level in LEVELS
            ]
            for z, phi in early + late:
                least = abs(forms[0](z) / phi - 1)
                for form in forms[1:]:
                    least = least.min(abs(form(z) / phi - 1))
                place = f"least relative error at z = {z.str(6, radius=False)}, phi0 = {name}"
                yield place, least, initial_angles.fraction(share) / crossing**power

    return bounded(
        rows(), shown=f"lines {lines}: least relative error at most {share} of 1/z*", sampled=True
    )
