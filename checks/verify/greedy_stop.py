"""Largest angle that a sector keeps at its cut: how far below the cutoff, as the edges shrink."""

from fractions import Fraction
from math import pi

import numpy as np

from checks.evidence import Evidence, Setting
from checks.verify.findings import findings as found
from checks.verify.greedy_samples import tree_of

STEPS = ("1/25", "1/50", "1/100", "1/200")
#: Radius, initial sectors, cutoff: runs whose number of cuts is one for all edge lengths.
RUNS = (("4", "4", "3/4"), ("5", "8", "4/5"))


def stops_at_cutoff(setting: Setting, *, level: str = "1", least: int = 0) -> Evidence:
    """Whether phi* less the largest angle kept goes to 0 with order 1, in the mean over the cuts.

    level: of the cutoff, in units of phi*; least: generation of the sectors from which on they
    count.
    """
    del setting
    failures, told = [], []
    for radius, sectors, cutoff in RUNS:
        top = float(Fraction(cutoff) * Fraction(level)) * pi
        means = []
        for step in STEPS:
            tree = tree_of(radius, step, sectors, cutoff)
            rows = tree.sectors[tree.sectors["cut"] & (tree.sectors["generation"] >= least)]
            gaps = top - rows["largest"]
            means.append(float(np.average(gaps, weights=rows["copies"])))
        lengths = [float(Fraction(step)) for step in STEPS]
        if min(means) <= 0:
            failures.append(f"R = {radius}: kept angles exceed {level} phi* in the mean")
            continue
        order = float(np.polyfit(np.log(lengths), np.log(means), 1)[0])
        told.append(f"{order:.3f}")
        if abs(order - 1) > 0.1:
            means_told = ", ".join(f"{mean:.4f}" for mean in means)
            failures.append(f"R = {radius}, phi* = {cutoff} pi: gaps {means_told}")
    return found(failures, shown=f"orders {', '.join(told)} at four edge lengths", tried=len(RUNS))
