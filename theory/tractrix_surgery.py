"""Surgery on the pseudosphere in float64: the three sectors at a point, on grids of n by n steps.

The pseudosphere is that of theory.fronts, away from its edge; the rays inserted at the point are
given by their angles from t_u in the tangent plane, as fractions of the angle cut out or freely.
"""

from dataclasses import dataclass

import numpy as np

from theory.goursat_float import (
    Floats,
    angle_gap,
    curvature_gap,
    front,
    moutard,
    sine_gordon,
)


@dataclass(frozen=True, kw_only=True)
class Cut:
    """Point (u, v) of the surgery, and lengths of the edges: inherited ones, then new ones."""

    u: float = -0.9
    v: float = -0.8
    edge_u: float = 0.5
    edge_v: float = 0.6
    ray_u: float = 0.8
    ray_v: float = 0.7


def place(u: Floats, v: Floats) -> Floats:
    """Points of the pseudosphere."""
    s, angle = u + v, v - u
    radius = 1 / np.cosh(s)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), s - np.tanh(s)], axis=-1)


def unit_normal(u: Floats, v: Floats) -> Floats:
    """Normals of the pseudosphere."""
    s, angle = u + v, v - u
    slope = np.tanh(s)
    return np.stack([slope * np.cos(angle), slope * np.sin(angle), 1 / np.cosh(s)], axis=-1)


def angle(u: Floats, v: Floats) -> Floats:
    """Angle between the asymptotic lines, from cos omega = r_u.r_v = tanh^2 s - sech^2 s."""
    return np.asarray(np.arccos(1 - 2 / np.cosh(u + v) ** 2))


def tangents(cut: Cut) -> tuple[Floats, Floats, Floats]:
    """Vectors t_u, t_v and n_1 at the point, by central differences of order four."""
    h, u, v = 1e-3, _scalar(cut.u), _scalar(cut.v)
    shifts = np.array([-2.0, -1.0, 1.0, 2.0]) * h
    weights = np.array([1.0, -8.0, 8.0, -1.0]) / (12 * h)
    t_u = np.asarray(weights @ place(u + shifts, np.full(4, cut.v)))
    t_v = np.asarray(weights @ place(np.full(4, cut.u), v + shifts))
    return t_u, t_v, unit_normal(u, v)


def _scalar(x: float) -> Floats:
    return np.asarray(x, dtype=np.float64)


def straight(n: Floats, e: Floats, s: Floats, *, sign: int) -> Floats:
    """Normals along a straight ray: they turn about e, sign = +1 for u-lines, -1 for v-lines."""
    return np.cos(s)[:, None] * n + sign * np.sin(s)[:, None] * np.cross(n, e)


@dataclass(frozen=True, kw_only=True)
class Sector:
    """Normals and front of a sector on its grid, and the angle from the sine-Gordon equation."""

    normal: Floats
    places: Floats
    omega: Floats


def sectors(
    cut: Cut, e_u: Floats, e_v: Floats, *, steps: int, rate: float = 1.0, fourth: int = 2
) -> tuple[Sector, Sector, Sector]:
    """Sectors Omega_1, Omega_2, Omega_3 for the new rays e_u and e_v.

    The angles start from those between the rays and change along inherited edges as they do on the
    pseudosphere, the curvatures of the edges being the same. rate: of the sine-Gordon equation;
    fourth: sector from which Omega_1 takes its v-axis, 3 for the wrong one.
    """
    t_u, t_v, n = tangents(cut)
    grid = np.linspace(0.0, 1.0, steps + 1)
    old_u, bent_u = _inherited(cut, cut.edge_u * grid, 0 * grid)
    old_v, bent_v = _inherited(cut, 0 * grid, cut.edge_v * grid)
    new_u = straight(n, e_u, cut.ray_u * grid, sign=1)
    new_v = straight(n, e_v, cut.ray_v * grid, sign=-1)
    first, middle, last = (_between(*pair) for pair in ((t_u, e_v), (e_v, e_u), (e_u, t_v)))
    lengths = ((cut.edge_u, cut.ray_v), (cut.ray_u, cut.ray_v), (cut.ray_u, cut.edge_v))
    flat = 0 * grid
    data = (
        (old_u, new_v if fourth == 2 else old_v, first + bent_u, first + flat),
        (new_u, new_v, middle + flat, middle + flat),
        (new_u, old_v, last + flat, last + bent_v),
    )
    start = place(_scalar(cut.u), _scalar(cut.v))
    one, two, three = (
        sector(axes, (a / steps, b / steps), start, rate=rate)
        for axes, (a, b) in zip(data, lengths, strict=True)
    )
    return one, two, three


