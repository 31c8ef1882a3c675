"""Checks of (lem:maximal): is the normal one-to-one on B_{2 delta}, and away from N_0 on a collar.

The statement is put with the radius reach * k_max^power * delta of the disk on which the immersion
and the bound on its curvatures are given; as printed it is 3 delta. It is refuted by surfaces near
a folded corner, or proved from the theorem of John for every k_max >= 1.
"""

from fractions import Fraction
from typing import Any

from flint import arb, ctx

from checks.evidence import Evidence, Setting
from checks.verify.ball_bounds import Row, bounded
from theory import folded_corner_surface, normal_distortion

BITS = 192
#: tan(phi0/4); the curvatures are at most 1/(2 t).
CORNERS = ("1/40", "1/400", "1/4000")
#: Separation of the double points in units of delta, inside the collar.
SEPARATION = Fraction(8, 5)


def _ball(text: str) -> Any:
    return folded_corner_surface.ball(Fraction(text))


def refutation(reach: str, power: str) -> str:
    """Surfaces with two points of one normal, the centre and one of the collar; else empty."""
    for t in CORNERS:
        family = folded_corner_surface.surfaces(Fraction(t))
        k_max = 1 / (2 * _ball(t))
        low, high = family.separation()
        delta = (low + high) / (2 * folded_corner_surface.ball(SEPARATION))
        inside = delta < low and high < 2 * delta
        disk = _ball(reach) * k_max ** _ball(power) * delta
        sound = family.largest_curvature() <= k_max and family.box_margin() > 0
        if sound and inside and disk < family.room():
            largest = (delta * folded_corner_surface.ball(family.scale)).str(3, radius=False)
            return (
                f"k_max = {1 / (2 * Fraction(t))}: for every delta in (0, {largest}] a smooth "
                f"immersion of the disk of radius {reach} k_max^{power} delta has curvatures at "
                "most k_max there, and one normal at the centre and at a distance between "
                f"{(low / delta).str(4, radius=False)} delta and "
                f"{(high / delta).str(4, radius=False)} delta"
            )
    return ""


def _follows(reach: str, power: str) -> bool:
    """Whether John's theorem gives both items for all k >= 1 with k R < 1/2."""
    if Fraction(power) < 2:
        return False
    return all(
        normal_distortion.radius_needed(cell) <= _ball(reach)
        for cell in normal_distortion.cells(arb(1) / 2)
    )


def lemma(setting: Setting, *, reach: str = "3", power: str = "0") -> Evidence:
    """Items 1 and 2 for immersions of the disk of radius reach * k_max^power * delta."""
    del setting
    shown = (
        "the normal is one-to-one on B_{2 delta} and bounded away from N_0 on the collar for every "
        "k_max >= 1, by the theorem of John with L^2 <= 1.2985 k_max^2"
    )
    with ctx.workprec(BITS):
        if witness := refutation(reach, power):
            return Evidence(outcome="fail", grade="certified", witness=witness, shown=shown)
        if _follows(reach, power):
            return Evidence(outcome="pass", grade="certified", shown=shown)
    return Evidence(outcome="undecided", grade="certified", shown="neither refuted nor proved")


def constants(
    setting: Setting,
    *,
    distortion: str = "57/50",
    needed: str = "3",
    collar: str = "7/8",
    largest: str = "1/2",
) -> Evidence:
    """Bounds that John's theorem is given, and what it gives, for every k >= 1 and k R <= largest.

    distortion: L/k; needed: R/(k^2 delta); collar: c(k) k.
    """
    del setting

    def rows() -> list[Row]:
        found = []
        eta = _ball(largest) / 3
        # The ends, where the bounds are attained, come last and as points.
        ends = [normal_distortion.Cell(rho=_ball(largest), s=arb(s)) for s in (0, 1)]
        for cell in (*normal_distortion.cells(_ball(largest)), *ends):
            place = f"k R = {cell.rho.str(3)}, 1/k = {cell.s.str(3)}"
            found += [
                (f"L/k at {place}", normal_distortion.relative_distortion(cell), _ball(distortion)),
                (f"radius at {place}", normal_distortion.radius_needed(cell), _ball(needed)),
                (
                    f"constant of the collar at {place}",
                    _ball(collar),
                    normal_distortion.collar_constant(cell, eta),
                ),
            ]
        return found

    return bounded(
        rows(),
        shown="for k >= 1 and k R <= 1/2 the projected normal is L-BLD with L <= 1.14 k, R = 3 k^2 "
        "delta is enough, and |N(x) - N_0| >= 7 delta/(8 k) on the collar",
        bits=BITS,
    )


