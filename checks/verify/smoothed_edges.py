"""Smoothing the jumps of phi across the edges of a periodic Amsler surface, off its branch point.

Sector j has coordinates x along its first and y along its second edge, phi = A(x y). About an edge,
s = x in one sector and s = -y' in the next, t is the length along the edge; phi = A for s > 0 and
pi - A for s < 0. Keep t >= rho, blend the two on the line t = rho for |s| < w, keep A on s = rho:
the strip |s| <= rho follows, and with A on x = rho the quadrant x, y >= rho of the next sector. All
data are exact near the corners, so that the pieces fit smoothly; every sector looks the same.
"""

from functools import cache

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from checks.evidence import Evidence, Setting
from checks.exact import combined
from checks.verify.convergence import order as observed_order
from theory import goursat_float, painleve_float

Array = NDArray[np.float64]

#: Opening of the sectors, diameter of the disk of radius R/2.
OPENING, REACH = np.pi / 3, 1.6
#: Largest angle of the surface on the disk of radius REACH.
LARGEST = np.pi - OPENING
#: The edge s = 0 lies between two nodes, rho is half a cell less than so many cells.
CELLS, STEP = 256, 1 / 1280
RHO = (CELLS - 0.5) * STEP
WIDTHS = (64, 32, 16, 8)


@cache
def _amsler() -> tuple[Array, Array]:
    """Table of phi against the product of the coordinates."""
    products = np.linspace(0, REACH**2, 2001)
    return products, np.array([painleve_float.angle(OPENING, 2 * z**0.5) for z in products])


def amsler(product: Array) -> Array:
    """Angle phi of an Amsler sector at this product of the coordinates."""
    return np.asarray(np.interp(product, *_amsler()))


def blend(s: Array, width: float) -> Array:
    """Smooth step from 0 at s <= -width to 1 at s >= width; a jump for width 0."""
    if width == 0:
        return np.where(s > 0, 1.0, np.where(s < 0, 0.0, 0.5))
    x = np.clip((s / width + 1) / 2, 0, 1)
    return np.asarray(x**3 * (10 - 15 * x + 6 * x**2))


def pieces(width: int) -> tuple[Array, Array, Array, Array]:
    """Strip and quadrant with the jump spread over so many cells, and those of the surface."""
    s: Array = RHO - STEP * np.arange(2 * CELLS, dtype=np.float64)
    t: Array = np.arange(RHO, REACH, STEP, dtype=np.float64)
    along = amsler(np.abs(s) * RHO)
    share = blend(s, width * STEP)
    start = share * along + (1 - share) * (np.pi - along)
    side = amsler(RHO * t)
    strip = goursat_float.sine_gordon(start, side, step_u=STEP, step_v=STEP, rate=-1.0)
    quadrant = goursat_float.sine_gordon(np.pi - strip[-1], side, step_u=STEP, step_v=STEP)
    inner = amsler(np.abs(s)[:, None] * t)
    exact = np.where(s[:, None] > 0, inner, np.pi - inner)
    return strip, quadrant, exact, amsler(t[:, None] * t)


@cache
def _measured(width: int) -> tuple[float, float, float]:
    """Squared L^2 error of phi, its largest error off the strip, and E_inf, on the disk."""
    strip, quadrant, exact_strip, exact_quadrant = pieces(width)
    within = exact_quadrant <= LARGEST
    gap = np.abs(quadrant - exact_quadrant)[within]
    squared = (np.sum((strip - exact_strip) ** 2) + np.sum(gap**2)) * STEP**2
    angles = np.concatenate([strip.ravel(), quadrant[within]])
    energy = np.maximum(np.tan(angles / 2), 1 / np.tan(angles / 2)).max()
    return float(squared), float(gap.max()), float(energy)


def smoothing(setting: Setting, *, power: int = 1, order: int = 1, percent: int = 100) -> Evidence:
    """Orders in w of the squared L^2 error (power) and of the error off the edges (order).

    percent: what E_inf tends to with order 1, in percent of that of the surface, cot(pi/6).
    """
    del setting
    measured = [_measured(width) for width in WIDTHS]
    levels = [mp.mpf(width * STEP) for width in WIDTHS]
    limit = percent / 100 / np.tan(OPENING / 2)
    largest = max(row[2] for row in measured)
    return combined(
        {
            "squared L^2 error of phi": observed_order(
                levels, [mp.mpf(row[0]) for row in measured], power, digits=6, shown="phi in L^2"
            ),
            "error off the edges": observed_order(
                levels, [mp.mpf(row[1]) for row in measured], order, digits=6, shown="phi beyond"
            ),
            "curvatures": observed_order(
                levels, [mp.mpf(row[2] - limit) for row in measured], 1, digits=6, shown="E_inf"
            ),
        },
        shown="sectors of pi/3 off their branch point, the jumps spread over w: phi converges in "
        f"L^2 with order 1/2, beyond the edges with order {order}, and E_inf, "
        f"{largest:.4f} at most, tends to {limit:.4f} with order 1",
    )
