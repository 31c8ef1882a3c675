"""Checks of section 4: (eq:unramified), the angles around the vertices of spherical nets."""

from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp
from flint import arb, ctx

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import discrete_surfaces
from checks.printed import spherical_nets as printed
from checks.verify import quad_meshes
from checks.verify.discrete_lelieuvre import minus
from checks.verify.spherical_samples import (
    ball,
    ball_angles,
    broken_side,
    half_turns,
    reverses_orientation,
    star_net,
)
from checks.verify.unit_vectors import circle
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.index import angle_sums, normal_winding
from discrete.spherical_net import SphericalNet, surface_points
from theory.vectors import Vector, cross, dot

_ORDERS = (2, 3, 4, 5)
_BITS = 128


def surface_angle(setting: Setting, *, shift: int = 1) -> Evidence:
    """Whether the angle of the surface at a corner is pi + alpha, alpha in (-pi, 0) that of N.

    From the two edges (eq:d_lelieuvre), for any edges and any alpha; shift: pi + alpha, 0: |alpha|.
    """
    x, y, z = sp.symbols("x y z", positive=True)
    c_1, s_1 = circle(x)
    c_2, s_2 = circle(y)
    # alpha = -2 arctan z is in (-pi, 0).
    c, s = circle(z)
    n_0: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
    n_1, n_2 = (c_1, s_1, sp.Integer(0)), (c_2, s_2 * c, -s_2 * s)
    one, other = discrete_surfaces.step_u(n_0, n_1), discrete_surfaces.step_v(n_0, n_2)
    cosine = -c if shift else c
    turned = dot(n_0, cross(one, other))
    return identities(
        setting,
        {
            "cosine": dot(one, other) - s_1 * s_2 * cosine,
            # The edges turn the other way round N than the normals do.
            "sine": turned - s_1 * s_2 * s,
        },
        shown="the edges at a vertex enclose pi + alpha, and turn positively about N where the "
        "normals turn negatively, for any two edge lengths below pi and every alpha in (-pi, 0)",
    )


def _ranges(setting: Setting, *, factor: str, first: str, low: str, high: str) -> Evidence:
    """Sums of pi + alpha over all faces at a vertex, in units of pi, from those of alpha."""
    m, d = sp.symbols("m d", positive=True)
    interior = printed.interior_sum(m, factor=sp.Rational(factor), first=sp.Rational(first))
    lower, upper = printed.boundary_range(d, low=sp.Rational(low), high=sp.Rational(high))
    return identities(
        setting,
        {
            "interior: sum of the surface's angles - 2": 2 * m + interior - 2,
            "boundary: least sum of the surface's angles": (d - 1) + lower,
            "boundary: largest sum - 2": (d - 1) + upper - 2,
        },
        shown="",
    )


def _instances(interior: dict[str, Any], boundary: dict[str, Any]) -> Evidence:
    """Whether rational stars of order 2 to 5 meet both lines at every vertex."""
    failed, met = "", 0
    with ctx.workprec(_BITS):
        for order in _ORDERS:
            net = star_net(order)
            sums = angle_sums(net.complex, ball_angles(net)) / arb.pi()
            for v in range(net.complex.vertex_count):
                degree, total = int(net.complex.degree[v]), sums[v]
                met += 1
                if net.complex.is_boundary[v]:
                    fine = printed.in_boundary_range(total, degree, **boundary)
                else:
                    expected = ball(printed.interior_sum(sp.Rational(degree, 2), **interior))
                    # The directions close up, so the sum is an even integer.
                    fine = abs(total - expected) < 1
                if not fine:
                    failed = failed or (
                        f"star of order {order}, vertex {v} of degree {degree}: the angles add up "
                        f"to {total.str(8, radius=False)} pi"
                    )
    found = statement(not failed, shown="", witness=failed)
    return Evidence(outcome=found.outcome, grade="exact", tried=met, met=met, witness=found.witness)


def unramified(
    setting: Setting, *, factor: str = "2", first: str = "1", low: str = "1", high: str = "3"
) -> Evidence:
    """(eq:unramified): the surface's angles add up to 2 pi, and to less at the boundary."""
    interior = {"factor": sp.Rational(factor), "first": sp.Rational(first)}
    return combined(
        {
            "surface's angle": surface_angle(setting),
            "ranges": _ranges(setting, factor=factor, first=first, low=low, high=high),
            "instances": _instances(interior, {"low": int(low), "high": int(high)}),
        },
        shown="in each face the surface's angle is pi + alpha, so with 2m faces the first line is "
        "the sum 2 pi and with d - 1 faces the second is a sum between 0 and 2 pi, for all m and "
        "d; rational stars of order 2 to 5 meet it at all their vertices",
    )


