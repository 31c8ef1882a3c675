"""How low the angles fall if the bounds observed hold: growth when small, the last cut above."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import cut_scaling as printed
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.bessel_balls import alpha_star, i0, text
from checks.verify.extremes import reference_ball
from checks.verify.initial_angles import fraction
from theory import angle_floor, bessel_expansions, bessel_reference, painleve

ALPHA, RADIUS = sp.symbols("alpha_star R", positive=True)
RADII = ("1", "3/2", "2", "3", "6", "10", "100", "1e4", "1e8")


def growth_below(setting: Setting, *, room: int = 1) -> Evidence:
    """Ratio (alpha_n/alpha*)^2 at an angle at most phi_min, at distance s_n < room R."""
    w, t = sp.symbols("w t", positive=True)
    x = printed.smallest_argument(ALPHA, RADIUS, sp) * (1 + w)
    excess = sp.cancel(printed.alpha_squared(x, room * RADIUS / (1 + t)) / ALPHA**2) - 1
    return combined(
        {
            "phi_min, s = room R": identities(setting, {"excess": _at_zero(excess)}, shown=""),
            "below": positivity(setting, {"(alpha_n/alpha*)^2 - 1": excess}, shown=""),
        },
        shown="X >= 2 alpha* sqrt R and s_n < R give (alpha_n/alpha*)^2 = X^2/(4 s_n alpha*^2) > 1",
    )


def _at_zero(excess: Any) -> Any:
    w, t = sp.symbols("w t", positive=True)
    return excess.subs({w: 0, t: 0})


def floor(setting: Setting, *, least: str = "0", drop: int = 3) -> Evidence:
    """Whether from above phi_min no cut that the bounds allow leads below it, for all R >= least.

    The lowest place is reached from X = Y/sqrt 3 or from X = Y (theory.angle_floor); in w = Y^2/4
    the condition has coefficients >= 0 but for the constant one: it holds from some R on.
    """
    del setting
    radii = [r for r in RADII if Fraction(r) >= Fraction(least)]
    radii += [least] if Fraction(least) > 0 else []
    rising = all(
        angle_floor.coefficient(k, Fraction(drop), Fraction(drop)) >= 0 for k in range(1, 40)
    )

    def rows() -> Iterator[Row]:
        for radius in sorted(radii, key=Fraction):
            r = fraction(radius)
            y = printed.smallest_argument(alpha_star(), r, BALLS)
            x = y / arb(drop).sqrt()
            third, _ = printed.kept_share(x**2 / y**2, drop=drop)
            lowest = fraction(str(third)) / i0(x)
            smallest = printed.smallest_angle(arb(1), alpha_star(), r, i0, BALLS)
            place = f"phi_min/phi* against the lowest phi_(n+1)/phi*, from {text(1 / i0(x))}"
            yield f"{place}, R = {radius}", smallest, lowest

    return combined(
        {
            "least radius": bounded(rows(), shown=""),
            "larger radii": statement(rising, shown="", witness="a coefficient is negative"),
            "other angles": _convex(),
        },
        shown="I_0(Y) - 3 I_0(Y/sqrt 3) is >= 0 at the least R and increases: for all larger R no "
        "cut leads below phi_min",
    )


def _convex() -> Evidence:
    """Second derivative of I_0(X)/X^2 in X^2: coefficients a_2k (k - 1)(k - 2), none negative."""
    even = bessel_expansions.origin_coefficients(40)[::2]
    bends = [a * (k - 1) * (k - 2) for k, a in enumerate(even)]
    return statement(min(bends) >= 0, shown="", witness=f"a coefficient is {min(bends)}")


def least_radius(setting: Setting, *, value: str = "2.05699491638609") -> Evidence:
    """Radius from which no angle falls below phi_min, by two routes, against a decimal."""
    del setting
    places = len(value.partition(".")[2])

    def rows() -> Iterator[Row]:
        found = angle_floor.least_radius(digits=30).ball()
        other = reference_ball(angle_floor.least_radius_reference(digits=30))
        yield "radius by two routes", abs(found - other), arb(10) ** -25
        place = f"distance of {found.str(17, radius=False)} from {value}"
        yield place, abs(found - fraction(value)), arb(1) / (2 * 10**places)

    return bounded(rows(), shown=f"R_0 = {value} to the digits shown")


def lowest_on_grid(setting: Setting, *, radii: str = "33/16 3 6 10 100") -> Evidence:
    """Lowest angle after one cut over phi_min, on a grid of 400 angles above phi_min."""
    names, lowest = radii.split(), {}
    with mp.workdps(setting.digits):
        for name in names:
            exact = Fraction(name)
            root = mp.sqrt(mp.mpf(exact.numerator) / exact.denominator)
            y = 2 * bessel_reference.supporting_scale(digits=setting.digits) * root
            lowest[name] = angle_floor.lowest_share(y)
        low = [f"{mp.nstr(v, 8)} for R = {k}" for k, v in lowest.items() if v < 1]
    return Evidence(
        outcome="fail" if low else "pass",
        grade="numeric",
        digits=setting.digits,
        tried=400 * len(names),
        met=400 * len(names),
        shown="no cut that the bounds allow leads from above phi_min below it, on the grid",
        witness=f"an angle falls to phi_min times {low[0]}" if low else "",
    )


def daughters_below(setting: Setting, *, radius: str = "1") -> Evidence:
    """Whether every daughter, at most phi*/3, lies below phi_min on a disk of this radius.

    There is one if phi_0 = pi/2, phi* = 8/5: phi is 8/5 at u = v = z/2, within z of the centre.
    """
    del setting

    def rows() -> Iterator[Row]:
        smallest = printed.smallest_angle(arb(1), alpha_star(), fraction(radius), i0, BALLS)
        yield f"1/3 against phi_min/phi*, R = {radius}", arb(1) / 3, smallest
        z = painleve.crossing(lambda: arb.pi() / 2, Fraction(8, 5), digits=20).ball()
        yield f"z with phi(z) = 8/5 against R = {radius}", z, fraction(radius)

    return bounded(
        rows(),
        shown=f"phi_min > phi*/3 for R = {radius}: whatever the run, each daughter is below it",
    )


def sufficient(
    setting: Setting, *, numerator: int = 2, scale: int = 3, growth: str = "1", drop: int = 3
) -> Evidence:
    """Floor of the angles if phi_(n+1)/phi_n >= f(2 C alpha_n^2), f >= growth from A on.

    Threshold phi*/I_0(k sqrt R) with k^2 = numerator A/C; constant C' = sqrt(scale) k.
    """
    c, big, w, t = sp.symbols("C A w t", positive=True)
    x = sp.sqrt(numerator * big / c) * sp.sqrt(RADIUS) * (1 + w)
    argument = 2 * c * printed.alpha_squared(x, RADIUS / (1 + t))
    shares = Fraction(1, 3), Fraction(growth)
    lowest = min(
        angle_floor.lowest_on_path(lambda angle: shares[angle <= 1], start)
        for start in (Fraction(1001, 1000), Fraction(2), Fraction(10))
    )
    signs = [angle_floor.coefficient(k, Fraction(drop), Fraction(scale)) for k in range(1, 40)]

    def rows() -> Iterator[Row]:
        yield (
            "3 I_0(k sqrt R) minus I_0(C' sqrt R), C'^2 R = 64",
            -angle_floor.excess(arb(angle_floor.MOST_W), drop=drop, scale=scale),
            arb(0),
        )

    return combined(
        {
            "at the threshold": identities(
                setting, {"2 C alpha^2 - A": _at_zero(argument - big)}, shown=""
            ),
            "below the threshold": positivity(
                setting, {"2 C alpha^2 - A": sp.cancel(argument - big)}, shown=""
            ),
            "lowest angle": statement(
                lowest >= Fraction(1, 3),
                shown="",
                witness=f"angles fall to {float(lowest):.4g} times the threshold in 200 cuts",
            ),
            "C'": bounded(rows(), shown=""),
            "larger R": statement(min(signs) >= 0, shown="", witness="a coefficient is negative"),
        },
        shown="below phi*/I_0(k sqrt R), k^2 = 2 A/C, the argument exceeds A and no angle falls; "
        "from above one cut reaches a third of it, at least phi*/I_0(sqrt(3) k sqrt R) for large R",
    )
