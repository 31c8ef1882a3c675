"""The folded corner, its surfaces, the nets that confirm them, and the searches around them."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from checks.evidence import Setting
from checks.searches import translation_nets
from checks.verify import corner_remainders, double_point, normal_map_lemma
from checks.verify.translation_net_searches import net_of, trace
from theory import folded_corner_surface, half_turn_net, normal_distortion
from theory.folded_corner import FoldedCorner, square, squared_distance

SHARP = st.fractions(min_value=Fraction(1, 400), max_value=Fraction(1, 12), max_denominator=400)


@given(t=SHARP)
def test_the_two_places_have_one_normal_and_different_positions(t: Fraction):
    corner = FoldedCorner(t=t, spare=t / 4)
    right, left = corner.double_point()
    assert corner.normal(right) == corner.normal(left)
    assert corner.position(right) != corner.position(left)


@given(t=SHARP, u=st.fractions(-3, 3), v=st.fractions(-3, 3))
def test_the_normal_is_that_of_asymptotic_curves_and_reverses_areas(t, u, v):
    corner = FoldedCorner(t=t, spare=t / 4)

    def steps(f):
        at = f((u, v))
        ends = (f((u + Fraction(1, 9), v)), f((u, v + Fraction(1, 9))))
        return [(x - at[0], y - at[1]) for x, y in ends]

    r, n = steps(corner.position), steps(corner.normal)
    # No second form along u and along v: N_u is r_u turned to the left, N_v to the right.
    assert n[0] == (-r[0][1], r[0][0])
    assert n[1] == (r[1][1], -r[1][0])


@given(t=SHARP)
def test_the_directions_are_unit_vectors_with_all_angles_in_range(t: Fraction):
    corner = FoldedCorner(t=t, spare=t / 4)
    for x, y in (corner.steep, corner.bent, corner.turn):
        assert x * x + y * y == 1
    sine = corner.bent[0] * corner.steep[1] - corner.bent[1] * corner.steep[0]
    # sin(theta - gamma) = sin(phi0) = sin(pi - 2 theta): both ends of the range are attained.
    assert sine == corner.sine
    # tan(phi0/2) = 1/k_max, by the formula of the double angle.
    assert 2 / (corner.curvature + 1 / corner.curvature) == corner.sine


@given(t=SHARP)
def test_the_path_between_the_double_points_runs_on_their_segment(t: Fraction):
    corner = FoldedCorner(t=t, spare=t / 4)
    places = [corner.position(place) for place in corner.path()]
    assert len({y for _, y in places}) == 1
    assert [x for x, _ in places] == sorted(x for x, _ in places)
    assert all(u <= 0 or v >= 0 for u, v in corner.path())


def test_the_boundary_polygon_is_closed_and_keeps_to_the_region():
    corner = FoldedCorner(t=Fraction(1, 40), spare=Fraction(1, 160))
    corners = corner.boundary()
    assert corners[0] == corners[-1]
    assert corner.squared_room() < 1


def test_the_distance_from_a_segment():
    start, end = (Fraction(0), Fraction(0)), (Fraction(2), Fraction(0))
    assert squared_distance((Fraction(1), Fraction(3)), start, end) == 9
    assert squared_distance((Fraction(5), Fraction(4)), start, end) == 25
    assert square(start, end) == 4


@pytest.mark.parametrize("t", [Fraction(0), Fraction(1, 5), Fraction(-1, 40)])
def test_a_corner_that_does_not_fold_is_refused(t: Fraction):
    with pytest.raises(ValueError, match="gamma"):
        FoldedCorner(t=t, spare=Fraction(1, 100))


def test_a_square_too_small_for_the_double_point_is_refused():
    with pytest.raises(ValueError, match="extent"):
        FoldedCorner(t=Fraction(1, 40), spare=Fraction(1, 160), extent=Fraction(2))


def test_the_bounds_hold_for_every_smaller_scale_at_once():
    with ctx.workprec(128):
        family = folded_corner_surface.surfaces(Fraction(1, 40))
        small = folded_corner_surface.CornerSurfaces(
            net=family.net, scale=family.scale / 10**6, step=family.step / 10**6
        )
        assert family.size.contains(small.size)
        assert small.box_margin() > family.box_margin().lower()
        assert small.room() > family.room().lower()


def test_the_lemma_is_refuted_as_printed_and_on_larger_disks_proved():
    assert normal_map_lemma.lemma(Setting()).outcome == "fail"
    assert normal_map_lemma.lemma(Setting(), power="2").outcome == "pass"
    assert normal_map_lemma.lemma(Setting(), power="1").outcome == "undecided"


def test_the_distortion_tends_to_one_on_small_disks():
    with ctx.workprec(64):
        cell = normal_distortion.Cell(rho=arb("1e-6"), s=arb(1))
        assert abs(normal_distortion.relative_distortion(cell) - 1) < arb("1e-11")


@pytest.mark.parametrize(("rho", "s"), [(0.5, 1.0), (0.5, 0.2), (0.3, 4.0)])
def test_the_distortion_is_that_of_the_chart_or_of_the_projection(rho: float, s: float):
    radius, delta = rho * s, rho * s / 3
    # ds = |dx|/(1 - |x/2|^2), |x/2| = tanh(d/2); the projection from the hemisphere at k R.
    chart, shadow = 1 / (1 - np.tanh(radius / 2) ** 2), 1 / np.cos(rho)
    distortion = max(chart, shadow)
    with ctx.workprec(64):
        cell = normal_distortion.Cell(rho=arb(rho), s=arb(s))
        found = float(normal_distortion.relative_distortion(cell))
        needed = float(normal_distortion.radius_needed(cell))
        collar = float(normal_distortion.collar_constant(cell, arb(delta)))
    assert found == pytest.approx(distortion, rel=1e-12)
    assert needed >= 2 * distortion**2 * (radius / 2) / np.tanh(radius / 2)
    assert collar <= 2 * np.tanh(delta / 2) / delta / distortion


@pytest.mark.parametrize("curvature", [1, -1])
def test_half_turns_keep_the_edges_and_the_space_form(curvature: int):
    lines = [half_turn_net.broken_geodesic(np.full(20, a), 0.02, curvature) for a in (0.1, 1.4)]
    points = half_turn_net.net(lines[0], lines[1], curvature)
    norm = half_turn_net.inner(points, points, curvature)
    assert np.max(np.abs(norm - curvature)) < 1e-12
    for edges in (np.diff(points, axis=0), np.diff(points, axis=1)):
        length = half_turn_net.inner(edges, edges, curvature)
        assert np.ptp(length) < 1e-12


def test_half_turns_refuse_sides_that_do_not_meet():
    line = half_turn_net.broken_geodesic(np.zeros(4), 0.1, 1)
    with pytest.raises(ValueError, match="one point"):
        half_turn_net.net(line, line[1:], 1)


def test_half_turns_converge_with_order_two():
    ends = []
    for cells in (8, 16, 32, 64, 128, 256):
        lines = [half_turn_net.broken_geodesic(np.full(cells, a), 1 / cells, 1) for a in (0, 1.2)]
        ends.append(half_turn_net.net(lines[0], lines[1], 1)[-1, -1])
    steps = [float(np.max(np.abs(b - a))) for a, b in pairwise(ends)]
    orders = np.log2(np.array(steps[:-1]) / np.array(steps[1:]))
    assert len(orders) == 4
    assert np.all((orders > 1.9) & (orders < 2.1))


def test_nets_find_the_double_point_and_reject_a_wrong_distance():
    assert double_point.on_nets(Setting()).outcome == "pass"
    assert double_point.on_nets(Setting(), wider="101/100").outcome == "fail"
    assert corner_remainders.remainders(Setting(), cells=16).outcome == "pass"


def test_rays_agree_with_the_free_radius_of_the_search():
    point = np.array([*translation_nets.folded_corner(20.0), 0.1])
    a, la, b, lb = translation_nets.split(point, 3)
    angles, met, radius, apart, both = translation_nets.inscribed(a, la, b, lb, 0j, 0.1, 1.0)
    free = translation_nets.free_radius(angles, met, 0.0)
    assert both
    assert radius == pytest.approx(apart)
    net = net_of(point, 3)
    inside = [
        phi
        for w in np.linspace(0, 2 * np.pi, 50)
        for _, phi, _ in trace(net, (0.0, 0.0), float(w), free * 0.999)
    ]
    assert min(inside) > 0
    past = [
        phi
        for w in np.linspace(0, 2 * np.pi, 400)
        for _, phi, _ in trace(net, (0.0, 0.0), float(w), free * 1.01)
    ]
    assert min(past) < 0
