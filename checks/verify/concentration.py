"""Checks of section 3.5: what the alternating sum of the angle concentrates at a branch point."""

from collections.abc import Callable, Iterable
from itertools import combinations
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import branched_sine_gordon as printed
from checks.verify.ball_bounds import bounded
from checks.verify.convergence import order as observed_order
from checks.verify.nets import general_nets, over_nets
from theory import amsler, amsler_star_area, painleve, star_saddle
from theory.asymptotic_net import AsymptoticNet
from theory.forms import coordinate_line_curvatures
from theory.star_field import StarField, lengths

ORDERS = (2, 3, 4, 5)
EPSILON = sp.Symbol("epsilon", positive=True)
NEAR, FAR = sp.symbols("a b", positive=True)


def _twelfths(*parts: int) -> tuple[Any, ...]:
    return tuple(sp.pi * sp.Rational(k, 12) for k in parts)


STARS: tuple[tuple[Any, ...], ...] = (
    star_saddle.regular_star(3),
    star_saddle.regular_star(4),
    _twelfths(2, 5, 3, 4, 6, 4),
    _twelfths(2, 3, 2, 3, 4, 4, 3, 3),
)
"""Stars in which no two neighbouring angles add up to pi."""

SURGERY: tuple[tuple[Any, ...], ...] = (
    (*_twelfths(2, 2, 2), *_twelfths(6, 6, 6)),
    (*_twelfths(1, 2, 1), *_twelfths(8, 4, 8)),
    (*_twelfths(1, 1, 1, 1, 1), *_twelfths(7, 5, 7)),
)
"""Stars made at a smooth point, a sector of angle a replaced by 3 or 5 sectors."""


def _over_fields(
    setting: Setting,
    residuals: Callable[[StarField], dict[str, Any]],
    *,
    shown: str,
    orders: Iterable[int] = ORDERS,
    **hypotheses: Any,
) -> Evidence:
    """Identities on unknown surfaces over stars of these orders, under the hypotheses."""
    found: dict[str, Any] = {}
    for m in orders:
        for name, value in residuals(StarField(order=m, **hypotheses)).items():
            found[f"m = {m}, {name}"] = sp.expand(value)
    return identities(setting, found, shown=shown)


def _jumps(angles: tuple[Any, ...]) -> list[Any]:
    phi = star_saddle.asymptotic_angles(angles)
    return [phi[i] - phi[i - 1] for i in range(len(phi))]


def jumps(setting: Setting, *, continuous_rays: int = 0, smallest: int = 3) -> Evidence:
    """Rays of stars across which phi is continuous: at most continuous_rays of them.

    Jumps of seven stars, three of which come from surgery; and for orders from smallest to 6 the
    largest sets of rays without a jump: two of them that bound no common sector would use up 2 pi.
    """
    wrong = []
    for angles in (*STARS, *SURGERY):
        count = sum(bool(sp.simplify(jump) == 0) for jump in _jumps(angles))
        if count > continuous_rays:
            shown = ", ".join(map(str, angles))
            wrong.append(f"phi is continuous across {count} rays of the star of angles {shown}")
    for m in range(smallest, 7):
        if (most := _most_continuous(m)) > continuous_rays and not wrong:
            wrong.append(f"for m = {m} the angles may leave {most} rays without a jump")
    a, b = sp.symbols("alpha beta", positive=True)
    jump = StarField(order=3).centre
    generic = {
        "jump - (sum of neighbours - pi)": (jump(2) - jump(1)).subs(
            {sp.Symbol("alpha_1", positive=True): a, sp.Symbol("alpha_2", positive=True): b}
        )
        - (a + b - sp.pi)
    }
    return combined(
        {
            "rays": statement(not wrong, shown="", witness="; ".join(wrong)),
            "jump": identities(setting, generic, shown=""),
        },
        shown="phi jumps across a ray unless the angles beside it add up to pi; for m >= 3 two "
        "such rays have a sector in common, so there are two at most, as after surgery",
    )


def _most_continuous(m: int) -> int:
    """Largest set of rays of an m-star that can be without a jump, by the sum of the angles.

    Two rays with four sectors beside them use up 2 pi, possible only if these are all.
    """
    rays = range(2 * m)

    def compatible(i: int, k: int) -> bool:
        beside = {(i - 1) % (2 * m), i, (k - 1) % (2 * m), k}
        return len(beside) < 4 or len(beside) == 2 * m

    return max(
        size
        for size in range(1, 2 * m + 1)
        for chosen in combinations(rays, size)
        if all(compatible(i, k) for i, k in combinations(chosen, 2))
    )


