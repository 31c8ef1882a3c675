"""Section 4.1: the Amsler surface with the angle pi/2, its singular edges and its disks."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed.amsler_disk import PANELS
from checks.verify.ball_bounds import Row, bounded
from checks.verify.initial_angles import fraction
from theory import amsler_balls, painleve, painleve_reference
from theory.amsler import PHI0, U, V, accelerations, edge_curvatures
from theory.asymptotic_net import general_net
from theory.vectors import added

_DIGITS = 25
#: Places at which phi - pi alternates in sign.
_PLACES = ("2", "9/2", "15/2", "21/2", "14", "17")


def right_angle() -> Any:
    """Ball of pi/2 at the precision in force."""
    return arb.pi() / 2


def edge_radius() -> Any:
    """Ball of the length of the mirror line from the crossing to the first singular edge."""
    place = painleve.crossing(right_angle, arb.pi, digits=_DIGITS + 5)
    return painleve.diagonal(right_angle, place.ball, digits=_DIGITS).ball()


def _half_pi() -> Any:
    return mp.pi / 2


def _reference_radius() -> Any:
    place = painleve_reference.crossing(_half_pi, lambda: +mp.pi, digits=30)
    found = painleve_reference.diagonal(_half_pi, Fraction(mp.nstr(place, 28)), digits=25)
    return arb(mp.nstr(found, 20))


def _shapes(setting: Setting) -> dict[str, Evidence]:
    """Exact parts: both bounds of the distance from the crossing, and from any point."""
    half, moved = amsler_balls.PHI / 2, amsler_balls
    square = sp.sin(half) ** 2 * (moved.DU - moved.DV) ** 2
    roots = (moved.ROOT_U - moved.ROOT_V) ** 2
    return {
        "shapes": identities(
            setting,
            {
                "ds^2 against dw": moved.length_excess() - square,
                "u + v against 2 sqrt(u v)": moved.sum_excess() - roots,
                "(u + t)(v + t)": moved.diagonal_excess() - moved.T * roots,
                "speed along the diagonal": moved.diagonal_speed_squared() - 4 * sp.cos(half) ** 2,
            },
            shown="both bounds are the integral of cos(phi/2) up to z*",
        )
    }


def smooth_disk(setting: Setting, *, radius: str = "1") -> Evidence:
    """Whether the disk of this radius about the crossing does not reach the singular edge."""
    return _against_edge(setting, radius, inside=True)


def smooth_disk_refused(setting: Setting, *, radius: str = "3/2") -> Evidence:
    """Whether the disks of this radius about every point of the surface reach the edge."""
    return _against_edge(setting, radius, inside=False)


def _against_edge(setting: Setting, radius: str, *, inside: bool) -> Evidence:
    """Radius against the least distance of the crossing from the edge, the greatest of all points.

    inside: whether the radius is claimed to be less.
    """

    def rows() -> Iterator[Row]:
        edge, size = edge_radius(), fraction(radius)
        yield "two routes to the edge", abs(edge - _reference_radius()), arb(10) ** -18
        if inside:
            yield "radius against the distance of the edge", size, edge
        else:
            yield "distance of the edge against the radius", edge, size

    found = bounded(rows(), shown="against 1.26620..., the distance of the edge")
    return combined(
        {**_shapes(setting), "radius": found},
        shown="the nearest points of the singular edge are at the distance 1.26620... from the "
        "crossing, on the mirror lines, and no point of the surface is farther from the edge",
    )


def singular_edges(setting: Setting, *, count: int = 3, level: str = "1") -> Evidence:
    """Changes of sign of phi - level pi on the mirror line: so many singular edges at least."""
    del setting

    def rows() -> Iterator[Row]:
        for k, place in enumerate(_PLACES[: count + 1]):
            value = painleve.angle(right_angle, Fraction(place), digits=15).ball()
            gap = value - fraction(level) * arb.pi()
            side = -gap if k % 2 else gap
            yield f"phi - {level} pi at z = {place}, of the wrong sign", side, arb(0)

    return bounded(
        rows(), shown=f"phi(z) crosses pi in each of {count} disjoint intervals of z up to "
        f"{_PLACES[count]}",
    )  # fmt: skip


def cuspidal(setting: Setting, *, rate: int = 1, direction: int = 1) -> Evidence:
    """Criterion of a cuspidal edge where phi = pi with phi_u + phi_v not 0, as 2 (u + v) F'/z is.

    There dr kills eta = (1, direction), the area density sin phi changes along it and N moves.
    rate: factor of the rate claimed.
    """
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        net = general_net(sigma)
        back = direction * sigma
        step = added(net.r_u, tuple(back * x for x in net.r_v))
        turn = added(net.d(net.normal, "u"), tuple(back * x for x in net.d(net.normal, "v")))
        at_pi = {net.cos_phi: -1, net.sin_phi: 0}
        dot = net.calculus.dot
        residuals[f"|dr(eta)|^2, {sigma}"] = sp.expand(dot(step, step)).subs(at_pi)
        residuals[f"|dN(eta)|^2, {sigma}"] = sp.simplify(dot(turn, turn)).subs(at_pi) - 4
        slope_u, slope_v = sp.symbols("phi_u phi_v", real=True)
        density = net.cos_phi * (slope_u + direction * slope_v)
        residuals[f"rate of sin phi, {sigma}"] = density.subs(at_pi) + rate * (
            slope_u + direction * slope_v
        )
    slope = sp.Symbol("F_z", positive=True)
    z = 2 * sp.sqrt(U * V)
    rates = [slope * sp.diff(z, w) for w in (U, V)]
    residuals["phi_u + phi_v"] = sp.simplify(sum(rates) - slope * (U + V) * 2 / z)
    return identities(
        setting,
        residuals,
        shown="at phi = pi, dr kills r_u + r_v's direction, |dN| is 2 along it and sin phi changes "
        "at the rate -(phi_u + phi_v) = -2 (u + v) F'/z; F' is not 0 there, or F would be pi "
        "everywhere",
    )


def axes(setting: Setting, *, on_axis: str = "constant") -> Evidence:
    """The u-axis and the v-axis are straight in R^3 and geodesics of the surface.

    on_axis: whether phi is `constant` on the axes, or any function.
    """
    w = sp.Function("w")(U, V)
    phi = PHI0 + (U * V * w if on_axis == "constant" else w)
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        r_uu, r_vv = accelerations(phi, sigma=sigma)
        bent_u, bent_v = edge_curvatures(phi, sigma=sigma)
        for name, value, place in (
            ("r_uu", list(r_uu), V), ("r_vv", list(r_vv), U),
            ("curvature of the u-axis", [bent_u], V), ("curvature of the v-axis", [bent_v], U),
        ):  # fmt: skip
            plain = [sp.expand(entry.doit()) for entry in value]
            residuals[f"{name}, sigma = {sigma}"] = [entry.subs(place, 0) for entry in plain]
    return identities(
        setting,
        residuals,
        shown="where phi is constant along an asymptotic line its acceleration in R^3 vanishes, "
        "and so does its geodesic curvature, which the metric determines",
    )


def panels(setting: Setting, *, caption: str = "as printed") -> Evidence:
    """Whether the caption of (fig:geodesicballs) says of its panels what the text says."""
    del setting
    said = dict(PANELS["caption"])
    if caption == "exchanged":
        said = {"a": said["b"], "b": said["a"]}
    return statement(
        said == PANELS["text"],
        shown="caption and text agree on the panels",
        witness=f"panel (a), labelled poincaregeodesics, shows by the caption: {said['a']}, by the "
        f"text: {PANELS['text']['a']}",
    )
