r"""Search for a smooth pseudospherical disk whose curvatures are smaller than the best bobbin's.

The angle on the two asymptotic lines through the centre is a polynomial, phi_0 + a_1 x + ... +
a_4 x^4, any sine-Gordon solution near it being determined by such data. The surface enters by its
Chebyshev net in H^2 only: quads are closed by half-turns of the hyperboloid, and phi at a quad
follows from its diagonals. The search minimises the largest |phi - pi/2| on the disk of radius 1,
that is E_inf, from the faces of a box of data; the net has cells of size H, so its value is good to
about a percent, and the check computes that of the best datum anew.
"""

from collections.abc import Callable
from math import cosh, pi, tan
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray

from checks.searches.maximise import from_the_faces

SOURCES = ("checks/searches/smooth_disks.py", "checks/searches/maximise.py")
RADIUS = 1.0
CELLS = 48
H = 1.9 * RADIUS / CELLS
DEGREE = 4
#: Ranges of a_1 to a_4; the disk meets an edge for most data on the faces.
BOX = ((-0.3, 0.3), (-0.7, 0.7), (-0.3, 0.3), (-0.2, 0.2))
#: Data of nets that meet a singular edge or leave the grid.
WORST = 10.0

Array = NDArray[np.float64]


def _compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    return numba.njit(cache=False)(function)


@_compiled
def _dot(a: Array, b: Array) -> float:
    return float(-a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


@_compiled
def _rise(c: Array, x: float) -> float:
    """Value of the polynomial with these coefficients of x, x^2, ..."""
    total, power = 0.0, 1.0
    for k in range(len(c)):
        power *= x
        total += c[k] * power
    return total


@_compiled
def _axis(start: float, turns: Array, h: float) -> Array:
    """Polygon of edges h from the centre of H^2 at the polar angle start, turning at its nodes."""
    points = np.zeros((len(turns) + 1, 3))
    p = np.array([1.0, 0.0, 0.0])
    t = np.array([0.0, np.cos(start), np.sin(start)])
    points[0] = p
    for i in range(len(turns)):
        q = np.cosh(h) * p + np.sinh(h) * t
        t = np.sinh(h) * p + np.cosh(h) * t
        left = np.array(
            [
                q[2] * t[1] - q[1] * t[2],
                q[2] * t[0] - q[0] * t[2],
                q[0] * t[1] - q[1] * t[0],
            ]
        )
        t = np.cos(turns[i]) * t + np.sin(turns[i]) * left
        p = q
        points[i + 1] = p
    return points


@_compiled
def _quadrant(corner: float, on_u: Array, on_v: Array, su: int, sv: int, n: int, h: float) -> Any:
    """Angles phi of the quads of one quadrant and their distances from the centre.

    su, sv: signs of u and v. The u-line turns by -phi_u, the v-line by phi_v per length.
    """
    turn_u, turn_v = np.zeros(n), np.zeros(n)
    for i in range(n):
        near, far = (i + 0.5) * h, (i + 1.5) * h
        turn_u[i] = _rise(on_u, su * near) - _rise(on_u, su * far)
        turn_v[i] = _rise(on_v, sv * far) - _rise(on_v, sv * near)
    net = np.zeros((n + 1, n + 1, 3))
    along_u = (0.0 if su == 1 else np.pi) - _rise(on_u, su * h / 2)
    along_v = corner + (0.0 if sv == 1 else np.pi) + _rise(on_v, sv * h / 2)
    net[:, 0] = _axis(along_u, turn_u, h)
    net[0, :] = _axis(along_v, turn_v, h)
    angles, away = np.zeros((n, n)), np.zeros((n, n))
    for i in range(n):
        for j in range(n):
            s = net[i + 1, j] + net[i, j + 1]
            square = _dot(s, s)
            net[i + 1, j + 1] = 2 * _dot(net[i, j], s) / square * s - net[i, j]
            across = -_dot(net[i + 1, j], net[i, j + 1]) - 1
            onward = -_dot(net[i, j], net[i + 1, j + 1]) - 1
            phi = 2 * np.arctan(np.sqrt(max(across, 0.0) / max(onward, 1e-300)))
            angles[i, j] = phi if su * sv > 0 else np.pi - phi
            away[i, j] = np.arccosh(max(1.0, s[0] / np.sqrt(-square)))
    return angles, away


@_compiled
def _largest_offset(corner: float, on_u: Array, on_v: Array, n: int, h: float) -> float:
    """Largest |phi - pi/2| on the disk, interpolated at its rim; 10 where the grid is too small."""
    worst = 0.0
    for su in (1, -1):
        for sv in (1, -1):
            angles, away = _quadrant(corner, on_u, on_v, su, sv, n, h)
            inside = np.zeros((n, n), dtype=np.bool_)
            for i in range(n):
                for j in range(n):
                    # Beyond a singular edge the net folds back: only what is reached from within.
                    joined = (i + j == 0) or (i > 0 and inside[i - 1, j])
                    joined = joined or (j > 0 and inside[i, j - 1])
                    inside[i, j] = joined and away[i, j] <= RADIUS
            for i in range(n):
                for j in range(n):
                    if not inside[i, j]:
                        continue
                    if i == n - 1 or j == n - 1:
                        return WORST
                    worst = max(worst, abs(angles[i, j] - np.pi / 2))
                    for a, b in ((1, 0), (0, 1), (1, 1)):
                        d = away[i + a, j + b]
                        if d > RADIUS:
                            w = (RADIUS - away[i, j]) / (d - away[i, j])
                            rim = angles[i, j] + w * (angles[i + a, j + b] - angles[i, j])
                            worst = max(worst, abs(rim - np.pi / 2))
    return worst


def max_curvature(point: Array) -> float:
    """E_inf = cot(delta/2), delta = pi/2 - largest |phi - pi/2|, on the net of the data."""
    on_u, on_v = point[1 : 1 + DEGREE], point[1 + DEGREE :]
    offset = float(_largest_offset(float(point[0]), on_u, on_v, CELLS, H))
    return 1 / tan((pi / 2 - offset) / 2) if offset < pi / 2 else WORST


def search(*, seed: int, progress: Callable[[str], None]) -> dict[str, Any]:
    """Least E_inf found; margin is what it exceeds cosh 1 by."""
    bounds = ((0.9, 2.2), *(BOX * 2))
    best = from_the_faces(
        lambda point: -max_curvature(point),
        bounds,
        seed=seed,
        population=60,
        generations=400,
        polish=6000,
        progress=progress,
    )
    return {
        "evaluations": best.evaluations,
        "margin": -best.value - cosh(RADIUS),
        "point": list(best.point),
        "curvature": -best.value,
    }
