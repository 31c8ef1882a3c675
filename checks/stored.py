"""Stored evidence of heavy runs: the result, and the hashes of the sources that made it.

A run is made by `python -m checks.searches NAME`, kept in `checks/stored_runs/NAME.json`, and
re-analysed by the suite. When a source that it depends on changes, it is stale.
"""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from checks.files import canonical_json, write_whole

ROOT = Path(__file__).resolve().parent.parent
FOLDER = Path(__file__).resolve().parent / "stored_runs"


@dataclass(frozen=True, kw_only=True)
class StoredRun:
    """Result of a heavy run; sources: path from the project's root to SHA-256 of its text."""

    name: str
    seed: int
    evaluations: int
    result: Mapping[str, Any]
    sources: Mapping[str, str]

    @property
    def stale(self) -> bool:
        """Whether a source has changed since the run."""
        return dict(self.sources) != hashes(tuple(self.sources))


def hashes(paths: tuple[str, ...]) -> dict[str, str]:
    """SHA-256 of each file, by path from the project's root; a missing file hashes to nothing."""
    found = {}
    for path in sorted(paths):
        file = ROOT / path
        found[path] = hashlib.sha256(file.read_bytes()).hexdigest() if file.is_file() else ""
    return found


def load(name: str) -> StoredRun:
    """Return the stored run of this name; raises FileNotFoundError if it was never made."""
    return StoredRun(**json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8")))


def store(run: StoredRun) -> Path:
    """Write the run to its file, whole or not at all, and return the path."""
    path = FOLDER / f"{run.name}.json"
    fields = ("name", "seed", "evaluations", "result", "sources")
    write_whole(path, canonical_json({name: getattr(run, name) for name in fields}))
    return path
