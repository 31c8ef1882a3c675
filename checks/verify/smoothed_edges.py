"""Smoothing the jumps of phi across the edges of a periodic Amsler surface, off its branch point.

Sector j has coordinates x along its first and y along its second edge, phi = A(x y). About an edge,
s = x in one sector and s = -y' in the next, t is the length along the edge; phi = A for s > 0 and
pi - A for s < 0. Keep t >= rho, blend the two on the line t = rho for |s| < w, keep A on s = rho:
the strip |s| <= rho follows, and with A on x = rho the quadrant x, y >= rho of the next sector. All
data are exact near the corners, so that the pieces fit smoothly; every sector looks the same.
"""

from fractions import Fraction
from functools import cache

import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from checks.evidence import Evidence, Setting
from checks.exact import combined
from checks.verify.convergence import order as observed_order
from theory import goursat_float, painleve_float

Array = NDArray[np.float64]

#: Opening of the sectors, distance kept from the branch point, diameter of the disk of radius R/2.
OPENING, RHO, REACH = np.pi / 3, 0.2, 1.6
#: Largest angle of the surface on the disk of radius REACH.
LARGEST = np.pi - OPENING
CELLS = 256
WIDTHS = (64, 32, 16, 8)


@cache
def _amsler() -> tuple[Array, Array]:
    """Table of phi against the product of the coordinates."""
    products = np.linspace(0, REACH**2, 4001)
    return products, np.array([painleve_float.angle(OPENING, 2 * z**0.5) for z in products])


def amsler(product: Array) -> Array:
    """phi of an Amsler sector at this product of the coordinates."""
    return np.asarray(np.interp(product, *_amsler()))


def blend(s: Array, width: float) -> Array:
    """Smooth step from 0 at s <= -width to 1 at s >= width; a jump for width 0."""
    if width == 0:
        return np.where(s > 0, 1.0, np.where(s < 0, 0.0, 0.5))
    x = np.clip((s / width + 1) / 2, 0, 1)
    return np.asarray(x**3 * (10 - 15 * x + 6 * x**2))


def pieces(width: int) -> tuple[Array, Array, Array, Array]:
    """Strip and quadrant with the jump spread over so many cells, and those of the surface."""
    step = RHO / CELLS
    s = step * np.arange(CELLS, -CELLS - 1, -1)
    t = np.arange(RHO, REACH + step / 2, step)
    along = amsler(np.abs(s) * RHO)
    share = blend(s, width * step)
    start = share * along + (1 - share) * (np.pi - along)
    strip = goursat_float.sine_gordon(start, amsler(RHO * t), step_u=step, step_v=step, rate=-1.0)
    quadrant = goursat_float.sine_gordon(
        np.pi - strip[-1], amsler(RHO * t), step_u=step, step_v=step
    )
    inner = amsler(np.abs(s)[:, None] * t)
    half = blend(s, 0)[:, None]
    exact = half * inner + (1 - half) * (np.pi - inner)
    return strip, quadrant, exact, amsler(t[:, None] * t)


@cache
def _measured(width: int) -> tuple[float, float, float]:
    """Squared L^2 error of phi, its largest error off the strip, and E_inf, on the disk."""
    strip, quadrant, exact_strip, exact_quadrant = pieces(width)
    step = RHO / CELLS
    t = np.arange(RHO, REACH + step / 2, step)
    within = exact_quadrant <= LARGEST
    gap = np.abs(quadrant - exact_quadrant)[within]
    squared = (np.sum((strip - exact_strip) ** 2) + np.sum(gap**2)) * step**2
    angles = np.concatenate([strip.ravel(), quadrant[within]])
    energy = np.maximum(np.tan(angles / 2), 1 / np.tan(angles / 2)).max()
    return float(squared), float(gap.max()), float(energy)


def smoothing(setting: Setting, *, power: int = 1, order: int = 1, percent: int = 105) -> Evidence:
    """Orders in w of the squared L^2 error (power) and of the error off the edges (order).

    percent: what E_inf may not exceed, in percent of that of the surface, cot(pi/6).
    """
    del setting
    measured = [_measured(width) for width in WIDTHS]
    levels = [mp.mpf(width) * mp.mpf(RHO) / CELLS for width in WIDTHS]
    most = float(Fraction(percent, 100)) / np.tan(OPENING / 2)
    largest = max(row[2] for row in measured)
    return combined(
        {
            "squared L^2 error of phi": observed_order(
                levels, [mp.mpf(row[0]) for row in measured], power, digits=6, shown="phi in L^2"
            ),
            "error off the edges": observed_order(
                levels, [mp.mpf(row[1]) for row in measured], order, digits=6, shown="phi beyond"
            ),
            "curvatures": Evidence(
                outcome="pass" if largest <= most else "fail",
                grade="experiment",
                shown=f"E_inf at most {largest:.4f}",
                tried=len(WIDTHS),
                met=len(WIDTHS),
                witness=f"E_inf {largest:.4f} above {most:.4f}",
            ),
        },
        shown=f"sectors of pi/3 off their branch point: with the jumps spread over w, phi converges "
        f"in L^2 with order 1/2 and beyond the edges with order {order}, and E_inf stays below "
        f"{largest:.4f}, against {1 / np.tan(OPENING / 2):.4f}",
    )
