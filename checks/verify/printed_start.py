"""Steps 1 to 6 of the printed greedy algorithm: numbers, cutoff, sectors, axes."""

import math
from fractions import Fraction

import numpy as np
import numpy.typing as npt

from checks.evidence import Evidence, Setting
from checks.printed import poincare_disk
from checks.printed.disk_net import ARRAYS
from checks.printed.greedy_algorithm import initial_sectors
from checks.printed.greedy_reading import MEANT, VARIANTS
from checks.printed.greedy_sector import (
    inside,
)
from checks.verify.printed_runs import CASES, found, parameters_of, run_of
from discrete.geodesics import polar
from discrete.poincare_disk import to_disk
from discrete.point_cover import contained
from discrete.space_forms import H2


def sector_number(setting: Setting, *, start: int = 4, by: int = 2) -> Evidence:
    """Whether M admits alternating marks u, v on the axes and a cutoff between 2 pi/M and pi."""
    del setting
    failures = []
    numbers = range(start, 21, by)
    for number in numbers:
        marks = ["uv"[n % 2] for n in range(number)]
        if any(marks[n] == marks[n - 1] for n in range(number)):
            failures.append(f"M = {number}: two neighbouring axes have one mark")
        if 2 * math.pi / number >= math.pi:
            failures.append(f"M = {number}: no cutoff between pi/m and pi")
    return found(failures, shown=f"M = {list(numbers)}", tried=len(numbers))


def cutoff_range(setting: Setting, *, low: str = "101/100", high: str = "99/100") -> Evidence:
    """Whether sectors start below the cutoff and have an angle above it before they fold.

    low, high: cutoffs in units of pi/m and of pi. The disk, of radius 5, reaches beyond the
    singular edges.
    """
    del setting
    failures, tried = [], 0
    for number in (4, 6, 8):
        sector = initial_sectors(parameters_of(("5", number, "9/10", "1/10")), MEANT)[0]
        corner = float(sector.angles[0, 0]) * number / (2 * math.pi)
        widest = float(np.nanmax(sector.angles)) / math.pi
        tried += 2
        if not corner < Fraction(low):
            failures.append(f"M = {number}: the corner has the angle {corner:.6f} pi/m")
        if not widest > Fraction(high):
            failures.append(f"M = {number}: no angle is above {widest:.6f} pi")
    return found(failures, shown="M = 4, 6, 8 with cutoffs near both ends", tried=tried)


def enough_nodes(setting: Setting, *, factor: str = "2") -> Evidence:
    """Whether each line of a sector leaves the disk within N = factor R/Delta edges."""
    del setting
    failures: list[str] = []
    longest, tried = 0.0, 0
    for case in CASES:
        edges = Fraction(factor) * Fraction(case[0]) / Fraction(case[3])
        run = run_of(case, "meant", nodes=math.ceil(edges))
        for sector in run.sectors:
            tried += 1
            near = inside(sector.zeta, run.parameters.radius) & sector.kept
            if near[-1].any() or near[:, -1].any():
                failures.append(f"sector {sector.path}: a line ends within the disk")
            reach = max(int(np.nonzero(near.any(axis=axis))[0].max()) for axis in (0, 1))
            longest = max(longest, reach * run.parameters.step / run.parameters.radius)
    return found(
        failures,
        shown=f"{tried} sectors; the longest line in the disk has the length {longest:.2f} R",
        tried=tried,
    )


def list_of_sectors(setting: Setting, *, extra: int = 0) -> Evidence:
    """Whether the list has M entries after step 9, each made once; extra: more of them."""
    del setting
    failures = []
    for case in CASES:
        made = initial_sectors(parameters_of(case), MEANT)
        if [sector.path for sector in made] != [str(n) for n in range(case[1] + extra)]:
            failures.append(f"M = {case[1] + extra}: sectors {[s.path for s in made]}")
    return found(failures, shown="lists of 4 and of 8 sectors", tried=len(CASES))


def initial_cover(
    setting: Setting, *, variant: str = "letter", last: int = 0, radius: str = "1/2"
) -> Evidence:
    """Whether the initial sectors cover a disk around the origin once.

    last: sectors left out at the end; radius: of this disk, within the first cut.
    """
    failures, count = [], 2000
    random = np.random.default_rng(int.from_bytes(setting.seed.encode()[:8], "big"))
    modulus = math.tanh(float(Fraction(radius)) / 2) * np.sqrt(random.random(count))
    points = modulus * np.exp(2j * math.pi * random.random(count))
    for case in CASES:
        sectors = initial_sectors(parameters_of(case), VARIANTS[variant])
        held = sum(contained(points, s.corners()) for s in sectors[: case[1] - last])
        wrong = np.flatnonzero(held != 1)
        if len(wrong):
            failures.append(
                f"M = {case[1]}: {len(wrong)} of {count} points not in one quad, as "
                f"{points[wrong[0]]:.4f}"
            )
    return found(
        failures, shown=f"{count} points of a disk of radius {radius} each", tried=len(CASES)
    )


def _printed_axis(step: float, direction: float, rate: str) -> npt.NDArray[np.complex128]:
    nodes = poincare_disk.on_ray(np.arange(13), step, direction, ARRAYS, rate=rate)
    return np.asarray(nodes[0] + 1j * nodes[1])


def _axis(step: float, direction: float) -> npt.NDArray[np.complex128]:
    """Nodes of the same axis on the hyperboloid, seen in the disk."""
    nodes = [to_disk(polar(H2, math, direction, j * step)) for j in range(13)]
    return np.array([complex(*z) for z in nodes])


def axes(setting: Setting, *, number: str = "0", rate: str = "1/2") -> Evidence:
    """Whether the axes are geodesics with nodes Delta apart that turn by pi/m between sectors.

    number: added to n in the direction pi n/m of the v-axis; rate: factor of j Delta in tanh.
    """
    del setting
    failures, tried = [], 0
    for case in CASES:
        step = parameters_of(case).step
        for n in range(1, case[1] + 1):
            tried += 1
            before = 2 * math.pi * (n - 1) / case[1]
            after = 2 * math.pi * (n + float(Fraction(number))) / case[1]
            for direction, true in ((before, n - 1), (after, n)):
                printed = _printed_axis(step, direction, rate)
                gap = np.abs(printed - _axis(step, 2 * math.pi * true / case[1])).max()
                if gap > 1e-13:
                    failures.append(f"M = {case[1]}, sector {n}: an axis is off by {gap:.2g}")
    return found(failures, shown=f"both axes of {tried} sectors", tried=tried)


def each_sector(setting: Setting, *, last: int = 0) -> Evidence:
    """Whether sectors 1 to M, filled as step 5 is meant, surround the origin once."""
    return initial_cover(setting, variant="meant", last=last)
