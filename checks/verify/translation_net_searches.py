"""Re-analysis of the stored searches in translation nets, by rays traced from the centre."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import atan, cos, exp, pi, sin, sinh, tan

import numpy as np

from checks.evidence import Evidence, Setting
from checks.searches import john, normal_map
from checks.searches.translation_nets import split
from checks.stored import load
from checks.verify.stored_searches import judged

RAYS = 1440


@dataclass(frozen=True, kw_only=True)
class Net:
    """Directions of the sides of A and B, and the values of u and v at which they change."""

    a: tuple[float, ...]
    b: tuple[float, ...]
    at_u: tuple[float, ...]
    at_v: tuple[float, ...]

    def ends(self) -> tuple[complex, complex]:
        """Chords of A and B between their first and last value of the parameter."""
        first = (np.diff(self.at_u) * np.exp(1j * np.array(self.a))).sum()
        second = (np.diff(self.at_v) * np.exp(1j * np.array(self.b))).sum()
        return complex(first), complex(second)


def net_of(point: np.ndarray, sides: int, gap: complex = 0j) -> Net:
    """Net of a point of the search: B turned and scaled so that the chords differ by the gap."""
    a, la, b, lb = split(point, sides)
    ratio = complex((la * np.exp(1j * a)).sum() * (1 - gap) / (lb * np.exp(1j * b)).sum())
    turned = b + np.angle(ratio)
    # The sheet on which phi lies in (0, pi) at the start.
    turned = turned - 2 * pi * np.round((turned[0] - a[0] - pi / 2) / (2 * pi))
    u, v = np.cumsum(la), np.cumsum(lb * abs(ratio))
    return Net(a=tuple(a), b=tuple(turned), at_u=(0.0, *u), at_v=(0.0, *v))


def _side(x: float, rate: float, knots: tuple[float, ...]) -> tuple[int, float]:
    """Side in which x lies or that it is about to enter, and how far it is to the next knot."""
    inner = knots[1:-1]
    ahead = x + (1e-12 if rate > 0 else -1e-12)
    index = sum(ahead > knot for knot in inner)
    if rate > 0:
        left = inner[index] - x if index < len(inner) else np.inf
    else:
        left = x - inner[index - 1] if index > 0 else np.inf
    return index, float(left)


def trace(
    net: Net, start: tuple[float, float], direction: float, length: float
) -> Iterator[tuple[float, float, tuple[float, float]]]:
    """Pieces of a ray as (distance at its beginning, phi, place at its end); ends where phi is bad.

    direction: angle in the plane of the net.
    """
    u, v = start
    done = 0.0
    i, j = _side(u, 1.0, net.at_u)[0], _side(v, 1.0, net.at_v)[0]
    while done < length:
        for _ in range(3):
            phi = net.b[j] - net.a[i]
            if not 0 < phi < pi:
                yield done, phi, (u, v)
                return
            du = sin(net.b[j] - direction) / sin(phi)
            dv = sin(direction - net.a[i]) / sin(phi)
            (i, to_u), (j, to_v) = _side(u, du, net.at_u), _side(v, dv, net.at_v)
        step = min(length - done, *(far / abs(r) for far, r in ((to_u, du), (to_v, dv)) if r))
        u, v, done = u + step * du, v + step * dv, done + step
        yield done - step, net.b[j] - net.a[i], (u, v)


def _angles(net: Net, centre: tuple[float, float], radius: float) -> list[float]:
    """Angles of the net met by rays of this length in all directions."""
    turns = [2 * pi * (n + 0.5) / RAYS for n in range(RAYS)]
    return [phi for w in turns for _, phi, _ in trace(net, centre, w, radius)]


def _end(net: Net, start: tuple[float, float], vector: complex) -> tuple[float, float]:
    """Place reached from another along a straight segment of the plane."""
    *_, last = trace(net, start, float(np.angle(vector)), abs(vector))
    return last[2]


@dataclass(frozen=True, kw_only=True)
class Found:
    """What rays say of a net: distance of the farther point, angles within it and within more."""

    farther: float
    misses: float
    inner: float
    outer: float


def _found(net: Net, offset: float, pull: float, inner: float, outer: float) -> Found:
    """Trace from the first point to the centre, to the second, and all round.

    inner, outer: radii in units of the distance of the farther point.
    """
    first, second = net.ends()
    between = first + second
    to_centre = (1 - pull) * between * (0.5 + 1j * offset)
    start = (0.0, 0.0)
    centre = _end(net, start, to_centre) if pull < 1 else start
    end = _end(net, centre, between - to_centre)
    far = (net.at_u[-1], net.at_v[-1])
    misses = max(abs(end[0] - far[0]), abs(end[1] - far[1])) / abs(between)
    farther = max(abs(to_centre), abs(between - to_centre))
    least = [
        min(min(phi, pi - phi) for phi in _angles(net, centre, share * farther))
        for share in (inner, outer)
    ]
    return Found(farther=farther, misses=misses, inner=least[0], outer=least[1])


def threshold(
    setting: Setting,
    *,
    item: str = "one-to-one",
    k_max: str = "4.33",
    below: str = "4.31",
    share: str = "2/3",
) -> Evidence:
    """Least k_max at which the item was found to fail, between two numbers.

    Recomputed from the stored net by rays: 0 < phi < pi on B_3, curvatures on B_2, both points in
    B_2. share: part of the radius in which both points are to be.
    """
    del setting
    run = load("normal_map")
    point = np.array(run.result["points"][item])
    pull = 0.0 if item == "one-to-one" else 1.0
    top, _, bottom = share.partition("/")
    factor = float(bottom or 1) / float(top)
    net = net_of(point, normal_map.SIDES)
    found = _found(net, sinh(float(point[-1])), pull, 1.0, factor * (1 - 1e-6))
    first, second = net.ends()
    k = 1 / tan(found.inner / 2)
    failures = []
    if abs(first - second) > 1e-9 * abs(first):
        failures.append("the two normals differ")
    if found.misses > 1e-6:
        failures.append(f"the second point is missed by {found.misses:.2g}")
    if not found.outer > 0:
        failures.append(f"phi = {found.outer:.4g} in the larger disk")
    if not float(below) < k < float(k_max):
        failures.append(f"the curvatures reach {k:.5g}, not between {below} and {k_max}")
    return judged(
        run,
        failures,
        shown=f"of {run.evaluations} translation nets with two points of one normal in B_2 of B_3 "
        f"the least curved on B_2 reaches {k:.4g}: no counterexample below was found",
        residual=f"{found.misses:.0e}",
    )


def john_search(
    setting: Setting, *, power: str = "2", broken_percent: int = 95, disk_percent: int = 100
) -> Evidence:
    """Whether the nearest pair found that breaks John's inequality lies beyond r/L^power.

    Recomputed by rays. broken_percent: share of |w - z|/L that |f(w) - f(z)| may reach;
    disk_percent: radius of the disk that is to be free, in percent of the stored one.
    """
    del setting
    run = load("john")
    point = np.array(run.result["point"])
    offset, size, argument, log = (float(x) for x in point[4 * john.SIDES :])
    distortion = exp(log)
    gap = size * 2 * john.BROKEN / (distortion + john.BROKEN)
    net = net_of(point, john.SIDES, gap * complex(cos(argument), sin(argument)))
    # The radius of the disk in units of the farther point, by the stored margin.
    reach = distortion**2 / (1 + run.result["margin"])
    found = _found(net, sinh(offset), 0.0, 1.0, reach * disk_percent / 100 * (1 - 1e-6))
    first, second = net.ends()
    allowed = broken_percent / 100 * abs(first + second) / distortion
    failures = []
    if found.misses > 1e-6:
        failures.append(f"the second point is missed by {found.misses:.2g}")
    if not found.outer > 2 * atan(1 / distortion) - 1e-6:
        failures.append(f"phi = {found.outer:.4g} for L = {distortion:.4g}")
    if abs(first - second) > allowed * (1 + 1e-9):
        failures.append("the inequality is not broken")
    if not 1 / reach > distortion ** -float(power):
        failures.append(
            f"a pair at {1 / reach:.4g} of the radius breaks the inequality for L = "
            f"{distortion:.5g}"
        )
    return judged(
        run,
        failures,
        shown=f"of {run.evaluations} L-BLD maps and pairs of points none breaks the inequality "
        f"within {1 + run.result['margin']:.3g} r/L^2",
        residual=f"{found.misses:.0e}",
    )
