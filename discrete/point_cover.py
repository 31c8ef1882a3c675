"""How often random points of the disk lie in the kept quads of a run of the greedy algorithm."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from discrete.greedy_tree import GreedyTree
from discrete.greedy_walk import walked
from discrete.sector_quads import disk_points, sector_quads

#: Quads that are searched together.
BATCH = 400_000

Points = npt.NDArray[np.complex128]


@dataclass(frozen=True, kw_only=True)
class PointCover:
    """Numbers of random points: in all, in no quad, and in more than one."""

    points: int
    uncovered: int
    twice: int


def random_points(tree: GreedyTree, count: int, *, seed: int) -> Points:
    """Points (count,) of the first initial sector in the Poincare disk, uniform by area."""
    random = np.random.default_rng(seed)
    theta = float(tree.parameters.phi0) * random.random(count)
    half = np.sinh(float(tree.parameters.radius) / 2) * np.sqrt(random.random(count))
    return np.asarray(half / np.sqrt(1 + half * half) * np.exp(1j * theta))


def contained(points: Points, corners: Points) -> npt.NDArray[np.int64]:
    """Number of geodesic quads, corners (n, 4) in the Poincare disk, that hold each point (m,).

    The side of the geodesic from a to b on which z lies is the sign of a determinant; both
    orientations of a quad serve.
    """
    from scipy.spatial import cKDTree

    centres = corners.mean(axis=1)
    tree = cKDTree(np.column_stack([centres.real, centres.imag]))
    near = tree.query_ball_point(
        np.column_stack([points.real, points.imag]), _reach(points, corners, centres)
    )
    sizes = np.fromiter(map(len, near), dtype=np.int64, count=len(points))
    of_point = np.repeat(np.arange(len(points)), sizes)
    quads = np.fromiter((q for found in near for q in found), dtype=np.int64, count=sizes.sum())
    inside = _inside(points[of_point], corners[quads])
    return np.bincount(of_point[inside], minlength=len(points))


def _reach(points: Points, corners: Points, centres: Points) -> Any:
    """Radius around each point within which the centre of a quad that holds it must lie.

    The quads have one size on H^2, which the disk scales by (1 - |z|^2)/2; a tenth for its change
    across a quad.
    """
    size = np.abs(corners - centres[:, np.newaxis]).max(axis=1) / (1 - np.abs(centres) ** 2)
    return 1.1 * size.max() * (1 - np.abs(points) ** 2)


def _lift(z: Any) -> Any:
    """Triples (..., 3) of the hyperboloid, up to a factor: determinants keep their sign."""
    square = np.abs(z) ** 2
    return np.stack([1 + square, 2 * z.real, 2 * z.imag], axis=-1)


def _inside(z: Points, corners: Points) -> Any:
    x, p = _lift(z), _lift(corners)
    sides = [
        np.linalg.det(np.stack([x, p[:, k], p[:, (k + 1) % 4]], axis=-2)) > 0 for k in range(4)
    ]
    same = np.stack(sides)
    return same.all(axis=0) | (~same).all(axis=0)


def _batches(tree: GreedyTree) -> Iterator[tuple[bool, Points]]:
    """Corners of kept quads in batches, and whether they belong to sectors that are mirrored."""
    waiting: dict[bool, list[Points]] = {True: [], False: []}
    for _, sector, found in walked(tree):
        quads = sector_quads(tree.parameters, sector, found)
        waiting[sector.mirrored].append(disk_points(sector.place, quads.corners()))
        if sum(map(len, waiting[sector.mirrored])) > BATCH:
            yield sector.mirrored, np.concatenate(waiting[sector.mirrored])
            waiting[sector.mirrored] = []
    for mirrored, rest in waiting.items():
        if sum(map(len, rest)):
            yield mirrored, np.concatenate(rest)


def point_cover(tree: GreedyTree, count: int, *, seed: int) -> PointCover:
    """Cover of the first initial sector, whose images make up the disk.

    A sector that is not mirrored stands for its mirror image too: it is tried on the points and on
    their images in the bisector.
    """
    points = random_points(tree, count, seed=seed)
    turn = np.exp(1j * float(tree.parameters.phi0))
    held = np.zeros(count, dtype=np.int64)
    for mirrored, corners in _batches(tree):
        held += contained(points, corners)
        if not mirrored:
            held += contained(turn * points.conj(), corners)
    return PointCover(points=count, uncovered=int((held == 0).sum()), twice=int((held > 1).sum()))
