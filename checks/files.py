"""Write files whole or not at all, and JSON that is the same byte for byte."""

import json
import os
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any


def canonical_json(data: Any) -> str:
    """JSON text of plain data, two spaces deep, keys in the order given, one newline at the end."""
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def json_parts(data: dict[str, Any]) -> Iterator[str]:
    """JSON text of plain data in parts, laid out as by `canonical_json`.

    Where a value is an iterator, its entries come one to a line, each made as it is written, so
    that the memory never holds them all.
    """
    opening = "{"
    for key, value in data.items():
        yield f"{opening}\n  {_in_one_line(key)}: "
        if isinstance(value, Iterator):
            yield from _entries(value)
        else:
            yield canonical_json(value).rstrip("\n").replace("\n", "\n  ")
        opening = ","
    yield "\n}\n"


def _entries(entries: Iterator[Any]) -> Iterator[str]:
    opening = "["
    for entry in entries:
        yield f"{opening}\n    {_in_one_line(entry)}"
        opening = ","
    yield "[]" if opening == "[" else "\n  ]"


def _in_one_line(data: Any) -> str:
    return json.dumps(data, ensure_ascii=False, allow_nan=False)


@contextmanager
def replacing(path: Path) -> Iterator[IO[bytes]]:
    """Binary stream whose content takes the place of path at the end, through a file beside it.

    A reader sees the old or the new whole. Raises OSError where the folder is missing or cannot be
    written; then, and where the block is left by an error, the old file stands.
    """
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=".kminusone-", suffix=".part")
    try:
        with os.fdopen(handle, "wb") as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        os.chmod(name, 0o666 & ~_umask())
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def write_whole(path: Path, text: str) -> None:
    """Write text to path as `replacing` does. Raises OSError; the old file then stands."""
    write_parts(path, [text])


def write_parts(path: Path, parts: Iterable[str]) -> None:
    """Write the parts of a text to path, one after the other, as `replacing` does."""
    with replacing(path) as stream:
        for part in parts:
            stream.write(part.encode("utf-8"))


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