def sector_angle_by_parity(setting: Setting, *, even: int = 0) -> Evidence:
    """Caption of the figure against cos phi = sigma r_u . r_v on seven stars."""
    residuals = {
        f"star {n}, sector {j}": phi - printed.sector_angle_by_parity(angles[j], j, even=even)
        for n, angles in enumerate((*STARS, *SURGERY))
        for j, phi in enumerate(star_saddle.asymptotic_angles(angles))
    }
    return identities(
        setting,
        residuals,
        shown="with ray 0 a u-curve and sector 0 after it, phi is alpha on even sectors and "
        "pi - alpha on odd ones",
    )


def sector_angle(setting: Setting, *, swapped: bool = False, whole: int = 1) -> Evidence:
    """Angle at the centre against cos phi = sigma r_u . r_v, sin phi = |r_u x r_v|."""
    alpha = sp.Symbol("alpha", positive=True)
    residuals = {}
    for turn in (1, -1):
        r_u, r_v = (sp.Integer(1), sp.Integer(0)), (sp.cos(alpha), turn * sp.sin(alpha))
        product = r_u[0] * r_v[0] + r_u[1] * r_v[1]
        area = r_u[0] * r_v[1] - r_u[1] * r_v[0]
        phi = printed.sector_angle(alpha, (turn == 1) != swapped, whole=whole)
        residuals[f"cosine, turn {turn}"] = sp.cos(phi) - turn * product
        residuals[f"sine, turn {turn}"] = sp.sin(phi) - turn * area
    return identities(
        setting,
        residuals,
        shown="for r_u, r_v that leave the point at an angle alpha in (0, pi), of either sense",
    )


