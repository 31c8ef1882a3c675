"""Run jobs, each in a child process of its own, so that a crash or a kill costs one check."""

import multiprocessing
import os
import signal
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from multiprocessing import forkserver, resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

from checks.errors import Interrupted
from checks.job import Job, Report, child

# Imported once by the fork server; a child then starts in milliseconds.
PRELOADED = ["mpmath", "flint", "checks.cli", "checks.job", "checks.exact", "checks.preloaded"]

Key = tuple[str, str]


@dataclass(frozen=True, kw_only=True)
class Running:
    """A job under way in its process, with the time at which it is given up."""

    job: Job
    process: BaseProcess
    connection: Connection
    started: float
    deadline: float


@dataclass(frozen=True, kw_only=True)
class Watcher:
    """Whom the runner tells that a job starts and that it has ended."""

    started: Callable[[Job], None] = lambda job: None
    ended: Callable[[Job, Report], None] = lambda job, report: None


def _serve() -> None:
    """Start the fork server with SIGINT blocked, as its children inherit: the parent interrupts."""
    forkserver.set_forkserver_preload(PRELOADED)
    resource_tracker.ensure_running()  # first, for it unblocks SIGINT
    # Python 3.11 starts the server with the working folder first on its path: a folder `checks`
    # there would be loaded instead of the one that runs here.
    path = os.pathsep.join(entry or os.getcwd() for entry in sys.path)
    wanted = {"PYTHONPATH": path, "PYTHONSAFEPATH": "1"}
    kept = {name: os.environ.get(name) for name in wanted}
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    os.environ.update(wanted)
    try:
        forkserver.ensure_running()
    finally:
        for name, value in kept.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)


def _start(job: Job, timeout: float) -> Running:
    context = multiprocessing.get_context("forkserver")
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=child, args=(job, theirs), daemon=True)
    try:
        process.start()
    except EOFError as error:  # click would take it for an interrupt
        raise RuntimeError("the fork server died while it started: see above") from error
    theirs.close()
    now = time.monotonic()
    return Running(job=job, process=process, connection=ours, started=now, deadline=now + timeout)


def _lost(running: Running, reason: str) -> Report:
    return Report(
        outcome="error",
        error=reason,
        traceback=f"{reason}\nno traceback: the child process left none",
        seconds=time.monotonic() - running.started,
    )


def _collect(running: Running, timeout: float) -> Report | None:
    """Report of a job that has ended or must be ended, None while it may go on."""
    if running.connection.poll():
        try:
            report: Report = running.connection.recv()
        except EOFError:
            _end(running)
            return _lost(running, f"the child process died ({_ending(running.process.exitcode)})")
        except Exception as error:  # cut off in mid-message, or no Report at all
            _end(running)
            return _lost(running, f"the child's report cannot be read ({type(error).__name__})")
        _end(running)
        return report
    if not running.process.is_alive() and not running.connection.poll():
        return _lost(running, f"the child process died ({_ending(running.process.exitcode)})")
    if time.monotonic() >= running.deadline:
        running.process.kill()
        running.process.join()
        return _lost(running, f"timed out after {timeout:g} s")
    return None


def _end(running: Running, grace: float = 2.0) -> None:
    """Await a child that has no more to say; kill one that lingers (a thread, an exit hook)."""
    running.process.join(grace)
    if running.process.is_alive():
        running.process.kill()
        running.process.join()


def _ending(code: int | None) -> str:
    return f"killed by signal {-code}" if code is not None and code < 0 else f"exit code {code}"


def _wait(active: Sequence[Running]) -> None:
    nearest = min(running.deadline for running in active) - time.monotonic()
    handles = [running.connection for running in active]
    sentinels = [running.process.sentinel for running in active]
    wait([*handles, *sentinels], timeout=max(0.0, nearest))


def run(
    jobs: Sequence[Job], *, workers: int, timeout: float = 300.0, watcher: Watcher | None = None
) -> dict[Key, Report]:
    """Return the reports of all jobs by claim and check; they start in the order given.

    workers: child processes at a time, at least 1; timeout: seconds for a check with its mutants.
    Raises Interrupted, with every child ended, where the run is interrupted.
    """
    watcher = watcher or Watcher()
    waiting, active = list(jobs), list[Running]()
    reports: dict[Key, Report] = {}
    try:
        _serve()
        while waiting or active:
            while waiting and len(active) < workers:
                active.append(_start(waiting.pop(0), timeout))
                watcher.started(active[-1].job)
            _wait(active)
            for running in list(active):
                report = _collect(running, timeout)
                if report is not None:
                    active.remove(running)
                    running.connection.close()
                    reports[running.job.claim, running.job.check] = report
                    watcher.ended(running.job, report)
    except KeyboardInterrupt:
        done = len(reports)
        raise Interrupted(
            f"interrupted after {done} of {len(jobs)} checks; nothing was written"
        ) from None
    finally:
        for running in active:
            running.process.kill()
            running.process.join()
    return reports
