"""The remark on the recursion of Amsler sectors: growth of small angles, smallest angle."""

from collections.abc import Iterator
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
from theory import bessel, rim_distance


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
        sampled=True,
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
    d, radius, length, c = sp.symbols("d R l c", positive=True)
    towards = sp.Symbol("a", real=True)
    along = rim_distance.cosh_radius(d, towards, length)
    at_radius = rim_distance.cosh_radius(d, towards, radius)
    sharp = -sp.Rational(share) * sp.tanh(d / 2) / sp.tanh(radius)
    outward = at_radius.subs(towards, sp.Rational(cosine) + c / (1 + c))
    return combined(
        {
            "ray": identities(
                setting,
                {
                    "cosh of the distance, twice derived": along.diff(length, 2) - along,
                    "start": along.subs(length, 0) - sp.cosh(d),
                    "sharp cosine": at_radius.subs(towards, sharp) - sp.cosh(radius),
                    "solved": rim_distance.least_cosine(radius, d) - sharp,
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
        sampled=True,
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
                if not threshold_place(name, level) <= 2 * radius:
                    continue
                place = f"R = {text}, phi* = {level}"
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
        sampled=True,
    )


def rounded_down(ball: Any) -> Fraction:
    """Fraction with 15 digits below the ball, at most 10^-15 of it less."""
    low = ball.lower()
    digits = 15 - floor(float(low.log().mid()) / 2.302585)
    whole = (low * arb(10) ** digits).floor().unique_fmpz()
    return Fraction(int(whole), 10**digits)
