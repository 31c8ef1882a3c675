"""Every code name of notes/notation.md exists, so that a reader of the paper finds the room."""

import re
from importlib import import_module
from pathlib import Path

import pytest

TEXT = (Path(__file__).resolve().parent.parent / "notes" / "notation.md").read_text("utf-8")
NAMES = sorted(set(re.findall(r"`((?:theory|discrete|checks)\.[\w.]+:\w+)`", TEXT)))


def test_there_are_names():
    assert len(NAMES) > 20


@pytest.mark.parametrize("name", NAMES)
def test_the_name_exists(name: str):
    module, attribute = name.split(":")
    assert hasattr(import_module(module), attribute)
