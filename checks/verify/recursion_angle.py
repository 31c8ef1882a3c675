"""The angle of an Amsler sector between two Bessel functions (eq:integral, eq:defC, boundCphi*)."""

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import amsler_recursion as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from theory import amsler, comparison

Z = comparison.Z
PARTS = ("1/1000", "1/8", "1/2", "7/8", "999/1000")


def integral_equation(
    setting: Setting, *, weight: int = 1, outer: int = -1, sign: int = 1
) -> Evidence:
    """Both directions of the equivalence with PIII, for an unknown function."""
    f = sp.Function("f", real=True)
    phi_n, c, d = sp.symbols("phi_n c d", real=True)
    right = printed.integral_equation(f, phi_n, Z, weight=weight, outer=outer, sign=sign)
    slope = right.diff(Z)
    operator = sp.expand((Z * slope).diff(Z) / Z)
    kernel = c + d * sp.log(Z)
    return identities(
        setting,
        {
            "the right side satisfies PIII": operator - sp.sin(f(Z)),
            "its value at 0": right.subs(Z, 0).doit() - phi_n,
            "what PIII leaves free": kernel.diff(Z, 2) + kernel.diff(Z) / Z,
            "slope of what is left free": Z * kernel.diff(Z) - d,
        },
        shown="the right side R has R'' + R'/z = sin phi, R(0) = phi_n; a solution of PIII differs "
        "from it by c + d log z, which is 0 where phi(0) = phi_n is finite",
    )


def integral_series(
    setting: Setting, *, weight: int = 1, outer: int = -1, sign: int = 1, order: int = 5
) -> Evidence:
    """Taylor series of PIII put into the integral equation."""
    w, xi = sp.symbols("w xi", positive=True)
    f = [sp.Integer(0), *amsler.similarity_coefficients(order)]
    sine = [k**2 * f[k] for k in range(1, order + 1)]
    inner = sum(
        sp.integrate(s * (xi**2 / 4) ** k * xi**weight, (xi, 0, w)) for k, s in enumerate(sine)
    )
    outside = sign * sp.integrate(sp.expand(inner * w**outer), (w, 0, Z))
    series = amsler.similarity_series(order, Z**2 / 4)
    return identities(
        setting,
        {"series": sp.expand(outside - series)},
        shown=f"the series of PIII satisfies the integral equation to order z^{2 * order}",
    )


def rises_to_threshold(setting: Setting, *, force: int = 1, damping: int = 1) -> Evidence:
    """Z phi' grows where 0 < phi < pi, at a rate that has a positive bound below."""
    t = sp.Symbol("t", positive=True)
    f = sp.Function("f", real=True)(Z)
    moment = Z**damping * f.diff(Z)
    by_piii = force * sp.sin(f) - f.diff(Z) / Z
    rate = sp.expand(moment.diff(Z).subs(f.diff(Z, 2), by_piii))
    return combined(
        {
            "moment": identities(
                setting, {"(z phi')' - z sin phi": rate - Z * sp.sin(f)}, shown="rate"
            ),
            "sine": positivity(
                setting, {"sin t on (0, pi)": comparison.half_angle(sp.sin(t), t)}, shown="sine"
            ),
        },
        shown="(z phi')' = z sin phi > 0 while 0 < phi < pi: phi rises as long as phi <= phi*; on "
        "[phi_n, phi*] the sine is at least s = min(sin phi_n, sin phi*), so phi >= phi_n + "
        "s z^2/4 and phi* is reached by z = 2 sqrt((phi* - phi_n)/s)",
    )


def threshold_samples(
    setting: Setting,
    *,
    initials: str = "1e-6 1/100 1 2 3",
    level: str = "157/50",
    late: str = "1",
    factor: str = "2",
) -> Evidence:
    """Slope at certified places of [0, late z*], and the bound on z* with this factor.

    In the last two pairs phi_n is near phi*, where the bound is nearly attained.
    """
    del setting
    pairs = [(name, level) for name in initials.split()] + [("1", "101/100"), ("2", "201/100")]

    def rows() -> Iterator[Row]:
        for name, threshold in pairs:
            phi_n, top = initial_angles.ball(name), initial_angles.fraction(threshold)
            crossing = initial_angles.crossing(name, Fraction(threshold))
            least = phi_n.sin().min(top.sin())
            place = f"z* for phi_n = {name}, phi* = {threshold}"
            most = initial_angles.fraction(factor) * ((top - phi_n) / least).sqrt()
            yield place, crossing, most
            for part in PARTS:
                z = crossing * initial_angles.fraction(part) * initial_angles.fraction(late)
                slope = initial_angles.slope(name, z)
                yield f"-phi' at {part} of the stretch, phi_n = {name}", -slope, arb(0)

    return bounded(
        rows(),
        shown="phi' > 0 at five places of [0, z*], and the bound on z*, for seven pairs phi_n < "
        "phi*, two of them with phi* - phi_n = 1/100",
        sampled=True,
    )


