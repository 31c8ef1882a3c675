"""`kminusone explain`: all there is about one claim."""

from collections.abc import Mapping
from typing import Any

import click

from checks.errors import BadInput
from checks.last_run import committed_ledger, last_run
from checks.output import STDOUT, require_writable, write_json
from checks.registry import Registry, registry
from checks.report.explanation import explanation
from checks.selection import select


def _evidence(id_: str) -> tuple[dict[str, Any] | None, str]:
    """Entry of the claim in the last run, else in the committed ledger, and where it was found."""
    for ledger, source in ((last_run(), "the last run"), (committed_ledger(), "notes/ledger.json")):
        for entry in (ledger or {}).get("claims", []):
            if entry["id"] == id_:
                return entry, source
    return None, ""


def _plain(
    id_: str, whole: Registry, entry: Mapping[str, Any] | None, source: str
) -> dict[str, Any]:
    claim = whole.by_id[id_]
    direct = [other.id for other in whole.claims if id_ in other.rests_on]
    return {
        "id": id_,
        "statement": claim.statement,
        "hypotheses": list(claim.hypotheses),
        "rests_on": list(claim.rests_on),
        "rests_on_it": direct,
        "evidence_from": source or None,
        "evidence": dict(entry) if entry else None,
    }


def explain_command(pattern: str, json_file: str | None) -> int:
    """Exit code: 0; an unknown claim is refused with the close ones named."""
    require_writable(json_file)
    whole = registry()
    chosen = select(whole, [pattern])
    if json_file is not None and len(chosen) > 1:
        raise BadInput(f"--json explains one claim, {pattern!r} matches {len(chosen)}: name one")
    for claim in chosen:
        entry, source = _evidence(claim.id)
        if json_file is not None:
            write_json(json_file, _plain(claim.id, whole, entry, source))
        if json_file != STDOUT:
            click.echo(explanation(claim, whole, entry, source), nl=False)
    return 0
