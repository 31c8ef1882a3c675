"""Minding's bobbin as a front and its normals, as printed (eq:bobbin_psfront, eq:NFront)."""

from typing import Any

import sympy as sp

Vector = tuple[Any, Any, Any]


def azimuth(u: Any, v: Any, kappa: Any, *, sense: int = 1, shift: int = 1) -> Any:
    """Azimuth theta on the front; sense +1 is printed (eq:bobbin_psfront, eq:NFront)."""
    return sense * kappa * (u - v) / sp.sqrt(kappa**2 + shift)


def front(rho: Any, z: Any, theta: Any) -> Vector:
    """Point of the front (eq:bobbin_psfront)."""
    return rho * sp.cos(theta), rho * sp.sin(theta), z


def normal_direction(
    s: Any, ds: Any, dz_ds: Any, theta: Any, kappa: Any, *, multiple: int = 1, height: int = 1
) -> Vector:
    """Vector along the normal, displayed before (eq:NFront); multiple +1 is printed."""
    return (
        -multiple * ds * dz_ds * sp.cos(theta),
        -multiple * ds * dz_ds * sp.sin(theta),
        multiple * height * ds * sp.sinh(s) / kappa,
    )


def normal_height(s: Any, kappa: Any, *, function: str = "sinh") -> Any:
    """Height N_z of the continuous normal (eq:NFront)."""
    return {"sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh}[function](s) / kappa


def normal(n_z: Any, theta: Any, sigma: Any, *, radial: int = -1, power: int = 2) -> Vector:
    """Continuous normal by its height (eq:NFront)."""
    root = radial * sigma * sp.sqrt(1 - n_z**power)
    return root * sp.cos(theta), root * sp.sin(theta), n_z
