"""The corner of the L-shaped cut of an Amsler sector (lem:amsler_recursion), from its contour.

On an Amsler sector phi depends on z = 2 sqrt(u v) alone. The L-shaped region with corner (u*, v*)
reaches the values z = 2 sqrt(u* v_max) and z = 2 sqrt(u_max v*) at its ends; X is the value there.
"""

from typing import Any

import sympy as sp


def corner(x: Any, u_max: Any, v_max: Any) -> tuple[Any, Any]:
    """Coordinates (u*, v*) for which both ends of the region lie on z = X > 0."""
    u, v = sp.symbols("u v", positive=True)
    (first,) = sp.solve(sp.Eq(4 * u * v_max, x**2), u)
    (second,) = sp.solve(sp.Eq(4 * u_max * v, x**2), v)
    return first, second


def corner_value(x: Any, u_max: Any, v_max: Any) -> Any:
    """Value 2 sqrt(u* v*) of z at the corner, zeta_n in the lemma."""
    u, v = corner(x, u_max, v_max)
    return sp.powdenest(2 * sp.sqrt(u * v), force=True)