def star_lemma(
    setting: Setting,
    *,
    orders: str = "2,3,4,5",
    regular: int = 2,
    sign: int = -1,
    area_sign: int = 1,
    percent: int = 100,
    matched: bool = True,
    alternating: bool = True,
    turns: int = 1,
) -> Evidence:
    """(lem:m-star) on unknown surfaces over stars of arbitrary angles and lengths.

    matched, alternating, turns: hypotheses, see theory.star_field.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        rays = lengths(field.order)
        right = printed.star_difference(
            field.star_area(rays), field.order, area_sign=area_sign, regular=regular, sign=sign,
            percent=percent,
        )  # fmt: skip
        return {"sum - right side": field.alternating_sum(field.star(rays)) - right}

    return _over_fields(
        setting,
        residuals,
        orders=map(int, orders.split(",")),
        shown=f"on unknown surfaces over stars of order {orders}, angles and lengths arbitrary",
        matched=matched,
        alternating=alternating,
        turns=turns,
    )


def two_saddle(setting: Setting, *, order: int = 2) -> Evidence:
    """Alternating sum over a star of this order, of arbitrary angles, minus its area."""

    def residuals(field: StarField) -> dict[str, Any]:
        rays = lengths(field.order)
        return {"sum - area": field.alternating_sum(field.star(rays)) - field.star_area(rays)}

    return _over_fields(
        setting,
        residuals,
        orders=(order,),
        shown="on stars of order 2 with any angles of sum 2 pi, C^2 at the centre or not, the sum "
        "is the area",
    )


LEVELS = (4, 8, 16, 32)
_QUADRATURE_STARS = ((2, 5, 3, 4, 6, 4), (2, 3, 2, 3, 4, 4, 3, 3))
_LENGTHS = ("0.5", "0.9", "0.6", "0.8", "0.7", "0.4", "0.65", "0.75")


def _amsler_angle(twelfths: int, x: str) -> Any:
    """Certified angle between the curves of an Amsler sector at s t = x, as mpf."""
    found = painleve.angle(lambda: arb.pi() * twelfths / 12, lambda: 2 * arb(x).sqrt())
    return mp.mpf(found.decimal(15))


def star_by_quadrature(setting: Setting, *, regular: int = 2, percent: int = 100) -> Evidence:
    """(lem:m-star) on two stars of Amsler sectors: PIII at the corners, the midpoint rule inside.

    percent: of the area on the right side.
    """
    parts = {}
    for parts_of_pi in _QUADRATURE_STARS:
        size = len(parts_of_pi)
        rays = _LENGTHS[:size]
        left = mp.mpf(0)
        for j, k in enumerate(parts_of_pi):
            x = str(mp.mpf(rays[j]) * mp.mpf(rays[(j + 1) % size]))
            between = _amsler_angle(k, x)
            left += between if j % 2 == 0 else between - mp.pi
        angles = [float(mp.pi) * k / 12 for k in parts_of_pi]
        errors = []
        for cells in LEVELS:
            area = amsler_star_area.star_area(angles, [float(r) for r in rays], cells)
            charge = -(size // 2 - regular) * mp.pi
            errors.append(left - (mp.mpf(area) * percent / 100 + charge))
        parts[f"m = {size // 2}"] = observed_order(
            [mp.mpf(1) / n for n in LEVELS], errors, 2, digits=12, shown=""
        )
    return combined(
        parts,
        shown="on stars of order 3 and 4 of unequal Amsler sectors both sides agree up to the "
        "error of the midpoint rule, of order 2 within 0.1",
    )


def shrinking_stars(setting: Setting, *, regular: int = 2, percent: int = 100) -> Evidence:
    """Sum over stars of Amsler sectors of lengths eps = 2^-k, k to 8, in balls, against its limit.

    As 0 <= F - alpha <= s t, the area is eps^2 sum sin(alpha) up to m eps^4/2. percent: of the
    concentration.
    """

    def rows() -> Iterable[tuple[str, Any, Any]]:
        for parts_of_pi in ((4,) * 6, (2, 5, 3, 4, 6, 4), (3,) * 8, (6, 6, 6, 6)):
            m = len(parts_of_pi) // 2
            limit = -arb.pi() * (m - regular) * percent / 100
            sines = sum((arb.sin_pi_fmpq(_fraction(k)) for k in parts_of_pi), arb(0))
            for k in range(1, 9):
                total = arb(0)
                for j, part in enumerate(parts_of_pi):
                    between = _certified_angle(part, k)
                    total += between if j % 2 == 0 else between - arb.pi()
                eps2 = arb(1) / 4**k
                gap = abs(total - limit - eps2 * sines)
                yield f"m = {m}, eps = 2^-{k}", gap, m * eps2**2 / 2

    return bounded(
        rows(),
        shown="on stars of order 2 to 4, eps from 1/2 to 1/256, the sum is -(m - 2) pi + eps^2 "
        "times the sum of the sines of the sectors, up to m eps^4/2",
    )


def _fraction(twelfths: int) -> Any:
    from flint import fmpq

    return fmpq(twelfths, 12)


def _certified_angle(twelfths: int, k: int) -> Any:
    """Ball of F(4^-k), F(0) = pi twelfths/12."""
    place = arb(1) / 2 ** (k - 1)
    return painleve.angle(lambda: arb.pi() * twelfths / 12, place, digits=25).ball()


def star_boundary(setting: Setting, *, per_order: int = 2) -> Evidence:
    """Sides of the boundaries of stars, their families, and where the corners lie."""
    wrong = []
    for m in ORDERS:
        field, rays = StarField(order=m), lengths(m)
        boundary = field.star(rays)
        kinds = field.arc_families(boundary)
        alternate = all(a != b for a, b in zip(kinds, kinds[1:] + kinds[:1], strict=True))
        opposite = boundary == [(j, rays[j], rays[(j + 1) % (2 * m)]) for j in range(2 * m)]
        if not (alternate and opposite and len(kinds) == per_order * m):
            wrong.append(f"m = {m} has {len(kinds)} sides")
    return statement(
        not wrong,
        shown="for m = 2 to 5: 2m arcs, u and v in turn, arc j crossing ray j; one corner in each "
        "sector, opposite the centre",
        witness="; ".join(wrong),
    )


def _strip_angles(field: StarField, ray: int) -> tuple[Any, Any, Any, Any]:
    """Angles at r+, r-, q-, q+ of the strip about a ray."""
    q_minus, r_minus, r_plus, q_plus = field.strip(ray, (NEAR, FAR), EPSILON)
    return (
        field.angle(r_plus),
        field.angle(r_minus),
        field.angle(q_minus),
        field.angle(q_plus),
    )


def strip_formula(setting: Setting, *, sign: int = 1, rays: str = "u") -> Evidence:
    """Formula for the thin rectangle against the sum with the signs of (eq:sg-hamburger).

    rays: family of the curve that the rectangle straddles.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        return {
            f"ray {k}": printed.strip_difference(*_strip_angles(field, k), sign=sign)
            - field.alternating_sum(field.strip(k, (NEAR, FAR), EPSILON))
            for k in range(field.size)
            if field.family(k) == rays
        }

    return _over_fields(
        setting, residuals, shown="about every u-ray of stars of order 2 to 5, q- before r-"
    )


