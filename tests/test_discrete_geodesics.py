"""Geodesics, angles, parallelograms, isometries and views, in both spaces by one body of tests."""

import math

import pytest
from discrete_samples import BASE, SPACES, angles, apart, corner, directions, lengths
from flint import arb, ctx
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath import mp

from discrete import geodesics, half_plane, isometries, poincare_disk, sl2_frames
from discrete.elementary import array_functions, ball_functions
from discrete.parallelograms import half_defect, neighbour_angle, quad_area, side_product
from discrete.quad_rule import close_quad
from discrete.space_forms import H2, S2

in_both_spaces = pytest.mark.parametrize("space", SPACES, ids=lambda s: s.name)


@in_both_spaces
@given(exponent=st.floats(-150, 0.1), turn=directions)
def test_distance_keeps_its_digits_near_coincidence(space, exponent, turn):
    length = 10.0**exponent
    q = geodesics.polar(space, math, turn, length)
    assert abs(geodesics.distance(space, math, BASE, q) / length - 1) < 1e-14


def test_distance_by_the_arc_cosine_would_not():
    q = geodesics.polar(H2, math, 0.3, 1e-9)
    assert abs(math.acosh(max(1.0, -H2.dot(BASE, q))) / 1e-9 - 1) > 0.5


def test_distance_of_nearly_antipodal_points():
    q = geodesics.polar(S2, math, 0.3, math.pi - 1e-9)
    assert abs(math.pi - geodesics.distance(S2, math, BASE, q) - 1e-9) < 1e-15


@in_both_spaces
@given(a=st.floats(-9, 0), b=st.floats(-9, 0), angle=directions)
def test_angle_keeps_its_digits_for_short_edges(space, a, b, angle):
    assume(abs(angle) > 1e-3)
    p1 = geodesics.polar(space, math, 0.0, 10.0**a)
    p2 = geodesics.polar(space, math, angle, 10.0**b)
    assert abs(geodesics.angle_at(space, math, BASE, p1, p2) / angle - 1) < 1e-12


@in_both_spaces
@given(tiny=st.floats(-15, -3))
def test_tiny_and_nearly_straight_angles_keep_their_digits(space, tiny):
    # Relative to the angle, not to pi: the arc cosine would lose all digits below 1e-8.
    angle = 10.0**tiny
    p1 = geodesics.polar(space, math, 0.0, 0.4)
    p2 = geodesics.polar(space, math, angle, 0.7)
    back = geodesics.polar(space, math, 0.0, -0.4)
    assert abs(geodesics.angle_at(space, math, BASE, p1, p2) / angle - 1) < 1e-12
    assert abs(geodesics.turn_at(space, math, back, BASE, p2) / angle - 1) < 1e-12


@in_both_spaces
@given(a=lengths, b=lengths, angle=angles)
def test_midpoint_and_direction_fit_together(space, a, b, angle):
    p, q = geodesics.polar(space, math, 0.0, a), geodesics.polar(space, math, angle, b)
    length = geodesics.distance(space, math, p, q)
    assume(1e-2 < length < 3)
    along = geodesics.direction(space, math, p, q)
    half = geodesics.point_along(space, math, p, along, length / 2)
    assert apart(geodesics.midpoint(space, math, p, q), half) < 1e-12
    assert apart(geodesics.point_along(space, math, p, along, length), q) < 1e-12


@in_both_spaces
@given(a=lengths, b=lengths, angle=angles, turn=directions)
def test_the_angles_of_a_parallelogram(space, a, b, angle, turn):
    assume(space is H2 or a + b < 2.8)
    p1, p2 = corner(space, BASE, turn, angle, a, b)
    p12 = close_quad(space.dot, BASE, p1, p2)
    q = side_product(space, math, a, b)
    other = geodesics.angle_at(space, math, p1, p12, BASE)
    assert abs(math.remainder(neighbour_angle(math, q, angle) - other, 2 * math.pi)) < 1e-11
    total = math.tan(angle / 2) * math.tan(neighbour_angle(math, q, angle) / 2)
    napier = space.cosine(math, (a - b) / 2) / space.cosine(math, (a + b) / 2)
    assert abs(total / napier - 1) < 1e-10


@pytest.mark.parametrize(("space", "value"), [(H2, 1 / math.cosh(0.8)), (S2, 1 / math.cos(0.8))])
def test_the_relation_of_the_rhombus(space, value):
    q = side_product(space, math, 0.8, 0.8)
    tangents = math.tan(0.35) * math.tan(neighbour_angle(math, q, 0.7) / 2)
    assert abs(tangents - value) < 1e-14


@in_both_spaces
def test_the_area_of_a_quad_is_that_of_two_triangles(space):
    a, b, angle = 0.6, 0.9, 1.2
    p1, p2 = corner(space, BASE, 0.0, angle, a, b)
    triangle = (
        geodesics.angle_at(space, math, BASE, p1, p2)
        + geodesics.angle_at(space, math, p1, p2, BASE)
        + geodesics.angle_at(space, math, p2, BASE, p1)
    )
    q = side_product(space, math, a, b)
    expected = 2 * space.curvature * (triangle - math.pi)
    assert abs(quad_area(space, math, q, angle) - expected) < 1e-13


def test_the_defect_of_a_tiny_quad_keeps_its_digits():
    q = side_product(H2, math, 1e-9, 1e-8)
    assert abs(half_defect(math, q, 1e-5) / (2 * q * 1e-5) - 1) < 1e-9


