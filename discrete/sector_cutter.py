"""Cuts sectors one after another in the same working arrays, by the compiled kernel."""

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from discrete import sector_cut, sector_sweep
from discrete.complex_errors import SurgeryError
from discrete.greedy_parameters import GreedyParameters
from discrete.sector_sides import Place, SectorSides, daughters, place_of, start_frame


class TooNarrowError(Exception):
    """The ring swept around the disk is too narrow: internal, the run is begun anew."""


@dataclass(frozen=True, kw_only=True, eq=False)
class CutSector:
    """What the sweep of a sector found: see SECTOR of discrete.greedy_tree; None where not cut."""

    cut: tuple[int, int] | None
    place: Place | None
    cut_angle: float
    area: float
    willmore: float
    largest: float
    smallest: float
    quads: int
    daughters: list[SectorSides]


@dataclass(frozen=True, kw_only=True, eq=False)
class Cutter:
    """Working arrays for the sectors of one run; margin: width of the ring around the disk."""

    parameters: GreedyParameters
    margin: float
    run: Any = field(init=False)
    arrays: Any = field(init=False)

    def __post_init__(self) -> None:
        reach = 2 * (float(self.parameters.radius) + self.margin)
        n = math.ceil(reach / float(self.parameters.step)) + 8
        lanes = sector_sweep.LANES
        arrays = {
            "w": np.zeros(sector_sweep.STATES),
            "buffers": np.zeros((2, 3, n + lanes, lanes)),
            "sums": np.zeros((n + lanes, sector_sweep.SUMS)),
            "found": np.zeros(sector_sweep.FOUND, dtype=np.int64),
            **{name: np.zeros(n) for name in ("row_h", "row_t", "column_h", "column_t")},
            "counts": np.zeros(4, dtype=np.int64),
            "totals": np.zeros(6),
        }
        object.__setattr__(self, "run", self.parameters.run_constants(self.margin))
        object.__setattr__(self, "arrays", arrays)

    def __call__(self, sector: SectorSides, number: int) -> CutSector:
        """Sweep a sector, which has this number in the tree.

        Raises TooNarrowError, and SurgeryError where rounding cannot place the cut.
        """
        status = sector_cut.cut_kernel()(
            self.run,
            *(sector.first_heights, sector.first_turns),
            *(sector.second_heights, sector.second_turns),
            sector.mirrored,
            *self.arrays.values(),
        )
        if status == sector_cut.TOO_NARROW:
            raise TooNarrowError
        if status == sector_cut.TIE:
            raise SurgeryError(_refusal(sector))
        cut = status == sector_cut.CUT
        totals = self.arrays["totals"].tolist()
        place, found = self._daughters(sector, number) if cut else (None, [])
        i, k = self.arrays["counts"].tolist()[:2]
        return CutSector(
            cut=(i, k) if cut else None,
            place=place,
            cut_angle=totals[sector_cut.CUT_ANGLE] if cut else math.nan,
            area=totals[sector_cut.AREA],
            willmore=totals[sector_cut.WILLMORE],
            largest=totals[sector_cut.LARGEST],
            smallest=totals[sector_cut.SMALLEST],
            quads=int(totals[sector_cut.QUADS]),
            daughters=found,
        )

    def _daughters(self, sector: SectorSides, number: int) -> tuple[Place, list[SectorSides]]:
        arrays = self.arrays
        i, k, row_edges, column_edges = arrays["counts"].tolist()
        frame = np.array(start_frame(sector.place))
        sector_cut.path_kernel()(
            *(frame, float(self.parameters.step), sector.opening, float(sector.place.hand)),
            *(sector.second_turns, k, arrays["row_t"], i),
        )
        place = place_of(tuple(frame.tolist()), sector.place)
        row = arrays["row_h"][i : row_edges + 1].copy(), arrays["row_t"][i : row_edges + 1].copy()
        row[1][0] = 0.0
        column = (
            arrays["column_h"][: column_edges + 1].copy(),
            arrays["column_t"][: column_edges + 1].copy(),
        )
        cut_angle = float(arrays["totals"][sector_cut.CUT_ANGLE])
        column[1][0] = cut_angle / 3
        found = daughters(
            self.parameters, float(self.run[sector_sweep.COSH_OUTER]), sector, number, place,
            cut_angle, row, column,
        )  # fmt: skip
        return place, found


def _refusal(sector: SectorSides) -> str:
    return (
        f"the sector of generation {sector.generation} at distance {sector.place.rho:.6g} has a "
        "cut that rounding cannot place, since its rows and columns disagree: change the step or "
        "the cutoff a little"
    )
