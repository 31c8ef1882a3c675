"""Whole nets of disks with distributed branch points and with one, and their largest curvature.

The angle phi is measured on the vertices of the K-surface in space; the other route is the sweep
of the greedy algorithm, which has angles only, and for one branch point the balls of theory.
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import cache

import numpy as np
from numpy.typing import NDArray

from checks.evidence import Evidence, Setting
from checks.searches.greedy_runs import SETS
from checks.verify.findings import findings as found
from checks.verify.greedy_samples import TREE, tree_of
from checks.verify.quads_in_space import edges_of, space_angles
from discrete.greedy_net import greedy_net
from theory import periodic_amsler

Array = NDArray[np.float64]

STEP = "1/50"
RADII = ("2", "3", "4")

#: Cutoff, in half turns, beyond the angles of the best periodic Amsler surfaces: no cut is made.
NO_CUT = "99/100"

#: Rounding of the positions in space.
ROUNDING = 1e-8


@dataclass(frozen=True, kw_only=True)
class Disk:
    """Net of a disk as a figure shows it.

    branched: degrees of the inner vertices other than 4, by their distance from the centre;
    largest: greatest larger principal curvature of the quads within the disk; angle_gap: greatest
    difference of phi in space from phi of the sweep; closed: whether the net is one disk.
    """

    branched: tuple[tuple[float, int], ...]
    largest: float
    angle_gap: float
    closed: bool


def curvatures(angles: Array, *, smaller: bool = False) -> Array:
    """Larger, or smaller, of the two principal curvatures in size, from phi."""
    pair = np.stack([np.tan(angles / 2), 1 / np.tan(angles / 2)])
    return np.asarray(pair.min(axis=0) if smaller else pair.max(axis=0))


@cache
def disk(radius: str, sectors: str, cutoff: str, smaller: bool = False) -> Disk:
    """Net of a run, measured."""
    net = greedy_net(tree_of(radius, STEP, sectors, cutoff))
    edges, count = edges_of(net.quads)
    inner = np.ones(len(net.disk), dtype=bool)
    inner[edges[count == 1].ravel()] = False
    degree = np.bincount(edges.ravel(), minlength=len(net.disk))
    distance = 2 * np.arctanh(np.abs(net.disk))
    odd = np.flatnonzero(inner & (degree != 4))
    angles = (space_angles(net, 0) + np.pi - space_angles(net, 1)) / 2
    within = (distance[net.quads] <= float(Fraction(radius))).all(axis=1)
    return Disk(
        branched=tuple(sorted((float(distance[k]), int(degree[k])) for k in odd)),
        largest=float(curvatures(angles, smaller=smaller)[within].max()),
        angle_gap=float(np.abs(angles - net.quad_angles).max()),
        closed=len(net.disk) - len(edges) + len(net.quads) == 1,
    )


def one_branch_point(radius: str) -> tuple[str, str, str]:
    """Radius, best number of sectors and a cutoff that is not reached."""
    return radius, str(periodic_amsler.best_sectors(Fraction(radius))), NO_CUT


def figure(
    setting: Setting,
    *,
    sectors: str = "",
    smaller: bool = False,
    distributed: str = "4",
    percent: int = 100,
) -> Evidence:
    """Whether the nets of both columns are disks with the branch points and colours stated.

    sectors: number on the right, by default the best; smaller: colour by the smaller curvature;
    distributed: number of initial sectors on the left; percent: of the curvature in space.
    """
    del setting
    failures, told = [], []
    for radius in RADII:
        left = (radius, distributed, TREE[1])
        right = (radius, sectors or one_branch_point(radius)[1], NO_CUT)
        for key, single in ((left, False), (right, True)):
            net, tree = disk(*key, smaller), tree_of(key[0], STEP, *key[1:])
            name = f"R = {radius}, 2 m = {key[1]}"
            off_centre = [degree for distance, degree in net.branched if distance > 1e-9]
            at_centre = [degree for distance, degree in net.branched if distance <= 1e-9]
            wanted = at_centre == [int(key[1])] and not off_centre
            if single != wanted or (not single and len(off_centre) < 2):
                failures.append(f"{name}: {len(off_centre)} branch points off the centre")
            # The middle of a quad is within an edge of the vertices at which the sweep looks.
            largest = net.largest * percent / 100
            gap = abs(np.log(largest / tree.max_curvature))
            if not net.closed or net.angle_gap > ROUNDING or gap > float(Fraction(STEP)):
                failures.append(f"{name}: {largest:.3f}, swept {tree.max_curvature:.3f}")
            told.append(f"{len(net.branched)} branch points, {net.largest:.2f} ({name})")
    return found(failures, shown="; ".join(told), tried=len(told))


def slower_growth(setting: Setting, *, sectors: str = "", share: str = "1") -> Evidence:
    """Whether the largest curvature grows from R = 2 to 4 for both, by less with distributed ones.

    Every set of runs is compared over the whole way, that with distributed branch points for R = 2
    also step by step; sectors: number about the one branch point, by default the best for each R;
    share: of the growth for one branch point.
    """
    del setting
    failures, told = [], []
    single = [
        disk(*((radius, sectors, NO_CUT) if sectors else one_branch_point(radius))).largest
        for radius in RADII
    ]
    told.append("one branch point " + ", ".join(f"{value:.2f}" for value in single))
    if not single[0] < single[1] < single[2]:
        failures.append(f"one branch point: {told[-1]}")
    most = float(Fraction(share))
    for key in SETS:
        values = [disk(radius, *key).largest for radius in RADII]
        told.append(f"2 m = {key[0]}, phi* = {key[1]} pi: {', '.join(f'{v:.2f}' for v in values)}")
        steps = [(0, 1), (1, 2)] if key == TREE else []
        slower = all(
            values[b] / values[a] < most * single[b] / single[a] for a, b in [*steps, (0, 2)]
        )
        if not slower or not values[0] < values[1] < values[2]:
            failures.append(told[-1])
    return found(failures, shown=f"R = 2, 3, 4: {'; '.join(told)}", tried=3 * (1 + len(SETS)))


def crochet(
    setting: Setting, *, radius: str = "3", fewest: int = 2, percent: int = 100
) -> Evidence:
    """Whether the run on the disk makes a surface in space, isometric to the disk and branched.

    Edges have the length tanh of the step in space (percent of it), and angles in space are those
    of the net in H^2; fewest: branch points off the centre.
    """
    del setting
    failures, told = [], []
    for key in SETS:
        run = tree_of(radius, STEP, *key)
        net, measured = greedy_net(run), disk(radius, *key)
        ends = net.points[net.quads]
        lengths = np.linalg.norm(ends - np.roll(ends, -1, axis=1), axis=2)
        wrong = np.abs(lengths / np.tanh(float(Fraction(STEP))) - percent / 100).max()
        off_centre = sum(distance > 1e-9 for distance, _ in measured.branched)
        name = f"2 m = {key[0]}, phi* = {key[1]} pi"
        told.append(f"{off_centre} ({name})")
        short = wrong > ROUNDING or measured.angle_gap > ROUNDING or not measured.closed
        if short or off_centre < fewest or not run.terminated:
            failures.append(f"{name}: {off_centre} branch points, edges off by {wrong:.2g}")
    return found(
        failures,
        shown=f"branch points off the centre on R = {radius}: {', '.join(told)}; edges and angles "
        "in space are those of the net in H^2",
        tried=len(SETS),
    )
