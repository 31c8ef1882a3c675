"""Write files whole or not at all, and JSON that is the same byte for byte."""

import json
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any


def canonical_json(data: Any) -> str:
    """JSON text of plain data, two spaces deep, keys in the order given, one newline at the end."""
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


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
    with replacing(path) as stream:
        stream.write(text.encode("utf-8"))


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
