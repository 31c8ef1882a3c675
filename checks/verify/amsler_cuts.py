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

import numpy as np
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.verify.amsler_balls import right_angle
from checks.verify.ball_bounds import Row, bounded
from checks.verify.convergence import order
from checks.verify.disk_surgery import disk_daughter
from checks.verify.initial_angles import fraction
from discrete.branched_net import BranchedNet, geodesic_ray, star, surgery
from discrete.k_surface import k_surface
from discrete.net_contours import (
    contour_meets_circle,
    middle_angles,
    middle_distances,
    value_at,
)
from discrete.placed_frames import placed_distances
from theory import amsler_disk, daughter_sectors, painleve, painleve_float

_RADIUS = "3"
_LEVEL = "3/4"
#: Edges of the first cut: u* is so many times the edge length.
_EDGES = (24, 32, 40, 48)
_OUTER, _MIDDLE = 6, 5


def _contour(level: str = _LEVEL) -> Any:
    """Ball of c, with phi = level pi where u v = c."""
    place = painleve.crossing(right_angle, lambda: fraction(level) * arb.pi(), digits=25).ball()
    return place**2 / 4


def _bracket(radius: str, level: str) -> tuple[Any, Any, Any]:
    """Bounds of u* below and above, and c."""
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


def location(setting: Setting, *, radius: str = _RADIUS, level: str = _LEVEL) -> Evidence:
    """Whether contour and circle meet on either side of the mirror line, and within which bounds.

    On the mirror line the contour is inside the circle, near the axes outside.
    """
    del setting

    def rows() -> Iterator[Row]:
        low, high, c = _bracket(radius, level)
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


def kept_below(setting: Setting, *, level: str = _LEVEL, share: str = "1") -> Evidence:
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


def location_by_net(setting: Setting, *, level: str = _LEVEL, expected: int = 2) -> Evidence:
    """Order at which u* of the net, by splines, tends to that of the continuum."""
    u_star, _ = first_cut()
    steps, errors = [], []
    for n in _EDGES:
        step = u_star / n
        net = _star(step)
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


def angle_at_cut(setting: Setting, *, level: str = _LEVEL, lower: str = "1") -> Evidence:
    """Whether phi(u*, v*) < phi* < lower pi, u* = v* being at most its certified bound."""
    del setting

    def rows() -> Iterator[Row]:
        _, high, _ = _bracket(_RADIUS, _LEVEL)
        value = painleve.angle(right_angle, lambda: (2 * high).upper(), digits=15).ball()
        top = fraction(level) * arb.pi()
        yield "phi at the cut against phi*", value, top
        yield "phi* against pi", top, fraction(lower) * arb.pi()

    return bounded(
        rows(), shown="phi(u*, v*) <= 1.6618 = 0.529 pi, as u* = v* <= 0.3017 and phi rises with z"
    )


def radius_at_cut(
    setting: Setting, *, bound: str = "1/2", radius: str = _RADIUS, inside: str = "2/5"
) -> Evidence:
    """Distance of the cut from the crossing, against the bound and against the singular edge.

    inside: most of the edge's distance that the cut may be at.
    """
    del setting

    def rows() -> Iterator[Row]:
        _, high, _ = _bracket(radius, _LEVEL)
        reached = _diagonal(high)
        yield f"distance of the cut for R = {radius}", reached, fraction(bound)
        edge = painleve.crossing(right_angle, arb.pi, digits=20)
        whole = painleve.diagonal(right_angle, edge.ball, digits=15).ball()
        yield "distance of the cut against the edge's", reached, fraction(inside) * whole

    return bounded(
        rows(), shown="the cut is at most 0.4201 from the crossing (0.3706 in floats), a third of "
        "the 1.2662 of the singular edge",
    )  # fmt: skip


def _star(step: float) -> BranchedNet:
    ray = geodesic_ray([step] * math.ceil(3.6 / step))
    return star([ray] * 4, [math.pi / 2] * 4)


@cache
def second_net(edges: int) -> tuple[BranchedNet, tuple[Any, ...], float]:
    """Net with the first cut, distances of its vertices, edge length; u* is `edges` edges."""
    step = first_cut()[0] / edges
    net = surgery(_star(step), 0, (edges, edges))
    return net, tuple(placed_distances(net)), step


def second_cut(edges: int, sector: int, level: float, radius: float) -> tuple[float, float, float]:
    """Coordinates of the cut of a daughter sector and its distance from the crossing."""
    net, distances, step = second_net(edges)
    angles, middles = (
        middle_angles(net.placed[sector].sector),
        middle_distances(distances[sector]),
    )
    u, v = (
        contour_meets_circle(a, d, step=step, level=level, radius=radius)
        for a, d in ((angles, middles), (angles.T, middles.T))
    )
    return u, v, value_at(distances[sector], step=step, u=u, v=v)


