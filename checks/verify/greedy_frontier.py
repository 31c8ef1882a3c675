"""Observations on the scatter plots phi_(n+1)/phi_n against alpha_n^2 (fig:frontier), counted."""

from collections.abc import Iterator
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray
from scipy.special import i0

from checks.evidence import Evidence, Setting
from checks.printed import cut_scaling as printed
from checks.verify.findings import findings as found
from checks.verify.greedy_samples import OTHERS, PANELS, Array, Cuts, cuts_of, inverse_i0
from theory import bessel

STEPS = ("1/25", "1/50", "1/100")

#: Interval of alpha_n^2 on which the plots have points of both families, cut into bins.
BINS = np.array([0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0])

#: More runs with a thousand branch points or more, phi* from pi/2 on.
MANY = (
    ("7", "4", "3/5"),
    ("8", "6", "2/3"),
    ("9", "12", "2/3"),
    ("8", "12", "1/2"),
    ("8", "8", "1/2"),
)

#: Points of a bin that make it count.
FEWEST = 20


def alpha_squared(cuts: Cuts) -> Array:
    """alpha_n^2 of each cut, s_n from the branch point at the corner of the sector that is cut."""
    x = inverse_i0(cuts.level / cuts.opening)
    return np.asarray(printed.alpha_squared(x, cuts.distance))


def samples(others: bool = True) -> Iterator[tuple[str, Cuts]]:
    """The panels on three edge lengths, and more runs on one."""
    for panel, key in PANELS.items():
        for step in STEPS:
            yield f"panel ({panel}), step {step}", cuts_of(key[0], step, *key[1:])
    for radius, sectors, cutoff in OTHERS if others else ():
        yield (
            f"R = {radius}, 2 m = {sectors}, phi* = {cutoff} pi",
            cuts_of(radius, "1/50", sectors, cutoff),
        )


def amsler_curve(cuts: Cuts, share: str, inside: str) -> Array:
    """Curve f_1 at alpha_n."""
    return np.asarray(
        printed.curve(np.sqrt(alpha_squared(cuts)), i0, share=share, inside=inside), dtype=float
    )


def general_bound(cuts: Cuts, factor: str, drop: int) -> Array:
    """Larger of 1/3 and f_2 at alpha_n."""
    star = float(bessel.supporting_scale().ball().mid())
    quadratic = printed.quadratic(np.sqrt(alpha_squared(cuts)), star, factor=factor)
    kept, growth = printed.kept_share(quadratic, drop=drop)
    return np.asarray(np.maximum(float(kept), growth), dtype=float)


def _judged(family: str, below: Iterator[tuple[str, Cuts, Array]]) -> Evidence:
    """Cuts of the family below a bound: failure if there are any."""
    failures: list[str] = []
    tried, least, where = 0, np.inf, ""
    for name, cuts, bound in below:
        kept = cuts.amsler if family == "amsler" else ~cuts.amsler
        if family == "all":
            kept = np.ones_like(kept)
        tried += int(cuts.weight[kept].sum())
        quotient = cuts.ratio / bound
        worst = int(np.argmin(np.where(kept, quotient, np.inf)))
        if quotient[worst] < least:
            least, where = float(quotient[worst]), name
        under = kept & (quotient < 1)
        if under.any():
            failures.append(
                f"{name}: {int(cuts.weight[under].sum())} of {int(cuts.weight[kept].sum())} below, "
                f"path {cuts.path[worst]!r}, ratio {cuts.ratio[worst]:.4f} < {bound[worst]:.4f} at "
                f"alpha^2 = {alpha_squared(cuts)[worst]:.4f}"
            )
    return found(
        failures,
        shown=f"none of {tried} nodes is below the bound; the least quotient is {least:.4f} "
        f"({where})",
        tried=tried,
    )


def amsler_nodes(
    setting: Setting, *, share: str = "1/3", inside: str = "2", family: str = "amsler"
) -> Evidence:
    """Whether every Amsler node is on or above f_1."""
    del setting
    return _judged(
        family, ((name, cuts, amsler_curve(cuts, share, inside)) for name, cuts in samples())
    )


def pseudo_amsler_nodes(setting: Setting, *, factor: str = "1", drop: int = 3) -> Evidence:
    """Whether every pseudo-Amsler node is on or above max(1/3, f_2)."""
    del setting
    return _judged(
        "pseudo", ((name, cuts, general_bound(cuts, factor, drop)) for name, cuts in samples())
    )


def violations(setting: Setting, *, family: str = "pseudo", least: str = "0") -> Evidence:
    """Whether more than this share of the nodes of a family lies below f_1, in every run."""
    del setting
    failures, told, tried = [], [], 0
    for name, cuts in samples():
        kept = cuts.amsler if family == "amsler" else ~cuts.amsler
        under = kept & (cuts.ratio < amsler_curve(cuts, "1/3", "2"))
        share = cuts.weight[under].sum() / cuts.weight[kept].sum()
        tried += int(cuts.weight[kept].sum())
        told.append(f"{100 * share:.0f}")
        if not share > float(Fraction(least)):
            failures.append(f"{name}: {100 * share:.1f} % of the {family} nodes are below")
    return found(
        failures,
        shown=f"{', '.join(told)} % of the pseudo-Amsler nodes of the runs are below f_1",
        tried=tried,
    )


