"""Spherical nets: assembly, surgery at corners, the surface in space, against hyperbolic nets."""

import math

import numpy as np
import pytest
from flint import arb, ctx
from hypothesis import given, settings
from hypothesis.strategies import integers

from discrete import geodesics, spherical_net
from discrete.branched_net import regular_star
from discrete.edge_lengths import spherical_length
from discrete.elementary import ball_functions
from discrete.errors import ShapeError
from discrete.gluing import rectangle
from discrete.index import angle_sums, normal_winding, ramified_vertex
from discrete.space_forms import ORIGIN, S2, dot_s2
from discrete.spherical_net import (
    SphericalNet,
    assembled,
    attached_with_places,
    corner_angles,
    geodesic_curve,
    surface_points,
)

#: Rounding of some hundred steps in float64.
ROUNDING = 1e-11


def geodesic_star(order: int, edges: int, length: float) -> SphericalNet:
    """Star whose surface has equal angles at the centre; length: of the edges on H^2."""
    s = spherical_length(math, length)
    turn = math.pi / order - math.pi
    return assembled(
        [
            geodesic_curve(math, ORIGIN, (0.0, math.cos(k * turn), math.sin(k * turn)), s, edges)
            for k in range(2 * order)
        ]
    )


def with_corner_closed(net: SphericalNet, corner: int) -> tuple[SphericalNet, np.ndarray]:
    """Net with three equal sectors put in at a corner from which the exterior begins with u."""
    segments = [
        spherical_net.boundary_segment(net.complex, corner, along_u=u) for u in (True, False)
    ]
    q, first, last = (net.normals[v] for v in (corner, segments[0][1], segments[1][1]))
    angle = geodesics.angle_at(S2, math, q, first, last)
    # Three turns by a negative angle lead to the other segment of a corner of degree 2.
    alpha = ((angle % (2 * math.pi)) - 2 * math.pi) / 3
    along = geodesics.direction(S2, math, q, first)
    length = geodesics.distance(S2, math, q, first)
    curves = []
    for edges in (2, 1):
        along = geodesics.turned_direction(S2, math, q, along, alpha)
        curves.append(geodesic_curve(math, q, along, length, edges))
    return attached_with_places(net, corner, curves)


@settings(max_examples=12, deadline=None, derandomize=True)
@given(order=integers(2, 6), edges=integers(1, 5))
def test_angles_on_the_sphere_and_the_hyperbolic_plane_are_supplements(order, edges):
    net = geodesic_star(order, edges, 0.1)
    hyperbolic = regular_star(order, edge_length=0.1, edges=edges)
    assert (net.complex.faces == hyperbolic.complex.faces).all()
    angles = corner_angles(net, math).astype(float)
    assert np.abs(math.pi + angles - hyperbolic.corner_angles).max() < ROUNDING


def test_the_normals_wind_as_the_order_says():
    for order in (2, 3, 5):
        net = geodesic_star(order, 2, 0.1)
        inside = ~net.complex.is_boundary
        assert (
            normal_winding(net.complex, np.array(net.normals, dtype=float))
            == 1 - net.complex.saddle_order[inside]
        ).all()
        angles = corner_angles(net, math).astype(float)
        found = ramified_vertex(net.complex, angles, straight_angle=math.pi, tolerance=1e-9)
        assert found is None


def test_the_surface_closes_and_its_edges_have_the_sine_of_the_angle():
    net = geodesic_star(3, 3, 0.2)
    early = np.array(surface_points(net))
    late = np.array(surface_points(net, 7, last=True))
    assert np.abs(early - late - (early - late)[0]).max() < ROUNDING
    ends = net.complex.edges
    lengths = np.linalg.norm(early[ends[:, 0]] - early[ends[:, 1]], axis=1)
    assert np.abs(lengths - math.tanh(0.2)).max() < ROUNDING


def corner_beginning_with_u(net: SphericalNet) -> int:
    """Corner (n, 0) of a rectangle: its exterior is met counterclockwise from u to v."""
    return int(np.flatnonzero(net.complex.is_corner)[2])


