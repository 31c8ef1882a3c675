"""Geodesic disks about points of an Amsler surface: how far they are from the singular edge.

ds^2 = du^2 + 2 cos phi du dv + dv^2 with phi = F(2 sqrt(|u v|)) in each of the sectors about the
crossing, F rising from phi0 to pi at z*. Below, with w = |u| + |v| >= 2 sqrt(|u v|),

    ds^2 - cos^2(phi/2) (du + dv)^2 = sin^2(phi/2) (du - dv)^2 >= 0,

so that a curve from the crossing to the edge, where w >= z*, is at least as long as the integral of
cos(F/2) from 0 to z*. Above, along (u + t, v + t) the length is 2 cos(phi/2) dt and z grows at
least at the rate 2, so the edge is within that same integral of every point of the sector.
"""

from typing import Any

import sympy as sp

PHI = sp.Symbol("phi", real=True)
DU, DV = sp.symbols("du dv", real=True)
ROOT_U, ROOT_V, T = sp.symbols("a b t", nonnegative=True)


def length_excess() -> Any:
    """Square of ds minus that of cos(phi/2) dw, w = u + v."""
    squared = DU**2 + 2 * sp.cos(PHI) * DU * DV + DV**2
    return squared - sp.cos(PHI / 2) ** 2 * (DU + DV) ** 2


def sum_excess() -> Any:
    """Excess of u + v over 2 sqrt(u v), the coordinates being squares of ROOT_U, ROOT_V."""
    return ROOT_U**2 + ROOT_V**2 - 2 * ROOT_U * ROOT_V


def diagonal_excess() -> Any:
    """Excess of (u + t)(v + t) over (sqrt(u v) + t)^2."""
    moved = (ROOT_U**2 + T) * (ROOT_V**2 + T)
    return sp.expand(moved - (ROOT_U * ROOT_V + T) ** 2)


def diagonal_speed_squared() -> Any:
    """Square of ds/dt along (u + t, v + t)."""
    return sp.expand(1 + 2 * sp.cos(PHI) + 1)
