"""Section 4.1, item 2: where the daughters of the first step stop, on nets of an Amsler sector.

Nets by advanced angles, distances from the origin by SL(2, R) frames. A node counts where it is in
the closed disk. Beside them the angle at the rim of the continuum, by v-lines on the hyperboloid.
"""

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from checks.evidence import Evidence, Setting
from discrete.branched_net import BranchedNet, geodesic_ray, star
from discrete.placed_frames import placed_distances
from theory import amsler_disk, painleve_float

Floats = NDArray[np.float64]
#: Half the number of sectors, phi* over pi, R; edge length.
_CASES = ((2, "3/4", 3), (6, "1/2", 4))
_EDGE = 1 / 24


@cache
def angles_in_disk(half: int, radius: int) -> Floats:
    """Angles at the nodes of one sector, 0 outside the disk; a little more than it is laid."""
    ray = geodesic_ray([_EDGE] * math.ceil((radius + 0.2) / _EDGE))
    net = star([ray] * (2 * half), [math.pi / half] * (2 * half))
    (distances,) = placed_distances(BranchedNet(placed=net.placed[:1], seams=()))
    angles = net.placed[0].sector.angles
    return np.where(distances[: angles.shape[0], : angles.shape[1]] <= radius, angles, 0.0)


def _cut(angles: Floats, level: float) -> tuple[int, int]:
    """Steps 12 and 13 as they stand: the largest j, and k, with no angle above level so far."""
    columns = [j for j in range(len(angles)) if angles[: j + 1].max() <= level]
    rows = [k for k in range(angles.shape[1]) if angles[:, : k + 1].max() <= level]
    return max(columns), max(rows)


def _stops(angles: Floats, level: float, rule: str) -> list[tuple[int, int]]:
    """Places at which a daughter stops: one edge farther the largest angle kept exceeds level.

    rule: `one`, the largest over the whole sector that is kept, or `each`, over either arm of it.
    """
    column = np.maximum.accumulate(angles.max(axis=1))
    row = np.maximum.accumulate(angles.max(axis=0))
    found = []
    for j in range(1, len(column) - 1):
        for k in range(1, len(row) - 1):
            fits = max(column[j], row[k]) <= level
            over = (column[j + 1] > level, row[k + 1] > level)
            if fits and (all(over) if rule == "each" else any(over)):
                found.append((j, k))
    return found


def same_cut(setting: Setting, *, rule: str = "one", shift: int = 0) -> Evidence:
    """Whether the rule by which the daughters stop gives (j*, k*) of steps 12 and 13, and only it.

    shift: of j*.
    """
    del setting
    for half, level, radius in _CASES:
        angles = angles_in_disk(half, radius)
        top = float(Fraction(level)) * math.pi
        (j, k), stops = _cut(angles, top), _stops(angles, top, rule)
        if stops != [(j + shift, k)]:
            return Evidence(
                outcome="fail", grade="numeric", digits=10, tried=len(_CASES), met=len(_CASES),
                witness=f"m = {half}, phi* = {level} pi, R = {radius}, edges of {_EDGE:.4f}: "
                f"{len(stops)} places, {stops[0]} to {stops[-1]}, beside ({j + shift}, {k})",
            )  # fmt: skip
    return Evidence(
        outcome="pass", grade="numeric", digits=10, tried=len(_CASES), met=len(_CASES),
        shown="the daughter that moves until either arm reaches phi* stops at (j*, k*)",
    )  # fmt: skip


def _rim_angle(half: int, u: float, radius: int) -> float:
    """Largest angle over the arm of breadth u in the disk, that at the rim of its v-line."""
    corner = math.pi / half
    v = amsler_disk.rim(corner, u, float(radius))
    return painleve_float.angle(corner, 2 * math.sqrt(u * v))


def _arms() -> Iterator[tuple[int, float, int, int]]:
    for half, level, radius in _CASES:
        top = float(Fraction(level)) * math.pi
        yield half, top, radius, _cut(angles_in_disk(half, radius), top)[0]


def reaches_cutoff(setting: Setting, *, shift: int = 0) -> Evidence:
    """Whether the largest angle over an arm rises with its breadth and is phi* at the net's cut.

    From half an edge before j* to an edge and a half after it: the net is good to the first order.
    shift: of j*.
    """
    del setting
    for half, top, radius, j in _arms():
        u = (j + shift) * _EDGE
        values: list[Any] = [_rim_angle(half, x * u, radius) for x in np.linspace(0.05, 1, 20)]
        before = _rim_angle(half, u - _EDGE / 2, radius)
        after = _rim_angle(half, u + 1.5 * _EDGE, radius)
        rising = all(a < b for a, b in pairwise(values))
        if not (rising and before <= top < after):
            return Evidence(
                outcome="fail", grade="experiment", tried=len(_CASES), met=len(_CASES),
                witness=f"m = {half}, R = {radius}: {before:.4f}, {after:.4f} about u = {u:.4f}, "
                f"phi* = {top:.4f}; {'rising' if rising else 'not rising'}",
            )  # fmt: skip
    return Evidence(
        outcome="pass", grade="experiment", digits=1, tried=len(_CASES), met=len(_CASES),
        shown="the largest angle over an arm of an Amsler sector rises with its breadth, from the "
        "angle at the origin to phi* at the place of the net's cut",
    )  # fmt: skip
