"""The whole net of a run of the greedy algorithm: in the disk, and its K-surface in space.

One initial sector is filled; the others are its images. On H^2 these are rotations about the centre
and reflections in the sides; in space the reflection in a side, which is a straight line, becomes
the half-turn about it, and the one in the bisector of a sector becomes that in the plane of the
bisector and the normal.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from discrete.angle_kernel import filled_angles
from discrete.greedy_parameters import GreedyParameters
from discrete.greedy_tree import GreedyTree
from discrete.greedy_walk import walked
from discrete.sector_cutter import CutSector
from discrete.sector_numbers import REFLECTED, VertexNumbers
from discrete.sector_quads import disk_points, sector_quads
from discrete.sector_sides import SectorSides
from discrete.sector_surface import STANDARD, CornerFrame, daughter_frames, sector_surface
from discrete.space_forms import H2

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]


@dataclass(frozen=True, kw_only=True, eq=False)
class GreedyNet:
    """Net of the disk: V vertices, Q quads (Q, 4) of their numbers p, p_u, p_uv, p_v.

    disk: complex positions in the Poincare disk; points, normals: (V, 3) of the K-surface;
    vertex_angles, vertex_curvatures: mean of phi over the quads around a vertex, and the larger
    principal curvature there; quad_angles: phi in the middle of each quad; generation, sector: of
    the sector that a quad, or a vertex, belongs to.
    """

    parameters: GreedyParameters
    disk: npt.NDArray[np.complex128]
    points: FloatArray
    normals: FloatArray
    quads: IntArray
    quad_angles: FloatArray
    quad_generations: IntArray
    quad_sectors: IntArray

    def _at_vertices(self, values: FloatArray) -> FloatArray:
        corners = self.quads.ravel()
        sums = np.bincount(corners, weights=np.repeat(values, 4), minlength=len(self.disk))
        return np.asarray(sums / np.bincount(corners, minlength=len(self.disk)))

    @property
    def vertex_angles(self) -> FloatArray:
        """Angle phi at the vertices: mean over the quads around each."""
        return self._at_vertices(self.quad_angles)

    @property
    def vertex_curvatures(self) -> FloatArray:
        """Larger principal curvature at the vertices."""
        half = self.vertex_angles / 2
        return np.asarray(np.maximum(np.tan(half), 1 / np.tan(half)))

    def first_quad(self, values: IntArray) -> IntArray:
        """Values of the quads carried to their vertices: of the first quad that has each."""
        found = np.empty(len(self.disk), dtype=np.int64)
        found[self.quads[::-1].ravel()] = np.repeat(values[::-1], 4)
        return found


@dataclass(frozen=True, kw_only=True, eq=False)
class _Wedge:
    """One initial sector: vertices, quads, and the vertices on its two axes from the centre on."""

    disk: Any
    points: FloatArray
    normals: FloatArray
    quads: IntArray
    angles: FloatArray
    generations: IntArray
    sectors: IntArray
    first: IntArray
    second: IntArray


def _middle_angles(parameters: GreedyParameters, sector: SectorSides) -> FloatArray:
    """Angle phi = A + D/2 in the middle of each quad (n, m) of a sector."""
    n, m = len(sector.first_turns) - 1, len(sector.second_turns) - 1
    step = float(parameters.step)
    angles, defects = filled_angles(
        H2, [step] * n, [step] * m, sector.opening,
        sector.first_turns[1:n].tolist(), sector.second_turns[1:m].tolist(),
    )  # fmt: skip
    return np.asarray(angles + defects / 2)


class _Gatherer:
    """Collects the sectors of one wedge."""

    def __init__(self, tree: GreedyTree) -> None:
        self.parameters = tree.parameters
        half = float(tree.parameters.phi0) / 2
        self.bisector = np.exp(2j * half)
        across = np.array([-np.sin(half), np.cos(half), 0.0])
        self.reflection = np.eye(3) - 2 * np.outer(across, across)
        self.numbers = VertexNumbers()
        self.frames = {"": STANDARD}
        self.parts: dict[str, list[Any]] = {
            name: [] for name in ("at", "disk", "points", "normals", "quads", "angles", "of")
        }
        self.axes: tuple[IntArray, IntArray] | None = None

    def add(self, path: str, sector: SectorSides, found: CutSector, number: int) -> None:
        """Take in a sector and its reflection."""
        quads = sector_quads(self.parameters, sector, found)
        frame: CornerFrame = self.frames.pop(path)
        points, normals = sector_surface(float(self.parameters.step), sector, frame)
        if found.cut is not None:
            below = daughter_frames(sector, found.cut, found.cut_angle, points, normals)
            self.frames.update({path + "-uAv"[letter]: f for letter, f in below.items()})
        angles = _middle_angles(self.parameters, sector)[quads.kept]
        flat = [np.moveaxis(a, 0, -1).reshape(-1, 3) for a in (quads.vertices, points, normals)]
        for image, numbers, fresh in self.numbers.numbered(path, sector, found, quads.kept):
            if self.axes is None:
                self.axes = numbers[:, 0], numbers[0]
            disk = disk_points(sector.place, flat[0][fresh])
            space = [a[fresh] for a in flat[1:]]
            if image == REFLECTED:
                disk = self.bisector * disk.conj()
                space = [a @ self.reflection for a in space]
            self.parts["at"].append(numbers.ravel()[fresh])
            self.parts["disk"].append(disk)
            self.parts["points"].append(space[0])
            self.parts["normals"].append(space[1])
            corners = (numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:])
            self.parts["quads"].append(np.stack([c[quads.kept] for c in corners], axis=-1))
            self.parts["angles"].append(angles)
            entry = [sector.generation, 2 * number + image]
            self.parts["of"].append(np.tile(entry, (len(angles), 1)))

    def wedge(self) -> _Wedge:
        """Everything in order."""
        joined = {name: np.concatenate(parts) for name, parts in self.parts.items()}
        order = np.argsort(joined["at"])
        first, second = self.axes or (np.zeros(1, np.int64), np.zeros(1, np.int64))
        return _Wedge(
            disk=joined["disk"][order],
            points=joined["points"][order],
            normals=joined["normals"][order],
            quads=joined["quads"],
            angles=joined["angles"],
            generations=joined["of"][:, 0],
            sectors=joined["of"][:, 1],
            first=first[first >= 0],
            second=second[second >= 0],
        )


def _images(wedge: _Wedge, count: int) -> list[IntArray]:
    """Numbers of the vertices of each image of the wedge; images share the axes between them."""
    inner = np.ones(len(wedge.disk), dtype=bool)
    inner[wedge.first] = inner[wedge.second] = False
    inner_at, size = np.flatnonzero(inner), int(inner.sum())
    axis = len(wedge.first) - 1
    start = 1 + count * axis
    found = []
    for k in range(count):
        numbers = np.empty(len(wedge.disk), dtype=np.int64)
        numbers[inner_at] = start + k * size + np.arange(size)
        rays = (k, (k + 1) % count) if k % 2 == 0 else ((k + 1) % count, k)
        for side, ray in zip((wedge.first, wedge.second), rays, strict=True):
            numbers[side[1:]] = 1 + ray * axis + np.arange(axis)
        numbers[wedge.first[0]] = 0
        found.append(numbers)
    return found


def _moves(phi0: float, k: int) -> tuple[Any, FloatArray, float]:
    """Image k: factor of z, or of its conjugate for odd k; matrix in space; sign of the normals."""
    if k % 2 == 0:
        c, s = np.cos(k * phi0), np.sin(k * phi0)
        return np.exp(1j * k * phi0), np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]), 1.0
    c, s = np.cos((k + 1) * phi0), np.sin((k + 1) * phi0)
    return np.exp(1j * (k + 1) * phi0), np.array([[c, s, 0], [s, -c, 0], [0, 0, -1]]), -1.0


def greedy_net(tree: GreedyTree) -> GreedyNet:
    """Net of the whole disk and its K-surface, the centre at the origin with normal x3."""
    gatherer = _Gatherer(tree)
    for number, (path, sector, found) in enumerate(walked(tree)):
        gatherer.add(path, sector, found, number)
    wedge, count = gatherer.wedge(), tree.parameters.sectors
    numbers = _images(wedge, count)
    size = 1 + max(int(n.max()) for n in numbers)
    disk = np.empty(size, dtype=np.complex128)
    points, normals = np.empty((size, 3)), np.empty((size, 3))
    for k, at in enumerate(numbers):
        factor, matrix, sign = _moves(float(tree.parameters.phi0), k)
        disk[at] = factor * (wedge.disk if k % 2 == 0 else wedge.disk.conj())
        points[at] = wedge.points @ matrix.T
        normals[at] = sign * wedge.normals @ matrix.T
    per_wedge = 1 + int(wedge.sectors.max())
    return GreedyNet(
        parameters=tree.parameters,
        disk=disk,
        points=points,
        normals=normals,
        quads=np.concatenate([at[wedge.quads] for at in numbers]),
        quad_angles=np.tile(wedge.angles, count),
        quad_generations=np.tile(wedge.generations, count),
        quad_sectors=np.concatenate([k * per_wedge + wedge.sectors for k in range(count)]),
    )
