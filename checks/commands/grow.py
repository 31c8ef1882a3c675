"""`kminusone grow`: a branched net that covers a disk, by the greedy algorithm."""

import os
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from fractions import Fraction
from typing import Any

import click

from checks.errors import BadInput
from checks.grow.parameters import parameters
from checks.output import STDOUT, require_writable, write_json

#: A run with more quads than this, by its area, shows how far it is.
LONG_RUN = 5e7


def grow_command(
    *,
    radius: str,
    phi0: str | None,
    sectors: int | None,
    cutoff: str,
    step: str,
    max_cuts: int,
    jobs: int | None,
    json_file: str | None,
) -> int:
    """Exit code: 0; 4 where the limit of cuts was reached."""
    require_writable(json_file)
    run = parameters(radius, phi0, sectors, cutoff, step)
    tree, seconds = _timed(run, jobs or os.cpu_count() or 1, max_cuts)
    from checks.grow.summary import plain, table

    if json_file is not None:
        write_json(json_file, plain(tree, seconds))
    if json_file != STDOUT:
        for line in table(tree, seconds):
            click.echo(line)
    _warn(tree, max_cuts)
    return 0 if tree.terminated else 4


def _timed(run: Any, jobs: int, max_cuts: int) -> tuple[Any, float]:
    """Tree of a run, and the seconds that it took after the kernels were compiled."""
    from checks.grow.bar import share_bar
    from discrete.complex_errors import SurgeryError
    from discrete.exact_angle import ExactAngle
    from discrete.greedy import grown
    from discrete.greedy_parameters import GreedyParameters

    warm = GreedyParameters(
        radius=Fraction(2),
        step=Fraction(1, 10),
        sectors=4,
        cutoff=ExactAngle(half_turns=Fraction(3, 4)),
    )
    grown(warm)
    with ExitStack() as stack:
        progress = None
        if run.area / float(run.step) ** 2 > LONG_RUN:
            progress = stack.enter_context(share_bar("area covered"))
        executor = stack.enter_context(ThreadPoolExecutor(jobs)) if jobs > 1 else None
        start = time.perf_counter()
        try:
            tree = grown(run, executor=executor, max_cuts=max_cuts, progress=progress)
        except SurgeryError as error:
            raise BadInput(str(error)) from None
        return tree, time.perf_counter() - start


def _warn(tree: Any, max_cuts: int) -> None:
    if tree.unresolved_cuts:
        click.echo(
            f"kminusone: {tree.unresolved_cuts} cuts fall on a side of their sector: the step "
            f"{tree.parameters.step} does not resolve them, take a smaller one",
            err=True,
        )
    if not tree.terminated:
        click.echo(
            f"kminusone: undecided: stopped after {max_cuts} cuts, with sectors left to sweep; "
            "raise --max-cuts",
            err=True,
        )
