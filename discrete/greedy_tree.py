"""Result of the greedy algorithm: the tree of sectors, and the branch points of the whole disk.

The initial star is its own image under rotations and reflections. Sectors that are images of one
another are swept once; the copies are made on output.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from math import pi, tan
from typing import Any

import numpy as np
import numpy.typing as npt

from discrete.errors import ShapeError
from discrete.greedy_parameters import GreedyParameters

LETTERS = "-uAv"

#: A sector swept; letter: its place among its parent's daughters, an index into LETTERS.
SECTOR = np.dtype(
    [
        *(("parent", np.int64), ("letter", np.uint8), ("generation", np.int32)),
        *(("copies", np.int64), ("mirrored", np.bool_), ("hand", np.int8)),
        *(("theta", np.float64), ("rho", np.float64), ("heading", np.float64)),
        *(("opening", np.float64), ("cut", np.bool_), ("i_cut", np.int64), ("k_cut", np.int64)),
        *(("cut_angle", np.float64), ("cut_theta", np.float64), ("cut_rho", np.float64)),
        *(("area", np.float64), ("willmore", np.float64), ("quads", np.int64)),
        *(("largest", np.float64), ("smallest", np.float64)),
    ]
)


@dataclass(frozen=True, kw_only=True)
class BranchPoint:
    """Branch point other than the centre: rho, theta: distance and direction from the centre.

    path: number of the initial sector, then the letters of the sectors cut; angle: opening of its
    daughters, a third of cut_angle.
    """

    generation: int
    path: str
    parent: str
    rho: float
    theta: float
    angle: float
    cut_angle: float
    distance_to_rim: float


@dataclass(frozen=True, kw_only=True, eq=False)
class GreedyTree:
    """Sectors of a run, as a read-only array of SECTOR, each after its parent.

    terminated: whether every sector was swept; margin: width of the ring swept around the disk.
    """

    parameters: GreedyParameters
    sectors: npt.NDArray[Any]
    terminated: bool
    margin: float

    def __post_init__(self) -> None:
        if self.sectors.dtype != SECTOR or self.sectors.ndim != 1 or len(self.sectors) == 0:
            raise ShapeError("the sectors of a tree are an array of SECTOR, not empty")
        if (self.sectors["parent"] >= np.arange(len(self.sectors))).any():
            raise ShapeError("a sector of the tree stands before its parent")
        self.sectors.setflags(write=False)

    @property
    def sector_count(self) -> int:
        """Number of sectors of the whole disk."""
        return int(self.sectors["copies"].sum())

    @property
    def branch_point_count(self) -> int:
        """Number of branch points; the centre is one where more than four sectors meet there."""
        return int(self.sectors["copies"][self.sectors["cut"]].sum()) + (
            self.parameters.sectors > 4
        )

    @property
    def unresolved_cuts(self) -> int:
        """Cuts on a side of their sector: a smaller step would place them within."""
        on_side = (self.sectors["i_cut"] == 0) | (self.sectors["k_cut"] == 0)
        return int(self.sectors["copies"][self.sectors["cut"] & on_side].sum())

    @property
    def generations(self) -> int:
        """Largest generation of a branch point; 0 without any but the centre."""
        cut = self.sectors["cut"]
        return int((self.sectors["generation"][cut] + 1).max(initial=0))

    @property
    def min_angle(self) -> float:
        """Least angle phi (eq:angle) at a vertex of the disk, towards the next u- and v-vertex."""
        return float(self.sectors["smallest"].min())

    @property
    def max_angle(self) -> float:
        """Largest angle phi (eq:angle) at a vertex of the disk, towards the next vertices."""
        return float(self.sectors["largest"].max())

    @property
    def max_curvature(self) -> float:
        """Larger of tan(phi/2) and cot(phi/2) over the extremes of the angle (ebound)."""
        return max(tan(self.max_angle / 2), 1 / tan(self.min_angle / 2))

    @property
    def area(self) -> float:
        """Area of the kept quads, clipped to the disk."""
        return float(np.dot(self.sectors["area"], self.sectors["copies"]))

    @property
    def willmore(self) -> float:
        """Integral of kappa1^2 + kappa2^2 over the disk."""
        return float(np.dot(self.sectors["willmore"], self.sectors["copies"]))

    @cached_property
    def paths(self) -> list[str]:
        """Letters of each sector below the initial one."""
        found: list[str] = []
        for parent, letter in zip(
            self.sectors["parent"].tolist(), self.sectors["letter"].tolist(), strict=True
        ):
            found.append("" if parent < 0 else found[parent] + LETTERS[letter])
        return found

    def branch_points(self) -> Iterator[BranchPoint]:
        """Branch points of the whole disk other than the centre, sector by sector.

        Every initial sector is the image of the first by a rotation or a reflection in a side, and
        each is its own image by the reflection in its bisector, which swaps u and v.
        """
        radius, phi0 = float(self.parameters.radius), float(self.parameters.phi0)
        swap = str.maketrans("uv", "vu")
        for number in range(self.parameters.sectors):
            for sector, path in zip(self.sectors, self.paths, strict=True):
                if not sector["cut"]:
                    continue
                theta = float(sector["cut_theta"])
                images = [(theta, path)]
                if not sector["mirrored"]:
                    images.append((phi0 - theta, path.translate(swap)))
                for angle, letters in images:
                    turned = angle if number % 2 == 0 else phi0 - angle
                    yield BranchPoint(
                        generation=int(sector["generation"]) + 1,
                        path=f"{number}{letters}",
                        parent=f"{number}{letters[:-1]}" if letters else "",
                        rho=float(sector["cut_rho"]),
                        theta=(turned + number * phi0) % (2 * pi),
                        angle=float(sector["cut_angle"]) / 3,
                        cut_angle=float(sector["cut_angle"]),
                        distance_to_rim=radius - float(sector["cut_rho"]),
                    )
