"""Section 4.1, items 4 and 6: the first stage of the dual, and branch points that move.

Nets by advanced angles, distances from the origin by SL(2, R) frames. One sector of a star is cut;
at the first stage of the dual 3^g sectors are put in there, at a cut of the algorithm three.
"""

from fractions import Fraction
from functools import cache
from math import ceil, pi

import numpy as np
import numpy.typing as npt

from checks.evidence import Evidence, Setting
from checks.verify.greedy_dual_result import generations_expected
from checks.verify.greedy_samples import tree_of
from checks.verify.printed_runs import found
from discrete.branched_net import BranchedNet, geodesic_ray, star, surgery
from discrete.placed_frames import placed_distances

Flags = npt.NDArray[np.bool_]

STEPS = ("1/20", "1/40")


@cache
def cut_star(half: int, cut: tuple[int, int], inserted: int, edges: int, step: str) -> BranchedNet:
    """Star of 2m Amsler sectors, the first cut and filled with so many sectors of equal angles."""
    length = float(Fraction(step))
    ray = geodesic_ray([length] * edges)
    net = star([ray] * (2 * half), [pi / half] * (2 * half))
    new = [
        geodesic_ray([length] * (edges - cut[(k + 1) % 2])) for k in range(inserted - 1)
    ]  # u- and v-rays alternate
    return surgery(net, 0, cut, rays=new)


def reached(near: Flags, angles: npt.NDArray[np.float64]) -> Flags:
    """Nodes near the centre that are reached from the corner through such nodes with phi < pi."""
    kept = np.zeros_like(near)
    kept[0, 0] = near[0, 0]
    through = near & (angles < pi)
    for total in range(1, sum(near.shape) - 1):
        j = np.arange(max(0, total - near.shape[1] + 1), min(total, near.shape[0] - 1) + 1)
        k = total - j
        left, below = np.maximum(j - 1, 0), np.maximum(k - 1, 0)
        from_left = (j > 0) & kept[left, k] & through[left, k]
        from_below = (k > 0) & kept[j, below] & through[j, below]
        kept[j, k] = near[j, k] & (from_left | from_below)
    return kept


def widest(radius: str, half: int, cutoff: str, step: str, by: str) -> tuple[float, float]:
    """Largest angle in the disk at the first stage, and the distance of the first beyond pi.

    by: what m_0 keeps in the disk, phi < pi (`edge`) or phi <= phi* (`cutoff`).
    """
    tree = tree_of(radius, step, str(2 * half), cutoff)
    cut = (int(tree.sectors[0]["i_cut"]), int(tree.sectors[0]["k_cut"]))
    edges = ceil(Fraction(radius) / Fraction(step)) + 4
    g = generations_expected(radius, half, "1" if by == "edge" else cutoff)
    net = cut_star(half, cut, 3**g, edges, step)
    distances = placed_distances(net)
    best = (0.0, 0.0)
    for number in range(2 * half, len(net.placed)):
        angles = net.placed[number].sector.angles
        far = distances[number][: angles.shape[0], : angles.shape[1]]
        inside = np.where(reached(far <= float(Fraction(radius)), angles), angles, 0.0)
        beyond = inside >= pi
        at = np.unravel_index(int(inside.argmax()), inside.shape)
        place = far[beyond].min() if beyond.any() else far[at]
        best = max(best, (float(inside[at]), float(place)))
    return best


def stage_one(
    setting: Setting,
    *,
    half: int = 6,
    radius: str = "5",
    cutoff: str = "1/2",
    level: str = "1",
    by: str = "cutoff",
) -> Evidence:
    """Whether the sectors of the first stage stay below level pi inside the disk of radius R.

    half: m; by: as in `widest`. A sector that reaches pi has a singular edge there and covers
    nothing beyond it.
    """
    del setting
    failures, told = [], []
    for step in STEPS:
        angle, far = widest(radius, half, cutoff, step, by)
        told.append(f"{angle / pi:.3f} pi")
        if angle >= float(Fraction(level)) * pi:
            failures.append(
                f"R = {radius}, m = {half}, phi* = {cutoff} pi, edges {step}: phi = "
                f"{angle / pi:.3f} pi at the distance {far:.3f}"
            )
    return found(failures, shown=f"largest angles {', '.join(told)}", tried=len(STEPS))


def _moves(setting: Setting, both: bool) -> list[tuple[int, tuple[int, int], tuple[int, int]]]:
    """Values of m with corners and the edges by which these move; one far off the mirror line."""
    random = setting.random()
    ways = [(1, 1)] if both else [(1, 0), (0, 1), (1, 1)]
    found_moves = [] if both else [(6, (14, 3), (0, 1))]
    for half in (6, 8, 12):
        for _ in range(4):
            corner = (random.randint(3, 14), random.randint(3, 14))
            found_moves.append((half, corner, random.choice(ways)))
    return found_moves


def moves_outward(
    setting: Setting, *, both: bool = False, direction: int = 1, least: str = "0"
) -> Evidence:
    """Whether all points of the daughters go away from the origin when their corner does.

    Points at one place (u, v) of their sector, where phi < pi/2 before and after; both: only where
    both coordinates of the corner grow; direction: -1 moves it inward; least: of the way, in edges.
    """
    failures, tried = [], 0
    step, edges = STEPS[0], 84
    for half, old, by in _moves(setting, both):
        new = (old[0] + direction * by[0], old[1] + direction * by[1])
        before, after = (cut_star(half, cut, 3, edges, step) for cut in (old, new))
        far = [placed_distances(net) for net in (before, after)]
        for number in range(2 * half, 2 * half + 3):
            angles = [net.placed[number].sector.angles for net in (before, after)]
            n, m = (min(a, b) for a, b in zip(angles[0].shape, angles[1].shape, strict=True))
            wide = np.maximum(angles[0][:n, :m], angles[1][:n, :m])
            flat = np.maximum.accumulate(np.maximum.accumulate(wide, axis=0), axis=1) < pi / 2
            start = far[0][number][:n, :m][flat]
            way = far[1][number][:n, :m][flat] - start
            tried += way.size
            if way.min(initial=np.inf) <= float(Fraction(least)) * float(Fraction(step)):
                at = int(way.argmin())
                failures.append(
                    f"m = {half}, edges {step}, corner from {old} to {new}: a point at the "
                    f"distance {start[at]:.3f} moves by {way[at]:.4f}"
                )
    return found(failures, shown=f"{tried} points of daughters", tried=tried)
