"""Formulas of section 2 on the limit of vanishing thickness, as printed."""

from typing import Any

import sympy as sp


def rescaled_energy(
    energy: Any,
    h: Any,
    young: Any,
    *,
    prefactor: str = "24",
    thickness_power: int = -3,
    modulus_power: int = -1,
) -> Any:
    """Left side of (eqn:gammalimit), 24 h^-3 I / Y."""
    return sp.Rational(prefactor) * h**thickness_power * young**modulus_power * energy


def limit_density(kappa_1: Any, kappa_2: Any, *, second_sign: int = 1) -> Any:
    """Integrand of the limit energy E_2 in (eqn:gammalimit)."""
    return kappa_1**2 + second_sign * kappa_2**2
