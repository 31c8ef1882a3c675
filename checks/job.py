"""One check with its mutants, run in a process of its own: what goes in and what comes out."""

import os
import re
import signal
import threading
import time
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from multiprocessing import parent_process
from multiprocessing.connection import Connection
from typing import Any

from checks.claim import Check, Claim, Value
from checks.evidence import Evidence, Grade, Outcome, Setting


@dataclass(frozen=True, kw_only=True)
class Mutation:
    """A mutant as the child needs it: all the keyword arguments, plain data."""

    name: str
    near: bool
    given: Mapping[str, Value]


@dataclass(frozen=True, kw_only=True)
class Job:
    """A check to run: the function, its arguments, its mutants and the setting, plain data."""

    claim: str
    check: str
    run: str
    given: Mapping[str, Value]
    mutations: tuple[Mutation, ...]
    setting: Setting


@dataclass(frozen=True, kw_only=True)
class MutantReport:
    """What the check said of a mutant; a sound check says fail, and only that is a rejection."""

    name: str
    near: bool
    outcome: Outcome

    @property
    def rejected(self) -> bool:
        """Whether the check failed on the mutant."""
        return self.outcome == "fail"


@dataclass(frozen=True, kw_only=True)
class Report:
    """Outcome of a job; error is one line, traceback the whole of it, seconds the wall time."""

    outcome: Outcome
    evidence: Evidence | None = None
    error: str = ""
    traceback: str = ""
    mutants: tuple[MutantReport, ...] = ()
    seconds: float = 0.0

    @property
    def grade(self) -> Grade | None:
        """Grade of the evidence, if there is any."""
        return self.evidence.grade if self.evidence else None

    @property
    def broken(self) -> str:
        """Why the check is not to be believed whatever its outcome; empty where it is sound."""
        accepted = [mutant.name for mutant in self.mutants if not mutant.rejected]
        if accepted:
            return f"does not reject its mutant {', '.join(accepted)}"
        measured = self.grade in ("numeric", "experiment")
        if measured and not any(mutant.near for mutant in self.mutants):
            return f"is {self.grade} and has no near mutant"
        return ""


def job_of(claim: Claim, check: Check, *, digits: int, seed: int) -> Job:
    """Return the job of a check; its seed depends on the run's and on the two names alone."""
    mutations = tuple(
        Mutation(name=m.name, near=m.near, given={**check.given, **m.given}) for m in check.mutants
    )
    setting = Setting(digits=digits, seed=f"{seed}:{claim.id}:{check.name}")
    return Job(
        claim=claim.id,
        check=check.name,
        run=check.run,
        given=dict(check.given),
        mutations=mutations,
        setting=setting,
    )


def _function(run: str) -> Callable[..., Evidence]:
    module, name = run.split(":")
    function: Callable[..., Evidence] = getattr(import_module(module), name)
    return function


def _mutant_report(
    function: Callable[..., Evidence], mutation: Mutation, setting: Setting
) -> tuple[MutantReport, str]:
    try:
        outcome: Outcome = function(setting, **mutation.given).outcome
        trace = ""
    except BaseException:
        outcome, trace = "error", f"on mutant {mutation.name}:\n{traceback.format_exc()}"
    return MutantReport(name=mutation.name, near=mutation.near, outcome=outcome), trace


def _writable(text: str) -> str:
    return text.encode("utf-8", "backslashreplace").decode()


def _stable(text: str) -> str:
    """Text without the addresses of objects, which differ from run to run."""
    return _writable(re.sub(r"0x[0-9a-f]+", "0x...", text))


def _erred(error: BaseException, start: float) -> Report:
    first = (str(error).splitlines() or [""])[0]
    return Report(
        outcome="error",
        error=_stable(f"{type(error).__name__}: {first}"),
        traceback=_writable("".join(traceback.format_exception(error))),
        seconds=time.perf_counter() - start,
    )


def perform(job: Job) -> Report:
    """Run the check and its mutants in this process; an exception becomes the outcome error."""
    start = time.perf_counter()
    try:
        function = _function(job.run)
        evidence = function(job.setting, **job.given)
        if not isinstance(evidence, Evidence):
            raise TypeError(f"{job.run} returned {type(evidence).__name__}, expected Evidence")
    except BaseException as error:  # SystemExit too is the check's error, with its traceback
        return _erred(error, start)
    pairs = [_mutant_report(function, mutation, job.setting) for mutation in job.mutations]
    return Report(
        outcome=evidence.outcome,
        evidence=evidence,
        mutants=tuple(report for report, _ in pairs),
        traceback="\n".join(trace for _, trace in pairs if trace),
        seconds=time.perf_counter() - start,
    )


def child(job: Job, connection: Connection) -> None:
    """Entry of the child process: perform the job and send its report; the parent interrupts."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    os.dup2(2, 1)  # what a check prints must not mix with the result of the parent
    start = time.perf_counter()
    report = perform(job)
    try:
        connection.send(report)
    except Exception as error:  # evidence that cannot be pickled
        connection.send(_erred(error, start))
    connection.close()


def _end_with_parent() -> None:
    """End this process once the parent is gone, however it went."""
    parent = parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def as_plain(evidence: Evidence | None) -> dict[str, Any]:
    """Digits, residual or enclosure, samples, witness and what was shown, for the ledger."""
    if evidence is None:
        return {"digits": None, "residual": None, "samples": {"tried": 0, "met": 0}}
    plain: dict[str, Any] = {"digits": evidence.digits}
    if evidence.enclosure:
        plain["enclosure"] = evidence.enclosure
    else:
        plain["residual"] = evidence.residual or None
    plain["samples"] = {"tried": evidence.tried, "met": evidence.met}
    if evidence.shown:
        plain["shown"] = evidence.shown
    if evidence.witness:
        plain["witness"] = evidence.witness
    return plain
