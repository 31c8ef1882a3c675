"""The three curves of (fig:energywithradius): bobbins, one branch point, distributed branch points.

Energies of runs of the greedy algorithm are those of the finest stored nets, and of the limit of
edge length 0; of the rivals, closed forms and balls.
"""

from fractions import Fraction
from functools import cache
from itertools import pairwise
from math import inf, log, tan
from typing import Any

import numpy as np
import sympy as sp
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from checks.evidence import Evidence, Setting
from checks.searches.greedy_runs import SETS
from checks.stored import load
from checks.verify.findings import findings as found
from checks.verify.greedy_growth import energies, limit_sets
from checks.verify.greedy_tree_shape import stale
from theory import bobbin, bobbin_values, periodic_amsler
from theory.errors import SingularEdgeError

#: Largest radius of the figure.
LARGEST = 10


def finest(sectors: str, cutoff: str) -> dict[Fraction, dict[str, Any]]:
    """Stored run of the smallest edge length for each radius up to the figure's largest."""
    best: dict[Fraction, dict[str, Any]] = {}
    for run in load("greedy_runs").result["runs"]:
        radius = Fraction(run["radius"])
        if (run["initial"], run["cutoff"]) != (sectors, cutoff) or radius > LARGEST:
            continue
        known = best.get(radius)
        if known is None or Fraction(run["step"]) < Fraction(known["step"]):
            best[radius] = run
    return best


def run_energy(run: dict[str, Any]) -> float:
    """E_inf of a stored run (ebound)."""
    return max(1 / tan(run["min_angle"] / 2), tan(run["max_angle"] / 2))


@cache
def rival_energy(name: str, radius: Fraction) -> float:
    """E_inf of the best bobbin, or of the best periodic Amsler surface, on the disk."""
    if name == "bobbin":
        return float(bobbin_values.least_max_curvature(radius).ball().mid())
    return float(periodic_amsler.max_curvature(radius).ball().mid())


def _rows(lowest: Fraction) -> list[tuple[str, list[Fraction], list[float]]]:
    """Name, radii and energies of each set of runs from this radius on: nets, then the limit."""
    rows = []
    for sectors, cutoff in SETS:
        runs = finest(sectors, cutoff)
        radii = sorted(radius for radius in runs if radius >= lowest)
        name = f"2 m = {sectors}, phi* = {cutoff} pi"
        rows.append((name, radii, [run_energy(runs[radius]) for radius in radii]))
    for sectors, cutoff in limit_sets():
        numbers, logs = energies(sectors, cutoff)
        kept = (numbers >= float(lowest)) & (numbers <= LARGEST)
        limit_radii = [Fraction(int(number)) for number in numbers[kept]]
        rows.append((f"limit of 2 m = {sectors}", limit_radii, np.exp(logs[kept]).tolist()))
    return rows


def below(
    setting: Setting, *, rival: str = "bobbin", lowest: str = "3", factor: str = "1"
) -> Evidence:
    """Whether every run is below the rival from this radius on, and falls behind with each unit.

    rival: `bobbin` or `amsler`; factor: of the energy of the runs.
    """
    del setting
    failures, told, tried = stale("greedy_runs", "greedy_limits"), [], 0
    for name, radii, values in _rows(Fraction(lowest)):
        quotients = {
            radius: rival_energy(rival, radius) / (float(Fraction(factor)) * value)
            for radius, value in zip(radii, values, strict=True)
        }
        whole = [quotients[radius] for radius in radii if radius.denominator == 1]
        tried += len(radii)
        told.append(f"{whole[0]:.2f} to {whole[-1]:.3g}")
        short = [radius for radius in radii if not quotients[radius] > 1]
        if short:
            failures.append(f"{name}: {quotients[short[0]]:.3f} times as much at R = {short[0]}")
        if not all(b > a for a, b in pairwise(whole)):
            failures.append(f"{name}: the quotient does not grow with R")
    return found(
        failures,
        shown=f"E_inf of {rival} over that of the runs, R = {lowest} to {LARGEST}: "
        f"{', '.join(told)}",
        tried=tried,
    )


def below_amsler(setting: Setting, *, lowest: str = "9/2", factor: str = "1") -> Evidence:
    """The same against one branch point at the centre."""
    return below(setting, rival="amsler", lowest=lowest, factor=factor)


def star_energy(radius: Fraction, sectors: str) -> float:
    """E_inf of the initial star without any cut: infinite where it reaches the singular edge."""
    try:
        return float(periodic_amsler.max_curvature(radius, int(sectors)).ball().mid())
    except SingularEdgeError:
        return inf


def cuts_help(setting: Setting, *, lowest: str = "3", factor: str = "1") -> Evidence:
    """Whether each run has less E_inf than its initial star without cuts, from this radius on.

    factor: of the energy of the runs.
    """
    del setting
    failures, tried, finite = stale("greedy_runs"), 0, []
    for sectors, cutoff in SETS:
        runs = finest(sectors, cutoff)
        for radius in sorted(radius for radius in runs if radius >= Fraction(lowest)):
            star, value = star_energy(radius, sectors), run_energy(runs[radius])
            tried += 1
            if star < inf:
                finite.append(f"{star:.3g} and {value:.3g} (R = {radius}, 2 m = {sectors})")
            if not float(Fraction(factor)) * value < star:
                failures.append(
                    f"2 m = {sectors}, phi* = {cutoff} pi, R = {radius}: {value:.3f} with cuts, "
                    f"{star:.3f} without"
                )
    return found(
        failures,
        shown=f"{tried} runs; finite energies of stars and of runs: {', '.join(finite) or 'none'}, "
        "the other stars reach their singular edge",
        tried=tried,
    )


def least_bobbin_bending(radius: Fraction) -> float:
    """Least integral of kappa1^2 + kappa2^2 on the disk about a point of the throat, over kappa."""
    squares = sum(bobbin.squared_curvatures())
    density = sp.lambdify((bobbin.KAPPA, bobbin.S), squares, "math")
    size = float(radius)

    def bending(excess: float) -> float:
        kappa = np.sinh(size) * (1 + np.exp(excess))

        def across(s: float) -> float:
            half = np.arccosh(max(1.0, np.cosh(size) / np.cosh(s)))
            return float(4 * half * np.cosh(s) * density(kappa, s))

        return float(quad(across, 0, size, limit=200)[0])

    return float(minimize_scalar(bending, bounds=(-8, 3), method="bounded").fun)


def frilly_bends_less(setting: Setting, *, lowest: str = "5/2", factor: str = "1") -> Evidence:
    """Whether runs have less bending energy than every centred bobbin, R from here up to 4.

    factor: of the bending energy of the runs.
    """
    del setting
    failures, told, tried = stale("greedy_runs"), [], 0
    for half in range(int(2 * Fraction(lowest)), 9):
        radius = Fraction(half, 2)
        smooth = least_bobbin_bending(radius)
        for sectors, cutoff in SETS:
            value = finest(sectors, cutoff)[radius]["willmore"] * float(Fraction(factor))
            tried += 1
            if not value < smooth:
                failures.append(
                    f"2 m = {sectors}, phi* = {cutoff} pi, R = {radius}: {value:.1f} against "
                    f"{smooth:.1f}"
                )
        told.append(f"log {log(smooth):.2f} at R = {radius}")
    return found(
        failures,
        shown=f"all runs are below the best bobbin: {', '.join(told)}",
        tried=tried,
    )
