"""Checks of the linearised Painleve III and of the expansions of its solution (appendix A)."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.printed import painleve_asymptotics as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.convergence import order as observed_order
from theory import bessel_expansions, bessel_reference, painleve_reference

Z = sp.Symbol("z", positive=True)


def linearised(
    setting: Setting, *, damping: int = 1, linear: int = -1, slope: str = "0"
) -> Evidence:
    """First variation of PIII at phi = 0, and the slope at z = 0 that a regular solution has."""
    f, df, ddf, e = sp.symbols("f f1 f2 e", real=True)
    phi0, at_origin, bend = sp.symbols("phi_0 s c", real=True)
    nonlinear = e * ddf + e * df / Z - sp.sin(e * f)
    variation = sp.diff(nonlinear, e).subs(e, 0)
    regular = phi0 + at_origin * Z + bend * Z**2
    residual = sp.diff(regular, Z, 2) + sp.diff(regular, Z) / Z - sp.sin(regular)
    pole = sp.expand(Z * residual).subs(Z, 0)
    found = sp.solve(pole, at_origin)
    return identities(
        setting,
        {
            "operator": variation
            - printed.linear_operator(f, df, ddf, Z, damping=damping, linear=linear),
            "slope at 0": found[0] - sp.Rational(slope),
        },
        shown="the first variation of PIII at 0 is the printed operator; regularity at z = 0 "
        "forces phi'(0) = 0",
    )


def linearisation_order(setting: Setting, *, rate: str = "1", order: int = 2) -> Evidence:
    """Relative distance of phi from phi0 I_0(rate z) at z = 2 as phi0 is halved."""
    del setting
    names = ["1/4", "1/8", "1/16", "1/32", "1/64"]
    with mp.workdps(30):
        phi0 = [mp.mpf(1) / int(name.split("/")[1]) for name in names]
        errors = [
            painleve_reference.angle(initial_angles.reference(name), 2, digits=25)
            / printed.linear_solution(start, mp.mpf(2), mp, rate=rate)
            - 1
            for name, start in zip(names, phi0, strict=True)
        ]
        return observed_order(
            phi0, errors, order, digits=25, shown="phi/(phi0 I_0) - 1 at z = 2 falls like phi0^2"
        )


def bessel_solution(
    setting: Setting, *, order: int = 0, sign: int = 1, rate: str = "1"
) -> Evidence:
    """Series of phi0 I_0 in the linearised equation, term by term, with the index k a symbol."""
    k = sp.Symbol("k", positive=True, integer=True)
    forms: dict[str, Any] = {"order": order, "sign": sign, "rate": rate}
    ratio = printed.linear_coefficient(k, **forms) / printed.linear_coefficient(k - 1, **forms)
    first = printed.linear_coefficient(sp.Integer(0), **forms)
    known = bessel_expansions.origin_coefficients(11)
    exponent = 2 * k + order
    return identities(
        setting,
        {
            "coefficient of z^(2 k + order - 2)": exponent**2 * sp.gammasimp(ratio) - 1,
            "indicial equation": sp.Integer(order**2),
            "value at 0": (first if order == 0 else 0) - 1,
            "solved for in the equation": [
                printed.linear_coefficient(sp.Integer(n), **forms) - known[2 * n] for n in range(6)
            ],
        },
        shown="n^2 a_n = a_(n-2) for every n, a_0 = 1, a_1 = 0: the series solves the equation "
        "with both initial values, and every regular solution is a multiple of it",
    )


def bessel_integral(setting: Setting, *, damping: int = 1, linear: int = -1) -> Evidence:
    """Mean of e^(z cos t) over 0 < t < pi in the linearised equation."""
    t = sp.Symbol("t", positive=True)
    kernel = bessel_expansions.kernel(Z, t)
    flux = bessel_expansions.kernel_flux(Z, t)
    applied = printed.linear_operator(
        kernel, sp.diff(kernel, Z), sp.diff(kernel, Z, 2), Z, damping=damping, linear=linear
    )
    series = [
        sp.integrate(sp.cos(t) ** (2 * n), (t, 0, sp.pi)) / (sp.pi * sp.factorial(2 * n))
        - printed.linear_coefficient(sp.Integer(n))
        for n in range(5)
    ]
    return identities(
        setting,
        {
            "operator on the kernel": applied - sp.diff(flux, t),
            "flux at the ends": [flux.subs(t, 0), flux.subs(t, sp.pi)],
            "Taylor coefficients": series,
        },
        shown="the operator turns e^(z cos t) into an exact t-derivative that vanishes at 0 and "
        "pi: the mean solves the equation and has the printed series",
    )


def inner_series(
    setting: Setting, *, coefficient: str = "1/4", power: int = 2, order: int = 4
) -> Evidence:
    """Coefficients of phi_inner/phi0 below the order of its error term."""
    printed_form = sp.Poly(printed.inner(1, Z, coefficient=coefficient, power=power), Z)
    known = bessel_expansions.origin_coefficients(order)
    return identities(
        setting,
        {f"z^{n}": printed_form.coeff_monomial(Z**n) - known[n] for n in range(order)},
        shown="the coefficients of I_0 up to z^3, solved for in the equation, are 1, 0, 1/4, 0",
    )


def inner_error(setting: Setting, *, coefficient: str = "1/4", order: int = 4) -> Evidence:
    """Quotient (I_0 - phi_inner/phi0)/z^order for z from 1 down to 2^-20."""
    del setting

    def rows() -> Iterator[Row]:
        for level in range(0, 21, 2):
            z = arb(1) / 2**level
            error = z.bessel_i(0) - printed.inner(1, z, coefficient=coefficient)
            yield f"error/z^{order} at z = 2^-{level}", abs(error) / z**order, arb(1) / 62

    return bounded(
        rows(),
        bits=256,
        shown="error/z^4 <= 1/62 at z = 1, and so on (0, 1]: its series has positive coefficients",
    )


def inner_order(setting: Setting, *, coefficient: str = "1/4", order: int = 4) -> Evidence:
    """Order of phi_inner/phi0 - I_0 observed for z = 1/2 to 1/32."""
    del setting
    with mp.workdps(30):
        levels = [mp.mpf(2) ** -k for k in range(1, 6)]
        errors = [
            bessel_reference.i0(z, digits=28) - printed.inner(1, z, coefficient=coefficient)
            for z in levels
        ]
        return observed_order(levels, errors, order, digits=28, shown="error of phi_inner in z")


def outer_series(
    setting: Setting, *, correction: str = "1/8", under: str = "2", factor: str = "1"
) -> Evidence:
    """Leading terms of I_0 at infinity, by Watson's lemma."""
    forms = {"correction": correction, "under": under, "factor": factor}
    scaled = sp.expand(printed.outer(1, Z, sp, **forms) * sp.exp(-Z) * sp.sqrt(Z))
    known = bessel_expansions.watson_coefficients(2)
    return identities(
        setting,
        {"two terms": scaled - known[0] - known[1] / Z},
        shown="the mean of e^(z cos t) has these two terms, with their constant 1/sqrt(2 pi)",
    )


