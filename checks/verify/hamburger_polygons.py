"""Checks of Hamburger polygons: their definition, signs, areas, and stars as instances."""

from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import identities, statement
from checks.printed import branched_sine_gordon as printed
from checks.verify.convergence import order
from theory import amsler_star_area, painleve, star_saddle
from theory import asymptotic_polygon as polygons
from theory.star_field import StarField, lengths

SIGNS = (1, -1)


_OTHER_CURVES: dict[str, polygons.Polygon] = {
    "triangle": ((0, 0), (2, 0), (0, 2)),
    "figure of eight": ((0, 0), (2, 0), (2, 1), (1, 1), (1, -1), (0, -1)),
}


def hamburger_polygon(setting: Setting, *, mixed: bool = False, crossing: bool = False) -> Evidence:
    """Sort polygons of the coordinate grid into Hamburger polygons and others."""
    wrong = []
    for name, polygon in (*polygons.POLYGONS.items(), *_OTHER_CURVES.items()):
        kinds = [polygons.family(arc) for arc in polygons.arcs(polygon)]
        simple = polygons.is_simple(polygon)
        found = printed.is_hamburger_polygon(kinds, simple, mixed=mixed, crossing=crossing)
        if found != (name in polygons.POLYGONS):
            wrong.append(name)
    return statement(
        not wrong,
        shown="six polygons of u- and v-arcs are accepted; a triangle with one other side and a "
        "closed curve of u- and v-arcs that crosses itself are refused",
        witness=f"decided wrongly: {', '.join(wrong)}",
    )


def _signed_sum(polygon: polygons.Polygon, *, initial: str = "u") -> Any:
    families = [polygons.family(arc) for arc in polygons.arcs(polygon)]
    signs = printed.vertex_signs(families, initial=initial)
    return sum(s * polygons.unknown_angle(p) for s, p in zip(signs, polygon, strict=True))


def vertex_signs(setting: Setting, *, initial: str = "u", sign_u: int = -1) -> Evidence:
    """Alternating sum over the vertices against the boundary integral, arc by arc."""
    residuals = {}
    for name, polygon in polygons.POLYGONS.items():
        for sigma in SIGNS:
            turned = polygons.oriented(polygon, sigma=sigma)
            integral = polygons.boundary_integral(turned, polygons.unknown_angle, sign_u=sign_u)
            residuals[f"{name}, sigma = {sigma}"] = sp.expand(
                _signed_sum(turned, initial=initial) - integral
            )
    return identities(
        setting,
        residuals,
        shown="on six polygons with unknown angles the signs turn the boundary integral into the "
        "sum over the vertices, for both signs of sigma",
    )


def hamburger_sum(
    setting: Setting, *, initial: str = "u", orientation: str = "surface", percent: int = 100
) -> Evidence:
    """(eq:sg-hamburger) on polygons of the grid, the area of a cell by Hazzidakis with sigma.

    orientation: of the polygon, `surface` for that of sigma du dv, `coordinates` for du dv.
    """
    residuals = {}
    for name, polygon in polygons.POLYGONS.items():
        for sigma in SIGNS:
            turned = polygons.oriented(polygon, sigma=sigma if orientation == "surface" else 1)
            area = sum(
                sigma * polygons.cell_difference(cell, polygons.unknown_angle)
                for cell in polygons.cells(polygon)
            )
            gap = _signed_sum(turned, initial=initial) - area * sp.Rational(percent, 100)
            residuals[f"{name}, sigma = {sigma}"] = sp.expand(gap)
    return identities(
        setting,
        residuals,
        shown="on six polygons with unknown angles, convex or not, the sum is the area of the "
        "cells inside, for both signs of sigma",
    )


LEVELS = (4, 8, 16, 32)


_STEP = Fraction(1, 6)


def _sector_angle(point: polygons.Point) -> Any:
    """Certified angle of the Amsler sector with phi_0 = 1 at (i/6, j/6), as mpf."""
    x = point[0] * point[1] * _STEP**2
    if x == 0:
        return mp.mpf(1)
    found = painleve.angle(1, lambda: 2 * arb(x.numerator).sqrt() / arb(x.denominator).sqrt())
    return mp.mpf(found.decimal(15))


