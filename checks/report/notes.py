"""The notes that are built from a ledger: ledger.md, errata.md and the README's example."""

from collections.abc import Mapping, Sequence
from decimal import Decimal
from itertools import groupby
from typing import Any

from checks.report.table import TITLES, by_section, summary

BEGIN = "<!-- begin: built by `kminusone notes` -->"
END = "<!-- end: built by `kminusone notes` -->"
_HEADER = "<!-- Built by `kminusone notes` from notes/ledger.json: do not edit. -->\n"


def power_of_ten(residual: str) -> str:
    """Residual rounded up to a power of ten, so that another processor gives the same text."""
    value = Decimal(residual)
    if value == 0:
        return "0"
    exponent = value.adjusted()
    return f"1e{exponent if abs(value) == Decimal(1).scaleb(exponent) else exponent + 1}"


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", r"\|")


def _evidence(check: Mapping[str, Any]) -> str:
    parts = [f"{check['outcome']}"]
    if check["grade"]:
        parts.append(check["grade"])
    if check.get("residual"):
        parts.append(f"residual {power_of_ten(check['residual'])}")
    if check["digits"]:
        parts.append(f"{check['digits']} digits")
    samples = check["samples"]
    if samples["tried"] > 1:
        parts.append(f"{samples['met']}/{samples['tried']} samples")
    rejected = sum(mutant["rejected"] for mutant in check["mutants"])
    parts.append(f"{rejected}/{len(check['mutants'])} mutants rejected")
    return f"{check['form']} `{check['name']}`: {', '.join(parts)}"


def _row(claim: Mapping[str, Any]) -> str:
    verdict = claim["verdict"] + (f", {claim['grade']}" if claim["grade"] else "")
    checks = "; ".join(_evidence(check) for check in claim["checks"])
    if claim["citation"]:
        checks = f"{claim['citation']['source']}. {checks}".strip()
    if claim["waits_for"]:
        checks = f"waits for section {', '.join(claim['waits_for'])}. {checks}".strip()
    weak = ", ".join(f"`{id_}`" for id_ in claim["weakened_by"])
    cells = (f"`{claim['id']}`", claim["kind"], claim["statement"], verdict, checks, weak)
    return "| " + " | ".join(_cell(cell) for cell in cells) + " |"


def _fenced(lines: Sequence[str]) -> list[str]:
    return ["```text", *lines, "```"]


def ledger_markdown(ledger: Mapping[str, Any]) -> str:
    """Text of notes/ledger.md: verdicts by section, then every claim with its evidence."""
    lines = [_HEADER, "# The ledger", "", f"{summary(ledger['counts'])}.", ""]
    lines += [*_fenced(by_section(ledger["claims"])), ""]
    for section, group in groupby(ledger["claims"], key=lambda claim: claim["section"]):
        lines += [f"## {TITLES.get(section, section)}", ""]
        lines += ["| claim | kind | statement | verdict | evidence | weakened by |"]
        lines += ["| --- | --- | --- | --- | --- | --- |"]
        lines += [*(_row(claim) for claim in group), ""]
    lines += ["## Labels that state nothing", "", "| label | reason |", "| --- | --- |"]
    lines += [f"| `{waiver['label']}` | {_cell(waiver['reason'])} |" for waiver in ledger["waived"]]
    return "\n".join(lines) + "\n"


def _erratum(claim: Mapping[str, Any]) -> list[str]:
    erratum = claim["erratum"]
    affects = ", ".join(f"`{id_}`" for id_ in erratum["affects"]) or "no other claim"
    survives = "yes" if erratum["conclusion_survives"] else "no"
    found = [c["witness"] for c in claim["checks"] if c["form"] == "printed" and c.get("witness")]
    lines = [
        f"## `{claim['id']}` ({erratum['class']})",
        "",
        f"- where: section {claim['section']}, {claim['where']}",
        f"- verdict: {claim['verdict']}, {claim['grade'] or 'no grade'}",
        f"- printed: {erratum['printed']}",
        f"- corrected: {erratum['corrected']}",
        f"- witness: {erratum['witness']}",
        f"- found by the computer: {'; '.join(found) or 'nothing'}",
        f"- rests on it: {affects}",
        f"- conclusion survives: {survives}",
    ]
    return [*lines, *([f"- remark: {erratum['remark']}"] if erratum["remark"] else []), ""]


def errata_markdown(ledger: Mapping[str, Any]) -> str:
    """Text of notes/errata.md: every erratum with its witness, in the paper's order."""
    claims = [claim for claim in ledger["claims"] if claim["erratum"]]
    kinds = sorted({claim["erratum"]["class"] for claim in claims})
    number = {kind: sum(c["erratum"]["class"] == kind for c in claims) for kind in kinds}
    told = ", ".join(f"{number[kind]} {kind}" for kind in kinds) or "none"
    lines = [_HEADER, "# Errata", "", f"{len(claims)} errata: {told}.", ""]
    for claim in claims:
        lines += _erratum(claim)
    return "\n".join(lines)


def readme_example(ledger: Mapping[str, Any]) -> str:
    """Return the end of a good run, between the markers that the README keeps for it."""
    text = [*by_section(ledger["claims"]), "", f"{summary(ledger['counts'])}: as pinned"]
    return "\n".join([BEGIN, "", *_fenced(text), "", END])


def with_example(readme: str, ledger: Mapping[str, Any]) -> str:
    """Return the README with its example rebuilt; raises ValueError where a marker is missing."""
    if readme.count(BEGIN) != 1 or readme.count(END) != 1:
        raise ValueError(f"the README must hold {BEGIN} and {END} once each")
    before, rest = readme.split(BEGIN)
    return before + readme_example(ledger) + rest.split(END)[1]
