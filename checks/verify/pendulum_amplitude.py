"""Checks of the substitution that gives the amplitude of the pendulum (appendix A)."""

from collections.abc import Iterator

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.order import order_of_zero
from checks.printed import painleve_asymptotics as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.convergence import order as observed_order
from theory import painleve_matching, painleve_reference

Z, CROSSING = sp.symbols("z c", positive=True)
AMPLITUDE = sp.Function("A")(Z)
RATE = sp.diff(AMPLITUDE, Z)
SINE, COSINE = sp.sin(CROSSING - Z), sp.cos(CROSSING - Z)
ANGLE = sp.pi - AMPLITUDE * SINE


def first_line(setting: Setting, *, rate_sign: int = 1) -> Evidence:
    """Energy of phi = pi - A(z) sin(z* - z) against the first line, A' kept."""
    bracket = printed.rate_of_angle(AMPLITUDE, RATE, SINE, COSINE, rate_sign=rate_sign)
    true = printed.energy(ANGLE, sp.diff(ANGLE, Z), sp)
    return identities(
        setting,
        {"energy minus the line": true - bracket**2 / 2 - sp.cos(ANGLE)},
        shown="phi' = -A' sin(z* - z) + A cos(z* - z)",
    )


def second_line(
    setting: Setting, *, level: int = -1, coefficient: str = "1/2", order: int = 4
) -> Evidence:
    """Order in phi - pi of what the second line drops."""
    del setting
    angle = sp.Symbol("a", real=True)
    dropped = sp.cos(angle) - printed.near_pi(angle, sp, level=level, coefficient=coefficient)
    found = order_of_zero(dropped, angle, sp.pi, most=8)
    return statement(
        found == order,
        shown="cos phi = -1 + (pi - phi)^2/2 + O((pi - phi)^4): exact at phi = pi, where A is read",
        witness=f"the terms dropped are of order (pi - phi)^{found}",
    )


def third_line(setting: Setting, *, coefficient: str = "1/2", power: int = 2) -> Evidence:
    """Quadratic potential on phi = pi - A sin(z* - z)."""
    form = printed.third_line(AMPLITUDE, SINE, coefficient=coefficient, power=power)
    return identities(
        setting,
        {"potential": printed.near_pi(ANGLE, sp) + 1 - form},
        shown="pi - phi = A sin(z* - z)",
    )


def fourth_line(
    setting: Setting, *, joined: str = "product", rate_sign: int = 1, mixed: int = -2
) -> Evidence:
    """Fourth line against the third, whose bracket has the sign rate_sign of A'."""
    bracket = printed.rate_of_angle(AMPLITUDE, RATE, SINE, COSINE, rate_sign=rate_sign)
    third = bracket**2 / 2 - 1 + printed.third_line(AMPLITUDE, SINE)
    fourth = printed.fourth_line(AMPLITUDE, RATE, SINE, COSINE, joined=joined, mixed=mixed)
    return identities(
        setting,
        {"third minus fourth line": third - fourth},
        shown="the lines agree with -A' in the first three and a plus sign after -1",
    )


def amplitude_algebra(setting: Setting, *, coefficient: str = "1/48", power: int = 4) -> Evidence:
    """Solution A of the fourth line for A' = 0 and the printed energy."""
    delta = sp.Symbol("delta", positive=True)
    a = printed.amplitude(delta, sp, coefficient=coefficient, power=power)
    line = printed.fourth_line(a, 0, SINE, COSINE, joined="sum")
    return identities(
        setting,
        {"energy": line - printed.data_energy(delta)},
        shown="-1 + A^2/2 = 1 + delta^4/24 gives A = 2 sqrt(1 + delta^4/48)",
    )


def amplitude_value(
    setting: Setting, *, form: str = "data", factor: str = "1", coefficient: str = "1/48"
) -> Evidence:
    """Distance of the form from A = phi'(z*), 3/(2 z*^2) allowed, for phi0 from pi/100 to 1e-100.

    form: `data` for the printed one, delta = 1/10, or `friction` for 2 - factor * 2/z*.
    """
    del setting
    slope = painleve_matching.crossing_slope().coeff(painleve_matching.EPSILON)

    def rows() -> Iterator[Row]:
        for name in ("pi/100", "1e-4", "1e-8", "1e-12", "1e-100"):
            z = initial_angles.crossing(name)
            true = initial_angles.slope(name, z)
            if form == "data":
                claimed = printed.amplitude(arb(1) / 10, BALLS, coefficient=coefficient)
            else:
                claimed = 2 + initial_angles.fraction(factor) * int(slope) / z
            place = f"error of A, phi0 = {name}, phi'(z*) = {true.str(7, radius=False)}"
            yield place, abs(claimed - true), 3 / (2 * z * z)

    return bounded(
        rows(),
        shown="A = phi'(z*) is within 3/(2 z*^2) of 2 - 2/z*, and so below 2",
        sampled=True,
    )


def amplitude_order(setting: Setting, *, constant: str = "2", order: int = -1) -> Evidence:
    """Order in z* of phi'(z*) - constant, for phi0 = 1e-6 to 1e-48."""
    del setting
    levels, errors = [], []
    with mp.workdps(30):
        limit = mp.mpf(constant.split("/")[0]) / int(constant.partition("/")[2] or 1)
        for name in ("1e-6", "1e-12", "1e-24", "1e-48"):
            z = initial_angles.reference_crossing(name, digits=28)
            slope = painleve_reference.slope(initial_angles.reference(name), z, digits=20)
            levels.append(z)
            errors.append(slope - limit)
        return observed_order(levels, errors, order, digits=18, shown="phi'(z*) - 2 in z*")


def amplitude_derivation(setting: Setting, *, factor: str = "1") -> Evidence:
    """First correction to the separatrix by friction, and the slope at z* that it gives."""
    x, t, e = painleve_matching.X, painleve_matching.T, painleve_matching.EPSILON
    rate = painleve_matching.rate
    correction = sp.Rational(factor) * painleve_matching.damped_correction()
    slope = rate(painleve_matching.separatrix())
    cosine = painleve_matching.separatrix_functions()[1]
    at_crossing = {x: 1, t: 0}
    level = (slope + e * rate(correction)).subs(at_crossing) ** 2 / 2 - 1
    lost = painleve_matching.energy_lost().subs(x, 1)
    return combined(
        {
            "equation": identities(
                setting,
                {"first order": rate(rate(correction)) - cosine * correction + slope},
                shown="friction to first order",
            ),
            "crossing": identities(
                setting,
                {
                    "angle": correction.subs(at_crossing),
                    "energy": sp.diff(level, e).subs(e, 0) + lost,
                },
                shown="at z*",
            ),
        },
        shown="phi_1'' - cos(Phi) phi_1 = -Phi'; the energy lost up to z* is 4/z*, so that "
        "phi'(z*) = 2 - 2/z* + O(1/z*^2)",
    )
