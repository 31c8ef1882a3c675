"""Certificates of the greedy algorithm: made anew or stored, and checked by another rule."""

import copy
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from checks.certificates.greedy import verdict
from checks.certificates.greedy_format import certificate
from checks.evidence import Evidence, Setting
from checks.grow.certificate import certificate_of
from checks.grow.certified import ROUNDING, difference
from checks.searches.greedy_certificates import parameters
from checks.stored import load
from discrete.certified_greedy import certified_tree
from discrete.greedy import grown

#: Radius, step, sectors and cutoff in half turns.
RUNS = (
    ("3", "1/50", 4, "3/4"),
    ("3", "1/50", 8, "4/5"),
    ("5", "1/20", 4, "3/4"),
    ("5", "1/20", 8, "4/5"),
)


def _altered(data: Mapping[str, Any], alter: str) -> Mapping[str, Any]:
    """Certificate with one field changed: a cut one column on, its angle, a total, the cutoff."""
    if not alter:
        return data
    found = copy.deepcopy(dict(data))
    cut = next(sector["cut"] for sector in found["sectors"] if sector["cut"])
    if alter == "column":
        cut["i"] += 1
    elif alter == "angle":
        m, e, r, f = cut["angle"].split()
        cut["angle"] = f"{int(m) + (int(m) >> 30)} {e} {r} {f}"
    elif alter == "branch points":
        found["totals"]["branch_points"] += 1
    elif alter == "cutoff":
        turns = Fraction(found["parameters"]["cutoff"][1])
        found["parameters"]["cutoff"][1] = str(turns * Fraction(99, 100))
    return found


def _evidence(wrong: list[str], left: list[str], *, shown: str, tried: int) -> Evidence:
    return Evidence(
        outcome="fail" if wrong else "undecided" if left else "pass",
        grade="certified",
        shown=shown,
        tried=tried,
        met=tried,
        witness="; ".join((wrong or left)[:3]),
    )


def made_anew(setting: Setting, *, alter: str = "") -> Evidence:
    """Whether runs in balls end, with sound certificates and the sectors of discrete.greedy.

    The first that does not ends the check.
    """
    del setting
    wrong: list[str] = []
    left: list[str] = []
    quads: list[int] = []
    for radius, step, sectors, cutoff in RUNS:
        told = f"R = {radius}, 2 m = {sectors}, phi* = {cutoff} pi"
        run = parameters(radius, step, sectors, cutoff)
        tree, floats = certified_tree(run), grown(run)
        if where := difference(tree, floats):
            wrong.append(f"{told}: discrete.greedy differs, {where}")
        if not abs(floats.area / run.area - 1) <= ROUNDING:
            wrong.append(f"{told}: the kept quads have another area than the disk")
        said = verdict(certificate(_altered(certificate_of(tree), alter)))
        wrong += [f"{told}: {said.wrong}"] if said.wrong else []
        left += [f"{told}: {said.open}"] if said.open else []
        quads.append(said.quads)
        if wrong:
            break
    return _evidence(
        wrong,
        left,
        shown=f"{len(quads)} runs end, with {sum(quads)} quads up to symmetry, every comparison "
        "by balls, and certificates that the checker accepts",
        tried=len(quads),
    )


def stored(setting: Setting, *, alter: str = "") -> Evidence:
    """Whether the stored certificates of the disk of radius 6 are sound."""
    del setting
    run = load("greedy_certificates")
    wrong = ["the stored run greedy_certificates is older than its sources"] if run.stale else []
    left: list[str] = []
    quads: list[int] = []
    for data in run.result["certificates"]:
        said = verdict(certificate(_altered(data, alter)))
        wrong += [said.wrong] if said.wrong else []
        left += [said.open] if said.open else []
        quads.append(said.quads)
        if wrong:
            break
    return _evidence(
        wrong,
        left,
        shown=f"{len(quads)} certificates of R = 6, edges 1/25: {sum(quads)} quads",
        tried=len(quads),
    )
