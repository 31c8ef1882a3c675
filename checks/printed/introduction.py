"""Formulas of the abstract and of the introduction, as printed there."""

from typing import Any

import sympy as sp


def sectors(order: int, *, per_order: int = 2) -> int:
    """Return the number of sectors at a point: 4 if it is regular, 2m > 4 if it is of order m."""
    return per_order * order


def sine_gordon(phi: Any, *, sign: int = 1, factor: int = 1) -> Any:
    """Value of phi_uv for a smooth pseudospherical surface: sin phi."""
    return sign * factor * sp.sin(phi)


def boundary_form(
    phi_u: Any, phi_v: Any, *, denominator: int = 2, sign_u: int = -1
) -> tuple[Any, Any]:
    """Coefficients of du and dv in the boundary integrand (phi_v dv - phi_u du)/2."""
    return sign_u * phi_u / denominator, phi_v / denominator


def area_integrand(phi: Any, *, sign: int = 1) -> Any:
    """Integrand of the double integral: sin phi."""
    return sign * sp.sin(phi)


def correction(order: Any, *, sign: int = -1, regular: int = 2) -> Any:
    """Contribution -pi (m - 2) of a branch point of order m to the right side."""
    return sign * sp.pi * (order - regular)


def charge(index: Any, *, reading: str = "excess") -> Any:
    """Topological charge m - 2 of a point, of which the correction is a sum times pi.

    J_p measures it: `excess` is -(1 + J_p); `index` would be J_p itself.
    """
    return index if reading == "index" else -(1 + index)


def objective(larger: Any, *, quantity: str = "mean", absolute: bool = True) -> Any:
    """Quantity |H| of the min-max problem, from the larger principal curvature, K = -1.

    quantity: `gauss` for |K| instead; absolute: without it H itself, for the normal where H < 0.
    """
    smaller = -1 / larger
    value = (larger + smaller) / 2 if quantity == "mean" else -larger * smaller
    return value if absolute else -value


def energy_growth(radius: Any, *, growth: str = "root") -> Any:
    """Growth of log inf E for branched immersions of a disk: sqrt(R); `linear` for R, as smooth."""
    return {"root": sp.sqrt(radius), "linear": radius, "square": radius**2}[growth]
