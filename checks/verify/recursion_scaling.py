"""The remark on the recursion of Amsler sectors: growth of small angles, smallest angle."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from math import floor
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import amsler_recursion as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import Row, bounded
from checks.verify.recursion_lemma import CASES, constant, sides_of, threshold_place
from theory import bessel, bessel_growth, geodesic_ray, painleve


def recursion_bound(
    setting: Setting,
    *,
    daughters: str = "3",
    factor: str = "2",
    scale: str = "1",
    meets: bool = True,
) -> Evidence:
    """First inequality at the lemma's corner and where the contour z = z* of phi puts it.

    meets: whether a branch point is needed, X <= 2 sqrt(u_max v_max); otherwise the far corner of
    the rectangle stands for it.
    """
    del setting

    def rows() -> Iterator[Row]:
        for name, level, rectangles in CASES:
            x, c = threshold_place(name, level), constant(level, scale=scale)
            last = initial_angles.crossing(name, Fraction(level))
            for text in rectangles:
                u_max, v_max = sides_of(text)
                most = 2 * (u_max * v_max).sqrt()
                if meets and not x <= most:
                    continue
                root = (u_max * v_max).sqrt()
                argument, under = printed.ratio_bound(
                    c, x, root, daughters=daughters, factor=factor
                )
                bound = initial_angles.ball(name) * argument.bessel_i(0) / under
                places = {"lemma": x * x / most, "contour": (last * last / most).min(last)}
                for where, z in places.items():
                    phi = initial_angles.angle(name, z.min(most)) / 3
                    place = f"bound, phi_n = {name}, phi* = {level}, sides {text}, node by the "
                    yield place + where, bound, phi

    return bounded(
        rows(),
        shown="phi_{n+1} is at least the bound, with the node of the lemma and "
        "with that on the contour of phi itself, wherever a node is needed",
    )


def axes_for_radius(setting: Setting, *, factor: str = "2", longest: str = "1") -> Evidence:
    """Second inequality: argument of I_0 with R in place of sqrt(u_max v_max), axes up to R."""
    c, x, radius, p, q = sp.symbols("C X R p q", positive=True)
    top = sp.Rational(longest) * radius
    axes = sp.sqrt(top / (1 + p) * top / (1 + q))
    first, under = printed.ratio_bound(c, x, axes)
    second, below = printed.ratio_bound(c, x, radius, factor=factor)
    return combined(
        {
            "squares": positivity(setting, {"first - second": first**2 - second**2}, shown=""),
            "divisors": identities(setting, {"3": under - below}, shown=""),
        },
        shown="C X^2/(2 sqrt(u_max v_max)) > C X^2/(2 R) for axes shorter than R, and I_0 grows",
    )


def axes_below_radius(setting: Setting, *, cosine: str = "0", share: str = "1") -> Evidence:
    """Length of a geodesic axis inside the disk of radius R, by the angle at which it leaves.

    cosine: least cosine of its angle to the direction away from the centre; share: of the sharp
    value -tanh(d/2)/tanh R, at which the axis is R long.
    """
    d, radius, alpha = geodesic_ray.D, geodesic_ray.R, geodesic_ray.ALPHA
    c, length = sp.Symbol("c", positive=True), geodesic_ray.L
    along = geodesic_ray.cosh_distance(length, d, alpha)
    at_radius = geodesic_ray.cosh_distance(radius, d, alpha)
    sharp = -sp.Rational(share) * sp.tanh(d / 2) / sp.tanh(radius)
    outward = at_radius.subs(sp.cos(alpha), sp.Rational(cosine) + c / (1 + c))
    return combined(
        {
            "ray": identities(
                setting,
                {
                    "cosh of the distance, twice derived": along.diff(length, 2) - along,
                    "start": along.subs(length, 0) - sp.cosh(d),
                    "sharp cosine": at_radius.subs(sp.cos(alpha), sharp) - sp.cosh(radius),
                    "solved": geodesic_ray.least_cosine() - sharp,
                },
                shown="ray",
            ),
            "outward": positivity(
                setting,
                {"cosh(distance) - cosh R at length R": outward - sp.cosh(radius)},
                shown="",
            ),
        },
        shown="cosh of the distance from the centre is convex along the axis, below cosh R at its "
        "start and above it at length R if the axis leaves outward: it leaves the disk once, "
        "before R; exactly cos(angle) >= -tanh(d/2)/tanh R is needed, d the distance of its start",
    )


def growth_of_small_angles(
    setting: Setting, *, daughters: str = "3", share: str = "1", factor: str = "2"
) -> Evidence:
    """Ratio phi_{n+1}/phi_n at and below the threshold X^2 = 2 R x_0/C, x_0 = I_0^{-1}(3)."""
    del setting

    def rows() -> Iterator[Row]:
        x0 = bessel.fixed_point(digits=30).ball()
        for radius in (4, 10, 100):
            for level in ("1", "9/4", "3"):
                c = constant(level)
                for more in ("1000001/1000000", "2", "8"):
                    squared = 2 * radius * x0 / c * initial_angles.fraction(share)
                    x = (squared * initial_angles.fraction(more)).sqrt()
                    argument, under = printed.ratio_bound(
                        c, x, arb(radius), daughters=daughters, factor=factor
                    )
                    place = f"1 against the bound, R = {radius}, phi* = {level}, X^2 {more} times"
                    yield place, arb(1), argument.bessel_i(0) / under

    return bounded(
        rows(),
        shown="I_0(C X^2/(2 R))/3 >= 1 as soon as X^2 >= 2 R x_0/C, that is "
        "phi_n <= phi*/I_0(sqrt(2 R x_0/C))",
    )


def growth_of_angles(
    setting: Setting, *, daughters: str = "3", radii: str = "10 40 100", larger: str = "1"
) -> Evidence:
    """Angle of the next generation itself, sector with both axes of length R, at the threshold."""
    del setting

    def rows() -> Iterator[Row]:
        x0 = bessel.fixed_point(digits=30).ball()
        for text in radii.split():
            for level in ("1/10", "9/4", "3"):
                radius, top = initial_angles.fraction(text), initial_angles.fraction(level)
                x = (2 * radius * x0 / constant(level)).sqrt()
                wanted = top / x.bessel_i(0) * initial_angles.fraction(larger)
                name = str(rounded_down(wanted))
                place = f"R = {text}, phi* = {level}"
                yield f"X against the far corner, {place}", threshold_place(name, level), 2 * radius
                for node, last in {
                    "lemma": threshold_place(name, level),
                    "contour": initial_angles.crossing(name, Fraction(level)),
                }.items():
                    phi = initial_angles.angle(name, last * last / (2 * radius))
                    after = printed.daughter_angle(phi, daughters=daughters)
                    yield (
                        f"phi_n at the threshold, node by the {node}, {place}",
                        (initial_angles.ball(name)),
                        after,
                    )

    return bounded(
        rows(),
        shown="at the threshold phi_{n+1} >= phi_n, with the node of the lemma "
        "and with that on the contour of phi, for nine pairs R, phi*",
    )


def rounded_down(ball: Any) -> Fraction:
    """Fraction with 15 digits below the ball, at most 10^-15 of it less."""
    low = ball.lower()
    digits = 15 - floor(float(low.log().mid()) / 2.302585)
    whole = (low * arb(10) ** digits).floor().unique_fmpz()
    return Fraction(int(whole), 10**digits)


def smallest_angle(
    setting: Setting,
    *,
    constants: str = "1 10 100",
    quotient: str = "0",
    scale: str = "1",
    divisor: str = "1",
) -> Evidence:
    """Whether phi_n >= phi_min = phi*/(divisor I_0(C' sqrt(R))) is kept from n to n + 1.

    As printed: for each of the constants, and disks as small as R = 1/C'^2. With a divisor other
    than 1, or for R >= quotient C > 0: with C' = scale sqrt(2 x_0/C).
    """
    del setting
    if Fraction(divisor) != 1:
        return _kept_with_divisor(divisor, scale)
    if Fraction(quotient) > 0:
        return _kept_from_radius(quotient, scale)
    return _kept_by_a_constant(constants.split())


def _kept_by_a_constant(constants: list[str]) -> Evidence:
    """Whether one of the constants serves for every R: refuted only if each of them is."""
    shown = "phi_1 >= phi_min in the disk of radius 1/C'^2, where I_0(C' sqrt(R)) = I_0(1) < 3"
    found = [bounded(_small_disks(text), shown=shown) for text in constants]
    kept = [evidence for evidence in found if evidence.outcome != "fail"]
    if kept:
        return kept[0]
    return Evidence(
        outcome="fail",
        grade="certified",
        witness="; ".join(evidence.witness for evidence in found),
        tried=len(found),
        met=len(found),
        shown=shown,
    )


def _small_disks(text: str) -> Iterator[Row]:
    """First step from an angle just below phi* = 9/4 in the disk of radius 1/C'^2."""
    level, radius = Fraction(9, 4), 1 / Fraction(text) ** 2
    name = str(level * (1 - radius**2 / 32))
    r, top = initial_angles.fraction(str(radius)), initial_angles.fraction("9/4")
    least = top / (initial_angles.fraction(text) * r.sqrt()).bessel_i(0)
    last = initial_angles.crossing(name, level)
    where = f"C' = {text}, R = {radius}, phi* = 9/4, phi_0 = {name}"
    yield f"phi_min against phi_0, {where}", least, initial_angles.ball(name)
    distance = painleve.diagonal(Fraction(name), last, digits=12).ball()
    yield f"distance of the contour from the apex, {where}", distance, r
    yield f"z* against the far corner, {where}", last, 2 * r
    after = initial_angles.angle(name, last * last / (2 * r)) / 3
    yield f"phi_min against phi_1, {where}", least, after


def _kept_from_radius(quotient: str, scale: str) -> Evidence:
    """Step for every R >= quotient C: I_0(X)/I_0(C X^2/(2 R)) grows up to its end, I_0(X)/3."""

    def rows() -> Iterator[Row]:
        more = initial_angles.fraction(scale)
        yield "x_0 against C B^2/(2 R) over x_0, B = C' sqrt(R)", arb(1), more * more
        q = initial_angles.fraction(quotient)
        end = bessel.fixed_point(digits=30).ball() * more * more
        cells, place = bessel_growth.cover(lambda s: bessel_growth.surplus(q, s), 0, end.upper())
        if place is not None:
            value = bessel_growth.surplus(q, place)
            yield f"minus the rate at C X^2/(2 R) = {place.str(6, radius=False)}", -value, arb(0)
        yield f"one of {cells} cells", arb(0), arb(cells)

    return bounded(
        rows(),
        shown="for R >= 4 C and C' = sqrt(2 x_0/C): on [0, C' sqrt(R)] the quotient "
        "I_0(X)/I_0(C X^2/(2 R)) grows (certified on all of it for R = 4 C, and X I_1(X)/I_0(X) "
        "grows, so for larger R too), up to I_0(C' sqrt(R))/3: phi_n >= phi_min gives "
        "phi_{n+1} >= phi_min",
    )


def _kept_with_divisor(divisor: str, scale: str) -> Evidence:
    """Step for small and large R: 3 I_0(X) <= divisor I_0(B) I_0(C X^2/(2 R)) where allowed."""

    def rows() -> Iterator[Row]:
        x0 = bessel.fixed_point(digits=30).ball()
        for text in ("1/10000", "1/10", "1", "4", "100"):
            q = initial_angles.fraction(text)
            most = initial_angles.fraction(divisor) * (
                initial_angles.fraction(scale) * (2 * x0 * q).sqrt()
            ).bessel_i(0)

            def room(x: Any, q: Any = q, most: Any = most) -> Any:
                w = x * x / 4
                grown = (w * w / (4 * q * q) * 4).hypgeom_0f1(1)
                return most * grown / w.hypgeom_0f1(1) - 3

            end = bessel.inverse_i0(lambda most=most: most, digits=12).ball()
            cells, place = bessel_growth.cover(room, 0, end.upper())
            if place is not None:
                where = f"3 phi_min over the bound, R = {text} C, X = {place.str(6, radius=False)}"
                yield where, arb(3), room(place) + 3
            yield f"one of {cells} cells, R = {text} C", arb(0), arb(cells)

    return bounded(
        rows(),
        shown="phi_min = phi*/(3 I_0(C' sqrt(R))), C' = sqrt(2 x_0/C), is kept for every R > 0: "
        "where X <= C' sqrt(R) a third of phi_n is enough, beyond it the angle grows; certified "
        "for all X at five R from C/10^4 to 100 C",
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
        x0, level = bessel.fixed_point(digits=30).ball(), "9/4"
        for text in radii.split():
            radius, angle = initial_angles.fraction(text), Fraction("2.2")
            root = (2 * radius * x0 / constant(level)).sqrt() * initial_angles.fraction(scale)
            least = initial_angles.fraction(level) / root.bessel_i(0)
            for n in range(generations):
                last = initial_angles.crossing(str(angle), Fraction(level))
                if not last <= 2 * radius:
                    break
                after = initial_angles.angle(str(angle), last * last / (2 * radius)) / 3
                angle = rounded_down(after)
                yield f"phi_min against phi_{n + 1}, R = {text}, phi* = {level}", least, after

    found = bounded(rows(), shown="phi_n >= phi_min for twelve generations, R = 4, 10, 40")
    return replace(found, grade="numeric", digits=14)


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
                uniform = initial_angles.fraction(low) / (widest * root).bessel_i(0)
                place = f"uniform phi_min against that of phi* = {level}, R = {radius}"
                yield place, uniform, top / (own * root).bessel_i(0)

    return bounded(
        rows(),
        shown=f"C(phi*) >= C({high}), C'(phi*) <= C'({high}), R_0 = 4 C <= 4 and "
        f"phi_min >= {low}/I_0(C'({high}) sqrt(R)) on [{low}, {high}]",
    )
