"""Section 4.1: the first cuts for phi_0 = pi/2, phi* = 3 pi/4, R = 3, and the sectors put in.

The contour phi = phi* is u v = c, c = z_c^2/4. A point (u, v) of it has |d - v| <= u and
d <= u + v, d being its distance from the crossing. So where the circle R meets it, the smaller
coordinate u* satisfies c/u* - u* <= R <= c/u* + u*, and such points exist: both bounds hold for
every intersection.
"""

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any

from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.verify.amsler_balls import right_angle
from checks.verify.ball_bounds import Row, bounded
from checks.verify.convergence import order
from checks.verify.initial_angles import fraction
from discrete.branched_net import BranchedNet, geodesic_ray, star
from discrete.net_contours import (
    contour_meets_circle,
    middle_angles,
    middle_distances,
)
from discrete.placed_frames import placed_distances
from theory import amsler_disk, painleve, painleve_float

#: Radius of the disk, and the cutoff phi* over pi.
RADIUS, LEVEL = "3", "3/4"
#: Edges of the first cut: u* is so many times the edge length.
_EDGES = (24, 32, 40, 48)


def _contour(level: str = LEVEL) -> Any:
    """Ball of c, with phi = level pi where u v = c."""
    place = painleve.crossing(right_angle, lambda: fraction(level) * arb.pi(), digits=25).ball()
    return place**2 / 4


def cut_bounds(radius: str, level: str) -> tuple[Any, Any, Any]:
    """Bounds of the smaller coordinate u* below and above, and c."""
    c, size = _contour(level), fraction(radius)
    return ((size**2 + 4 * c).sqrt() - size) / 2, (size - (size**2 - 4 * c).sqrt()) / 2, c


def _diagonal(u: Any) -> Any:
    """Distance of (u, u) from the crossing, at the upper end of the ball."""
    return painleve.diagonal(right_angle, lambda: (2 * u).upper(), digits=15).ball()


@cache
def first_cut() -> tuple[float, float]:
    """Floats u*, v of the intersection with u < v, from the continuum."""
    from scipy.optimize import brentq

    c = painleve_float.crossing(math.pi / 2, 3 * math.pi / 4) ** 2 / 4
    u = brentq(lambda x: amsler_disk.rim(math.pi / 2, x, 3.0) * x - c, 0.2505, 0.45, xtol=1e-12)
    return float(u), c / float(u)


def location(setting: Setting, *, radius: str = RADIUS, level: str = LEVEL) -> Evidence:
    """Whether contour and circle meet on either side of the mirror line, and within which bounds.

    On the mirror line the contour is inside the circle, near the axes outside.
    """
    del setting

    def rows() -> Iterator[Row]:
        low, high, c = cut_bounds(radius, level)
        size = fraction(radius)
        yield "distance of the contour on the mirror line", _diagonal(c.sqrt()), size
        yield "R against the distance at the lower bound of u*", size, c / low - low + arb("1e-30")
        yield "lower against upper bound of u*", low, high
        yield "upper bound of u* against the mirror line", high, c.sqrt()

    return bounded(
        rows(),
        shown="contour and circle meet on each side of the mirror line, only with the smaller "
        "coordinate in [0.2505, 0.3017]",
    )


def kept_below(setting: Setting, *, level: str = LEVEL, share: str = "1") -> Evidence:
    """Whether phi <= phi* on the part u <= u* of the disk, and above it past u*.

    On the rim z^2 = 4 u v rises with u up to the cut. share: of u* that is cut at.
    """
    del setting
    c = float(_contour(level).mid())
    edge = float(Fraction(share)) * first_cut()[0]
    inside = [edge * k / 40 for k in range(1, 41)]
    values = [u * amsler_disk.rim(math.pi / 2, u, 3.0) for u in inside]
    past = edge * 1.01
    beyond = past * amsler_disk.rim(math.pi / 2, past, 3.0)
    rising = all(a < b for a, b in pairwise(values))
    fine = rising and values[-1] <= c * (1 + 1e-8) and beyond > c
    return Evidence(
        outcome="pass" if fine else "fail",
        grade="numeric",
        digits=8,
        tried=len(values) + 1,
        met=len(values) + 1,
        shown="on the rim u v rises with u to c at u*, so that phi <= phi* where u <= u* or "
        "v <= v* in the disk, and phi > phi* in what is cut out",
        witness=""
        if fine
        else f"u v on the rim is {values[-1]:.6f} at u = {edge:.6f} and "
        f"{beyond:.6f} at {past:.6f}; the contour has {c:.6f}",
    )


def location_by_net(setting: Setting, *, level: str = LEVEL, expected: int = 2) -> Evidence:
    """Order at which u* of the net, by splines, tends to that of the continuum."""
    u_star, _ = first_cut()
    steps, errors = [], []
    for n in _EDGES:
        step = u_star / n
        net = amsler_star(step)
        (distances,) = placed_distances(BranchedNet(placed=net.placed[:1], seams=()))
        found = contour_meets_circle(
            middle_angles(net.placed[0].sector),
            middle_distances(distances),
            step=step,
            level=float(Fraction(level)) * math.pi,
            radius=3.0,
        )
        steps.append(mp.mpf(step))
        errors.append(mp.mpf(found - u_star))
    return order(
        steps, errors, expected, digits=setting.digits,
        shown="u* of the net (angles advanced without coordinates, SL(2, R) frames) tends to that "
        "of the continuum (v-lines laid out on the hyperboloid)",
    )  # fmt: skip


def angle_at_cut(setting: Setting, *, level: str = LEVEL, lower: str = "1") -> Evidence:
    """Whether phi(u*, v*) < phi* < lower pi, u* = v* being at most its certified bound."""
    del setting

    def rows() -> Iterator[Row]:
        _, high, _ = cut_bounds(RADIUS, LEVEL)
        value = painleve.angle(right_angle, lambda: (2 * high).upper(), digits=15).ball()
        top = fraction(level) * arb.pi()
        yield "phi at the cut against phi*", value, top
        yield "phi* against pi", top, fraction(lower) * arb.pi()

    return bounded(
        rows(), shown="phi(u*, v*) <= 1.6618 = 0.529 pi, as u* = v* <= 0.3017 and phi rises with z"
    )


def radius_at_cut(
    setting: Setting, *, bound: str = "1/2", radius: str = RADIUS, inside: str = "2/5"
) -> Evidence:
    """Distance of the cut from the crossing, against the bound and against the singular edge.

    inside: most of the edge's distance that the cut may be at.
    """
    del setting

    def rows() -> Iterator[Row]:
        _, high, _ = cut_bounds(radius, LEVEL)
        reached = _diagonal(high)
        yield f"distance of the cut for R = {radius}", reached, fraction(bound)
        edge = painleve.crossing(right_angle, arb.pi, digits=20)
        whole = painleve.diagonal(right_angle, edge.ball, digits=15).ball()
        yield "distance of the cut against the edge's", reached, fraction(inside) * whole

    return bounded(
        rows(), shown="the cut is at most 0.4201 from the crossing (0.3706 in floats), a third of "
        "the 1.2662 of the singular edge",
    )  # fmt: skip


def amsler_star(step: float) -> BranchedNet:
    """Four quadrants with the angle pi/2 that reach a little past the circle R = 3."""
    ray = geodesic_ray([step] * math.ceil(3.6 / step))
    return star([ray] * 4, [math.pi / 2] * 4)
