"""Curves of the energy figure: rivals, stars without cuts, bending energy of bobbins."""

from fractions import Fraction
from math import cosh, inf, pi, tan

import pytest

from checks.evidence import Setting
from checks.verify import energy_figure, greedy_growth


def test_the_best_bobbin_has_cosh_of_the_radius():
    assert energy_figure.rival_energy("bobbin", Fraction(5, 2)) == pytest.approx(cosh(2.5))


def test_a_star_has_its_opening_at_the_centre_or_reaches_its_edge():
    assert energy_figure.star_energy(Fraction(3, 2), "6") == pytest.approx(1 / tan(pi / 6))
    assert energy_figure.star_energy(Fraction(3), "4") == inf


def test_the_energy_of_a_run_without_cuts_is_that_of_its_star():
    run = energy_figure.finest("12", "4/5")[Fraction(2)]
    assert run["generations"] == 0
    assert energy_figure.run_energy(run) == pytest.approx(1 / tan(pi / 12), rel=1e-6)


@pytest.mark.parametrize("radius", [Fraction(1), Fraction(2)])
def test_bending_of_bobbins_is_at_least_twice_the_area_and_at_most_that_at_cosh(radius: Fraction):
    r = float(radius)
    found = energy_figure.least_bobbin_bending(radius)
    area = 2 * pi * (cosh(r) - 1)
    assert 2 * area < found < area * (cosh(r) ** 2 + cosh(r) ** -2)


@pytest.mark.parametrize(
    ("check", "mutant"),
    [
        ("below", {"lowest": "5/2"}),
        ("below", {"factor": "5/4"}),
        ("below_amsler", {"lowest": "4"}),
        ("below_amsler", {"factor": "2"}),
        ("cuts_help", {"lowest": "5/2"}),
        ("frilly_bends_less", {"lowest": "2"}),
        ("frilly_bends_less", {"factor": "3/2"}),
    ],
)
def test_the_checks_reject_their_mutants(check: str, mutant: dict[str, str]):
    function = getattr(energy_figure, check)
    assert function(Setting()).outcome == "pass"
    assert function(Setting(), **mutant).outcome == "fail"


def test_the_runs_grow_by_less_than_exponentially_and_not_by_less_than_a_root():
    assert greedy_growth.sub_exponential(Setting()).outcome == "pass"
    assert greedy_growth.sub_exponential(Setting(), rival="1/2").outcome == "fail"
