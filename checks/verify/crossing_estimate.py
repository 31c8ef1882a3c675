"""Checks of the first crossing of pi: its value, and its estimate (eqa5, line 3)."""

from collections.abc import Iterator

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.printed import painleve_asymptotics as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.convergence import order as observed_order
from theory import painleve_matching


def estimate(
    setting: Setting, *, slow: str = "0", constant: str = "1", inverse: str = "0"
) -> Evidence:
    """Distance of the estimate from z*, 1/z*^2 allowed, for phi0 from pi/100 to 1e-12."""
    del setting

    def rows() -> Iterator[Row]:
        for name in ("1e-12", "1e-9", "1e-6", "1e-4", "pi/100"):
            z = initial_angles.crossing(name)
            claimed = printed.crossing_estimate(
                initial_angles.ball(name), z, BALLS, slow=slow, constant=constant, inverse=inverse
            )
            place = f"distance of the estimate {claimed.str(8, radius=False)} from z* = "
            yield f"{place}{z.str(8, radius=False)}, phi0 = {name}", abs(z - claimed), 1 / z**2

    return bounded(
        rows(),
        shown="z* is within 1/z*^2 of -log phi0 + log(2 pi z*)/2 + log 4 + 1/(8 z*) for phi0 = "
        "pi/100 to 1e-12",
        sampled=True,
    )


def excess(setting: Setting, *, constant: str = "329/100") -> Evidence:
    """Whether z* + log phi0 exceeds a constant and grows as phi0 falls."""
    del setting

    def rows() -> Iterator[Row]:
        last = initial_angles.fraction(constant)
        for name in ("pi/100", "1e-2", "1e-4", "1e-6", "1e-9", "1e-12", "1e-50"):
            now = initial_angles.crossing(name) + initial_angles.ball(name).log()
            yield f"excess before against that for phi0 = {name}", last, now
            last = now

    return bounded(
        rows(), shown="z* + log phi0 grows from 3.29 for pi/100 over 4.04 for 1e-12", sampled=True
    )


def ratio(setting: Setting, *, initial: str = "1e-100", most: str = "1/40") -> Evidence:
    """Whether z*/(-log phi0) - 1 is at most this."""
    del setting

    def rows() -> Iterator[Row]:
        quotient = initial_angles.crossing(initial) / -initial_angles.ball(initial).log()
        place = f"z*/(-log phi0) - 1 for phi0 = {initial}"
        yield place, quotient - 1, initial_angles.fraction(most)

    return bounded(rows(), shown=f"for phi0 = {initial}, -log phi0 is within {most} of z*")


def estimate_order(
    setting: Setting, *, constant: str = "4", slow: str = "1/2", order: int = -1
) -> Evidence:
    """Order in z* of the distance of the estimate without its last term, phi0 = 1e-12 to 1e-80."""
    del setting
    levels, errors = [], []
    with mp.workdps(30):
        for name in ("1e-12", "1e-24", "1e-48", "1e-80"):
            z = initial_angles.reference_crossing(name, digits=25)
            phi0 = mp.mpf(10) ** int(name[2:])
            claimed = printed.crossing_estimate(phi0, z, mp, slow=slow, constant=constant)
            levels.append(z)
            errors.append(z - claimed)
        return observed_order(
            levels, errors, order, digits=20, shown="z* + log phi0 - log(2 pi z*)/2 - log 4 in z*"
        )


def derivation(
    setting: Setting, *, slow: str = "0", constant: str = "1", inverse: str = "0"
) -> Evidence:
    """Estimate that follows from matching the separatrix with phi0 I_0(z)."""
    phi0, z = sp.symbols("phi_0 z", positive=True)
    level, first = painleve_matching.crossing_terms()
    matched = -sp.log(phi0) + sp.log(2 * sp.pi * z) / 2 + level + first / z
    claimed = printed.crossing_estimate(phi0, z, sp, slow=slow, constant=constant, inverse=inverse)
    return identities(
        setting,
        {"printed minus matched": sp.expand(claimed - matched)},
        shown="the tails 4 e^t (1 + (1/4 - t/2)/z*) and D e^t (1 + (1/8 - t/2)/z*), D = phi0 "
        "e^z*/sqrt(2 pi z*), agree for D = 4 + 1/(2 z*)",
    )


def reference_agrees(setting: Setting, *, shift: str = "0") -> Evidence:
    """Certified and reference values of z* for phi0 from pi/100 to 1e-12."""
    del setting

    def rows() -> Iterator[Row]:
        for name in ("pi/100", "1e-2", "1e-4", "1e-6", "1e-9", "1e-12"):
            z = initial_angles.crossing(name)
            other = initial_angles.reference_crossing_ball(name)
            difference = z - other + initial_angles.fraction(shift)
            yield f"difference of the routes, phi0 = {name}", abs(difference), arb(10) ** -20

    return bounded(rows(), shown="the two routes give the same z* to 20 digits", sampled=True)


def crossing_number(setting: Setting, *, value: str = "9", initial: str = "pi/100") -> Evidence:
    """First crossing of pi against a number, to half a unit of its last place, by two routes."""
    del setting
    places = len(value.partition(".")[2])

    def rows() -> Iterator[Row]:
        z = initial_angles.crossing(initial)
        claimed = initial_angles.fraction(value)
        other = initial_angles.reference_crossing_ball(initial)
        place = f"distance of z* = {z.str(10, radius=False)} from {value}, phi0 = {initial}"
        yield place, abs(z - claimed), arb(1) / (2 * 10**places)
        yield "distance of the two routes", abs(z - other), arb(10) ** -20

    return bounded(rows(), shown=f"z* = {value} to the digits shown, by both routes")


def angle_of_crossing(
    setting: Setting, *, z: str = "9", low: str = "0.003790746", high: str = "0.003790747"
) -> Evidence:
    """Whether the initial angle whose first crossing is at z lies between two numbers."""
    del setting

    def rows() -> Iterator[Row]:
        at = initial_angles.fraction(z)
        yield f"z - z*({low})", at - initial_angles.crossing(low), arb(0)
        yield f"z*({high}) - z", initial_angles.crossing(high) - at, arb(0)

    return bounded(rows(), shown=f"z* = {z} for an angle between {low} and {high}, about pi/829")
