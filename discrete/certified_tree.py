"""Result of the greedy algorithm in balls: the tree of sectors, with an enclosure of every number.

Letters of a path: u, A, v, the daughters of each cut on the way from the initial sector. Vertices
(i, j) are counted from the corner of their sector.
"""

from dataclasses import dataclass

from discrete.enclosure import Enclosure
from discrete.greedy_parameters import GreedyParameters


@dataclass(frozen=True, kw_only=True)
class Extreme:
    """Extreme angle and the first vertex, row by row, that has it as far as the balls tell."""

    angle: Enclosure
    vertex: tuple[int, int]


@dataclass(frozen=True, kw_only=True)
class CertifiedCut:
    """Cut at vertex (i, k): its angle, polar coordinates, and why no more was kept.

    row, column: the first vertices with an angle beyond the cutoff, in the first row and the first
    column that have one: in the disk, or at a flipped quad that meets it.
    """

    i: int
    k: int
    angle: Enclosure
    rho: Enclosure
    theta: Enclosure
    row: Extreme
    column: Extreme


@dataclass(frozen=True, kw_only=True)
class CertifiedSector:
    """Sector swept; copies, mirrored: as in SECTOR of discrete.greedy_tree.

    largest, smallest: of the angles at the kept vertices in the disk, None without any.
    """

    path: str
    copies: int
    mirrored: bool
    opening: Enclosure
    quads: int
    largest: Extreme | None
    smallest: Extreme | None
    cut: CertifiedCut | None


@dataclass(frozen=True, kw_only=True)
class CertifiedTree:
    """Sectors of a run that ended, each after its parent; bits: the precision that decided all."""

    parameters: GreedyParameters
    sectors: tuple[CertifiedSector, ...]
    bits: int

    @property
    def sector_count(self) -> int:
        """Number of sectors of the whole disk."""
        return sum(sector.copies for sector in self.sectors)

    @property
    def branch_point_count(self) -> int:
        """Number of branch points; the centre is one where more than four sectors meet there."""
        cuts = sum(sector.copies for sector in self.sectors if sector.cut)
        return cuts + (self.parameters.sectors > 4)

    @property
    def quad_count(self) -> int:
        """Number of kept quads of the whole disk that meet it."""
        return sum(sector.copies * sector.quads for sector in self.sectors)

    @property
    def generations(self) -> int:
        """Largest generation of a branch point; 0 without any but the centre."""
        return max((len(sector.path) + 1 for sector in self.sectors if sector.cut), default=0)
