"""The cut of an Amsler sector of a geodesic disk: contours, circle and branch point (float64)."""

import math
from collections.abc import Iterator
from math import pi, sqrt
from typing import Any

from flint import arb

from checks.evidence import Evidence, Setting
from checks.printed import amsler_recursion as printed
from checks.verify import initial_angles
from checks.verify.ball_bounds import Row, bounded
from theory import amsler_disk, painleve, painleve_float

#: Errors of the layout are some 1e-10.
TOLERANCE = 1e-8
#: Openings, thresholds and radii; the first is the example of section 4.1.
DISKS = (
    (pi / 2, 3 * pi / 4, 3.0),
    (pi / 2, 3.0, 2.0),
    (1.0, 2.8, 4.0),
    (0.3, 2.2, 5.0),
    (2.0, 2.2, 2.0),
)
FloatRow = tuple[str, float, float]


def compared(rows: Iterator[FloatRow], *, shown: str) -> Evidence:
    """Numeric evidence that each quantity is at most its bound, up to 1e-8."""
    tried = 0
    for place, quantity, bound in rows:
        tried += 1
        if not quantity <= bound + TOLERANCE:
            witness = f"{place}: {quantity:.8g} > {bound:.8g}"
            return Evidence(
                outcome="fail",
                grade="numeric",
                witness=witness,
                shown=shown,
                digits=8,
                tried=tried,
                met=tried,
            )
    return Evidence(outcome="pass", grade="numeric", shown=shown, digits=8, tried=tried, met=tried)


def crossing_of_circle(opening: float, radius: float, contour: float) -> float:
    """Coordinate u where the circle meets the contour z = contour before the mirror line u = v."""
    from scipy.optimize import brentq

    def excess(u: float) -> float:
        return amsler_disk.distance(opening, u, contour**2 / (4 * u)) - radius

    # The v-line that meets the contour at v = 2 R + 1 has left the disk before.
    return float(brentq(excess, contour**2 / (8 * radius + 4), contour / 2, xtol=1e-13))


def strip_of_disk(setting: Setting, *, domain: str = "disk", share: str = "1") -> Evidence:
    """Angle on the part u <= u* of the disk, where u* is the largest that the region allows.

    domain: the region's part in the `disk`, or whole `rectangles` with the lengths of the axes as
    sides, a reading that leaves out the part of the disk beyond them.
    """
    del setting

    def rows() -> Iterator[FloatRow]:
        for opening, level, radius in DISKS:
            contour = painleve_float.crossing(opening, level)
            if domain == "rectangles":
                edge = float(printed.cutoff_contour(contour, radius))
            else:
                edge = crossing_of_circle(opening, radius, contour)
            edge *= float(initial_angles.fraction(share))
            place = f"phi_n = {opening:.6g}, phi* = {level:.6g}, R = {radius:.6g}"
            for part in (0.25, 0.5, 0.75, 1.0):
                top = _top_angle(opening, edge * part, radius)
                yield f"phi where u = {part} u* leaves the disk, {place}", top, level
            beyond = _top_angle(opening, edge * 1.001, radius)
            yield f"phi* against phi at 1.001 u*, {place}", level, beyond

    return compared(
        rows(),
        shown="phi <= phi* on the part u <= u* of the disk and not beyond: u* is "
        "where the circle meets the contour phi = phi*",
    )


def _top_angle(opening: float, u: float, radius: float) -> float:
    v = amsler_disk.rim(opening, u, radius)
    return painleve_float.angle(opening, 2 * sqrt(u * v))


def beyond_the_rectangle(setting: Setting, *, halves: int = 2, along: str = "127/100") -> Evidence:
    """Whether the point u = v of a sector is nearer to the apex than u: outside [0, R]^2."""
    del setting

    def opening() -> Any:
        return arb.pi() / halves

    def rows() -> Iterator[Row]:
        u = initial_angles.fraction(along)
        distance = painleve.diagonal(opening, 2 * u, digits=20).ball()
        yield "phi at the point", painleve.angle(opening, 2 * u).ball(), arb.pi()
        yield f"distance of (u, u), u = {along}", distance, u

    return bounded(
        rows(),
        shown="the disk through (u, u), u = 1.27, of a sector of opening pi/2 has "
        "a radius below u: it is not in the rectangle of its axes",
    )


def sketch(setting: Setting, *, share: str = "1", lowered: str = "1") -> Evidence:
    """What the figure shows: circle through both axes, two contours, the node and the L-region."""
    del setting

    def rows() -> Iterator[FloatRow]:
        for opening, level, radius in DISKS:
            place = f"phi_n = {opening:.6g}, phi* = {level:.6g}, R = {radius:.6g}"
            contour = painleve_float.crossing(opening, level)
            u = crossing_of_circle(opening, radius, contour) * float(initial_angles.fraction(share))
            v, node = u, 2 * u
            corner = amsler_disk.rim(opening, u, radius)
            shown = float(initial_angles.fraction(lowered)) * contour
            yield f"contour of the node against z = z*, {place}", node, shown
            yield f"node against the circle, {place}", amsler_disk.distance(opening, u, v), radius
            for name, (a, b) in {"u_n*": (u, corner), "v_n*": (corner, v)}.items():
                off = abs(amsler_disk.distance(opening, a, b) - radius)
                yield f"distance of the corner at {name} from the circle, {place}", off, 0.0
                apart = abs(2 * sqrt(a * b) - contour)
                yield f"distance of the corner at {name} from z = z*, {place}", apart, 0.0
            near_axis = amsler_disk.rim(opening, radius * 1e-6, radius)
            yield f"v_max against R, {place}", abs(near_axis - radius), 1e-4
            phi = painleve_float.angle(opening, node)
            yield f"phi at the node against phi*, {place}", phi, level

    return compared(
        rows(),
        shown="the circle of radius R meets the axes at R; the contour z = z* "
        "meets it at two places, which bound the L-shaped region; the node of its inner "
        "corner is inside the circle on a lower contour",
    )


def nodes_of_disks(setting: Setting, *, daughters: str = "3", best: bool = False) -> Evidence:
    """Bound of the remark at the node of the disk, both axes of length R."""
    del setting

    def rows() -> Iterator[FloatRow]:
        for opening, level, radius in DISKS:
            contour = painleve_float.crossing(opening, level)
            u = crossing_of_circle(opening, radius, contour)
            x = _inverse_i0(level / opening)
            c = 1.0 if best else sqrt(_constant_squared(level))
            argument, under = printed.ratio_bound(c, x, radius, daughters=daughters)
            place = f"phi_n = {opening:.6g}, phi* = {level:.6g}, R = {radius:.6g}"
            yield f"zeta_n against the node, {place}", x * x / (2 * radius), 2 * u
            bound = opening * float(arb(argument).bessel_i(0)) / under
            yield f"bound, {place}", bound, painleve_float.angle(opening, 2 * u) / 3

    return compared(
        rows(),
        shown="the node of the disk is farther out than that of the lemma, and "
        "phi_{n+1} above the bound, for five disks",
    )


def _constant_squared(level: float) -> float:
    return float(printed.constant_squared(level, math))


def _inverse_i0(y: float) -> float:
    from scipy.optimize import brentq
    from scipy.special import i0

    return float(brentq(lambda x: float(i0(x)) - y, 0.0, 60.0, xtol=1e-13))
