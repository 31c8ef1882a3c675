"""The verdict follows from the outcomes, for every combination of them."""

from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st
from planted import check

from checks.claim import Citation, Claim
from checks.evidence import GRADES, stronger, weaker
from checks.verdict import Result, verdict

OUTCOMES = ("pass", "fail", "undecided", "error", "not_run")


def claim(*forms: str, parts: tuple[str, ...] = (), cited: bool = False) -> Claim:
    parts = parts or ("",) * len(forms)
    checks = tuple(
        check(f"c{n}", form=form, part=part)
        for n, (form, part) in enumerate(zip(forms, parts, strict=True))
    )
    citation = Citation(source="Euclid", reason="analysis") if cited else None
    return Claim(
        id="x", section="1", where="w", kind="sentence", statement="s", checks=checks,
        citation=citation,
    )  # fmt: skip


def results(*outcomes: str, grades: tuple[str, ...] = ()) -> dict[str, Result]:
    grades = grades or ("exact",) * len(outcomes)
    return {
        f"c{n}": Result(outcome=outcome, grade=grade)
        for n, (outcome, grade) in enumerate(zip(outcomes, grades, strict=True))
    }


def test_no_check_is_unchecked():
    assert verdict(claim(), {}) == ("unchecked", None)


@pytest.mark.parametrize("outcomes", list(product(OUTCOMES, repeat=2)))
def test_printed_alone(outcomes: tuple[str, str]):
    found, _ = verdict(claim("printed", "printed"), results(*outcomes))
    if "fail" in outcomes:
        assert found == "fails"
    elif set(outcomes) == {"pass"}:
        assert found == "holds"
    else:
        assert found == "undecided"


@pytest.mark.parametrize("outcomes", list(product(OUTCOMES, repeat=2)))
def test_printed_and_corrected(outcomes: tuple[str, str]):
    found, _ = verdict(claim("printed", "corrected"), results(*outcomes))
    printed, corrected = outcomes
    if printed == "fail":
        expected = {"pass": "corrected", "fail": "fails"}.get(corrected, "undecided")
    else:
        expected = "holds" if printed == "pass" else "undecided"
    assert found == expected


@pytest.mark.parametrize("outcome", OUTCOMES)
def test_support_decides_nothing_but_can_spoil_a_citation(outcome: str):
    assert verdict(claim("support"), results(outcome))[0] == "unchecked"
    cited = verdict(claim("support", cited=True), results(outcome))[0]
    assert cited == ("cited" if outcome == "pass" else "undecided")


def test_undecided_is_never_a_pass():
    for outcome in ("undecided", "error", "not_run"):
        assert verdict(claim("printed"), results(outcome))[0] == "undecided"


def test_two_routes_to_one_part_give_the_stronger_grade():
    found = verdict(
        claim("printed", "printed"), results("pass", "pass", grades=("numeric", "exact"))
    )
    assert found == ("holds", "exact")


def test_two_parts_give_the_weaker_grade():
    both = claim("printed", "printed", parts=("u", "v"))
    assert verdict(both, results("pass", "pass", grades=("numeric", "exact"))) == (
        "holds",
        "numeric",
    )


@given(st.sampled_from(GRADES), st.sampled_from(GRADES))
def test_grades_are_ordered(first: str, second: str):
    assert {weaker(first, second), stronger(first, second)} == {first, second}
    assert weaker(first, second) == weaker(second, first)
    assert weaker("exact", first) == first


@pytest.mark.parametrize(
    ("outcomes", "expected"),
    [
        (("fail", "pass", "pass"), "corrected"),
        (("fail", "pass", "error"), "undecided"),
        (("fail", "fail", "pass"), "fails"),
        (("fail", "pass", "not_run"), "undecided"),
    ],
)
def test_a_part_that_is_not_mended_keeps_a_claim_from_being_corrected(outcomes, expected):
    two_parts = claim("printed", "corrected", "printed", parts=("u", "u", "v"))
    assert verdict(two_parts, results(*outcomes))[0] == expected


def test_a_correction_of_another_part_mends_nothing():
    crossed = claim("printed", "corrected", parts=("u", "v"))
    assert verdict(crossed, results("fail", "pass"))[0] == "fails"


def test_the_grade_of_a_corrected_claim_counts_the_parts_that_stood():
    two_parts = claim("printed", "corrected", "printed", parts=("u", "u", "v"))
    found = verdict(
        two_parts, results("fail", "pass", "pass", grades=("exact", "exact", "numeric"))
    )
    assert found == ("corrected", "numeric")
