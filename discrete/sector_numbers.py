"""Numbers of the vertices that the sectors of an initial sector share along their sides.

An image of a sector is itself or its reflection in the bisector of the initial sector; a sector
that is its own reflection has one image. Along a side a daughter takes the numbers that its parent
or its sister has given.
"""

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from discrete.greedy_tree import LETTERS
from discrete.sector_cutter import CutSector
from discrete.sector_sides import SectorSides

IntArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]

#: Images of a sector.
ITSELF, REFLECTED = 0, 1


def corners_of(kept: BoolArray) -> BoolArray:
    """Vertices (n + 1, m + 1) of the kept quads (n, m)."""
    found = np.zeros((kept.shape[0] + 1, kept.shape[1] + 1), dtype=bool)
    for i in (0, 1):
        for j in (0, 1):
            found[i : i + kept.shape[0], j : j + kept.shape[1]] |= kept
    return found


@dataclass(frozen=True, kw_only=True, eq=False)
class VertexNumbers:
    """Numbers given so far; sides: what the daughters of a path take, by its two images."""

    sides: dict[tuple[str, int], tuple[IntArray | None, IntArray | None]] = field(
        default_factory=dict
    )
    count: list[int] = field(default_factory=lambda: [0])

    def numbered(
        self, path: str, sector: SectorSides, found: CutSector, kept: BoolArray
    ) -> list[tuple[int, IntArray, IntArray]]:
        """For each image of a sector: which, its numbers (n + 1, m + 1), and the new ones, flat.

        -1 where no kept quad has its corner; the new ones are indices into the flat array.
        """
        used = corners_of(kept)
        images = [ITSELF] if sector.mirrored else [ITSELF, REFLECTED]
        answer = []
        for image in images:
            numbers = np.full(used.shape, -1, dtype=np.int64)
            first, second = self.sides.pop((path, image), (None, None))
            if first is not None:
                size = min(len(first), len(numbers))
                numbers[:size, 0] = first[:size]
            if second is not None:
                size = min(len(second), len(numbers[0]))
                numbers[0, :size] = second[:size]
            fresh = np.flatnonzero((used & (numbers < 0)).ravel())
            numbers.ravel()[fresh] = self.count[0] + np.arange(len(fresh))
            self.count[0] += len(fresh)
            answer.append((image, numbers, fresh))
        self._hand_down(path, sector, found, answer)
        return answer

    def _hand_down(
        self, path: str, sector: SectorSides, found: CutSector,
        images: list[tuple[int, IntArray, IntArray]],
    ) -> None:  # fmt: skip
        """Leave to the daughters and to the next sister the numbers along shared sides."""
        for image, numbers, _ in images:
            if found.cut is not None:
                i, k = found.cut
                row, column = numbers[i:, k], numbers[i, k:]
                self.sides[path + "u", image] = (row, None)
                if sector.mirrored:
                    self.sides[path + "u", REFLECTED] = (column, None)
                else:
                    self.sides[path + "v", image] = (None, column)
            letter = LETTERS[sector.letter]
            if letter == "u":
                self._to_middle(path[:-1] + "A", image, numbers[0])
            elif letter == "A" and not sector.mirrored:
                self.sides[path[:-1] + "v", image] = (
                    numbers[:, 0],
                    self.sides.get((path[:-1] + "v", image), (None, None))[1],
                )

    def _to_middle(self, path: str, image: int, numbers: IntArray) -> None:
        """Leave the second side of a sister u to the middle sector.

        Where that is its own reflection it has both: the reflected u is at its first side.
        """
        own = set(path) == {"A"}
        first, second = self.sides.get((path, ITSELF if own else image), (None, None))
        if own and image == REFLECTED:
            self.sides[path, ITSELF] = (numbers, second)
        else:
            self.sides[path, image] = (first, numbers)
