"""Steps 1 to 9 of the printed greedy algorithm: sectors, axes, fill, discards, angles."""

import math
from fractions import Fraction

import numpy as np
import numpy.typing as npt

from checks.evidence import Evidence, Setting
from checks.printed import poincare_disk
from checks.printed.greedy_algorithm import PrintedRun, initial_sectors
from checks.printed.greedy_reading import MEANT, VARIANTS
from checks.printed.greedy_sector import (
    FIELD,
    Flags,
    PrintedSector,
    inside,
    undiscarded,
)
from checks.verify.printed_runs import CASES, found, parameters_of, run_of, seen_from
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
    nodes = poincare_disk.on_ray(np.arange(13), step, direction, FIELD, rate=rate)
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


def lost_nodes(setting: Setting, *, variant: str = "meant", radius: str = "1") -> Evidence:
    """Whether steps 6 and 20 keep every node in the disk that the net has before it folds.

    radius: of the disk by which they discard, in units of R. Before it folds: phi < pi at the
    node's predecessors, by the turn of the net from one quad to the next.
    """
    del setting
    failures: list[str] = []
    tried = 0
    for case in CASES:
        run = run_of(case, variant)
        for sector in run.sectors:
            kept = undiscarded(
                sector.zeta, run.parameters.radius * float(Fraction(radius)), run.reading
            )
            flat = _unfolded(sector)
            near = inside(sector.zeta, run.parameters.radius) & flat
            tried += int(near.sum())
            lost = np.argwhere(near & ~kept)
            if len(lost):
                failures.append(f"sector {sector.path}: node {lost[0].tolist()} is lost")
    return found(failures, shown=f"{tried} nodes in the disk", tried=tried)


def _unfolded(sector: PrintedSector) -> Flags:
    """Nodes that are reached through quads of one orientation."""
    z = sector.zeta[0] + 1j * sector.zeta[1]
    centre = z[:-1, :-1]
    turned = np.imag(seen_from(centre, z[:-1, 1:]) * seen_from(centre, z[1:, :-1]).conj())
    good = turned * (-1 if sector.path[-1] == "A" else 1) > 0
    found_nodes = np.ones(z.shape, dtype=np.bool_)
    found_nodes[1:, 1:] = np.logical_and.accumulate(np.logical_and.accumulate(good, 0), 1)
    return found_nodes


def rim_quads(setting: Setting, *, variant: str = "meant", short: str = "0") -> Evidence:
    """Whether no point of the disk of radius R - short Delta is lost with the discarded nodes."""
    failures, count = [], 20000
    random = np.random.default_rng(int.from_bytes(setting.seed.encode()[:8], "big"))
    for case in CASES:
        run = run_of(case, variant)
        held, points = held_points(run, count, random, float(Fraction(short)))
        lost = np.flatnonzero(held == 0)
        if len(lost):
            depth = run.parameters.radius - 2 * np.arctanh(np.abs(points[lost]))
            failures.append(
                f"R = {case[0]}, M = {case[1]}: {len(lost)} of {count} points in no quad, at most "
                f"{depth.max() / run.parameters.step:.2f} Delta within the rim"
            )
    return found(
        failures, shown=f"{count} random points of each of {len(CASES)} disks", tried=len(CASES)
    )


def held_points(
    run: PrintedRun, count: int, random: np.random.Generator, short: float
) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.complex128]]:
    """Number of kept quads that hold each random point of the disk of radius R - short Delta."""
    largest = math.sinh((run.parameters.radius - short * run.parameters.step) / 2)
    half = largest * np.sqrt(random.random(count))
    points = half / np.sqrt(1 + half * half) * np.exp(2j * math.pi * random.random(count))
    held = sum(contained(points, s.corners()) for s in run.sectors if s.quads.any())
    return np.asarray(held), points


def staircase(setting: Setting, *, variant: str = "meant", dropped: int = 0) -> Evidence:
    """Whether the quads of every Omega_n make up one simply connected piece.

    dropped: inner nodes taken out of each sector.
    """
    del setting
    failures: list[str] = []
    tried = 0
    for case in CASES:
        for sector in run_of(case, variant).sectors:
            kept = sector.kept.copy()
            for j in range(dropped):
                kept[2 + j, 2] = False
            tried += 1
            pieces, euler = _pieces(kept)
            if (pieces, euler) != (1, 1):
                failures.append(f"sector {sector.path}: {pieces} pieces, V - E + F = {euler}")
    return found(failures, shown=f"{tried} sectors", tried=tried)


def _pieces(kept: Flags) -> tuple[int, int]:
    """Components, and V - E + F, of the closed quads whose four nodes are kept."""
    from scipy.ndimage import label

    quads = kept[:-1, :-1] & kept[1:, :-1] & kept[:-1, 1:] & kept[1:, 1:]
    wide = np.pad(quads, 1)
    nodes = wide[:-1, :-1] | wide[1:, :-1] | wide[:-1, 1:] | wide[1:, 1:]
    edges = (wide[:-1, 1:-1] | wide[1:, 1:-1]).sum() + (wide[1:-1, :-1] | wide[1:-1, 1:]).sum()
    count = label(quads, structure=np.ones((3, 3)))[1]
    return int(count), int(nodes.sum() - edges + quads.sum())


def angles_at_nodes(
    setting: Setting, *, conjugated: bool = True, spacing: str = "1", variant: str = "meant"
) -> Evidence:
    """Angle (eq:angle) against the law of cosines for the three distances at the node.

    spacing: side of the triangle in units of Delta.
    """
    del setting
    failures: list[str] = []
    tried = 0
    for case in CASES:
        run = run_of(case, variant)
        side = run.parameters.step * float(Fraction(spacing))
        for sector in run.sectors:
            z = sector.zeta
            corners = tuple(z[:, :-1, :-1]), tuple(z[:, 1:, :-1]), tuple(z[:, :-1, 1:])
            printed = np.abs(poincare_disk.angle(*corners, FIELD, conjugated=conjugated))
            first = z[0, 1:, :-1] + 1j * z[1, 1:, :-1]
            second = z[0, :-1, 1:] + 1j * z[1, :-1, 1:]
            half = np.abs(first - second) / np.sqrt(
                (1 - np.abs(first) ** 2) * (1 - np.abs(second) ** 2)
            )
            # sinh of half the third side is sinh(side) sin(phi/2): two sides are equal.
            true = 2 * np.arcsin(np.minimum(half / np.sinh(side), 1.0))
            where = np.isfinite(sector.angles[:-1, :-1])
            tried += int(where.sum())
            gap = np.abs(printed - true)[where].max(initial=0.0)
            if gap > 1e-6:
                failures.append(f"sector {sector.path}: the angles differ by {gap:.3g}")
    return found(failures, shown=f"{tried} nodes", tried=tried)