@in_both_spaces
@given(a=lengths, angle=directions, b=lengths)
def test_isometries_preserve_products_and_do_what_they_say(space, a, angle, b):
    p, q = geodesics.polar(space, math, 0.4, a), geodesics.polar(space, math, -1.0, b)
    x, y = geodesics.polar(space, math, 2.0, 0.7), geodesics.polar(space, math, 2.5, 0.2)
    maps = {
        "half-turn": lambda z: isometries.half_turn(space.dot, p, z),
        "translation": lambda z: isometries.translation(space.dot, p, q, z),
        "rotation": lambda z: isometries.rotation(space, math, p, angle, z),
        "reflection": lambda z: isometries.reflection(space.dot, (0.0, 0.6, 0.8), z),
    }
    for move in maps.values():
        assert abs(space.dot(move(x), move(y)) - space.dot(x, y)) < 1e-10
        assert apart(isometries.apply(isometries.matrix(move), x), move(x)) < 1e-10
    assert apart(maps["translation"](p), q) < 1e-11
    assert apart(maps["rotation"](p), p) < 1e-11
    seen = geodesics.angle_at(space, math, p, x, maps["rotation"](x))
    assert abs(math.remainder(seen - angle, 2 * math.pi)) < 1e-9
    assert apart(maps["half-turn"](maps["half-turn"](x)), x) < 1e-10


@in_both_spaces
def test_four_kinds_of_numbers_agree(space):
    def measured(functions, number):
        one, zero = number(1), number(0)
        p = geodesics.polar(space, functions, number(1) / 4, number(3) / 4)
        q = geodesics.polar(space, functions, number(2), number(1) / 2)
        d = geodesics.distance(space, functions, p, q)
        return d, geodesics.angle_at(space, functions, (one, zero, zero), p, q)

    floats = measured(math, float)
    arrays = measured(array_functions(), lambda x: 0 * array_functions().cos(0.0) + float(x))
    with mp.workdps(30):
        multi = measured(mp, mp.mpf)
    with ctx.workprec(120):
        balls = measured(ball_functions(), arb)
        for f, a, m, ball in zip(floats, arrays, multi, balls, strict=True):
            assert ball.is_finite()
            assert ball.rad() < 1e-30
            assert abs(ball - arb(mp.nstr(m, 29))) < 1e-27
            assert abs(f - m) < 1e-14
            assert abs(a - f) < 1e-15


def test_ball_functions_refuse_a_float_that_is_no_integer():
    with pytest.raises(TypeError, match="float"):
        ball_functions().sin(0.1)
    assert ball_functions().sin(0.0) == 0
    with pytest.raises(AttributeError):
        ball_functions().gamma  # noqa: B018


@given(a=lengths, b=lengths, angle=directions)
def test_the_views_show_the_same_distances(a, b, angle):
    p, q = geodesics.polar(H2, math, 0.3, a), geodesics.polar(H2, math, angle, b)
    expected = geodesics.distance(H2, math, p, q)
    z, w = poincare_disk.to_disk(p), poincare_disk.to_disk(q)
    assert abs(poincare_disk.disk_distance(math, z, w) - expected) < 1e-12
    assert apart(poincare_disk.from_disk(z), p) < 1e-13
    assert abs(math.hypot(*z) - math.tanh(a / 2)) < 1e-15
    z, w = half_plane.to_half_plane(p), half_plane.to_half_plane(q)
    assert abs(half_plane.half_plane_distance(math, z, w) - expected) < 1e-12
    assert apart(half_plane.from_half_plane(z), p) < 1e-12


@given(a=lengths, turn=directions, b=lengths, angle=directions)
def test_the_disk_map_is_the_translation_of_triples(a, turn, b, angle):
    centre, x = geodesics.polar(H2, math, turn, a), geodesics.polar(H2, math, angle, b)
    moved = isometries.translation(H2.dot, BASE, centre, x)
    seen = poincare_disk.moebius(poincare_disk.to_disk(x), poincare_disk.to_disk(centre))
    assert apart(seen, poincare_disk.to_disk(moved)) < 1e-13


@given(a=lengths, turn=directions, b=lengths, angle=directions)
def test_frames_walk_as_triples_do(a, turn, b, angle):
    g = sl2_frames.advanced(math, sl2_frames.turned(math, sl2_frames.IDENTITY, turn), a)
    h = sl2_frames.advanced(math, sl2_frames.turned(math, g, angle), b)
    p = geodesics.polar(H2, math, turn, a)
    along = geodesics.direction(H2, math, p, BASE)
    along = geodesics.turned_direction(H2, math, p, along, math.pi + angle)
    q = geodesics.point_along(H2, math, p, along, b)
    assert apart(sl2_frames.triple_of(h), q) < 1e-11
    assert abs(sl2_frames.distance(math, g, h) - b) < 1e-12
    assert abs(sl2_frames.distance_from_start(math, h) - geodesics.distance(H2, math, BASE, q)) < (
        1e-12
    )
    seen = half_plane.moebius(h, (0.0, 1.0))
    assert apart(seen, half_plane.to_half_plane(sl2_frames.triple_of(h))) < 1e-9
    bearing = sl2_frames.bearing_from_start(math, g)
    assert abs(math.remainder(bearing - turn, 2 * math.pi)) < 1e-13


def test_frames_reach_where_triples_lose_everything():
    g = sl2_frames.IDENTITY
    for _ in range(400):
        g = sl2_frames.advanced(math, g, 1.0)
    assert abs(sl2_frames.distance_from_start(math, g) - 400) < 1e-12
