"""`kminusone notes`: build the notes from the committed ledger; no check runs."""

from pathlib import Path
from typing import Any

import click

from checks.errors import BadInput
from checks.last_run import COMMITTED, committed_ledger
from checks.output import STDOUT, require_writable, write_json, write_text
from checks.report.notes import errata_markdown, ledger_markdown, with_example

NOTES = COMMITTED[0].parent


def built(ledger: dict[str, Any]) -> dict[Path, str]:
    """Text of each file that is built from the ledger."""
    readme = NOTES.parent / "README.md"
    return {
        NOTES / "ledger.md": ledger_markdown(ledger),
        NOTES / "errata.md": errata_markdown(ledger),
        readme: with_example(readme.read_text(encoding="utf-8"), ledger),
    }


def notes_command(json_file: str | None) -> int:
    """Exit code: 0; raises BadInput outside a checkout or where there is no ledger."""
    if not NOTES.is_dir():
        raise BadInput(f"no folder {NOTES}: the notes are built in a checkout of the project")
    ledger = committed_ledger()
    if ledger is None:
        place = "notes/ledger.json"
        raise BadInput(f"no {place}: run `kminusone check --tier full --json {place}` first")
    require_writable(json_file)
    files = built(ledger)
    changed = [
        path
        for path, text in files.items()
        if not path.is_file() or path.read_text("utf-8") != text
    ]
    for path in changed:
        write_text(str(path), files[path])
    names = [str(path.relative_to(NOTES.parent)) for path in changed]
    write_json(
        json_file, {"built": [str(p.relative_to(NOTES.parent)) for p in files], "changed": names}
    )
    if json_file != STDOUT:
        click.echo(f"rebuilt {', '.join(names)}" if names else "the notes are current")
    return 0
