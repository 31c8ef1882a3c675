"""Checks of the pendulum near its upper equilibrium and of its data (appendix A)."""

from collections.abc import Iterator
from typing import Any

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

Z = sp.Symbol("z", positive=True)
ANGLES = ("pi/100", "1e-4", "1e-8", "1e-12")


def damped_pendulum(setting: Setting, *, damping: int = -1, sine: int = -1) -> Evidence:
    """PIII as a pendulum about pi, psi = pi - phi, with friction 1/z."""
    f, df, ddf = sp.symbols("f f1 f2", real=True)
    left, right = printed.pendulum_sides(f, df, ddf, Z, damping=damping, sine=sine)
    piii = ddf + df / Z - sp.sin(f)
    psi = {f: sp.pi - f, df: -df, ddf: -ddf}
    mirrored = (left - right).subs(psi, simultaneous=True)
    return identities(
        setting,
        {
            "PIII": left - right - piii,
            "pendulum with friction": mirrored + ddf + sp.sin(f) + df / Z,
        },
        shown="PIII rearranged; psi = pi - phi has psi'' + sin psi = -psi'/z, friction 1/z",
    )


def dropped_friction(setting: Setting, *, power: str = "1", most: str = "2") -> Evidence:
    """Size of phi'/z on the way to z*: at most most/z^power.

    The slope at z* is 2 - 2/z* + O(1/z*^2), so that the last phi0 leaves little room below 2.
    """
    del setting

    def rows() -> Iterator[Row]:
        for name in (*ANGLES, "1e-60"):
            crossing = initial_angles.crossing(name)
            for quarter in (2, 3, 4):
                z = crossing * quarter / 4
                slope = initial_angles.slope(name, z)
                place = f"|phi'/z| z^{power} at z = {z.str(6, radius=False)}, phi0 = {name}"
                size = abs(slope / z) * z ** initial_angles.fraction(power)
                yield place, size, initial_angles.fraction(most)

    return bounded(rows(), shown="0 < phi' < 2, so that the friction is below 2/z", sampled=True)


def conserved(setting: Setting, *, potential: int = 1, kinetic: str = "1/2") -> Evidence:
    """Rate of the energy along phi'' = sin phi, and the force of the potential."""
    f = sp.Function("phi")(Z)
    df = sp.diff(f, Z)
    value = printed.energy(f, df, sp, potential=potential, kinetic=kinetic)
    rate = sp.diff(value, Z).subs(sp.diff(f, Z, 2), sp.sin(f))
    angle = sp.Symbol("a", real=True)
    force = -sp.diff(printed.energy(angle, 0, sp, potential=potential), angle)
    return identities(
        setting,
        {"rate of E": rate, "force": force - sp.sin(angle)},
        shown="dE/dz = phi' (phi'' - sin phi) = 0, and -d(cos phi)/d phi = sin phi",
    )


def dissipated(setting: Setting, *, factor: int = -1) -> Evidence:
    """Rate of the energy along PIII itself, factor * phi'^2/z, and the bound that follows."""
    f = sp.Function("phi")(Z)
    df = sp.diff(f, Z)
    rate = sp.diff(printed.energy(f, df, sp), Z).subs(sp.diff(f, Z, 2), sp.sin(f) - df / Z)
    start = sp.Symbol("phi_0", positive=True)
    at_pi = 2 * (printed.energy(start, 0, sp) - printed.energy(sp.pi, 0, sp))
    return identities(
        setting,
        {
            "rate of E": rate - factor * df**2 / Z,
            "most that phi'^2 can be at pi": at_pi - 4 * sp.cos(start / 2) ** 2,
        },
        shown="dE/dz = -phi'^2/z <= 0 and E = cos phi0 at z = 0: phi'(z*) < 2 cos(phi0/2) < 2",
    )


def pendulum_solution(setting: Setting, *, centre: str = "1", rate: str = "1") -> Evidence:
    """Linearisation of phi'' = sin phi about the centre, and pi - A sin(z* - z) in it."""
    a, crossing = sp.symbols("A c", real=True)
    form = printed.pendulum(Z, crossing, a, sp, rate=rate, centre=centre)
    middle = sp.Rational(centre) * sp.pi
    stiffness = sp.cos(middle)
    return identities(
        setting,
        {
            "equilibrium": sp.sin(middle),
            "linearised": sp.diff(form, Z, 2) - stiffness * (form - middle),
            "crossing": form.subs(Z, crossing) - sp.pi,
        },
        shown="about pi, phi'' = -(phi - pi), which pi - A sin(z* - z) solves for constant A",
    )


