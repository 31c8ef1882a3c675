"""Checks of the approximate trisection of section 3.4, over the whole range of angles."""

from typing import Any

import sympy as sp
from flint import arb, ctx, fmpq

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import surgery as printed
from theory.vectors import Vector, cross, dot

T = sp.Symbol("t", positive=True)
_BITS = 96
_PIECES = 360


def _unit(t: Any) -> Vector:
    """Unit vector at the angle 2 atan t."""
    return ((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2), sp.Integer(0))


def vectors(
    setting: Setting, *, weight: str = "2", by: int = 1, parallel: bool = False, speed: int = 1
) -> Evidence:
    """e_v and e_u are unit tangent vectors that follow t_u in this order, before t_v.

    weight: that of the nearer vector; by: power of the norm that divides; parallel: whether t_v
    is opposite to t_u; speed: of t_u.
    """
    t_u: Vector = (sp.Integer(speed), sp.Integer(0), sp.Integer(0))
    t_v: Vector = (sp.Integer(-1), sp.Integer(0), sp.Integer(0)) if parallel else _unit(T)
    long_u, long_v = printed.trisecting(t_u, t_v, weight=sp.Rational(weight))
    e_u, e_v = (printed.normalised(a, sp.sqrt, by=by) for a in (long_u, long_v))
    rays = (t_u, long_v, long_u, t_v)
    return combined(
        {
            "unit": identities(
                setting,
                {
                    "e_u": dot(e_u, e_u) - 1,
                    "e_v": dot(e_v, e_v) - 1,
                    "normal parts": (e_u[2], e_v[2]),
                },
                shown="unit tangent vectors",
            ),
            "order": positivity(
                setting,
                {
                    **{f"sine of part {k}": cross(rays[k - 1], rays[k])[2] for k in (1, 2, 3)},
                    "sine from t_u to e_u": cross(t_u, long_u)[2],
                    "sine from e_v to t_v": cross(long_v, t_v)[2],
                },
                shown="e_v and e_u are between t_u and t_v, e_v first",
            ),
        },
        shown="for every angle in (0, pi) the two are unit vectors perpendicular to n_1 and the "
        "rays t_u, e_v, e_u, t_v follow one another, v- and u-directions in turn",
    )


def _outer(angle: Any, *, weight: Any) -> Any:
    """Angle from t_u to e_v, by the arc tangent of the printed vector, for angles in (0, pi)."""
    t_u: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
    _, e_v = printed.trisecting(t_u, (sp.cos(angle), sp.sin(angle), sp.Integer(0)), weight=weight)
    return sp.atan(e_v[1] / e_v[0])


def approximate(
    setting: Setting, *, weight: str = "2", vanishing: int = 3, largest: str = "2/3"
) -> Evidence:
    """Error of the outer parts: its first term, its growth, and where the parts are comparable.

    weight: as in the vectors; vanishing: order in the angle of the error; largest: largest angle
    over pi for which the middle part is at most twice an outer one.
    """
    angle = sp.Symbol("a", positive=True)
    outer = _outer(angle, weight=sp.Rational(weight))
    first = sp.series(angle / 3 - outer, angle, 0, vanishing + 1).removeO()
    lower = [sp.expand(first).coeff(angle, n) for n in range(vanishing)]
    leading = sp.expand(first).coeff(angle, vanishing)
    slope = sp.diff(outer, angle)
    end = sp.Rational(largest) * sp.pi
    there = outer.subs(angle, end) if end < sp.pi else sp.limit(outer, angle, sp.pi, "-")
    ratio = sp.simplify((end - 2 * there) - 2 * there)
    cosine = sp.Symbol("c", real=True)
    return combined(
        {
            "leading": statement(
                all(entry == 0 for entry in lower) and bool(leading > 0),
                shown="first terms",
                witness=f"the error of an outer part starts with {first}",
            ),
            "slope": identities(
                setting,
                {
                    "d(error)/da": sp.Rational(1, 3) - slope
                    - sp.Rational(2, 3) * (1 - sp.cos(angle)) / (5 + 4 * sp.cos(angle)),
                    # An outer part is concave: its share of the angle falls all the way.
                    "second derivative": sp.diff(slope, angle)
                    + 6 * sp.sin(angle) / (5 + 4 * sp.cos(angle)) ** 2,
                },
                shown="the error rises, the share of an outer part falls",
            ),
            "comparable": statement(
                bool(sp.simplify(ratio) <= 0),
                shown="at most twice",
                witness=f"at the angle {end} the outer parts are {there}, the middle one "
                f"{sp.simplify(end - 2 * there)}",
            ),
            "range": positivity(
                setting, {"5 + 4 c, c = 1/(1 + x) - x/(1 + x)": _denominator(cosine)}, shown="> 0"
            ),
        },
        shown="each outer part is a/3 - a^3/81 + ...; its error rises with slope 2 (1 - cos a)/"
        "(3 (5 + 4 cos a)), and the middle part is at most twice an outer one up to 2 pi/3, where "
        "the parts are 1 : 2 : 1",
    )  # fmt: skip