def outer_error(setting: Setting, *, correction: str = "1/8", power: int = 2) -> Evidence:
    """Product of z^power and the relative error of phi_outer for z from 2 to 2^20."""
    del setting

    def rows() -> Iterator[Row]:
        for level in range(1, 21):
            z = arb(2**level)
            scaled = (-z).exp() * z.bessel_i(0)
            form = printed.outer(1, z, BALLS, correction=correction) * (-z).exp()
            error = abs(scaled / form - 1)
            yield f"z^{power} |error| at z = 2^{level}", error * z**power, arb(1) / 7

    return bounded(rows(), shown="z^2 |I_0/form - 1| <= 1/7 for z = 2 to 2^20", sampled=True)


def outer_order(setting: Setting, *, correction: str = "1/8", order: int = -2) -> Evidence:
    """Order in z of the relative error of phi_outer observed for z = 32 to 512."""
    del setting
    with mp.workdps(30):
        levels = [mp.mpf(2**k) for k in range(5, 10)]
        errors = [
            bessel_reference.i0(z, digits=28) / printed.outer(1, z, mp, correction=correction) - 1
            for z in levels
        ]
        return observed_order(levels, errors, order, digits=28, shown="error of phi_outer in z")


def regime_1(setting: Setting, *, coefficient: str = "1/4", power: int = 2) -> Evidence:
    """Error of the first line of (eqa5) on the solution itself: phi0^2 z^2/24 + z^4/60 at most."""
    del setting
    forms: dict[str, Any] = {"coefficient": coefficient, "power": power}

    def rows() -> Iterator[Row]:
        for name in ("1/2", "pi/100", "1e-6", "1e-12"):
            for level in (0, 1, 3, 6, 10):
                z, phi0 = arb(1) / 2**level, initial_angles.ball(name)
                phi = initial_angles.angle(name, z)
                error = abs(phi / phi0 - printed.inner(1, z, **forms))
                place = f"relative error at z = 2^-{level}, phi0 = {name}"
                yield place, error, (phi0 * z) ** 2 / 24 + z**4 / 60

    return bounded(
        rows(),
        shown="|phi/phi0 - 1 - z^2/4| <= phi0^2 z^2/24 + z^4/60 at z <= 1, phi0 <= 1/2",
        sampled=True,
    )


