"""The command line `kminusone`: its commands, and what it says of bad input."""

import errno
import os
import signal
import sys
from types import FrameType
from typing import Any

import click

from checks.errors import BadInput, Interrupted

TESTED = ((3, 11),)


def _version_option(context: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted and not context.resilient_parsing:
        from checks.version import version_line

        click.echo(version_line())
        context.exit()


class _Commands(click.Group):
    """The commands; an interrupt is told before click, which would print an empty line for it."""

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except KeyboardInterrupt:
            raise Interrupted("interrupted; nothing was written") from None


@click.group(
    cls=_Commands,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
@click.option("--version", is_flag=True, is_eager=True, expose_value=False,
              callback=_version_option, help="Show the version and the commit.")  # fmt: skip
@click.pass_context
def command_line(context: click.Context) -> None:
    """Check a paper on surfaces of constant negative curvature, claim by claim."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help())


@command_line.command()
@click.argument("patterns", metavar="[CLAIM-OR-GLOB]...", nargs=-1)
@click.option("--section", help="Only this section and its subsections, e.g. 3.1.")
@click.option("--tier", type=click.Choice(["fast", "full"]), default="fast", show_default=True)
@click.option("--digits", type=click.IntRange(1, 10000), default=30, show_default=True,
              help="Decimal digits of the numeric routes.")  # fmt: skip
@click.option("--jobs", type=click.IntRange(1, 1024), help="Child processes [default: all cores].")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True)
@click.option("--json", "json_file", metavar="FILE", help="Write the ledger, - for stdout.")
@click.option("--junit", "junit_file", metavar="FILE", help="Write a JUnit report.")
def check(**options: Any) -> int:
    """Run the checks of the claims named (default: all) and print the ledger."""
    from checks.commands.check import check_command

    return check_command(**options)


@command_line.command()
@click.option("--json", "json_file", metavar="FILE", help="Write the list, - for stdout.")
@click.option("--verdict", help="Only claims expected to end so.")
@click.option("--kind", help="Only claims of this kind, e.g. lemma.")
def claims(**options: Any) -> int:
    """List the catalogue with the verdicts expected, without running a check."""
    from checks.commands.claims import claims_command

    return claims_command(**options)


@command_line.command()
@click.argument("claim")
@click.option("--json", "json_file", metavar="FILE", help="Write the explanation, - for stdout.")
def explain(claim: str, json_file: str | None) -> int:
    """Tell all there is about a claim: statement, checks, mutants, evidence, erratum."""
    from checks.commands.explain import explain_command

    return explain_command(claim, json_file)


@command_line.command()
@click.option("--json", "json_file", metavar="FILE", help="Write the difference, - for stdout.")
def pin(json_file: str | None) -> int:
    """Take the outcomes of the last run as the expected ones, and print what changes."""
    from checks.commands.pin import pin_command

    return pin_command(json_file)


@command_line.command()
@click.option("--json", "json_file", metavar="FILE", help="Write what was built, - for stdout.")
def notes(json_file: str | None) -> int:
    """Build notes/ledger.md and notes/errata.md from notes/ledger.json."""
    from checks.commands.notes import notes_command

    return notes_command(json_file)


@command_line.command()
@click.argument("name", required=False)
@click.argument("assignments", metavar="[KEY=EXPRESSION]...", nargs=-1)
@click.option("--digits", type=click.IntRange(1, 10000), default=30, show_default=True,
              help="Significant digits.")  # fmt: skip
@click.option("--certified", is_flag=True, help="Prove every digit, by ball arithmetic.")
@click.option("--json", "json_file", metavar="FILE", help="Write the value, - for stdout.")
@click.option("--list", "list_", is_flag=True, help="List the values and their keys.")
def value(**options: Any) -> int:
    """Print a named number of the paper, as in: value painleve.crossing phi0=pi/100 level=pi."""
    from checks.commands.value import value_command

    return value_command(**options)


@command_line.command()
@click.option("--radius", required=True, metavar="R", help="Radius of the disk, as 3 or 7/2.")
@click.option("--phi0", metavar="ANGLE",
              help="Angle 2*pi/n of the initial sectors, n even  [default: pi/2].")  # fmt: skip
@click.option("--sectors", metavar="N", help="Number n of initial sectors, instead of --phi0.")
@click.option("--cutoff", default="3*pi/4", show_default=True, metavar="ANGLE",
              help="Largest angle phi: between phi0 and pi.")  # fmt: skip
@click.option("--step", default="0.02", show_default=True, metavar="LENGTH",
              help="Edge length of the net.")  # fmt: skip
@click.option("--max-cuts", type=click.IntRange(1), default=10**6, show_default=True,
              help="Stop beyond so many cuts of the whole disk.")  # fmt: skip
@click.option("--jobs", type=click.IntRange(1, 1024), help="Threads [default: all cores].")
@click.option("--json", "json_file", metavar="FILE", help="Write the result, - for stdout.")
@click.option("--out", "net_file", metavar="FILE",
              help="Write the surface: .ply, .obj, .stl, .glb, .vtk or .npz.")  # fmt: skip
@click.option("--picture", "picture_file", metavar="FILE",
              help="Draw the disk: .png or .svg.")  # fmt: skip
@click.option("--certified", is_flag=True,
              help="Decide every comparison by balls; --json adds a certificate to be checked by "
                   "python -m checks.certificates.")  # fmt: skip
@click.option("--as-printed", is_flag=False, flag_value="letter", metavar="[VARIANT]",
              help="Run the algorithm of the paper: every line to the letter, or one only "
                   "(fill, sign, argument, discard, nodes, axes), or none (meant).")  # fmt: skip
def grow(**options: Any) -> int:
    """Cover a disk with a branched net by the greedy algorithm, as in: grow --radius 3."""
    from checks.commands.grow import grow_command

    return grow_command(**options)


def _warn_of_untested_python() -> None:
    if sys.version_info[:2] not in TESTED:
        tested = ", ".join(f"{major}.{minor}" for major, minor in TESTED)
        running = f"{sys.version_info.major}.{sys.version_info.minor}"
        click.echo(f"warning: Python {running} is not tested (tested: {tested})", err=True)


def _terminated(_signal: int, _frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def _say(text: str) -> None:
    click.echo(f"kminusone: {' '.join(text.split())}", err=True)


def run(arguments: list[str]) -> int:
    """Run the command line and return its exit code (design: 0, 1, 2, 3, 4 or 130)."""
    try:
        result = command_line.main(arguments, prog_name="kminusone", standalone_mode=False)
        if sys.stdout is not None:
            sys.stdout.flush()
    except click.ClickException as error:
        _say(error.format_message())
        return 2
    except BadInput as error:
        _say(str(error))
        return 2
    except (BrokenPipeError, SystemExit):
        # The reader has gone (click turns that into an exit of its own): no complaint at the flush.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except OSError as error:
        if error.errno != errno.ENOSPC:
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        _say(f"cannot write to stdout: {error.strerror}")
        return 2
    except Interrupted as error:
        _say(str(error))
        return 130
    except (KeyboardInterrupt, click.Abort):
        _say("interrupted; nothing was written")
        return 130
    return result if isinstance(result, int) else 0


def main() -> None:
    """Entry point of the console script."""
    signal.signal(signal.SIGTERM, _terminated)
    _warn_of_untested_python()
    sys.exit(run(sys.argv[1:]))
