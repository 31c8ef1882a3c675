"""Nets with corners for the checks of discrete surgery, and the surgery itself, in balls."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import pi
from typing import Any

import numpy as np
import sympy as sp
from flint import arb

from checks.printed import spherical_nets as printed
from checks.verify.spherical_samples import EDGE, POLE, ball, ball_angles, direction, ray, star_net
from checks.verify.unit_vectors import circle
from discrete import geodesics
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_surgery import boundary_segment, restricted
from discrete.elementary import ball_functions
from discrete.gluing import rectangle
from discrete.goursat_fill import fill
from discrete.index import angle_sums
from discrete.quad_rule import close_quad
from discrete.signed_graph import IntArray
from discrete.space_forms import S2, dot_s2
from discrete.spherical_net import (
    SphericalNet,
    assembled,
    attached_with_places,
    geodesic_curve,
)
from theory.vectors import Vector, added, cross, scaled


def rectangle_net(n: int, m: int, angle: float) -> SphericalNet:
    """Rational net of n by m rhombi between two curves with turns, at this angle of normals."""
    turn = sp.Rational(1, 20)
    first, second = ray(0.0, n, turns=[turn] * n), ray(-angle, m, turns=[-turn] * m)
    nodes = fill(dot_s2, first, second)
    normals = tuple(nodes[i][j] for i in range(n + 1) for j in range(m + 1))
    return SphericalNet(complex=rectangle(n, m), normals=normals)


def partial_star(
    surface_angles: Sequence[float], kept: int, edges: int, *, edge: Any = EDGE
) -> SphericalNet:
    """First `kept` sectors of a star of geodesics whose surface has these angles, in pi."""
    turned = np.cumsum([0.0, *(angle - 1 for angle in surface_angles[:-1])])
    net = assembled([ray(pi * t, edges, edge=edge) for t in turned])
    keep = np.arange(len(net.complex.faces)) < kept * edges * edges
    complex_, place = restricted(net.complex, keep)
    normals = {int(place[v]): n for v, n in enumerate(net.normals) if place[v] >= 0}
    return SphericalNet(complex=complex_, normals=tuple(normals[v] for v in range(len(normals))))


def slotted() -> SphericalNet:
    """Three sectors, of three rhombi in all, whose angles at vertex 0 add up to about 1.8 pi."""
    return partial_star([0.6, 0.6, 0.6, 0.2], 3, 1)


def _neighbour(p: Vector, known: Vector, angle: float) -> Vector:
    """Rational point as far from p as `known`, in its direction turned left by about an angle."""
    c, s = circle(EDGE)
    along = tuple((x - c * y) / s for x, y in zip(known, p, strict=True))
    x, y = direction(angle)
    left = cross(p, (along[0], along[1], along[2]))
    return added(
        scaled(c, p), scaled(s, added(scaled(x, (along[0], along[1], along[2])), scaled(y, left)))
    )


def between_two_slots(*, at_corner: float = 0.7, beside: float = 0.8) -> SphericalNet:
    """Five rhombi: one with the corner q = 0, and two more at each of its neighbours 1 and 3.

    at_corner, beside: angles of the surface in the first and in the four others, in pi; by default
    those at the vertices 1 and 3 add up to about 1.9 pi.
    """
    q, c, s = POLE, *circle(EDGE)
    a = (c, s, sp.Integer(0))
    b = _neighbour(q, a, -(1 - at_corner) * pi)
    far = close_quad(dot_s2, q, a, b)
    turn = (1 - beside) * pi
    g_1 = _neighbour(a, far, turn)
    g_2 = _neighbour(a, g_1, turn)
    h_1 = _neighbour(b, far, -turn)
    h_2 = _neighbour(b, h_1, -turn)
    ends = [
        close_quad(dot_s2, a, g_1, far),
        close_quad(dot_s2, a, g_1, g_2),
        close_quad(dot_s2, b, far, h_1),
        close_quad(dot_s2, b, h_2, h_1),
    ]
    faces = [(0, 1, 2, 3), (1, 4, 6, 2), (1, 4, 7, 5), (3, 2, 10, 8), (3, 9, 11, 8)]
    normals = (q, a, far, b, g_1, g_2, ends[0], ends[1], h_1, h_2, ends[2], ends[3])
    return SphericalNet(complex=AsymptoticComplex(faces=np.array(faces)), normals=normals)


def half_monkey_star() -> SphericalNet:
    """Four of the six sectors of a regular star of order 3, of two edges each."""
    return partial_star([1 / 3] * 6, 4, 2)


def samples() -> Iterator[tuple[str, SphericalNet]]:
    """Nets that meet (eq:unramified), by name."""
    yield "rectangle of 2 by 3", rectangle_net(2, 3, 2 * pi / 3)
    yield "rectangle of 1 by 1", rectangle_net(1, 1, pi / 2)
    yield "star of order 2", star_net(2)
    yield "star of order 3", star_net(3)
    yield "three of four sectors", partial_star([0.5] * 4, 3, 2)
    yield "five of six sectors", partial_star([1 / 3] * 6, 5, 1)


def corners(net: SphericalNet) -> list[int]:
    """Corner vertices of the net's complex."""
    return [int(v) for v in np.flatnonzero(net.complex.is_corner)]