def strip_differences(setting: Setting, *, least: int = 1, matched: bool = True) -> Evidence:
    """Differences of phi along the sides of a strip, less those along the ray in between.

    They are sigma times the area between. least: order in eps to which they are to vanish, decided
    on the Taylor series of a solution whose rays have curvature, up to degree 4.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        found = {}
        for k in range(field.size):
            before = (k - 1) % field.size
            r_plus, r_minus, q_minus, q_plus = _strip_angles(field, k)
            ray_plus = field.angle((k, FAR, 0)) - field.angle((k, NEAR, 0))
            ray_minus = field.angle((before, 0, FAR)) - field.angle((before, 0, NEAR))
            plus = field.sigma(k) * field.area(k, (NEAR, FAR), (0, EPSILON))
            minus = field.sigma(before) * field.area(before, (0, EPSILON), (NEAR, FAR))
            found[f"+ of ray {k}"] = r_plus - q_plus - ray_plus - plus
            found[f"- of ray {k}"] = r_minus - q_minus - ray_minus - minus
            found[f"along ray {k}"] = ray_plus - ray_minus
        return found

    u, v = amsler.U, amsler.V
    phi = amsler.goursat_series(4, u / 2 + u**2, v / 3)
    side = sp.expand((phi - phi.subs(v, 0)).subs(u, 1) - (phi - phi.subs(v, 0)).subs(u, 0))
    vanishing = [sp.expand(side.coeff(v, n)) for n in range(least)]
    return combined(
        {
            "area": _over_fields(setting, residuals, shown="", matched=matched),
            "order": _all_zero(vanishing, f"coefficients below eps^{least}"),
        },
        shown="the differences exceed the integral along the ray by sigma times the area between, "
        "which vanishes like eps",
    )


def _all_zero(values: list[Any], what: str) -> Evidence:
    return statement(
        all(sp.expand(value) == 0 for value in values),
        shown="",
        witness=f"{what}: {', '.join(map(str, values))}",
    )


def curvatures_match(
    setting: Setting, *, along: str = "u", sign: int = 1, one_normal: bool = True
) -> Evidence:
    """Slope of phi along a curve and its geodesic curvature, on nets of either sigma.

    sign: kappa^u = -sign phi_u, kappa^v = sign phi_v; one_normal: whether curvatures are
    measured with N for both sectors, else with the orientation of (u, v) in each.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        slope = net.angle_rate(along)
        stated = (-sign if along == "u" else sign) * slope
        forms = (sp.Integer(1), net.sigma * net.cos_phi, sp.Integer(1))
        orientation = net.sigma if one_normal else 1
        by_metric = coordinate_line_curvatures(forms, orientation * net.sin_phi, net.calculus.rate)[
            0 if along == "u" else 1
        ]
        return {
            "by the frame": net.geodesic_curvature(along) - stated,
            "by the metric": by_metric - stated,
        }

    return over_nets(
        setting,
        general_nets(),
        residuals,
        shown="for an unknown angle and either sign of sigma, N the same: the slope of phi along "
        "the curve is its geodesic curvature up to one sign, whatever the sector",
    )


