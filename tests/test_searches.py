"""The command that makes stored evidence: what it refuses, and that it knows every search."""

import subprocess
import sys
from pathlib import Path

import pytest

from checks.searches import __main__ as command
from checks.stored import FOLDER

NO_SEARCH = {"__init__", "__main__", "maximise", "resumable", "translation_nets"}


def test_every_search_can_be_named_and_is_stored():
    folder = Path(command.__file__).parent
    assert {path.stem for path in folder.glob("*.py")} - NO_SEARCH == set(command.NAMES)
    assert {path.stem for path in FOLDER.glob("*.json")} == set(command.NAMES)


@pytest.mark.parametrize(
    "arguments", [[], ["unknown"], ["efimov", "x"], ["efimov", "-1"], ["efimov", "1", "2"]]
)
def test_other_words_are_refused_in_one_line(arguments, capsys):
    assert command.main(arguments) == 2
    told = capsys.readouterr().err
    assert told.startswith("usage:")
    assert told.count("\n") == 1


def test_an_interrupted_search_stores_nothing(monkeypatch, capsys):
    def interrupted(**_):
        raise KeyboardInterrupt

    monkeypatch.setattr("checks.searches.efimov.search", interrupted)
    before = (FOLDER / "efimov.json").read_bytes()
    assert command.main(["efimov"]) == 130
    assert (FOLDER / "efimov.json").read_bytes() == before


def test_the_module_is_a_command():
    done = subprocess.run(
        [sys.executable, "-m", "checks.searches"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
