"""A sector Omega_n of the greedy algorithm as printed: axes, nodes, angles, cut (steps 4 to 17)."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from checks.printed import poincare_disk
from checks.printed.disk_net import ARRAYS, filled_disk
from checks.printed.greedy_reading import Reading

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]
Node = tuple[int, int]


@dataclass(frozen=True, kw_only=True, eq=False)
class PrintedSector:
    """Nodes zeta (2, n + 1, m + 1) in the disk, which of them are kept, the angles at those.

    angles: NaN where one of the next nodes is not kept; parent: place of the parent in the list,
    -1 for an initial sector; letter: u, A, v for Omega_{M+1}, Omega_{M+2}, Omega_{M+3}.
    """

    zeta: Floats
    kept: Flags
    angles: Floats
    parent: int
    path: str
    cut: Node | None = None

    @property
    def quads(self) -> Flags:
        """Whether all four nodes of each quad (n, m) are kept."""
        k = self.kept
        return np.asarray(k[:-1, :-1] & k[1:, :-1] & k[:-1, 1:] & k[1:, 1:])

    def corners(self) -> Any:
        """Corners (quads, 4) of the kept quads, complex numbers, and the angles at the first."""
        z = self.zeta[0] + 1j * self.zeta[1]
        four = (z[:-1, :-1], z[1:, :-1], z[1:, 1:], z[:-1, 1:])
        return np.stack([corner[self.quads] for corner in four], axis=1)


def ray(edges: int, step: float, direction: float, start: tuple[float, float]) -> Floats:
    """Nodes (2, edges + 1) of a geodesic from `start` (eq:poincare-surgery), (item C)."""
    from_origin = poincare_disk.on_ray(np.arange(edges + 1), step, direction, ARRAYS)
    return np.stack(poincare_disk.moebius(from_origin, start))


def inside(zeta: Floats, radius: float) -> Flags:
    """Whether nodes lie in the closed disk of this radius (eq:hyp_radius)."""
    return np.asarray(np.hypot(zeta[0], zeta[1]) <= np.tanh(radius / 2) * (1 + 1e-14))


def undiscarded(zeta: Floats, radius: float, reading: Reading) -> Flags:
    """Nodes left by steps 6 and 20; on an axis the one predecessor counts."""
    near = inside(zeta, radius)
    counted = np.zeros((near.shape[0] + 1, near.shape[1] + 1), dtype=np.bool_)
    kept = np.zeros_like(near)
    if reading.by_place:
        counted[1:, 1:] = near
        kept = counted[:-1, 1:] | counted[1:, :-1]
        kept[0, 0] = True
        return kept
    for total in range(sum(near.shape) - 1):
        j = np.arange(max(0, total - near.shape[1] + 1), min(total, near.shape[0] - 1) + 1)
        k = total - j
        kept[j, k] = counted[j, k + 1] | counted[j + 1, k] | (total == 0)
        counted[j + 1, k + 1] = kept[j, k] & near[j, k]
    return kept


def angles(zeta: Floats, kept: Flags, reading: Reading) -> Floats:
    """Angles of steps 8 and 22 at the nodes (n + 1, m + 1), NaN where they are not determined."""
    found = np.full(kept.shape, np.nan)
    corners = tuple(zeta[:, :-1, :-1]), tuple(zeta[:, 1:, :-1]), tuple(zeta[:, :-1, 1:])
    value = poincare_disk.angle(*corners, ARRAYS)
    found[:-1, :-1] = np.where(
        kept[:-1, :-1] & kept[1:, :-1] & kept[:-1, 1:],
        value if reading.signed else np.abs(value),
        np.nan,
    )
    return found


def printed_sector(
    zeta: Floats, *, radius: float, reading: Reading, parent: int, path: str
) -> PrintedSector:
    """Sector of these nodes (steps 6 to 8 and 20 to 22)."""
    kept = undiscarded(zeta, radius, reading)
    return PrintedSector(
        zeta=zeta, kept=kept, angles=angles(zeta, kept, reading), parent=parent, path=path
    )


def too_wide(sector: PrintedSector, *, radius: float, cutoff: float, reading: Reading) -> Flags:
    """Nodes with phi > phi* that steps 11 to 13 and 25 look at."""
    wide = np.nan_to_num(sector.angles, nan=-np.inf) > cutoff
    wide &= sector.kept
    return wide if reading.all_nodes else wide & inside(sector.zeta, radius)


def cut_of(wide: Flags) -> Node | None:
    """Node (j*, k*) of steps 12 and 13; None where a set of which it is the largest is empty."""
    j, k = (int(np.argmax(wide.any(axis=axis))) - 1 for axis in (1, 0))
    return None if j < 0 or k < 0 else (j, k)


def excised(sector: PrintedSector, cut: Node) -> PrintedSector:
    """Sector after step 14."""
    j, k = cut
    kept = sector.kept.copy()
    kept[j + 1 :, k + 1 :] = False
    return replace(sector, kept=kept, cut=cut)


def daughters(
    sector: PrintedSector, cut: Node, before: Flags, *, edges: int, step: float, reading: Reading
) -> list[Floats]:
    """Nodes of the three sectors at a cut, u, A, v (steps 16, 17, 19).

    before: nodes kept before the cut; the axes of the middle sector cross: its u-axis is the one
    next to the v-line of the parent.
    """
    j, k = cut
    row, column = sector.zeta[:, j:, k], sector.zeta[:, j, k:]
    if reading.lost_axes:
        row = row[:, : _leading(before[j:, k])]
        column = column[:, : _leading(before[j, k:])]
    start = (float(row[0, 0]), float(row[1, 0]))
    away = (-start[0], -start[1])
    w1 = poincare_disk.moebius((row[0, 1], row[1, 1]), away)
    w2 = poincare_disk.moebius((column[0, 1], column[1, 1]), away)
    first, second = np.arctan2(w1[1], w1[0]) / np.pi, np.arctan2(w2[1], w2[0]) / np.pi
    if not reading.principal:
        second = first + 1 - (1 - (second - first)) % 2
    phi_1 = poincare_disk.trisecting(first, second, principal=reading.principal) * np.pi
    phi_2 = poincare_disk.trisecting(second, first, principal=reading.principal) * np.pi
    v_axis, u_axis = ray(edges, step, phi_1, start), ray(edges, step, phi_2, start)
    return [filled_disk(row, v_axis), filled_disk(u_axis, v_axis), filled_disk(u_axis, column)]


def _leading(flags: Flags) -> int:
    """Number of flags before the first that is down."""
    return len(flags) if flags.all() else int(np.argmin(flags))
