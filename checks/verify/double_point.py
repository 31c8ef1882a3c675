"""Double points of the normal on surfaces around a folded corner, computed on discrete nets."""

from fractions import Fraction

import numpy as np

from checks.evidence import Evidence, Setting
from theory import folded_corner, folded_corner_surface, half_turn_net
from theory.half_turn_net import Array

CELLS = (32, 64, 128, 256)


def _corner(directions: tuple[float, float], sides: tuple[float, float], n: int, k: int) -> Array:
    """Far corner of the net over two geodesics in these directions, of signed lengths."""
    lines = [
        half_turn_net.broken_geodesic(np.full(n, a if side > 0 else a + np.pi), abs(side) / n, k)
        for a, side in zip(directions, sides, strict=True)
    ]
    far: Array = half_turn_net.net(lines[0], lines[1], k)[-1, -1]
    return far


def _turned(angles: tuple[float, float]) -> tuple[float, float]:
    """Directions of N_u = N x r_u and N_v = -N x r_v on the sphere."""
    return angles[0] + np.pi / 2, angles[1] - np.pi / 2


def _double_point(
    net: folded_corner.FoldedCorner, scale: float, cells: int, longer: float
) -> tuple[float, float, float, float]:
    """Place (u, v) of the second double point, mismatch of the normals, distance in H^2.

    The first one is (-1, -arm); lengths are in units of the scale.
    """
    theta, gamma = (float(np.arctan2(float(z[1]), float(z[0]))) for z in (net.steep, net.bent))
    arm = float(net.arm)
    left, right = (-theta, np.pi - (np.pi + gamma)), (gamma, theta)
    first = _corner(_turned(left), (-scale, -arm * longer * scale), cells, 1)
    place = np.array([arm, 1.0])

    def mismatch(at: Array) -> Array:
        found = _corner(_turned(right), (at[0] * scale, at[1] * scale), cells, 1)
        gap: Array = (found - first)[:2] / scale
        return gap

    for _ in range(20):
        value = mismatch(place)
        columns = [(mismatch(place + 1e-4 * e) - value) / 1e-4 for e in np.eye(2)]
        step = np.linalg.solve(np.array(columns).T, value)
        place = place - step
        if np.max(np.abs(step)) < 1e-9:
            break
    else:
        raise ArithmeticError("Newton's method did not find the double point")
    ends = [
        _corner(left, (-scale, -arm * longer * scale), cells, -1),
        _corner(right, (place[0] * scale, place[1] * scale), cells, -1),
    ]
    gap = ends[1] - ends[0]
    chord = float(np.sqrt(half_turn_net.inner(gap, gap, -1)))
    distance = 2 * float(np.arcsinh(chord / 2)) / scale
    left_over = float(np.max(np.abs(mismatch(place))))
    return float(place[0]), float(place[1]), left_over, distance


def on_nets(setting: Setting, *, t: str = "1/40", wider: str = "1", longer: str = "1") -> Evidence:
    """Double points found by Newton's method on nets against the certified bounds.

    wider: factor of the separation that is compared; longer: factor of v at the first point.
    """
    del setting
    family = folded_corner_surface.surfaces(Fraction(t))
    scale = float(family.scale)
    factor = float(Fraction(longer))
    rows = [_double_point(family.net, scale, n, factor) for n in CELLS]
    low, high = (float(x) for x in family.separation())
    arm, spare = float(family.net.arm), float(family.net.spare)
    u, v, left_over, distance = rows[-1]
    distance *= float(Fraction(wider))
    failures = []
    if not left_over < 1e-8:
        failures.append(f"the normals differ by {left_over:.2g} of the scale")
    if not max(abs(u - arm), abs(v - 1)) < spare:
        failures.append(f"the double point ({u:.5g}, {v:.5g}) is outside of the box")
    if not low < distance < high:
        failures.append(f"the distance {distance:.6g} is not in ({low:.6g}, {high:.6g})")
    limit = float(family.net.separation())
    if not abs(distance - limit) < scale:
        failures.append(f"the distance {distance:.6g} is not within the scale of {limit:.6g}")
    change = abs(rows[-1][3] - rows[-2][3])
    return Evidence(
        outcome="fail" if failures else "pass",
        grade="numeric",
        digits=8,
        tried=len(CELLS),
        met=len(CELLS),
        residual=f"{max(left_over, change):.0e}",
        shown=f"on nets of {CELLS[-1]}^2 quads in S^2 and H^2 the normals of two points at the "
        f"distance {distance:.6f} of the scale 1/16000 agree to 1e-8 of it, as certified",
        witness="; ".join(failures),
    )
