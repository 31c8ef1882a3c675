"""Smoothed corners, the asymptotic coframe, and what smooth isometries approximate."""

import pytest
import sympy as sp
from mpmath import mp

from checks.evidence import Setting
from checks.verify import approximability, bounded_distortion, smoothed_saddle
from theory import asymptotic_coframe, smoothed_corner


@pytest.mark.parametrize("torsion", [1, -1])
def test_frames_stay_orthonormal(torsion: int):
    with mp.workdps(30):
        _, end = smoothed_corner.smoothed(mp.mpf(1), mp.mpf(1), mp.mpf("0.1"), torsion=torsion)
        frame = end[:3, :]
        assert mp.norm(frame * frame.T - mp.eye(3)) < mp.mpf("1e-25")


def test_without_turning_there_is_nothing_to_smooth():
    with mp.workdps(30):
        zero, half = mp.mpf(0), mp.mpf(1)
        _, sharp = smoothed_corner.cornered(zero, half, torsion=1)
        _, other = smoothed_corner.smoothed(zero, half, mp.mpf("0.3"), torsion=1)
        assert mp.norm(sharp - other) < mp.mpf("1e-25")


def test_a_straight_asymptotic_curve_is_a_line_along_which_the_normal_turns():
    with mp.workdps(30):
        _, end = smoothed_corner.cornered(mp.mpf(0), mp.mpf(1), torsion=1)
        assert mp.norm(end[3, :] - mp.matrix([[2, 0, 0]])) < mp.mpf("1e-25")
        # Torsion 1 over the length 2: the angle of N to its start.
        assert abs(end[2, 2] - mp.cos(2)) < mp.mpf("1e-25")


def test_the_coframe_is_closed_for_curvature_minus_one_only():
    half = asymptotic_coframe.H
    factors = asymptotic_coframe.asymptotic_coframe()["du"]
    closed = asymptotic_coframe.exterior(factors, sp.tan(half), -sp.cot(half))
    assert sp.simplify(closed) == 0
    other = asymptotic_coframe.exterior(factors, sp.tan(half), -2 * sp.cot(half))
    assert sp.simplify(other) != 0


@pytest.mark.parametrize(
    ("check", "mutant"),
    [
        (approximability.unsmooth, {"second": "2/3"}),
        (approximability.corners, {"add": "1/100"}),
        (approximability.smoothed_curves, {"percent": 101}),
        (approximability.normal_reverses, {"second_sign": 1}),
        (approximability.mollified, {"exponent": "oo"}),
        (bounded_distortion.inner_bounds, {"power": 0}),
        (bounded_distortion.coframe, {"product": 1}),
        (bounded_distortion.definition, {"constant": "201/100"}),
        (smoothed_saddle.continuous_angles, {"profile": "corner"}),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_checks_pass_on_the_truth_and_fail_on_a_mutant(check, mutant):
    assert check(Setting()).outcome == "pass"
    assert check(Setting(), **mutant).outcome == "fail"


def test_a_jump_in_the_second_form_is_no_uniform_limit():
    assert approximability.flat_limit(Setting()).outcome == "fail"
    assert approximability.flat_limit(Setting(), exponent="2").outcome == "pass"
    assert approximability.flat_limit(Setting(), exponent="7").outcome == "pass"


def test_the_condition_on_branch_points_needs_the_sign_of_the_index():
    assert approximability.branch_condition(Setting()).outcome == "fail"
    assert approximability.branch_condition(Setting(), factor=-1).outcome == "pass"
