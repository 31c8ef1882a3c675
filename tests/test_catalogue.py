"""The catalogue of the whole paper: complete, consistent, and every check within reach."""

import inspect
import json
from importlib import import_module
from pathlib import Path

import pytest

from checks.claim import Check, Claim
from checks.pins import expected, read_pins
from checks.registry import registry

ROOT = Path(__file__).resolve().parent.parent
LABELS = json.loads((ROOT / "tests" / "data" / "labels.json").read_text())["labels"]
WHOLE = registry()
PINS = read_pins()
CHECKS = [(claim, check) for claim in WHOLE.claims for check in claim.checks]
DECIDED_NOW = ("abstract", "1", "2", "3", "3.1")


def name(value: object) -> str:
    return getattr(value, "id", None) or getattr(value, "name", "")


def function(check: Check):
    module, attribute = check.run.split(":")
    return getattr(import_module(module), attribute)


def test_every_label_of_the_paper_is_a_claim_or_belongs_to_one_or_is_waived():
    assert len(LABELS) == 178
    claimed = {label for claim in WHOLE.claims for label in claim.labels}
    claimed |= {claim.id for claim in WHOLE.claims} & LABELS.keys()
    waived = {waiver.label for waiver in WHOLE.waived}
    assert claimed | waived == set(LABELS)
    assert not claimed & waived


def test_a_claim_named_by_a_label_covers_it():
    assert not [c.id for c in WHOLE.claims if c.id in LABELS and c.id not in c.labels]


def test_there_are_well_over_250_claims():
    assert len(WHOLE.claims) > 250


@pytest.mark.parametrize("claim", [c for c in WHOLE.claims if c.section in DECIDED_NOW], ids=name)
def test_the_first_sections_are_decided(claim: Claim):
    waits = bool(claim.waits_for)
    assert waits or claim.checks or claim.citation, "no check, citation or reason to wait"
    assert not (waits and claim.citation), "a claim that waits is not yet cited"


def test_only_later_sections_are_waited_for():
    for claim in WHOLE.claims:
        assert not set(claim.waits_for) & set(DECIDED_NOW), claim.id


def test_at_least_40_claims_are_exact():
    assert sum(expected(c, PINS) == ("holds", "exact") for c in WHOLE.claims) >= 40


def test_at_most_40_claims_are_cited():
    assert sum(claim.citation is not None for claim in WHOLE.claims) <= 40


@pytest.mark.parametrize("claim", [c for c in WHOLE.claims if c.checks], ids=name)
def test_an_erratum_stands_exactly_where_the_printed_form_is_expected_to_fail(claim: Claim):
    wanted = expected(claim, PINS)
    assert wanted is not None, "not pinned"
    assert (claim.erratum is not None) == (wanted[0] in ("corrected", "fails"))


@pytest.mark.parametrize(("claim", "check"), CHECKS, ids=name)
def test_the_check_can_be_called_as_it_will_be(claim: Claim, check: Check):
    parameters = inspect.signature(function(check)).parameters
    known = {n for n, p in parameters.items() if p.kind is inspect.Parameter.KEYWORD_ONLY}
    assert set(check.given) <= known
    for mutant in check.mutants:
        assert set(mutant.given) <= known, mutant.name
        defaults = {n: parameters[n].default for n in known}
        changed = {**defaults, **check.given, **mutant.given} != {**defaults, **check.given}
        assert changed, f"mutant {mutant.name} is the claim itself"


@pytest.mark.parametrize("claim", [c for c in WHOLE.claims if c.erratum], ids=name)
def test_a_failing_form_shares_its_function_with_one_that_passes(claim: Claim):
    pinned = PINS[claim.id]
    failing = {c.run for c in claim.checks if pinned[c.name].outcome == "fail"}
    passing = {c.run for c in claim.checks if pinned[c.name].outcome == "pass"}
    assert failing <= passing, "a check that always fails shows as little as one that always passes"


@pytest.mark.parametrize(("claim", "check"), CHECKS, ids=name)
def test_routes_within_the_house_exist(claim: Claim, check: Check):
    for route in check.routes:
        if route.startswith(("theory.", "discrete.", "checks.")):
            module, _, attribute = route.partition(":")
            assert not attribute or hasattr(import_module(module), attribute), route
