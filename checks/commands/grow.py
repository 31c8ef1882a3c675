"""`kminusone grow`: a branched net that covers a disk, by the greedy algorithm."""

from typing import Any

import click

from checks.errors import BadInput
from checks.grow.computing import Undecided, computed
from checks.grow.files import Files
from checks.grow.parameters import parameters
from checks.output import STDOUT, write_json

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
    certified: bool,
    as_printed: str | None,
) -> int:
    """Exit code: 0; 4 where the limit of cuts was reached or rounding cannot place a cut."""
    files = Files(json=json_file, net=net_file, picture=picture_file)
    files.require_possible()
    run = parameters(radius=radius, phi0=phi0, sectors=sectors, cutoff=cutoff, step=step)
    if as_printed is not None:
        if certified:
            raise BadInput("--certified is for our algorithm, not for --as-printed: give one")
        return _grow_as_printed(run, as_printed, files, max_cuts)
    files.require_feasible(run)
    try:
        found = computed(run, jobs=jobs, max_cuts=max_cuts)
    except Undecided as error:
        click.echo(f"kminusone: undecided: {error}", err=True)
        return 4
    from checks.grow.summary import plain, table

    tree = found.tree
    data, lines = plain(tree, found.seconds), table(tree, found.seconds)
    if certified:
        from checks.grow.certified import certificate_lines, certified_data

        try:
            data["certificate"] = certified_data(tree, max_cuts=max_cuts)
        except Undecided as error:
            click.echo(f"kminusone: undecided: {error}", err=True)
            return 4
        lines += certificate_lines(data["certificate"])
    if files.names:
        files.write(tree, data)
    if json_file != STDOUT:
        click.echo("\n".join(lines))
    _warn(tree, max_cuts)
    return 0 if tree.terminated else 4


def _grow_as_printed(run: Any, variant: str, files: Files, max_cuts: int) -> int:
    """Exit code: 0; 4 where the run does not end as step 25 says."""
    from checks.grow.printed import plain, printed_result, require_variant, table

    require_variant(variant)
    if files.net is not None or files.picture is not None:
        raise BadInput(
            "--as-printed makes no surface, its quads may overlap: leave out --out and --picture"
        )
    result = printed_result(run, variant, max_cuts=max_cuts)
    data = plain(result)
    if files.json is not None:
        write_json(files.json, data)
    if files.json != STDOUT:
        click.echo("\n".join(table(data)))
    if not result.terminated:
        click.echo(
            f"kminusone: undecided: the algorithm as printed, variant {variant}, did not end by "
            f"step 25 but by: {result.run.end}, after {result.cuts} cuts",
            err=True,
        )
    return 0 if result.terminated else 4


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
