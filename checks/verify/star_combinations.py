"""Combinations of two rays: the printed pairs of coordinates against the sectors (def:sectors)."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.printed import m_stars as printed
from checks.verify.m_stars import ETA, XI, components, gap, ray

LENGTH = sp.symbols("l_0:4", positive=True)
# Middle one of the four rays about which the angles are arbitrary.
RAY = 2


def pair_sectors(setting: Setting, *, shift: int = 0, sign: int = -1) -> Evidence:
    """Points of the pair i, i = 2, as points of two sectors with their ranges.

    shift: the sectors S_(i-1+shift), S_(i+shift) are stated; sign: of eta where eta < 0.
    """
    before, own = printed.pair_of_sectors(RAY, shift=shift)
    ahead = printed.pair_point(ray, RAY, XI, ETA, positive=True)
    back = printed.pair_point(ray, RAY, XI, -ETA, positive=False, sign=sign)
    residuals: dict[str, Any] = {
        "eta > 0": gap(ahead, printed.sector_point(ray, own, XI, ETA)),
        "eta < 0": gap(back, printed.sector_point(ray, before, ETA, XI)),
        "ranges of xi": [LENGTH[own - 1] - LENGTH[RAY], LENGTH[before] - LENGTH[RAY]],
        "ranges of eta": [
            LENGTH[own] - LENGTH[RAY + 1],
            LENGTH[before - 1] - LENGTH[RAY - 1],
        ],
    }
    return identities(
        setting,
        residuals,
        shown="for eta > 0 the point is that of the sector between s_i and s_(i+1) with c = xi, "
        "d = eta, for eta < 0 that of the sector before with c = -eta, d = xi, and the ranges are "
        "the same: the image is both interiors and their open common ray",
    )


def ray_coordinates(
    setting: Setting, *, parity: int = 0, along: str = "u", even: int = 0, ahead: int = 0
) -> Evidence:
    """Values of (u, v) on the ray of S_i and S_(i+1), arbitrary angles, i = 2 or 1 by parity.

    along: the coordinate said to run along the ray; even: parity of the rays called u-lines;
    ahead: added to the index of the ray.
    """
    t = sp.Symbol("t", positive=True)
    i = 2 - parity
    x = tuple(t * entry for entry in ray(i + ahead))
    wanted = (t, sp.Integer(0)) if along == "u" else (sp.Integer(0), t)
    residuals: dict[str, Any] = {}
    for sector in (i, i + 1):
        c, d = components((x[0], x[1], x[2]), ray(sector - 1), ray(sector))
        u, v = (d, c) if sector % 2 == even else (c, d)
        residuals[f"u on S_{sector}"] = u - wanted[0]
        residuals[f"v on S_{sector}"] = v - wanted[1]
    return identities(
        setting,
        residuals,
        shown="on the ray of S_i and S_(i+1) one coordinate vanishes and the other is the distance "
        "from the origin, whatever the angles, the same from both sectors",
    )


def odd_ray_coordinates(
    setting: Setting, *, parity: int = 1, along: str = "v", even: int = 0, ahead: int = 0
) -> Evidence:
    """Values of (u, v) on the ray of S_i and S_(i+1), i odd."""
    return ray_coordinates(setting, parity=parity, along=along, even=even, ahead=ahead)
