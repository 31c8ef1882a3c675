"""The lemma on the cut by the bounds, and the rate of the quotient: what breaks them."""

import pytest

from checks.evidence import Evidence, Setting
from checks.verify import amsler_lemma_range, recursion_smallest_angle
from theory import bessel_growth

FAST = (
    amsler_lemma_range.angle_on_cut,
    amsler_lemma_range.cut_before_threshold,
    amsler_lemma_range.lower_bound_at_corner,
    amsler_lemma_range.first_inequality,
)


@pytest.mark.parametrize("check", FAST)
def test_the_implications_are_exact(check):
    found = check(Setting())
    assert (found.outcome, found.grade) == ("pass", "exact")


@pytest.mark.parametrize("share", ["1001/1000", "2"])
def test_a_corner_outside_of_the_rectangle_is_refuted(share):
    assert amsler_lemma_range.lower_bound_at_corner(Setting(), share=share).outcome == "fail"


def test_a_false_implication_does_not_wait_for_the_certificate(monkeypatch):
    def never(*_args: object, **_given: object) -> Evidence:
        raise AssertionError("the certificate was read")

    monkeypatch.setattr(amsler_lemma_range, "certificate", never)
    assert amsler_lemma_range.whole_range(Setting(), share="2").outcome == "fail"


@pytest.mark.parametrize("outcome", ["pass", "undecided"])
def test_the_whole_range_is_as_good_as_the_certificate(monkeypatch, outcome):
    stored = Evidence(outcome=outcome, grade="certified", shown="bounds")
    monkeypatch.setattr(amsler_lemma_range, "certificate", lambda *_args, **_given: stored)
    found = amsler_lemma_range.whole_range(Setting())
    assert (found.outcome, found.grade) == (outcome, "certified")


def test_a_wrong_factor_in_the_surplus_is_refuted(monkeypatch):
    def wrong(quotient, s, *, over=bessel_growth.ratio):
        return quotient * over(s * quotient / 2) - 2 * s * over(s * s / 4)

    assert recursion_smallest_angle.smallest_angle(Setting()).outcome == "pass"
    monkeypatch.setattr(bessel_growth, "surplus", wrong)
    assert recursion_smallest_angle.smallest_angle(Setting()).outcome == "fail"