def covering_number(setting: Setting, *, winding: str = "1-m") -> Evidence:
    """Whether the image of the star of a vertex winds 1 - m times around its normal.

    The sum of the angles is an integer multiple of pi, isolated by a ball; in floats the shipped
    winding number of the normals is compared. winding: "1-m", or "2-m" for a net that breaks the
    condition (orders above 2).
    """
    failed = ""
    for order in _ORDERS:
        times = 1 - order if winding == "1-m" or order == 2 else 2 - order
        net = star_net(order, winding=times)
        floats = np.array([[float(x) for x in n] for n in net.normals])
        shipped = normal_winding(net.complex, floats)
        inside = np.flatnonzero(~net.complex.is_boundary)
        for place, v in enumerate(inside):
            m = int(net.complex.saddle_order[v])
            total = half_turns(net, int(v))
            if total != printed.interior_sum(m) or shipped[place] != 1 - m:
                failed = failed or (
                    f"order {order}, vertex {v} of degree {2 * m}: sum of angles {total} pi, "
                    f"winding {shipped[place]}"
                )
    return statement(
        not failed,
        shown="on rational stars of order 2 to 5 the angles at each interior vertex of degree 2m "
        "add up to 2 pi (1 - m), and the normals of the neighbours wind 1 - m times",
        witness=failed,
    )


def space_angles(net: SphericalNet) -> dict[int, arb]:
    """Sum of the angles in space at each interior vertex, in units of pi, as balls."""
    points = surface_points(net)
    sums: dict[int, arb] = {}
    for corners in net.complex.faces.tolist():
        for k in range(4):
            v = corners[k]
            one = minus(points[corners[(k + 1) % 4]], points[v])
            other = minus(points[corners[(k - 1) % 4]], points[v])
            area = cross(one, other)
            sine = ball(dot(area, area)).sqrt()
            sums[v] = sums.get(v, arb(0)) + arb.atan2(sine, ball(dot(one, other))) / arb.pi()
    inside = np.flatnonzero(~net.complex.is_boundary)
    return {int(v): sums[int(v)] for v in inside}


def not_multi_sheeted(setting: Setting, *, winding: str = "1-m") -> Evidence:
    """Whether the angles of the surface at every vertex add up to 2 pi.

    From its points in space: planar stars whose edges follow one another with angles of sum 2 pi
    are single sheets. winding: "2-m" takes nets that break (eq:unramified), of orders above 2.
    """
    failed = ""
    with ctx.workprec(_BITS):
        for order in _ORDERS:
            times = 1 - order if winding == "1-m" or order == 2 else 2 - order
            net = star_net(order, winding=times)
            for v, total in space_angles(net).items():
                if not abs(total - 2) < 1:
                    failed = failed or (
                        f"order {order}, normals winding {times} times around vertex {v}: the "
                        f"angles in space add up to {total.str(8, radius=False)} pi"
                    )
    # The stars are planar, so the sums are even multiples of pi.
    instances = statement(not failed, shown="", witness=failed)
    return combined(
        {"surface's angle": surface_angle(setting), "instances": instances},
        shown="every angle of the surface is pi + alpha, so at a vertex of degree 2m they add up "
        "to 2 pi exactly under (eq:unramified); on rational stars of order 2 to 5 the angles in "
        "space at each interior vertex add up to 2 pi, though the normals wind 1 to 4 times",
    )


def _fan_families(complex_: AsymptoticComplex, vertex: int) -> list[bool]:
    """Whether each edge at a boundary vertex is a u-edge, from one boundary edge to the other."""
    faces = complex_.faces
    links: dict[int, list[int]] = {}
    for face in np.flatnonzero((faces == vertex).any(axis=1)):
        k = int(np.flatnonzero(faces[face] == vertex)[0])
        one, other = (int(complex_.sides.edge_of[face, side]) for side in (k, (k - 1) % 4))
        links.setdefault(one, []).append(other)
        links.setdefault(other, []).append(one)
    at = min(edge for edge, ends in links.items() if len(ends) == 1)
    order = [at]
    while onwards := [e for e in links[order[-1]] if e not in order]:
        order.append(onwards[0])
    return [bool(complex_.edge_is_u[edge]) for edge in order]


def degree_parity(setting: Setting, *, swapped: bool = False) -> Evidence:
    """Whether boundary vertices of odd degree are edge vertices and those of even degree corners.

    The edges at a vertex in order alternate, so the last is of the family of the first exactly if
    their number is odd; on six complexes, against the shipped corners.
    """
    failed, met = "", 0
    for name, complex_ in quad_meshes.corpus().items():
        for v in np.flatnonzero(complex_.is_boundary):
            families = _fan_families(complex_, int(v))
            met += 1
            alternate = all(a != b for a, b in pairwise(families))
            degree = int(complex_.degree[v])
            even = degree % 2 == (1 if swapped else 0)
            if not (alternate and len(families) == degree and even == complex_.is_corner[v]):
                failed = failed or f"{name}, vertex {v}: degree {degree}, families {families}"
    found = statement(not failed, shown="", witness=failed)
    return Evidence(
        outcome=found.outcome,
        grade="exact",
        tried=met,
        met=met,
        witness=failed,
        shown=f"at all {met} boundary vertices of six complexes the families alternate, and the "
        "degree is even exactly at the corners",
    )