def strips_vanish(
    setting: Setting, *, rays: str = "u", matched: bool = True, least: int = 1, percent: int = 100
) -> Evidence:
    """Sum over a strip about a ray: its area, and 0 <= area <= 2 eps (b - a).

    rays: families of the rays, "u", "v" or "uv"; least: order in eps to which the sum is to
    vanish, decided on Taylor series up to degree 4; percent: of the area.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        ends = (NEAR, FAR)
        return {
            f"ray {k}": field.alternating_sum(field.strip(k, ends, EPSILON))
            - sp.Rational(percent, 100) * field.strip_area(k, ends, EPSILON)
            for k in range(field.size)
            if field.family(k) in rays
        }

    u, v = amsler.U, amsler.V
    phi = amsler.goursat_series(4, u / 2, v / 3)
    area = sp.expand(phi.subs(u, 1) - phi.subs(u, 0) - (phi.subs(u, 1) - phi.subs(u, 0)).subs(v, 0))
    vanishing = [sp.expand(area.coeff(v, n)) for n in range(least)]
    return combined(
        {
            "area": _over_fields(setting, residuals, shown="", matched=matched),
            "order": _all_zero(vanishing, f"coefficients below eps^{least}"),
        },
        shown="on unknown surfaces over stars of order 2 to 5 the sum over the strip is its area, "
        "at most 2 eps times its length as sin phi <= 1",
    )


def v_strips_vanish(setting: Setting, *, matched: bool = True, least: int = 1) -> Evidence:
    """Sum over a strip about a v-ray."""
    return strips_vanish(setting, rays="v", matched=matched, least=least)


def all_strips_vanish(setting: Setting, *, matched: bool = True, least: int = 1) -> Evidence:
    """Sum over a strip about any ray."""
    return strips_vanish(setting, rays="uv", matched=matched, least=least)


def v_curvatures_match(setting: Setting, *, sign: int = 1, one_normal: bool = True) -> Evidence:
    """Slope of phi along a v-curve and its geodesic curvature."""
    return curvatures_match(setting, along="v", sign=sign, one_normal=one_normal)


def alternating_rays(setting: Setting, *, per_family: int = 0, shift: int = 1) -> Evidence:
    """Torsion of the rays of seven stars by the sense in which the normal turns along them.

    Along a ray the gradient of the saddle is normal to it: +1 where it lies to the left. shift:
    number of rays after which the sign is to change; per_family: added to the claimed number m.
    """
    wrong = []
    for angles in (*STARS, *SURGERY):
        rays = range(len(angles))
        senses = [
            sp.simplify(
                sp.sin(star_saddle.gradient_angle(angles, i) - star_saddle.ray_angle(angles, i))
            )
            for i in rays
        ]
        counts = senses.count(1), senses.count(-1)
        changes = all(senses[i] == -senses[i - shift] for i in rays)
        distinct = all(0 < angle < sp.pi for angle in angles)
        if not (changes and distinct and set(counts) == {len(angles) // 2 + per_family}):
            wrong.append(f"star of {len(angles)} rays: {counts}")
    return statement(
        not wrong,
        shown="on seven stars of order 3 and 4 the rays have distinct tangents, and the normal "
        "turns to the left and to the right of them in turn: m rays of each torsion",
        witness="; ".join(wrong),
    )


def angles_at_centre(setting: Setting, *, turns: int = 1, percent: int = 100) -> Evidence:
    """Sum of the angles between neighbouring tangents of the rays, from their inner products."""
    residuals = {}
    for n, angles in enumerate((*STARS, *SURGERY)):
        rays = [star_saddle.direction(star_saddle.ray_angle(angles, i)) for i in range(len(angles))]
        total = sum(sp.acos(sp.simplify((rays[i - 1].T * ray)[0, 0])) for i, ray in enumerate(rays))
        residuals[f"star {n}"] = sp.simplify(
            sp.nsimplify(total / sp.pi) - 2 * turns * sp.Rational(percent, 100)
        )
    return identities(
        setting,
        residuals,
        shown="the directions of the rays of seven stars, one turn of the tangent plane, make "
        "angles of sum 2 pi",
    )


def far_corner(setting: Setting, *, least: int = 1, lipschitz: bool = True) -> Evidence:
    """Taylor series of phi(eps, eps) - phi_0 where the edges have curvature.

    least: order in eps to which it is to vanish; lipschitz: else phi grows like the square root of
    the length along an edge, continuous but no more.
    """
    u, v = amsler.U, amsler.V
    phi = amsler.goursat_series(4, u / 2 + u**2, v / 3)
    # With eps = h^2 the square root of eps is h: order 2 in h is order 1 in eps.
    h = sp.Symbol("h", positive=True)
    extra = sp.Integer(0) if lipschitz else h
    series = sp.expand(phi.subs({u: h**2, v: h**2}) + extra)
    return _all_zero_shown(
        [series.coeff(h, n) for n in range(2 * least)],
        f"coefficients of phi - phi_0 below eps^{least}, by powers of sqrt(eps)",
        "for a Goursat problem with smooth data phi at the far corner is phi_0 + 5 eps/6 + ..., "
        "not better than O(eps)",
    )


def _all_zero_shown(values: list[Any], what: str, shown: str) -> Evidence:
    found = _all_zero(values, what)
    return statement(found.outcome == "pass", shown=shown, witness=found.witness or what)


def star_sum(setting: Setting, *, exponent: str = "i") -> Evidence:
    """First equality for a small star, as eps -> 0, and what is left beyond.

    exponent: "i", the index of the branch point, odd or even, or by "j", that of the sum.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        centres = [field.centre(j) for j in range(field.size)]
        at_p = field.alternating_sum(field.star([sp.Integer(0)] * field.size))
        small = [EPSILON] * field.size
        rest = field.alternating_sum(field.star(small)) - at_p - field.star_area(small)
        found = {
            f"branch point {star}": at_p - printed.star_sum(centres, star, exponent=exponent)
            for star in (1, 2)
        }
        return found | {"sum over the star - limit - area": rest}

    return _over_fields(
        setting,
        residuals,
        shown="the sum over a small star is the alternating sum of the phi_j plus its area, which "
        "is at most 2m eps^2",
    )


