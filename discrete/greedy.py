"""The greedy algorithm (alg:greedy-cuts) as this library runs it: the tree of sectors of a disk.

A sector keeps its quads up to the first vertex in the closed disk whose angle exceeds the cutoff
(steps 12 to 14; discrete.sector_cut); three sectors take the place of the corner cut out, and are
cut in their turn. What belongs to the
disk is decided row by row: of a row of quads those count that meet the disk and can be reached in
it from the row below (the net beyond a singular edge may fold back into the disk).
"""

from collections import deque
from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from math import inf

import numpy as np

from discrete.errors import ShapeError
from discrete.greedy_parameters import GreedyParameters
from discrete.greedy_tree import SECTOR, GreedyTree
from discrete.sector_cutter import CutSector, Cutter, TooNarrowError
from discrete.sector_sides import SectorSides, initial_sector

#: Told the share of the disk's area that is done.
Progress = Callable[[float], None]

#: Sectors that wait when the tree is split among the workers: the same split for any executor.
SPLIT = 48

#: Width of the ring swept around the disk at first, its growth when it was too narrow, its limit.
MARGIN, GROWTH, WIDEST = 0.4, 2.0, 8.0

Rows = list[tuple[object, ...]]


def _row(sector: SectorSides, found: CutSector) -> tuple[object, ...]:
    """Entry of SECTOR."""
    at, cut, then = sector.place, found.cut or (0, 0), found.place
    return (
        *(sector.parent, sector.letter, sector.generation, sector.copies, sector.mirrored),
        *(at.hand, at.theta, at.rho, at.heading, sector.opening, found.cut is not None, *cut),
        *(found.cut_angle, *((then.theta, then.rho) if then else (0.0, 0.0))),
        *(found.area, found.willmore, found.quads, found.largest, found.smallest),
    )


class _Limit:
    """Cuts of the whole disk that may still be made."""

    def __init__(self, cuts: int) -> None:
        self.left = cuts

    def passed_by(self, cuts: int) -> bool:
        """Whether these cuts, which are made, were more than may be made."""
        self.left -= cuts
        return self.left < 0


class _Stop:
    """Asks the workers of a run to end; seen by threads, not by other processes."""

    asked = False


def _sweep(
    cutter: Cutter, waiting: deque[SectorSides], rows: Rows, limit: _Limit, stop: _Stop,
    split: float, deep: bool, done: Callable[[float], None],
) -> bool:  # fmt: skip
    """Sweep waiting sectors until none is left or `split` wait; gives False beyond the limit.

    deep: daughters before the others, so that few sectors wait. False too where asked to stop.
    """
    while waiting and len(waiting) < split:
        if stop.asked:
            return False
        sector = waiting.popleft()
        found = cutter(sector, len(rows))
        rows.append(_row(sector, found))
        done(found.area * sector.copies)
        if found.cut is not None and limit.passed_by(sector.copies):
            return False
        if deep:
            waiting.extendleft(reversed(found.daughters))
        else:
            waiting.extend(found.daughters)
    return True


def _subtree(
    parameters: GreedyParameters, margin: float, sector: SectorSides, cuts: int, stop: _Stop
) -> tuple[np.ndarray, bool]:
    """Sectors below one, the parents numbered from its own 0 on, and whether all were swept."""
    rows: Rows = []
    complete = _sweep(
        Cutter(parameters=parameters, margin=margin), deque([sector]), rows, _Limit(cuts), stop,
        inf, True, lambda area: None,
    )  # fmt: skip
    return np.array(rows, dtype=SECTOR), complete


def _joined(parts: Sequence[np.ndarray]) -> np.ndarray:
    """Trees one after another: each but the first has its root's parent in the first."""
    start = len(parts[0])
    moved = [parts[0]]
    for part in parts[1:]:
        part = part.copy()
        part["parent"][1:] += start
        moved.append(part)
        start += len(part)
    return np.concatenate(moved)


def _grown(
    parameters: GreedyParameters, margin: float, executor: Executor | None, max_cuts: int,
    progress: Progress,
) -> GreedyTree:  # fmt: skip
    cutter = Cutter(parameters=parameters, margin=margin)
    outer = float(np.cosh(float(parameters.radius) + margin))
    waiting, limit = deque([initial_sector(parameters, outer)]), _Limit(max_cuts)
    rows: Rows = []
    area, stop = 0.0, _Stop()

    def done(more: float) -> None:
        nonlocal area
        area += more
        progress(min(area / parameters.area, 1.0))

    complete = _sweep(cutter, waiting, rows, limit, stop, SPLIT, False, done)
    parts = [np.array(rows, dtype=SECTOR)]
    futures = []
    try:
        if executor is not None and complete:
            futures = [
                executor.submit(_subtree, parameters, margin, sector, limit.left, stop)
                for sector in waiting
            ]
        for k, sector in enumerate(waiting if complete else ()):
            if futures:
                part, complete = futures[k].result()
            else:
                part, complete = _subtree(parameters, margin, sector, limit.left, stop)
            cuts = int(part["copies"][part["cut"]].sum())
            if cuts > limit.left:
                part, complete = _subtree(parameters, margin, sector, limit.left, stop)
                cuts = int(part["copies"][part["cut"]].sum())
            limit.passed_by(cuts)
            parts.append(part)
            done(float(np.dot(part["area"], part["copies"])))
            if not complete:
                break
    finally:
        stop.asked = True  # after an interrupt or beyond the limit: nobody waits for the others
        for future in futures:
            future.cancel()
    return GreedyTree(
        parameters=parameters, sectors=_joined(parts), terminated=complete, margin=margin
    )


def grown(
    parameters: GreedyParameters,
    *,
    executor: Executor | None = None,
    max_cuts: int = 10**6,
    progress: Progress | None = None,
) -> GreedyTree:
    """Tree of sectors that covers the disk; the same for every executor.

    max_cuts: of the whole disk; the cut that passes it is the last, together with its images: the
    tree is then partial and `terminated` is False. Threads suffice for an executor, since the
    kernel lets others run. Raises ShapeError for a bad limit, SurgeryError where rounding cannot
    place a cut.
    """
    if isinstance(max_cuts, bool) or not isinstance(max_cuts, int) or max_cuts < 1:
        raise ShapeError(f"max_cuts = {max_cuts!r}: give an integer of 1 or more")
    margin = MARGIN
    while True:
        try:
            return _grown(parameters, margin, executor, max_cuts, progress or (lambda share: None))
        except TooNarrowError:
            if margin >= WIDEST:
                raise ShapeError(
                    f"a ring of {margin} around the disk is too narrow for the lines of its net"
                ) from None
            margin = GROWTH * margin
