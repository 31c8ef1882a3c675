r"""Local series of the sectors that surgery inserts at a point with tangent plane N = e_3.

A sector is given by the two asymptotic lines on its edges, each by its direction at the point and
the Taylor coefficients of its geodesic curvature. Directions are at the angle 0 and at +omega or
-omega, with cos omega = C0, sin omega = S0 the symbols of theory.amsler. All is exact.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from theory.amsler import C0, S0, U, V
from theory.moutard import ZERO, Series, goursat_series
from theory.vectors import Vector, added, cross, dot, scaled

HALF = sp.Symbol("t", positive=True)
NORMAL: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(1))


@dataclass(frozen=True, kw_only=True)
class Line:
    """Asymptotic line from the point: unit direction, Taylor coefficients of its curvature."""

    direction: Vector
    curvatures: tuple[Any, ...] = ()


def frames(line: Line, *, torsion: int, order: int) -> list[sp.Matrix]:
    """Taylor coefficients of the frame (T, N x T, N) along a line, by Frenet-Serret."""
    start = sp.Matrix([line.direction, cross(NORMAL, line.direction), NORMAL])
    twist = sp.Matrix([[0, 0, 0], [0, 0, torsion], [0, -torsion, 0]])
    bend = sp.Matrix([[0, 1, 0], [-1, 0, 0], [0, 0, 0]])
    found = [start]
    for n in range(order):
        rate = twist * found[n]
        for k, curvature in enumerate(line.curvatures[: n + 1]):
            rate += curvature * bend * found[n - k]
        found.append((rate / (n + 1)).applyfunc(sp.expand))
    return found


def _row(frame: sp.Matrix, i: int) -> Vector:
    return (frame[i, 0], frame[i, 1], frame[i, 2])


def normals(line: Line, *, torsion: int, order: int) -> list[Vector]:
    """Taylor coefficients of N along a line."""
    return [_row(frame, 2) for frame in frames(line, torsion=torsion, order=order)]


def places(line: Line, *, torsion: int, order: int) -> list[Vector]:
    """Taylor coefficients of r along a line that starts in the origin: the integral of T."""
    tangents = [_row(frame, 0) for frame in frames(line, torsion=torsion, order=order - 1)]
    return [ZERO] + [scaled(sp.Rational(1, n + 1), a) for n, a in enumerate(tangents)]


def sector_normal(on_u: Line, on_v: Line, *, order: int) -> Series:
    """Taylor coefficients of N on the sector, of this order in u and in v."""
    return goursat_series(
        normals(on_u, torsion=-1, order=order), normals(on_v, torsion=1, order=order)
    )


def _product(a: Mapping[tuple[int, int], Any], b: Series, i: int, j: int, times: Any) -> Any:
    """Coefficient of u^i v^j in the product of two series."""
    terms = [times(a[k, m], b[i - k, j - m]) for k in range(i + 1) for m in range(j + 1)]
    total = terms[0]
    for term in terms[1:]:
        total = added(total, term) if isinstance(term, tuple) else total + term
    return total


def rate(series: Series, along: str) -> Series:
    """Derivative of a series along "u" or "v", of one order less there."""
    step = (1, 0) if along == "u" else (0, 1)
    return {
        (i - step[0], j - step[1]): scaled((i, j)[step[1]], a)
        for (i, j), a in series.items()
        if (i, j)[step[1]] > 0
    }


def front_rates(normal: Series, *, order: int, sign_v: int = -1) -> tuple[Series, Series]:
    """Taylor coefficients of r_u = N_u x N and r_v = sign_v N_v x N, of order below `order`."""
    n_u, n_v = rate(normal, "u"), rate(normal, "v")
    indices = [(i, j) for i in range(order) for j in range(order)]
    r_u = {(i, j): _product(n_u, normal, i, j, cross) for i, j in indices}
    r_v = {(i, j): scaled(sign_v, _product(n_v, normal, i, j, cross)) for i, j in indices}
    return r_u, r_v


def products(a: Series, b: Series, *, order: int) -> dict[tuple[int, int], Any]:
    """Taylor coefficients of the inner product, of order below `order`."""
    return {(i, j): _product(a, b, i, j, dot) for i in range(order) for j in range(order)}


def edge_places(rates: Series, along: str, start: Vector, *, order: int) -> list[Vector]:
    """Taylor coefficients of r on the edge v = 0 (along "u") or u = 0 (along "v")."""
    keys = [(n, 0) if along == "u" else (0, n) for n in range(order)]
    return [start] + [scaled(sp.Rational(1, n + 1), rates[key]) for n, key in enumerate(keys)]


def angle_cosine(kappa_u: Sequence[Any], kappa_v: Sequence[Any], *, order: int) -> Any:
    """Taylor polynomial of cos omega, omega_uv = sin omega, from the curvatures of the axes.

    omega is the angle from r_u to r_v counter-clockwise: omega_u = -kappa_u, omega_v = kappa_v.
    """
    on_u = -sum(k * U ** (n + 1) / (n + 1) for n, k in enumerate(kappa_u))
    on_v = sum(k * V ** (n + 1) / (n + 1) for n, k in enumerate(kappa_v))
    psi = _picard(on_u + on_v, order)
    cosine, sine, power = sp.Integer(1), sp.Integer(0), sp.Integer(1)
    for n in range(1, 2 * order + 1):
        power = _truncated(sp.expand(power * psi) / n, order)
        if n % 2:
            sine += (-1) ** (n // 2) * power
        else:
            cosine += (-1) ** (n // 2) * power
    return sp.expand(C0 * cosine - S0 * sine)


def _picard(data: Any, order: int) -> Any:
    """Picard iterates of omega - omega_0 = data + integral of sin omega, to the degree kept.

    theory.amsler has the same problem for numerical data; these hold symbols.
    """
    psi = data
    for _ in range(order):
        sine, power = S0, sp.Integer(1)
        for n in range(1, 2 * order + 1):
            power = _truncated(sp.expand(power * psi) / n, order)
            sine += (S0, C0, -S0, -C0)[n % 4] * power
        psi = _truncated(data + sp.expand(sp.integrate(sp.expand(sine), U, V)), order)
    return psi


def _truncated(expr: Any, order: int) -> Any:
    poly = sp.Poly(sp.expand(expr), U, V)
    return sum(
        (c * U**i * V**j for (i, j), c in poly.terms() if i <= order and j <= order), sp.Integer(0)
    )


def coefficient(expr: Any, i: int, j: int) -> Any:
    """Coefficient of u^i v^j of a polynomial."""
    return sp.expand(expr).coeff(U, i).coeff(V, j)


def on_circle(expr: Any) -> Any:
    """Replace C0, S0 by the cosine and sine of 2 atan t, the half-angle being a free symbol."""
    square = HALF**2
    return sp.sympify(expr).subs({C0: (1 - square) / (1 + square), S0: 2 * HALF / (1 + square)})
