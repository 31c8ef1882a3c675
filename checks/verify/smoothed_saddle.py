"""Smoothing the curves of a 2-saddle with corners, on discrete nets in S^2 and in H^2."""

from collections.abc import Iterator

import numpy as np
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined
from checks.verify.convergence import order as observed_order
from theory import half_turn_net
from theory.half_turn_net import Array

CELLS = 256
LENGTH = 0.5
WINDOWS = (64, 32, 16, 8)
#: Directions of the u- and the v-curve on both sides of p: sectors pi/3, pi/2, 2 pi/3, pi/2.
BEFORE = (-np.pi / 6, np.pi / 2)
AFTER = (0.0, np.pi / 3)


def _corner(window: int) -> Array:
    """Share of the turning done at each edge: a step, or a ramp over `window` edges."""
    share = np.ones(CELLS)
    if window:
        share[:window] = (np.arange(window) + 0.5) / window
    return share


def _root(window: int) -> Array:
    """Share of the turning done at each edge: a square root, cut off by its chord near 0."""
    edges = np.arange(CELLS) + 0.5
    share: Array = np.sqrt(edges / CELLS)
    if window:
        share[:window] = edges[:window] / np.sqrt(window * CELLS)
    return share


def _directions(axis: int, forward: bool, share: Array) -> Array:
    """Direction of each edge from p on: forward the turning is done by its share."""
    if not forward:
        return np.full(CELLS, BEFORE[axis] + np.pi)
    found: Array = BEFORE[axis] + share * (AFTER[axis] - BEFORE[axis])
    return found


def _quadrants(share: Array, curvature: int) -> Iterator[Array]:
    """Nets of the normal (curvature 1) or of the surface's metric (-1), without the last one."""
    quarter = np.pi / 2 if curvature > 0 else 0.0
    edge = LENGTH / CELLS
    for forward in ((True, True), (False, True), (True, False)):
        lines = [
            half_turn_net.broken_geodesic(
                _directions(axis, forward[axis], share) + (quarter if axis == 0 else -quarter),
                edge,
                curvature,
            )
            for axis in (0, 1)
        ]
        yield half_turn_net.net(lines[0], lines[1], curvature)


def _errors(window: int) -> tuple[float, float, float, float]:
    """Largest distance of the normals and of the points, squared L^2 of phi, and least angle."""
    rounded, cornered = _corner(window), _corner(0)
    distances = [
        max(
            float(np.max(np.abs(a - b)))
            for a, b in zip(_quadrants(rounded, k), _quadrants(cornered, k), strict=True)
        )
        for k in (1, -1)
    ]
    squared, least = 0.0, np.pi
    for a, b in zip(_quadrants(rounded, -1), _quadrants(cornered, -1), strict=True):
        rough, smooth = half_turn_net.angle(b, -1), half_turn_net.angle(a, -1)
        squared += float(np.sum((smooth - rough) ** 2)) * (LENGTH / CELLS) ** 2
        least = min(least, float(np.min(smooth)), float(np.min(np.pi - smooth)))
    return distances[0], distances[1], squared, least


def convergence(
    setting: Setting, *, order: int = 1, power: int = 1, floor_percent: int = 95
) -> Evidence:
    """Orders in the window of the distances (order) and of the squared L^2 error of phi (power).

    floor_percent: what the least angle may not fall below, in percent of pi/3, the least at p.
    """
    del setting
    found = [_errors(window) for window in WINDOWS]
    levels = [mp.mpf(LENGTH * window / CELLS) for window in WINDOWS]
    floor = floor_percent / 100 * np.pi / 3
    least = min(row[3] for row in found)
    names = ("normals", "points of H^2", "squared L^2 error of phi")
    parts = {
        name: observed_order(
            levels,
            [mp.mpf(row[n]) for row in found],
            power if n == 2 else order,
            digits=10,
            shown=name,
        )
        for n, name in enumerate(names)
    }
    parts["angles"] = Evidence(
        outcome="pass" if least > floor else "fail",
        grade="experiment",
        shown="curvatures stay bounded",
        witness=f"least angle {least:.4g}, floor {floor:.4g}",
    )
    return combined(
        parts,
        shown="with the turning spread over h the normals and the points converge with order 1, "
        "phi in L^2 with order 1/2, and all angles stay above 0.95 pi/3",
    )


def continuous_angles(setting: Setting, *, order: int = 1, profile: str = "root") -> Evidence:
    """Order in the window of the squared largest error of phi, for curves with continuous tangents.

    profile: `root`, tangents that are continuous and not Lipschitz, or `corner`.
    """
    del setting
    share = {"root": _root, "corner": _corner}[profile]
    errors = []
    for window in WINDOWS:
        pairs = zip(_quadrants(share(window), -1), _quadrants(share(0), -1), strict=True)
        errors.append(
            max(
                float(np.max(np.abs(half_turn_net.angle(a, -1) - half_turn_net.angle(b, -1))))
                for a, b in pairs
            )
        )
    return observed_order(
        [mp.mpf(LENGTH * window / CELLS) for window in WINDOWS],
        [mp.mpf(e) ** 2 for e in errors],
        order,
        digits=10,
        shown="phi converges uniformly, squared error in the window over which curves with "
        "continuous tangents are smoothed",
    )
