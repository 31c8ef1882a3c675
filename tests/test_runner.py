"""The runner: one child per check, so that whatever befalls a child costs that check alone."""

import time

import pytest
from planted import claim

from checks.job import Job, _stable, job_of
from checks.runner import run


def jobs(*names: str, seed: int = 0) -> list[Job]:
    planted = claim("planted", *names)
    return [job_of(planted, check, digits=30, seed=seed) for check in planted.checks]


def test_a_killed_child_costs_its_own_check_and_nothing_else():
    reports = run(jobs("sound", "killed", "drawn"), workers=2)
    assert reports["planted", "killed"].outcome == "error"
    assert "killed by signal 9" in reports["planted", "killed"].error
    assert reports["planted", "killed"].traceback
    assert reports["planted", "sound"].outcome == "pass"
    assert reports["planted", "drawn"].outcome == "pass"


def test_an_exit_in_mid_check_is_an_error_that_names_the_code():
    assert "exit code 7" in run(jobs("exiting"), workers=1)["planted", "exiting"].error


def test_an_exception_is_the_checks_error_with_its_traceback():
    report = run(jobs("raising", "sound"), workers=1)["planted", "raising"]
    assert report.outcome == "error"
    assert report.error == "ArithmeticError: planted"
    assert "in raising" in report.traceback


def test_a_check_that_returns_no_evidence_is_an_error():
    report = run(jobs("wrong_type"), workers=1)["planted", "wrong_type"]
    assert report.outcome == "error"
    assert "expected Evidence" in report.error


def test_a_time_out_ends_the_child_and_is_an_error():
    reports = run(jobs("slow", "sound"), workers=2, timeout=3.0)
    assert reports["planted", "slow"].error == "timed out after 3 s"
    assert reports["planted", "sound"].outcome == "pass"


def test_a_vacuous_check_is_broken_though_it_passes():
    report = run(jobs("vacuous"), workers=1)["planted", "vacuous"]
    assert report.outcome == "pass"
    assert report.broken == "does not reject its mutant factor"


def test_a_measured_check_without_a_near_mutant_is_broken():
    report = run(jobs("measured"), workers=1)["planted", "measured"]
    assert report.broken == "is experiment and has no near mutant"


def test_a_sound_check_is_not_broken():
    assert run(jobs("sound"), workers=1)["planted", "sound"].broken == ""


@pytest.mark.parametrize("workers", [1, 3])
def test_the_seed_alone_decides_what_is_drawn(workers: int):
    first = run(jobs("drawn"), workers=workers)["planted", "drawn"].evidence
    again = run(jobs("drawn"), workers=workers)["planted", "drawn"].evidence
    other = run(jobs("drawn", seed=1), workers=workers)["planted", "drawn"].evidence
    assert first == again
    assert first != other


def test_a_thread_that_lingers_does_not_hold_up_the_suite():
    start = time.monotonic()
    reports = run(jobs("leaving_a_thread", "sound"), workers=1)
    assert [report.outcome for report in reports.values()] == ["pass", "pass"]
    assert time.monotonic() - start < 30


def test_leaving_the_process_by_an_exception_keeps_the_traceback():
    report = run(jobs("leaving_the_process"), workers=1)["planted", "leaving_the_process"]
    assert report.error == "SystemExit: planted exit"
    assert "leaving_the_process" in report.traceback


def test_an_error_names_no_address():
    assert _stable("bad <object at 0x7f12ab34>") == "bad <object at 0x...>"
