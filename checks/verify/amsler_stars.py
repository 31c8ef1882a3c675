"""Checks of the lemma (lem:m-star) on stars of Amsler sectors, by numbers and in balls."""

from collections.abc import Iterable
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.ball import enclosure
from checks.evidence import Evidence, Setting
from checks.exact import combined
from checks.printed import branched_sine_gordon as printed
from checks.verify.ball_bounds import bounded
from checks.verify.convergence import order as observed_order
from theory import amsler_star_area, chebyshev_sector, painleve

LEVELS = (4, 8, 16, 32)


_QUADRATURE_STARS = ((2, 5, 3, 4, 6, 4), (2, 3, 2, 3, 4, 4, 3, 3))


_LENGTHS = ("0.5", "0.9", "0.6", "0.8", "0.7", "0.4", "0.65", "0.75")


def _amsler_angle(twelfths: int, x: str) -> Any:
    """Certified angle between the curves of an Amsler sector at s t = x, as mpf."""
    found = painleve.angle(lambda: arb.pi() * twelfths / 12, lambda: 2 * arb(x).sqrt())
    return mp.mpf(found.decimal(15))


def star_by_quadrature(setting: Setting, *, regular: int = 2, percent: int = 100) -> Evidence:
    """(lem:m-star) on two stars of Amsler sectors: PIII at the corners, the midpoint rule inside.

    percent: of the area on the right side.
    """
    parts = {}
    for parts_of_pi in _QUADRATURE_STARS:
        size = len(parts_of_pi)
        rays = _LENGTHS[:size]
        left = mp.mpf(0)
        for j, k in enumerate(parts_of_pi):
            x = str(mp.mpf(rays[j]) * mp.mpf(rays[(j + 1) % size]))
            between = _amsler_angle(k, x)
            left += between if j % 2 == 0 else between - mp.pi
        angles = [float(mp.pi) * k / 12 for k in parts_of_pi]
        errors = []
        for cells in LEVELS:
            area = amsler_star_area.star_area(angles, [float(r) for r in rays], cells)
            errors.append(
                left - (mp.mpf(area) * percent / 100 + _concentration(size // 2, regular))
            )
        parts[f"m = {size // 2}"] = observed_order(
            [mp.mpf(1) / n for n in LEVELS], errors, 2, digits=12, shown=""
        )
    return combined(
        parts,
        shown="on stars of order 3 and 4 of unequal Amsler sectors both sides agree up to the "
        "error of the midpoint rule, of order 2 within 0.1",
    )


def _concentration(m: int, regular: int) -> Any:
    """Printed concentration at a point of order m, as mpf."""
    return mp.mpf(str(sp.N(printed.concentration(m, regular=regular), 30)))


NET_LEVELS = (16, 32, 64, 128)


_NET_LENGTH = 0.5


def corners_of_nets(setting: Setting, *, regular: int = 2, sign: int = 1) -> Evidence:
    """Corner angles less pi/2 over stars of Chebyshev nets in the hyperbolic plane, as h -> 0.

    The right side has its area by the midpoint rule with 128 cells a side. The corners alone have
    the sum over the boundary in the limit only; sign: of the corner terms.
    """
    parts = {}
    for parts_of_pi in _QUADRATURE_STARS:
        size = len(parts_of_pi)
        angles = [float(mp.pi) * k / 12 for k in parts_of_pi]
        area = amsler_star_area.star_area(angles, [_NET_LENGTH] * size, 128)
        right = mp.mpf(area) + _concentration(size // 2, regular)
        errors = []
        for cells in NET_LEVELS:
            corners = [chebyshev_sector.far_angle(a, _NET_LENGTH, cells) for a in angles]
            total = sum((mp.mpf(corner) - mp.pi / 2 for corner in corners), mp.mpf(0))
            errors.append(sign * total - right)
        parts[f"m = {size // 2}"] = observed_order(
            [mp.mpf(1) / n for n in NET_LEVELS], errors, 1, digits=10, shown=""
        )
    return combined(
        parts,
        shown="the sum of (corner angle - pi/2) over stars of nets tends to A - (m - 2) pi, to "
        "order 1 in the side of a quad within 0.1",
    )


def shrinking_stars(setting: Setting, *, regular: int = 2, percent: int = 100) -> Evidence:
    """Sum over stars of Amsler sectors of lengths eps = 2^-k, k to 8, in balls, against its limit.

    As 0 <= F - alpha <= s t, the area is eps^2 sum sin(alpha) up to m eps^4/2. percent: of the
    concentration.
    """

    def rows() -> Iterable[tuple[str, Any, Any]]:
        for parts_of_pi in ((4,) * 6, (2, 5, 3, 4, 6, 4), (3,) * 8, (6, 6, 6, 6)):
            m = len(parts_of_pi) // 2
            limit = enclosure(printed.concentration(m, regular=regular, percent=percent), {})
            sines = sum((arb.sin_pi_fmpq(_fraction(k)) for k in parts_of_pi), arb(0))
            for k in range(1, 9):
                total = arb(0)
                for j, part in enumerate(parts_of_pi):
                    between = _certified_angle(part, k)
                    total += between if j % 2 == 0 else between - arb.pi()
                eps2 = arb(1) / 4**k
                gap = abs(total - limit - eps2 * sines)
                yield f"m = {m}, eps = 2^-{k}", gap, m * eps2**2 / 2

    return bounded(
        rows(),
        sampled=True,
        shown="on stars of order 2 to 4, eps from 1/2 to 1/256, the sum is -(m - 2) pi + eps^2 "
        "times the sum of the sines of the sectors, up to m eps^4/2",
    )


def _fraction(twelfths: int) -> Any:
    from flint import fmpq

    return fmpq(twelfths, 12)


def _certified_angle(twelfths: int, k: int) -> Any:
    """Ball of F(4^-k), F(0) = pi twelfths/12."""
    place = arb(1) / 2 ** (k - 1)
    return painleve.angle(lambda: arb.pi() * twelfths / 12, place, digits=25).ball()
