"""The greedy algorithm as printed (alg:greedy-cuts), under a reading of its open lines."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from checks.printed.disk_net import filled_disk
from checks.printed.greedy_reading import Reading
from checks.printed.greedy_sector import (
    Flags,
    PrintedSector,
    cut_of,
    daughters,
    excised,
    printed_sector,
    ray,
    too_wide,
)

#: How a run ends: by step 25; with too many cuts; with sectors for which j* or k* does not exist.
End = Literal["step 25", "max cuts", "no cut"]

#: Which of the sectors that can be cut is cut next (step 11), given their places in the list.
Choice = Callable[[Sequence[int]], int]


@dataclass(frozen=True, kw_only=True)
class PrintedParameters:
    """Parameters of step 1: R, M = 2m, phi* in radians, Delta; N follows unless it is given.

    Raises ValueError where m < 2 or phi* is not in (pi/m, pi).
    """

    radius: float
    sectors: int
    cutoff: float
    step: float
    nodes: int = 0

    def __post_init__(self) -> None:
        if self.sectors < 4 or self.sectors % 2:
            raise ValueError(f"M = {self.sectors}: expected an even number of 4 or more")
        if not 2 * math.pi / self.sectors < self.cutoff < math.pi:
            raise ValueError(f"phi* = {self.cutoff}: expected a number between pi/m and pi")
        if not self.nodes:
            # A radius that is a multiple of the step must not be rounded up by a last digit.
            object.__setattr__(self, "nodes", math.ceil(2 * self.radius / self.step - 1e-9))


@dataclass(frozen=True, kw_only=True, eq=False)
class PrintedRun:
    """Sectors of a run in the order of the list; M of step 24; how it ended."""

    parameters: PrintedParameters
    reading: Reading
    sectors: tuple[PrintedSector, ...]
    count: int
    end: End


def _first(places: Sequence[int]) -> int:
    return places[0]


def initial_sectors(parameters: PrintedParameters, reading: Reading) -> list[PrintedSector]:
    """Sectors after step 9."""
    found = []
    m, n_nodes = parameters.sectors // 2, parameters.nodes
    for n in range(1, parameters.sectors + 1):
        edges = min(n, n_nodes) if reading.fill_to_number else n_nodes
        first = ray(edges, parameters.step, math.pi * (n - 1) / m, (0.0, 0.0))
        second = ray(edges, parameters.step, math.pi * n / m, (0.0, 0.0))
        found.append(
            printed_sector(
                filled_disk(first, second),
                radius=parameters.radius,
                reading=reading,
                parent=-1,
                path=str(n - 1),
            )
        )
    return found


def printed_run(
    parameters: PrintedParameters,
    reading: Reading,
    *,
    max_cuts: int = 10**4,
    choice: Choice = _first,
    progress: Callable[[int, int], None] | None = None,
) -> PrintedRun:
    """Run steps 1 to 25; a sector of which j* or k* does not exist is left as it is.

    progress: told the number of cuts, and of the sectors that can still be cut.
    """
    sectors = initial_sectors(parameters, reading)
    count, cuts, stuck = parameters.sectors, 0, 0

    def wide_in(sector: PrintedSector) -> Flags:
        return too_wide(sector, radius=parameters.radius, cutoff=parameters.cutoff, reading=reading)

    waiting = {n: wide for n, sector in enumerate(sectors) if (wide := wide_in(sector)).any()}
    while waiting:
        n = choice(list(waiting))
        cut = cut_of(waiting.pop(n))
        if cut is None:
            stuck += 1
            continue
        before, sector = sectors[n].kept, excised(sectors[n], cut)
        sectors[n] = sector
        for letter, zeta in zip(
            "uAv",
            daughters(
                sector, cut, before, edges=parameters.nodes, step=parameters.step, reading=reading
            ),
            strict=True,
        ):
            daughter = printed_sector(
                zeta,
                radius=parameters.radius,
                reading=reading,
                parent=n,
                path=sector.path + letter,
            )
            if (wide := wide_in(daughter)).any():
                waiting[len(sectors)] = wide
            sectors.append(daughter)
        count, cuts = count + 3, cuts + 1
        if progress is not None:
            progress(cuts, len(waiting))
        if cuts >= max_cuts and waiting:
            break
    end: End = "max cuts" if waiting else "no cut" if stuck else "step 25"
    return PrintedRun(
        parameters=parameters, reading=reading, sectors=tuple(sectors), count=count, end=end
    )
