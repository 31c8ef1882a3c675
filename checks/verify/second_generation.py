"""Section 4.1: the second generation of sectors for phi_0 = pi/2, phi* = 3 pi/4, R = 3."""

import math
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.verify.amsler_balls import right_angle
from checks.verify.amsler_cuts import LEVEL, RADIUS, amsler_star, cut_bounds, first_cut
from checks.verify.ball_bounds import Row, bounded
from checks.verify.disk_surgery import disk_daughter
from checks.verify.initial_angles import fraction
from discrete.branched_net import BranchedNet, surgery
from discrete.k_surface import k_surface
from discrete.net_contours import (
    contour_meets_circle,
    middle_angles,
    middle_distances,
    value_at,
)
from discrete.placed_frames import placed_distances
from theory import daughter_sectors, painleve, painleve_float

_OUTER, _MIDDLE = 6, 5


@cache
def second_net(edges: int) -> tuple[BranchedNet, tuple[Any, ...], float]:
    """Net with the first cut, distances of its vertices, edge length; u* is `edges` edges."""
    step = first_cut()[0] / edges
    net = surgery(amsler_star(step), 0, (edges, edges))
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
    within: str = "1/20",
    sector: str = "outer",
    level: str = LEVEL,
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
        shown=f"the second cut of the {sector} sector is {found} from the crossing",
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
    setting: Setting, *, radius: str = RADIUS, sector: str = "outer"
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
        _, high, _ = cut_bounds(RADIUS, LEVEL)
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


def covered(setting: Setting, *, generations: int = 2, level: str = LEVEL) -> Evidence:
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
