"""Version, commit and the versions of what a result rests on."""

import platform
import subprocess
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RESTS_ON = ("sympy", "mpmath", "python-flint", "numpy", "scipy", "numba")


def installed(name: str) -> str:
    """Return the version of a distribution, `unknown` where it is not installed."""
    try:
        return version(name)
    except PackageNotFoundError:
        return "unknown"


def commit() -> str:
    """Return the commit of the checkout that runs, empty where there is none."""
    if not (ROOT / ".git").exists():
        return ""
    command = ["git", "-C", str(ROOT), "describe", "--always", "--dirty", "--abbrev=12"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=10)
    except (OSError, subprocess.SubprocessError):
        return ""
    return done.stdout.strip()


def version_line() -> str:
    """Return the line that `kminusone --version` prints."""
    known = commit()
    return f"kminusone {installed('kminusone')}" + (f" (commit {known})" if known else "")


def versions() -> dict[str, str]:
    """Versions of Python, of the platform and of the libraries that results rest on."""
    return {
        "kminusone": installed("kminusone"),
        "commit": commit(),
        "python": platform.python_version(),
        "platform": platform.platform(),
        **{name: installed(name) for name in RESTS_ON},
    }
