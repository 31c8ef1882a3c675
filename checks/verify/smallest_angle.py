"""The smallest angle phi_min, its decay with the radius, and the energy it allows."""

from collections.abc import Iterator
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import cut_scaling as printed
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.bessel_balls import alpha_star, i0, text
from checks.verify.initial_angles import fraction
from theory import bessel, bessel_envelope

ALPHA, RADIUS = sp.symbols("alpha_star R", positive=True)
RADII = ("1", "3/2", "2", "3", "6", "10", "100", "1e4", "1e8", "1e12", "1e30")


def solved(setting: Setting, *, factor: str = "2") -> Evidence:
    """Printed equation with the argument of I_0 in the printed phi_min in place of I_0^-1."""
    x = printed.smallest_argument(ALPHA, RADIUS, sp, factor=factor)
    return identities(
        setting,
        {"alpha^2 at s = R minus alpha*^2": printed.alpha_squared(x, RADIUS) - ALPHA**2},
        shown="X = 2 alpha* sqrt(R) is the positive solution of alpha*^2 = X^2/(4 R)",
    )


def inverted(setting: Setting, *, factor: str = "2") -> Evidence:
    """Printed equation at the printed phi_min, I_0 inverted by interval Newton."""
    del setting

    def rows() -> Iterator[Row]:
        for radius in ("1/10", "1", "6", "10", "100", "1e4"):
            for level in (arb.pi() / 2, 3 * arb.pi() / 4):
                r = fraction(radius)
                phi = printed.smallest_angle(level, alpha_star(), r, i0, BALLS, factor=factor)
                found = printed.alpha_squared(bessel.inverse_i0_ball(level / phi), r)
                place = f"alpha^2 of phi_min at s = R against alpha*^2, R = {radius}"
                yield place, abs(found - alpha_star() ** 2), arb(10) ** -25

    return bounded(
        rows(), shown="phi_min = phi*/I_0(2 alpha* sqrt R) solves the equation", sampled=True
    )


def decay(
    setting: Setting, *, factor: str = "1", under: int = 2, power: str = "0", size: str = "5/2"
) -> Evidence:
    """Whether phi_min/phi* is R^power e^-exponent for R >= 1, up to a factor of e^size.

    On all of R >= 1: log(phi_min/phi*) = -y + log(y)/2 + a bounded term, y = 2 alpha* sqrt R, so
    that the coefficients of sqrt R and of log R have to agree.
    """
    q, a = sp.symbols("q alpha_star", positive=True)
    exponent = printed.decay_exponent(a, q**2, sp, factor=factor, under=under)
    # Of log(y)/2, by the logarithm of R.
    growth = RADIUS * sp.diff(sp.log(printed.smallest_argument(ALPHA, RADIUS, sp)) / 2, RADIUS)

    def rows() -> Iterator[Row]:
        for radius in RADII:
            r = fraction(radius)
            y = printed.smallest_argument(alpha_star(), r, BALLS)
            below, above = bessel_envelope.log_bounds(y)
            claimed = printed.decay_exponent(alpha_star(), r, BALLS, factor=factor, under=under)
            claimed = claimed - fraction(power) * r.log()
            exact = [y.bessel_i(0).log()] if y < 10**5 else []
            where = f"-log(phi_min/phi*) against the exponent claimed, R = {radius}"
            for value in (*exact, below, above):
                yield where, abs(value - claimed), fraction(size)

    return combined(
        {
            "values": bounded(rows(), shown="", bits=256),
            "sqrt R": identities(
                setting,
                {"coefficient": exponent / q - printed.smallest_argument(a, q**2, sp) / q},
                shown="",
            ),
            "log R": identities(setting, {"power": growth - sp.Rational(power)}, shown=""),
        },
        shown="1/(pi sqrt e) <= I_0(y) sqrt(y) e^-y <= sqrt(pi/8) for y >= 1, so that phi_min/phi* "
        "is R^(1/4) e^(-2 alpha* sqrt R) up to bounded factors for all R >= 1",
    )


def rate(setting: Setting, *, factor: str = "1", under: int = 2, apart: str = "1/20") -> Evidence:
    """Quotient -log(phi_min/phi*)/sqrt R at R = 10^4, 10^6, 10^8 against the printed exponent's."""
    del setting

    def rows() -> Iterator[Row]:
        for radius in ("1e4", "1e6", "1e8"):
            r = fraction(radius)
            angle = printed.smallest_angle(arb(1), alpha_star(), r, i0, BALLS)
            found = -angle.log() / r.sqrt()
            claimed = printed.decay_exponent(alpha_star(), r, BALLS, factor=factor, under=under)
            claimed = claimed / r.sqrt()
            place = f"rate {found.str(6, radius=False)} against {claimed.str(6, radius=False)}"
            yield f"{place}, R = {radius}", abs(found - claimed), fraction(apart)

    return bounded(
        rows(), shown="-log(phi_min)/sqrt R tends to 2 alpha* = 2.3422", bits=256, sampled=True
    )


def energy_bound(setting: Setting, *, side: str = "both", rate: str = "3") -> Evidence:
    """Whether sqrt(R)/1000 <= log E <= rate sqrt(R) follows from (ebound) and phi >= phi_min.

    The largest E that the two allow has an angle phi_min; the smallest has all angles phi*/3.
    """
    del setting

    def rows() -> Iterator[Row]:
        yield "2 alpha* against the rate", 2 * alpha_star(), fraction(rate)
        for radius in ("3", "6", "10", "100", "1e4", "1e8"):
            for level in (arb.pi() / 2, 3 * arb.pi() / 4, 4 * arb.pi() / 5):
                r = fraction(radius)
                smallest = printed.smallest_angle(level, alpha_star(), r, i0, BALLS)
                top, least = _log_energy(smallest, level), _log_energy(level / 3, level)
                where = f"R = {radius}, phi* = {text(level)}"
                bound = fraction(rate) * r.sqrt()
                yield f"largest log E allowed against {rate} sqrt R, {where}", top, bound
                yield f"log(2/phi*) + 2 alpha* sqrt R, {where}", _linear(level, r), bound
                yield f"phi_min against phi*/3, {where}", smallest, level / 3
                if side == "both":
                    below = r.sqrt() / 1000
                    yield f"sqrt(R)/1000 against log E, all angles phi*/3, {where}", below, least

    return bounded(
        rows(),
        shown="log E <= 3 sqrt R for every R >= 3 and phi* from pi/2 to 4 pi/5, since cot(x/2) <= "
        "2/x and I_0(y) <= e^y; "
        "angles that stay at phi*/3 satisfy both premises with E bounded",
        bits=256,
    )


def _log_energy(angle: Any, level: Any) -> Any:
    return (angle / 2).cot().max((level / 2).tan()).log()


def _linear(level: Any, radius: Any) -> Any:
    return (2 / level).log() + 2 * alpha_star() * radius.sqrt()
