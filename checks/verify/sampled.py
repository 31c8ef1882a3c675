"""Evidence from propositions decided exactly one by one, such as memberships at rational points."""

from collections.abc import Iterable

from checks.evidence import Evidence

Decided = tuple[bool, str]


def decided(rows: Iterable[Decided], *, shown: str) -> Evidence:
    """Evidence that every proposition is true; each row holds its truth and what refutes it."""
    tried = 0
    for true, witness in rows:
        tried += 1
        if not true:
            return Evidence(
                outcome="fail", grade="exact", witness=witness, tried=tried, met=tried, shown=shown
            )
    if not tried:
        return Evidence(outcome="undecided", grade="exact", tried=0, met=0, shown=shown)
    return Evidence(
        outcome="pass", grade="exact", residual="0", tried=tried, met=tried, shown=shown
    )
