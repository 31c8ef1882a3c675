"""Search for a pseudospherical sector whose normal returns towards its value at the apex.

In asymptotic coordinates u, v of unit speed, where the angle keeps between phi_0 and pi - phi_0 on
[0, u] x [0, v], |N - N(p)| >= t sin(phi_0/2) - t^2/2 - t^3/8, t = u + v. Data: the angle at the
apex and the geodesic curvatures of the two bounding curves, constant on panels. The search
maximises (t sin(phi_0/2) - |N - N(p)|)/t^2 - t/8, which must stay below 1/2.
"""

from collections.abc import Callable
from typing import Any

import numba
import numpy as np

from checks.searches.maximise import from_the_faces

SOURCES = ("checks/searches/maximise.py", "checks/searches/star_normals.py")
PANELS = 4
CELLS = 48
BENDING = 12.0
LONGEST = 2.0


@numba.njit(cache=False)
def boundary(tangent: np.ndarray, torsion: float, bending: np.ndarray, step: float) -> np.ndarray:
    """Normals at equal steps of a curve from N = e_3, turned about its Darboux vector."""
    cells = CELLS
    t, n = tangent.copy(), np.array([0.0, 0.0, 1.0])
    normals = np.zeros((cells + 1, 3))
    normals[0] = n
    for i in range(cells):
        k = bending[i * len(bending) // cells]
        rate = np.sqrt(1 + k * k)
        axis = (torsion * t + k * n) / rate
        c, s = np.cos(rate * step), np.sin(rate * step)
        t_new = t * c + np.cross(axis, t) * s + axis * np.dot(axis, t) * (1 - c)
        n = n * c + np.cross(axis, n) * s + axis * np.dot(axis, n) * (1 - c)
        t = t_new
        normals[i + 1] = n
    return normals


@numba.njit(cache=False)
def fill(along_u: np.ndarray, along_v: np.ndarray) -> np.ndarray:
    """Normals on the whole grid: opposite edges of each cell are equal (half-turn rule)."""
    n, m = len(along_u), len(along_v)
    normals = np.zeros((n, m, 3))
    normals[:, 0] = along_u
    normals[0, :] = along_v
    for i in range(1, n):
        for j in range(1, m):
            total = normals[i - 1, j] + normals[i, j - 1]
            p = normals[i - 1, j - 1]
            normals[i, j] = 2 * np.dot(p, total) / np.dot(total, total) * total - p
    return normals


@numba.njit(cache=False)
def worst_excess(normals: np.ndarray, step: float) -> tuple[float, int, int]:
    """Largest excess over the nodes of immersed rectangles, and the node."""
    n, m, _ = normals.shape
    least = np.full((n, m), np.pi / 2)
    best, far_i, far_j = -np.inf, 0, 0
    for i in range(n - 1):
        for j in range(m - 1):
            a = normals[i + 1, j] - normals[i, j]
            b = normals[i, j + 1] - normals[i, j]
            cosine = -np.dot(a, b) / np.sqrt(np.dot(a, a) * np.dot(b, b))
            turned = np.dot(normals[i, j], np.cross(a, b))
            angle = np.arccos(min(1.0, max(-1.0, cosine)))
            local = min(angle, np.pi - angle) if turned < 0 else 0.0
            if i > 0:
                local = min(local, least[i - 1, j])
            if j > 0:
                local = min(local, least[i, j - 1])
            least[i, j] = local
            if i + j > 0 and local > 0:
                t = (i + j) * step
                d = normals[i, j] - normals[0, 0]
                excess = (t * np.sin(local / 2) - np.sqrt(np.dot(d, d))) / t**2 - t / 8
                if excess > best:
                    best, far_i, far_j = excess, i, j
    return best, far_i, far_j


def data(point: np.ndarray) -> tuple[float, np.ndarray, np.ndarray, float]:
    """Angle at the apex, curvatures of the u-curve and of the v-curve, length of both."""
    return (
        float(point[0]),
        point[2 : 2 + PANELS],
        point[2 + PANELS :],
        float(point[1]),
    )


def excess(point: np.ndarray) -> float:
    """Objective: the worst excess of the sector with these data."""
    angle, bend_u, bend_v, length = data(point)
    step = length / CELLS
    along_u = boundary(np.array([1.0, 0.0, 0.0]), -1.0, bend_u, step)
    along_v = boundary(np.array([np.cos(angle), np.sin(angle), 0.0]), 1.0, bend_v, step)
    return float(worst_excess(fill(along_u, along_v), step)[0])


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Largest excess found; margin is what it falls short of 1/2."""
    curvature = (-BENDING, BENDING)
    bounds = ((0.01, float(np.pi) - 0.01), (0.05, LONGEST), *((curvature,) * (2 * PANELS)))
    best = from_the_faces(
        excess, bounds, seed=seed, population=60, generations=240, progress=progress
    )
    angle, bend_u, bend_v, length = data(np.array(best.point))
    step = length / CELLS
    along_u = boundary(np.array([1.0, 0.0, 0.0]), -1.0, bend_u, step)
    along_v = boundary(np.array([np.cos(angle), np.sin(angle), 0.0]), 1.0, bend_v, step)
    _, far_u, far_v = worst_excess(fill(along_u, along_v), step)
    return {
        "evaluations": best.evaluations,
        "margin": 0.5 - best.value,
        "point": list(best.point),
        "excess": best.value,
        "node": [far_u, far_v],
        "cells": CELLS,
    }
