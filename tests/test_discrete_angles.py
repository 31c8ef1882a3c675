"""Angles advanced without coordinates, and positions by frames, against triples and balls."""

import math
from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from discrete_samples import SPACES, polyline
from flint import arb, ctx, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from discrete import angle_advance, geodesics, net_frames, sl2_frames
from discrete.angle_advance import checked_net_angles, net_angles, side_turns
from discrete.angle_kernel import filled_angles
from discrete.elementary import ball_functions
from discrete.errors import (
    AngleError,
    DiscreteError,
    EdgeLengthError,
    NotFiniteError,
    ShapeError,
)
from discrete.goursat_fill import fill
from discrete.space_forms import H2, S2

in_both_spaces = pytest.mark.parametrize("space", SPACES, ids=lambda s: s.name)


def curved_data(space, n, m, seed, corner=1.1):
    """Two turning sides with n and m edges of all lengths, and the angles that follow from them."""
    rng = np.random.default_rng(seed)
    u, v = (rng.uniform(0.02, 0.15, k).tolist() for k in (n, m))
    first = polyline(space, 0.0, u, rng.uniform(-0.2, 0.2, n - 1))
    second = polyline(space, corner, v, rng.uniform(-0.2, 0.2, m - 1))
    net = checked_net_angles(
        space,
        u,
        v,
        corner,
        u_turns=side_turns(space, math, first, net_on_left=True),
        v_turns=side_turns(space, math, second, net_on_left=False),
    )
    return net, fill(space.dot, first, second)


def angle_difference(a, b):
    """Distance of two angles modulo 2 pi."""
    return abs(math.remainder(a - b, 2 * math.pi))


@in_both_spaces
@settings(max_examples=20)
@given(n=st.integers(1, 9), m=st.integers(1, 9), seed=st.integers(0, 10**6))
def test_the_angles_are_those_of_the_filled_net(space, n, m, seed):
    net, nodes = curved_data(space, n, m, seed)
    for i in range(n):
        for j in range(m):
            p, p1, p2 = nodes[i][j], nodes[i + 1][j], nodes[i][j + 1]
            seen = geodesics.angle_at(space, math, p, p1, p2)
            assert angle_difference(seen, net.angles[i][j]) < 1e-10
            beside = geodesics.angle_at(space, math, p1, nodes[i + 1][j + 1], p)
            expected = math.pi - net.angles[i][j] - net.half_defects[i][j]
            assert angle_difference(beside, expected) < 1e-10


@in_both_spaces
def test_the_angles_around_a_vertex_add_up(space):
    net, _ = curved_data(space, 6, 6, 4)
    for i in range(5):
        for j in range(5):
            a, d = net.angles, net.half_defects
            beside = sum(math.pi - a[k] - d[k] for k in ((i + 1, j), (i, j + 1)))
            assert abs(a[i, j] + a[i + 1, j + 1] + beside - 2 * math.pi) < 1e-14


def wrong_neighbours(defect, u, v, corner, u_turns, v_turns, angles, defects):
    """Mutant: the defect of the quad itself in place of one of its neighbours."""
    angle_advance.fill_angles(defect, u, v, corner, u_turns, v_turns, angles, defects)
    for j in range(1, len(v)):
        for i in range(1, len(u)):
            rise = angles[i - 1][j] - angles[i - 1][j - 1]
            rise = rise + defects[i][j - 1] + defects[i - 1][j - 1]
            angles[i][j] = angles[i][j - 1] + rise
            defects[i][j] = defect(u[i] * v[j], angles[i][j])


@in_both_spaces
@pytest.mark.parametrize(
    "mutant", ["neighbours", "sign of q", "swapped sides", "edge length", "u and v"]
)
def test_the_filled_net_rejects(space, mutant):
    net, nodes = curved_data(space, 6, 6, 7)
    seen = geodesics.angle_at(space, math, nodes[5][5], nodes[6][5], nodes[5][6])
    assert angle_difference(net.angles[5, 5], seen) < 1e-11
    u, v = angle_advance.half_tangents(space, math, net.u_lengths, net.v_lengths)
    corner, first, second = net.angles[0, 0], (nodes[k][0] for k in range(7)), nodes[0]
    turns = [
        side_turns(space, math, list(first), net_on_left=True),
        side_turns(space, math, second, net_on_left=False),
    ]
    angles, defects = ([[0.0] * 6 for _ in range(6)] for _ in range(2))
    body = wrong_neighbours if mutant == "neighbours" else angle_advance.fill_angles
    if mutant == "sign of q":
        u = [-x for x in u]
    if mutant == "swapped sides":
        turns.reverse()
    if mutant == "edge length":
        v = [1.01 * x for x in v]
    if mutant == "u and v":
        u, v = v, u

    def defect(q, angle):
        return 2 * math.atan(q * math.sin(angle) / (1 - q * math.cos(angle)))

    body(defect, u, v, corner, *turns, angles, defects)
    assert angle_difference(angles[5][5], seen) > 1e-4


