"""The bound of smooth isometries by an inscribed square, and the gap to branched ones."""

from fractions import Fraction
from math import atan, cos, hypot, pi
from typing import Any

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from checks.evidence import Setting
from checks.verify import energy_gap
from theory import inscribed_square, periodic_amsler
from theory.errors import DomainError

RADII = st.fractions(Fraction(1, 2), 6, max_denominator=20)


@given(radius=RADII)
def test_the_bound_solves_its_equation(radius: Fraction):
    energy = float(inscribed_square.least_energy(radius, digits=15).ball())
    assert energy >= 1
    assert energy * (pi - 4 * atan(1 / energy)) == pytest.approx(float(radius) ** 2, rel=1e-12)


@given(radius=RADII)
def test_the_bound_is_below_the_bobbin_and_above_the_bound_of_the_smaller_square(radius: Fraction):
    energy = inscribed_square.least_energy(radius, digits=15).ball()
    r = arb(radius.numerator) / radius.denominator
    assert energy < r.cosh()
    assert energy > r**2 / arb.pi() - 1


@given(part=st.floats(0.05, 1.5), u=st.floats(-1, 1), v=st.floats(-1, 1))
def test_straight_ways_within_the_square_stay_in_the_unit_disk(part: float, u: float, v: float):
    """Whatever the angle between delta and pi - delta is along the way."""
    a = float(inscribed_square.half_side(1, part))
    for angle in (part, (part + pi / 2) / 2, pi / 2, pi - part):
        x, y = u * a + v * a * cos(angle), v * a * (1 - cos(angle) ** 2) ** 0.5
        assert hypot(x, y) <= 1 + 1e-12


def test_refuses_a_radius_of_zero():
    with pytest.raises(DomainError):
        inscribed_square.least_energy(0)


def test_the_monkey_saddle_beats_every_smooth_isometry_of_radius_three_halves():
    smooth = inscribed_square.least_energy(Fraction(3, 2)).ball()
    assert periodic_amsler.max_curvature(Fraction(3, 2), 6).ball() < smooth


@pytest.mark.parametrize(
    "mutant", [{"share": "99/100"}, {"stretch": "101/100"}, {"sectors": 4}, {"sectors": 10}]
)
def test_the_check_rejects_its_mutants(mutant: dict[str, Any]):
    assert energy_gap.energy_gap(Setting()).outcome == "pass"
    assert energy_gap.energy_gap(Setting(), **mutant).outcome == "fail"


@pytest.mark.parametrize("mutant", [{"share": "43/50"}, {"radius": "3/2"}, {"sectors": 8}])
def test_a_tenth_below_is_so_on_one_disk_and_not_more(mutant: dict[str, Any]):
    assert energy_gap.substantially_below(Setting()).outcome == "pass"
    assert energy_gap.substantially_below(Setting(), **mutant).outcome == "fail"
