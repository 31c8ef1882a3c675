"""Corrugations of a linear short map of the plane into R^3, two at a time (Nash, Kuiper).

Data: the columns p, q in R^3 of a linear map, and the metric defect diag(d1, d2), d_i > 0, that is
missing in its induced metric, in the eigenbasis of the defect. The first corrugation, of frequency
n along x1, is exact; the second, of frequency N n along x2, leaves a defect of order 1/N.
A corrugation turns the tangent by a triangle wave, so that everything is in closed form.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class ShortMap:
    """Linear map (x1, x2) -> p x1 + q x2 into R^3, and the missing metric diag(d1, d2).

    Raises ValueError where p and q are parallel or the map is not short.
    """

    p: Array
    q: Array
    missing: tuple[float, float]

    def __post_init__(self) -> None:
        if not np.linalg.norm(np.cross(self.p, self.q)) > 0:
            raise ValueError("expected an immersion: the columns are parallel")
        if not min(self.missing) > 0:
            raise ValueError(f"expected a short map, got the metric defect {self.missing}")

    @property
    def metric(self) -> Array:
        """Metric to be reached, a 2x2 array."""
        columns = np.stack([self.p, self.q])
        metric: Array = columns @ columns.T + np.diag(self.missing)
        return metric


def turning(ratio: Array) -> Array:
    """Amplitude b in (0, pi) of the tangent's angle whose mean cosine sin(b)/b is the ratio."""
    low, high = np.zeros_like(ratio), np.full_like(ratio, np.pi)
    for _ in range(60):
        middle = (low + high) / 2
        above = np.sinc(middle / np.pi) > ratio
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    return (low + high) / 2


def wave(phase: Array, amplitude: Array) -> tuple[Array, Array, Array]:
    """Angle a of the tangent at this phase, and integrals over it of cos a - mean and of sin a.

    The angle rises from 0 to the amplitude at phase 1/4, falls to its opposite at 3/4, and returns.
    """
    s = phase - np.floor(phase)
    tent = np.where(s < 0.25, 4 * s, np.where(s < 0.75, 2 - 4 * s, 4 * s - 4))
    angle = amplitude * tent
    top = np.sin(amplitude)
    turned = np.where(
        s < 0.25,
        np.sin(angle),
        np.where(s < 0.75, 2 * top - np.sin(angle), 4 * top + np.sin(angle)),
    )
    falling = (s >= 0.25) & (s < 0.75)
    height = np.where(falling, 1 + np.cos(angle) - 2 * np.cos(amplitude), 1 - np.cos(angle))
    return angle, (turned / 4 - top * s) / amplitude, height / (4 * amplitude)


def _unit(a: Array) -> Array:
    unit: Array = a / np.linalg.norm(a, axis=-1, keepdims=True)
    return unit


def _step(fixed: Array, moved: Array, missing: float, phase: Array) -> tuple[Array, Array]:
    """Corrugate once: derivative along the axis, and displacement times the frequency.

    fixed, moved: derivatives across and along it before, arrays of vectors.
    """
    normal = _unit(np.cross(fixed, moved))
    across = _unit(np.cross(normal, fixed))
    speed = np.sum(moved * across, axis=-1)
    target = np.sqrt(speed**2 + missing)
    amplitude = turning(speed / target)
    angle, forward, upward = wave(phase, amplitude)
    velocity = (
        moved
        + (target * np.cos(angle) - speed)[..., None] * across
        + (target * np.sin(angle))[..., None] * normal
    )
    shift = target[..., None] * (forward[..., None] * across + upward[..., None] * normal)
    return velocity, shift


def displacements(short: ShortMap, phase_1: Array, phase_2: Array) -> tuple[Array, Array]:
    """Both displacements times their frequencies, at these phases; arrays of vectors."""
    shape = np.shape(phase_1)
    p, q = (np.broadcast_to(v, (*shape, 3)) for v in (short.p, short.q))
    velocity, first = _step(q, p, short.missing[0], phase_1)
    _, second = _step(velocity, q, short.missing[1], phase_2)
    return first, second


def defect(short: ShortMap, frequency_ratio: float, *, nodes: int, step: float = 1e-6) -> float:
    """Largest metric defect after both corrugations, on a grid of phases.

    The second displacement varies along x1 at the rate 1/frequency_ratio times its derivative by
    the first phase, which is all that is left over. The nodes avoid the corners of the wave.
    """
    phases = (np.arange(nodes) + 0.5) / nodes
    phase_1, phase_2 = np.meshgrid(phases, phases, indexing="ij")
    q = np.broadcast_to(short.q, (*phase_1.shape, 3))
    p = np.broadcast_to(short.p, (*phase_1.shape, 3))
    velocity_1, _ = _step(q, p, short.missing[0], phase_1)
    velocity_2, _ = _step(velocity_1, q, short.missing[1], phase_2)
    ahead = displacements(short, phase_1 + step, phase_2)[1]
    behind = displacements(short, phase_1 - step, phase_2)[1]
    rest = (ahead - behind) / (2 * step * frequency_ratio)
    stretch = 2 * np.sum(velocity_1 * rest, axis=-1) + np.sum(rest**2, axis=-1)
    shear = np.sum(velocity_2 * rest, axis=-1)
    return float(np.max(np.sqrt(stretch**2 + 2 * shear**2)))


def corrugated(short: ShortMap, x: Array, frequency: float, frequency_ratio: float) -> Array:
    """Corrugated map at the points x, an (m, 2) array; frequencies are in periods per length."""
    fast = frequency * frequency_ratio
    first, second = displacements(short, frequency * x[:, 0], fast * x[:, 1])
    moved: Array = x[:, :1] * short.p + x[:, 1:] * short.q + first / frequency + second / fast
    return moved
