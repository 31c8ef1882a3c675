"""Checks of section 4: discrete surgery, three sectors put in at a corner."""

from collections.abc import Callable, Iterator
from itertools import chain, product

import numpy as np
import sympy as sp
from flint import arb, ctx

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import spherical_nets as printed
from checks.verify.discrete_lelieuvre import minus
from checks.verify.spherical_samples import ball, ball_angles, balled, reverses_orientation
from checks.verify.surgery_samples import (
    Surgery,
    begins_with_u,
    between_two_slots,
    corners,
    half_monkey_star,
    operated,
    samples,
    slotted,
)
from checks.verify.unit_vectors import X, Z, circle, corner
from checks.verify.vertex_angles import degree_parity
from discrete.complex_surgery import boundary_segment
from discrete.geodesics import sine_and_cosine_part
from discrete.index import angle_sums
from discrete.quad_rule import close_quad
from discrete.space_forms import S2, dot_s2
from discrete.spherical_net import SphericalNet, edge_step, geodesic_curve, surface_points
from theory.vectors import dot

_BITS = 192
#: Below this a ball of that precision is 0 for our purposes: rounding is a power of ten smaller.
_TINY = arb(2) ** -120
_LENGTHS = ((1, 1), (2, 3))

Case = tuple[str, SphericalNet, int, tuple[int, int]]


def _cases(*, hard: bool) -> Iterator[Case]:
    """Nets with each of their corners and lengths of the new curves, the hard nets first."""
    named: Iterator[tuple[str, SphericalNet]] = iter(())
    if hard:
        named = iter(
            [
                ("corner between two slots", between_two_slots()),
                ("three sectors of 0.6 pi", slotted()),
                ("four of six sectors", half_monkey_star()),
            ]
        )
    for name, net in chain(named, samples()):
        for at, lengths in product(corners(net), _LENGTHS):
            yield name, net, at, lengths


def _small(x: arb) -> bool:
    return bool(abs(x) < _TINY)


