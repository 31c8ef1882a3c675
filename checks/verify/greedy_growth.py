"""Growth of energy, depth and number of branch points with the radius, from stored runs.

Energies are those of the limit of edge length 0; numbers and depths those of the nets.
"""

from fractions import Fraction
from math import log, pi, tan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from checks.evidence import Evidence, Setting
from checks.searches.greedy_runs import SETS
from checks.stored import load
from checks.verify.findings import findings as found
from checks.verify.greedy_samples import tree_of
from checks.verify.greedy_tree_shape import stale
from theory.greedy_limit import limit_path

Array = NDArray[np.float64]

#: Difference of AIC from which on a law counts as refuted by another (Burnham and Anderson).
DECISIVE = 10.0

#: Exponents among which the best is looked for.
POWERS = np.linspace(0.05, 1.5, 146)

#: Radius from which on all runs have branch points.
FIRST = 3


def energies(sectors: str, cutoff: str) -> tuple[Array, Array]:
    """Radii and log E_inf in the limit of edge length 0 (ebound)."""
    radii, logs = [], []
    for entry in load("greedy_limits").result["least"]:
        if (entry["initial"], entry["cutoff"]) == (sectors, cutoff) and entry["least"]:
            least = min(angle for angle, _, _ in entry["least"])
            level = float(Fraction(cutoff)) * pi
            radii.append(float(Fraction(entry["radius"])))
            logs.append(log(max(1 / tan(least / 2), tan(level / 2))))
    return np.array(radii), np.array(logs)


def limit_sets() -> tuple[tuple[str, str], ...]:
    """Initial sectors and cutoff of the stored limits."""
    entries = load("greedy_limits").result["least"]
    return tuple(dict.fromkeys((entry["initial"], entry["cutoff"]) for entry in entries))


def spread(radii: Array, values: Array, power: float) -> tuple[float, Array]:
    """Sum of squares left by the best a + c R^power, and (a, c)."""
    columns = np.stack([np.ones_like(radii), radii**power], axis=1)
    best: Array = np.asarray(np.linalg.lstsq(columns, values, rcond=None)[0], dtype=np.float64)
    return float(np.sum((values - columns @ best) ** 2)), best


def exponents(radii: Array, values: Array) -> tuple[float, float, float]:
    """Best power of a + c R^power, and the ends of its interval of two standard deviations."""
    left = np.array([spread(radii, values, power)[0] for power in POWERS])
    inside = POWERS[left < left.min() * (1 + 4 / (len(radii) - 3))]
    return float(POWERS[left.argmin()]), float(inside[0]), float(inside[-1])


def _again(failures: list[str]) -> None:
    """Two stored least angles of the limit recomputed along their paths with more nodes."""
    for entry in load("greedy_limits").result["least"]:
        if entry["radius"] not in ("6", "12"):
            continue
        angle, path, _ = min(entry["least"])
        level = float(Fraction(entry["cutoff"])) * pi
        phi0 = 2 * pi / int(entry["initial"])
        cuts = limit_path(float(entry["radius"]), phi0, level, path, nodes=64)
        if cuts[-1].path != path or abs(cuts[-1].angle / 3 / angle - 1) > 1e-7:
            failures.append(f"R = {entry['radius']}: {cuts[-1].angle / 3} against {angle}")


def _from(lowest: float, radii: Array, values: Array) -> tuple[Array, Array]:
    return radii[radii >= lowest], values[radii >= lowest]


def energy_law(
    setting: Setting, *, power: str = "1/2", lowest: int = FIRST, largest: int = 10
) -> Evidence:
    """Law log E = a + c R^power on the limit's energies, against R and against the best power.

    It passes if the law R is worse by the decisive difference of AIC on every set. It fails if the
    law is itself worse than the best power by as much on one, and its power lies outside the
    interval of the best on 8 <= R <= 16 too; else it is undecided.
    """
    del setting
    failures, told = stale("greedy_limits"), []
    _again(failures)
    better, tried = True, 0
    given = float(Fraction(power))
    for sectors, cutoff in limit_sets():
        radii, values = energies(sectors, cutoff)
        kept = (radii >= lowest) & (radii <= largest)
        radii, values = radii[kept], values[kept]
        tried += len(radii)
        best, low, high = exponents(radii, values)
        law, line, least = (spread(radii, values, p) for p in (given, 1.0, best))
        against = len(radii) * log(line[0] / law[0])
        short = len(radii) * log(law[0] / least[0]) - 2  # the best power is one number more
        better = better and against >= DECISIVE
        text = (
            f"2 m = {sectors}, phi* = {cutoff} pi, {lowest} <= R <= {largest}: best power "
            f"{best:.2f} ({low:.2f} to {high:.2f}), c = {law[1][1]:.2f}, AIC of R less that of "
            f"R^({power}) {against:.1f}, of R^({power}) less that of the best {short:.1f}"
        )
        told.append(text)
        far = exponents(*_from(8.0, *energies(sectors, cutoff)))
        told[-1] += (
            f"; on 8 <= R <= 16 the best power is {far[0]:.2f} ({far[1]:.2f} to {far[2]:.2f})"
        )
        if short >= DECISIVE and not far[1] <= given <= far[2]:
            failures.append(text)
    if failures or better:
        return found(failures, shown="; ".join(told), tried=tried)
    return Evidence(
        outcome="undecided", grade="experiment", shown="; ".join(told), tried=tried, met=tried
    )