def _inherited(cut: Cut, u: Floats, v: Floats) -> tuple[Floats, Floats]:
    """Normals along an edge of the quadrant, and how the angle changes from the point."""
    here = angle(_scalar(cut.u), _scalar(cut.v))
    return unit_normal(cut.u + u, cut.v + v), angle(cut.u + u, cut.v + v) - here


def _between(a: Floats, b: Floats) -> float:
    return float(np.arccos(a @ b / (np.linalg.norm(a) * np.linalg.norm(b))))


def sector(
    axes: tuple[Floats, Floats, Floats, Floats],
    step: tuple[float, float],
    start: Floats,
    *,
    rate: float = 1.0,
) -> Sector:
    """Solve both Goursat problems of a sector.

    axes: normals on the u- and the v-axis, angles on the u- and the v-axis.
    """
    on_u, on_v, angle_u, angle_v = axes
    normal = moutard(on_u, on_v, step_u=step[0], step_v=step[1])
    omega = sine_gordon(angle_u, angle_v, step_u=step[0], step_v=step[1], rate=rate)
    return Sector(normal=normal, places=front(normal, start), omega=omega)


def defects(found: Sector) -> dict[str, float]:
    """What vanishes to second order on a sector: |N| - 1, K + 1, and the gap of the two angles."""
    length = np.linalg.norm(found.normal, axis=-1)
    return {
        "|N| - 1": float(np.max(np.abs(length - 1))),
        "K + 1": curvature_gap(found.places, found.normal),
        "angle": angle_gap(found.places, found.omega),
    }


def edge_gaps(cut: Cut, found: tuple[Sector, Sector, Sector]) -> dict[str, float]:
    """Largest distances between fronts on glued edges, those to the pseudosphere to second order.

    chi_2 and chi_4 join two sectors whose edges have the same nodes: there rounding is all.
    """
    one, two, three = found
    u = cut.u + np.linspace(0.0, cut.edge_u, len(one.places))
    v = cut.v + np.linspace(0.0, cut.edge_v, len(three.places))
    return {
        "chi_1": _largest(one.places[:, 0] - place(u, np.full_like(u, cut.v))),
        "chi_2": _largest(three.places[:, 0] - two.places[:, 0]),
        "chi_3": _largest(three.places[0] - place(np.full_like(v, cut.u), v)),
        "chi_4": _largest(one.places[0] - two.places[0]),
    }


def _largest(a: Floats) -> float:
    return float(np.max(np.linalg.norm(a, axis=-1)))


def bent_normals(
    start: tuple[Floats, Floats], curvatures: tuple[float, float], s: Floats
) -> tuple[Floats, Floats]:
    """Normals of a u-line whose curvature jumps half-way, and the integral of the curvature.

    start: r_u and N at s = 0. On each half the frame turns at a constant rate about a fixed axis.
    """
    tangent, normal = start
    half = s[len(s) // 2]
    frame = np.stack([tangent, np.cross(normal, tangent), normal])
    before, after = s[s <= half], s[s > half] - half
    first = _turned(frame, curvatures[0], before)
    second = _turned(first[-1], curvatures[1], after)
    turning = np.concatenate([curvatures[0] * before, curvatures[0] * half + curvatures[1] * after])
    return np.concatenate([first[:, 2], second[:, 2]]), turning


def _turned(frame: Floats, curvature: float, s: Floats) -> Floats:
    """Frames (T, N x T, N) along a curve of constant curvature and torsion -1."""
    rate = np.hypot(curvature, 1.0)
    axis = (curvature * frame[2] - frame[0]) / rate
    turned = []
    for row in frame:
        along = np.dot(axis, row) * axis
        swing = np.cos(rate * s)[:, None] * (row - along)
        turned.append(along + swing + np.sin(rate * s)[:, None] * np.cross(axis, row))
    return np.stack(turned, axis=1)
