"""Radii at which the generations of branch points first appear, and laws of the cut depth on them.

The depth is a whole number; these radii, found by bisection on runs, show its growth between the
steps. The law of a depth that is rounded is looked for within half a generation.
"""

from fractions import Fraction
from functools import cache

import numpy as np
from numpy.typing import NDArray

from checks.evidence import Evidence, Setting
from checks.searches.greedy_runs import SETS
from checks.verify.findings import findings as found
from checks.verify.greedy_samples import tree_of
from checks.verify.greedy_tree_shape import limit_cuts, stale

Array = NDArray[np.float64]

STEP = "1/25"
LARGEST = 10
#: The cutoff pi/2 makes many more cuts.
LARGEST_RIGHT_ANGLE = 9
#: Width to which the radii are bisected.
FINE = Fraction(1, 16)
#: Difference from a law that rounding to the nearest generation makes.
ROUNDING = 0.5


def depth(radius: Fraction, sectors: str, cutoff: str) -> int:
    """Number of generations of a run."""
    return tree_of(str(radius), STEP, sectors, cutoff, 4 * 10**6).generations


@cache
def first_radii(sectors: str, cutoff: str) -> tuple[float, ...]:
    """Radius at which each generation appears, from the first on, within FINE/2."""
    top = LARGEST_RIGHT_ANGLE if cutoff == "1/2" else LARGEST
    radii: list[float] = []
    low, number = Fraction(1), depth(Fraction(1), sectors, cutoff)
    while low < top:
        high = low + Fraction(1, 2)
        reached = depth(high, sectors, cutoff)
        for generation in range(number + 1, reached + 1):
            below, above = low, high
            while above - below > FINE:
                middle = (below + above) / 2
                if depth(middle, sectors, cutoff) >= generation:
                    above = middle
                else:
                    below = middle
            radii.append(float((below + above) / 2))
        low, number = high, max(number, reached)
    return tuple(radii)


def _samples(lowest: int) -> list[tuple[str, Array, Array]]:
    """Name, radii and numbers of the generations of each set of runs, from this radius on."""
    found_samples = []
    for sectors, cutoff in SETS:
        radii: Array = np.array(first_radii(sectors, cutoff))
        number: Array = np.arange(1, len(radii) + 1, dtype=np.float64)
        kept = radii >= lowest
        found_samples.append((f"2 m = {sectors}, phi* = {cutoff} pi", radii[kept], number[kept]))
    return found_samples


def _limit_agrees() -> list[str]:
    """Complaints where the depth of a stored tree of the limit is not that read off the radii.

    A cut sits at a node: a generation may appear two edge lengths earlier or later in the limit.
    """
    play = 2 * float(Fraction(STEP)) + float(FINE)
    failures = stale("greedy_limits")
    for sectors, cutoff in SETS[:2]:
        radii = np.array(first_radii(sectors, cutoff))
        for half in range(4, 15):
            radius = Fraction(half, 2)
            paths = [path for path, *_ in limit_cuts(str(radius), sectors, cutoff)]
            deepest = max((len(path) + 1 for path in paths), default=0)
            least, most = (int((radii <= float(radius) + d).sum()) for d in (-play, play))
            if not least <= deepest <= most:
                failures.append(f"2 m = {sectors}, R = {radius}: depth {deepest} in the limit")
    return failures


def law(setting: Setting, *, power: str = "1", less: str = "0", lowest: int = 3) -> Evidence:
    """Whether each generation appears within half a one of a + b (R^power - less sqrt R).

    b > 0; lowest: radius from which on the generations count.
    """
    del setting
    failures, told, tried = _limit_agrees(), [], 0
    for name, radii, number in _samples(lowest):
        law_at = radii ** float(Fraction(power)) - float(Fraction(less)) * np.sqrt(radii)
        slope, start = np.polyfit(law_at, number, 1)
        worst = float(np.abs(number - start - slope * law_at).max())
        tried += len(radii)
        told.append(f"{start:.2f} + {slope:.3f} x within {worst:.2f}")
        if not worst < ROUNDING or slope <= 0:
            failures.append(f"{name}: missed by {worst:.2f} generations")
    return found(
        failures,
        shown=f"n at the radii where the generations appear, R <= {LARGEST}: {'; '.join(told)}",
        tried=tried,
    )


def root_law(setting: Setting, *, power: str = "1", less: str = "1", lowest: int = 1) -> Evidence:
    """The law a + b (R - sqrt R), from the first generation on."""
    return law(setting, power=power, less=less, lowest=lowest)


def slope_grows(setting: Setting, *, sense: int = 1, bend: str = "0") -> Evidence:
    """Whether the slope of n against R grows (sense 1) or falls (-1), by the term in R^2 of a fit.

    Undecided within two standard deviations of 0; bend: what is taken off that term.
    """
    del setting
    failures, told, sure, tried = [], [], True, 0
    for name, radii, number in _samples(1):
        best, spread = np.polyfit(radii, number, 2, cov=True)
        term, error = float(best[0]) - float(Fraction(bend)), float(np.sqrt(spread[0, 0]))
        ends = [float(2 * best[0] * at + best[1]) for at in (radii[0], radii[-1])]
        tried += len(radii)
        told.append(f"{term:.3f} +- {error:.3f} (slope {ends[0]:.2f} to {ends[1]:.2f})")
        sure = sure and sense * term > 2 * error
        if sense * term < -2 * error:
            failures.append(f"{name}: {told[-1]}")
    shown = f"terms in R^2 of the cut depth: {', '.join(told)}"
    if failures or sure:
        return found(failures, shown=shown, tried=tried)
    return Evidence(outcome="undecided", grade="experiment", shown=shown, tried=tried, met=tried)
