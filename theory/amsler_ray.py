r"""Geodesic rays from the apex of an Amsler sector, as a system of the first order.

A unit-speed ray at the angles a to r_u and b = phi - a from it to r_v has

    u' = sin b/sin phi,  v' = sin a/sin phi,  a' = phi_u u',  b' = phi_v v',

phi = F(2 sqrt(u v)), phi_u = 2 v F'(z)/z, phi_v = 2 u F'(z)/z. Angles in radians, sigma = +1.
"""

from typing import Any

import sympy as sp

from theory.amsler import U, V, accelerations

A, B = sp.symbols("a b", positive=True)
RATE = sp.Symbol("F_z", positive=True)
"""Slope F'(z) > 0."""

PHI = sp.Function("phi", positive=True)(U, V)


def velocity() -> tuple[Any, Any]:
    """Rates u', v' of the ray at the angles A, B, with phi = A + B."""
    return sp.sin(B) / sp.sin(A + B), sp.sin(A) / sp.sin(A + B)


def place() -> Any:
    """Similarity variable z = 2 sqrt(u v)."""
    return 2 * sp.sqrt(U * V)


def angle_slopes() -> tuple[Any, Any]:
    """Derivatives phi_u, phi_v of F(z), by the chain rule."""
    z = place()
    return RATE * sp.diff(z, U), RATE * sp.diff(z, V)


def rates(slope_u: Any, slope_v: Any) -> dict[sp.Symbol, Any]:
    """Rates of U, V, A, B along the ray where phi has these derivatives."""
    along_u, along_v = velocity()
    return {U: along_u, V: along_v, A: slope_u * along_u, B: slope_v * along_v}


def along(expr: Any, slope_u: Any, slope_v: Any) -> Any:
    """Rate of an expression of U, V, A, B along the ray."""
    moved = rates(slope_u, slope_v)
    return sum((sp.diff(expr, x) * rate for x, rate in moved.items()), sp.Integer(0))


def geodesic_defects() -> tuple[Any, Any]:
    """Tangential acceleration of the ray along r_u and along r_v; 0 on a geodesic."""
    slope_u, slope_v = sp.symbols("phi_u phi_v", real=True)
    r_uu, r_vv = accelerations(PHI, sigma=1)
    known = {sp.diff(PHI, U): slope_u, sp.diff(PHI, V): slope_v}
    along_u, along_v = velocity()
    found = []
    for i, rate in enumerate((along_u, along_v)):
        bent = (r_uu[i] * along_u**2 + r_vv[i] * along_v**2).subs(known).subs(PHI, A + B)
        found.append(along(rate, slope_u, slope_v) + bent)
    return found[0], found[1]


def unit_normal() -> tuple[Any, Any]:
    """Components along r_u, r_v of the unit vector normal to the ray, to its left."""
    return -sp.cos(B) / sp.sin(A + B), sp.cos(A) / sp.sin(A + B)
