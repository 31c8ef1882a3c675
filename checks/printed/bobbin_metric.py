"""Minding's bobbin, metric and curvature, as printed in section 3.1 (ex:bobbin, eq:c2energy)."""

from typing import Any

import sympy as sp


def radius(s: Any, kappa: Any, *, rate: int = 1) -> Any:
    """Radius of the bobbin at arc length s (ex:bobbin)."""
    return sp.cosh(rate * s) / kappa


def meridian_speed(rho_s: Any, z_s: Any, *, total: int = 1) -> Any:
    """Defect that vanishes when s is the arc length of the meridian (ex:bobbin)."""
    return z_s**2 + rho_s**2 - total


def throat_curvature(kappa: Any, *, factor: int = 1) -> Any:
    """Curvature of the equator s = 0 (ex:bobbin)."""
    return factor * kappa


def induced_metric(rho: Any, *, power: int = 2) -> tuple[Any, Any, Any]:
    """Coefficients of ds^2, 2 ds d theta, d theta^2 (ex:bobbin)."""
    return sp.Integer(1), sp.Integer(0), rho**power


def gauss_curvature(rho: Any, rho_ss: Any, *, sign: int = -1) -> Any:
    """Gauss curvature by the radius (ex:bobbin)."""
    return sign * rho_ss / rho


def edge(kappa: Any, *, inverse: str = "asinh") -> Any:
    """Arc length L at the singular edge (ex:bobbin)."""
    return {"asinh": sp.asinh, "acosh": sp.acosh, "atanh": sp.atanh}[inverse](kappa)


def largest_diameter(kappa: Any, *, factor: int = 2) -> Any:
    """Bound on the diameter of an embedded geodesic disk (after ex:bobbin)."""
    return factor * sp.asinh(kappa)


def longitudinal_curvature(
    s: Any, kappa: Any, *, numerator: str = "cosh", power: str = "-1/2"
) -> Any:
    """Curvature of the meridian (before eq:c2energy)."""
    top = {"cosh": sp.cosh, "sinh": sp.sinh}[numerator](s)
    return top * (kappa**2 - sp.sinh(s) ** 2) ** sp.Rational(power)


def c2_energies(
    kappa: Any, radius: Any, *, throat: str = "1", numerator: str = "cosh", power: str = "-1/2"
) -> tuple[Any, Any]:
    """Two entries of the maximum: at the throat and at distance R from it (eq:c2energy)."""
    top = {"cosh": sp.cosh, "sinh": sp.sinh}[numerator](radius)
    edge_term = top * (kappa**2 - sp.sinh(radius) ** 2) ** sp.Rational(power)
    return sp.Rational(throat) * kappa, edge_term
