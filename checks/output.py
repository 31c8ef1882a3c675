"""Where results go: files that were found writable beforehand, or stdout."""

import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click

from checks.errors import BadInput
from checks.files import canonical_json, json_parts, write_parts

STDOUT = "-"


def require_writable(name: str | None) -> None:
    """Refuse an output file that could not be written at the end; raises BadInput."""
    if name is None or name == STDOUT:
        return
    path = Path(name)
    if not name:
        raise BadInput("cannot write to a file without a name")
    if path.exists() and not path.is_file() and not path.is_dir():
        return  # a pipe or a device: written to, never replaced
    path = path.resolve()
    if path.is_dir():
        raise BadInput(f"cannot write {name}: it is a folder, name a file in it")
    if not path.parent.is_dir():
        raise BadInput(f"cannot write {name}: the folder {path.parent} does not exist, create it")
    try:
        # Only an attempt tells: permissions, a read-only disk, a file system that takes no files.
        tempfile.TemporaryFile(dir=path.parent).close()
    except OSError as error:
        reason = error.strerror or str(error)
        raise BadInput(f"cannot write {name}: {reason}, choose another place") from error


def write_text(name: str, text: str) -> None:
    """Write text to the file whole, or to stdout; raises BadInput where that fails."""
    _write(name, [text])


def write_json(name: str | None, data: Any) -> None:
    """Write data as JSON to the file or to stdout, or nowhere where there is no name."""
    if name is not None:
        write_text(name, canonical_json(data))


def write_long_json(name: str, data: dict[str, Any]) -> None:
    """Write data, some of it iterators of many entries, as `write_json` does, but in parts."""
    _write(name, json_parts(data))


def _write(name: str, parts: Iterable[str]) -> None:
    if name == STDOUT:
        for part in parts:
            click.echo(part, nl=False)
        return
    path = Path(name)
    try:
        if path.exists() and not path.is_file():
            with path.open("w", encoding="utf-8") as stream:
                stream.writelines(parts)
        else:
            write_parts(path.resolve(), parts)
    except OSError as error:
        raise BadInput(f"cannot write {name}: {error.strerror or error}") from error
