"""The ledger: what a run found of each claim, as plain data that is the same byte for byte."""

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from checks.claim import Claim, Waiver
from checks.job import Report, as_plain
from checks.pins import Pins, expected
from checks.registry import Registry
from checks.runner import Key
from checks.verdict import VERDICTS, Result, Verdict, verdict

SCHEMA = "kminusone/ledger/1"
NOT_RUN = Report(outcome="not_run")


def results_of(claim: Claim, reports: Mapping[Key, Report]) -> dict[str, Result]:
    """Outcome and grade of each check of the claim, `not_run` for those without a report."""
    found = {}
    for check in claim.checks:
        report = reports.get((claim.id, check.name), NOT_RUN)
        found[check.name] = Result(outcome=report.outcome, grade=report.grade)
    return found


def believed(claim: Claim, reports: Mapping[Key, Report]) -> dict[str, Result]:
    """Results from which the verdict is drawn: a broken check decides nothing, whatever it says."""
    return {
        name: Result(outcome="undecided")
        if reports.get((claim.id, name), NOT_RUN).broken
        else result
        for name, result in results_of(claim, reports).items()
    }


def ran(claims: Sequence[Claim], reports: Mapping[Key, Report]) -> dict[str, dict[str, Result]]:
    """Results of the checks that ran, by claim and check."""
    return {
        claim.id: {n: r for n, r in results_of(claim, reports).items() if r.outcome != "not_run"}
        for claim in claims
    }


def is_weak(claim: Claim, known: Verdict | None) -> bool:
    """Whether what rests on the claim is weakened by it."""
    if known in ("holds", "cited"):
        return False
    survives = claim.erratum is not None and claim.erratum.conclusion_survives
    return not (known == "corrected" and survives)


def _check_entry(claim: Claim, number: int, report: Report, seed: int) -> dict[str, Any]:
    check = claim.checks[number]
    entry: dict[str, Any] = {
        "name": check.name,
        "form": check.form,
        "part": check.part,
        "outcome": report.outcome,
        "grade": report.grade,
        "tier": check.tier,
        "routes": list(check.routes),
        **as_plain(report.evidence),
        "seed": seed,
        "mutants": [
            {"name": m.name, "near": m.near, "outcome": m.outcome, "rejected": m.rejected}
            for m in report.mutants
        ],
    }
    if report.error:
        entry["error"] = report.error
    if report.broken:
        entry["broken"] = report.broken
    return entry


def _erratum_entry(claim: Claim, registry: Registry) -> dict[str, Any] | None:
    if claim.erratum is None:
        return None
    return {
        "printed": claim.erratum.printed,
        "corrected": claim.erratum.corrected,
        "class": claim.erratum.kind,
        "witness": claim.erratum.witness,
        "affects": list(registry.descendants[claim.id]),
        "conclusion_survives": claim.erratum.conclusion_survives,
        "remark": claim.erratum.remark,
    }


def _citation_entry(claim: Claim) -> dict[str, Any] | None:
    if claim.citation is None:
        return None
    return {
        "source": claim.citation.source,
        "reason": claim.citation.reason,
        "search": claim.citation.search,
    }


def _claim_entry(
    claim: Claim, registry: Registry, reports: Mapping[Key, Report], pins: Pins, seed: int
) -> dict[str, Any]:
    found, grade = verdict(claim, believed(claim, reports))
    wanted = expected(claim, pins)
    return {
        "id": claim.id,
        "section": claim.section,
        "where": claim.where,
        "kind": claim.kind,
        "labels": list(claim.labels),
        "statement": claim.statement,
        "hypotheses": list(claim.hypotheses),
        "verdict": found,
        "grade": grade,
        "expected": wanted[0] if wanted else None,
        "rests_on": list(claim.rests_on),
        "weakened_by": [],
        "waits_for": list(claim.waits_for),
        "erratum": _erratum_entry(claim, registry),
        "citation": _citation_entry(claim),
        "checks": [
            _check_entry(claim, n, reports.get((claim.id, check.name), NOT_RUN), seed)
            for n, check in enumerate(claim.checks)
        ],
    }


def _weaken(entries: Sequence[dict[str, Any]], registry: Registry, pins: Pins) -> None:
    """Fill in weakened_by: verdicts of this run where all checks ran, else the pinned ones."""
    found: dict[str, Verdict] = {
        entry["id"]: entry["verdict"]
        for entry in entries
        if all(check["outcome"] != "not_run" for check in entry["checks"])
    }
    for claim in registry.claims:
        if claim.id not in found and (wanted := expected(claim, pins)):
            found[claim.id] = wanted[0]
    weak = {claim.id for claim in registry.claims if is_weak(claim, found.get(claim.id))}
    for entry in entries:
        ancestors = registry.ancestors[entry["id"]]
        entry["weakened_by"] = [ancestor for ancestor in ancestors if ancestor in weak]


def counts(entries: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """How many claims have each verdict and grade, and how many checks each outcome."""
    verdicts = Counter(entry["verdict"] for entry in entries)
    grades = Counter(entry["grade"] for entry in entries if entry["grade"])
    checks = [check for entry in entries for check in entry["checks"]]
    outcomes = Counter(check["outcome"] for check in checks)
    return {
        "claims": len(entries),
        "verdicts": {name: verdicts[name] for name in VERDICTS},
        "grades": dict(sorted(grades.items())),
        "errata": sum(entry["erratum"] is not None for entry in entries),
        "checks": len(checks),
        "outcomes": dict(sorted(outcomes.items())),
        "mutants": sum(len(check["mutants"]) for check in checks),
        "broken": sum("broken" in check for check in checks),
    }


def build(
    claims: Sequence[Claim],
    registry: Registry,
    reports: Mapping[Key, Report],
    pins: Pins,
    *,
    seed: int,
    digits: int,
    tier: str,
    times: Mapping[str, Any],
) -> dict[str, Any]:
    """Ledger of a run over the claims; everything that may differ between runs is in times."""
    entries = [_claim_entry(claim, registry, reports, pins, seed) for claim in claims]
    _weaken(entries, registry, pins)
    return {
        "schema": SCHEMA,
        "seed": seed,
        "digits": digits,
        "tier": tier,
        "claims": entries,
        "waived": [_waiver_entry(waiver) for waiver in registry.waived],
        "counts": counts(entries),
        "times": dict(times),
    }


def _waiver_entry(waiver: Waiver) -> dict[str, str]:
    return {"label": waiver.label, "reason": waiver.reason}
