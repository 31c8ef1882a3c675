"""Amsler sectors, as printed at the end of section 3.1 (def:amsler-sector, PIII)."""

from typing import Any

import sympy as sp


def is_amsler_sector(curvatures: tuple[Any, Any], *, straight_edges: int = 2) -> bool:
    """Definition def:amsler-sector, first sentence: the bounding curves are geodesics of R^3.

    curvatures: those in R^3 of the u-curve and of the v-curve that bound the sector.
    """
    return [curvature == 0 for curvature in curvatures].count(True) >= straight_edges


def is_pseudo_amsler_sector(curvatures: tuple[Any, Any], *, straight_edges: int = 1) -> bool:
    """Definition def:amsler-sector, second sentence: one of the bounding curves is a geodesic."""
    return [curvature == 0 for curvature in curvatures].count(True) >= straight_edges


def boundary_data(phi_0: Any, u: Any, v: Any, *, tilt_u: int = 0, tilt_v: int = 0) -> Any:
    """Sum of both boundary values phi(u, 0) = phi(0, v) = phi_0, the corner counted once."""
    return phi_0 + tilt_u * u + tilt_v * v


def sine_gordon(phi: Any, *, sign: int = 1) -> Any:
    """Value of phi_uv: the equation solved on the first quadrant."""
    return sign * sp.sin(phi)


def similarity_variable(
    u: Any, v: Any, *, scale: int = 2, power_v: int = 1, combination: str = "product"
) -> Any:
    """Variable z = 2 sqrt(u v) of the self-similar reduction."""
    inside = u * v**power_v if combination == "product" else u + v**power_v
    return scale * sp.sqrt(inside)


def mixed_operator(f: Any, z: Any, *, first: int = 1, second: int = 1) -> Any:
    """Operator d_uv on functions of z: f_z / z + f_zz."""
    return first * sp.diff(f, z) / z + second * sp.diff(f, z, 2)


def painleve(f: Any, df: Any, ddf: Any, z: Any, *, damping: int = 1, sine: int = -1) -> Any:
    """Left side of PIII: phi'' + phi'/z - sin phi; df, ddf: the derivatives of f."""
    return ddf + damping * df / z + sine * sp.sin(f)


def edge_curvature(phi: Any, u: Any, v: Any, *, along: str = "u", sign: int = 1) -> Any:
    """Curvature of the curve u = 0 of an Amsler sector: it is written kappa^u = d_u phi."""
    return sign * sp.diff(phi, u if along == "u" else v)
