"""Checks of the growth with R of the least max curvature E(R) of periodic Amsler surfaces."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb, ctx
from mpmath import mp

from checks.ball import enclosure
from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.verify.ball_bounds import Row, bounded
from checks.verify.convergence import order as observed_order
from checks.verify.initial_angles import fraction
from theory import periodic_amsler, periodic_amsler_bounds, periodic_amsler_reference

RADIUS = sp.Symbol("R", positive=True)


def least_curvature(radius: Any, *, digits: int = 20) -> Any:
    """Ball of the least max curvature E(R) over the numbers of sectors."""
    return periodic_amsler.max_curvature(radius, digits=digits).ball()


def _stretches() -> Iterator[tuple[str, Any, Any]]:
    """Radii 1 to 12 and the stretches between them, with balls of R and of E(R), which grows."""
    last = least_curvature(1)
    yield "at 1", arb(1), last
    for right in range(2, 13):
        now = least_curvature(right)
        yield f"at {right}", arb(right), now
        yield f"on [{right - 1}, {right}]", arb(right - 1).union(arb(right)), last.union(now)
        last = now


def _range(lower: str, upper: str, power: str) -> Evidence:
    """Bounds lower R^power <= log E(R) <= upper R^power on [1, 12].

    Refuted only where a bound fails: a stretch too long to decide leaves it undecided.
    """

    def rows() -> Iterator[Row]:
        for place, radius, energy in _stretches():
            grown, found = radius ** fraction(power), energy.log()
            yield f"lower bound {place}", fraction(lower) * grown, found
            yield f"log E {place}", found, fraction(upper) * grown

    return bounded(rows(), shown="R/4 <= log E(R) <= 2 R on [1, 12]")


def _constants() -> Evidence:
    """Constants of the two bounds for all radii (theory.periodic_amsler_bounds)."""
    bounds = periodic_amsler_bounds

    def rows() -> Iterator[Row]:
        whole, square = bounds.integral_of_square()
        yield "integral of I_0^2 over [0, 1]", whole, square * 9 / 8
        yield "4/9 against I_1(1)/I_0(1)", arb(4) / 9, bounds.bessel_quotient()
        yield "0 against r' at r = 4/9, z >= 1", arb(0), 1 - arb(4) / 9 - (arb(4) / 9) ** 2
        yield "9 pi^2/256", 9 * arb.pi() ** 2 / 256, arb(7) / 20
        yield "5 against z_1 for m = 100", arb(bounds.LEAST_PLACE), bounds.least_place()
        yield "K at z_1 = 5", bounds.overshoot(arb(bounds.LEAST_PLACE)), arb(11) / 4
        yield "edge for m = 100", bounds.edge_distance(), arb(bounds.EDGE_WITHIN)

    return bounded(rows(), shown="the constants of the two bounds")


def _energy_steps(setting: Setting) -> Evidence:
    """The two differential identities of the bounds, and the coefficients of I_0 and sinh."""
    z, c = sp.symbols("z C", positive=True)
    phi, comparison = (sp.Function(name, positive=True)(z) for name in ("phi", "i"))
    second = sp.sin(phi) - phi.diff(z) / z
    fall = (phi.diff(z) ** 2 / 2 + sp.cos(phi)).diff(z).subs(phi.diff(z, 2), second)
    other = c**2 * comparison - comparison.diff(z) / z
    wronskian = z * (phi.diff(z) * comparison - phi * comparison.diff(z))
    grows = wronskian.diff(z).subs({phi.diff(z, 2): second, comparison.diff(z, 2): other})
    return identities(
        setting,
        {
            "phi'^2/2 + cos phi": fall + phi.diff(z) ** 2 / z,
            "phi against I_0(C z)": grows - z * comparison * (sp.sin(phi) - c**2 * phi),
        },
        shown="one falls; phi/I_0(C z) grows while sin phi > C^2 phi",
    )


def _beyond(setting: Setting, lower: str, upper: str, power: str) -> Evidence:
    """The bounds on R >= 12: at 12 by balls, and their growth; any other power by its limit."""
    x = sp.Symbol("x", positive=True)
    bounds = periodic_amsler_bounds
    least, most = bounds.least_exponent(), bounds.largest_exponent()
    p = sp.Rational(power)
    ratios = [sp.limit(rate * x / x**p, x, sp.oo) for rate in (least, most)]
    low, high = sp.Rational(lower), sp.Rational(upper)
    # d/dR log(sinh(y)/y) = C (coth y - 1/y) > C (1 - 1/y), and y >= C (12 - 11/4) > 7.
    rows = (
        ("at 12, from below", bounds.log_lower(RADIUS).subs(RADIUS, 12) - 12 * low),
        ("at 12, from above", 12 * high - bounds.log_upper(RADIUS).subs(RADIUS, 12)),
        ("y at 12", least * sp.Rational(37, 4) - 7),
        ("growth from below", least * sp.Rational(6, 7) - low),
        ("growth from above", high - most),
    )
    with ctx.workprec(128):
        unreached = [name for name, room in rows if not enclosure(room, {}) > 0]
    shown = "R/4 <= log E(R) <= 2 R for R >= 12"
    reached = Evidence(
        outcome="undecided" if unreached else "pass", grade="certified",
        shown=f"the proof does not reach: {', '.join(unreached)}" if unreached else shown,
        tried=len(rows), met=len(rows),
    )  # fmt: skip
    return combined(
        {
            "power": statement(
                ratios[0] != 0 and ratios[1] != sp.oo,
                shown="",
                witness=f"{least} R and sqrt(2) R, bounds but for a constant and log R, over "
                f"R^{power} tend to {ratios[0]} and {ratios[1]}",
            ),
            "rates": reached,
            "coth y > 1": positivity(setting, {"coth": sp.coth(x) - 1}, shown=""),
        },
        shown=shown,
    )


def scaling(
    setting: Setting, *, lower: str = "1/4", upper: str = "2", power: str = "1"
) -> Evidence:
    """Bounds lower R^power <= log E(R) <= upper R^power for all R >= 1, E at the best m."""
    return combined(
        {
            "R >= 12": _beyond(setting, lower, upper, power),
            "1 <= R <= 12": _range(lower, upper, power),
            "constants": _constants(),
            "steps": _energy_steps(setting),
        },
        shown="R/4 <= log E(R) <= 2 R for all R >= 1: by balls up to 12, beyond by (2/pi) "
        "sinh(y)/y <= E <= (2/pi)(2 e^(sqrt(2) R) + 1), y = sqrt(2/pi) (R - 11/4); the bound from "
        "above is a surface of ours, it does not follow from (e2)",
    )


def exponential(setting: Setting, *, power: str = "0") -> Evidence:
    """Order in R of E(R) e^-R at R = 5, 10, 20, 40, against a power; 0 is growth as exp(R).

    The order of the square is taken, so that the tolerance 0.1 means 0.05 in the power.
    """
    del setting
    with mp.workdps(30):
        levels = [mp.mpf(r) for r in (5, 10, 20, 40)]
        twice = 2 * mp.mpf(Fraction(power).numerator) / Fraction(power).denominator
        values = [_reference(int(r)) * mp.exp(-r) for r in levels]
        squares = [v**2 * r**-twice for r, v in zip(levels, values, strict=True)]
        shown = ", ".join(mp.nstr(v, 5) for v in values)
        return observed_order(
            levels, squares, 0, digits=15,
            shown=f"(E e^-R R^({-Fraction(power)}))^2 at R = 5, 10, 20, 40, E e^-R being {shown}",
        )  # fmt: skip


def _proved_constant(constant: str) -> Evidence:
    """Whether the constant of the proof, (4/pi) e^(7/20) sqrt(pi/8) + 2/(pi e), is not above."""
    with ctx.workprec(128):
        root = (arb.pi() / 8).sqrt()
        whole = 4 / arb.pi() * (arb(7) / 20).exp() * root + 2 / arb.pi() * arb(-1).exp()
        reached = bool(whole <= fraction(constant))
    return Evidence(
        outcome="pass" if reached else "undecided",
        grade="certified",
        shown=f"the constant of the proof is {whole.str(6, radius=False)}",
    )


def constant_bound(setting: Setting, *, constant: str = "3/2") -> Evidence:
    """Bound E(R) e^-R <= constant R^(-1/2) for all R >= 1: no multiple of exp(R) is below E.

    From E <= (2/pi)(2 I_0(R + 7/20) + 1) and e^-x I_0(x) <= sqrt(pi/(8 x)), as 1 - cos t >=
    2 t^2/pi^2 on [0, pi]; and sqrt(R) e^-R <= 1/e.
    """
    t, x = sp.symbols("t x", positive=True)
    gauss = sp.integrate(sp.exp(-2 * x * t**2 / sp.pi**2), (t, 0, sp.oo)) / sp.pi

    def rows() -> Iterator[Row]:
        most = fraction(constant)
        for radius in (1, 2, 5, 10, 20):
            value = least_curvature(radius)
            bessel = (arb(radius) + arb(7) / 20).bessel_i(0)
            yield f"E({radius})", value, 2 / arb.pi() * (2 * bessel + 1)
            yield (
                f"E e^-R sqrt(R), R = {radius}",
                value * arb(-radius).exp() * arb(radius).sqrt(),
                most,
            )

    return combined(
        {
            "integral": identities(
                setting, {"bound of I_0": gauss - sp.sqrt(sp.pi / (8 * x))}, shown=""
            ),
            "constants": _constants(),
            "whole": _proved_constant(constant),
            "rows": bounded(rows(), shown=""),
        },
        shown=f"E(R) <= {constant} R^(-1/2) e^R for all R >= 1",
    )


def half_disk(setting: Setting, *, share: str = "1/2") -> Evidence:
    """Whether E(R) >= cosh(share R) on [1, 12]: what bobbins have on disks of that radius.

    A smaller E would refute, together with the approximation of the half disks, that bobbins are
    optimal.
    """
    del setting

    def rows() -> Iterator[Row]:
        for place, radius, energy in _stretches():
            yield f"cosh({share} R) {place}", (fraction(share) * radius).cosh(), energy

    return bounded(
        rows(),
        shown="E(R) >= cosh(R/2) on [1, 12]: the argument by half disks is not contradicted; it "
        "bounds log E from below only",
    )


def bessel_growth(setting: Setting, *, constant: str = "1", order: int = -1) -> Evidence:
    """Order in 1/R of E(R)/(constant I_0(R)) - 1 at R = 10, 16, 25, 40."""
    del setting
    with mp.workdps(30):
        levels = [mp.mpf(r) for r in (10, 16, 25, 40)]
        c = mp.mpf(Fraction(constant).numerator) / Fraction(constant).denominator
        errors = [_reference(int(r)) / (c * mp.besseli(0, r)) - 1 for r in levels]
        return observed_order(
            levels, errors, order, digits=15,
            shown=f"E(R)/({constant} I_0(R)) - 1, {mp.nstr(errors[-1], 4)} at R = 40",
        )  # fmt: skip


def _reference(radius: int) -> Any:
    return periodic_amsler_reference.max_curvature(radius, digits=20)