def second_radius(
    setting: Setting,
    *,
    value: str = "3/2",
    within: str = "1/4",
    sector: str = "outer",
    level: str = _LEVEL,
) -> Evidence:
    """Distance of the second cut: Richardson's value of two nets, against value up to within.

    sector: `outer`, beside a line of the parent, or `middle`. The edge length enters linearly, for
    the corner angle is that of the quad.
    """
    del setting
    number = {"outer": _OUTER, "middle": _MIDDLE}[sector]
    top = float(Fraction(level)) * math.pi
    coarse, middle, fine = (second_cut(n, number, top, 3.0)[2] for n in (12, 24, 48))
    limit, before = 2 * fine - middle, 2 * middle - coarse
    spread = abs(limit - before)
    off = abs(limit - float(Fraction(value)))
    fine = off + spread <= float(Fraction(within))
    found = f"{limit:.4f} +- {max(spread, 1e-4):.4f}"
    return Evidence(
        outcome="pass" if fine else "fail",
        grade="experiment",
        residual=f"{off:.2g}",
        tried=3,
        met=3,
        shown=f"the second cut of the {sector} sector is {found} from the crossing; the circles of "
        "the figure are 0.5 apart, and 1.5 is the nearest to it",
        witness="" if fine else f"the {sector} sector is cut at the distance {found}",
    )


def two_ways(
    setting: Setting, *, weight: int = 2, divisor: int = 3, principal: bool = False
) -> Evidence:
    """Outer sector by the printed formulas in the disk against the advance of angles and frames.

    weight, divisor: of the printed trisection; principal: whether its arguments are in (-pi, pi].
    """
    del setting
    edges, count = 12, 60
    net, distances, step = second_net(edges)
    radii, angles = disk_daughter(
        step, edges, count, weight=weight, divisor=divisor, principal=principal
    )
    gap = float(np.abs(radii - distances[_OUTER][: count + 1, : count + 1]).max())
    turn = float(np.abs(angles - net.placed[_OUTER].sector.angles[:count, :count]).max())
    worst = max(gap, turn)
    return Evidence(
        outcome="pass" if worst < 1e-8 else "fail",
        grade="numeric",
        residual=f"{worst:.1g}",
        digits=8,
        tried=2 * radii.size,
        met=2 * radii.size,
        shown="distances and angles of the outer sector by (poincare-ddg) in the disk and by the "
        "intrinsic advance with frames agree",
        witness="" if worst < 1e-8 else f"distances differ by {gap:.2g}, angles by {turn:.2g}",
    )


def second_meets_circle(
    setting: Setting, *, radius: str = _RADIUS, sector: str = "outer"
) -> Evidence:
    """Least distance from the crossing at which the angle of a daughter sector reaches pi."""
    del setting
    number = {"outer": _OUTER, "middle": _MIDDLE}[sector]
    least = []
    for edges in (12, 24, 48):
        net, distances, _ = second_net(edges)
        past = middle_angles(net.placed[number].sector) >= math.pi
        least.append(float(middle_distances(distances[number])[past].min()))
    found, spread = least[-1], abs(least[-1] - least[-2])
    fine = found + 2 * spread < float(Fraction(radius))
    return Evidence(
        outcome="pass" if fine else "fail",
        grade="experiment",
        residual=f"{spread:.2g}",
        tried=3,
        met=3,
        shown=f"the edge phi = pi of the {sector} sector comes within {found:.3f} of the crossing",
        witness="" if fine else f"it stays {found:.3f} +- {spread:.3f} away from the crossing",
    )


def pseudo_axis(setting: Setting, *, start: str = "1", orientation: int = 1) -> Evidence:
    """Whether phi varies along the axis that an outer daughter shares with her parent.

    Up to the circle the parent's angle rises there from that at the cut to phi* = 3 pi/4.
    start: factor of the bound of the angle at the cut; orientation: of the daughter.
    """
    slope = daughter_sectors.slope_on_shared_edge(1, family="v")
    (parent,) = slope.free_symbols

    def rows() -> Iterator[Row]:
        _, high, _ = _bracket(_RADIUS, _LEVEL)
        value = painleve.angle(right_angle, lambda: (2 * high).upper(), digits=15).ball()
        yield "angle at the cut against phi*", fraction(start) * value, 3 * arb.pi() / 4

    return combined(
        {
            "slope": identities(
                setting, {"slope of the daughter": slope - orientation * parent}, shown="the same"
            ),
            "parent": bounded(rows(), shown="the parent's angle is not constant"),
        },
        shown="on the shared axis phi has the slope of the parent's angle, which rises there from "
        "1.6618 at most to 2.3562; the slope is minus the geodesic curvature of the axis",
    )