def sine_quotient(setting: Setting, *, scale: str = "1", root: bool = True) -> Evidence:
    """Fall of sin t/t on (0, pi), by the sign of the derivative's numerator."""
    t = sp.Symbol("t", positive=True)
    level = sp.Symbol("phi", positive=True)
    numerator, its_slope = comparison.sinc_slope(t)
    squared = printed.constant_squared(level, sp, scale=scale, root=root)
    excess = sp.diff(t - sp.sin(t), t)
    return combined(
        {
            "numerator": identities(
                setting,
                {
                    "t cos t - sin t at 0": numerator.subs(t, 0),
                    "its derivative": its_slope + t * sp.sin(t),
                    "equality at phi*": squared * level - sp.sin(level),
                    "t - sin t at 0": (t - sp.sin(t)).subs(t, 0),
                },
                shown="numerator",
            ),
            "signs": positivity(
                setting,
                {
                    "sin t": comparison.half_angle(sp.sin(t), t),
                    "(t - sin t)'": comparison.half_angle(excess, t),
                },
                shown="signs",
            ),
        },
        shown="(sin t/t)' = (t cos t - sin t)/t^2, whose numerator is 0 at 0 and has the slope "
        "-t sin t < 0 on (0, pi): sin t/t falls from 1, so C^2 = sin phi*/phi* < 1 is the largest "
        "constant on (0, phi*]; t - sin t grows from 0",
    )


def sine_samples(
    setting: Setting,
    *,
    scale: str = "1",
    upper: str = "1",
    levels: str = "1/100 1 2 3 157/50",
    below: str = "1",
) -> Evidence:
    """Both inequalities at certified places phi = part of phi*, and 0 < C^2 < 1."""
    del setting

    def rows() -> Iterator[Row]:
        for name in levels.split():
            level = initial_angles.fraction(name)
            squared = printed.constant_squared(level, BALLS, scale=scale)
            yield f"-C^2 for phi* = {name}", -squared, arb(0)
            yield f"C^2 for phi* = {name}", squared, arb(1)
            for part in PARTS:
                phi = level * initial_angles.fraction(part) * initial_angles.fraction(below)
                place = f"{part} of phi* = {name}"
                yield f"C^2 phi at {place}", squared * phi, phi.sin()
                yield f"sin phi at {place}", phi.sin(), initial_angles.fraction(upper) * phi

    return bounded(
        rows(), shown="C^2 phi < sin phi < phi below phi*, 0 < C < 1, for five phi*", sampled=True
    )


def linear_solution(
    setting: Setting, *, damping: int = 1, power: int = 2, order: int = 0
) -> Evidence:
    """Series of phi_n I_0(C z), coefficient by coefficient, in the linear equation."""
    k = sp.Symbol("k", positive=True, integer=True)
    phi_n, c = sp.symbols("phi_n C", positive=True)
    coefficient = phi_n * (c / 2) ** (2 * k + order) / (sp.factorial(k) * sp.factorial(k + order))
    before = coefficient.subs(k, k - 1)
    ratio = sp.combsimp(sp.simplify(coefficient / before))
    degree = 2 * k + order
    monomial = Z**degree
    left = printed.linear_side(
        sp.Integer(0), sp.diff(monomial, Z), sp.diff(monomial, Z, 2), Z, c, damping=damping
    )
    right = -printed.linear_side(Z ** (degree - 2), 0, 0, Z, c, power=power)
    return identities(
        setting,
        {
            "coefficient of z^(2k - 2)": sp.simplify(ratio * left / Z ** (degree - 2))
            - sp.simplify(right / Z ** (degree - 2)),
            "value at 0": coefficient.subs(k, 0) * (Z**order).subs(Z, 0) - phi_n,
        },
        shown="the coefficients phi_n (C/2)^(2k)/k!^2 satisfy the equation for every k >= 1, start "
        "from phi_n and have no odd powers, so that the slope at 0 is 0",
    )