def sub_exponential(setting: Setting, *, rival: str = "1") -> Evidence:
    """Whether the likely powers in log E = a + c R^power are below the rival, 1 for exp(c R).

    On the limit's energies with 3 <= R <= 16 and with 8 <= R <= 16, two standard deviations about
    the best power; no word on larger R.
    """
    del setting
    failures, told, tried = stale("greedy_limits"), [], 0
    _again(failures)
    for sectors, cutoff in limit_sets():
        for lowest in (FIRST, 8):
            radii, values = _from(float(lowest), *energies(sectors, cutoff))
            best, low, high = exponents(radii, values)
            tried += len(radii)
            told.append(
                f"2 m = {sectors}, phi* = {cutoff} pi, {lowest} <= R <= 16: {best:.2f} "
                f"({low:.2f} to {high:.2f})"
            )
            if not high < float(Fraction(rival)):
                failures.append(told[-1])
    return found(failures, shown=f"best powers: {'; '.join(told)}", tried=tried)


def _finest(sectors: str, cutoff: str) -> dict[str, dict[str, Any]]:
    """Run of the smallest step for each radius."""
    best: dict[str, dict[str, Any]] = {}
    for run in load("greedy_runs").result["runs"]:
        if (run["initial"], run["cutoff"]) != (sectors, cutoff):
            continue
        known = best.get(run["radius"])
        if known is None or Fraction(run["step"]) < Fraction(known["step"]):
            best[run["radius"]] = run
    return best


def _series(sectors: str, cutoff: str, name: str, lowest: float) -> tuple[Array, Array]:
    runs = _finest(sectors, cutoff)
    radii = sorted(Fraction(radius) for radius in runs if Fraction(radius) >= lowest)
    return (
        np.array([float(radius) for radius in radii]),
        np.array([float(runs[str(radius)][name]) for radius in radii]),
    )


def _made_again(failures: list[str]) -> None:
    """Stored numbers and depths of radius 7 against runs made now."""
    for sectors, cutoff in SETS:
        run = _finest(sectors, cutoff)["7"]
        tree = tree_of("7", run["step"], sectors, cutoff)
        if (tree.branch_point_count, tree.generations) != (
            run["branch_points"],
            run["generations"],
        ):
            failures.append(f"R = 7, 2 m = {sectors}: {tree.branch_point_count} branch points")


def number_law(
    setting: Setting, *, rate: str = "1", factor: str = "1", power: str = "1/2", lowest: int = 8
) -> Evidence:
    """Whether log N - (rate R - factor R^power) is without trend on R >= lowest, N branch points.

    A trend is a slope of more than 0.03 in R, a third of the least that a near mutant leaves.
    """
    del setting
    failures, told, tried = stale("greedy_runs"), [], 0
    _made_again(failures)
    for sectors, cutoff in SETS:
        radii, number = _series(sectors, cutoff, "branch_points", lowest)
        law = float(Fraction(rate)) * radii
        law -= float(Fraction(factor)) * radii ** float(Fraction(power))
        left = np.log(number) - law
        slope = float(np.polyfit(radii, left, 1)[0])
        tried += len(radii)
        told.append(f"{slope:+.3f}")
        if abs(slope) > 0.03:
            failures.append(
                f"2 m = {sectors}, phi* = {cutoff} pi: N over the law grows from "
                f"{np.exp(left[0]):.3g} at R = {radii[0]:g} to {np.exp(left[-1]):.3g} at "
                f"R = {radii[-1]:g}"
            )
    return found(failures, shown=f"slopes of log N less the law: {', '.join(told)}", tried=tried)
