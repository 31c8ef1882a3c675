"""Formulas of section 2 on isometric immersions and their energies, as printed."""

from collections.abc import Sequence
from typing import Any

import sympy as sp


def max_curvature(kappa_1: Any, kappa_2: Any, *, absolute: bool = True) -> Any:
    """Max curvature E_infty at a point (after eqn:gammalimit)."""
    return sp.Max(abs(kappa_1), abs(kappa_2)) if absolute else sp.Max(kappa_1, kappa_2)


def willmore_bound(
    max_energy_squared: Any, area: Any, *, factor: str = "1", area_power: int = 0
) -> Any:
    """Bound of E_2 by the square of E_infty (after eqn:gammalimit), on a domain of this area."""
    return sp.Rational(factor) * area**area_power * max_energy_squared


def curvature_bounds(mean: Any, *, scale: str = "1", offset: str = "1") -> tuple[Any, Any]:
    """Lower and upper bound of the max curvature by |H| (displayed after eqn:gammalimit)."""
    return sp.Rational(scale) * 2 * mean, 2 * mean + sp.Rational(offset)


def max_mean_energy(mean: Any, *, factor: str = "2") -> Any:
    """Multiple of |H| that the max curvature is near (the display and the sentence after it)."""
    return sp.Rational(factor) * mean


def isometry_defect(
    metric: sp.Matrix, differential: sp.Matrix, v: sp.Matrix, w: sp.Matrix, *, factor: str = "1"
) -> sp.Expr:
    """Left minus right side of g(v, w) = <df v, df w> (first display of Nash-Kuiper)."""
    left = (v.T * metric * w)[0]
    return left - sp.Rational(factor) * ((differential * v).T * (differential * w))[0]


def distance(f: Sequence[Any], other: Sequence[Any]) -> sp.Expr:
    """Euclidean distance |f(x) - f_eps(x)| (second display of Nash-Kuiper)."""
    return sp.sqrt(sum((a - b) ** 2 for a, b in zip(f, other, strict=True)))
