"""Long sweeps that tell their progress and resume where they were interrupted."""

import json
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

from checks.files import write_whole
from checks.last_run import FOLDER

Progress = Callable[[str], None]
EVERY = 5.0


def swept(
    task: Callable[[str], dict[str, Any]],
    keys: Sequence[str],
    *,
    name: str,
    stamp: str,
    executor: Executor,
    progress: Progress,
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Results of the task for each key, in the order of the keys.

    Each result is added to a file of partial results as it comes, and read from there when the
    sweep is run again with the same stamp (a hash of the sources); another stamp begins anew.
    """
    file = Path(FOLDER) / f"{name}.partial.jsonl"
    known = _read(file, stamp)
    missing = [key for key in keys if key not in known]
    if len(missing) < len(keys):
        progress(f"{len(keys) - len(missing)} of {len(keys)} taken from {file}")
    file.parent.mkdir(exist_ok=True)
    whole = [{"stamp": stamp}, *({"key": key, "result": known[key]} for key in known)]
    write_whole(file, "".join(json.dumps(record) + "\n" for record in whole))
    with file.open("a", encoding="utf-8") as stream:
        told = _Told(progress, len(missing))
        for key, result in zip(missing, executor.map(task, missing, chunksize=4), strict=True):
            _append(stream, {"key": key, "result": result})
            known[key] = result
            told.one()
    for key in keys:
        yield key, known[key]


def discard(name: str) -> None:
    """Remove the partial results of a sweep that has been stored whole."""
    (Path(FOLDER) / f"{name}.partial.jsonl").unlink(missing_ok=True)


def _append(stream: Any, record: dict[str, Any]) -> None:
    stream.write(json.dumps(record) + "\n")
    stream.flush()


def _read(file: Path, stamp: str) -> dict[str, dict[str, Any]]:
    """Results in the file by key, none where its stamp is another; a torn last line is left out."""
    if not file.is_file():
        return {}
    records = []
    for line in file.read_text(encoding="utf-8").splitlines():
        try:
            records.append(json.loads(line))
        except ValueError:
            break
    if not records or records[0].get("stamp") != stamp:
        return {}
    return {record["key"]: record["result"] for record in records[1:]}


class _Told:
    """Progress told every few seconds: how many are done and the time left."""

    def __init__(self, progress: Progress, total: int) -> None:
        self.progress, self.total, self.done = progress, total, 0
        self.start = self.last = time.monotonic()

    def one(self) -> None:
        """Count one, and tell if it is time."""
        self.done += 1
        now = time.monotonic()
        if now - self.last >= EVERY or self.done == self.total:
            self.last = now
            left = (now - self.start) / self.done * (self.total - self.done)
            self.progress(f"{self.done} of {self.total}, about {left:.0f} s left")
