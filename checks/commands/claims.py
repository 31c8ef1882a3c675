"""`kminusone claims`: the catalogue with the verdicts that the pins imply."""

from typing import Any, get_args

import click

from checks.claim import Claim, Kind
from checks.errors import BadInput
from checks.output import STDOUT, require_writable, write_json
from checks.pins import Pins, expected, read_pins
from checks.registry import registry
from checks.verdict import VERDICTS


def _entry(claim: Claim, pins: Pins) -> dict[str, Any]:
    wanted = expected(claim, pins)
    return {
        "id": claim.id,
        "section": claim.section,
        "where": claim.where,
        "kind": claim.kind,
        "labels": list(claim.labels),
        "statement": claim.statement,
        "expected": wanted[0] if wanted else None,
        "grade": wanted[1] if wanted else None,
        "checks": len(claim.checks),
        "waits_for": list(claim.waits_for),
    }


def _require(value: str | None, known: tuple[str, ...], what: str) -> None:
    if value is not None and value not in known:
        raise BadInput(f"unknown {what} {value!r}: expected one of {', '.join(known)}")


def claims_command(*, json_file: str | None, verdict: str | None, kind: str | None) -> int:
    """Exit code: 0, or 3 where no claim is listed."""
    _require(verdict, VERDICTS, "verdict")
    _require(kind, get_args(Kind), "kind")
    require_writable(json_file)
    pins = read_pins()
    entries = [
        entry
        for claim in registry().claims
        if kind in (None, claim.kind)
        and verdict in (None, (entry := _entry(claim, pins))["expected"])
    ]
    write_json(json_file, {"claims": entries})
    if json_file != STDOUT:
        width = max((len(entry["id"]) for entry in entries), default=0)
        for e in entries:
            where = f"{e['section']:<8} {e['kind']:<11} {e['expected'] or 'not pinned':<10}"
            click.echo(f"{e['id']:<{width}} {where} {e['grade'] or '':<10}".rstrip())
    click.echo(f"{len(entries)} claims", err=True)
    return 0 if entries else 3
