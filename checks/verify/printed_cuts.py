"""Steps 11 to 15, 24 and 25 of the printed greedy algorithm: the choice, the cut, the end."""

import math
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np

from checks.evidence import Evidence, Setting
from checks.printed.disk_net import filled_disk
from checks.printed.greedy_algorithm import PrintedRun, printed_run
from checks.printed.greedy_reading import VARIANTS
from checks.printed.greedy_sector import (
    cut_of,
    inside,
    printed_sector,
    too_wide,
)
from checks.verify.greedy_samples import tree_of
from checks.verify.printed_runs import (
    CASES,
    MOST,
    Case,
    cut_sectors,
    found,
    parameters_of,
    run_of,
)


@cache
def shipped_cuts(case: Case) -> dict[str, tuple[int, int]]:
    """Columns i* and rows k* by path below the first initial sector, of discrete.greedy.

    A sector between two geodesics is its own mirror image; another stands for its image too.
    """
    radius, sectors, cutoff, step = case
    tree = tree_of(radius, step, str(sectors), cutoff)
    swap = str.maketrans("uv", "vu")
    cuts = {}
    for row, path in zip(tree.sectors, tree.paths, strict=True):
        if row["cut"]:
            cut = (int(row["i_cut"]), int(row["k_cut"]))
            cuts[path] = cut
            cuts[path.translate(swap)] = cut if row["mirrored"] else cut[::-1]
    return cuts


def order_of_choice(setting: Setting, *, most: int = MOST, variant: str = "meant") -> Evidence:
    """Whether the cuts are the same when the first, the last or any sector is chosen in step 11."""
    failures, tried = [], 0
    random = setting.random()
    for case in CASES:
        results = []
        for choice in (min, max, random.choice):
            run = printed_run(parameters_of(case), VARIANTS[variant], max_cuts=most, choice=choice)
            results.append({sector.path: sector.cut for sector in run.sectors})
            tried += 1
        if any(result != results[0] for result in results):
            failures.append(f"R = {case[0]}, M = {case[1]}: the sectors depend on the order")
    return found(failures, shown="first, last and random sector", tried=tried)


def _cut_by_definition(angles: Any, level: float, *, axis: int, shift: int) -> int:
    """Largest j (axis 0) or k (axis 1) so that all angles up to there are at most phi*."""
    lines = np.moveaxis(angles, axis, 0)
    good = [j for j in range(len(lines)) if not (lines[: j + 1] > level).any()]
    return max(good) + shift


def cut_place(
    setting: Setting, *, line: str = "column", shift: int = 0, level: str = "1",
    variant: str = "nodes",
) -> Evidence:  # fmt: skip
    """Line j* or k* of steps 12 and 13, set by set, against the cuts of discrete.greedy.

    shift: added to it; level: of the cutoff, in units of phi*.
    """
    del setting
    failures, tried = [], 0
    axis = 0 if line == "column" else 1
    for case in CASES:
        cuts, run = shipped_cuts(case), run_of(case, variant)
        for sector, _, _ in cut_sectors(run):
            tried += 1
            wide = run.parameters.cutoff * float(Fraction(level))
            number = _cut_by_definition(sector.angles, wide, axis=axis, shift=shift)
            # Every other initial sector has its u-axis where the shipped one has its v-axis, and
            # the printed middle sectors exchange their axes: letters and numbers come out alike.
            wanted = cuts.get(sector.path[1:])
            if wanted is None or wanted[axis] != number:
                failures.append(f"sector {sector.path}: {number}, by discrete.greedy {wanted}")
    return found(failures, shown=f"{tried} cuts", tried=tried)


def cut_row(setting: Setting, *, shift: int = 0, level: str = "1") -> Evidence:
    """The same for the row k* of step 13."""
    return cut_place(setting, line="row", shift=shift, level=level)


