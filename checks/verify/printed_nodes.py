"""Steps 6 to 8 and 20 to 22 of the printed greedy algorithm: nodes kept, sectors, angles."""

import math
from fractions import Fraction

import numpy as np
import numpy.typing as npt

from checks.evidence import Evidence, Setting
from checks.printed import poincare_disk
from checks.printed.disk_net import ARRAYS
from checks.printed.greedy_algorithm import PrintedRun
from checks.printed.greedy_sector import (
    Flags,
    PrintedSector,
    inside,
    undiscarded,
)
from checks.verify.printed_runs import CASES, found, run_of, seen_from
from discrete.point_cover import contained


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
            printed = np.abs(poincare_disk.angle(*corners, ARRAYS, conjugated=conjugated))
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
            if gap > 1e-7:  # near pi the arc sine has half of the digits
                failures.append(f"sector {sector.path}: the angles differ by {gap:.3g}")
    return found(failures, shown=f"{tried} nodes", tried=tried)
