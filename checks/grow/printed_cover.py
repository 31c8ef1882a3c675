"""Area, energy and cover of the disk by the quads that a run of the printed algorithm keeps."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from checks.printed.greedy_algorithm import PrintedRun
from discrete.clipped_quads import clipped_area
from discrete.point_cover import contained

#: Random points of the disk that are looked for in the quads, and the seed that they come from.
POINTS, SEED = 10**5, 1


@dataclass(frozen=True, kw_only=True)
class PrintedCover:
    """Area of the kept quads, clipped to the disk, integral of kappa1^2 + kappa2^2 over it.

    uncovered, twice: shares of random points, uniform by area, in no quad and in more than one.
    """

    area: float
    willmore: float
    uncovered: float
    twice: float


def cover(run: PrintedRun) -> PrintedCover:
    """Cover of the disk by the sectors of a run, sector by sector."""
    radius = run.parameters.radius
    random = np.random.default_rng(SEED)
    half = math.sinh(radius / 2) * np.sqrt(random.random(POINTS))
    places = half / np.sqrt(1 + half * half) * np.exp(2j * math.pi * random.random(POINTS))
    held, area, willmore = np.zeros(POINTS, dtype=np.int64), 0.0, 0.0
    for sector in run.sectors:
        corners = sector.corners()
        if len(corners):
            held += contained(places, corners)
            areas, densities = areas_and_densities(corners, radius, run.parameters.step)
            area += float(areas.sum())
            willmore += float((areas * densities).sum())
    return PrintedCover(
        area=area,
        willmore=willmore,
        uncovered=float((held == 0).mean()),
        twice=float((held > 1).mean()),
    )


def areas_and_densities(corners: Any, radius: float, step: float) -> tuple[Any, Any]:
    """Areas in the disk of rhombi with corners (quads, 4), and kappa1^2 + kappa2^2 in each.

    A rhombus that is flipped counts like another. The angle in the middle is that at the first
    corner and a quarter of the whole area.
    """
    square = np.abs(corners) ** 2
    heights = (1 + square) / (1 - square)
    cosh_r = math.cosh(radius)
    w1, w2 = (
        (corners[:, k] - corners[:, 0]) / (1 - corners[:, k] * corners[:, 0].conj()) for k in (1, 3)
    )
    product = w2 * w1.conj()
    product = product / np.abs(product)
    sine, cosine = np.abs(product.imag), product.real
    within = (heights <= cosh_r).all(axis=1)
    q = math.tanh(step / 2) ** 2
    whole = 4 * np.arctan(q * sine / (1 - q * cosine))
    half = (np.arctan2(sine, cosine) + whole / 4) / 2
    areas = np.where(within, whole, 0.0)
    crossing = ~within & (heights.min(axis=1) < cosh_r * math.cosh(step / 2)) & (sine > 0)
    rows = np.column_stack([sine, cosine, heights])[crossing].tolist()
    areas[crossing] = [
        clipped_area(math.cosh(step), math.sinh(step), cosh_r, s, c, (h, h1, h12, h2))
        for s, c, h, h1, h12, h2 in rows
    ]
    return areas, np.tan(half) ** 2 + np.tan(half) ** -2
