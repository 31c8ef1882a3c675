"""Radii at which generations of branch points appear, and the laws held against them."""

from fractions import Fraction

import numpy as np
import pytest

from checks.evidence import Setting
from checks.verify import cut_depth


def test_a_generation_is_there_above_its_radius_and_not_below():
    for generation, radius in enumerate(cut_depth.first_radii("8", "4/5")[:4], start=1):
        width = cut_depth.FINE / 2
        around = Fraction(radius).limit_denominator(64)
        assert cut_depth.depth(around - width, "8", "4/5") == generation - 1
        assert cut_depth.depth(around + width, "8", "4/5") >= generation


def test_the_radii_increase():
    assert (np.diff(cut_depth.first_radii("8", "4/5")) > 0).all()


@pytest.fixture
def straight(monkeypatch: pytest.MonkeyPatch):
    """Generations that appear on a line, each three quarters of a unit after the last."""
    radii = tuple(3 + 0.75 * k for k in range(10))
    monkeypatch.setattr(cut_depth, "first_radii", lambda sectors, cutoff: radii)
    monkeypatch.setattr(cut_depth, "_limit_agrees", list)


@pytest.mark.usefixtures("straight")
def test_a_line_follows_the_line_and_has_no_growing_slope():
    assert cut_depth.law(Setting()).outcome == "pass"
    assert cut_depth.law(Setting(), power="3").outcome == "fail"
    assert cut_depth.slope_grows(Setting(), bend="1/20").outcome == "fail"
    assert cut_depth.slope_grows(Setting(), bend="-1/20").outcome == "pass"


@pytest.mark.usefixtures("straight")
def test_a_depth_that_falls_with_the_radius_is_refused(monkeypatch: pytest.MonkeyPatch):
    falling = tuple(9 - 0.5 * k for k in range(10))
    monkeypatch.setattr(cut_depth, "first_radii", lambda sectors, cutoff: falling)
    assert cut_depth.law(Setting()).outcome == "fail"
