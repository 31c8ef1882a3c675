r"""Sectors between two asymptotic lines with given geodesic curvatures, as power series.

The lines leave the corner at the angle alpha, v = 0 with the curvature kappa^u(u), u = 0 with
kappa^v(v); sigma is the sign of (r_u x r_v).N. The angle theta between r_u and r_v satisfies

    theta_uv = sin theta,  theta_u = -sigma kappa^u on v = 0,  theta_v = sigma kappa^v on u = 0

(theta is phi for sigma = 1, pi - phi for sigma = -1). The frame (r_u, N x r_u, N) is carried along
v = 0 by kappa^u, then along the v-lines by theta; the Frenet frame of the line u = 0 is not used.
Coefficients are polynomials in the symbols C, S (cosine and sine of alpha), K and H (Taylor
coefficients of kappa^u and kappa^v); series are cut at a total degree in (u, v).
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

U, V, C, S = sp.symbols("u v c s")
K = sp.symbols("k_0:4")
H = sp.symbols("h_0:4")
RING = PolyRing((U, V, C, S, *K, *H), sp.QQ)
_U, _V, _C, _S, *_MODULI = RING.gens

Series = Any
Frame = tuple[Series, Series, Series]


@dataclass(frozen=True, kw_only=True)
class SectorSeries:
    """Series of a sector whose corner frame is (e_u, e_3 x e_u, e_3), in that frame's components.

    sigma: orientation; order: total degree kept; theta_excess: theta - alpha; r_u, side, normal:
    triples of series; position: that of r, one degree more.
    """

    sigma: int
    order: int
    theta_excess: Series
    r_u: Frame
    side: Frame
    normal: Frame
    r_v: Frame
    position: Frame


def cut(p: Series, order: int) -> Series:
    """Terms up to a total degree in (u, v), with S^2 replaced by 1 - C^2."""
    terms: dict[tuple[int, ...], Any] = {}
    for m, c in p.terms():
        if m[0] + m[1] <= order:
            terms[m] = c
    kept = RING.from_dict(terms)
    if any(m[3] > 1 for m in terms):
        kept = kept.rem([_S**2 + _C**2 - 1])
    return kept


def product(p: Series, q: Series, order: int) -> Series:
    """Product up to a total degree in (u, v): only terms that survive are multiplied."""
    parts = _by_degree(q, order)
    total = RING.zero
    for i, first in enumerate(_by_degree(p, order)):
        if first:
            rest = sum(parts[: order + 1 - i], RING.zero)
            total += first * rest
    return cut(total, order)


def _by_degree(p: Series, order: int) -> list[Series]:
    """Homogeneous parts in (u, v) of the degrees 0, ..., order."""
    parts: list[dict[tuple[int, ...], Any]] = [{} for _ in range(order + 1)]
    for m, c in p.terms():
        if m[0] + m[1] <= order:
            parts[m[0] + m[1]][m] = c
    return [RING.from_dict(terms) for terms in parts]


def integral(p: Series, along: int) -> Series:
    """Integral from 0 along u (0) or v (1)."""
    out: dict[tuple[int, ...], Any] = {}
    for m, c in p.terms():
        power = list(m)
        power[along] += 1
        out[tuple(power)] = c / power[along]
    return RING.from_dict(out)


def slope(p: Series, along: int) -> Series:
    """Derivative along u (0) or v (1)."""
    return p.diff(RING.gens[along])


def curvature(moduli: tuple[Any, ...], along: int) -> Series:
    """Geodesic curvature of an edge, a polynomial in its arc length."""
    t = RING.gens[along]
    return sum((RING.from_expr(sp.sympify(k)) * t**n for n, k in enumerate(moduli)), RING.zero)


def sine_and_cosine(excess: Series, order: int) -> tuple[Series, Series]:
    """Sine and cosine of alpha + excess, excess(0, 0) = 0."""
    sine, cosine, power = RING.zero, RING.zero, RING.one
    for n in range(order + 1):
        sine += power * (_S, _C, -_S, -_C)[n % 4]
        cosine += power * (_C, -_S, -_C, _S)[n % 4]
        power = product(power, excess, order).mul_ground(sp.QQ(1, n + 1))
    return cut(sine, order), cut(cosine, order)


def angle_series(sigma: int, on_u: Series, on_v: Series, order: int) -> Series:
    """Series theta - alpha, by Picard iteration from the curvatures of the edges."""
    data = -sigma * integral(on_u, 0) + sigma * integral(on_v, 1)
    excess = cut(data, order)
    for _ in range(order // 2):
        sine, _ = sine_and_cosine(excess, order)
        excess = cut(data + integral(integral(sine, 0), 1), order)
    return excess


def _carried(start: list[Frame], rates: Any, along: int, order: int) -> list[Frame]:
    """Solve of a linear system d(frame) = A frame along one coordinate, by Picard iteration."""
    frame = start
    for _ in range(order):
        moved = []
        for row in range(3):
            entries = []
            for x in range(3):
                total = RING.zero
                for other in range(3):
                    if rates[row][other] != 0:
                        total += product(rates[row][other], frame[other][x], order)
                entries.append(cut(start[row][x] + integral(total, along), order))
            moved.append((entries[0], entries[1], entries[2]))
        if moved == frame:
            break
        frame = moved
    return frame


def sector_series(
    *, sigma: int, on_u: tuple[Any, ...], on_v: tuple[Any, ...], order: int
) -> SectorSeries:
    """Series of the sector; on_u, on_v: Taylor coefficients of the curvatures of its edges.

    >>> straight = sector_series(sigma=1, on_u=(), on_v=(), order=2)
    >>> straight.theta_excess
    u*v*s
    """
    kappa_u, kappa_v = curvature(on_u, 0), curvature(on_v, 1)
    excess = angle_series(sigma, kappa_u, kappa_v, order)
    sine, cosine = sine_and_cosine(excess, order)
    zero, one = RING.zero, RING.one
    corner: list[Frame] = [(one, zero, zero), (zero, one, zero), (zero, zero, one)]
    along_u = ((zero, kappa_u, zero), (-kappa_u, zero, -one), (zero, one, zero))
    edge = _carried(corner, along_u, 0, order)
    tilt = sigma * sine
    along_v = ((zero, zero, -tilt), (zero, zero, cosine), (tilt, -cosine, zero))
    r_u, side, normal = _carried(edge, along_v, 1, order)
    r_v = _combined(cosine, r_u, tilt, side, order)
    on_edge = tuple(integral(_on_axis(a), 0) for a in r_u)
    position = [a + integral(b, 1) for a, b in zip(on_edge, r_v, strict=True)]
    return SectorSeries(
        sigma=sigma,
        order=order,
        theta_excess=excess,
        r_u=r_u,
        side=side,
        normal=normal,
        r_v=r_v,
        position=(position[0], position[1], position[2]),
    )


def _combined(a: Series, first: Frame, b: Series, second: Frame, order: int) -> Frame:
    x, y, z = (
        product(a, p, order) + product(b, q, order) for p, q in zip(first, second, strict=True)
    )
    return (x, y, z)


def _on_axis(p: Series) -> Series:
    """Part of a series on v = 0."""
    return RING.from_dict({m: c for m, c in p.terms() if m[1] == 0})


def on_edge(p: Series, along: int) -> Series:
    """Part of a series on the edge where only u (0) or only v (1) differs from 0."""
    return RING.from_dict({m: c for m, c in p.terms() if m[1 - along] == 0})
