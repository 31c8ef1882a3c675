"""Runs of the printed greedy algorithm that its checks share, and what they say in common."""

import math
from fractions import Fraction
from functools import cache, partial
from typing import Any

import numpy as np

from checks.printed.greedy_algorithm import PrintedParameters, PrintedRun, printed_run
from checks.printed.greedy_reading import VARIANTS
from checks.printed.greedy_sector import Node, PrintedSector
from checks.verify.findings import findings

#: Radius, number of initial sectors, cutoff in half turns, edge length.
Case = tuple[str, int, str, str]
CASES: tuple[Case, ...] = (("3", 4, "3/4", "1/10"), ("3", 8, "4/5", "1/10"))

#: Most cuts of a run; those of CASES that end have 16 and 8.
MOST = 40


def parameters_of(case: Case, *, level: str = "1", nodes: int = 0) -> PrintedParameters:
    """Parameters of a case; level: in units of its cutoff."""
    radius, sectors, cutoff, step = case
    return PrintedParameters(
        radius=float(Fraction(radius)),
        sectors=sectors,
        cutoff=float(Fraction(cutoff) * Fraction(level)) * math.pi,
        step=float(Fraction(step)),
        nodes=nodes,
    )


@cache
def run_of(case: Case, variant: str, *, most: int = MOST, nodes: int = 0) -> PrintedRun:
    """Run of a case under a named variant of (alg:greedy-cuts)."""
    return printed_run(parameters_of(case, nodes=nodes), VARIANTS[variant], max_cuts=most)


def cut_sectors(run: PrintedRun) -> list[tuple[PrintedSector, Node, list[PrintedSector]]]:
    """Sectors that were cut, each with (j*, k*) and its three daughters u, A, v."""
    return [
        (sector, sector.cut, [other for other in run.sectors if other.parent == n])
        for n, sector in enumerate(run.sectors)
        if sector.cut is not None
    ]


def node(sector: PrintedSector, j: int, k: int) -> complex:
    """Node zeta_{j,k} as a complex number."""
    return complex(sector.zeta[0, j, k], sector.zeta[1, j, k])


def seen_from(centre: complex, z: Any) -> Any:
    """Places of points when the translation that carries `centre` to 0 is applied."""
    return (z - centre) / (1 - np.conj(centre) * z)


def place_of(centre: complex, w: Any) -> Any:
    """Places of points seen from `centre`."""
    return (w + centre) / (1 + np.conj(centre) * w)


#: Evidence at sampled parameters.
found = partial(findings, grade="numeric")
