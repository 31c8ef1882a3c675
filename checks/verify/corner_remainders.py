"""Taylor remainders of surfaces near a folded corner, measured on discrete nets in S^2 and H^2."""

from collections.abc import Iterator
from fractions import Fraction

import numpy as np

from checks.evidence import Evidence, Setting
from theory import folded_corner, half_turn_net
from theory.half_turn_net import Array

SIZES = (0.5, 0.25, 0.125, 0.0625)
#: Signs of u and v; the quadrant u > 0 > v is the folded one.
QUADRANTS = ((-1, 1), (1, 1), (-1, -1))


def _angles(net: folded_corner.FoldedCorner, signs: tuple[int, int]) -> tuple[float, float]:
    """Directions of A and B on a quadrant, before the last step of each."""
    theta, gamma = (float(np.arctan2(float(z[1]), float(z[0]))) for z in (net.steep, net.bent))
    return (-theta if signs[0] < 0 else gamma), (theta if signs[1] > 0 else -gamma)


def _net(angles: tuple[float, float], signs: tuple[int, int], steps: Array, k: int) -> Array:
    """Net over two geodesics, in S^2 (k = 1, turned as N is) or in H^2 (k = -1)."""
    turns = (np.pi / 2, -np.pi / 2) if k > 0 else (0.0, 0.0)
    lines = [
        half_turn_net.broken_geodesic(
            np.full(len(steps) - 1, angle + turn + (np.pi if sign < 0 else 0.0)), steps[1], k
        )
        for angle, turn, sign in zip(angles, turns, signs, strict=True)
    ]
    return half_turn_net.net(lines[0], lines[1], k)


def _parts(
    angles: tuple[float, float], signs: tuple[int, int], steps: Array
) -> Iterator[tuple[str, float]]:
    """Largest quotient of each remainder and its bound on a quadrant."""
    u, v = np.meshgrid(signs[0] * steps, signs[1] * steps, indexing="ij")
    a, b = u * np.exp(1j * angles[0]), v * np.exp(1j * angles[1])
    span = np.abs(u) + np.abs(v)
    rows = (("N", 1, 1j * (a - b), span**2 / 2), ("X", -1, a + b, np.expm1(span) - span))
    for name, k, flat, bound in rows:
        points = _net(angles, signs, steps, k)
        model = np.stack([flat.real, flat.imag, np.ones_like(span)], axis=-1)
        off = np.linalg.norm(points - model, axis=-1)
        yield name, float(np.max(off[span > 0] / bound[span > 0]))
    turned = half_turn_net.angle(_net(angles, signs, steps, -1), -1)
    phi = turned if signs[0] == signs[1] else np.pi - turned
    # The angle is measured at the near vertex of a quad, and bounded at the far one.
    change = np.abs(phi - (angles[1] - angles[0]))
    yield "phi", float(np.max(change / np.abs(u * v)[1:, 1:]))


def remainders(
    setting: Setting, *, t: str = "1/8", percent: int = 100, cells: int = 64
) -> Evidence:
    """Remainders of N, X and phi on nets of the sizes 1/2 to 1/16, as parts of their bounds.

    percent: the bounds taken, in percent of S^2/2, of e^S - 1 - S and of |u v|.
    """
    del setting
    net = folded_corner.FoldedCorner(t=Fraction(t), spare=Fraction(1, 8))
    worst: dict[str, float] = {}
    for size in SIZES:
        steps = np.linspace(0.0, size, cells + 1)
        for signs in QUADRANTS:
            for name, part in _parts(_angles(net, signs), signs, steps):
                worst[name] = max(worst.get(name, 0.0), part)
    over = [f"{name}: {part:.6g}" for name, part in worst.items() if part > percent / 100]
    return Evidence(
        outcome="fail" if over else "pass",
        grade="numeric",
        digits=4,
        tried=len(SIZES) * len(QUADRANTS),
        met=len(SIZES) * len(QUADRANTS),
        shown="largest parts of the bounds on nets of three quadrants, sizes 1/2 to 1/16: "
        + ", ".join(f"{name} {part:.5f}" for name, part in worst.items()),
        witness=f"parts of the bounds above {percent} %: {', '.join(over)}" if over else "",
    )
