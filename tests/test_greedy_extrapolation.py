"""Extrapolated values of the greedy algorithm against the limit of edge length 0, not snapped."""

import math
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

from discrete.errors import ShapeError
from discrete.exact_angle import ExactAngle
from discrete.greedy_extrapolation import extrapolated, line_at_zero
from discrete.greedy_parameters import GreedyParameters
from theory.greedy_limit import limit_tree

STEPS = tuple(Fraction(1, n) for n in (50, 75, 100, 150, 200, 300, 400))
CASES = [(3, 4, "3/4"), (4, 4, "3/4"), (5, 4, "3/4"), (4, 8, "4/5"), (5, 8, "4/5")]


@cache
def values(radius: int, sectors: int, cutoff: str):
    run = GreedyParameters(
        radius=Fraction(radius),
        step=STEPS[0],
        sectors=sectors,
        cutoff=ExactAngle(half_turns=Fraction(cutoff)),
    )
    return extrapolated(run, STEPS)


@cache
def limit(radius: int, sectors: int, cutoff: str):
    return limit_tree(
        float(radius), 2 * math.pi / sectors, float(Fraction(cutoff)) * math.pi, nodes=40
    )


@pytest.mark.parametrize("case", CASES, ids=str)
def test_limit_lies_within_the_uncertainty(case):
    found, exact = values(*case), limit(*case)
    curvature = max(
        math.tan(float(Fraction(case[2])) * math.pi / 2), 1 / math.tan(exact.min_angle / 2)
    )
    for name, true in (("min_angle", exact.min_angle), ("max_curvature", curvature)):
        assert abs(found[name].value - true) <= found[name].uncertainty
        assert found[name].uncertainty < 0.02 * true


def test_places_of_cuts_lie_within_their_uncertainty():
    """The uncertainty is an estimate: of all cuts nearly all are within it, and none is far off."""
    ratios = []
    for case in CASES:
        found, true = values(*case), {f"rho {cut.path}": cut.rho for cut in limit(*case).cuts}
        names = [name for name in found if name in true]
        assert len(names) >= len(true) * 2 / 3
        ratios += [abs(found[n].value - true[n]) / found[n].uncertainty for n in names]
    assert len(ratios) > 30
    assert np.mean(np.array(ratios) <= 1) >= 0.9
    assert max(ratios) < 3


@pytest.mark.parametrize("case", CASES, ids=str)
def test_number_of_branch_points_is_that_of_the_limit(case):
    found, exact = values(*case), limit(*case)
    copies = [1 if set(cut.path) <= {"A"} else 2 for cut in exact.cuts]
    expected = case[1] * sum(copies) + (case[1] > 4)
    assert abs(found["branch_points"].value - expected) <= found["branch_points"].uncertainty


def test_errors_fall_with_the_first_order_in_the_mean():
    """Over all cuts of all runs: the error of each by itself jumps as the grid passes it."""
    errors = []
    for case in CASES:
        found, true = values(*case), {f"rho {cut.path}": cut.rho for cut in limit(*case).cuts}
        errors += [np.abs(np.array(found[n].values) - true[n]) for n in true if n in found]
    mean = np.mean(errors, axis=0)
    order = np.polyfit(np.log([float(step) for step in STEPS]), np.log(mean), 1)[0]
    assert order == pytest.approx(1, abs=0.1)


def test_a_line_is_met_exactly():
    steps = [Fraction(1, n) for n in (10, 20, 40)]
    found = line_at_zero(steps, [3 + 2 * float(step) for step in steps])
    assert found.value == pytest.approx(3)
    assert found.uncertainty == pytest.approx(2 / 40)


@pytest.mark.parametrize(
    ("steps", "numbers"),
    [((1, 2), (1.0, 2.0)), ((1, 2, 3), (1.0, 2.0, 3.0)), ((3, 2, 1), (1.0, 2.0))],
)
def test_bad_data_are_refused(steps, numbers):
    with pytest.raises(ShapeError, match="coarsest first"):
        line_at_zero([Fraction(step) for step in steps], numbers)
