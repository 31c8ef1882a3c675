"""Re-check of the stored certificate of the Bessel bounds over their whole range (boundCphi*)."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

from flint import arb, ctx

from checks.certificates.amsler_bounds import Verdict, verdict
from checks.certificates.painleve_tube import Step, grid
from checks.evidence import Evidence, Setting
from checks.stored import StoredRun, load

BITS = 64
STEP = Fraction(1, 20)
#: Every so many columns the bounds are first tried at one phi_n, where a false one is refuted.
SAMPLED = 25

Column = tuple[Fraction, Fraction, int]


def certificate(
    setting: Setting,
    *,
    lower: str = "1",
    upper: str = "1",
    constant: str = "at phi",
    beginning: str = "1e-6",
) -> Evidence:
    """Bounds I_0(lower C z) <= phi/phi_n <= I_0(upper z) on every column of the certificate.

    constant: `at phi_n` takes C(phi_n) in place of C(phi*). beginning: the least phi_n that the
    columns must reach; they must tile [beginning, pi - 1/100] without a gap.
    """
    del setting
    run = load("amsler_bounds")
    columns = [(Fraction(low), Fraction(high), depth) for low, high, depth in run.result["columns"]]
    if reason := _unsound(run, columns, Fraction(beginning)):
        return _failed(reason, len(columns))
    forms: dict[str, Any] = {
        "top": Fraction(run.result["top"]),
        "lower": Fraction(lower),
        "upper": Fraction(upper),
        "constant": constant,
    }
    with ctx.workprec(BITS):
        for found in _points(columns, forms):
            if found.refuted:
                return _failed(found.refuted, len(columns))
        return _proved([*_verdicts(columns, forms)], run)


def _unsound(run: StoredRun, columns: list[Column], beginning: Fraction) -> str:
    """Why the certificate does not cover the range, empty if it does."""
    if run.stale:
        return "the stored certificate is older than its sources"
    if any(left[1] != right[0] for left, right in pairwise(columns)):
        return "the columns leave a gap or overlap"
    if columns[0][0] > beginning:
        return f"the columns begin at {columns[0][0]}, above {beginning}"
    with ctx.workprec(BITS):
        end = arb(columns[-1][1].numerator) / columns[-1][1].denominator
        if not end >= arb.pi() - arb(1) / 100:
            return "the columns end below pi - 1/100"
    return ""


def _points(columns: list[Column], forms: dict[str, Any]) -> Iterator[Verdict]:
    """Verdicts at single phi_n, the middles of some columns; the last are above pi/2."""
    steps = grid(STEP)
    for low, high, _ in columns[::-SAMPLED]:
        middle = (low + high) / 2
        yield verdict(middle, middle, steps=steps, **forms)


def _verdicts(columns: list[Column], forms: dict[str, Any]) -> Iterator[Verdict]:
    """Verdicts on whole columns, each with the step that closed it in the run."""
    grids: dict[int, tuple[Step, ...]] = {}
    for low, high, depth in columns:
        if depth not in grids:
            grids[depth] = grid(STEP / 2**depth)
        yield verdict(low, high, steps=grids[depth], **forms)


def _proved(verdicts: list[Verdict], run: StoredRun) -> Evidence:
    refuted = [found.refuted for found in verdicts if found.refuted]
    if refuted:
        return _failed(refuted[0], len(verdicts))
    open_places = [found.open for found in verdicts if found.open]
    closed = len(verdicts) - len(open_places)
    if open_places:
        return Evidence(
            outcome="undecided",
            grade="certified",
            tried=len(verdicts),
            met=closed,
            shown=f"{len(open_places)} columns open: {'; '.join(open_places[:3])}",
        )
    stretches = sum(found.stretches for found in verdicts)
    gap = min(found.gap for found in verdicts)
    quotient = min(found.quotient for found in verdicts)
    return Evidence(
        outcome="pass",
        grade="certified",
        tried=len(verdicts),
        met=closed,
        shown=f"for all phi_n from 1e-6 to phi*, all phi* <= pi - 1/100, all z in [0, z*]: {closed} "
        f"columns of phi_n, {stretches} stretches of z, open share {run.result['open_share']:g}; "
        f"(I_0(z) - phi/phi_n)/(phi_n^2 z^2/4) >= {gap:.3g}, and the two parts of the lower gap "
        f"over (phi_n^2 z^4/16) differ by a factor of at least {quotient:.3g}",
    )


def _failed(witness: str, tried: int) -> Evidence:
    return Evidence(outcome="fail", grade="certified", witness=witness, tried=tried, met=tried)
