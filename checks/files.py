"""Write files whole or not at all, and JSON that is the same byte for byte."""

import json
import os
import tempfile
from pathlib import Path
from typing import Any


def canonical_json(data: Any) -> str:
    """JSON text of plain data, two spaces deep, keys in the order given, one newline at the end."""
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def write_whole(path: Path, text: str) -> None:
    """Write text to path through a file beside it, so that a reader sees the old or the new whole.

    Raises OSError where the folder is missing or cannot be written; the old file then stands.
    """
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=".kminusone-", suffix=".part")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as stream:
            stream.write(text)
            stream.flush()
            os.fsync(stream.fileno())
        os.chmod(name, 0o666 & ~_umask())
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
