"""Checks of section 4: discrete surgery, three sectors put in at a corner."""

from collections.abc import Callable, Iterator
from itertools import chain, product

import numpy as np
from flint import arb, ctx

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import spherical_nets as printed
from checks.verify.discrete_lelieuvre import minus
from checks.verify.forced_sums import forced_sums
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
from checks.verify.unit_vectors import X, Z, corner
from discrete.complex_surgery import boundary_segment
from discrete.geodesics import sine_and_cosine_part
from discrete.index import angle_sums
from discrete.quad_rule import close_quad
from discrete.space_forms import S2, dot_s2
from discrete.spherical_net import SphericalNet, edge_step, surface_points
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


def _far_ends(net: SphericalNet, at: int, found: Surgery) -> list[int]:
    """Far ends of the two segments of a corner, as they are numbered after surgery."""
    ends = (boundary_segment(net.complex, at, along_u=u)[-1] for u in (True, False))
    return [int(found.places[v]) for v in ends]


def _ranges_broken(found: Surgery, vertices: list[int] | None = None) -> str:
    """First of these vertices, or of all, at which (eq:unramified) is not seen to hold."""
    complex_ = found.net.complex
    sums = angle_sums(complex_, ball_angles(found.net)) / arb.pi()
    for v in range(complex_.vertex_count) if vertices is None else vertices:
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


def _net_broken(old: SphericalNet, found: Surgery) -> str:
    """What is wrong with sides, old normals or the closing of the surface, or nothing."""
    net = found.net
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


def surgery(
    setting: Setting, *, far_ends: str = "any", stretch: str = "1", least: str = "-1"
) -> Evidence:
    """The lemma: three rectangles at any corner give a spherical Chebyshev net and a surface.

    far_ends: "any" corner of any net, or "free": only surgeries after which all rhombi reverse the
    orientation and the far ends of both segments meet (eq:unramified); stretch: factor of the
    edges of the new curves; least: of the angles of a rhombus in `forced_sums`.
    """
    relation = rhombus_angles(setting)
    if relation.outcome != "pass":
        return relation
    tried = met = 0
    with ctx.workprec(_BITS):
        for name, net, at, lengths in _cases(hard=True):
            tried += 1
            old = balled(net)
            found = operated(old, at, lengths, stretch=stretch)
            reversing = reverses_orientation(found.net)
            ends_free = reversing and not _ranges_broken(found, _far_ends(net, at, found))
            if far_ends == "free" and not ends_free:
                continue
            met += 1
            if broken := _broken(old, found, reversing):
                why = _obstruction(old, at) or broken
                return _failure(f"{name}, corner {at}, l = {lengths}: {why}", tried, met)
    instances = Evidence(
        outcome="pass" if met else "undecided", grade="certified", tried=tried, met=met
    )
    return combined(
        {"instances": instances, "sums": forced_sums(setting, least=least)},
        shown="angles in (-pi, 0) leave one sum at new vertices and inside the segments, for "
        f"every odd degree; in {met} of {tried} surgeries on nine nets the rhombi reverse the "
        "orientation and the far ends meet (eq:unramified), and in balls these give "
        "(eq:unramified) everywhere, sides of one length, the old normals, the corner inside and a "
        "surface that closes",
    )


def _broken(old: SphericalNet, found: Surgery, reversing: bool) -> str:
    """What the lemma says of the net after surgery that is not so, or nothing."""
    if not reversing:
        return "a rhombus keeps the orientation"
    if found.net.complex.is_boundary[found.corner] or not found.net.complex.is_disk:
        return "the corner is still on the boundary"
    return _ranges_broken(found) or _net_broken(old, found)


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
        "segment to the other, from gamma_v to gamma_u where the exterior begins at gamma_v",
        always_u=always_u,
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
    setting: Setting, *, inner_degree: str = "any", corner_too: bool = False
) -> Evidence:
    """Whether no branch point but the corner is made and none is changed.

    inner_degree: "any", or "3" for the corners whose segments have inner vertices of degree 3
    only; corner_too: claims that the corner does not become one either.
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
            after = {int(v) for v in found.net.complex.branch_points}
            if not corner_too:
                after -= {found.corner}
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
