"""The house: who may import whom, and what listing the catalogue may cost."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
FORBIDDEN = {"theory": {"discrete", "checks"}, "discrete": {"theory", "checks"}}


def imported(path: Path) -> set[str]:
    """Top-level packages that a file imports, anywhere in it."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and node.level == 0:
            found.add(node.module.split(".")[0])
    return found


@pytest.mark.parametrize("package", sorted(FORBIDDEN))
def test_the_two_routes_share_no_code(package: str):
    files = list((ROOT / package).rglob("*.py"))
    assert files
    offenders = {str(f): imported(f) & FORBIDDEN[package] for f in files}
    assert not {f: names for f, names in offenders.items() if names}


def test_checkers_of_certificates_share_no_code_with_what_made_them():
    files = list((ROOT / "checks" / "certificates").glob("*.py"))
    assert files
    assert not any(imported(f) & {"theory", "discrete"} for f in files)


def test_the_import_test_sees_an_import_inside_a_function(tmp_path: Path):
    planted = tmp_path / "planted.py"
    planted.write_text("def f():\n    from checks.claim import Claim\n    return Claim\n")
    assert imported(planted) == {"checks"}


@pytest.mark.parametrize("package", ["theory", "discrete", "checks"])
def test_the_packages_are_typed(package: str):
    assert (ROOT / package / "py.typed").is_file()


def test_the_catalogue_imports_nothing_heavy():
    code = (
        "import sys, checks.registry, checks.pins; checks.registry.registry();"
        "heavy = {'sympy', 'numpy', 'mpmath', 'flint', 'scipy', 'numba', 'rich', 'theory',"
        "'discrete'} & set(sys.modules); sys.exit(', '.join(sorted(heavy)) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_theory_and_discrete_neither_print_nor_write_nor_start_processes():
    banned = {"print", "open", "write_text", "write_bytes", "Popen", "Process", "system"}
    for package in FORBIDDEN:
        for path in (ROOT / package).rglob("*.py"):
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Call):
                    name = getattr(node.func, "id", getattr(node.func, "attr", ""))
                    assert name not in banned, f"{path}:{node.lineno} calls {name}"


def test_files_stay_short():
    long = {
        str(path.relative_to(ROOT)): lines
        for package in ("theory", "discrete", "checks")
        for path in (ROOT / package).rglob("*.py")
        if (lines := path.read_text(encoding="utf-8").count("\n")) > 400
        and "catalogue" not in path.parts
    }
    assert not long