def figure(setting: Setting, *, panel: str = "", factor: str = "1", share: str = "1/3") -> Evidence:
    """Whether on the three panels Amsler nodes are above f_1 and all nodes above max(1/3, f_2).

    panel: `b only` leaves out two of them; factor: of f_2; share: the factor of f_1.
    """
    del setting
    chosen = [pair for pair in samples(False) if panel != "b only" or "(b)" in pair[0]]
    if len(chosen) != len(PANELS) * len(STEPS):
        return found([f"{len(chosen)} plots only"], shown="", tried=len(chosen))
    first = _judged("amsler", ((n, cuts, amsler_curve(cuts, share, "2")) for n, cuts in chosen))
    second = _judged("all", ((n, cuts, general_bound(cuts, factor, 3)) for n, cuts in chosen))
    failures = [one.witness for one in (first, second) if one.witness]
    return found(failures, shown=f"{first.shown}; {second.shown}", tried=second.tried)


def medians(cuts: Cuts, amsler: bool) -> dict[int, float]:
    """Median of phi_(n+1)/phi_n over the bins of alpha_n^2, for one family."""
    places = np.digitize(alpha_squared(cuts), BINS)
    found_medians = {}
    for place in range(1, len(BINS)):
        kept = (places == place) & (cuts.amsler == amsler)
        if cuts.weight[kept].sum() >= FEWEST:
            values = np.repeat(cuts.ratio[kept], cuts.weight[kept])
            found_medians[place] = float(np.median(values))
    return found_medians


def plots_agree(
    setting: Setting, *, tolerance: str = "1/4", shifted: str = "1", cutoffs: str = "all"
) -> Evidence:
    """Whether the medians of the pseudo-Amsler nodes agree on the panels, bin by bin.

    tolerance: of the relative spread; shifted: factor of the values of panel (c); cutoffs: `large`
    leaves out the runs with phi* = pi/2. Runs with a thousand branch points or more.
    """
    del setting
    known = {
        panel: medians(cuts_of(key[0], "1/50", *key[1:]), amsler=False)
        for panel, key in PANELS.items()
    }
    for key in MANY:
        if cutoffs == "all" or key[2] != "1/2":
            name = f"R = {key[0]}, 2 m = {key[1]}, phi* = {key[2]} pi"
            known[name] = medians(cuts_of(key[0], "1/50", *key[1:]), amsler=False)
    known["c"] = {place: value * float(Fraction(shifted)) for place, value in known["c"].items()}
    failures, told, tried = [], [], 0
    for place in range(1, len(BINS)):
        values = [table[place] for table in known.values() if place in table]
        if len(values) < 2:
            continue
        tried += 1
        spread = max(values) / min(values) - 1
        told.append(f"{100 * spread:.0f}")
        if spread > float(Fraction(tolerance)):
            failures.append(
                f"alpha^2 from {BINS[place - 1]} to {BINS[place]}: medians "
                f"{', '.join(f'{value:.3f}' for value in values)}"
            )
    return found(
        failures,
        shown=f"medians of the runs differ by {', '.join(told)} % in {tried} bins",
        tried=tried,
    )


def gap_of(cuts: Cuts, least: float) -> tuple[float, float]:
    """Least quotient ratio/f_1 of Amsler nodes, largest of others, where alpha_n^2 >= least."""
    quotient: NDArray[np.float64] = cuts.ratio / amsler_curve(cuts, "1/3", "2")
    far = alpha_squared(cuts) >= least
    amsler, other = quotient[far & cuts.amsler], quotient[far & ~cuts.amsler]
    return (
        float(amsler.min()) if len(amsler) else np.inf,
        float(other.max()) if len(other) else 0.0,
    )


def two_families(setting: Setting, *, marked: str = "geodesics", least: str = "5/4") -> Evidence:
    """Whether the families lie apart for alpha_n^2 >= least: each Amsler node above all others.

    Above means the quotient by f_1. marked: `diagonals` counts as Amsler only those on diagonals.
    """
    del setting
    failures, told, tried = [], [], 0
    for name, cuts in samples():
        if marked == "diagonals":
            on = np.array([set(path) <= {"A"} for path in cuts.path])
            cuts = Cuts(**{**vars(cuts), "amsler": on})
        low, high = gap_of(cuts, float(Fraction(least)))
        if low == np.inf:  # no Amsler node there
            continue
        tried += int(cuts.weight.sum())
        told.append(f"{low:.2f}/{high:.2f}")
        if not low > high:
            failures.append(f"{name}: least {low:.3f}, largest of the others {high:.3f}")
    if not told:
        failures.append(f"no run has Amsler nodes with alpha_n^2 >= {least}")
    return found(
        failures,
        shown=f"least quotient of Amsler nodes and largest of the others: {', '.join(told)}",
        tried=tried,
    )