def _closing(setting: Setting, *, odd: bool, sectors: int, low: int, high: int) -> Evidence:
    """Whether `sectors` new angles in (-pi, 0) close any boundary vertex of this parity.

    T = 2 (1 - m) - S with 2m = d + sectors - 1 is their sum, S that of the others, in units of pi.
    As S runs over the range of (eq:unramified), T has to stay in (-sectors, 0): at its ends, since
    it is linear, for every d; and 2m has to be even.
    """
    d = sp.Symbol("d", positive=True)
    m = (d + sectors - 1) / 2
    ends = [
        sp.simplify(printed.interior_sum(m) - total)
        for total in printed.boundary_range(d, low=low, high=high)
    ]
    most, least = ends
    degree = (1 if odd else 0) + sectors - 1
    fine = degree % 2 == 0 and bool(least >= -sectors) and bool(most <= 0)
    return statement(
        fine,
        shown=f"the {sectors} angles have to add up to between {least} and {most} times pi, for "
        f"every degree, so equal ones are in (-pi, 0); the new degree d + {sectors - 1} is even",
        witness=f"{sectors} sectors: their sum ranges over ({least} pi, {most} pi), allowed is "
        f"(-{sectors} pi, 0); the new degree is d + {sectors - 1}, d "
        f"{'odd' if odd else 'even'}",
    )


def edge_vertex_closes(
    setting: Setting, *, sectors: int = 2, low: int = 1, high: int = 3
) -> Evidence:
    """Whether two sectors close an edge vertex, of odd degree."""
    return _closing(setting, odd=True, sectors=sectors, low=low, high=high)


def corner_vertex_closes(
    setting: Setting, *, sectors: int = 3, low: int = 1, high: int = 3
) -> Evidence:
    """Whether three sectors close a corner vertex, of even degree."""
    return _closing(setting, odd=False, sectors=sectors, low=low, high=high)


def net_defect(net: SphericalNet) -> str:
    """What keeps rational normals from being a spherical Chebyshev net; empty if nothing does."""
    if side := broken_side(net):
        return f"(i) {side}"
    if not reverses_orientation(net):
        return "(ii) a rhombus keeps its orientation, or is degenerate"
    with ctx.workprec(_BITS):
        sums = angle_sums(net.complex, ball_angles(net)) / arb.pi()
        for v in range(net.complex.vertex_count):
            degree = int(net.complex.degree[v])
            if net.complex.is_boundary[v]:
                fine = printed.in_boundary_range(sums[v], degree)
            else:
                fine = abs(sums[v] - printed.interior_sum(degree // 2)) < 1
            if not fine:
                return f"(iii) at vertex {v} of degree {degree}: {sums[v].str(8, radius=False)} pi"
    return ""


def _spoiled(order: int, how: str) -> SphericalNet:
    """Net of an order, or a near-miss of one."""
    net = star_net(order)
    if how == "mirrored":
        normals = tuple((x, y, -z) for x, y, z in net.normals)
        return SphericalNet(complex=net.complex, normals=normals)
    if how == "winding":
        return star_net(order, winding=min(2 - order, -1))
    if how == "side":
        last = net.normals[-1]
        c, s = circle(sp.Rational(1, 1000))
        turned = (last[0], c * last[1] - s * last[2], s * last[1] + c * last[2])
        return SphericalNet(complex=net.complex, normals=(*net.normals[:-1], turned))
    return net


def net_definition(
    setting: Setting, *, spoiled: str = "none", refused: str = "mirrored,winding,side"
) -> Evidence:
    """def:sphchebnet: stars of order 2 to 4 are accepted, near-misses of order 3 refused.

    refused: names of the near-misses, the mirror image, a star whose normals wind once less, one
    whose last normal is turned by 1/500.
    """
    parts = {}
    for order in (2, 3, 4):
        defect = net_defect(_spoiled(order, spoiled))
        parts[f"order {order}"] = statement(not defect, shown="", witness=defect)
    for how in refused.split(","):
        defect = net_defect(_spoiled(3, how))
        parts[how] = statement(bool(defect), shown="", witness=f"near-miss {how!r} is accepted")
    return combined(
        parts,
        shown="stars of order 2, 3, 4 between rational curves meet (i), (ii), (iii); refused are "
        "the mirror image of the star of order 3, one whose normals wind once in place of twice, "
        "and one whose last normal is turned by 1/500",
    )