def regime_1_order(setting: Setting, *, coefficient: str = "1/4", order: int = 4) -> Evidence:
    """Order in z of the relative error of the first line of (eqa5), with phi0 = z/100."""
    del setting
    with mp.workdps(30):
        levels = [mp.mpf(2) ** -k for k in range(1, 6)]
        errors = [
            painleve_reference.angle(z / 100, z, digits=25)
            - printed.inner(z / 100, z, coefficient=coefficient)
            for z in levels
        ]
        relative = [100 * error / z for z, error in zip(levels, errors, strict=True)]
        return observed_order(
            levels, relative, order, digits=20, shown="relative error of line 1, phi0 = z/100"
        )


def regime_2(
    setting: Setting,
    *,
    reach: str = "pi",
    correction: str = "1/8",
    under: str = "2",
    factor: str = "1",
) -> Evidence:
    """Relative error of the second line of (eqa5), for z >= 3 up to phi = reach.

    Allowed: phi^2/40 + 1/(8 z^2), and 3 % at most. The next terms are -9/(128 z^2), of the Bessel
    function, and phi^2/48, of the separatrix.
    """
    del setting
    forms = {"correction": correction, "under": under, "factor": factor}
    level: Any = arb.pi if reach == "pi" else Fraction(reach)

    def rows() -> Iterator[Row]:
        for name in ("1e-3", "1e-12"):
            last = initial_angles.crossing(name, level)
            for step in range(8, -1, -1):
                z = 3 + (last - 3) * step / 8
                phi = initial_angles.angle(name, z)
                form = printed.outer(initial_angles.ball(name), z, BALLS, **forms)
                place = f"|form/phi - 1| at z = {z.str(6, radius=False)}, phi0 = {name}"
                allowed = phi * phi / 40 + 1 / (8 * z * z)
                yield place, abs(form / phi - 1), allowed.min(arb(3) / 100)

    return bounded(
        rows(),
        shown="within phi^2/40 + 1/(8 z^2), and 3 %, at 9 places from z = 3 to "
        f"phi = {reach}, phi0 = 1e-3 and 1e-12",
        sampled=True,
    )


def regime_2_order(setting: Setting, *, factor: str = "1", order: int = 2) -> Evidence:
    """Order in phi of the relative error of the second line of (eqa5), phi0 = 1e-70."""
    del setting
    name = "1e-70"
    with mp.workdps(30):
        levels = [mp.mpf(2) ** -k for k in range(5)]
        errors = []
        for level in levels:
            z = painleve_reference.crossing(initial_angles.reference(name), level, digits=25)
            form = printed.outer(mp.mpf(10) ** -70, z, mp, factor=factor)
            errors.append(form / level - 1)
        return observed_order(
            levels, errors, order, digits=20, shown="relative error of line 2 in phi, phi0 = 1e-70"
        )
