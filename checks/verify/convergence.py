"""Evidence from an order of convergence observed on a sequence of levels."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from mpmath import mp

from checks.evidence import Evidence

TOLERANCE = "0.1"
FEWEST_LEVELS = 4


def observed_orders(levels: Sequence[Any], errors: Sequence[Any]) -> list[Any]:
    """Logarithmic slopes of the errors between neighbouring levels; mpf, all of them nonzero."""
    pairs = list(zip(levels, errors, strict=True))
    return [mp.log(abs(e1) / abs(e0)) / mp.log(h1 / h0) for (h0, e0), (h1, e1) in pairwise(pairs)]


def order(
    levels: Sequence[Any], errors: Sequence[Any], expected: int, *, digits: int, shown: str
) -> Evidence:
    """Evidence that the errors scale as level^expected: every slope observed within 0.1 of it.

    levels and errors: mpf, at least four of them, good to the digits stated; ValueError for fewer.
    """
    if len(levels) < FEWEST_LEVELS:
        raise ValueError(f"{len(levels)} levels: an order takes at least {FEWEST_LEVELS}")
    slopes = observed_orders(levels, errors)
    off = max(abs(slope - expected) for slope in slopes)
    seen = ", ".join(mp.nstr(slope, 4) for slope in slopes)
    if off <= mp.mpf(TOLERANCE):
        return Evidence(
            outcome="pass",
            grade="experiment",
            residual=f"{mp.nstr(off, 2)}",
            digits=digits,
            tried=len(levels),
            met=len(levels),
            shown=f"{shown}: orders {seen}",
        )
    return Evidence(
        outcome="fail",
        grade="experiment",
        digits=digits,
        tried=len(levels),
        met=len(levels),
        shown=shown,
        witness=f"orders {seen}, expected {expected}",
    )
