"""Nets with distributed branch points and with one, and what is measured on them."""

import numpy as np
import pytest

from checks.evidence import Setting
from checks.verify import comparison_nets as nets


def test_curvatures_are_one_at_a_right_angle_and_reciprocal():
    angles = np.array([np.pi / 2, np.pi / 3, 2 * np.pi / 3])
    larger, smaller = nets.curvatures(angles), nets.curvatures(angles, smaller=True)
    assert larger == pytest.approx([1, np.sqrt(3), np.sqrt(3)])
    assert larger * smaller == pytest.approx(np.ones(3))


def test_a_star_of_eight_sectors_has_one_branch_point_of_that_degree():
    found = nets.disk("2", "8", nets.NO_CUT)
    assert found.branched == ((0.0, 8),)
    assert found.closed
    assert found.angle_gap < nets.ROUNDING
    assert found.largest == pytest.approx(1 / np.tan(np.pi / 8), rel=1e-3)


def test_a_run_without_cuts_has_a_star_s_net_and_one_with_cuts_daughters_of_degree_six():
    assert nets.disk("2", "8", "4/5").branched == nets.disk("2", "8", nets.NO_CUT).branched
    cut = nets.disk("2", "4", "3/4")
    assert [degree for _, degree in cut.branched] == [6] * 4


def test_the_crochet_needs_branch_points_and_the_right_edges(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(nets, "SETS", (("4", "3/4"),))
    assert nets.crochet(Setting(), radius="2").outcome == "pass"
    assert nets.crochet(Setting(), radius="2", percent=101).outcome == "fail"
    assert nets.crochet(Setting(), radius="1").outcome == "fail"


def test_the_figure_refuses_other_colours(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(nets, "RADII", ("2",))
    assert nets.figure(Setting()).outcome == "pass"
    for mutant in ({"percent": 103}, {"smaller": True}, {"sectors": "4"}, {"distributed": "8"}):
        assert nets.figure(Setting(), **mutant).outcome == "fail"
