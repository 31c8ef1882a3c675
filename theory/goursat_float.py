"""Goursat problems in float64, second order: the Moutard equation and omega_uv = sin omega.

A rectangle is a grid of (n + 1, m + 1) nodes filled along anti-diagonals from its two axes.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from theory.errors import DomainError

Floats = NDArray[np.float64]
_CORRECTIONS = 3


def _filled(
    on_u: Floats, on_v: Floats, close: Callable[[Floats, Floats, Floats], Floats]
) -> Floats:
    """Grid from its axes and the rule that gives the far corner of a quad from the other three."""
    if not np.allclose(on_u[0], on_v[0], rtol=0, atol=1e-12):
        raise DomainError("the data on the two axes differ in the corner (0, 0)")
    n, m = len(on_u) - 1, len(on_v) - 1
    grid = np.empty((n + 1, m + 1, *on_u.shape[1:]))
    grid[:, 0], grid[0, :] = on_u, on_v
    for total in range(n + m - 1):
        i = np.arange(max(0, total - m + 1), min(total, n - 1) + 1)
        j = total - i
        grid[i + 1, j + 1] = close(grid[i, j], grid[i + 1, j], grid[i, j + 1])
    return grid


def moutard(on_u: Floats, on_v: Floats, *, step_u: float, step_v: float) -> Floats:
    """Solution of N_uv = -(N_u.N_v) N with these values on the axes, each of shape (k, 3).

    The rule is centred in the quad and implicit; it does not keep |N| = 1 but to second order.
    """
    area = step_u * step_v

    def close(near: Floats, right: Floats, up: Floats) -> Floats:
        far = right + up - near
        for _ in range(_CORRECTIONS):
            n_u, n_v = (right - near + far - up) / 2, (up - near + far - right) / 2
            speed = np.sum(n_u * n_v, axis=-1, keepdims=True) / area
            far = right + up - near - area * speed * (near + right + up + far) / 4
        return far

    return _filled(on_u, on_v, close)


def sine_gordon(
    on_u: Floats, on_v: Floats, *, step_u: float, step_v: float, rate: float = 1.0
) -> Floats:
    """Solution of omega_uv = rate sin omega with these values on the axes."""

    def close(near: Floats, right: Floats, up: Floats) -> Floats:
        return right + up - near + rate * step_u * step_v * np.sin((right + up) / 2)

    return _filled(on_u, on_v, close)


def front(normal: Floats, start: Floats) -> Floats:
    """Front from the nodes of N by Lelieuvre's equations, along the u-axis and then across."""
    along_u = np.cross(normal[1:], normal[:-1])
    along_v = -np.cross(normal[:, 1:], normal[:, :-1])
    grid = np.empty_like(normal)
    grid[0, 0] = start
    grid[1:, 0] = start + np.cumsum(along_u[:, 0], axis=0)
    grid[:, 1:] = grid[:, :1] + np.cumsum(along_v, axis=1)
    return grid


def _quad_tangents(grid: Floats) -> tuple[Floats, Floats]:
    """Mean differences along u and along v on every quad."""
    along_u = (grid[1:, 1:] - grid[:-1, 1:] + grid[1:, :-1] - grid[:-1, :-1]) / 2
    along_v = (grid[1:, 1:] - grid[1:, :-1] + grid[:-1, 1:] - grid[:-1, :-1]) / 2
    return along_u, along_v


def _means(grid: Floats) -> Floats:
    return np.asarray((grid[1:, 1:] + grid[1:, :-1] + grid[:-1, 1:] + grid[:-1, :-1]) / 4)


def angle_gap(places: Floats, omega: Floats) -> float:
    """Largest difference on the quads of cos omega and the cosine between the lines of a front."""
    a, b = _quad_tangents(places)
    size = np.linalg.norm(a, axis=-1) * np.linalg.norm(b, axis=-1)
    return float(np.max(np.abs(np.sum(a * b, axis=-1) / size - np.cos(_means(omega)))))


def _areas(grid: Floats, normal: Floats) -> Floats:
    a, b = _quad_tangents(grid)
    return np.asarray(np.sum(np.cross(a, b) * _means(normal), axis=-1))


def curvature_gap(places: Floats, normal: Floats) -> float:
    """Largest |K + 1| on the quads, K being the ratio of the areas of N and of the front."""
    return float(np.max(np.abs(_areas(normal, normal) / _areas(places, normal) + 1)))


def orientation(places: Floats, normal: Floats) -> int:
    """Sign of (r_u x r_v).N if it is the same on all quads, else 0."""
    signs = np.sign(_areas(places, normal))
    return int(signs[0, 0]) if bool(np.all(signs == signs[0, 0])) else 0