def _denominator(cosine: Any) -> Any:
    """5 + 4 cos a through x = tan^2(a/2) > 0."""
    x = sp.Symbol("x", positive=True)
    return (5 + 4 * cosine).subs(cosine, (1 - x) / (1 + x))


def _half_angle(setting: Setting, *, weight: int) -> Evidence:
    """Tangent of the outer part through the half-angle, against the printed vector."""
    t_u: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
    _, e_v = printed.trisecting(t_u, _unit(T), weight=weight)
    return identities(
        setting,
        {"tan of the outer part": e_v[1] / e_v[0] - 2 * T / (3 + T**2)},
        shown="2 t/(3 + t^2)",
    )


def _outer_ball(angle: arb) -> arb:
    """Angle from t_u to e_v by the half-angle: tan is 2 t/(3 + t^2), t = tan(a/2), over [0, pi]."""
    c, s = (angle / 2).cos(), (angle / 2).sin()
    return (2 * s * c / (3 * c * c + s * s)).atan()


def whole_range(
    setting: Setting, *, limit: str = "1/3", at_right_angle: str = "1/2", weight: int = 2
) -> Evidence:
    """Error of the outer parts in balls over (0, pi): at most pi limit, which is its limit at pi.

    limit: least bound over pi; at_right_angle: tangent of an outer part at the angle pi/2;
    weight: of the printed vectors.
    """
    half_angle = _half_angle(setting, weight=weight)
    if half_angle.outcome != "pass":
        return half_angle
    bound, least = sp.Rational(limit), None
    with ctx.workprec(_BITS):
        pi, top = arb.pi(), fmpq(int(bound.p), int(bound.q))
        rational = sp.Rational(at_right_angle)
        right = _outer_ball(pi / 2) - arb(fmpq(int(rational.p), int(rational.q))).atan()
        if not right.contains(0):
            return _refuted(f"at pi/2 an outer part is {_outer_ball(pi / 2).str(8, radius=False)}")
        for k in range(_PIECES):
            low, high = pi * k / _PIECES, pi * (k + 1) / _PIECES
            # The error rises (see `approximate`), so its values at the ends enclose it.
            least = high / 3 - _outer_ball(high)
            first = low / 3 - _outer_ball(low)
            wide = low.union(high)
            direct = wide / 3 - _outer_ball(wide)
            if not (direct.contains(first) and direct.contains(least)):
                return _refuted(f"piece {k}: the two enclosures do not meet")
            if least > pi * top:
                return _refuted(f"the error at {high.str(6, radius=False)} is "
                                f"{least.str(8, radius=False)}, above {bound} pi")  # fmt: skip
        if least is None or not (least - pi * top).contains(0):
            return _refuted(f"the error tends to {least}, not to {bound} pi")
    return Evidence(
        outcome="pass",
        grade="certified",
        enclosure=least.str(12),
        tried=_PIECES,
        met=_PIECES,
        shown="over the whole of (0, pi) the error of an outer part stays below pi/3, to which it "
        "tends at pi, where the outer parts shrink to 0; at pi/2 the parts are atan(1/2), "
        "atan(3/4), atan(1/2): 26.57, 36.87, 26.57 degrees",
    )


def _refuted(witness: str) -> Evidence:
    return Evidence(outcome="fail", grade="certified", witness=witness, shown="")
