"""Evidence from propositions decided exactly one by one, such as memberships at rational points."""

from collections.abc import Iterable

from checks.evidence import Evidence, Grade

Decided = tuple[bool, str]


def decided(rows: Iterable[Decided], *, shown: str, grade: Grade = "numeric") -> Evidence:
    """Evidence that every proposition is true; each row holds its truth and what refutes it.

    grade: of a pass; numeric where the rows are samples of what the claim says of all stars or all
    points, exact where they exhaust it. A refutation is exact.
    """
    tried = 0
    for true, witness in rows:
        tried += 1
        if not true:
            return Evidence(
                outcome="fail", grade="exact", witness=witness, tried=tried, met=tried, shown=shown
            )
    if not tried:
        return Evidence(outcome="undecided", grade=grade, tried=0, met=0, shown=shown)
    residual = "0" if grade == "exact" else ""
    return Evidence(
        outcome="pass", grade=grade, residual=residual, tried=tried, met=tried, shown=shown
    )
