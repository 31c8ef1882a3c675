"""Evidence from a list of complaints: it fails where anything was found."""

from collections.abc import Sequence

from checks.evidence import Evidence, Grade


def findings(
    failures: Sequence[str], *, shown: str, tried: int, grade: Grade = "experiment"
) -> Evidence:
    """Evidence with the first complaints as witness; undecided where nothing was tried."""
    return Evidence(
        outcome="fail" if failures else "pass" if tried else "undecided",
        grade=grade,
        shown=shown,
        tried=tried,
        met=tried,
        witness="; ".join(failures[:3]),
    )