def hamburger_by_quadrature(
    setting: Setting, *, initial: str = "u", percent: int = 100
) -> Evidence:
    """(eq:sg-hamburger) in an Amsler sector: PIII at the vertices, the midpoint rule inside."""
    polygon = polygons.POLYGONS["spiral"]
    families = [polygons.family(arc) for arc in polygons.arcs(polygon)]
    signs = printed.vertex_signs(families, initial=initial)
    left = sum(s * _sector_angle(p) for s, p in zip(signs, polygon, strict=True))
    errors = []
    for cells in LEVELS:
        area = sum(
            amsler_star_area.rectangle_area(
                1.0, (float(i * _STEP), float((i + 1) * _STEP)),
                (float(j * _STEP), float((j + 1) * _STEP)), cells,
            )
            for i, j in polygons.cells(polygon)
        )  # fmt: skip
        errors.append(left - mp.mpf(area) * percent / 100)
    return order(
        [mp.mpf(1) / n for n in LEVELS],
        errors,
        2,
        digits=12,
        shown="on a spiral in an Amsler sector the sum by certified angles is the area, up to the "
        "error of the midpoint rule",
    )


def stars_are_hamburger(
    setting: Setting, *, largest: int = 5, equal_lengths: bool = True
) -> Evidence:
    """Arcs of the boundaries of m-stars and of the quadrilaterals in their sectors.

    equal_lengths: whether the two quadrilaterals at a ray are equally long along it.
    """
    wrong = []
    for m in range(2, largest + 1):
        field, rays = StarField(order=m), lengths(m)
        boundary = field.star(rays)
        if not equal_lengths:
            boundary[0] = (0, sp.Symbol("other", positive=True), rays[1])
        curves = {"star": boundary, "sector": field.rectangle(1, (0, rays[1]), (0, rays[2]))}
        for name, curve in curves.items():
            try:
                kinds = field.arc_families(curve)
            except ValueError:
                kinds = ["other"]
            simple = len(set(curve)) == len(curve)
            alternate = all(a != b for a, b in zip(kinds, kinds[1:] + kinds[:1], strict=True))
            if not (alternate and printed.is_hamburger_polygon(kinds, simple)):
                wrong.append(f"{name} of order {m}")
    return statement(
        not wrong,
        shown="for m = 2 to 5 the boundaries of stars with any lengths, and of their sectors, are "
        "u- and v-arcs in turn",
        witness=f"not bounded by u- and v-arcs in turn: {', '.join(wrong)}",
    )


def agreement(setting: Setting, *, sigma_power: int = 1) -> Evidence:
    """(eq:hazzidakis) on a rectangle, against the area that (eq:sg-hamburger) gives to it.

    sigma_power: of sigma in sigma A(R), as the erratum of (eq:hazzidakis) reads it; 0 as printed.
    """
    residuals = {}
    polygon = ((0, 0), (1, 0), (1, 1), (0, 1))
    phi = polygons.unknown_angle
    left = printed.corner_sum(phi((0, 0)), phi((0, 1)), phi((1, 1)), phi((1, 0)))
    for sigma in SIGNS:
        area = _signed_sum(polygons.oriented(polygon, sigma=sigma))
        right = printed.rectangle_area(area, sigma, sigma_power=sigma_power)
        residuals[f"sigma = {sigma}"] = sp.expand(left - right)
    return identities(
        setting,
        residuals,
        shown="the sum over the rectangle oriented by omega is sigma times the difference of "
        "(eq:hazzidakis)",
    )


_UNEVEN = {
    3: tuple(sp.pi * sp.Rational(k, 12) for k in (3, 2, 3, 4, 8, 4)),
    4: tuple(sp.pi * sp.Rational(k, 12) for k in (2, 3, 2, 3, 4, 4, 3, 3)),
}


def not_smooth(setting: Setting, *, orders: str = "3,4,5", directions: int = 3) -> Evidence:
    """Second form at the centre of a star: it would vanish along all the rays.

    directions: number of distinct tangent lines along which it is to vanish; orders: of the stars.
    """
    slopes = sp.symbols(f"t_1:{directions + 1}", real=True)
    conditions = sp.Matrix([[1, 2 * t, t**2] for t in slopes])
    distinct = sp.prod(b - a for n, a in enumerate(slopes) for b in slopes[n + 1 :])
    full = conditions.rank() == 3
    smooth = []
    for m in map(int, orders.split(",")):
        for angles in (star_saddle.regular_star(m), _UNEVEN.get(m)):
            if angles and not any(
                star_saddle.hessian_jump(angles, i) != 0 for i in range(len(angles))
            ):
                smooth.append(f"the star of angles {', '.join(map(str, angles))}")
    if not full or smooth:
        witness = smooth or ["forms that vanish along these directions need not be 0"]
        return statement(False, shown="", witness=f"may be C^2: {'; '.join(witness)}")
    return identities(
        setting,
        {"determinant - 2 product of differences": conditions.det() - 2 * distinct},
        shown="2m > 4 rays have at least three tangent lines; a quadratic form that vanishes on "
        "three is 0, while K = -1; the saddles of order 3 to 5 have a jump of second derivatives",
    )
