"""A progress bar on stderr that says what is running; none where stderr is no terminal."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from checks.job import Job, Report
from checks.runner import Watcher


@contextmanager
def watching(total: int) -> Iterator[Watcher]:
    """Watcher for a run of so many checks, drawn while the context is open."""
    if not sys.stderr.isatty():
        yield Watcher()
        return
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    console = Console(stderr=True, no_color="NO_COLOR" in os.environ)
    columns = (
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        TextColumn("{task.description}"),
    )
    with Progress(*columns, console=console, transient=True) as progress:
        bar = progress.add_task("", total=total)
        running: list[str] = []

        def started(job: Job) -> None:
            running.append(job.claim)
            progress.update(bar, description=", ".join(running[:4]))

        def ended(job: Job, _report: Report) -> None:
            running.remove(job.claim)
            progress.update(bar, advance=1, description=", ".join(running[:4]))

        yield Watcher(started=started, ended=ended)
