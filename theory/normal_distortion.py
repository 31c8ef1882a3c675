r"""Distortion of the normal map of a small disk, read in the plane: bounds in balls for every k.

On a disk of hyperbolic radius R with curvatures at most k >= 1 let x be twice the coordinate of the
Poincare disk, |dx| <= ds <= cosh(R/2)^2 |dx|, and f(x) the conjugate of the part of N normal to
N_0. Lengths on the sphere are between 1/k and k times those on the surface, and the projection
multiplies them by at least cos(k R). So f is an L-BLD immersion with L = k D,
    D = max(cosh(R/2)^2, 1/cos(k R)),
a function of rho = k R and s = 1/k in (0, 1].
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from flint import arb

CELLS = 32


@dataclass(frozen=True, kw_only=True)
class Cell:
    """Ranges of rho = k R and of s = 1/k, as balls."""

    rho: Any
    s: Any


def cells(largest: Any) -> Iterator[Cell]:
    """Tiling of 0 <= rho <= largest, 0 <= s <= 1 (largest a ball)."""
    for i in range(CELLS):
        rho = largest * arb(i).union(arb(i + 1)) / CELLS
        for j in range(CELLS):
            yield Cell(rho=rho, s=arb(j).union(arb(j + 1)) / CELLS)


def relative_distortion(cell: Cell) -> Any:
    """Upper end of D = L/k on a cell; needs rho < pi/2."""
    metric = (cell.rho * cell.s / 2).cosh() ** 2
    projection = 1 / cell.rho.cos()
    return metric.max(projection)


def radius_needed(cell: Cell) -> Any:
    """Bound on L^2 (2 delta) / k^2 over R/2, times R/delta: what R/(k^2 delta) must exceed.

    In the coordinate x the radii are 2 tanh(delta) <= 2 delta, 2 tanh(R/2) >= R (1 - R^2/12).
    """
    radius = cell.rho * cell.s
    return 2 * relative_distortion(cell) ** 2 / (1 - radius**2 / 12)


def collar_constant(cell: Cell, delta: Any) -> Any:
    """Lower bound on k |N(x) - N_0| / delta for delta <= d(x) < 2 delta where John's bound holds.

    |f(x)| >= |x|/L with |x| = 2 tanh(d/2) >= d (1 - d^2/12).
    """
    return (1 - delta**2 / 12) / relative_distortion(cell)