def _ranges_broken(found: Surgery) -> str:
    """First vertex at which (eq:unramified) is certainly broken or undecided, or nothing."""
    complex_ = found.net.complex
    sums = angle_sums(complex_, ball_angles(found.net)) / arb.pi()
    for v in range(complex_.vertex_count):
        degree = int(complex_.degree[v])
        if complex_.is_boundary[v]:
            fine = printed.in_boundary_range(sums[v], degree)
        else:
            fine = abs(sums[v] - printed.interior_sum(degree // 2)) < 1
        if not fine:
            return f"the angles at vertex {v} of degree {degree} add up to {_shown(sums[v])} pi"
    return ""


def _shown(x: arb) -> str:
    return str(x.str(6, radius=False))


def _net_broken(net: SphericalNet, old: SphericalNet, found: Surgery) -> str:
    """What is wrong with sides, old normals or the closing of the surface, or nothing."""
    moved = [
        v
        for v, place in enumerate(found.places)
        if any(not _small(e) for e in minus(old.normals[v], net.normals[place]))
    ]
    if moved:
        return f"the normal at the old vertex {moved[0]} has changed"
    cosine = dot(old.normals[0], old.normals[int(old.complex.edges[0, 1])])
    for edge, (one, other) in enumerate(net.complex.edges.tolist()):
        if not _small(dot(net.normals[one], net.normals[other]) - cosine):
            return f"edge {edge} has another length"
    points = surface_points(net)
    for edge, (one, other) in enumerate(net.complex.edges.tolist()):
        gap = minus(minus(points[other], points[one]), edge_step(net, edge, one))
        if any(not _small(ball(entry)) for entry in gap):
            return f"the surface does not close along edge {edge}"
    return ""


def rhombus_angles(setting: Setting) -> Evidence:
    """tan(alpha/2) tan(beta/2) = 1/cos delta for the angles of a spherical rhombus, of any side."""
    rhombus = corner(X, X, Z)
    far = close_quad(dot_s2, rhombus.n_0, rhombus.n_1, rhombus.n_2)
    sine, cosine = sine_and_cosine_part(S2, rhombus.n_1, far, rhombus.n_0)
    # The half-tangent at N_1 is sine/(1 + cosine), and both parts have the factor sin^2 delta.
    other = sine / (rhombus.sines[0] ** 2 + cosine)
    return identities(setting, {"product": Z * other * rhombus.cosines[0] - 1}, shown="")


def _obstruction(net: SphericalNet, at: int) -> str:
    """Why no three angles at a corner work, where both segments have one edge; or nothing.

    A rhombus of side delta has tan(A/2) tan(B/2) = cos delta for the surface's angles A, B, which
    are pi minus those of `rhombus_angles`. At the
    far end of a segment B has to be below what is left of 2 pi, so A is above a bound; the two
    bounds must leave something of the missing angle.
    """
    complex_ = net.complex
    sums = angle_sums(complex_, ball_angles(net)) / arb.pi()
    missing = printed.deficit(sums[at], int(complex_.degree[at]))
    least = arb(0)
    for along_u in (True, False):
        segment = boundary_segment(complex_, at, along_u=along_u)
        if len(segment) != 2:
            return ""
        end = int(segment[-1])
        left = printed.deficit(sums[end], int(complex_.degree[end])) * arb.pi()
        cosine = dot(net.normals[at], net.normals[end])
        if left < arb.pi():
            least += 2 * (cosine / (left / 2).tan()).atan() / arb.pi()
    if least > missing:
        return (
            f"whatever the three angles: the outer ones have to exceed {_shown(least)} pi "
            f"together, or the angles of the surface at the far ends of gamma_u and gamma_v exceed "
            f"2 pi, but only {_shown(missing)} pi are missing at the corner"
        )
    return ""


def surgery(setting: Setting, *, far_ends: str = "any", parts: int = 3) -> Evidence:
    """The lemma: three rectangles at any corner give a spherical Chebyshev net and a surface.

    far_ends: "any" corner of any net, or "free": only surgeries after which all rhombi reverse the
    orientation and the vertices at the far ends of both segments meet (eq:unramified); parts: of
    the missing angle.
    """
    relation = rhombus_angles(setting)
    if relation.outcome != "pass":
        return relation
    tried = met = 0
    with ctx.workprec(_BITS):
        for name, net, at, lengths in _cases(hard=True):
            tried += 1
            old = balled(net)
            found = operated(old, at, lengths, parts=parts)
            broken = _ranges_broken(found) if reverses_orientation(found.net) else "orientation"
            if far_ends == "free" and parts == 3 and broken:
                continue
            met += 1
            q = found.corner
            if found.net.complex.is_boundary[q] or not found.net.complex.is_disk:
                broken = broken or "the corner is still on the boundary"
            broken = _net_broken(found.net, old, found) or broken
            if broken:
                why = _obstruction(old, at) or broken
                return _failure(f"{name}, corner {at}, l = {lengths}: {why}", tried, met)
    return Evidence(
        outcome="pass",
        grade="certified",
        digits=36,
        tried=tried,
        met=met,
        shown=f"in {met} of {tried} surgeries on nine nets the rhombi reverse the orientation and "
        "the far ends meet (eq:unramified); each gives a net with sides of one length, the old "
        "normals, the corner inside and a surface that closes, in balls",
    )


def _failure(witness: str, tried: int, met: int) -> Evidence:
    return Evidence(outcome="fail", grade="certified", witness=witness, tried=tried, met=met)


def _over_surgeries(
    wrong: Callable[[SphericalNet, int, Surgery], str],
    shown: str,
    *,
    hard: bool = False,
    always_u: bool = False,
    parts: int = 3,
) -> Evidence:
    """Evidence that nothing is wrong with any surgery of the samples, in balls."""
    tried = 0
    with ctx.workprec(_BITS):
        for name, net, at, lengths in _cases(hard=hard):
            tried += 1
            found = operated(balled(net), at, lengths, always_u=always_u, parts=parts)
            if told := wrong(net, at, found):
                return _failure(f"{name}, corner {at}, l = {lengths}: {told}", tried, tried)
    return Evidence(
        outcome="pass", grade="certified", digits=36, tried=tried, met=tried, shown=shown
    )


def outer_curves(setting: Setting, *, always_u: bool = False) -> Evidence:
    """Whether the three sectors lie between the segments of the corner, in this order.

    The surgery begins with the segment from which the exterior is met counterclockwise; always_u:
    with the u-segment.
    """

    def wrong(net: SphericalNet, at: int, found: Surgery) -> str:
        return (
            ""
            if _small(found.third - found.alpha)
            else (
                f"the third angle is {_shown(found.third)} pi, alpha is {_shown(found.alpha)} pi; "
                f"the exterior begins with {'u' if begins_with_u(net.complex, at) else 'v'}"
            )
        )

    return _over_surgeries(
        wrong,
        "at all corners of six nets three sectors of angle alpha fill the exterior from one "
        "segment to the other; at half of them from gamma_v to gamma_u",
        always_u=always_u,
    )


def deficit(setting: Setting, *, high: str = "3", most: str = "3") -> Evidence:
    """Whether the missing angle is in (0, 3 pi), for every sum in the range of (eq:unramified).

    high: in delta = (high - d) pi - sum; most: the upper bound tested, in pi. Ends of the range,
    delta being linear in the sum, for every d; and the corners of the samples.
    """
    d = sp.Symbol("d", positive=True)
    lower, upper = printed.boundary_range(d)
    ends = [
        sp.simplify(printed.deficit(total, d, high=sp.Rational(high))) for total in (upper, lower)
    ]
    fine = bool(ends[0] >= 0) and bool(ends[1] <= sp.Rational(most))
    parts = {
        "ends": statement(
            fine, shown="", witness=f"delta ranges over ({ends[0]} pi, {ends[1]} pi), d arbitrary"
        )
    }
    alpha = sp.Symbol("alpha", real=True)
    total = sp.Symbol("S", real=True)
    # Three angles alpha make the sum 2 (1 - m) with 2m = d + 2.
    solved = sp.solve(3 * alpha + total - printed.interior_sum((d + 2) / 2), alpha)[0]
    stated = printed.surgery_angle(printed.deficit(total, d, high=sp.Rational(high)))
    parts["closing"] = identities(setting, {"alpha": solved - stated}, shown="")
    return combined(
        parts,
        shown="delta = (3 - d) pi - sum lies in (0, 2 pi), so in (0, 3 pi), for every d and every "
        "sum that (eq:unramified) allows, and is what makes three angles -pi + delta/3 close",
    )


def angle(setting: Setting, *, parts: str = "3", shift: str = "-1") -> Evidence:
    """Whether alpha = -pi + delta/3 is in (-pi, 0) for delta in (0, 3 pi), and closes a corner."""
    ends = [
        printed.surgery_angle(sp.Integer(x), parts=sp.Rational(parts), shift=sp.Rational(shift))
        for x in (0, 3)
    ]
    d, total = sp.Symbol("d", positive=True), sp.Symbol("S", real=True)
    alpha = printed.surgery_angle(
        printed.deficit(total, d), parts=sp.Rational(parts), shift=sp.Rational(shift)
    )
    inside = sp.Integer(-1) <= ends[0] and ends[1] <= 0
    return combined(
        {
            "range": statement(
                bool(inside), shown="", witness=f"alpha ranges over ({ends[0]} pi, {ends[1]} pi)"
            ),
            "closing": identities(
                setting,
                {"3 alpha + sum": 3 * alpha + total - printed.interior_sum((d + 2) / 2)},
                shown="",
            ),
        },
        shown="delta in (0, 3 pi) is alpha in (-pi, 0), and 3 alpha and the old sum are "
        "2 pi (1 - m) for the new degree 2m = d + 2",
    )


def directions(setting: Setting, *, parts: int = 3) -> Evidence:
    """Whether the third angle is alpha too; parts: into which the missing angle is divided."""

    def wrong(net: SphericalNet, at: int, found: Surgery) -> str:
        q = found.net.normals[found.corner]
        if not _small(dot(q, q) - 1) or not _small(found.third - found.alpha):
            return f"third angle {_shown(found.third)} pi, alpha {_shown(found.alpha)} pi"
        return ""

    return _over_surgeries(
        wrong,
        "at all corners of six nets the two angles determine two new directions, and the third "
        "angle is alpha again",
        parts=parts,
    )


def geodesics(setting: Setting, *, subtracted: int = 1, angle: str = "edge") -> Evidence:
    """Whether the printed points are equally spaced on a great circle, for any k and edge angle.

    angle: "edge" for the delta of the edges, "missing" for another angle; the shipped geodesic is
    compared for k up to 4.
    """
    delta, other = sp.symbols("delta epsilon", positive=True)
    c, s = circle(sp.Symbol("w", real=True))
    k = sp.Symbol("k", integer=True)
    q = corner().n_2
    # A unit tangent at q, turned by any angle, from the frame of two orthogonal ones.
    one, two = _frame()
    along = tuple(c * x + s * y for x, y in zip(one, two, strict=True))
    first = tuple(sp.cos(delta) * x + sp.sin(delta) * y for x, y in zip(q, along, strict=True))
    used = delta if angle == "edge" else other
    angles = (lambda n: sp.cos(n * used)), (lambda n: sp.sin(n * used))

    def point(n: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        return printed.geodesic_point(q, first, n, angles, subtracted=subtracted)

    shipped = geodesic_curve(sp, q, along, delta, 4)
    found = {
        "|gamma(k)|^2 - 1": dot(point(k), point(k)) - 1,
        "<gamma(k), gamma(k + 1)> - cos delta": dot(point(k), point(k + 1)) - sp.cos(delta),
        "gamma(0) - N(q)": minus(point(sp.Integer(0)), q),
        "gamma(1)": minus(point(sp.Integer(1)), first),
    }
    found |= {f"shipped gamma({n})": minus(point(sp.Integer(n)), shipped[n]) for n in range(2, 5)}
    return identities(
        setting,
        found,
        shown="for every unit vector N(q), direction, edge angle and integer k the printed points "
        "are unit vectors in steps of delta, in the plane of N(q) and gamma(1), and the shipped "
        "geodesic's",
    )


def _frame() -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """Two orthogonal unit tangents at the point q = (c, s cos t, s sin t) of `corner`."""
    c, s = circle(sp.Symbol("y", positive=True))
    turn = circle(sp.Symbol("z", real=True))
    return (-s, c * turn[0], c * turn[1]), (sp.Integer(0), -turn[1], turn[0])


def closes_corner(setting: Setting, *, parts: int = 3, added: int = 2) -> Evidence:
    """Whether the corner becomes an interior vertex of degree d + added with the right sum."""

    def wrong(net: SphericalNet, at: int, found: Surgery) -> str:
        complex_ = found.net.complex
        degree = int(complex_.degree[found.corner])
        total = (angle_sums(complex_, ball_angles(found.net)) / arb.pi())[found.corner]
        if complex_.is_boundary[found.corner] or degree != net.complex.degree[at] + added:
            return f"degree {degree}, before {net.complex.degree[at]}"
        if not _small(total - printed.interior_sum(degree // 2)):
            return f"sum {_shown(total)} pi at degree {degree}"
        return ""

    return _over_surgeries(
        wrong,
        "at all corners, of degree 2, 4 and 6, of nine nets the corner is an interior vertex of "
        "degree d + 2 whose angles add up to 2 pi (1 - m)",
        hard=True,
        parts=parts,
    )


def changes_nothing_else(
    setting: Setting, *, inner_degree: str = "any", sectors: int = 3
) -> Evidence:
    """Whether no branch point but the corner is made and none is changed.

    inner_degree: "any", or "3" for the corners whose segments have inner vertices of degree 3
    only; sectors: 5 attaches five of them, by combinatorics alone.
    """
    tried = met = 0
    with ctx.workprec(_BITS):
        for name, net, at, lengths in _cases(hard=True):
            tried += 1
            inner = np.concatenate(
                [boundary_segment(net.complex, at, along_u=u)[1:-1] for u in (True, False)]
            )
            if inner_degree == "3" and (net.complex.degree[inner] != 3).any():
                continue
            met += 1
            found = operated(balled(net), at, lengths)
            before = {int(found.places[v]) for v in net.complex.branch_points}
            after = {int(v) for v in found.net.complex.branch_points} - {found.corner}
            if sectors == 5:
                after = after | {found.corner}
            if after != before:
                new = sorted(after - before)
                degree = [int(found.net.complex.degree[v]) for v in new]
                return _failure(
                    f"{name}, corner {at}, l = {lengths}: new branch points {new} of degree "
                    f"{degree}",
                    tried,
                    met,
                )
            kept = [
                int(found.net.complex.degree[found.places[v]]) for v in net.complex.branch_points
            ]
            if kept != net.complex.degree[net.complex.branch_points].tolist():
                return _failure(f"{name}, corner {at}: a branch point changed", tried, met)
    return Evidence(
        outcome="pass",
        grade="exact",
        residual="0",
        tried=tried,
        met=met,
        shown=f"in {met} of {tried} surgeries on nine nets every inner vertex of both segments has "
        "degree 3; the branch points are then the old ones, of their degrees, and perhaps the "
        "corner",
    )


def even_degree(setting: Setting, *, swapped: bool = False) -> Evidence:
    """Whether corners have even degree, 2 or more; swapped: odd degree."""
    return degree_parity(setting, swapped=swapped)
