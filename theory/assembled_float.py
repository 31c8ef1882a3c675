"""Surfaces of curvature -1 assembled from sectors between curves of given curvature, in float64.

Each ray's frame is integrated by Frenet-Serret (DOP853, 1e-12), each sector's normal by a scheme of
second order for N_uv = -(N_u.N_v) N, its position by the Lelieuvre formulae; rays of even index are
u-lines. scipy is imported when a function is called.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import cos, pi, sin
from typing import Any

import numpy as np

from theory.errors import DomainError

Curvature = Callable[[float], float]
TOLERANCE = 1e-12
SWEEPS = 4


@dataclass(frozen=True, kw_only=True)
class Sector:
    """Sector i on a grid: arrays (n + 1, n + 1, 3) by u and v; step: of both coordinates.

    sigma: sign of (r_u x r_v).N; first_u: position integrated along u, then v; first_v: the other
    way round.
    """

    sigma: int
    step: float
    normal: Any
    first_u: Any
    first_v: Any

    def from_before(self, k: int) -> list[tuple[int, int]]:
        """Nodes of the antidiagonal u + v = k step, from ray i - 1 to ray i."""
        nodes = [(j, k - j) for j in range(k + 1)]
        return nodes if self.sigma == -1 else nodes[::-1]

    def outer_sides(self) -> list[tuple[int, int]]:
        """Nodes of the two outer sides, from ray i - 1 to ray i."""
        n = len(self.normal) - 1
        nodes = [(j, n) for j in range(n)] + [(n, n - j) for j in range(n + 1)]
        return nodes if self.sigma == -1 else nodes[::-1]


def ray_frames(angle: float, curvature: Curvature, torsion: int, length: float, steps: int) -> Any:
    """Frames (T, N x T, N) at steps + 1 points of a ray, an array (steps + 1, 3, 3)."""
    from scipy.integrate import solve_ivp

    def rate(t: float, state: Any) -> Any:
        tangent, side, normal = state.reshape(3, 3)
        k = curvature(t)
        return np.concatenate([k * side, -k * tangent + torsion * normal, -torsion * side])

    start = np.array([cos(angle), sin(angle), 0, -sin(angle), cos(angle), 0, 0, 0, 1], float)
    times = np.linspace(0, length, steps + 1)
    run = solve_ivp(
        rate, (0, length), start, method="DOP853", t_eval=times, rtol=TOLERANCE, atol=TOLERANCE
    )
    return run.y.T.reshape(steps + 1, 3, 3)


def filled(on_u: Any, on_v: Any, step: float) -> Any:
    """Normal on a square grid from its values on both axes, antidiagonal by antidiagonal."""
    n = len(on_u) - 1
    normal = np.zeros((n + 1, n + 1, 3))
    normal[:, 0], normal[0, :] = on_u, on_v
    for k in range(2, 2 * n + 1):
        i = np.arange(max(1, k - n), min(n, k - 1) + 1)
        j = k - i
        a, b, c = normal[i - 1, j - 1], normal[i, j - 1], normal[i - 1, j]
        d = b + c - a
        for _ in range(SWEEPS):
            n_u, n_v = (b - a + d - c) / (2 * step), (c - a + d - b) / (2 * step)
            product = np.sum(n_u * n_v, axis=1, keepdims=True)
            d = b + c - a - step**2 * product * (a + b + c + d) / 4
        normal[i, j] = d
    return normal


def positions(normal: Any) -> tuple[Any, Any]:
    """Positions along u then v, and along v then u, from r_u = N_u x N, r_v = -N_v x N."""
    along_u = np.cross(normal[1:] - normal[:-1], (normal[1:] + normal[:-1]) / 2)
    along_v = -np.cross(normal[:, 1:] - normal[:, :-1], (normal[:, 1:] + normal[:, :-1]) / 2)
    on_u = np.zeros_like(normal)
    on_v = np.zeros_like(normal)
    on_u[1:] = np.cumsum(along_u, axis=0)
    on_v[:, 1:] = np.cumsum(along_v, axis=1)
    return on_u[:, :1] + on_v, on_v[:1] + on_u


def assembled(
    angles: Sequence[float],
    curvatures: Sequence[Curvature],
    *,
    length: float,
    steps: int,
    torsions: tuple[int, int] = (-1, 1),
    other_side: Sequence[Curvature] = (),
) -> tuple[Sector, ...]:
    """Sectors 1, ..., 2m of a star; angles alpha_i, curvatures of the rays 1, ..., 2m.

    torsions: of the rays of even and of odd index; other_side: curvatures that the rays have as
    second edge of their sectors, if they differ. Raises DomainError where the numbers of angles and
    curvatures differ, an angle is not in (0, pi), or the length or the steps are not positive.
    """
    if len(angles) != len(curvatures) or not all(0 < alpha < pi for alpha in angles):
        raise DomainError("every ray needs a curvature, and every sector an angle in (0, pi)")
    if not length > 0 or steps < 1:
        raise DomainError(f"length and steps must be positive, not {length} and {steps}")
    count, angle = len(angles), 0.0
    ends: list[tuple[float, float]] = []
    for alpha in angles:
        ends.append((angle, angle + alpha))
        angle += alpha
    frames = {}
    for i in range(1, count + 1):
        before = i - 1 or count
        for ray, at, given in (
            (before, ends[i - 1][0], curvatures),
            (i, ends[i - 1][1], other_side or curvatures),
        ):
            torsion = torsions[ray % 2]
            frames[i, ray] = ray_frames(at, given[ray - 1], torsion, length, steps)
    found = []
    for i in range(1, count + 1):
        before = i - 1 or count
        even, odd = (i, before) if i % 2 == 0 else (before, i)
        normal = filled(frames[i, even][:, 2], frames[i, odd][:, 2], length / steps)
        first_u, first_v = positions(normal)
        found.append(
            Sector(
                sigma=-1 if i % 2 == 0 else 1,
                step=length / steps,
                normal=normal,
                first_u=first_u,
                first_v=first_v,
            )
        )
    return tuple(found)


def edge_angles(sector: Sector, along: str) -> Any:
    """Angle of r_u and r_v on the edge v = 0 (along u) or u = 0, by one-sided differences."""
    n = sector.normal if along == "u" else np.swapaxes(sector.normal, 0, 1)
    own = np.gradient(n[:, 0], sector.step, axis=0, edge_order=2)
    across = (-3 * n[:, 0] + 4 * n[:, 1] - n[:, 2]) / (2 * sector.step)
    # Both Lelieuvre formulae turn N_u and N_v by a right angle, with opposite signs.
    cosine = -np.sum(own * across, axis=1)
    size = np.linalg.norm(own, axis=1) * np.linalg.norm(across, axis=1)
    return np.arccos(np.clip(cosine / size, -1, 1))


def circuit(sectors: Sequence[Sector], k: int | None) -> list[tuple[Any, Any]]:
    """Positions and normals once around the centre, counter-clockwise.

    Along u + v = k step in every sector, or along the outer sides where k is None.
    """
    found = []
    for sector in sectors:
        nodes = sector.outer_sides() if k is None else sector.from_before(k)
        found += [(sector.first_u[p, q], sector.normal[p, q]) for p, q in nodes[:-1]]
    return found


def upward_crossings(heights: Sequence[float]) -> int:
    """Times that a closed sequence of heights passes from negative to positive; zeros are left."""
    signs = [h > 0 for h in heights if h != 0]
    return sum(not a and b for a, b in zip(signs, signs[1:] + signs[:1], strict=True))


def winding(vectors: Sequence[Any]) -> int:
    """Turns of the first two components along a closed sequence of vectors."""
    z = np.array([complex(v[0], v[1]) for v in vectors])
    return round(float(np.sum(np.angle(np.roll(z, -1) / z))) / (2 * pi))