@in_both_spaces
def test_the_compiled_body_is_the_generic_one(space):
    net, _ = curved_data(space, 30, 20, 9)
    generic = net_angles(space, math, net.u_lengths, net.v_lengths, 1.1)
    angles, defects = filled_angles(
        space, net.u_lengths, net.v_lengths, 1.1, [0.0] * 29, [0.0] * 19
    )
    # The compiled sine and arc tangent may differ from math's in the last place.
    assert np.abs(angles - np.array(generic.angles)).max() < 1e-13
    assert np.abs(defects - np.array(generic.half_defects)).max() < 1e-14


@in_both_spaces
def test_floats_balls_mpmath_and_sympy_agree(space):
    lengths = ([Fraction(1, 4), Fraction(1, 3)], [Fraction(1, 5)])

    def advanced(functions, number):
        u, v = ([number(x) for x in side] for side in lengths)
        return net_angles(space, functions, u, v, number(Fraction(1))).angles[1][0]

    found = advanced(math, float)
    symbolic = advanced(sp, lambda x: sp.Rational(x.numerator, x.denominator))
    with mp.workdps(40):
        multi = advanced(mp, lambda x: mp.mpf(x.numerator) / x.denominator)
    with ctx.workprec(160):
        ball = advanced(ball_functions(), lambda x: arb(fmpq(x.numerator, x.denominator)))
        assert ball.is_finite()
        assert ball.rad() < 1e-40
        assert abs(ball - arb(mp.nstr(multi, 39))) < 1e-37
    assert abs(sp.N(symbolic, 40) - sp.Float(mp.nstr(multi, 39), 40)) < 1e-36
    assert abs(found - multi) < 1e-14


@settings(max_examples=20)
@given(n=st.integers(1, 7), m=st.integers(1, 7), seed=st.integers(0, 10**6))
def test_frames_are_where_the_half_turns_put_the_vertices(n, m, seed):
    net, nodes = curved_data(H2, n, m, seed)
    frames = net_frames.net_frames(net, math)
    for i in range(n + 1):
        for j in range(m + 1):
            found = sl2_frames.triple_of(frames[i][j])
            assert max(abs(a - b) for a, b in zip(found, nodes[i][j], strict=True)) < 1e-10


@settings(max_examples=20)
@given(data=st.data(), seed=st.integers(0, 10**6))
def test_distances_between_any_two_vertices(data, seed):
    net, nodes = curved_data(H2, 5, 6, seed)
    start, end = (data.draw(st.tuples(st.integers(0, 5), st.integers(0, 6))) for _ in range(2))
    g = net_frames.relative_frame(net, math, start, end)
    p, q = nodes[start[0]][start[1]], nodes[end[0]][end[1]]
    expected = geodesics.distance(H2, math, p, q)
    assert abs(sl2_frames.distance_from_start(math, g) - expected) < 1e-10


STRIP = 1e-10  # required of the strip u <= 200, v <= 1/200


def test_a_long_strip_of_an_amsler_sector_agrees_with_balls():
    u, v, corner = [0.05] * 4000, [1 / 2000] * 10, math.pi / 2
    net = checked_net_angles(H2, u, v, corner)
    frames = net_frames.net_frames(net, math)
    with ctx.workprec(256):
        functions = ball_functions()
        # The same rule on the same data: each double is an exact ball.
        exact = net_angles(H2, functions, [arb(x) for x in u], [arb(x) for x in v], arb(corner))
        worst = max(
            (abs(exact.angles[i][j] - net.angles[i, j]) for i in range(4000) for j in range(10)),
            key=float,
        )
        assert all(a.is_finite() and a.rad() < 1e-30 for row in exact.angles for a in row)
        assert worst < STRIP
        places = net_frames.net_frames(exact, functions)
        for i in range(1, 4001, 7):
            for j in (0, 1, 4, 7, 10):
                ball = sl2_frames.distance_from_start(functions, places[i][j])
                assert ball.is_finite()
                assert ball.rad() < 1e-15
                found = sl2_frames.distance_from_start(math, frames[i][j])
                assert abs(ball - found) < STRIP


