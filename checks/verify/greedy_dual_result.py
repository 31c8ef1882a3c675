"""Section 4.1, items 1 and 6: sectors, least angles and depths of runs against g.

The runs meet m >= 6, phi* <= pi/2. g is fixed by m_0, the order that one branch point needs, which
can be read in two ways: `edge`, that phi < pi in the disk, or `cutoff`, that phi <= phi* there as
the greedy algorithm has it. Corrected forms have n in place of g, the generations of the run.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from math import pi

from checks.evidence import Evidence, Setting
from checks.printed import greedy_dual as printed
from checks.verify.findings import findings as found
from checks.verify.greedy_dual_saddle_order import least_order
from checks.verify.greedy_samples import tree_of
from discrete.greedy_tree import GreedyTree

#: Numbers of initial sectors and cutoffs in half turns.
SETS = (("12", "1/2"), ("12", "2/5"), ("16", "1/2"))
RADII = tuple(str(radius) for radius in range(3, 8))
STEPS = ("1/50", "1/100")


@dataclass(frozen=True, kw_only=True)
class Case:
    """A run with its name, m, its radius, and phi* in units of pi."""

    name: str
    half: int
    radius: str
    cutoff: str
    tree: GreedyTree

    def exponent(self, by: str) -> int:
        """The exponent g for m_0 by `edge` or `cutoff`; by `n`, the generations of the run."""
        if by == "n":
            return self.tree.generations
        return generations_expected(self.radius, self.half, "1" if by == "edge" else self.cutoff)


@cache
def generations_expected(radius: str, half: int, level: str = "1") -> int:
    """The g of item (1), 3^(g-1) m < m_0 <= 3^g m, where m_0 keeps phi below level pi."""
    needed = least_order(Fraction(radius), Fraction(level))
    return next(g for g in range(-3, 20) if printed.is_generations(g, half, needed))


def cases() -> Iterator[Case]:
    """All runs whose cuts the edges resolve."""
    for sectors, cutoff in SETS:
        half = int(sectors) // 2
        for radius in RADII:
            for step in STEPS:
                tree = tree_of(radius, step, sectors, cutoff)
                if tree.terminated and not tree.unresolved_cuts:
                    yield Case(
                        name=f"R = {radius}, m = {half}, phi* = {cutoff} pi, edges {step}",
                        half=half,
                        radius=radius,
                        cutoff=cutoff,
                        tree=tree,
                    )


def _told(by: str) -> str:
    return "n" if by == "n" else "g"


def _cuts(tree: GreedyTree) -> int:
    return int(tree.sectors["copies"][tree.sectors["cut"]].sum())


def sectors(
    setting: Setting, *, by: str = "cutoff", count: str = "uncut", shift: int = 0
) -> Evidence:
    """Whether the number of sectors is at most 2 3^(exponent + shift) m.

    by: which exponent; count: all as in step 24, or those that were never cut.
    """
    del setting
    failures, tried = [], 0
    for case in cases():
        tried += 1
        exponent = case.exponent(by)
        number = case.tree.sector_count - (_cuts(case.tree) if count == "uncut" else 0)
        bound = printed.most_sectors(exponent + shift, case.half)
        if number > bound:
            failures.append(
                f"{case.name}: {number} sectors, {_told(by)} = {exponent}, bound {bound}"
            )
    return found(failures, shown=f"{tried} runs", tried=tried)


def least_angle(setting: Setting, *, by: str = "cutoff", shift: int = 0) -> Evidence:
    """Whether the least angle is at least 3^-(exponent + shift) pi/m."""
    del setting
    failures, tried = [], 0
    for case in cases():
        tried += 1
        exponent = case.exponent(by) + shift
        bound = float(printed.least_angle(exponent, case.half, pi))
        if case.tree.min_angle < bound * (1 - 1e-12):
            failures.append(
                f"{case.name}: an angle of {case.tree.min_angle:.5f}, {_told(by)} = "
                f"{case.exponent(by)}, bound {bound:.5f}"
            )
    return found(failures, shown=f"{tried} runs", tried=tried)


def branch_points(setting: Setting, *, by: str = "cutoff", shift: int = 0) -> Evidence:
    """Whether there are no more than the m (3^exponent - 1) branch points that move outward."""
    del setting
    failures, tried = [], 0
    for case in cases():
        tried += 1
        exponent = case.exponent(by) + shift
        most = case.half * (Fraction(3) ** exponent - 1)
        if _cuts(case.tree) > most:
            failures.append(
                f"{case.name}: {_cuts(case.tree)} branch points beside the origin, {_told(by)} = "
                f"{case.exponent(by)}, at most {most} move"
            )
    return found(failures, shown=f"{tried} runs", tried=tried)


def depth(setting: Setting, *, by: str = "cutoff", more: int = 0, exactly: bool = True) -> Evidence:
    """Whether each run has g + more generations; exactly: or else at least as many."""
    del setting
    failures, tried = [], 0
    for case in cases():
        tried += 1
        n, wanted = case.tree.generations, case.exponent(by) + more
        if n < wanted or (exactly and n != wanted):
            failures.append(f"{case.name}: {n} generations, g = {case.exponent(by)}")
    return found(failures, shown=f"{tried} runs", tried=tried)


def energy(setting: Setting, *, constant: str = "11/10") -> Evidence:
    """Whether E_inf < constant 3^g m on the runs; g by `edge`, the smaller of the two."""
    del setting
    failures, tried, largest = [], 0, 0.0
    for case in cases():
        tried += 1
        ratio = case.tree.max_curvature / (3.0 ** case.exponent("edge") * case.half)
        largest = max(largest, ratio)
        if ratio >= float(Fraction(constant)):
            failures.append(f"{case.name}: E_inf = {ratio:.4f} 3^g m")
    return found(failures, shown=f"{tried} runs, at most {largest:.3f} 3^g m", tried=tried)


def ends(setting: Setting, *, most: int = 10**6, radii: int = len(RADII)) -> Evidence:
    """Whether the runs end, each within so many cuts; radii: how many of RADII."""
    del setting
    failures, tried = [], 0
    for sectors_, cutoff in SETS:
        for radius in RADII[:radii]:
            tried += 1
            tree = tree_of(radius, "1/50", sectors_, cutoff, most)
            if not tree.terminated or abs(tree.area / tree.parameters.area - 1) > 1e-9:
                failures.append(f"R = {radius}, 2 m = {sectors_}: not over after {most} cuts")
    return found(failures, shown=f"{tried} runs end and cover the disk", tried=tried)
