"""The curve I_0(2 alpha^2)/3 and the quadratic that supports it (fig:frontier)."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import cut_scaling as printed
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.bessel_balls import alpha_star, i0
from checks.verify.extremes import cell, largest, reference_ball
from checks.verify.initial_angles import fraction
from theory import bessel, bessel_expansions, bessel_reference

FAR = 8
WIDTH = Fraction(1, 10**5)
CLOSE = Fraction(1, 10**4)


def largest_quotient(setting: Setting, *, inside: str = "2", power: int = 2) -> Evidence:
    """Largest value of the printed quotient over all w >= 0, against alpha*.

    Beyond w = 8, as I_0(y) >= y^2/4, it is at most 2 sqrt(3) w/(inside w^power).
    """
    del setting

    def rows() -> Iterator[Row]:
        def quotient(w: Any) -> Any:
            return printed.quotient(w, i0, BALLS, inside=inside, power=power)

        found = largest(quotient, Fraction(0), Fraction(FAR), width=WIDTH)
        tail = 2 * arb(3).sqrt() * FAR / (fraction(inside) * FAR**power)
        yield f"quotient beyond w = {FAR}", tail, found
        place = f"largest quotient {found.str(8)} against alpha*"
        yield place, abs(found - alpha_star()), fraction(str(CLOSE))

    return bounded(
        rows(),
        shown="the quotient is largest, over all w >= 0, within 1e-4 of the root's alpha* = 1.1711",
    )


def taken(setting: Setting, *, inside: str = "2") -> Evidence:
    """Value of the printed quotient where t I_1(t) = I_0(t), t = 2 w^2, by both routes."""
    del setting

    def rows() -> Iterator[Row]:
        w = bessel.supporting_argument(digits=30).ball()
        value = printed.quotient(w, i0, BALLS, inside=inside)
        yield "quotient at the touching point against alpha*", *_apart(value, alpha_star())
        reference = reference_ball(bessel_reference.supporting_scale(digits=30))
        yield "alpha* by two routes", *_apart(reference, alpha_star())

    return bounded(rows(), shown="alpha* is taken at w = 0.8967..., by both routes")


def _apart(one: Any, other: Any) -> tuple[Any, Any]:
    return abs(one - other), arb(10) ** -25


def supports(setting: Setting, *, factor: str = "1", power: int = 2) -> Evidence:
    """Contact of f_2 with f_1 in value and slope, and convexity of f_1 - f_2 in q = alpha^2.

    f_1 is a power series in q with coefficients >= 0, f_2 linear in q: a tangent that lies below.
    """

    def rows() -> Iterator[Row]:
        w = bessel.supporting_argument(digits=30).ball()
        q = w * w
        f2 = printed.quadratic(w, alpha_star(), factor=factor, power=power)
        slopes = 2 * (2 * q).bessel_i(1) / 3, f2 / q * power / 2
        yield "f_1 - f_2 at the touching point", *_apart(printed.curve(w, i0), f2)
        yield "difference of the slopes there", *_apart(*slopes)

    coefficients = bessel_expansions.origin_coefficients(24)
    q, a = sp.symbols("q alpha_star", positive=True)
    bend = sp.diff(printed.quadratic(sp.sqrt(q), a, factor=factor, power=power), q, 2)
    return combined(
        {
            "contact": bounded(rows(), shown=""),
            "convex": statement(
                min(coefficients) >= 0 and sp.simplify(bend) == 0,
                shown="",
                witness=f"f_2 has the second derivative {bend} in alpha^2",
            ),
        },
        shown="f_2 is the tangent of f_1 in alpha^2 at alpha = 0.8967...; f_1 is convex in "
        "alpha^2, so f_2 <= f_1 for all alpha",
    )


def _cells() -> Iterator[tuple[Fraction, Fraction]]:
    """Cells that cover [0, 0.85] and [0.95, 4], finer within 0.1 of the touching point."""
    for parts, numbers in ((200, (*range(160), *range(200, 800))), (5000, _NEAR)):
        for n in numbers:
            yield Fraction(n, parts), Fraction(n + 1, parts)


_NEAR = (*range(4000, 4250), *range(4750, 5000))


def below(setting: Setting, *, factor: str = "1", power: int = 2) -> Evidence:
    """Whether f_2 <= f_1 on every cell of [0, 4] away from the touching point, and beyond 4.

    Beyond 4, f_1 >= (1 + alpha^4)/3 and f_2 grows with a lower power.
    """
    del setting

    def rows() -> Iterator[Row]:
        for low, high in _cells():
            alpha = cell(low, high)
            f2 = printed.quadratic(alpha, alpha_star(), factor=factor, power=power)
            yield f"f_2 against f_1 for alpha in [{low}, {high}]", f2, printed.curve(alpha, i0)
        edge = arb(4)
        f2 = printed.quadratic(edge, alpha_star(), factor=factor, power=power)
        yield "f_2 against (1 + alpha^4)/3 at alpha = 4", f2, (1 + edge**4) / 3

    return bounded(
        rows(), shown="f_2 < f_1 for alpha outside [0.85, 0.95], by cells of width 1/200 and 1/5000"
    )


def constant(setting: Setting, *, value: str = "0.73") -> Evidence:
    """Constant of the supporting quadratic against a decimal, to half a unit of its last place."""
    del setting
    places = len(value.partition(".")[2])

    def rows() -> Iterator[Row]:
        found = bessel.supporting_constant(digits=30).ball()
        other = reference_ball(bessel_reference.supporting_constant(digits=30))
        place = f"distance of {found.str(8, radius=False)} from {value}"
        yield place, abs(found - fraction(value)), arb(1) / (2 * 10**places)
        yield "constant by two routes", *_apart(found, other)

    return bounded(rows(), shown=f"alpha*^-2 = 0.729143... rounds to {value}")


def infimum(setting: Setting, *, under: int = 3, inside: str = "2", power: int = 2) -> Evidence:
    """Printed quotient against the power -2 of the quotient whose largest value is alpha*."""
    w = sp.Symbol("w", positive=True)
    bessel_i0 = sp.Function("I_0", positive=True)
    inverse = printed.quotient(w, bessel_i0, sp) ** -2
    return identities(
        setting,
        {"quotients": printed.least_quotient(w, bessel_i0, under=under, inside=inside, power=power)
         - inverse},
        shown="I_0(2 w^2)/(3 w^2) = (w/sqrt(f_1(w)))^-2 for every w > 0, and q -> q^-2 decreases: "
        "the infimum of one is alpha*^-2",
    )  # fmt: skip


def least_value(setting: Setting, *, under: int = 3, inside: str = "2", power: int = 2) -> Evidence:
    """Least value of the printed quotient over w in [1/4, 4], against alpha*^-2.

    Outside it is at least 1/(3 w^2) and w^2/3, more than 5.
    """
    del setting

    def rows() -> Iterator[Row]:
        def negative(w: Any) -> Any:
            return -printed.least_quotient(w, i0, under=under, inside=inside, power=power)

        found = -largest(negative, Fraction(1, 4), Fraction(4), width=WIDTH)
        place = f"least quotient {found.str(8)} against alpha*^-2"
        yield place, abs(found - alpha_star() ** -2), fraction(str(CLOSE))

    return bounded(rows(), shown="the least quotient is within 1e-4 of alpha*^-2 = 0.72914...")