def begins_with_u(complex_: AsymptoticComplex, corner: int) -> bool:
    """Whether the exterior at a corner is met counterclockwise from its u- to its v-segment."""
    signs = complex_.orientation
    if signs is None:
        raise ValueError("a one-sided complex has no exterior angle")
    for face in np.flatnonzero((complex_.faces == corner).any(axis=1)):
        k = int(np.flatnonzero(complex_.faces[face] == corner)[0])
        # The last side of a face at its corner k, counterclockwise.
        side = (k - 1) % 4 if signs[face] > 0 else k
        edge = complex_.sides.edge_of[face, side]
        if complex_.sides.counts[edge] == 1:
            return bool(complex_.edge_is_u[edge])
    raise ValueError(f"vertex {corner} is no corner")


@dataclass(frozen=True, kw_only=True)
class Surgery:
    """Result of discrete surgery at a corner, in balls.

    missing, alpha, third: the missing angle, the printed angle and the third angle, in units of
    pi; places: new number of each old vertex; corner: that of the corner.
    """

    net: SphericalNet
    places: IntArray
    corner: int
    missing: arb
    alpha: arb
    third: arb


def operated(
    net: SphericalNet,
    corner: int,
    lengths: tuple[int, int],
    *,
    always_u: bool = False,
    parts: int = 3,
    stretch: str = "1",
) -> Surgery:
    """Discrete surgery as in its proof, on a net in balls, at the precision in force.

    always_u: begins with the u-segment though the exterior may be met from v to u; parts: into
    which the missing angle is divided; stretch: factor of the edges of the new curves.
    """
    functions, complex_ = ball_functions(), net.complex
    total = angle_sums(complex_, ball_angles(net))[corner] / arb.pi()
    missing = printed.deficit(total, int(complex_.degree[corner]))
    alpha = printed.surgery_angle(missing, parts=parts)
    from_u = always_u or begins_with_u(complex_, corner)
    start = boundary_segment(complex_, corner, along_u=from_u)
    end = boundary_segment(complex_, corner, along_u=not from_u)
    q, first = net.normals[corner], net.normals[start[1]]
    delta = geodesics.distance(S2, functions, q, first) * ball(sp.Rational(stretch))
    along = geodesics.direction(S2, functions, q, first)
    curves = []
    for length in lengths:
        along = geodesics.turned_direction(S2, functions, q, along, alpha * arb.pi())
        curves.append(geodesic_curve(functions, q, along, delta, length))
    third = geodesics.angle_at(S2, functions, q, curves[-1][1], net.normals[end[1]]) / arb.pi()
    new, places = attached_with_places(net, corner, curves if from_u else curves[::-1])
    return Surgery(
        net=new,
        places=places,
        corner=int(places[corner]),
        missing=missing,
        alpha=alpha,
        third=third,
    )
