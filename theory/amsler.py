"""Amsler surfaces: the sine-Gordon equation phi_uv = sin phi with phi = phi_0 on both axes.

The problem is unchanged by (u, v) -> (c u, v/c), so that phi = F(x), x = u v, where

    (x F')' = x F'' + F' = sin F,  F(0) = phi_0.

Coefficients are polynomials in the symbols S0 = sin phi_0 and C0 = cos phi_0. The corner angle and
the coordinates are positive symbols: 0 < phi_0 < pi, u, v > 0.
"""

from collections.abc import Sequence
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

from theory.curvature import christoffel

U, V = sp.symbols("u v", positive=True)
PHI0 = sp.Symbol("phi_0", positive=True)
S0, C0 = sp.symbols("s_0 c_0", real=True)


def similarity_coefficients(order: int) -> list[Any]:
    """Coefficients a_1, ..., a_order of F = phi_0 + sum a_k x^k.

    From k^2 a_k = [x^(k-1)] sin F, sine and cosine of F advanced by their own equations.
    """
    sine, cosine, a = [S0], [C0], [sp.Integer(0)]
    for k in range(1, order + 1):
        a.append(sp.expand(sine[k - 1] / k**2))
        sine.append(sp.expand(sum(j * a[j] * cosine[k - j] for j in range(1, k + 1)) / k))
        cosine.append(sp.expand(-sum(j * a[j] * sine[k - j] for j in range(1, k + 1)) / k))
    return a[1:]


def similarity_series(order: int, x: Any) -> Any:
    """Taylor polynomial of F - phi_0 of this order at x."""
    return sum(a * x ** (k + 1) for k, a in enumerate(similarity_coefficients(order)))


def goursat_series(order: int, on_u: Any = 0, on_v: Any = 0) -> Any:
    """Taylor polynomial of phi - phi_0, of degree order in u and in v, by Picard iteration.

    phi_uv = sin phi with phi = phi_0 + on_u(u) on the u-axis and phi_0 + on_v(v) on the v-axis;
    on_u, on_v: polynomials that vanish at 0. Nothing is assumed of the form of the solution.
    """
    ring = PolyRing((U, V, S0, C0), sp.QQ)
    data = ring.from_expr(sp.sympify(on_u) + sp.sympify(on_v))
    psi = data
    for _ in range(order):
        psi = _truncated(data + _integrated(_sine_of(psi, order)), order)
    return psi.as_expr()


def _sine_of(psi: Any, order: int) -> Any:
    """Sine of phi_0 + psi, up to the degrees that are kept."""
    _, _, sine, cosine = psi.ring.gens
    terms, power = sine, psi.ring.one
    for k in range(1, 2 * order + 1):
        power = _truncated((power * psi).mul_ground(sp.QQ(1, k)), order)
        terms += power * (sine, cosine, -sine, -cosine)[k % 4]
    return terms


def _integrated(p: Any) -> Any:
    """Integral over u and v from 0."""
    terms = {(i + 1, j + 1, a, b): c / ((i + 1) * (j + 1)) for (i, j, a, b), c in p.terms()}
    return p.ring.from_dict(terms)


def _truncated(p: Any, order: int) -> Any:
    return p.ring.from_dict({m: c for m, c in p.terms() if m[0] <= order and m[1] <= order})


def chebyshev_metric(phi: Any, *, sigma: int) -> sp.Matrix:
    """Metric of unit-speed asymptotic lines (U, V) at the angle phi, with orientation sigma."""
    mixed = sigma * sp.cos(phi)
    return sp.Matrix([[1, mixed], [mixed, 1]])


def accelerations(phi: Any, *, sigma: int) -> tuple[sp.Matrix, sp.Matrix]:
    """Tangential part of r_uu and of r_vv, as components along r_u, r_v (Christoffel symbols).

    There is no normal part, the lines being asymptotic: a line is straight in R^3 where it is 0.
    """
    gamma = christoffel(chebyshev_metric(phi, sigma=sigma), (U, V))
    return (
        sp.Matrix([gamma[k][0, 0] for k in range(2)]),
        sp.Matrix([gamma[k][1, 1] for k in range(2)]),
    )


def edge_curvatures(phi: Any, *, sigma: int) -> tuple[Any, Any]:
    """Geodesic curvatures of the u-lines and of the v-lines of the net with this angle phi(U, V).

    The acceleration of the line against its tangent, turned by +pi/2 in the orientation
    sigma du dv.
    """
    metric = chebyshev_metric(phi, sigma=sigma)
    tangents = (sp.Matrix([1, 0]), sp.Matrix([0, 1]))
    along_u, along_v = (
        _against_normal(metric, tangent, acceleration, sigma) / sp.sin(phi)
        for tangent, acceleration in zip(tangents, accelerations(phi, sigma=sigma), strict=True)
    )
    return along_u, along_v


def _against_normal(metric: sp.Matrix, tangent: Any, vector: Any, sigma: int) -> Any:
    """Product of the vector with the turned tangent, times sin phi = sqrt(det metric)."""
    covector = metric * tangent
    turned = sigma * sp.Matrix([-covector[1], covector[0]])
    return (turned.T * metric * vector)[0, 0]


def edge_of_regularity(phi_0: Any) -> tuple[Any, Any]:
    """Bounds below and above on the x = u v at which F first leaves (0, pi), for phi_0 in (0, pi).

    Below: 0 <= F - phi_0 <= x, as 0 <= sin F <= 1. Above: with m midway from phi_0 to pi and s the
    least sine on [phi_0, m], s <= F' <= 1 until F = m, so this is at an x in [m - phi_0,
    (m - phi_0)/s], and there x F' >= s (m - phi_0). From there on x F' grows, so that log x needs
    at most 1/s more to gain the remaining pi - m = m - phi_0.
    """
    middle = (sp.pi + phi_0) / 2
    sines: Sequence[Any] = (sp.sin(phi_0), sp.sin(middle))
    least = sp.Min(*sines)
    return sp.pi - phi_0, (middle - phi_0) / least * sp.exp(1 / least)