def rectangle_net() -> SphericalNet:
    star = geodesic_star(2, 3, 0.1)
    complex_ = rectangle(3, 3)
    return SphericalNet(complex=complex_, normals=star.normals[:16])


def test_three_sectors_close_a_corner():
    net = rectangle_net()
    corner = corner_beginning_with_u(net)
    found, places = with_corner_closed(net, corner)
    q = int(places[corner])
    assert not found.complex.is_boundary[q]
    assert found.complex.is_disk
    assert found.complex.degree[q] == net.complex.degree[corner] + 2
    sums = angle_sums(found.complex, corner_angles(found, math).astype(float))
    assert sums[q] == pytest.approx(-2 * math.pi, abs=ROUNDING)
    for v, place in enumerate(places):
        assert net.normals[v] == found.normals[place]
    cosine = dot_s2(net.normals[0], net.normals[1])
    products = [dot_s2(found.normals[a], found.normals[b]) for a, b in found.complex.edges]
    assert np.abs(np.array(products) - cosine).max() < ROUNDING


def test_a_curve_in_the_wrong_direction_does_not_close_the_corner(monkeypatch):
    turned = geodesics.turned_direction
    monkeypatch.setattr(
        geodesics, "turned_direction", lambda s, f, p, along, a: turned(s, f, p, along, -a)
    )
    net = rectangle_net()
    found, places = with_corner_closed(net, corner_beginning_with_u(net))
    q = int(places[corner_beginning_with_u(net)])
    sums = angle_sums(found.complex, corner_angles(found, math).astype(float))
    assert abs(sums[q] + 2 * math.pi) > 1


def test_a_sign_in_the_step_is_caught(monkeypatch):
    monkeypatch.setattr(spherical_net, "edge_step", lambda net, edge, start: (1, 0, 0))
    net = geodesic_star(2, 2, 0.1)
    early, late = np.array(surface_points(net)), np.array(surface_points(net, 3, last=True))
    assert np.abs(early - late - (early - late)[0]).max() > 0.1


def test_angles_in_balls_contain_those_in_floats():
    net = geodesic_star(3, 2, 0.1)
    with ctx.workprec(96):
        balls = SphericalNet(
            complex=net.complex, normals=tuple(tuple(arb(x) for x in n) for n in net.normals)
        )
        found = corner_angles(balls, ball_functions())
        floats = corner_angles(net, math)
        for at, value in np.ndenumerate(found):
            assert value.is_finite()
            assert value.rad() < 1e-20
            assert abs(float(value.mid()) - floats[at]) < ROUNDING


def test_the_argument_in_balls_is_in_the_right_quadrant():
    functions = ball_functions()
    for y, x in ((1, 1), (1, -1), (-1, -1), (-1, 1)):
        found = functions.atan2(arb(y), arb(x))
        assert found.rad() < 1e-12
        assert float(found.mid()) == pytest.approx(math.atan2(y, x), rel=1e-14)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda curves: curves[:3], "even and at least 4"),
        (lambda curves: curves[:2], "even and at least 4"),
        (lambda curves: [*curves[:3], curves[3][1:]], "start at the same normal"),
    ],
)
def test_curves_that_make_no_star_are_refused(change, told):
    curves = [
        geodesic_curve(math, ORIGIN, (0.0, math.cos(k), math.sin(k)), 0.1, 2) for k in range(4)
    ]
    with pytest.raises(ShapeError, match=told):
        assembled(change(curves))


def test_normals_that_do_not_fit_are_refused():
    net = geodesic_star(2, 1, 0.1)
    with pytest.raises(ShapeError, match="8 normals for 9 vertices"):
        SphericalNet(complex=net.complex, normals=net.normals[:-1])
    corner = int(np.flatnonzero(net.complex.is_corner)[0])
    with pytest.raises(ShapeError, match="an even number"):
        attached_with_places(net, corner, [[net.normals[corner]]])
