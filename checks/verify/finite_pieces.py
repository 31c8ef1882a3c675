"""Which bounded hyperbolic surfaces lie in R^3: disks do, closed surfaces do not."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from theory import closed_surface, collar, dini, hyperbolic_plane, surface_of_revolution
from theory.bobbin import KAPPA, THETA, S, bobbin, half_length, radius
from theory.curvature import first_form

R = sp.Symbol("R", positive=True)
GENUS = 2
_THROATS = {"cosh": sp.cosh(R), "sinh": sp.sinh(R), "half": sp.cosh(R / 2)}


def disk_in_bobbin(setting: Setting, *, throat: str = "cosh", curvature: int = -1) -> Evidence:
    """Geodesic disk of radius R about a point of the throat, in the cover of a bobbin.

    With theta = kappa tau the metric is ds^2 + cosh^2(s) d tau^2, that of H^2 about a geodesic, so
    that the disk is in |s| <= R. throat: the curvature kappa of the throat, a function of R.
    """
    kappa = _THROATS[throat]
    e, f, g = surface_of_revolution.first_form(bobbin(), THETA)
    room = sp.simplify((kappa**2 - sp.sinh(R) ** 2).rewrite(sp.exp))
    edge = sp.simplify(sp.sinh(half_length()) - KAPPA)
    return combined(
        {
            "metric": identities(
                setting,
                {"E": e - 1, "F": f, "G/kappa^2": g * KAPPA**2 - sp.cosh(S) ** 2},
                shown="metric of the strip",
            ),
            "curvature": identities(
                setting,
                {
                    "K": surface_of_revolution.gauss_curvature(bobbin(), THETA) - curvature,
                    "edge": edge,
                },
                shown="curvature -1 up to sinh L = kappa",
            ),
            "room": statement(
                bool(room.subs(R, 1) > 0) and sp.diff(room, R) == 0,
                shown="sinh L > sinh R",
                witness=f"sinh(L)^2 - sinh(R)^2 = {room} is not positive for every R",
            ),
        },
        shown="the cover of the bobbin of throat curvature cosh R, smooth and of curvature -1 up "
        "to its edges at |s| = L > R, contains a geodesic disk of radius R",
    )


def closed_surface_exists(setting: Setting) -> Evidence:
    """Build the closed surface of genus 2 and curvature -1, from a regular octagon."""
    corners = closed_surface.corner_count(GENUS)
    cosh_radius = closed_surface.cosh_circumradius(corners)
    angle = sp.acos(closed_surface.corner_cosine(corners, cosh_radius))
    area = closed_surface.area_by_angles(corners, angle)
    chi = closed_surface.euler_characteristic(GENUS)
    return identities(
        setting,
        {
            "sum of the corners - 2 pi": corners * angle - 2 * sp.pi,
            "area + 2 pi chi": area + 2 * sp.pi * chi,
        },
        shown="a regular octagon of circumradius arcosh(3 + 2 sqrt 2) has corners of sum 2 pi",
    )


def closed_surface_immersed(setting: Setting) -> Evidence:
    """Whether a closed surface can have curvature -1 in R^3, by its point farthest from 0."""
    distance = sp.Symbol("d", positive=True)
    excess = sp.symbols("a b", nonnegative=True)
    forced = closed_surface.curvature_at_farthest_point(distance, excess)
    return statement(
        not (forced + 1).is_positive,
        shown="",
        witness="the closed surface of genus 2 and curvature -1 (a regular octagon with its sides "
        "glued), also without one of its points p: its diameter is at most 2 arcosh(3 + 2 sqrt 2), "
        "and in R^3 its curvature where it is farthest from 0 (from the place of p) would be "
        f"{forced} >= 1/d^2 > 0",
    )


def finite_piece(
    setting: Setting, *, closed: bool = True, slack: int = 1, pitch: int = 1
) -> Evidence:
    """Bounded hyperbolic surfaces embedded in R^3: every disk of H^2, by a surface of Dini.

    closed: whether closed surfaces count as finite pieces; slack: width of the strip of H^2 that
    the surface covers, less the diameter 2R of the disk; pitch: of its screw, 0 for none.
    """
    parts = _dini_holds_disk(slack, pitch)
    if closed:
        parts["closed surface"] = closed_surface_exists(setting)
        parts["closed surface in R^3"] = closed_surface_immersed(setting)
    if all(part.outcome == "pass" for part in parts.values()):
        parts["metric"] = dini_metric(setting)
    return combined(
        parts,
        shown="every bounded subset of H^2 lies in a disk, and every disk of H^2 is embedded "
        "smoothly and isometrically as a part of a surface of Dini",
    )


def _dini_holds_disk(slack: int, pitch: int) -> dict[str, Evidence]:
    """Whether the strip is wider than the disk, and the surface free of double points.

    Two points as far from the axis have the same x = tan(v/2) in (0, 1), on which that distance
    grows; if they lie above each other, u differs by whole turns.
    """
    width = 2 * R + slack
    a, b = dini.radius_and_pitch(dini.WIDTH)
    turns = sp.Symbol("k", integer=True, positive=True)
    height = dini.point(a, pitch * b)[2]
    rise = sp.expand(height.subs(dini.U, dini.U + 2 * sp.pi * turns) - height)
    # x = 1/(1 + y), y > 0, makes the sign of the rate plain.
    y = sp.Symbol("y", positive=True)
    outwards = sp.cancel(sp.diff(dini.distance_to_axis(1), dini.X).subs(dini.X, 1 / (1 + y)))
    edge = dini.sinh_distance(width).subs(dini.X, 1) - sp.sinh(width)
    return {
        "room": statement(
            bool(width - 2 * R > 0) and edge == 0,
            shown="the strip 0 < s < w is wider than the disk",
            witness=f"the strip has the width {width}, the disk the diameter 2R",
        ),
        "injective": statement(
            bool(rise.is_positive) and bool(outwards.is_positive),
            shown="no double points",
            witness=f"k turns lift the point by {rise}, and its distance from the axis has the "
            f"rate {outwards} in x: two points of the disk coincide",
        ),
    }


def dini_metric(setting: Setting) -> Evidence:
    """Metric of Dini's surface against ds^2 + cosh^2(s) d tau^2, tau = b (u + a function of x)."""
    a, b = dini.radius_and_pitch(dini.WIDTH)
    metric = first_form(dini.point(a, b), (dini.U, dini.X))
    cosh_squared = 1 + dini.sinh_distance(dini.WIDTH) ** 2
    across = metric[0, 0] * dini.squared_distance_rate(dini.WIDTH)
    return identities(
        setting,
        {
            "E - b^2 cosh^2 s": metric[0, 0] - b**2 * cosh_squared,
            "det - E (ds/dx)^2": metric.det() - across,
            "d/du": [sp.expand(sp.diff(entry, dini.U)) for entry in metric],
        },
        shown="Dini's surface has the metric of a strip of H^2 along a geodesic",
    )


