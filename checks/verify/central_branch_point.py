"""Checks of the branch point of periodic Amsler surfaces, and of disks of half the radius."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from theory import equidistant_strip, star_saddle
from theory.amsler import PHI0, U, accelerations
from theory.asymptotic_net import general_net
from theory.vectors import scaled

_ORDERS = (3, 4, 5, 6)
_EDGE = (sp.pi / 3, sp.pi / 4, sp.pi / 5)


def _star_parts(angles: tuple[Any, ...], index: int) -> dict[str, Evidence]:
    """Index and finite second derivatives of the star of these angles."""
    name = f"star of {', '.join(map(str, angles))}"
    second = [star_saddle.hessian_jump(angles, i) for i in range(len(angles))]
    found = star_saddle.winding_number(angles)
    return {
        f"second derivatives, {name}": statement(
            all(bool(jump.is_finite) for jump in second), shown="bounded", witness=f"{second}"
        ),
        f"index, {name}": statement(
            found == index, shown=f"{index}", witness=f"{name}: the index is {found}, not {index}"
        ),
    }


def _any_star(setting: Setting) -> Evidence:
    """Two neighbouring sectors of any angles: no jump of the gradient; each turns it by a - pi."""
    pair = sp.symbols("a b", positive=True)
    turning = star_saddle.gradient_angle(pair, 1) - star_saddle.gradient_angle(pair, 0)
    m = sp.Symbol("m", positive=True)
    return identities(
        setting,
        {
            "gradient": star_saddle.gradient_jump(pair, 1),
            "turning, up to whole turns": turning - (pair[0] - sp.pi) - 2 * sp.pi,
            "2m sectors of pi/m": 2 * m * (sp.pi / m - sp.pi) / (2 * sp.pi) - (1 - m),
        },
        shown="the gradient is continuous, the index of 2m sectors is 1 - m",
    )


def _along_edge(setting: Setting, torsion: int) -> Evidence:
    """On an edge, phi = phi_0: it is straight, and the normal turns as its torsion alone says."""
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        r_uu, _ = accelerations(PHI0 + sp.Function("w")(U), sigma=sigma)
        fixed = [entry.subs(sp.Function("w")(U), 0).doit() for entry in r_uu]
        residuals[f"straight, sigma = {sigma:+d}"] = fixed
        net = general_net(sigma)
        turned = net.calculus.cross(net.normal, net.r_u)
        moved = net.d(net.normal, "u")
        residuals[f"normal, sigma = {sigma:+d}"] = [
            net.calculus.reduced(a - b)
            for a, b in zip(moved, scaled(sp.Integer(-torsion), turned), strict=True)
        ]
    return identities(setting, residuals, shown="one line, one normal on both sides")


def one_branch_point(
    setting: Setting, *, least_order: int = 3, inner: str = "supplementary", torsion: int = -1
) -> Evidence:
    """Index and smoothness at the origin, on the edges of the sectors and inside them.

    least_order: of the saddles at the origin; inner: `supplementary` angles phi, pi - phi on both
    sides of an edge, or `equal` thirds and sixths there; torsion: of the u-lines.
    """
    parts = {"any star": _any_star(setting)}
    for order in (least_order, *_ORDERS[1:]):
        angles = star_saddle.regular_star(order)
        parts |= _star_parts(angles, 1 - order)
        parts[f"branch point, order {order}"] = statement(
            star_saddle.winding_number(angles) < -1,
            shown="index below -1",
            witness=f"for order {order} the index at the origin is -1: no branch point",
        )
    for angle in _EDGE:
        if inner == "supplementary":
            edge: tuple[Any, ...] = (angle, sp.pi - angle, sp.pi - angle, angle)
        else:
            edge = (sp.pi / 3,) * 6
        smooth = (angle, sp.pi - angle, angle, sp.pi - angle)
        parts |= _star_parts(edge, -1) | _star_parts(smooth, -1)
        kinks = [star_saddle.hessian_jump(smooth, i) for i in range(4)]
        parts[f"inside, {angle}"] = statement(
            kinks == [0] * 4, shown="second derivatives continuous", witness=f"jumps {kinks}"
        )
    parts["edges"] = _along_edge(setting, torsion)
    return combined(
        parts,
        shown="index 1 - m < -1 at the origin for m = 3 to 6; at the points of an edge, where the "
        "angles are phi_0, pi - phi_0, pi - phi_0, phi_0, and inside the sectors the index is -1; "
        "the gradient is continuous, second derivatives jump by finite amounts across the edges, "
        "and the edge and its normal are the same seen from both sides",
    )


def half_radius(setting: Setting, *, share: str = "1/2", closed: bool = False) -> Evidence:
    """Disk of radius share R whose centre is at the distance R/2 from the branch point, in H^2.

    It must lie within the disk of radius R and miss its centre, as an open or a closed disk.
    """
    radius, turn = sp.symbols("R omega", positive=True)
    inner = equidistant_strip.minkowski
    origin = equidistant_strip.point(0, 0)
    shift, size = radius / 2, sp.Rational(share) * radius
    centre = equidistant_strip.geodesic(0, 0, 0, shift)
    onward = equidistant_strip.direction(shift, 0, turn)
    rim = tuple(sp.cosh(size) * c + sp.sinh(size) * d for c, d in zip(centre, onward, strict=True))
    away = -inner(origin, (rim[0], rim[1], rim[2]))
    room = sp.sinh(shift) * sp.sinh(size)
    shown = (
        "the rim of the disk is at distances from |R/2 - r| to R/2 + r from the branch point: for "
        "r = R/2 from 0 to R; an open disk of radius r in the disk has its centre within R - r of "
        "the branch point, so that r > R/2 would contain it"
    )
    fits = sp.Rational(share) <= sp.Rational(1, 2)
    misses = sp.Rational(share) < sp.Rational(1, 2) if closed else fits
    return combined(
        {
            "farthest": identities(
                setting,
                {"R/2 + r": sp.cosh(shift + size) - away - room * (1 - sp.cos(turn))},
                shown=shown,
            ),
            "nearest": identities(
                setting,
                {"R/2 - r": away - sp.cosh(shift - size) - room * (1 + sp.cos(turn))},
                shown=shown,
            ),
            "inside": statement(
                bool(fits), shown=shown, witness=f"the point opposite is at {share} R + R/2 > R"
            ),
            "free of the branch point": statement(
                bool(misses),
                shown=shown,
                witness=f"the branch point is at R/2 <= {share} R from the centre",
            ),
        },
        shown=shown,
    )


def sharp(setting: Setting, *, share: str = "51/100") -> Evidence:
    """Whether every open disk of radius share R in the disk of radius R contains its centre."""
    del setting
    part = sp.Rational(share)
    return statement(
        bool(1 - part < part),
        shown=f"its centre is within {1 - part} R < {part} R of the branch point",
        witness=f"centred at {1 - part} R it lies in the disk and misses the branch point",
    )


def straddles(setting: Setting, *, distance: str = "1") -> Evidence:
    """Edges that the disk of radius R/2 meets, centred at distance (R/2) from the branch point.

    On the ray at the angle w to its axis the nearest point to the disk's centre obeys sinh d =
    sinh(D) sin w, D the distance of the centre: d < R/2 for every w < pi/2 if D = R/2.
    """
    radius, turn = sp.symbols("R omega", positive=True)
    depth = sp.Rational(distance) * radius / 2
    centre = equidistant_strip.geodesic(0, 0, turn, depth)
    away = centre[1]
    shown = (
        "the disk of radius R/2 that touches the branch point subtends the angle pi there: it "
        "meets at least m - 1 >= 2 of the 2m edges, across which second derivatives jump"
    )
    return combined(
        {
            "distance": identities(
                setting, {"sinh d": away - sp.sinh(depth) * sp.sin(turn)}, shown=shown
            ),
            "all rays of a half-plane": statement(
                bool(sp.Rational(distance) <= 1),
                shown=shown,
                witness=f"with its centre at {distance} R/2 the disk subtends less than pi",
            ),
        },
        shown=shown,
    )
