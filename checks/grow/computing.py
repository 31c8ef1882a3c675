"""Computing of a run: kernels compiled beforehand, threads, a progress bar, the time it took."""

import os
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import click

from checks.errors import BadInput

#: Seconds of compiling that a user is told of.
NOTICEABLE = 1.5


class Undecided(Exception):
    """A run that rounding does not let end; its text is one line."""


@dataclass(frozen=True, kw_only=True)
class Computed:
    """Tree of a run, a discrete.greedy_tree.GreedyTree, and its seconds with warm kernels."""

    tree: Any
    seconds: float


@contextmanager
def _announced(text: str) -> Iterator[None]:
    """Say the text on stderr if the block lasts long."""
    timer = threading.Timer(NOTICEABLE, click.echo, [f"kminusone: {text}"], {"err": True})
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def _warm_up() -> None:
    """Compile the kernels, or load their code, on a disk so small that it takes no time."""
    from discrete.exact_angle import ExactAngle
    from discrete.greedy import grown
    from discrete.greedy_parameters import GreedyParameters

    small = GreedyParameters(
        radius=Fraction(2),
        step=Fraction(1, 10),
        sectors=4,
        cutoff=ExactAngle(half_turns=Fraction(3, 4)),
    )
    grown(small)


def computed(run: Any, *, jobs: int | None, max_cuts: int) -> Computed:
    """Grow the tree of a run in so many threads, by default as many as there are cores.

    Raises Undecided where rounding cannot place a cut, BadInput where the memory runs out.
    """
    from checks.grow.bar import share_bar
    from discrete.complex_errors import SurgeryError
    from discrete.errors import ShapeError
    from discrete.greedy import grown

    with _announced("compiling the kernel of the sweep, which is kept for later runs"):
        _warm_up()
    threads = jobs or os.cpu_count() or 1
    with ExitStack() as stack:
        progress = stack.enter_context(share_bar("area covered"))
        executor = stack.enter_context(ThreadPoolExecutor(threads)) if threads > 1 else None
        start = time.perf_counter()
        try:
            tree = grown(run, executor=executor, max_cuts=max_cuts, progress=progress)
        except (SurgeryError, ShapeError) as error:
            raise Undecided(str(error)) from None
        except MemoryError:
            raise BadInput(
                "the memory does not suffice: take a larger --step, a smaller --radius or fewer "
                "--jobs"
            ) from None
        return Computed(tree=tree, seconds=time.perf_counter() - start)
