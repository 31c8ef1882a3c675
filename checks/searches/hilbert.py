"""Search for an asymptotic quadrilateral of area 2 pi among immersions of curvature -1.

A complete surface of curvature -1 in R^3 would be covered by asymptotic quadrilaterals of any
area, and one of area 2 pi would refute the step on which Hilbert's theorem rests. The data are
those of Goursat: the angle phi along two sides that meet. phi_uv = sin phi is solved on a square
grid, and the largest corner rectangle with 0 < phi < pi at all of its nodes is kept.
"""

from collections.abc import Callable
from typing import Any

import numba
import numpy as np

from checks.searches.maximise import from_the_faces

SOURCES = ("checks/searches/hilbert.py", "checks/searches/maximise.py")
KNOTS = 5
CELLS = 80
LONGEST = 20.0


@numba.njit(cache=False)
def march(along_u: np.ndarray, along_v: np.ndarray, cell: float) -> np.ndarray:
    """Solution of phi_uv = sin phi with the values given on two sides, by the midpoint rule.

    cell: area of a cell in u, v; two corrections of each corner make the rule of second order.
    """
    n, m = len(along_u), len(along_v)
    phi = np.zeros((n, m))
    phi[:, 0] = along_u
    phi[0, :] = along_v
    for i in range(1, n):
        for j in range(1, m):
            known = phi[i, j - 1] + phi[i - 1, j]
            free = known - phi[i - 1, j - 1]
            corner = free + cell * np.sin(known / 2)
            for _ in range(2):
                corner = free + cell * np.sin((known + phi[i - 1, j - 1] + corner) / 4)
            phi[i, j] = corner
    return phi


@numba.njit(cache=False)
def largest_immersed(phi: np.ndarray, cell: float) -> tuple[float, int, int]:
    """Area and far corner of the largest rectangle from node (0, 0) where 0 < phi < pi."""
    n, m = phi.shape
    best, far_i, far_j = 0.0, 0, 0
    columns = np.zeros(m)
    width = m
    for i in range(n):
        for j in range(width):
            if not 0.0 < phi[i, j] < np.pi:
                width = j
                break
        area = 0.0
        for j in range(1, width):
            if i > 0:
                total = phi[i, j] + phi[i - 1, j] + phi[i, j - 1] + phi[i - 1, j - 1]
                columns[j] += cell * np.sin(total / 4)
            area += columns[j]
            if area > best:
                best, far_i, far_j = area, i, j
    return best, far_i, far_j


def sides(point: np.ndarray, cells: int) -> tuple[np.ndarray, np.ndarray, float]:
    """Angles along both sides, piecewise linear between knots, and the area of a cell.

    point: logarithms of the two lengths, the angle at the common corner, then the angles at the
    knots of the u-side and of the v-side, all in (0, pi).
    """
    length_u, length_v = np.exp(point[0]), np.exp(point[1])
    nodes = np.linspace(0.0, 1.0, cells + 1)
    knots = np.linspace(0.0, 1.0, KNOTS + 1)
    along_u = np.interp(nodes, knots, np.concatenate((point[2:3], point[3 : 3 + KNOTS])))
    along_v = np.interp(nodes, knots, np.concatenate((point[2:3], point[3 + KNOTS :])))
    return along_u, along_v, float(length_u * length_v) / cells**2


def area(point: np.ndarray) -> float:
    """Area of the largest immersed quadrilateral of these data."""
    along_u, along_v, cell = sides(point, CELLS)
    return float(largest_immersed(march(along_u, along_v, cell), cell)[0])


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Largest area found; margin is what it falls short of 2 pi."""
    angle = (1e-4, float(np.pi) - 1e-4)
    length = (float(np.log(0.05)), float(np.log(LONGEST)))
    bounds = (length, length, *((angle,) * (1 + 2 * KNOTS)))
    best = from_the_faces(
        area, bounds, seed=seed, population=80, generations=300, polish=4000, progress=progress
    )
    along_u, along_v, cell = sides(np.array(best.point), CELLS)
    found, far_i, far_j = largest_immersed(march(along_u, along_v, cell), cell)
    return {
        "evaluations": best.evaluations,
        "margin": 2 * float(np.pi) - found,
        "point": list(best.point),
        "far_corner": [far_i, far_j],
        "cells": CELLS,
    }
