"""A claim as text: statement, hypotheses, graph, checks with mutants and evidence, erratum."""

import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

from checks.claim import Check, Claim
from checks.registry import Registry

WIDTH = 100


def _block(title: str, lines: Sequence[str]) -> list[str]:
    if not lines:
        return []
    wrapped = [
        textwrap.fill(line, WIDTH, initial_indent="  ", subsequent_indent="    ",
                      break_long_words=False, break_on_hyphens=False)
        for line in lines
    ]  # fmt: skip
    return [f"{title}:", *wrapped, ""]


def _found(entry: Mapping[str, Any]) -> str:
    """Evidence of one check in a line."""
    parts = [f"{entry['outcome']}", f"grade {entry['grade'] or '-'}"]
    parts += [
        f"{key} {entry[key]}" for key in ("residual", "enclosure", "digits") if entry.get(key)
    ]
    samples = entry["samples"]
    parts.append(f"{samples['met']} of {samples['tried']} samples met the hypotheses")
    return ", ".join(parts)


def _check_lines(check: Check, entry: Mapping[str, Any] | None) -> list[str]:
    lines = [f"{check.name} ({check.form}, tier {check.tier}): {check.run}"]
    if check.given:
        lines.append("given " + ", ".join(f"{key} = {value}" for key, value in check.given.items()))
    lines.append("routes: " + "; ".join(check.routes))
    rejected = {m["name"]: m["rejected"] for m in (entry or {}).get("mutants", [])}
    for mutant in check.mutants:
        change = ", ".join(f"{key} = {value}" for key, value in mutant.given.items())
        near = ", near" if mutant.near else ""
        said = {True: "rejected", False: "NOT REJECTED", None: "not run"}[rejected.get(mutant.name)]
        lines.append(f"mutant {mutant.name} ({change}{near}): {said}")
    if entry:
        lines.append(_found(entry))
        lines += [
            f"{key}: {entry[key]}"
            for key in ("shown", "witness", "error", "broken")
            if key in entry
        ]
    return [lines[0], *(f"  {line}" for line in lines[1:])]


def _erratum_lines(claim: Claim, whole: Registry) -> list[str]:
    if claim.erratum is None:
        return []
    erratum = claim.erratum
    affects = ", ".join(whole.descendants[claim.id]) or "no other claim"
    survives = "survives" if erratum.conclusion_survives else "does not survive"
    lines = [
        f"class: {erratum.kind}",
        f"printed: {erratum.printed}",
        f"corrected: {erratum.corrected}",
        f"witness: {erratum.witness}",
        f"what rests on it: {affects}",
        f"the conclusion {survives}",
    ]
    return [*lines, f"remark: {erratum.remark}"] if erratum.remark else lines


def explanation(claim: Claim, whole: Registry, entry: Mapping[str, Any] | None, source: str) -> str:
    """Text about a claim; entry: its place in a ledger, if any; source: which ledger that is."""
    by_name = {check["name"]: check for check in (entry or {}).get("checks", [])}
    head = f"{claim.id}  ({claim.kind}, section {claim.section}, {claim.where})"
    lines = [head, ""]
    if entry:
        grade = f", grade {entry['grade']}" if entry["grade"] else ""
        lines += [f"verdict: {entry['verdict']}{grade} (evidence from {source})", ""]
    else:
        lines += ["no evidence yet: run `kminusone check` on it", ""]
    lines += _block("statement", [claim.statement])
    lines += _block("hypotheses", claim.hypotheses)
    lines += _block("covers the labels", [", ".join(claim.labels)] if claim.labels else [])
    lines += _block("rests on", claim.rests_on)
    lines += _block("what rests on it", [c.id for c in whole.claims if claim.id in c.rests_on])
    lines += _block("weakened by", (entry or {}).get("weakened_by", []))
    for check in claim.checks:
        lines += _block("check", _check_lines(check, by_name.get(check.name)))
    lines += _block("erratum", _erratum_lines(claim, whole))
    if claim.citation:
        cited = [f"source: {claim.citation.source}", f"reason: {claim.citation.reason}"]
        lines += _block("cited", cited)
    lines += _block("waits for sections", [", ".join(claim.waits_for)] if claim.waits_for else [])
    return "\n".join(lines).rstrip() + "\n"