def wronskian(setting: Setting, *, power: int = 2, upper: str = "1", sine: int = 1) -> Evidence:
    """Growth of phi/(phi_n I_0(C z)) and fall of phi/(phi_n I_0(z)), for every phi_n and phi*."""
    u, v = comparison.unknowns()
    gap = sp.Symbol("gap", positive=True)
    c = sp.Symbol("C", positive=True)
    top = sp.Rational(upper)
    linear = [-printed.linear_side(v, 0, 0, Z, k, power=power) for k in (c, top)]
    lower_rate = comparison.wronskian_rate(sine * (c**2 + gap) * u, linear[0])
    upper_rate = comparison.wronskian_rate(sine * (1 - gap) * u, linear[1])
    return combined(
        {
            "identities": identities(
                setting,
                {
                    "for I_0(C z)": lower_rate - u * v * gap,
                    "for I_0(z)": upper_rate + u * v * gap,
                },
                shown="rates",
            ),
            "signs": positivity(
                setting,
                {"for I_0(C z)": lower_rate, "for I_0(z)": -upper_rate},
                shown="signs",
            ),
            "iteration": _iteration(setting),
        },
        shown="with sin phi/phi = C^2 + gap, gap >= 0 by (eq:defC), (z (U' V - U V'))' = z U V gap "
        "for U = phi/phi_n, V = I_0(C z): U/V grows from 1; with sin phi/phi = 1 - gap and "
        "V = I_0(z) it falls; the double integral has the kernel xi log(z/xi) >= 0, and its n-th "
        "iterate of 1 is (z/2)^(2n)/n!^2, which sums to I_0",
    )


def _iteration(setting: Setting) -> Evidence:
    """Double integral of a power, by its kernel and by iteration."""
    n = sp.Symbol("n", positive=True, integer=True)
    step = comparison.iterated_power(n)
    return identities(
        setting,
        {
            "double integral of xi^(2n)": step - Z ** (2 * n + 2) / (2 * n + 2) ** 2,
            "by the kernel": [comparison.kernel_power(k) - step.subs(n, k) for k in range(1, 4)],
        },
        shown="kernel",
    )


def bound_samples(
    setting: Setting, *, scale: str = "1", upper: str = "1", root: bool = True
) -> Evidence:
    """Both bounds at certified places of [0, z*], C^2 = scale sin phi*/phi*."""
    del setting
    cases = [("1e-6", "3"), ("1/100", "1/10"), ("1/2", "157/50"), ("1", "101/100"), ("3", "157/50")]

    def rows() -> Iterator[Row]:
        for name, level in cases:
            phi_n = initial_angles.ball(name)
            last = initial_angles.crossing(name, Fraction(level))
            top = initial_angles.fraction(level)
            c = printed.constant_squared(top, BALLS, scale=scale, root=root).sqrt()
            for part in ("1/16", "1/2", "7/8", "1"):
                z = last * initial_angles.fraction(part)
                phi = initial_angles.angle(name, z, digits=20)
                place = f"at {part} of z*, phi_n = {name}, phi* = {level}"
                yield f"phi_n I_0(C z) {place}", phi_n * (c * z).bessel_i(0), phi
                above = initial_angles.fraction(upper) * z
                yield f"phi {place}", phi, phi_n * above.bessel_i(0)

    return bounded(
        rows(), shown="phi_n I_0(C z) < phi(z) < phi_n I_0(z) at four places each", sampled=True
    )


def pointwise_bound(setting: Setting, *, scale: str = "1") -> Evidence:
    """The bounds for every phi* at once: I_0(z sqrt(sin phi/phi)) at phi = phi(z) itself."""
    del setting

    def rows() -> Iterator[Row]:
        for name in ("1e-6", "1/100", "1", "2", "3"):
            phi_n = initial_angles.ball(name)
            last = initial_angles.crossing(name, Fraction(314, 100))
            for part in ("1/64", "1/4", "1/2", "3/4", "15/16", "1"):
                z = last * initial_angles.fraction(part)
                phi = initial_angles.angle(name, z, digits=25)
                c = printed.constant_squared(phi, BALLS, scale=scale).sqrt()
                place = f"{part} of the way to phi = 3.14, phi_n = {name}"
                yield f"phi_n I_0(C(phi(z)) z) at {place}", phi_n * (c * z).bessel_i(0), phi

    return bounded(
        rows(),
        shown="z <= z*(phi*) means phi* >= phi(z), and C falls with phi*: the lower bounds for all "
        "phi* are the one with C(phi(z)), which holds at six places for each phi_n",
        sampled=True,
    )
