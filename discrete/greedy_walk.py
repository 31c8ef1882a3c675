"""Sectors of a run of the greedy algorithm one after another, with their sides and their cuts.

What a tree leaves out, since it would take memory in proportion to the area: for nets and pictures.
"""

from collections import deque
from collections.abc import Iterator

import numpy as np

from discrete.greedy_tree import LETTERS, GreedyTree
from discrete.sector_cutter import CutSector, Cutter
from discrete.sector_sides import SectorSides, initial_sector


def walked(tree: GreedyTree) -> Iterator[tuple[str, SectorSides, CutSector]]:
    """Sectors of the tree, parents first: letters of the path, the sector, and what became of it.

    One of each set of images, as in the tree; daughters that the tree does not hold are left out.
    """
    known = set(tree.paths)
    cutter = Cutter(parameters=tree.parameters, margin=tree.margin)
    outer = float(np.cosh(float(tree.parameters.radius) + tree.margin))
    waiting = deque([("", initial_sector(tree.parameters, outer))])
    while waiting:
        path, sector = waiting.popleft()
        found = cutter(sector, 0)
        yield path, sector, found
        named = [(path + LETTERS[below.letter], below) for below in found.daughters]
        waiting.extendleft(entry for entry in reversed(named) if entry[0] in known)
