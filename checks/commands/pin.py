"""`kminusone pin`: what the last run found becomes what is expected."""

from typing import Any

import click

from checks.errors import BadInput
from checks.last_run import FILE, last_run
from checks.output import STDOUT, require_writable, write_json
from checks.pins import FILE as PINS
from checks.pins import as_plain, read_pins, text
from checks.registry import Registry, registry
from checks.verdict import Result


def _ran(ledger: dict[str, Any]) -> dict[str, dict[str, Result]]:
    return {
        entry["id"]: {
            check["name"]: Result(outcome=check["outcome"], grade=check["grade"])
            for check in entry["checks"]
            if check["outcome"] != "not_run"
        }
        for entry in ledger["claims"]
    }


def _refuse_unsound(ledger: dict[str, Any]) -> None:
    """Refuse errors and broken checks: they are defects, never something to expect."""
    unsound = [
        f"{entry['id']} / {check['name']}"
        for entry in ledger["claims"]
        for check in entry["checks"]
        if check["outcome"] == "error" or "broken" in check
    ]
    if unsound:
        raise BadInput(f"cannot pin a check that erred or is broken, mend it: {', '.join(unsound)}")


def _lines(
    old: dict[str, dict[str, Result]], new: dict[str, dict[str, Result]], whole: Registry
) -> list[str]:
    lines = []
    for claim in {**old, **new}:
        known = (
            {check.name for check in whole.by_id[claim].checks} if claim in whole.by_id else set()
        )
        for check in {**old.get(claim, {}), **new.get(claim, {})}:
            before = old.get(claim, {}).get(check)
            after = new.get(claim, {}).get(check) if check in known else None
            if before != after:
                lines.append(f"{claim} / {check}: {text(before)} -> {text(after)}")
    return lines


def pin_command(json_file: str | None) -> int:
    """Exit code: 0; raises BadInput where there is no last run or it holds a broken check."""
    require_writable(json_file)
    ledger = last_run()
    if ledger is None:
        raise BadInput(f"no last run in {FILE}: run `kminusone check --tier full` first")
    _refuse_unsound(ledger)
    whole, old = registry(), read_pins()
    new = {claim: dict(checks) for claim, checks in old.items()}
    for claim, checks in _ran(ledger).items():
        new.setdefault(claim, {}).update(checks)
    lines = _lines(old, new, whole)
    write_json(str(PINS), as_plain(new, whole))
    write_json(json_file, {"changed": lines})
    if json_file != STDOUT:
        click.echo("\n".join(lines) if lines else "the pins stay as they are")
    return 0
