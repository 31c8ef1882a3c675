"""The smallest angle of the recursion of Amsler sectors, and how it depends on phi*."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import amsler_recursion as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import Row, bounded
from checks.verify.recursion_lemma import constant
from checks.verify.recursion_scaling import rounded_down
from theory import bessel, bessel_growth, painleve


def i0(x: Any) -> Any:
    """Ball of I_0 at a ball."""
    return x.bessel_i(0)


def smallest_angle(
    setting: Setting,
    *,
    constants: str = "1 10 100",
    quotient: str = "4",
    scale: str = "1",
    divisor: str = "1",
    factor: str = "2",
) -> Evidence:
    """Whether phi_n >= phi_min = phi*/(divisor I_0(C' sqrt(R))) is kept from n to n + 1.

    For R >= quotient C > 0, or with a divisor other than 1: with C' = scale sqrt(2 x_0/C). For
    quotient 0: by one of the constants in all disks and for all phi_0, R = 1/C'^2 among them.
    factor: of R in the bound of the remark, whose rate is derived from it.
    """
    if Fraction(divisor) != 1:
        return _kept_with_divisor(divisor, scale)
    if Fraction(quotient) > 0:
        kept = _kept_from_radius(quotient, scale)
        return combined(
            {"rate": rate_of_quotient(setting, factor=factor), "whole range": kept},
            shown=kept.shown,
        )
    return _kept_by_a_constant(constants.split())


def _kept_by_a_constant(constants: list[str]) -> Evidence:
    """Whether one of the constants serves for every R: refuted only if each of them is."""
    shown = "phi_1 >= phi_min in the disk of radius 1/C'^2, where I_0(C' sqrt(R)) = I_0(1) < 3"
    witnesses = []
    for text in constants:
        if bounded(_premises(text), shown=shown).outcome != "pass":
            return Evidence(outcome="undecided", grade="certified", shown=f"premises for {text}")
        found = bounded(_first_step(text), shown=shown)
        if found.outcome != "fail":
            return found
        witnesses.append(found.witness)
    return Evidence(
        outcome="fail",
        grade="certified",
        witness="; ".join(witnesses),
        tried=len(constants),
        met=len(constants),
        shown=shown,
    )


def _small_disk(text: str) -> tuple[Any, str, Any]:
    """Radius 1/C'^2 as a ball, an angle phi_0 just below phi* = 9/4, and the place z* for it."""
    level, radius = Fraction(9, 4), 1 / Fraction(text) ** 2
    name = str(level * (1 - radius**2 / 32))
    return initial_angles.fraction(str(radius)), name, initial_angles.crossing(name, level)


def _least(text: str) -> Any:
    """Ball of phi_min as printed in the disk of radius 1/C'^2, phi* = 9/4."""
    radius, _, _ = _small_disk(text)
    top, rate = initial_angles.fraction("9/4"), initial_angles.fraction(text)
    return printed.least_angle(top, rate, radius.sqrt(), i0)


def _premises(text: str) -> Iterator[Row]:
    """That phi_0 >= phi_min, and that phi reaches phi* on the disk and on its rectangle."""
    radius, name, last = _small_disk(text)
    yield "phi_min against phi_0", _least(text), initial_angles.ball(name)
    distance = painleve.diagonal(Fraction(name), last, digits=12).ball()
    yield "distance of the contour from the apex", distance, radius
    yield "z* against the far corner", last, 2 * radius


def _first_step(text: str) -> Iterator[Row]:
    radius, name, last = _small_disk(text)
    after = initial_angles.angle(name, last * last / (2 * radius)) / 3
    where = f"C' = {text}, R = 1/C'^2, phi* = 9/4, phi_0 = {name}"
    yield f"phi_min against phi_1, {where}", _least(text), after


def _kept_from_radius(quotient: str, scale: str) -> Evidence:
    """Step for every R >= quotient C: I_0(X)/I_0(C X^2/(2 R)) grows up to its end, I_0(X)/3."""

    def rows() -> Iterator[Row]:
        more = initial_angles.fraction(scale)
        yield "x_0 against C B^2/(2 R) over x_0, B = C' sqrt(R)", arb(1), more * more
        q = initial_angles.fraction(quotient)
        end = bessel.fixed_point(digits=30).ball() * more * more
        cells, place = bessel_growth.cover(lambda s: bessel_growth.surplus(q, s), 0, end.upper())
        for cell in cells if place is None else [place]:
            rate = bessel_growth.surplus(q, cell)
            yield f"minus the rate at C X^2/(2 R) = {cell.str(6)}", -rate, arb(0)

    return bounded(
        rows(),
        shown="for R >= 4 C and C' = sqrt(2 x_0/C): on [0, C' sqrt(R)] the quotient "
        "I_0(X)/I_0(C X^2/(2 R)) grows (certified on all of it for R = 4 C, and X I_1(X)/I_0(X) "
        "grows, so for larger R too), up to I_0(C' sqrt(R))/3: phi_n >= phi_min gives "
        "phi_{n+1} >= phi_min",
    )


def rate_of_quotient(setting: Setting, *, factor: str = "2", share: str = "1") -> Evidence:
    """Derivative of log(I_0(X)/I_0(Y)), Y the printed argument, against the surplus at Y.

    By I_0' = I_1 for unknown functions; on balls the ratio of the surplus is compared with the
    Bessel functions themselves. share: of the surplus.
    """
    x, radius, c = sp.symbols("X R C", positive=True)
    zero, one = sp.Function("I0"), sp.Function("I1")
    inside, _ = printed.ratio_bound(c, x, radius, factor=factor)
    log = sp.log(zero(x)) - sp.log(zero(inside))
    slopes = {sp.diff(zero(x), x): one(x), sp.diff(zero(inside), x): one(inside) * inside.diff(x)}
    surplus = bessel_growth.surplus(
        radius / c, inside, over=lambda w: one(2 * sp.sqrt(w)) / (sp.sqrt(w) * zero(2 * sp.sqrt(w)))
    )
    rate = x * sp.diff(log, x).subs(slopes) - sp.Rational(share) * inside * surplus

    # The ratio is one of Bessel functions by definition: what the rows guard is its code.
    def rows() -> Iterator[Row]:
        for text in ("1/100", "1", "7/2", "20"):
            at = initial_angles.fraction(text)
            ball = bessel_growth.ratio(at * at / 4) * at * i0(at) / 2
            yield f"I_1({text}) by two routes", abs(ball - at.bessel_i(1)), arb(10) ** -25

    return combined(
        {
            "derivative": identities(setting, {"X log' - Y surplus": sp.expand(rate)}, shown=""),
            "ratio": bounded(rows(), shown=""),
        },
        shown="X d/dX log(I_0(X)/I_0(Y)) = X I_1(X)/I_0(X) - 2 Y I_1(Y)/I_0(Y), Y = C X^2/(2 R)",
    )


def _kept_with_divisor(divisor: str, scale: str) -> Evidence:
    """Step for small and large R: 3 I_0(X) <= divisor I_0(B) I_0(C X^2/(2 R)) where allowed."""

    def rows() -> Iterator[Row]:
        x0 = bessel.fixed_point(digits=30).ball()
        for text in ("1/10000", "1/10", "1", "4", "100"):
            q = initial_angles.fraction(text)
            rate = initial_angles.fraction(scale) * (2 * x0).sqrt()
            most = 1 / printed.least_angle(arb(1), rate, q.sqrt(), i0, divisor=divisor)

            def room(x: Any, q: Any = q, most: Any = most) -> Any:
                w = x * x / 4
                grown = (w * w / (4 * q * q) * 4).hypgeom_0f1(1)
                return most * grown / w.hypgeom_0f1(1) - 3

            end = bessel.inverse_i0(lambda most=most: most, digits=12).ball()
            cells, place = bessel_growth.cover(room, 0, end.upper())
            for cell in cells if place is None else [place]:
                where = f"3 phi_min over the bound, R = {text} C, X = {cell.str(6)}"
                yield where, arb(3), room(cell) + 3

    return bounded(
        rows(),
        shown="phi_min = phi*/(3 I_0(C' sqrt(R))), C' = sqrt(2 x_0/C), is kept for every R > 0: "
        "where X <= C' sqrt(R) a third of phi_n is enough, beyond it the angle grows; certified "
        "for all X at five R from C/10^4 to 100 C",
    )


def down_to_radius(setting: Setting, *, times: str = "3") -> Evidence:
    """Step for R_0 <= R <= 4 C if C' is so large that I_0(C' sqrt(R_0)) = times I_0(8 C).

    R_0: parts of 4 C. A cut needs X <= 2 R, and leaves a third of phi_n = phi*/I_0(X) at least.
    """
    del setting

    def rows() -> Iterator[Row]:
        for level in ("1/10", "9/4", "3"):
            end = 4 * constant(level)
            for part in ("1/1000", "1/10", "999/1000"):
                least = initial_angles.fraction(part) * end
                most = initial_angles.fraction(times) * i0(2 * end)
                inverse = bessel.inverse_i0(lambda most=most: most, digits=20).ball()
                rate = inverse / least.sqrt()
                for share in ("0", "1/2", "1"):
                    radius = least + initial_angles.fraction(share) * (end - least)
                    kept = 1 / (3 * i0(2 * radius))
                    smallest = printed.least_angle(arb(1), rate, radius.sqrt(), i0)
                    place = f"phi_min against phi*/(3 I_0(2 R)), phi* = {level}"
                    yield f"{place}, R_0 = {part} of 4 C, R = {radius.str(6)}", smallest, kept

    return bounded(
        rows(),
        shown="for every R_0 > 0 a C' with I_0(C' sqrt(R_0)) >= 3 I_0(8 C) serves on R_0 <= R <= "
        "4 C: phi_n >= phi_min is kept, as phi_n/3 >= phi*/(3 I_0(2 R)) >= phi_min; every larger "
        "C' than that for R >= 4 C serves there too",
    )


def growth_rate(setting: Setting, *, share: str = "1") -> Evidence:
    """Derivative of x I_1/I_0, by which it is enough to test the least R; share: of (I_1/I_0)^2."""
    i0, i1, x = bessel_growth.symbols()
    more = sp.Symbol("k", positive=True)
    form = x * (1 - sp.Rational(share) * (i1 / i0) ** 2)
    return combined(
        {
            "rate": identities(
                setting, {"derivative": bessel_growth.rate_of_growth() - form}, shown="rate"
            ),
            "sign": positivity(setting, {"I_1 < I_0": form.subs(i0, i1 + more)}, shown="sign"),
        },
        shown="(x I_1/I_0)' = x (1 - (I_1/I_0)^2) > 0, as I_1 < I_0",
    )


def recursion_run(
    setting: Setting, *, scale: str = "1", radii: str = "4 10 40", generations: int = 12
) -> Evidence:
    """Recursion itself, both axes of length R and the node on the contour, from phi_0 near phi*."""
    del setting

    def rows() -> Iterator[Row]:
        x0 = bessel.fixed_point(digits=30).ball()
        for text in radii.split():
            for level in ("9/4", "1/10"):
                radius, top = initial_angles.fraction(text), initial_angles.fraction(level)
                rate = (2 * x0 / constant(level)).sqrt() * initial_angles.fraction(scale)
                least = printed.least_angle(top, rate, radius.sqrt(), i0)
                for n, angle in enumerate(_generations(level, radius, generations), start=1):
                    yield f"phi_min against phi_{n}, R = {text}, phi* = {level}", least, angle

    found = bounded(
        rows(), shown="phi_n >= phi_min for twelve generations, R = 4, 10, 40", sampled=True
    )
    return replace(found, grade="numeric", digits=14)


def _generations(level: str, radius: Any, most: int) -> Iterator[Any]:
    """Angles phi_1, phi_2, ... as long as phi reaches phi*, each rounded to 15 digits for the next.

    phi_0 = 44/45 phi*.
    """
    angle = Fraction(level) * Fraction(44, 45)
    for _ in range(most):
        last = initial_angles.crossing(str(angle), Fraction(level))
        if not last <= 2 * radius:
            return
        after = initial_angles.angle(str(angle), last * last / (2 * radius)) / 3
        yield after
        angle = rounded_down(after)


def cutoff_dependence(
    setting: Setting, *, high: str = "3", levels: str = "1/10 1 2 29/10", low: str = "1/100"
) -> Evidence:
    """Constants for phi* in [low, high] against those for phi* = high, and phi_min against them."""
    del setting

    def rows() -> Iterator[Row]:
        x0 = bessel.fixed_point(digits=30).ball()
        least, widest = constant(high), (2 * x0 / constant(high)).sqrt()
        for level in levels.split():
            c, top = constant(level), initial_angles.fraction(level)
            own = (2 * x0 / c).sqrt()
            yield f"C({high}) against C({level})", least, c
            yield f"C'({level}) against C'({high})", own, widest
            yield f"{low} against phi* = {level}", initial_angles.fraction(low), top
            for radius in (4, 100):
                root = arb(radius).sqrt()
                uniform = printed.least_angle(initial_angles.fraction(low), widest, root, i0)
                wanted = printed.least_angle(top, own, root, i0)
                place = f"uniform phi_min against that of phi* = {level}, R = {radius}"
                yield place, uniform, wanted

    return bounded(
        rows(),
        shown=f"C(phi*) >= C({high}), C'(phi*) <= C'({high}), R_0 = 4 C <= 4 and "
        f"phi_min >= {low}/I_0(C'({high}) sqrt(R)) on [{low}, {high}]",
        sampled=True,
    )