def complete_is_unbounded(setting: Setting, *, in_space: bool = True, power: int = 2) -> Evidence:
    """Complete surfaces of negative curvature: those that are bounded are closed (Hopf and Rinow).

    in_space: whether only surfaces in R^3 count, of which none is closed; H^2 is unbounded.
    """
    factor = 4 / (1 - hyperbolic_plane.X**2 - hyperbolic_plane.Y**2) ** power
    pole = hyperbolic_plane.boundary_pole(factor)
    parts = {
        "disk": statement(
            pole >= 2, shown="infinite radii", witness="the radii of the disk have finite length"
        )
    }
    if in_space:
        parts["closed surfaces in R^3"] = _farthest_point_is_convex()
    else:
        parts["octagon"] = closed_surface_exists(setting)
        corners = closed_surface.corner_count(GENUS)
        bound = 2 * sp.acosh(closed_surface.cosh_circumradius(corners))
        parts["closed surface"] = statement(
            bool(bound == sp.oo),
            shown="",
            witness="a closed surface of genus 2 and curvature -1 is complete, and its diameter "
            f"is at most 2 arcosh(3 + 2 sqrt 2) = {sp.N(bound, 5)}",
        )
    return combined(
        parts,
        shown="H^2 is unbounded, and no closed surface of R^3 has K < 0 at its point farthest from "
        "0, so that complete surfaces of R^3 with K < 0 are unbounded",
    )


