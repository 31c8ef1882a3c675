"""Step 27 of the printed greedy algorithm: the K-surface of the net, its stars and angle sums."""

import math
from fractions import Fraction
from typing import Any

import numpy as np

from checks.evidence import Evidence, Setting
from checks.verify.greedy_samples import tree_of
from checks.verify.printed_runs import CASES, found
from checks.verify.quads_in_space import edges_of, space_angles
from discrete.greedy_net import GreedyNet, greedy_net

#: Random points of a disk.
POINTS = 20000

#: Distance within which nodes of two sectors are one node, in units of Delta.
ONE_NODE = 1e-6


def _net(case: tuple[str, int, str, str]) -> GreedyNet:
    radius, sectors, cutoff, step = case
    return greedy_net(tree_of(radius, step, str(sectors), cutoff))


def _disk_angles(net: GreedyNet, k: int) -> Any:
    z = net.disk[net.quads]
    a, b = (
        (z[:, j] - z[:, k]) / (1 - z[:, j] * z[:, k].conj()) for j in ((k - 1) % 4, (k + 1) % 4)
    )
    return np.abs(np.angle(b * a.conj()))


def surface(setting: Setting, *, lift: str = "0", scale: str = "1") -> Evidence:
    """Whether the quads go to skew quads of space with planar stars, equal edges, equal angles.

    lift: of one vertex, in units of the edge; scale: of the angles of the net.
    """
    del setting
    failures, tried = [], 0
    for case in CASES:
        net = _net(case)
        inner = len(net.points) // 2
        net.points[inner] += float(Fraction(lift)) * float(Fraction(case[3])) * net.normals[inner]
        edges, _ = edges_of(net.quads)
        vector = net.points[edges[:, 1]] - net.points[edges[:, 0]]
        lengths = np.linalg.norm(vector, axis=1)
        out = max(
            np.abs(np.einsum("ij,ij->i", vector, net.normals[edges[:, end]])).max()
            for end in (0, 1)
        )
        turn = max(
            np.abs(space_angles(net, k) - float(Fraction(scale)) * _disk_angles(net, k)).max()
            for k in range(4)
        )
        skew = _skewness(net)
        tried += len(net.quads)
        gaps = {
            "edges differ": float(lengths.max() - lengths.min()),
            "edges leave the planes of their stars": float(out),
            "angles in space and in the disk differ": float(turn),
        }
        failures += [f"M = {case[1]}: {name} by {gap:.3g}" for name, gap in gaps.items()
                     if gap > 1e-7]  # fmt: skip
        if skew < 1e-3:
            failures.append(f"M = {case[1]}: a quad is planar")
    return found(failures, shown=f"{tried} quads of {len(CASES)} nets", tried=tried)


def _skewness(net: GreedyNet) -> float:
    """Least volume spanned by the edges of a quad, over the cube of the edge times the edge."""
    p = net.points[net.quads]
    a, b, c = (p[:, k] - p[:, 0] for k in (1, 2, 3))
    volume = np.abs(np.einsum("ij,ij->i", a, np.cross(b, c)))
    edge = np.linalg.norm(a, axis=1)
    area = np.linalg.norm(np.cross(a, c), axis=1)
    return float((volume / (area * edge**2)).min())


def angle_sums(setting: Setting, *, turn: str = "1", boundary: str = "1") -> Evidence:
    """Whether angles in space add up to 2 pi inside and to less at the boundary.

    turn, boundary: in units of 2 pi, for inner and for boundary nodes.
    """
    del setting
    failures, tried = [], 0
    for case in CASES:
        net = _net(case)
        total = np.zeros(len(net.points))
        for k in range(4):
            np.add.at(total, net.quads[:, k], space_angles(net, k))
        edges, count = edges_of(net.quads)
        inside_nodes = np.ones(len(total), dtype=np.bool_)
        inside_nodes[edges[count == 1].ravel()] = False
        tried += len(total)
        whole = 2 * math.pi * float(Fraction(turn))
        gap = float(np.abs(total[inside_nodes] - whole).max())
        rim = float(total[~inside_nodes].max()) / (2 * math.pi)
        if gap > 1e-7:
            failures.append(f"M = {case[1]}: an inner sum is off by {gap:.3g}")
        if not rim < float(Fraction(boundary)):
            failures.append(f"M = {case[1]}: a sum of {rim:.4f} 2 pi at the boundary")
    return found(failures, shown=f"{tried} nodes of {len(CASES)} nets", tried=tried)
