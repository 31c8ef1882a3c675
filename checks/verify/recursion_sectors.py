"""The recursion before its lemma: cut of a sector, daughters, monotone angle, largest curvature."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity, proved_positive
from checks.printed import amsler_recursion as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from checks.verify.extremes import reference_ball
from checks.verify.recursion_lemma import CASES, sides_of
from theory import comparison, daughter_sectors, kink, painleve_reference, periodic_amsler
from theory.errors import SingularEdgeError

#: Largest radius of a ball of two equal curvatures.
EQUAL = "1e-12"


class CurvatureFunctions:
    """Tangent and cotangent of balls."""

    tan = staticmethod(arb.tan)
    cot = staticmethod(arb.cot)


def contour_and_rim(
    setting: Setting, *, stretched: str = "1", cases: str = "1 2 2.18;1 2 2.2;1 3 1.36;3 2 2.25"
) -> Evidence:
    """Whether phi exceeds phi* on the disk exactly where the contour comes nearer than R.

    cases: R, half the number of sectors, phi*; stretched: factor of the contour's distance.
    """
    del setting

    def rows() -> Iterator[Row]:
        for case in cases.split(";"):
            radius, half, level = case.split()
            with mp.workdps(40):
                corner = mp.pi / int(half)
                contour = painleve_reference.crossing(corner, Fraction(level))
                distance = reference_ball(painleve_reference.diagonal(corner, contour))
            room = initial_angles.fraction(radius) - initial_angles.fraction(stretched) * distance
            try:
                rim = periodic_amsler.rim_angle(Fraction(radius), 2 * int(half)).ball()
            except SingularEdgeError:
                rim = arb.pi()
            excess = rim - initial_angles.fraction(level)
            place = f"R = {radius}, {2 * int(half)} sectors, phi* = {level}"
            yield f"minus (rim angle - phi*) (R - distance), {place}", -excess * room, arb(0)

    found = bounded(
        rows(),
        shown="phi > phi* somewhere on the disk, so that a branch point is needed, exactly where "
        "the contour phi = phi* is nearer than R on the mirror line, where it is nearest",
    )
    return replace(found, grade="numeric", digits=20)


def l_shaped_region(setting: Setting, *, grown: str = "1", least: str = "1") -> Evidence:
    """Bounds phi_n <= phi <= phi* on [0, u_max] x [0, v_n*] and [0, u_n*] x [0, v_max].

    u_n*, v_n*: where the contour of phi meets the sides; grown: factor of both.
    """
    del setting

    def rows() -> Iterator[Row]:
        for name, level, rectangles in CASES:
            last = initial_angles.crossing(name, Fraction(level))
            most, first = initial_angles.fraction(level), initial_angles.ball(name)
            for text in rectangles:
                u_max, v_max = sides_of(text)
                if not last <= 2 * (u_max * v_max).sqrt():
                    continue
                within = initial_angles.fraction(grown) * arb(999999) / 1000000
                u = within * printed.cutoff_contour(last, v_max)
                v = within * printed.cutoff_contour(last, u_max)
                places = {
                    "the far corner on u_max": (u_max, v),
                    "the far corner on v_max": (u, v_max),
                    "the inner corner": (u, v),
                    "near the u-axis": (u_max, v / 1000),
                }
                for place, (one, other) in places.items():
                    phi = initial_angles.angle(name, 2 * (one * other).sqrt())
                    where = f"at {place}, phi_n = {name}, phi* = {level}, sides {text}"
                    yield f"phi {where}", phi, most
                    yield f"phi_n {where}", initial_angles.fraction(least) * first, phi

    return bounded(
        rows(),
        shown="phi_n <= phi <= phi* < pi on the L-shaped region of each "
        "rectangle that the contour meets",
        sampled=True,
    )


def daughters(setting: Setting, *, divisor: str = "3", number: int = 3) -> Evidence:
    """Equal daughters that fill the removed angle, with alternating families of lines."""
    phi = sp.Symbol("phi", positive=True)
    angle = printed.daughter_angle(phi, daughters=divisor)
    filling = identities(
        setting, {"angles of the daughters - removed angle": number * angle - phi}, shown="sum"
    )
    families = statement(
        daughter_sectors.closes(number) and number > 1,
        shown="alternating",
        witness=f"{number} daughters: the rays are {daughter_sectors.rays(number)}, not u ... v",
    )
    return combined(
        {"sum": filling, "families": families},
        shown="three equal daughters of phi/3 fill the removed angle; as u- and v-lines take "
        "turns, their number is odd, and 3 is the least that adds lines",
    )


def monotone(setting: Setting, *, data: str = "any", sign: int = 1, shift: int = 8) -> Evidence:
    """Slopes of exact solutions with 0 < phi < pi near the corner, and the slope's own rate.

    data: `any`, or `rising` for those whose slopes along both axes are positive.
    """
    start = -sp.log(shift)
    t, p = sp.symbols("t p", positive=True)
    q = sp.Symbol("q", positive=True)
    residuals: dict[str, Any] = {}
    slopes: dict[str, Any] = {}
    for a in (1, -1):
        along_u, along_v = kink.slopes(a, start)
        on_axes = (along_u.subs(kink.V, 0), along_v.subs(kink.U, 0))
        if data == "rising" and not all(proved_positive(_plain(slope)) for slope in on_axes):
            continue
        sine = sign * kink.sine(kink.quarter_tangent(a, start))
        residuals[f"phi_uv - sin phi, a = {a}"] = kink.mixed(a, start) - sine
        name = f"of phi = 4 arctan(exp({a} (u + v))/{shift})"
        slopes |= {f"phi_u {name}": _plain(along_u), f"phi_v {name}": _plain(along_v)}
    rate = comparison.half_angle(sp.sin(t), t)
    return combined(
        {
            "solutions": identities(setting, residuals, shown="solutions"),
            "slopes": positivity(setting, slopes, shown="slopes"),
            "rate": positivity(setting, {"(phi_u)_v": sign * rate, "sum": p + q * rate}, shown=""),
        },
        shown="phi_u(u, v) = phi_u(u, 0) + integral of sin phi over v: it is positive with the "
        "slope on the axis, and phi_v likewise; an exact kink has both",
    )


def rises_inside(setting: Setting, *, data: str = "rising", sign: int = 1) -> Evidence:
    """Slopes inside a sector whose data rise along both axes."""
    return monotone(setting, data=data, sign=sign)


def _plain(expr: Any) -> Any:
    """Expression in positive symbols, its exponentials of single ones."""
    u, v = sp.symbols("u v", positive=True)
    return sp.powsimp(sp.expand(expr.subs({kink.U: u, kink.V: v}), power_exp=True))


def shared_axes(setting: Setting, *, number: int = 3, reversed_side: bool = False) -> Evidence:
    """Slope of the daughters along the axes that they take from their parent."""
    p = sp.Symbol("p", positive=True)
    parent = sp.Symbol("p", real=True)
    turns = daughter_sectors.orientations(number)
    first, last = (-turns[0], -turns[-1]) if reversed_side else (turns[0], turns[-1])
    slopes = {
        f"edge of family {family}": daughter_sectors.slope_on_shared_edge(turn, family=family).subs(
            parent, p
        )
        for family, turn in (("u", first), ("v", last))
    }
    return combined(
        {
            "same slope": identities(
                setting, {name: slope - p for name, slope in slopes.items()}, shown="same"
            ),
            "rising": positivity(setting, slopes, shown="rising"),
        },
        shown="a curve has one geodesic curvature on both of its sides, and a daughter at its side "
        "has the orientation of the parent: along a shared axis the slope of phi is the parent's; "
        "along the new axes, geodesics, phi is constant: it falls nowhere but at the branch point",
    )


def energy_bound(
    setting: Setting,
    *,
    level: str = "9/4",
    relation: str = "equal",
    share: str = "1",
    exchanged: bool = False,
    disks: str = "1 3;1 2;1/2 2",
) -> Evidence:
    """Largest curvature of periodic Amsler disks without a cut, phi < phi*, against (ebound).

    level: phi*, or `rim` for the largest angle of the disk; relation: `equal` or `at most`;
    disks: R and half the number of sectors.
    """
    del setting

    def rows() -> Iterator[Row]:
        for disk in disks.split(";"):
            radius, half = disk.split()
            rim = periodic_amsler.rim_angle(Fraction(radius), 2 * int(half), digits=20).ball()
            start = arb.pi() / int(half)
            cutoff = rim if level == "rim" else initial_angles.fraction(level)
            first, second = printed.energies(
                start, cutoff, CurvatureFunctions, share=share, exchanged=exchanged
            )
            curvature = _largest_curvature(start).max(_largest_curvature(rim))
            claimed = first.max(second)
            place = f"R = {radius}, {2 * int(half)} sectors, phi* = {level}"
            yield f"largest angle, {place}", rim.mid(), cutoff.upper() + arb(EQUAL)
            yield f"curvature against (ebound), {place}", curvature, claimed + arb(EQUAL)
            if relation == "equal":
                yield f"(ebound) against the curvature, {place}", claimed, curvature + arb(EQUAL)

    return bounded(
        rows(), shown=f"the curvature is {relation} (ebound) on disks without a cut", sampled=True
    )


def _largest_curvature(phi: Any) -> Any:
    """Largest eigenvalue of II against I for unit asymptotic tangents at the angle phi.

    (sin phi - k cos phi)^2 = k^2.
    """
    sine, cosine = BALLS.sin(phi), BALLS.cos(phi)
    return (sine / (1 + cosine)).max(sine / (1 - cosine))
