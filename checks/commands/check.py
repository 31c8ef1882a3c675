"""`kminusone check`: run, compare with the pins, print and keep the ledger."""

import os
import time
from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from graphlib import TopologicalSorter
from typing import Any

import click

from checks import ledger as ledgers
from checks.claim import Claim, Tier
from checks.errors import BadInput
from checks.job import Job, Report, job_of
from checks.last_run import keep
from checks.output import STDOUT, require_writable, write_json, write_text
from checks.pins import Pins, differences, read_pins, text
from checks.registry import Registry, registry
from checks.report.junit import junit
from checks.report.progress import watching
from checks.report.table import table
from checks.runner import Key, run
from checks.selection import runs_in, select
from checks.version import versions


def _in_order_of_need(claims: Sequence[Claim], whole: Registry) -> list[Claim]:
    """Claims sorted so that each comes after those it rests on; ties in the paper's order."""
    place = {claim.id: number for number, claim in enumerate(whole.claims)}
    sorter = TopologicalSorter(
        {c.id: sorted(c.rests_on, key=place.__getitem__) for c in whole.claims}
    )
    wanted = {claim.id: claim for claim in claims}
    sorter.prepare()
    order: list[Claim] = []
    while sorter.is_active():
        ready = sorted(sorter.get_ready(), key=place.__getitem__)
        order += [wanted[id_] for id_ in ready if id_ in wanted]
        sorter.done(*ready)
    return order


def jobs_of(
    claims: Sequence[Claim], whole: Registry, *, tier: Tier, digits: int, seed: int
) -> list[Job]:
    """Jobs of the claims' checks that belong to the tier, in the order in which they are needed."""
    return [
        job_of(claim, check, digits=digits, seed=seed)
        for claim in _in_order_of_need(claims, whole)
        for check in claim.checks
        if runs_in(check, tier)
    ]


def _vanished(whole: Registry, pins: Pins) -> list[str]:
    """One line for each pinned check that the catalogue no longer has."""
    known = {(claim.id, check.name) for claim in whole.claims for check in claim.checks}
    return [
        f"{claim} / {check}: pinned {text(pin)}, no longer in the catalogue"
        for claim, checks in pins.items()
        for check, pin in checks.items()
        if (claim, check) not in known
    ]


def _exit_code(problems: Sequence[str]) -> int:
    """0 as pinned, 4 where nothing worse happened than that checks stayed undecided, else 1."""
    if not problems:
        return 0
    return 4 if all(", came out undecided" in problem for problem in problems) else 1


def _problems(ledger: dict[str, Any], differing: Sequence[str]) -> list[str]:
    broken = [
        f"{claim['id']} / {check['name']}: broken, it {check['broken']}"
        for claim in ledger["claims"]
        for check in claim["checks"]
        if "broken" in check
    ]
    return broken + list(differing)


def _times(
    reports: Mapping[Key, Report], *, started: str, seconds: float, jobs: int
) -> dict[str, Any]:
    """All that may differ between two runs: times, tracebacks, versions."""
    named = {f"{claim}/{check}": report for (claim, check), report in sorted(reports.items())}
    return {
        "started": started,
        "seconds": round(seconds, 3),
        "jobs": jobs,
        "checks": {name: round(report.seconds, 3) for name, report in named.items()},
        "tracebacks": {name: r.traceback for name, r in named.items() if r.traceback},
        "versions": versions(),
    }


def _tell(
    ledger: dict[str, Any],
    problems: Sequence[str],
    *,
    json_file: str | None,
    junit_file: str | None,
) -> None:
    """Write the files asked for; the table goes to stdout, or only the problems to stderr."""
    write_json(json_file, ledger)
    if junit_file:
        write_text(junit_file, junit(ledger, problems))
    if STDOUT not in (json_file, junit_file):
        click.echo(table(ledger, problems), nl=False)
        return
    for line in problems:
        click.echo(f"kminusone: {line}", err=True)


def check_command(
    *,
    patterns: Sequence[str],
    section: str | None,
    tier: Tier,
    digits: int,
    jobs: int | None,
    seed: int,
    json_file: str | None,
    junit_file: str | None,
) -> int:
    """Exit code of the run: 0 as pinned, 1 differs or broken, 3 nothing ran, 4 only undecided."""
    whole = registry()
    claims = select(whole, patterns, section=section)
    for name in (json_file, junit_file):
        require_writable(name)
    if json_file == junit_file == STDOUT:
        raise BadInput("only one of --json and --junit can go to stdout: name a file for the other")
    todo = jobs_of(claims, whole, tier=tier, digits=digits, seed=seed)
    if not todo:
        click.echo(
            f"kminusone: nothing ran: no check of the claims selected is in tier {tier}", err=True
        )
        return 3
    pins = read_pins()
    workers = min(jobs or os.cpu_count() or 1, len(todo))
    start, begun = time.perf_counter(), datetime.now(UTC).isoformat(timespec="seconds")
    with watching(len(todo)) as watcher:
        reports = run(todo, workers=workers, watcher=watcher)
    times = _times(reports, started=begun, seconds=time.perf_counter() - start, jobs=workers)
    ledger = ledgers.build(
        claims, whole, reports, pins, seed=seed, digits=digits, tier=tier, times=times
    )
    results = ledgers.ran(claims, reports)
    problems = _problems(ledger, [*differences(results, pins), *_vanished(whole, pins)])
    keep(ledger)
    _tell(ledger, problems, json_file=json_file, junit_file=junit_file)
    return _exit_code(problems)
