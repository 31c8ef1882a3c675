"""The cut coordinate of a sector and the distance to the rim in it (eq:cut-coordinates)."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import cut_scaling as printed
from checks.verify.ball_bounds import Row, bounded
from checks.verify.extremes import reference_ball
from checks.verify.initial_angles import fraction
from theory import bessel, bessel_reference, cut_corner, rim_distance
from theory.errors import DomainError

#: Radius of the disk, distance of the branch point from the centre, phi*/phi_n.
SECTORS = (("4", "1", "3"), ("8", "5", "40"), ("10", "0", "1000"), ("6", "5.9", "1.01"))
COSINES = ("1", "1/2", "0", "-1/2", "-1")
S, A, B, X = sp.symbols("s a b X", positive=True)
TINY = 22


def instance(
    setting: Setting, *, under: str = "4", power: int = 2, distance: str = "to the rim"
) -> Evidence:
    """Whether alpha_n^2 solves phi_n I_0(2 sqrt(s_n) alpha_n) = phi*, s_n the least length."""
    del setting

    def rows() -> Iterator[Row]:
        for sector in SECTORS:
            radius, offset, ratio = map(fraction, sector)
            s = radius - offset if distance == "to the rim" else offset
            where = "R = {}, d = {}, phi*/phi_n = {}".format(*sector)
            for cosine in COSINES:
                length = rim_distance.axis_length(radius, offset, fraction(cosine))
                yield f"s_n minus a length to the rim, {where}", s - length, arb(10) ** -TINY
            straight = rim_distance.axis_length(radius, offset, arb(1))
            yield f"s_n against the radial length, {where}", abs(s - straight), arb(10) ** -TINY
            exact = Fraction(sector[2])
            x = bessel.inverse_i0(exact, digits=30).ball()
            other = reference_ball(bessel_reference.inverse_i0(exact, digits=30))
            found = printed.alpha_squared(x, s, under=under, power=power)
            again = printed.alpha_squared(other, s, under=under, power=power)
            reached = (2 * (s * found).sqrt()).bessel_i(0)
            yield f"phi_n I_0(2 sqrt(s) alpha) against phi*, {where}", *_apart(reached, ratio)
            yield f"alpha^2 by two routes, {where}", *_apart(found, again)

    return bounded(
        rows(),
        shown="alpha_n >= 0 is the number with phi_n I_0(2 sqrt(s_n) alpha_n) = phi*, where s_n = "
        "R - d is the least length of a geodesic to the rim",
    )


def _apart(one: Any, other: Any) -> tuple[Any, Any]:
    return abs(one - other) / abs(other), arb(10) ** -TINY


def refused(setting: Setting, *, ratio: str = "999999/1000000") -> Evidence:
    """Whether phi*/phi_n = ratio < 1 has no alpha_n, by both routes."""
    del setting
    accepted = []
    for route in (bessel, bessel_reference):
        try:
            accepted.append(f"{route.__name__} gives {route.inverse_i0(Fraction(ratio))}")
        except DomainError:
            continue
    return statement(
        not accepted,
        shown="an angle phi_n just above phi* has no alpha_n: I_0 takes no value below 1",
        witness=f"phi*/phi_n = {ratio}: {', '.join(accepted)}",
    )


def sectors(setting: Setting, *, sense: str = "at least", share: str = "1") -> Evidence:
    """Sign of s_n^2 - u_max v_max on sectors with geodesic axes, the branch point off the centre.

    The two axes leave on either side of the outward radius, at these cosines against it.
    """
    del setting

    def rows() -> Iterator[Row]:
        for radius, offset in (("4", "1"), ("4", "3"), ("8", "2"), ("10", "1/10")):
            for pair in (("0", "0"), ("4/5", "4/5"), ("4/5", "-1/2"), ("99/100", "99/100")):
                u, v = (
                    rim_distance.axis_length(fraction(radius), fraction(offset), fraction(c))
                    for c in pair
                )
                s = fraction(radius) - fraction(offset)
                gap = printed.axes_gap(s, u, v, sense=sense, share=share)
                place = f"R = {radius}, d = {offset}, cosines {pair[0]} and {pair[1]}"
                yield f"|s^2 - u_max v_max|, of the wrong sign, {place}", -gap, arb(0)

    return bounded(
        rows(), shown="s_n^2 < u_max v_max on sectors of sixteen kinds off the centre", sampled=True
    )


def shortest(setting: Setting, *, sense: str = "at least", share: str = "1") -> Evidence:
    """Sign of s_n^2 - u_max v_max for all sectors: s_n is the least length of a way to the rim."""
    d, length, w = sp.symbols("d l w", positive=True)
    c, form = 1 - w, {"sense": sense, "share": share}
    cosh_rim = rim_distance.cosh_radius(d, c, length)
    radial = rim_distance.cosh_radius(d, sp.Integer(1), length)
    return combined(
        {
            "off the centre": positivity(
                setting, {"gap": printed.axes_gap(S, S + A, S + B, **form)}, shown=""
            ),
            "radius": identities(setting, {"cosh R": radial - sp.cosh(d + length)}, shown=""),
            "longer": positivity(
                setting, {"cosh(d + l) - cosh R": sp.cosh(d + length) - cosh_rim}, shown=""
            ),
            "centre": identities(setting, {"gap": printed.axes_gap(S, S, S, **form)}, shown=""),
        },
        shown="cosh(d + l) - cosh R = sinh d sinh l (1 - c): every way to the rim is longer than "
        "s_n = R - d but the radial one, so s_n^2 < u_max v_max unless d = 0",
    )


def zeta_of_distance(setting: Setting, *, factor: str = "2") -> Evidence:
    """Quotient of zeta_n by what it is said to be like, 1 where sqrt(u_max v_max) = s_n."""
    u, v = sp.symbols("u v", positive=True)
    zeta = cut_corner.corner_value(X, u, v)
    claimed = printed.zeta_of_alpha(printed.alpha_squared(X, S), factor=factor)
    return identities(
        setting,
        {
            "quotient": zeta / claimed - S / sp.sqrt(u * v),
            "equal lengths": (zeta - claimed).subs({u: S, v: S}),
        },
        shown="2 alpha_n^2 is zeta_n with s_n in place of sqrt(u_max v_max): the two are equal at "
        "the centre, and zeta_n/(2 alpha_n^2) = s_n/sqrt(u_max v_max) elsewhere",
    )


def zeta_like(
    setting: Setting, *, factor: str = "2", steepest: str = "2/5", bound: str = "2/5"
) -> Evidence:
    """Quotient of zeta_n by what it is said to be like, on sectors with geodesic axes.

    steepest: largest angle in units of pi between an axis and the outward radius; the quotient
    must lie between 1 and the geometric mean of the cosines of the axes' angles, for bound in place
    of steepest. The least s nearly attain it.
    """

    def rows() -> Iterator[Row]:
        slant, least = ((arb.pi() * fraction(angle)).cos() for angle in (steepest, bound))
        for cosines, mean in (((slant, slant), least), ((arb(1), slant), least.sqrt())):
            for s in ("2", "1", "1/10", "1/1000", "1e-12", "1e-20"):
                radius, offset = arb(4), 4 - fraction(s)
                u, v = (rim_distance.axis_length(radius, offset, c) for c in cosines)
                alpha = printed.alpha_squared(arb(1), fraction(s))
                # The corner (1/(4 v), 1/(4 u)) of the cut with X = 1.
                quotient = 1 / (2 * (u * v).sqrt()) / printed.zeta_of_alpha(alpha, factor=factor)
                where = f"R = 4, s = {s}, axes at most {steepest} pi from the radius"
                yield f"mean cosine against zeta/claimed, {where}", mean, quotient
                yield f"zeta/claimed, {where}", quotient, arb(1)

    del setting
    return bounded(
        rows(),
        shown=f"zeta_n/(2 alpha_n^2) is between cos({steepest} pi) and 1 where both axes are at "
        "that angle to the outward radius, and between its root and 1 where one is and the other "
        "is radial",
        bits=256,
        sampled=True,
    )


def slanted_axis(setting: Setting, *, power: int = 1) -> Evidence:
    """Bound s_n >= c^power l for a geodesic axis of length l with cosine 0 < c < 1."""
    d, x, y, c, length = sp.symbols("d x y c l", positive=True)
    rim = rim_distance.cosh_radius(d, c, length)
    reached = sp.cosh(d) * sp.cosh(c**power * length)
    reached += sp.sinh(d) * sp.sinh(c**power * length)
    rest = sp.cosh(d) * (sp.cosh(length) - sp.cosh(c * length))
    concave = c * sp.sinh(length) - sp.sinh(c * length)
    return combined(
        {
            "split": identities(
                setting, {"cosh R - cosh(d + c l)": rim - reached - rest - sp.sinh(d) * concave},
                shown="",
            ),
            "ends": identities(
                setting, {"c = 0": concave.subs(c, 0), "c = 1": concave.subs(c, 1)}, shown=""
            ),
            "concave": identities(
                setting,
                {"second": sp.diff(concave, c, 2) + length**2 * sp.sinh(c * length)},
                shown="",
            ),
            "signs": positivity(
                setting,
                {"sinh": sp.sinh(x), "cosh l - cosh c l": sp.cosh(x + y) - sp.cosh(x)},
                shown="",
            ),
        },
        shown="cosh R >= cosh(d + c l): s_n >= c l, so zeta_n/(2 alpha_n^2) is at least the "
        "geometric mean of the two cosines",
    )  # fmt: skip


def best_bound(
    setting: Setting, *, axes: str = "radial", constant: str = "1", inside: str = "2"
) -> Evidence:
    """Argument of I_0 in the printed bound against C zeta_n, the argument in the lemma.

    axes: `radial`, both of the length s_n, so that zeta_n = 2 alpha_n^2, or `any` longer ones.
    """
    more = (A, B) if axes == "any" else (0, 0)
    zeta = cut_corner.corner_value(X, S + more[0], S + more[1])
    claimed = printed.amsler_bound(printed.alpha_squared(X, S), lambda y: y, inside=inside)
    return identities(
        setting,
        {"arguments of I_0": 3 * claimed - sp.Rational(constant) * zeta},
        shown="where both axes have the length s_n, as at the centre, C zeta_n = 2 alpha_n^2 for "
        "C = 1",
    )


def lemma_bound_below(setting: Setting, *, inside: str = "2") -> Evidence:
    """Whether the printed bound exceeds that of the lemma with C = 1 on all other sectors."""
    zeta = cut_corner.corner_value(X, S + A, S + B)
    claimed = printed.zeta_of_alpha(printed.alpha_squared(X, S), factor=inside)
    return positivity(
        setting,
        {"(2 alpha^2)^2 - zeta^2": sp.cancel(claimed**2 - zeta**2)},
        shown="2 alpha_n^2 > zeta_n unless u_max v_max = s_n^2: the printed bound is larger than "
        "any that the lemma gives",
    )
