"""How long the commands that must be instant take, as whole processes; run by `make bench`."""

import subprocess
import sys

import pytest

COMMANDS = (["--help"], ["claims"], ["explain", "eq:sg"])


@pytest.mark.parametrize("arguments", COMMANDS, ids=" ".join)
def test_instant_commands(benchmark, arguments: list[str]):
    command = [sys.executable, "-m", "checks", *arguments]
    benchmark.pedantic(
        subprocess.run,
        args=(command,),
        kwargs={"check": True, "capture_output": True},
        rounds=7,
        warmup_rounds=1,
    )
