"""Formulas of section 2 on elastic energies, as printed."""

from typing import Any

import sympy as sp


def metric_defect(
    gradient: sp.Matrix, metric: sp.Matrix, *, metric_factor: str = "1", swapped: bool = False
) -> sp.Matrix:
    """Matrix whose squared norm is the density of (eqn:threedenergy); swapped: F F^T for F^T F."""
    gram = gradient * gradient.T if swapped else gradient.T * gradient
    return gram - sp.Rational(metric_factor) * metric


def squared_norm(defect: sp.Matrix, metric: sp.Matrix, *, norm: str = "metric") -> sp.Expr:
    """Squared norm in (eqn:threedenergy), read as that of 2-tensors in the metric.

    norm: `metric` raises both indices with the metric, `one index` only one of them, `entries`
    sums the squares of the components. Raises ValueError for another.
    """
    if norm == "entries":
        return (defect.T * defect).trace()
    if norm == "metric":
        return (metric.inv() * defect * metric.inv() * defect).trace()
    if norm == "one index":
        return (metric.inv() * defect * defect).trace()
    raise ValueError(f"expected entries, metric or one index, got {norm!r}")


def well_element(turn: sp.Matrix, root: sp.Matrix, *, order: str = "RA") -> sp.Matrix:
    """Element R A of the energy well (before eq:hyperelastic); order `AR` or `RAA` else."""
    return {"RA": turn * root, "AR": root * turn, "RAA": turn * root * root}[order]


def deviation(gradient: sp.Matrix, element: sp.Matrix) -> sp.Expr:
    """Squared distance of a gradient to one element of the well, minimised in (eq:hyperelastic)."""
    return sum(entry**2 for entry in gradient - element)


def plate_metric(g: sp.Matrix, *, across: str = "1", shear: str = "0") -> sp.Matrix:
    """Metric G of a plate (displayed before FvK): g, bordered by zeros and 1."""
    metric = sp.diag(g, sp.Rational(across))
    metric[0, 2] = metric[2, 0] = sp.Rational(shear)
    return metric


def displacement_exponents(
    *, in_plane: str = "1/2", out_of_plane: str = "1", length: str = "0"
) -> tuple[Any, Any, Any]:
    """Exponents of h in the displacements of a sheet (before FvK): in plane, out of plane.

    length: exponent of the length over which they vary, which is not printed.
    """
    return sp.Rational(in_plane), sp.Rational(out_of_plane), sp.Rational(length)


def fvk_energy(
    h: Any, stretching: Any, bending: Any, *, stretching_power: int = 1, bending_power: int = 3
) -> Any:
    """Energy (FvK) of a sheet of thickness h."""
    return h**stretching_power * stretching + h**bending_power * bending


def bending_density(mean: Any, gauss: Any, *, of_mean: str = "4", of_gauss: str = "-2") -> Any:
    """Integrand 4 H^2 - 2 K of the second term of (eqn:finitethicknessenergy)."""
    return sp.Rational(of_mean) * mean**2 + sp.Rational(of_gauss) * gauss


def finite_thickness_density(
    h: Any,
    young: Any,
    metric_defect_squared: Any,
    bending: Any,
    *,
    stretching_factor: str = "1/2",
    bending_factor: str = "1/24",
) -> Any:
    """Energy per area of (eqn:finitethicknessenergy), from |dy.dy - g|^2 and 4 H^2 - 2 K."""
    stretching = sp.Rational(stretching_factor) * young * h * metric_defect_squared
    return stretching + sp.Rational(bending_factor) * young * h**3 * bending


def mean_curvature(kappa_1: Any, kappa_2: Any, *, factor: str = "1/2") -> Any:
    """Mean curvature H (after eqn:finitethicknessenergy)."""
    return sp.Rational(factor) * (kappa_1 + kappa_2)


def gauss_curvature(kappa_1: Any, kappa_2: Any, *, sign: int = 1) -> Any:
    """Gauss curvature K (after eqn:finitethicknessenergy)."""
    return sign * kappa_1 * kappa_2