def corner(
    setting: Setting,
    *,
    t: str = "1/40",
    k_max: str = "20",
    reach: str = "3",
    least: str = "1",
    scale: str = "1/16000",
) -> Evidence:
    """What the family of surfaces near a folded corner shows, one inequality a row.

    least: distance of the double points in units of delta, together with `below 2`.
    """
    del setting

    def rows() -> list[Row]:
        plain = folded_corner_surface.surfaces(Fraction(t))
        family = folded_corner_surface.CornerSurfaces(
            net=plain.net, scale=Fraction(scale), step=plain.step
        )
        low, high = family.separation()
        delta = (low + high) / (2 * folded_corner_surface.ball(SEPARATION))
        return [
            ("largest curvature against k_max", family.largest_curvature(), _ball(k_max)),
            ("0 against the margin of the box", arb(0), family.box_margin()),
            ("radius of the disk against the room for it", _ball(reach) * delta, family.room()),
            ("least distance of the double points", _ball(least) * delta, low),
            ("largest distance of the double points", high, 2 * delta),
        ]

    return bounded(
        rows(),
        shown="for every scale up to 1/16000 a smooth surface with curvatures at most 20 on "
        "B_{3 delta} has the normal of its centre again at a distance in (delta, 2 delta)",
        bits=BITS,
    )


def small_curvatures(setting: Setting, *, k_max: str = "61/50", reach: str = "3") -> Evidence:
    """Whether John's theorem gives the lemma for curvatures up to k_max on B_{reach delta}.

    For k_max * reach * delta <= 1/20; the paper bounds the curvatures on B_{2 delta} only.
    """
    del setting

    def rows() -> list[Row]:
        largest = arb(1) / 20
        ends = [normal_distortion.Cell(rho=largest, s=arb(s)) for s in (0, 1)]
        return [
            (
                f"L^2 2 delta/r at k R = {cell.rho.str(3)}, 1/k = {cell.s.str(3)}",
                normal_distortion.radius_needed(cell) * _ball(k_max) ** 2,
                _ball(reach),
            )
            for cell in (*normal_distortion.cells(largest), *ends)
        ]

    return bounded(
        rows(),
        shown="with the curvatures bounded on B_{3 delta} the lemma is true for k_max <= 1.22 < "
        "sqrt(3/2), eta = 1/(60 k_max), by the theorem of John",
        bits=BITS,
    )


def projected_distortion(setting: Setting, *, radius: str = "2", bound: str = "21/10") -> Evidence:
    """Distortion of the projected normal on the disk of radius `radius` delta, over k_max.

    delta < eta = pi/(6 k_max), so k R < radius pi/6; for every k_max >= 1.
    """
    del setting

    def rows() -> list[Row]:
        return [
            (
                f"L/k_max at k R = {cell.rho.str(3)}, 1/k = {cell.s.str(3)}",
                normal_distortion.relative_distortion(cell),
                _ball(bound),
            )
            for cell in normal_distortion.cells(_ball(radius) * arb.pi() / 6)
        ]

    return bounded(
        rows(),
        shown="on B_{2 delta}, delta < pi/(6 k_max), lengths are distorted by at most 2.1 k_max, "
        "for every k_max >= 1",
        bits=BITS,
    )


def inclusion(setting: Setting, *, reach: str = "3", power: str = "0") -> Evidence:
    """Whether B_{2 delta} lies in the ball of radius r/L^2 that John's theorem is about.

    r = reach k_max^power delta; L is at least k_max, the distortion where N_0 is the normal.
    """
    del setting
    shown = "2 delta <= r/L^2 for every k_max >= 1 and r <= 1/(2 k_max)"
    with ctx.workprec(BITS):
        for k in (1, 2, 20):
            covered = _ball(reach) * arb(k) ** _ball(power) / k**2
            if covered < 2:
                witness = f"k_max = {k}: r/L^2 is at most {covered.str(4, radius=False)} delta"
                return Evidence(outcome="fail", grade="certified", witness=witness, shown=shown)
        if _follows(reach, power):
            return Evidence(outcome="pass", grade="certified", shown=shown)
    return Evidence(outcome="undecided", grade="certified", shown="not decided for all k_max")


def uniform_radius(setting: Setting, *, reach: str = "3", power: str = "2") -> Evidence:
    """Whether (lem:maximal) leaves a radius for J_p that depends on k_max alone."""
    return lemma(setting, reach=reach, power=power)
