"""Smoothing the jumps of phi across the edges of a periodic Amsler surface."""

import numpy as np
import pytest

from checks.evidence import Setting
from checks.verify import smoothed_edges as edges


def test_the_blend_is_a_smooth_step():
    s = np.linspace(-2, 2, 41)
    share = edges.blend(s, 1.0)
    assert share + share[::-1] == pytest.approx(np.ones(41))
    assert set(share[s <= -1]) == {0.0}
    assert set(share[s >= 1]) == {1.0}
    assert (np.diff(share) >= 0).all()


def test_without_smoothing_the_pieces_are_the_surface():
    strip, quadrant, exact_strip, exact_quadrant = edges.pieces(0)
    assert np.abs(strip - exact_strip).max() < edges.STEP
    within = exact_quadrant <= edges.LARGEST
    assert np.abs(quadrant - exact_quadrant)[within].max() < edges.STEP


def test_smoothed_pieces_are_exact_before_the_edge_and_have_no_jump():
    strip, _, exact, _ = edges.pieces(64)
    before = edges.CELLS - 65
    assert np.abs(strip[:before] - exact[:before]).max() < 1e-6
    jump = np.pi - 2 * edges.OPENING
    assert np.abs(np.diff(exact, axis=0)).max() > 0.9 * jump
    assert np.abs(np.diff(strip, axis=0)).max() < jump / 30


@pytest.mark.parametrize("mutant", [{"power": 2}, {"order": 2}, {"percent": 99}])
def test_the_check_rejects_its_mutants(mutant: dict[str, int]):
    assert edges.smoothing(Setting()).outcome == "pass"
    assert edges.smoothing(Setting(), **mutant).outcome == "fail"