def pendulum_order(
    setting: Setting, *, factor: str = "1", rate: str = "1", order: int = 2
) -> Evidence:
    """Order in z* - z of phi_pend - phi with A = factor * phi'(z*), for three phi0."""
    del setting
    parts = {}
    for name in ("pi/100", "1e-6", "1e-12"):
        phi0 = initial_angles.reference(name)
        with mp.workdps(40):
            crossing = initial_angles.reference_crossing(name, digits=35)
            slope = painleve_reference.slope(phi0, crossing, digits=30)
            a = slope * mp.mpf(factor.split("/")[0]) / int(factor.partition("/")[2] or 1)
            levels = [mp.mpf(2) ** -k for k in range(5, 10)]
            errors = [
                printed.pendulum(crossing - tau, crossing, a, mp, rate=rate)
                - painleve_reference.angle(phi0, crossing - tau, digits=30)
                for tau in levels
            ]
            parts[name] = observed_order(levels, errors, order, digits=25, shown=name)
    return combined(parts, shown="with A = phi'(z*) the error is of order (z* - z)^2 near z*")


def swing_of_the_separatrix(
    setting: Setting, *, amplitude: int = 2, coefficient: str = "1/15"
) -> Evidence:
    """Undamped solution 4 arctan e^(z - z*) against pi - A sin(z* - z), in tau = z* - z."""
    tau = sp.Symbol("tau", real=True)
    form = printed.pendulum(-tau, sp.Integer(0), amplitude, sp)
    solution = painleve_matching.separatrix().subs(painleve_matching.X, sp.exp(-tau))
    derivatives = [solution - form]
    for _ in range(5):
        derivatives.append(sp.diff(derivatives[-1], tau))
    values = [derivative.subs(tau, 0) for derivative in derivatives]
    return identities(
        setting,
        {
            "below tau^5": values[:5],
            "tau^5": values[5] / sp.factorial(5) + sp.Rational(coefficient),
        },
        shown="pi - 2 sin(tau) exceeds the separatrix by tau^5/15 + O(tau^7): small for tau < 1, "
        "although the swing of amplitude 2 is no small oscillation",
    )


def slow_law(setting: Setting, *, power: str = "1/2") -> Evidence:
    """Amplitude z^-power in the equation linearised about pi, with its friction."""
    exponent = sp.Rational(power)
    phase = sp.Symbol("p", real=True)
    swing = Z**-exponent * sp.sin(Z + phase)
    left = sp.diff(swing, Z, 2) + sp.diff(swing, Z) / Z + swing
    remainder = sp.Rational(1, 4) * Z ** (-exponent - 2) * sp.sin(Z + phase)
    scaled = sp.expand((left - remainder) * Z ** (exponent + 2))
    return identities(
        setting,
        {"z^2 (equation - A sin/(4 z^2))/A": sp.powsimp(scaled)},
        shown="psi = z^(-1/2) sin(z + p) leaves psi/(4 z^2): A falls like z^(-1/2), by about "
        "pi/z in a period 2 pi",
    )


def slow_amplitude(
    setting: Setting, *, initial: str = "pi/100", most: str = "1/10", power: str = "0"
) -> Evidence:
    """Relative fall of A = sqrt(2 (E + 1)) up to z*, and from z* to z* + 2 pi, times z*^power."""
    del setting

    def amplitude(z: Any) -> Any:
        phi, slope = initial_angles.angle_and_slope(initial, z)
        return (2 * (1 + printed.energy(phi, slope, BALLS))).sqrt()

    def rows() -> Iterator[Row]:
        z = initial_angles.crossing(initial)
        first, start = amplitude(z), 2 * (initial_angles.ball(initial) / 2).cos()
        fall = 1 - amplitude(z + 2 * arb.pi()) / first
        place = f"z* = {z.str(6, radius=False)}, phi0 = {initial}"
        bound = initial_angles.fraction(most) / z ** initial_angles.fraction(power)
        yield f"fall of A in the period 2 pi after {place}", fall, bound
        yield f"fall of A up to {place}", 1 - first / start, bound

    return bounded(
        rows(),
        shown=f"for phi0 = {initial} A falls by less than {most} up to z* and in a period",
        sampled=True,
    )


