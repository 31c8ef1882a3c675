"""Every example in a docstring of the three packages gives what it shows."""

import doctest
import re
from importlib import import_module
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent


def _with_examples() -> list[str]:
    """Names of the modules whose text has an example, found without importing them."""
    return sorted(
        ".".join(path.relative_to(ROOT).with_suffix("").parts)
        for package in ("theory", "discrete", "checks")
        for path in (ROOT / package).rglob("*.py")
        if ">>> " in path.read_text(encoding="utf-8")
    )


@pytest.mark.parametrize("module", _with_examples())
def test_the_examples_hold(module: str):
    failed, tried = doctest.testmod(import_module(module))
    assert tried > 0
    assert failed == 0


def _readme_code() -> list[str]:
    """Blocks of Python in the README."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.findall(r"^```python\n(.*?)^```$", text, flags=re.DOTALL | re.MULTILINE)


def test_the_code_of_the_readme_runs():
    blocks = _readme_code()
    assert blocks
    for block in blocks:
        exec(compile(block, "README.md", "exec"), {})


def test_a_wrong_example_is_seen():
    example = doctest.DocTestParser().get_doctest(">>> 1 + 1\n3\n", {}, "planted", None, 0)
    runner = doctest.DocTestRunner(verbose=False)
    runner.run(example, out=lambda _: None)
    assert runner.failures == 1
