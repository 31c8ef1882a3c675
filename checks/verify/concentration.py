"""Checks of section 3.5: what the alternating sum of the angle concentrates at a branch point."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.printed import branched_sine_gordon as printed
from checks.verify.star_fields import ORDERS, over_fields
from checks.verify.thin_strips import far_corner, strip_formula
from theory.star_field import StarField, lengths

EPSILON = sp.Symbol("epsilon", positive=True)


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

    return over_fields(
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

    return over_fields(
        setting,
        residuals,
        orders=(order,),
        shown="on stars of order 2 with any angles of sum 2 pi, C^2 at the centre or not, the sum "
        "is the area",
    )


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

    return over_fields(
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

    return over_fields(
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

    return over_fields(
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