def matching_data(
    setting: Setting, *, argument: str = "0", factor: str = "1", under: str = "2"
) -> Evidence:
    """Angle and slope at the argument against (delta, delta), within 1/(2 z) + delta^2.

    argument: `0` as printed, or `z` for the matching point itself.
    """
    del setting

    def rows() -> Iterator[Row]:
        for name, at in (("1e-4", 6), ("1e-8", 8), ("1e-8", 14), ("1e-12", 12), ("1e-12", 22)):
            z = arb(at)
            delta = printed.growth(initial_angles.ball(name), z, BALLS, under=under, factor=factor)
            place = arb(0) if argument == "0" else z
            phi, slope = initial_angles.angle_and_slope(name, place)
            for what, value in (("phi", phi), ("phi'", slope)):
                where = f"|{what}({argument})/delta - 1| for z = {at}, phi0 = {name}"
                yield where, abs(value / delta - 1), 1 / (2 * z) + delta**2

    return bounded(
        rows(),
        shown="angle and slope at z are delta to a relative error of 1/(2 z) + delta^2",
        sampled=True,
    )


def data_expansion(
    setting: Setting, *, level: int = 1, coefficient: str = "1/24", power: int = 4
) -> Evidence:
    """Order of the error of the printed energy of the data (delta, delta)."""
    del setting
    delta = sp.Symbol("delta", positive=True)
    form = printed.data_energy(delta, level=level, coefficient=coefficient, power=power)
    order = order_of_zero(printed.energy(delta, delta, sp) - form, delta, sp.Integer(0), most=8)
    return statement(
        order == 6,
        shown="delta^2/2 + cos delta = 1 + delta^4/24 + O(delta^6)",
        witness=f"the difference is of order delta^{order}",
    )


def separatrix_data(setting: Setting, *, coefficient: str = "0") -> Evidence:
    """Energy of the solution that tends to 0, whose slope is 2 sin(phi/2) = delta - delta^3/24."""
    delta = sp.Symbol("delta", positive=True)
    slope = painleve_matching.rate(painleve_matching.separatrix())
    sine = painleve_matching.separatrix_functions()[0]
    bent = painleve_matching.rate(slope)
    excess = printed.energy(delta, 2 * sp.sin(delta / 2), sp) - 1
    taylor = sp.series(2 * sp.sin(delta / 2), delta, 0, 5).removeO()
    return identities(
        setting,
        {
            "separatrix": sp.cancel(bent - sine),
            "excess energy": excess - sp.Rational(coefficient) * delta**4,
            "slope": taylor - delta + delta**3 / 24,
        },
        shown="the undamped solution that matches has slope delta - delta^3/24 and E = 1 exactly: "
        "the term delta^4/24 comes from the slope delta put in its place",
    )


def energy_correction(
    setting: Setting, *, correction: str = "data", factor: str = "-1/2", power: int = 4
) -> Evidence:
    """Whether the correction to E = 1 brings it nearer to the energy of the solution.

    correction: `data` for the printed delta^4/24, `friction` for factor * delta^2/z. At matching
    points z >= 8 with delta below 1/8; asked for: 1/(3 z) of the error of E = 1, as the Bessel
    functions give E - 1 = -delta^2/(2 z) (1 + 1/(4 z) + O(1/z^2)).
    """
    del setting

    def corrected(delta: Any, z: Any) -> Any:
        if correction == "data":
            return printed.data_energy(delta, power=power)
        return 1 + initial_angles.fraction(factor) * delta**2 / z

    def rows() -> Iterator[Row]:
        places = (("1e-4", 8), ("1e-8", 15), ("1e-8", 18), ("1e-12", 25), ("1e-12", 28))
        for name, at in (*places, ("1e-50", 110), ("1e-50", 114)):
            z = arb(at)
            delta = printed.growth(initial_angles.ball(name), z, BALLS)
            true = printed.energy(*initial_angles.angle_and_slope(name, z, digits=30), BALLS)
            place = f"error of the energy at z = {at}, phi0 = {name}, E - 1 = {_short(true - 1)}"
            yield place, abs(true - corrected(delta, z)), abs(true - 1) / (3 * z)

    return bounded(
        rows(),
        shown="E - 1 is -delta^2/(2 z) to a relative error of 1/(3 z), at seven matching points",
        sampled=True,
    )


def _short(ball: Any) -> str:
    return str(ball.str(4, radius=False))