def test_distances_across_the_far_end_of_the_strip():
    net = checked_net_angles(H2, [0.05] * 4000, [1 / 2000] * 10, math.pi / 2)
    near, far = (3900, 2), (4000, 9)
    found = sl2_frames.distance_from_start(math, net_frames.relative_frame(net, math, near, far))
    with ctx.workprec(256):
        functions = ball_functions()
        u, v = ([arb(x) for x in side] for side in (net.u_lengths, net.v_lengths))
        exact = net_angles(H2, functions, u, v, arb(math.pi / 2))
        g = net_frames.relative_frame(exact, functions, near, far)
        ball = sl2_frames.distance_from_start(functions, g)
        assert ball.rad() < 1e-30
        assert abs(ball - found) < 1e-12


def test_the_global_frames_would_lose_what_the_relative_ones_keep():
    net = checked_net_angles(H2, [0.05] * 4000, [1 / 2000] * 10, math.pi / 2)
    frames = net_frames.net_frames(net, math)
    g = net_frames.relative_frame(net, math, (3999, 2), (4000, 2))
    assert abs(sl2_frames.distance_from_start(math, g) - 0.05) < 1e-15
    assert abs(sl2_frames.distance(math, frames[3999][2], frames[4000][2]) - 0.05) > 1e-3


def test_angles_far_out_where_triples_fail():
    # 40 steps of 1/2 along two axes at an angle of 1: two rows from the axis, at distance 20.
    steps = [0.5] * 40
    net = checked_net_angles(H2, steps, steps[:3], 1.0)
    with ctx.workprec(512):
        half = arb(1) / 2
        exact = net_angles(H2, ball_functions(), [half] * 40, [half] * 3, arb(1))
        assert abs(exact.angles[39][2] - net.angles[39, 2]) < 1e-13
    sides = [[geodesics.polar(H2, math, a, 0.5 * k) for k in range(41)] for a in (0.0, 1.0)]
    with np.errstate(all="ignore"):
        nodes = fill(H2.dot, sides[0][:30], sides[1][:4])
    seen = geodesics.angle_at(H2, math, nodes[28][2], nodes[29][2], nodes[28][3])
    assert angle_difference(seen, net.angles[28, 2]) > 1e-6  # triples at distance 14


def test_bad_data_are_named():
    good = ([0.1, 0.2], [0.1, 0.3], 1.0)
    with pytest.raises(EdgeLengthError, match=r"u-edge 1 has the length -0\.2"):
        checked_net_angles(H2, [0.1, -0.2], *good[1:])
    with pytest.raises(EdgeLengthError, match="v-edge 0 has the length 0"):
        checked_net_angles(H2, good[0], [0.0], 1.0)
    with pytest.raises(NotFiniteError, match="v-edge 1 has the length nan"):
        checked_net_angles(H2, good[0], [0.1, math.nan], 1.0)
    with pytest.raises(EdgeLengthError, match="not below pi"):
        checked_net_angles(S2, [0.1, 2.0], [1.3], 1.0)
    for angle in (0.0, -1.0, math.pi, math.nan):
        with pytest.raises(AngleError, match=r"vertex \(0, 0\)"):
            checked_net_angles(H2, *good[:2], angle)
    with pytest.raises(ShapeError, match="3 turns for the 1 inner vertices of the u-side"):
        checked_net_angles(H2, *good, u_turns=[0.0, 0.0, 0.0])
    with pytest.raises(NotFiniteError, match="turn at vertex 1 of the v-side is inf"):
        checked_net_angles(H2, *good, v_turns=[math.inf])
    with pytest.raises(AngleError, match="turn at vertex 1 of the u-side is 4"):
        checked_net_angles(H2, *good, u_turns=[4.0])
    with pytest.raises(ShapeError, match="no v-edges"):
        checked_net_angles(H2, [0.1], [], 1.0)


def test_frames_refuse_the_sphere_and_missing_vertices():
    net = checked_net_angles(S2, [0.1], [0.1], 1.0)
    with pytest.raises(DiscreteError, match="S\\^2"):
        net_frames.net_frames(net, math)
    net = checked_net_angles(H2, [0.1], [0.1], 1.0)
    with pytest.raises(DiscreteError, match=r"no vertex \(0, 2\)"):
        net_frames.relative_frame(net, math, (0, 0), (0, 2))