def _farthest_point_is_convex() -> Evidence:
    distance = sp.Symbol("d", positive=True)
    excess = sp.symbols("a b", nonnegative=True)
    forced = closed_surface.curvature_at_farthest_point(distance, excess)
    return statement(
        bool(forced.is_positive), shown="", witness=f"K = {forced} may be negative there"
    )


def metric_extension(
    setting: Setting,
    *,
    simply_connected: bool = False,
    up_to_boundary: bool = False,
    stiffness: int = 4,
) -> Evidence:
    """Extend a metric with K < 0 from a bounded domain to the plane: outwards, and into a hole.

    Outwards, with the boundary's geodesic curvature at least -C: K <= 0 on a collar of width
    1/(2C), then K = -(stiffness C)^2 or below until J grows, then any K < 0, however small. The
    hole is that of the annulus |s| < 1 of a bobbin, along its throat. Without up_to_boundary the
    metric may grow at the boundary of the domain, as that of the Poincare disk does.
    """
    parts = _outer_collar(setting, stiffness)
    if not simply_connected:
        parts["hole"] = _filled_hole()
    if not up_to_boundary:
        pole = hyperbolic_plane.boundary_pole(hyperbolic_plane.disk_metric()[0, 0])
        parts["boundary"] = statement(
            pole < 2,
            shown="",
            witness="the Poincare metric on the unit disk: its factor has a pole of order "
            f"{pole} on the circle, so that the disk is complete and no metric of R^2 extends it",
        )
    return combined(
        parts,
        shown="across the outer boundary every metric with K < 0 extends: J stays positive while K "
        "is made as negative as -16 C^2, J grows from then on, and K may decay at will",
    )


def _outer_collar(setting: Setting, stiffness: int) -> dict[str, Evidence]:
    j = collar.stiff_solution(sp.Integer(stiffness))
    rate = stiffness * collar.BOUND
    start, slope = collar.worst_start()
    rising, falling = collar.exponential_coefficients(j, stiffness)
    # Where x = stiffness C t is log 2.
    growing = sp.simplify(sp.diff(j, collar.T).subs(collar.T, sp.log(2) / rate)).is_positive
    return {
        "equation": identities(
            setting,
            {
                "J'' - (stiffness C)^2 J": sp.diff(j, collar.T, 2) - rate**2 * j,
                "J at the start": j.subs(collar.T, 0) - start,
                "J' at the start": sp.diff(j, collar.T).subs(collar.T, 0) - slope,
            },
            shown="",
        ),
        "collar": statement(
            bool(rising > 0 and falling > 0) and bool(growing),
            shown="",
            witness=f"with K = -({stiffness} C)^2 the metric breaks down or keeps narrowing: J has "
            f"the coefficients {rising}, {falling} of exp(x), exp(-x), x = {stiffness} C t",
        ),
    }


def _filled_hole() -> Evidence:
    throat = collar.total_curvature_of_parallel(radius(), S, 0)
    needed = collar.curvature_of_filling(throat)
    return statement(
        bool(needed < 0),
        shown="",
        witness="the annulus |s| < 1 of Minding's bobbin with kappa = 2, whose throat is a "
        "closed geodesic: by Gauss-Bonnet a disk filling it has the total curvature "
        f"{needed} > 0",
    )
