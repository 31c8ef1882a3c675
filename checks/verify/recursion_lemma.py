"""The lemma on the cut of an Amsler sector: where it lies and what the angle there is."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import amsler_recursion as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import BALLS, Row, bounded
from theory import bessel

#: Angle phi_n, threshold phi*, and sides u_max, v_max of rectangles; the first of each is small.
CASES = (
    ("1/10", "9/4", ("1/2 1/2", "3 3", "2 5", "10 10")),
    ("1", "101/100", ("1/16 1/16", "1/8 1/8", "1/4 1")),
    ("1/100", "1/10", ("1 1", "2 3", "4 4")),
    ("1e-6", "3", ("4 4", "9 9", "5 40")),
    ("2", "157/50", ("1/4 1/4", "1 1", "1 2")),
)


def threshold_place(initial: str, level: str) -> Any:
    """Ball of X = I_0^{-1}(phi*/phi_n)."""
    return bessel.inverse_i0(Fraction(level) / Fraction(initial), digits=30).ball()


def constant(level: str, *, scale: str = "1", best: bool = False) -> Any:
    """Ball of C(phi*), of 1 where best."""
    squared = printed.constant_squared(initial_angles.fraction(level), BALLS, scale=scale)
    return arb(1) if best else squared.sqrt()


def sides_of(text: str) -> tuple[Any, Any]:
    """Balls of u_max and v_max."""
    first, second = text.split()
    return initial_angles.fraction(first), initial_angles.fraction(second)


def cut_corners(
    setting: Setting, *, factor: str = "4", power: int = 2, swapped: bool = False
) -> Evidence:
    """Similarity variable at the far corners of the cut, and that it is largest there."""
    x, u_max, v_max = sp.symbols("X u_max v_max", positive=True)
    p, q = sp.symbols("p q", positive=True)
    u, v = printed.cut(x, u_max, v_max, factor=factor, power=power, swapped=swapped)
    return combined(
        {
            "corners": identities(
                setting,
                {"(u_max, v_n*)": 4 * u_max * v - x**2, "(u_n*, v_max)": 4 * u * v_max - x**2},
                shown="corners",
            ),
            "elsewhere": positivity(
                setting,
                {
                    "along u": x**2 - 4 * u_max / (1 + p) * v / (1 + q),
                    "along v": x**2 - 4 * u / (1 + p) * v_max / (1 + q),
                },
                shown="elsewhere",
            ),
        },
        shown="z = X at both far corners, and z < X elsewhere in the two rectangles",
    )


def corner_before_threshold(setting: Setting, *, grown: str = "1") -> Evidence:
    """Corner X against the place z* of the threshold."""
    del setting

    def rows() -> Iterator[Row]:
        for name, level, _ in CASES:
            x = initial_angles.fraction(grown) * threshold_place(name, level)
            place = f"X for phi_n = {name}, phi* = {level}"
            yield place, x, initial_angles.crossing(name, Fraction(level))

    return bounded(
        rows(), shown="I_0^{-1}(phi*/phi_n) < z* for five pairs phi_n < phi*", sampled=True
    )


def zeta_of_cut(setting: Setting, *, factor: str = "2", power: int = 2) -> Evidence:
    """Twice the root of u_n* v_n* for the cut of the proof, against the displayed zeta_n."""
    x, u_max, v_max = sp.symbols("X u_max v_max", positive=True)
    u, v = printed.cut(x, u_max, v_max)
    shown = printed.zeta(x, u_max, v_max, sp, factor=factor, power=power)
    return identities(
        setting,
        {"zeta_n^2 - 4 u_n* v_n*": shown**2 - 4 * u * v},
        shown="zeta_n = 2 sqrt(u_n* v_n*), both of them positive",
    )


def corner_inside(setting: Setting, *, factor: str = "4", share: str = "1") -> Evidence:
    """Corner of the cut where X is below share times 2 sqrt(u_max v_max), by any margin."""
    x, u_max, margin = sp.symbols("X u_max margin", positive=True)
    # Hundredths, so that a slight fault shows at the values that are tried.
    v_max = (x * (1 + margin / 100) / (2 * sp.Rational(share))) ** 2 / u_max
    u, v = printed.cut(x, u_max, v_max, factor=factor)
    return positivity(
        setting,
        {
            "u_max - u_n*": u_max - u,
            "v_max - v_n*": v_max - v,
            "X^2 - zeta_n^2": x**2 - printed.zeta(x, u_max, v_max, sp) ** 2,
        },
        shown="where X < 2 sqrt(u_max v_max) the corner is in the rectangle and zeta_n < X <= z*: "
        "part 2 is (boundCphi*) at z = zeta_n",
    )


def part_1(
    setting: Setting, *, grown: str = "1", initial: str = "", level: str = "", factor: str = "4"
) -> Evidence:
    """Angle on the L-shaped region at its corner of the apex, its far corners and between."""
    del setting
    cases = ((initial, level, ("1 1",)),) if initial else CASES

    def rows() -> Iterator[Row]:
        for name, top, rectangles in cases:
            most = initial_angles.fraction(top)
            yield f"phi(0, 0) for phi* = {top}", initial_angles.ball(name), most
            for text in rectangles:
                u_max, v_max = sides_of(text)
                x = threshold_place(name, top)
                u, v = printed.cut(x, u_max, v_max, factor=factor)
                more = initial_angles.fraction(grown)
                for at, (one, other) in {
                    "(u_max, v_n*)": (u_max, v * more),
                    "(u_n*, v_max)": (u * more, v_max),
                    "(u_max/2, v_n*)": (u_max / 2, v),
                }.items():
                    phi = initial_angles.angle(name, 2 * (one * other).sqrt())
                    yield f"phi at {at}, phi_n = {name}, sides {text}", phi, most

    return bounded(
        rows(),
        shown="phi <= phi* at the corners of the L-shaped region, where z is "
        "largest, for sixteen rectangles, small ones among them",
        sampled=True,
    )


def part_2(
    setting: Setting,
    *,
    meets: bool = False,
    best: bool = False,
    scale: str = "1",
    factor: str = "2",
) -> Evidence:
    """Lower bound of phi at the corner of the cut; meets: only where X <= 2 sqrt(u_max v_max).

    Where the corner is outside of the rectangle, the largest angle on the rectangle stands for it:
    the statement asks for any point of the rectangle.
    """
    del setting

    def rows() -> Iterator[Row]:
        for name, level, rectangles in CASES:
            x = threshold_place(name, level)
            c = constant(level, scale=scale, best=best)
            for text in rectangles:
                u_max, v_max = sides_of(text)
                inside = x <= 2 * (u_max * v_max).sqrt()
                if meets and not inside:
                    continue
                bound = printed.zeta(x, u_max, v_max, BALLS, factor=factor)
                u, v = printed.cut(x, u_max, v_max) if inside else (u_max, v_max)
                phi = initial_angles.angle(name, 2 * (u * v).sqrt())
                what = "" if inside else ", against the largest phi on the rectangle"
                where = f"phi_n I_0(C zeta_n), phi_n = {name}, phi* = {level}, sides {text}{what}"
                yield where, initial_angles.ball(name) * (c * bound).bessel_i(0), phi

    return bounded(
        rows(), shown="phi(u_n*, v_n*) >= phi_n I_0(C zeta_n) for each rectangle", sampled=True
    )


def lower_bound(
    setting: Setting, *, meets: bool = False, scale: str = "1", root: bool = True
) -> Evidence:
    """Bound phi_n I_0(2 C sqrt(u_n* v_n*)) at the corner of the cut itself, PIII continued.

    meets: only where X <= 2 sqrt(u_max v_max).
    """
    del setting

    def rows() -> Iterator[Row]:
        for name, level, rectangles in CASES:
            x, top = threshold_place(name, level), initial_angles.fraction(level)
            c = printed.constant_squared(top, BALLS, scale=scale, root=root).sqrt()
            for text in rectangles:
                u_max, v_max = sides_of(text)
                if meets and not x <= 2 * (u_max * v_max).sqrt():
                    continue
                u, v = printed.cut(x, u_max, v_max)
                z = 2 * (u * v).sqrt()
                bound = initial_angles.ball(name) * (c * z).bessel_i(0)
                where = f"bound at the corner, phi_n = {name}, phi* = {level}, sides {text}"
                yield where, bound, initial_angles.angle(name, z)

    return bounded(
        rows(), shown="the bound holds at the corner (u_n*, v_n*) for each rectangle", sampled=True
    )


def never_beyond(setting: Setting, *, damping: int = 1) -> Evidence:
    """Energy of PIII, by which phi stays between phi_n and 2 pi - phi_n for ever."""
    z = sp.Symbol("z", positive=True)
    f = sp.Function("f", real=True)(z)
    energy = f.diff(z) ** 2 / 2 + sp.cos(f)
    rate = energy.diff(z).subs(f.diff(z, 2), sp.sin(f) - f.diff(z) / z)
    return identities(
        setting,
        {"(phi'^2/2 + cos phi)' + phi'^2/z": sp.expand(rate + damping * f.diff(z) ** 2 / z)},
        shown="phi'^2/2 + cos phi falls from cos phi_n: phi < 2 pi - phi_n for every z > 0, so a "
        "bound above 2 pi is met nowhere, in the rectangle or beyond it",
    )


def lemma(
    setting: Setting,
    *,
    meets: bool = False,
    best: bool = False,
    grown: str = "1",
    initial: str = "",
    level: str = "",
) -> Evidence:
    """Both parts of the lemma at the corner of its proof."""
    return combined(
        {
            "part 1": part_1(setting, grown=grown, initial=initial, level=level),
            "part 2": part_2(setting, meets=meets, best=best),
        },
        shown="both parts hold with the u_n*, v_n* of the proof for each pair of angles and each "
        "rectangle",
    )


def no_constant_at_pi(
    setting: Setting, *, constants: str = "1/10 1/100", initial: str = ""
) -> Evidence:
    """Whether phi* = pi refutes each C > 0: phi(zeta) < phi_n I_0(C zeta) for phi_n close to pi.

    Sides with 2 sqrt(u_max v_max) = X, so that zeta = X; phi_n = pi cut to the digits of C^2, or
    initial.
    """
    del setting

    def rows() -> Iterator[Row]:
        for text in constants.split():
            c = initial_angles.fraction(text)
            name = initial or {"1/10": "3.14", "1/100": "3.14159"}[text]
            ratio = arb.pi() / initial_angles.ball(name)
            x = bessel.inverse_i0(lambda ratio=ratio: ratio, digits=20).ball()
            bound = initial_angles.ball(name) * (c * x).bessel_i(0)
            place = f"phi at zeta = X against the bound with C = {text}, phi_n = {name}"
            yield place, initial_angles.angle(name, x, digits=15), bound

    return bounded(
        rows(),
        shown="for phi* = pi no C > 0 serves all phi_n < pi: sin phi_n/phi_n, "
        "which C^2 must not exceed, tends to 0",
        sampled=True,
    )


def threshold_at_start(setting: Setting, *, level: str = "1") -> Evidence:
    """Whether phi_n = 1 = phi* leaves no u_n*, v_n* > 0: phi > phi* = level from z = 0 on."""
    del setting

    def rows() -> Iterator[Row]:
        for place in ("1/1000000", "1/100", "1"):
            phi = initial_angles.angle("1", initial_angles.fraction(place), digits=25)
            yield f"phi* against phi({place})", initial_angles.fraction(level), phi

    return bounded(
        rows(),
        shown="for phi_n = phi* the angle exceeds phi* at every u, v > 0: the "
        "cut of the proof is u_n* = v_n* = 0",
        sampled=True,
    )
