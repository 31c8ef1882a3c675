"""Extending a metric of negative curvature across the boundary of a domain, and into a hole.

Fermi coordinates (s, t) along the boundary: t >= 0 the distance outwards, g = dt^2 + J^2 ds^2 with
J_tt = -K J, J = 1 at the boundary and J_t = k there, the geodesic curvature of the boundary seen
from the domain. The metric extends to all t >= 0 as long as J > 0.
"""

from typing import Any

import sympy as sp

T = sp.Symbol("t", real=True)
BOUND = sp.Symbol("C", positive=True)


def width_before_stiffening() -> Any:
    """Width 1/(2C) of the part of the collar left for K to become as negative as is wanted.

    There K <= 0, so that J_t never falls below its start, -C at worst, and J stays above 1/2.
    """
    return 1 / (2 * BOUND)


def worst_start() -> tuple[Any, Any]:
    """Least J and J_t at the end of that part, for a boundary of geodesic curvature >= -C."""
    return 1 - BOUND * width_before_stiffening(), -BOUND


def stiff_solution(stiffness: Any) -> Any:
    """Solution J of J_tt = (stiffness C)^2 J from the worst start; where K is less, J is larger."""
    start, slope = worst_start()
    rate = stiffness * BOUND
    return start * sp.cosh(rate * T) + slope / rate * sp.sinh(rate * T)


def exponential_coefficients(j: Any, stiffness: Any) -> tuple[Any, Any]:
    """Coefficients of exp(x) and exp(-x) in J, where x = stiffness C t."""
    e = sp.Symbol("e", positive=True)
    expr = sp.expand(j.rewrite(sp.exp).subs(T, sp.log(e) / (stiffness * BOUND)))
    expr = sp.expand(sp.simplify(expr))
    return expr.coeff(e, 1), expr.coeff(e, -1)


def curvature_of_filling(total_geodesic_curvature: Any) -> Any:
    """Integral of K over a disk, from the geodesic curvature of its boundary (Gauss-Bonnet).

    The boundary is seen from the disk: the circle of the flat disk has the total 2 pi.
    """
    return 2 * sp.pi - total_geodesic_curvature


def total_curvature_of_parallel(radius: Any, s: sp.Symbol, at: Any) -> Any:
    """Integral of the geodesic curvature of the circle s = at in ds^2 + radius(s)^2 d theta^2."""
    return 2 * sp.pi * sp.diff(radius, s).subs(s, at)
