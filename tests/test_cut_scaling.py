"""What the claims on all sectors rest on: ways to the rim, floors of angles, trees, extremes."""

from fractions import Fraction
from itertools import pairwise

import pytest
import sympy as sp
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp

from checks.evidence import Setting
from checks.verify import branch_count, cut_coordinates, smallest_angle
from checks.verify.extremes import cell, largest
from theory import angle_floor, bessel_envelope, branching, cut_corner, rim_distance
from theory.precision import ball_of, working

COSINES = st.fractions(-1, 1, max_denominator=50)
OFFSETS = st.fractions(0, 6, max_denominator=50)
GAPS = st.fractions(Fraction(1, 50), 4, max_denominator=50)


@given(offset=OFFSETS, gap=GAPS, cosine=COSINES)
def test_the_geodesic_ends_on_the_rim(offset: Fraction, gap: Fraction, cosine: Fraction):
    with working(200):
        d, radius, c = ball_of(offset), ball_of(offset + gap), ball_of(cosine)
        length = rim_distance.axis_length(radius, d, c)
        reached = d.cosh() * length.cosh() + c * d.sinh() * length.sinh()
        assert reached.overlaps(radius.cosh())
        assert length.rad() < 1e-40
        assert length >= ball_of(gap) or length.overlaps(ball_of(gap))


def test_the_symbolic_geodesic_stays_on_the_hyperboloid():
    d, length, c = sp.symbols("d l c", positive=True)
    x = rim_distance.along(d, c, length)
    norm = sp.expand((-(x[0] ** 2) + x[1] ** 2 + x[2] ** 2 + 1).rewrite(sp.exp))
    assert sp.simplify(norm) == 0


def test_a_point_on_a_diameter_has_ways_s_and_2d_plus_s_to_the_rim():
    with working(100):
        radius, d = arb(5), arb(2)
        assert rim_distance.axis_length(radius, d, arb(1)).overlaps(arb(3))
        assert rim_distance.axis_length(radius, d, arb(-1)).overlaps(arb(7))


def test_the_corner_solves_both_conditions():
    u, v = cut_corner.corner(sp.Integer(6), sp.Integer(3), sp.Integer(5))
    assert (4 * u * 5, 4 * 3 * v) == (36, 36)
    value = cut_corner.corner_value(sp.Integer(6), sp.Integer(3), sp.Integer(5))
    assert sp.simplify(value**2 - 4 * u * v) == 0


def test_the_excess_changes_sign_once_at_its_zero():
    zero = angle_floor.least_w(digits=30).ball()
    with working(120):
        step = arb(10) ** -20
        assert angle_floor.excess(zero - step) < 0 < angle_floor.excess(zero + step)
        values = [angle_floor.excess(arb(n) / 4) for n in range(40)]
        assert all(a < b for a, b in pairwise(values) if b > -1.99)
        assert values[0] == -2


def test_the_least_radius_agrees_with_the_root_of_mpmath():
    low, high = angle_floor.least_radius(digits=20).ends()
    other = Fraction(mp.nstr(angle_floor.least_radius_reference(digits=30), 30))
    slack = Fraction(1, 10**25)
    assert low - slack <= other <= high + slack


@pytest.mark.parametrize(("radius", "holds"), [("2", False), ("2.1", True), ("30", True)])
def test_the_grid_sees_the_least_radius(radius: str, holds: bool):
    y = 2 * mp.mpf("1.17109891264738565") * mp.sqrt(mp.mpf(radius))
    assert (angle_floor.lowest_share(y) >= 1) == holds


def test_a_path_falls_once_if_small_angles_stay():
    stays = angle_floor.lowest_on_path(lambda a: Fraction(1 if a <= 1 else Fraction(1, 3)), 4)
    assert stays == Fraction(4, 9)
    falls = angle_floor.lowest_on_path(lambda a: Fraction(1, 2), Fraction(1), cuts=5)
    assert falls == Fraction(1, 32)


@given(y=st.fractions(1, 2000, max_denominator=100))
def test_the_growth_of_i0_is_bounded_on_both_sides(y: Fraction):
    with working(200):
        at = ball_of(y)
        low, high = bessel_envelope.log_bounds(at)
        assert low < at.bessel_i(0).log() < high


@pytest.mark.parametrize("daughters", [1, 2, 3, 4])
def test_the_nodes_of_a_tree_counted_one_by_one(daughters: int):
    for generations in range(1, 6):
        sizes = [1]
        for _ in range(generations - 1):
            sizes.append(sizes[-1] * daughters)
        assert branching.nodes(daughters, sp.Integer(generations)) == sum(sizes)
    assert sp.simplify(branching.rate(daughters) - sp.log(daughters)) == 0


def test_the_largest_value_of_a_parabola():
    with ctx.workprec(80):
        width = Fraction(1, 10**4)
        found = largest(lambda x: x * (1 - x), Fraction(0), Fraction(2), width=width)
        assert found.contains(arb(1) / 4)
        assert found.rad() < 1e-4


def test_a_cell_without_a_finite_value_is_halved_not_believed():
    def quotient(x):
        return 1 / (1 + x * x - x)

    with ctx.workprec(80):
        assert not quotient(cell(Fraction(0), Fraction(4))).is_finite()
        found = largest(quotient, Fraction(0), Fraction(4), width=Fraction(1, 1000))
        assert found.contains(arb(4) / 3)


def test_too_many_cells_raise():
    with ctx.workprec(80), pytest.raises(ArithmeticError):
        largest(lambda x: x - x, Fraction(0), Fraction(1), width=Fraction(1, 10**9))


def test_the_quotient_of_the_cut_coordinates_is_tested_on_both_sides():
    assert cut_coordinates.zeta_like(Setting()).outcome == "pass"
    assert cut_coordinates.zeta_like(Setting(), steepest="49/100").outcome == "fail"


def test_the_decay_is_refuted_with_any_power_of_the_radius():
    for power in ("-3", "-1", "0", "1", "3"):
        assert smallest_angle.decay(Setting(), power=power).outcome == "fail"


def test_the_number_needs_an_even_spread():
    assert branch_count.number(Setting()).outcome == "pass"
    found = branch_count.number(Setting(), spread="none")
    assert found.outcome == "fail"
    assert "tends to 0" in found.witness
