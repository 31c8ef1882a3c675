"""The notes and the README are built from the committed ledger, and the ledger is current."""

import json
from pathlib import Path

import jsonschema
import pytest

from checks.commands.notes import built
from checks.ledger import _citation_entry, _erratum_entry
from checks.pins import read_pins
from checks.registry import registry
from checks.report.notes import power_of_ten, with_example

ROOT = Path(__file__).resolve().parent.parent
LEDGER = json.loads((ROOT / "notes" / "ledger.json").read_text())


def test_the_committed_ledger_follows_the_schema():
    jsonschema.validate(LEDGER, json.loads((ROOT / "checks" / "ledger.schema.json").read_text()))


def test_the_committed_ledger_is_a_full_run_of_this_catalogue():
    whole, pins = registry(), read_pins()
    assert LEDGER["tier"] == "full"
    assert [entry["id"] for entry in LEDGER["claims"]] == [claim.id for claim in whole.claims]
    for entry, claim in zip(LEDGER["claims"], whole.claims, strict=True):
        assert entry["statement"] == claim.statement
        assert entry["erratum"] == _erratum_entry(claim, whole)
        assert entry["citation"] == _citation_entry(claim)
        found = {c["name"]: (c["outcome"], c["grade"]) for c in entry["checks"]}
        pinned = {n: (r.outcome, r.grade) for n, r in pins.get(claim.id, {}).items()}
        assert found == pinned, claim.id


@pytest.mark.parametrize("path", built(LEDGER), ids=lambda path: path.name)
def test_the_notes_are_current(path: Path):
    assert path.read_text(encoding="utf-8") == built(LEDGER)[path]


@pytest.mark.parametrize(
    ("residual", "rounded"),
    [("0", "0"), ("1e-30", "1e-30"), ("1.01e-30", "1e-29"), ("0.5", "1e0"), ("-3e-7", "1e-6")],
)
def test_residuals_are_rounded_up_to_powers_of_ten(residual: str, rounded: str):
    assert power_of_ten(residual) == rounded


def test_a_readme_without_its_markers_is_refused():
    with pytest.raises(ValueError, match="once each"):
        with_example("no markers", LEDGER)