def excision(
    setting: Setting, *, keep_rows: int = 0, level: str = "1", variant: str = "meant"
) -> Evidence:
    """Whether |phi| <= phi* at the nodes in the disk that step 14 leaves.

    keep_rows: rows beyond k* that are left too; level: in units of phi*.
    """
    del setting
    failures, tried = [], 0
    for case in CASES:
        run = run_of(case, variant)
        for sector, cut, _ in cut_sectors(run):
            kept = np.ones_like(sector.kept)
            kept[cut[0] + 1 :, cut[1] + 1 + keep_rows :] = False
            near = kept & inside(sector.zeta, run.parameters.radius)
            tried += int(near.sum())
            widest = float(np.nanmax(np.abs(np.where(near, sector.angles, 0.0))))
            if widest > run.parameters.cutoff * float(Fraction(level)):
                failures.append(f"sector {sector.path}: phi = {widest / math.pi:.4f} pi is left")
    return found(failures, shown=f"{tried} nodes left at the cuts", tried=tried)


def bookkeeping(setting: Setting, *, added: int = 3, variant: str = "meant") -> Evidence:
    """Whether each cut adds so many sectors to the list and to M, at its end and in one go."""
    del setting
    failures, tried = [], 0
    for case in CASES:
        run = run_of(case, variant)
        cuts = cut_sectors(run)
        tried += len(cuts)
        if len(run.sectors) != case[1] + added * len(cuts) or run.count != len(run.sectors):
            failures.append(f"M = {run.count}, {len(run.sectors)} sectors, {len(cuts)} cuts")
        for sector, _, daughters in cuts:
            letters = "".join(daughter.path[-1] for daughter in daughters)
            if letters != "uAv"[:added]:
                failures.append(f"sector {sector.path}: daughters {letters}")
    return found(failures, shown=f"{tried} cuts", tried=tried)


def _last_angles(run: PrintedRun) -> float:
    return max(
        float(np.nanmax(np.abs(np.where(near, sector.angles, 0.0))))
        for sector in run.sectors
        if (near := sector.kept & inside(sector.zeta, run.parameters.radius)).any()
    )


def stops(
    setting: Setting, *, variant: str = "sign", most: int = MOST, level: str = "1"
) -> Evidence:
    """Whether the run ends by step 25, with |phi| <= level phi* at every node in the disk."""
    del setting
    failures = []
    for case in CASES:
        run = run_of(case, variant, most=most)
        if run.end != "step 25":
            failures.append(f"R = {case[0]}, M = {case[1]}: {run.end}")
            continue
        widest = _last_angles(run)
        if widest > run.parameters.cutoff * float(Fraction(level)):
            failures.append(
                f"R = {case[0]}, M = {case[1]}: |phi| = {widest / math.pi:.4f} pi is left, above "
                f"{case[2]} pi"
            )
    return found(failures, shown=f"{len(CASES)} runs", tried=len(CASES))


def local_cut(setting: Setting, *, more: int = 0, variant: str = "nodes") -> Evidence:
    """Whether each cut follows from its sector's own axes and is the largest its angles allow.

    The sector is filled again from its axes alone. more: lines added to j* and k*, which must
    still be followed by a line with an angle above phi*.
    """
    del setting
    failures, tried = [], 0
    for case in CASES:
        run = run_of(case, variant)
        for sector, cut, _ in cut_sectors(run):
            tried += 1
            alone = printed_sector(
                filled_disk(sector.zeta[:, :, 0], sector.zeta[:, 0, :]),
                radius=run.parameters.radius, reading=run.reading, parent=-1, path=sector.path,
            )  # fmt: skip
            arguments = {"radius": run.parameters.radius, "cutoff": run.parameters.cutoff}
            wide = too_wide(alone, reading=run.reading, **arguments)
            again = cut_of(wide)
            j, k = cut[0] + more, cut[1] + more
            if again != (j, k):
                failures.append(f"sector {sector.path}: cut at {again}, not {(j, k)}")
            elif wide[: j + 1].any() or wide[:, : k + 1].any():
                failures.append(f"sector {sector.path}: an angle above phi* is kept")
            elif not (wide[j + 1].any() and wide[:, k + 1].any()):
                failures.append(f"sector {sector.path}: a larger j* or k* is possible")
    return found(failures, shown=f"{tried} cuts made again", tried=tried)
