"""A progress bar with the time left for one long computation, by the share of it that is done."""

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager

#: Seconds after which a computation is long: shorter ones draw nothing.
DELAY = 1.0


@contextmanager
def share_bar(text: str) -> Iterator[Callable[[float], None]]:
    """Function to be told the share done; draws on stderr where that is a terminal."""
    if not sys.stderr.isatty():
        yield lambda share: None
        return
    start = time.monotonic()
    drawn: list[Callable[[float], None]] = []
    with ExitStack() as stack:

        def told(share: float) -> None:
            if not drawn and time.monotonic() - start > DELAY:
                drawn.append(stack.enter_context(_bar(text)))
            if drawn:
                drawn[0](share)

        yield told


@contextmanager
def _bar(text: str) -> Iterator[Callable[[float], None]]:
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        Progress,
        TaskProgressColumn,
        TextColumn,
        TimeRemainingColumn,
    )

    console = Console(stderr=True, no_color="NO_COLOR" in os.environ)
    columns = (TextColumn(text), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True) as progress:
        bar = progress.add_task("", total=1.0)
        yield lambda share: progress.update(bar, completed=share)
