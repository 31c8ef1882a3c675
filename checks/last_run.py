"""The last run, kept in the working folder, and the committed ledger behind it."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from checks.files import canonical_json, write_whole

FOLDER = ".kminusone"
FILE = f"{FOLDER}/last.json"
_HERE = Path(__file__).resolve().parent
# In a checkout the ledger lies among the notes; a wheel carries it inside the package.
COMMITTED = (_HERE.parent / "notes" / "ledger.json", _HERE / "ledger.json")


def keep(ledger: Mapping[str, Any]) -> None:
    """Keep the ledger as the last run, whole or not at all; warn where the folder refuses it."""
    try:
        Path(FOLDER).mkdir(exist_ok=True)
        write_whole(Path(FILE), canonical_json(ledger))
    except OSError as error:
        reason = error.strerror or str(error)
        click.echo(f"warning: {FILE} cannot be written ({reason}): the run is not kept", err=True)


def _read(path: Path) -> dict[str, Any] | None:
    if not path.is_file():
        return None
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        data = None
    if isinstance(data, dict) and str(data.get("schema", "")).startswith("kminusone/ledger/"):
        return data
    click.echo(f"warning: {path} is not a ledger: it is ignored", err=True)
    return None


def last_run() -> dict[str, Any] | None:
    """Return the ledger of the last run in this folder, if there is one."""
    return _read(Path(FILE))


def committed_ledger() -> dict[str, Any] | None:
    """Return the ledger that is kept with the project, if it is there."""
    for path in COMMITTED:
        if (ledger := _read(path)) is not None:
            return ledger
    return None
