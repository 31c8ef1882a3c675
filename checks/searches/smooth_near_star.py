"""Search for a smooth saddle near the monkey saddle, among saddles of bounded curvature.

Small disks about p, magnified, in the limit: det D^2 w = -1 in the unit disk, and the normal is
-grad w to first order. Smooth solutions are x = f(u) + g(v), -grad w = J f(u) - J g(v), J the
quarter-turn, where f' and g' are unit vectors at angles theta(u), psi(v) that enclose between
phi_0 and pi - phi_0 (the bound k = cot(phi_0/2) on the curvature). The target is the quadratic
saddle over a star. The search minimises the mean over the disk of |D^2 w - D^2 w_star|^2, the
squared distance in W^{2,2}, with theta and psi constant on panels. For comparison the same is done
for a kinked star of order 2, which smooth saddles do approach.
"""

from collections.abc import Callable
from math import atan, pi, sin
from typing import Any

import numba
import numpy as np

from checks.searches.maximise import from_the_faces

SOURCES = ("checks/searches/maximise.py", "checks/searches/smooth_near_star.py")
PANELS = 6
CELLS = 156
LARGEST_CURVATURE = 4.0
MONKEY = (pi / 3,) * 6
KINKED = (pi / 3, pi / 2, 3 * pi / 4, 5 * pi / 12)
#: Length of the u- and v-lines to either side of p: a net of angles above phi_0 covers the disk.
REACH = 1 / sin(atan(1 / LARGEST_CURVATURE))


def star_hessians(angles: tuple[float, ...]) -> np.ndarray:
    """Rows (end angle, h11, h12, h22): -D^2 w on each sector, from the images of its rays."""
    rows, beta = [], 0.0
    for i, angle in enumerate(angles):
        first, last = (beta, beta + angle) if i % 2 == 0 else (beta + angle, beta)
        rays = np.array([[np.cos(b), np.sin(b)] for b in (first, last)]).T
        images = np.array([[-rays[1, 0], rays[0, 0]], [rays[1, 1], -rays[0, 1]]]).T
        h = images @ np.linalg.inv(rays)
        beta += angle
        rows.append((beta, h[0, 0], (h[0, 1] + h[1, 0]) / 2, h[1, 1]))
    return np.array(rows)


@numba.njit(cache=False)
def _curve(turn: np.ndarray, step: float) -> np.ndarray:
    """Points f at cell centres, with f(0) = 0 in the middle; turn: angle of f' on each cell."""
    n = len(turn)
    points = np.zeros((n, 2))
    for sense in (1, -1):
        x = y = 0.0
        for k in range(n // 2):
            i = n // 2 + k if sense == 1 else n // 2 - 1 - k
            c, s = np.cos(turn[i]) * step * sense, np.sin(turn[i]) * step * sense
            points[i, 0], points[i, 1] = x + c / 2, y + s / 2
            x, y = x + c, y + s
    return points


@numba.njit(cache=False)
def mean_square(theta: np.ndarray, psi: np.ndarray, step: float, star: np.ndarray) -> float:
    """Mean over the unit disk of |D^2 w - D^2 w_star|^2; what the net leaves out counts 16."""
    f, g = _curve(theta, step), _curve(psi, step)
    total = area = 0.0
    for i in range(len(theta)):
        for j in range(len(psi)):
            x, y = f[i, 0] + g[j, 0], f[i, 1] + g[j, 1]
            if x * x + y * y >= 1:
                continue
            c, s, p, q = np.cos(theta[i]), np.sin(theta[i]), np.cos(psi[j]), np.sin(psi[j])
            det = c * q - s * p
            # [J f', -J g'] [f', g']^{-1}, symmetric and of determinant -1.
            h11, h22 = (-s * q - q * s) / det, (-c * p - p * c) / det
            h12 = (s * p + q * c) / det
            polar = np.arctan2(y, x) % (2 * np.pi)
            row = 0
            while row < len(star) - 1 and polar > star[row, 0]:
                row += 1
            cell = det * step * step
            d11, d12, d22 = h11 - star[row, 1], h12 - star[row, 2], h22 - star[row, 3]
            total += cell * (d11**2 + 2 * d12**2 + d22**2)
            area += cell
    return (total + 16 * max(0.0, np.pi - area)) / max(area, np.pi)


def saddle(point: np.ndarray, cells: int) -> tuple[np.ndarray, np.ndarray, float]:
    """Angles theta and psi on cells, and the step; any point of the box gives admissible data.

    point: direction of the bisector, share of the room that theta takes, where phi is in its range,
    then the positions of theta and psi in their ranges on panels, all but the first in [0, 1].
    """
    least = 2 * atan(1 / LARGEST_CURVATURE)
    room = pi - 2 * least
    width_u, width_v = room * point[1] * point[2], room * (1 - point[1]) * point[2]
    between = least + (room - width_u - width_v) * point[3]
    start = point[0]
    panel = np.arange(cells) * PANELS // cells
    theta = start + width_u * point[4 : 4 + PANELS][panel]
    psi = start + width_u + between + width_v * point[4 + PANELS :][panel]
    return theta, psi, 2 * REACH / cells


def closest(
    angles: tuple[float, ...], *, seed: int, progress: Callable[[str], None]
) -> dict[str, Any]:
    """Least root mean square of the difference of Hessians found, relative to that of the star."""
    star = star_hessians(angles)

    def objective(point: np.ndarray) -> float:
        return -float(mean_square(*saddle(point, CELLS), star))

    bounds = ((-pi, pi), *(((0.0, 1.0),) * (3 + 2 * PANELS)))
    best = from_the_faces(
        objective, bounds, seed=seed, population=60, generations=300, progress=progress
    )
    widths = np.diff(np.concatenate(([0.0], star[:, 0])))
    size = float(np.sum(widths * (star[:, 1] ** 2 + 2 * star[:, 2] ** 2 + star[:, 3] ** 2)))
    return {
        "evaluations": best.evaluations,
        "point": list(best.point),
        "distance": float(np.sqrt(-best.value / (size / (2 * pi)))),
    }


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Distances to the monkey saddle and to the kinked star; margin is the excess over twice."""
    monkey = closest(MONKEY, seed=seed, progress=progress)
    kinked = closest(KINKED, seed=seed, progress=progress)
    return {
        "evaluations": monkey["evaluations"] + kinked["evaluations"],
        "margin": monkey["distance"] - 2 * kinked["distance"],
        "monkey": monkey,
        "kinked": kinked,
    }
