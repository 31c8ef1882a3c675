"""The ledger as text for a terminal: a table by section, what stands out, a summary line."""

from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

from checks.verdict import VERDICTS

TITLES = {
    "abstract": "Abstract",
    "1": "1 Introduction",
    "2": "2 Non-Euclidean elasticity",
    "3": "3 Pseudospherical surfaces with branch points",
    "3.1": "3.1 Pseudospherical surfaces",
    "3.2": "3.2 Assembly",
    "3.3": "3.3 The topology of the normal map",
    "3.4": "3.4 Surgery",
    "3.5": "3.5 The sine-Gordon equation with branch points",
    "4": "4 Discrete K-surfaces",
    "4.1": "4.1 Nets in the Poincare disk",
    "5": "5 Curvature energy",
    "5.1": "5.1 Recursion",
    "6": "6 Discussion",
    "A": "A Asymptotics of Painleve III",
}


def _claim_line(claim: Mapping[str, Any], width: int) -> str:
    passed = sum(check["outcome"] != "not_run" for check in claim["checks"])
    mutants = sum(len(check["mutants"]) for check in claim["checks"])
    parts = [f"  {claim['id']:<{width}}", f"{claim['verdict']:<9}", f"{claim['grade'] or '-':<10}"]
    if passed:
        parts.append(f"{passed} {_plural('check', passed)}, {mutants} {_plural('mutant', mutants)}")
    if waiting := len(claim["checks"]) - passed:
        expected = f", expected {claim['expected']}" if claim["expected"] else ""
        parts.append(f"({waiting} more in the full tier{expected})")
    if claim["weakened_by"]:
        parts.append(f"; weakened by {_first(claim['weakened_by'])}")
    return " ".join(parts).rstrip()


def _plural(word: str, number: int) -> str:
    return word if number == 1 else f"{word}s"


def _first(ids: Sequence[str], shown: int = 3) -> str:
    rest = len(ids) - shown
    return ", ".join(ids[:shown]) + (f" and {rest} more" if rest > 0 else "")


def _section(section: str, claims: Sequence[Mapping[str, Any]]) -> list[str]:
    lines = [TITLES.get(section, section)]
    decided = [claim for claim in claims if claim["verdict"] != "unchecked"]
    width = max((len(claim["id"]) for claim in decided), default=0)
    lines += [_claim_line(claim, width) for claim in decided]
    if without := len(claims) - len(decided):
        lines.append(f"  {without} {_plural('claim', without)} unchecked")
    return [*lines, ""]


def _cell(number: int, width: int) -> str:
    return f"{number or '.':>{width}}"


def by_section(claims: Sequence[Mapping[str, Any]]) -> list[str]:
    """Lines of the table of verdicts by section, with totals."""
    grouped = [(key, list(group)) for key, group in groupby(claims, key=lambda c: c["section"])]
    rows = [(TITLES.get(section, section), group) for section, group in grouped]
    rows.append(("all", list(claims)))
    width = max(len(title) for title, _ in rows)
    lines = [f"{'':<{width}} " + " ".join(f"{verdict:>9}" for verdict in VERDICTS)]
    for title, group in rows:
        found = [claim["verdict"] for claim in group]
        cells = (_cell(found.count(verdict), 9) for verdict in VERDICTS)
        lines.append(f"{title:<{width}} " + " ".join(cells))
    return lines


def summary(counts: Mapping[str, Any]) -> str:
    """Return the last line of a report: how many claims, verdicts, checks and mutants."""
    verdicts = ", ".join(f"{n} {name}" for name, n in counts["verdicts"].items() if n)
    outcomes = counts["outcomes"]
    ran = counts["checks"] - outcomes.get("not_run", 0)
    return (
        f"{counts['claims']} claims: {verdicts}; {ran} of {counts['checks']} checks ran, "
        f"{counts['mutants']} mutants, {counts['broken']} broken"
    )


def table(ledger: Mapping[str, Any], problems: Sequence[str]) -> str:
    """Text of the ledger: each section's claims, the table by section, problems, a summary line."""
    lines: list[str] = []
    for section, group in groupby(ledger["claims"], key=lambda claim: claim["section"]):
        lines += _section(section, list(group))
    lines += by_section(ledger["claims"])
    if problems:
        lines += ["", f"{len(problems)} {_plural('problem', len(problems))}:"]
        lines += [f"  {problem}" for problem in problems]
    ending = "as pinned" if not problems else "NOT as pinned"
    seconds = ledger["times"].get("seconds")
    lines += [
        "",
        f"{summary(ledger['counts'])}: {ending}" + (f" ({seconds:.0f} s)" if seconds else ""),
    ]
    return "\n".join(lines) + "\n"