def star_sum_value(
    setting: Setting, *, regular: int = 2, percent: int = 100, turns: int = 1
) -> Evidence:
    """Alternating sum of the angles at the centre against -(m - 2) pi."""

    def residuals(field: StarField) -> dict[str, Any]:
        centres = [field.centre(j) for j in range(field.size)]
        value = printed.concentration(field.order, regular=regular, percent=percent)
        return {"sum - value": printed.star_sum(centres, 1, exponent="j") - value}

    return _over_fields(
        setting, residuals, shown="for arbitrary angles of sum 2 pi, m = 2 to 5", turns=turns
    )


def star_pieces(setting: Setting, *, strips: str = "uv", regular: int = 2) -> Evidence:
    """Small star, a strip along each ray and a rectangle in each sector against the whole star.

    strips: families of the rays whose strips are counted.
    """

    def residuals(field: StarField) -> dict[str, Any]:
        rays = lengths(field.order)
        small = [EPSILON] * field.size
        total = field.alternating_sum(field.star(small))
        area = field.star_area(small)
        for k in range(field.size):
            first, second = (EPSILON, rays[k]), (EPSILON, rays[(k + 1) % field.size])
            total += field.alternating_sum(field.rectangle(k, first, second))
            area += field.area(k, first, second)
            if field.family(k) in strips:
                total += field.alternating_sum(field.strip(k, first, EPSILON))
                area += field.strip_area(k, first, EPSILON)
        right = printed.star_difference(field.star_area(rays), field.order, regular=regular)
        return {
            "sum over the pieces - sum over the star": total
            - field.alternating_sum(field.star(rays)),
            "area of the pieces - area of the star": area - field.star_area(rays),
            "sum over the pieces - right side": total - right,
        }

    return _over_fields(
        setting,
        residuals,
        shown="for every eps the pieces make up the star, their corners lie off the rays, and "
        "their sums add up to A - (m - 2) pi",
    )


def concentration_sign(setting: Setting, *, regular: int = 2, sign: int = -1) -> Evidence:
    """Sign of the concentration for m = 2 to 8, and its value from the angles at the centre."""
    wrong = []
    for m in range(2, 9):
        field = StarField(order=m)
        derived = sp.expand(sum((-1) ** j * field.centre(j) for j in range(field.size)))
        value = printed.concentration(m, regular=regular, sign=sign)
        if derived != value or not (derived == 0 if m == 2 else derived < 0):
            wrong.append(f"m = {m}: {derived}, not {value}")
    return statement(
        not wrong,
        shown="for m = 2 to 8 the alternating sum at the centre is -(m - 2) pi: 0 for m = 2, "
        "negative for the others",
        witness="; ".join(wrong),
    )


def figure(setting: Setting, *, sign: int = 1, least: int = 1) -> Evidence:
    """Polygons of (fig:concentrations): the star, the thin rectangle, phi near the centre."""
    return combined(
        {
            "star": star_boundary(setting),
            "rectangle": strip_formula(setting, sign=sign),
            "centre": far_corner(setting, least=least),
        },
        shown="the star and the rectangle, its corners in the order of the caption, are Hamburger "
        "polygons with the signs used, and phi on a sector is its value at the centre + O(eps)",
    )
