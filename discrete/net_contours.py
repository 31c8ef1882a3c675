"""Where a contour of the angle meets a circle about the centre, on a sector of a hyperbolic net.

Angles belong to the middles of the quads, distances to vertices; both are smooth functions of
(u, v) up to the square of the edge length, so cubic splines keep that order. Equal edge lengths.
scipy is imported when a function is called.
"""

from typing import Any

import numpy as np
import numpy.typing as npt

from discrete.errors import DiscreteError
from discrete.sector import Sector

FloatArray = npt.NDArray[np.float64]


def middle_angles(sector: Sector) -> FloatArray:
    """Angles at the middles of the quads: the mean of A and of pi - B, an array (n, m)."""
    return np.asarray((sector.angles + np.pi - sector.other_angles) / 2)


def middle_distances(distances: FloatArray) -> FloatArray:
    """Means (n, m) of the distances of the four vertices of each quad."""
    d = distances
    return np.asarray((d[1:, 1:] + d[:-1, 1:] + d[1:, :-1] + d[:-1, :-1]) / 4)


def contour_meets_circle(
    angles: FloatArray, distances: FloatArray, *, step: float, level: float, radius: float
) -> float:
    """Least u at which the contour of the angle at this level is within the circle.

    angles, distances: at the middles of the quads. On each column v is that of the contour; the
    distance there falls from column to column. Raises DiscreteError where they do not meet.
    """
    from scipy.interpolate import CubicSpline

    places, reached = [], []
    middles = (np.arange(angles.shape[1]) + 0.5) * step
    for i, column in enumerate(angles):
        above = np.flatnonzero(column >= level)
        if not len(above) or not above[0] > 3:
            continue
        window = slice(max(above[0] - 4, 0), above[0] + 4)
        v = _root(CubicSpline(middles[window], column[window]), level)
        places.append((i + 0.5) * step)
        reached.append(float(CubicSpline(middles[window], distances[i][window])(v)))
    inside = np.flatnonzero(np.array(reached) <= radius)
    if not len(inside) or inside[0] == 0:
        raise DiscreteError(f"the contour {level} does not cross the circle {radius} in the net")
    window = slice(max(inside[0] - 4, 0), inside[0] + 4)
    return _root(CubicSpline(places[window], reached[window]), radius, falling=True)


def _root(spline: Any, level: float, *, falling: bool = False) -> float:
    """Place at which a monotone spline takes a level."""
    found = spline.solve(level, extrapolate=False)
    slope = spline(found, 1)
    kept = found[slope < 0] if falling else found[slope > 0]
    if not len(kept):
        raise DiscreteError(f"no place with the value {level} in the window")
    return float(kept[0])


def value_at(distances: FloatArray, *, step: float, u: float, v: float) -> float:
    """Value at (u, v) of a function given at the vertices."""
    from scipy.interpolate import RectBivariateSpline

    i, j = int(u / step), int(v / step)
    first = [slice(max(k - 5, 0), max(k - 5, 0) + 11) for k in (i, j)]
    part = distances[first[0], first[1]]
    x, y = (np.arange(f.start, f.start + size) * step
            for f, size in zip(first, part.shape, strict=True))  # fmt: skip
    return float(RectBivariateSpline(x, y, part, s=0)(u, v)[0, 0])
