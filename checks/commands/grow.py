"""`kminusone grow`: a branched net that covers a disk, by the greedy algorithm."""

from typing import Any

import click

from checks.grow.computing import Undecided, computed
from checks.grow.files import Files
from checks.grow.parameters import parameters
from checks.output import STDOUT

#: Largest relative difference between the areas of the kept quads and of the disk.
TILED = 1e-8


def grow_command(
    *,
    radius: str,
    phi0: str | None,
    sectors: str | None,
    cutoff: str,
    step: str,
    max_cuts: int,
    jobs: int | None,
    json_file: str | None,
    net_file: str | None,
    picture_file: str | None,
) -> int:
    """Exit code: 0; 4 where the limit of cuts was reached or rounding cannot place a cut."""
    files = Files(json=json_file, net=net_file, picture=picture_file)
    files.require_possible()
    run = parameters(radius=radius, phi0=phi0, sectors=sectors, cutoff=cutoff, step=step)
    files.require_feasible(run)
    try:
        found = computed(run, jobs=jobs, max_cuts=max_cuts)
    except Undecided as error:
        click.echo(f"kminusone: undecided: {error}", err=True)
        return 4
    from checks.grow.summary import plain, table

    tree = found.tree
    if files.names:
        files.write(tree, plain(tree, found.seconds))
    if json_file != STDOUT:
        click.echo("\n".join(table(tree, found.seconds)))
    _warn(tree, max_cuts)
    return 0 if tree.terminated else 4


def _warn(tree: Any, max_cuts: int) -> None:
    """Say on stderr what makes a result less than it seems."""
    if tree.terminated and abs(tree.area / tree.parameters.area - 1) > TILED:
        click.echo(
            f"kminusone: warning: the quads cover an area of {tree.area:.12g} and the disk has "
            f"{tree.parameters.area:.12g}: rounding spoilt the net, take another --step",
            err=True,
        )
    if tree.unresolved_cuts:
        click.echo(
            f"kminusone: warning: {tree.unresolved_cuts} cuts fall on a side of their sector: the "
            f"step {tree.parameters.step} is too coarse to place them, take a smaller --step",
            err=True,
        )
    if not tree.terminated:
        cuts = int(tree.sectors["copies"][tree.sectors["cut"]].sum())
        click.echo(
            f"kminusone: undecided: stopped after {cuts} cuts with sectors left to sweep, so that "
            f"the tree is partial: raise --max-cuts from {max_cuts}",
            err=True,
        )