def pseudo_axis_by_net(setting: Setting, *, axis: str = "shared", factor: str = "1") -> Evidence:
    """Change of the net's angle along the axis that an outer daughter shares with her parent.

    axis: `shared`, or `new`, the geodesic; factor: of the change that PIII predicts.
    """
    del setting
    changes = []
    for edges in (12, 24, 48):
        net, _, step = second_net(edges)
        angles = net.placed[_OUTER].sector.angles
        along = angles[0] if axis == "shared" else angles[:, 0]
        count = 8 * edges
        changes.append(float(along[count] - along[0]))
    u = first_cut()[0]
    near, far = 2 * u, 2 * math.sqrt(u * (u + count * step))
    predicted = painleve_float.angle(math.pi / 2, far) - painleve_float.angle(math.pi / 2, near)
    # The angle of a quad differs from that at its vertex by a term linear in the edge length.
    limit = (changes[0] - 6 * changes[1] + 8 * changes[2]) / 3
    gap = abs(limit - float(Fraction(factor)) * predicted)
    fine = gap < 1e-3
    return Evidence(
        outcome="pass" if fine else "fail",
        grade="numeric",
        residual=f"{gap:.1g}",
        digits=3,
        tried=3,
        met=3,
        shown=f"along {count * step:.2f} of the axis the angle changes by {limit:.4f}",
        witness="" if fine else f"the angle changes by {limit:.4f}, not by {predicted:.4f}",
    )


def bounded_curvature(setting: Setting, *, reach: str = "1/4", growth: str = "1/50") -> Evidence:
    """Largest curvature of the sectors about the branch point on three nets, and their fit.

    Vertices have one normal each, so that neighbouring faces share the tangent plane on their edge.
    reach: of the neighbourhood, in asymptotic coordinates; growth: allowed from net to net.
    """
    del setting
    size, largest, gaps = float(Fraction(reach)), [], []
    for edges in (12, 24, 48):
        net, _, step = second_net(edges)
        count = int(size / step)
        near = [net.placed[k].sector.angles[:count, :count] for k in (4, 5, 6)]
        near.append(net.placed[0].sector.angles[: edges + count, :edges])
        near.append(net.placed[0].sector.angles[:edges, : edges + count])
        half = np.concatenate([a.ravel() for a in near]) / 2
        largest.append(float(np.maximum(1 / np.abs(np.tan(half)), np.abs(np.tan(half))).max()))
        gaps.append(k_surface(net).mismatch)
    ratios = [b / a for a, b in pairwise(largest)]
    fine = max(ratios) <= 1 + float(Fraction(growth)) and max(gaps) < 1e-9
    shown = ", ".join(f"{k:.4f}" for k in largest)
    return Evidence(
        outcome="pass" if fine else "fail",
        grade="experiment",
        residual=f"{max(abs(r - 1) for r in ratios):.1g}",
        tried=3,
        met=3,
        shown=f"within {reach} of the branch point the largest curvature is {shown} on three nets",
        witness="" if fine else f"largest curvatures {shown}; seams part by {max(gaps):.2g}",
    )


def covered(setting: Setting, *, generations: int = 2, level: str = _LEVEL) -> Evidence:
    """Area covered by one and by two generations in a quadrant of the disk, and largest angle.

    The three daughters are cut at their own intersections of contour and circle.
    """
    del setting
    edges = 24
    net, distances, step = second_net(edges)
    top = 3 * math.pi / 4
    claimed = float(Fraction(level)) * math.pi
    areas, largest = [], 0.0
    for number in (0, *((4, 5, 6) if generations == 2 else ())):
        placed = net.placed[number]
        sector, middles = placed.sector, middle_distances(distances[number])
        if number:
            u, v, _ = second_cut(edges, number, top, 3.0)
            i, j = int(u / step), int(v / step)
        else:
            i = j = edges
        n, m = sector.shape
        kept = (np.arange(n)[:, None] < i) | (np.arange(m) < j)
        kept &= middles < 3.0
        areas.append(float((2 * np.asarray(sector.net.half_defects))[kept].sum()))
        largest = max(largest, float(middle_angles(sector)[kept].max()))
    whole = math.pi / 2 * (math.cosh(3.0) - 1)
    first, both = areas[0], sum(areas)
    fine = largest <= claimed + step and both > 1.2 * first and both < whole
    return Evidence(
        outcome="pass" if fine else "fail",
        grade="experiment",
        residual=f"{max(largest - claimed, 0.0):.1g}",
        tried=4,
        met=4,
        shown=f"of a quadrant of area {whole:.2f} the first generation covers {first:.2f}, both "
        f"together {both:.2f}; the largest angle is {largest / math.pi:.3f} pi",
        witness=""
        if fine
        else f"areas {first:.3f} and {both:.3f} of {whole:.3f}, largest angle "
        f"{largest / math.pi:.4f} pi",
    )
