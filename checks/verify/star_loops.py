"""Winding numbers of the normal of pseudospherical stars along loops of finite size."""

from math import pi, sin

import numpy as np

from checks.evidence import Evidence, Setting
from checks.printed import normal_map as printed
from checks.verify.normal_turning import STARS
from theory.sector_normals import sector_normals

_CELLS = 64
# From node to node, in radians: well below pi, so that no turn of the loop is lost.
_LARGEST_TURN = 2.0


def _loop(angles: list[float], bending: list[float], reach: float, *, swapped: bool) -> np.ndarray:
    """Components of N in the plane of e_1, e_2 along u + v = reach, sector after sector.

    bending: geodesic curvature of each ray; swapped: whether every ray has the torsion -1.
    """
    beta = np.concatenate(([0.0], np.cumsum(angles)))
    points = []
    for i in range(len(angles)):
        rays = (i, i + 1) if i % 2 == 0 else (i + 1, i)
        bend_u, bend_v = (np.array([bending[r % len(angles)]]) for r in rays)
        grid = sector_normals((beta[rays[0]], beta[rays[1]]), bend_u, bend_v, reach, _CELLS)
        # From ray i to ray i + 1, whichever of them is the u-curve.
        diagonal = np.array([grid[_CELLS - j, j, :2] for j in range(_CELLS + 1)])
        piece = diagonal if i % 2 == 0 else diagonal[::-1]
        points.append(piece[:, ::-1] if swapped and i % 2 else piece)
    return np.concatenate(points)


def winding_of_stars(
    setting: Setting, *, offset: int = 1, slope: int = -1, swapped: bool = False
) -> Evidence:
    """J_p along u + v = 7/5 s of stars whose rays have random curvatures in [-3, 3].

    s is sin(phi/2) for the least angle phi or pi - phi at the centre; swapped: N reflected on every
    other sector, so that the turning of neighbouring sectors is opposite.
    """
    rng = setting.random()
    wrong, gap = [], 0.0
    for name, exact in STARS.items():
        angles = [float(a) for a in exact]
        bending = [rng.uniform(-3, 3) for _ in angles]
        least = min(min(a, pi - a) for a in angles)
        loop = _loop(angles, bending, 1.4 * sin(least / 2), swapped=swapped)
        turn = np.angle(np.roll(loop @ (1, 1j), -1) / (loop @ (1, 1j)))
        winding = float(np.sum(turn)) / (2 * pi)
        gap = max(gap, abs(winding - round(winding)))
        expected = printed.index(len(angles) // 2, offset=offset, slope=slope)
        if round(winding) != expected or float(np.max(np.abs(turn))) > _LARGEST_TURN:
            wrong.append(f"{name}: {winding:.6f} turns, printed {expected}")
    return Evidence(
        outcome="fail" if wrong else "pass",
        grade="numeric",
        residual=f"{gap:.0e}",
        digits=13,
        shown=f"the normal of {len(STARS)} stars of curvature -1, of orders 2 to 6, their rays "
        "bent at random, turns 1 - m_p times along u + v = 7/5 s",
        tried=len(STARS),
        met=len(STARS),
        witness="; ".join(wrong[:3]),
    )
