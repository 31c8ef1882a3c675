"""From the outcomes of a claim's checks to its verdict and grade: nobody types a status."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

from checks.claim import Check, Claim
from checks.evidence import Grade, Outcome, stronger, weaker

Verdict = Literal["holds", "corrected", "fails", "undecided", "cited", "unchecked"]
VERDICTS: tuple[Verdict, ...] = ("holds", "corrected", "fails", "undecided", "cited", "unchecked")


@dataclass(frozen=True, kw_only=True)
class Result:
    """Outcome and grade of one check, all that a verdict needs to know of it."""

    outcome: Outcome
    grade: Grade | None = None


def _grade(checks: Iterable[Check], results: Mapping[str, Result], wanted: Outcome) -> Grade | None:
    """Weakest over the claim's parts of the strongest route to each part."""
    best: dict[str, Grade] = {}
    for check in checks:
        result = results[check.name]
        if result.outcome == wanted and result.grade is not None:
            known = best.get(check.part)
            best[check.part] = stronger(known, result.grade) if known else result.grade
    weakest: Grade | None = None
    for grade in best.values():
        weakest = weaker(weakest, grade) if weakest else grade
    return weakest


def _outcomes(checks: Iterable[Check], results: Mapping[str, Result]) -> set[Outcome]:
    return {results[check.name].outcome for check in checks}


def _refuted(
    failed: set[str],
    printed: list[Check],
    corrected: list[Check],
    results: Mapping[str, Result],
) -> tuple[Verdict, Grade | None]:
    """Verdict where some parts of the printed form failed: all of them must be mended to count."""
    mended = {check.part for check in corrected}
    if not failed <= mended or "fail" in _outcomes(corrected, results):
        return "fails", _grade(printed, results, "fail")
    standing = [*corrected, *(check for check in printed if check.part not in failed)]
    if _outcomes(standing, results) == {"pass"}:
        return "corrected", _grade(standing, results, "pass")
    return "undecided", None


def verdict(claim: Claim, results: Mapping[str, Result]) -> tuple[Verdict, Grade | None]:
    """Verdict and grade of a claim, from the result of each of its checks by name.

    A refutation stands whatever else is open; a check that erred, was undecided or did not run
    leaves the claim undecided, and so does a citation whose support did not pass.
    """
    deciding = [check for check in claim.checks if check.form != "support"]
    printed = [check for check in deciding if check.form == "printed"]
    corrected = [check for check in deciding if check.form == "corrected"]
    if not deciding:
        if claim.citation is None:
            return "unchecked", None
        sound = _outcomes(claim.checks, results) <= {"pass"}
        return ("cited", None) if sound else ("undecided", None)
    failed = {check.part for check in printed if results[check.name].outcome == "fail"}
    if failed:
        return _refuted(failed, printed, corrected, results)
    if printed and _outcomes(printed, results) == {"pass"}:
        return "holds", _grade(printed, results, "pass")
    return "undecided", None
