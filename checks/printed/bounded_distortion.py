"""The normal map as a map of bounded distortion, as printed (section 3.3, lem:maximal, eq:BLD)."""

from typing import Any

import sympy as sp


def spherical_metric(cosine: Any, sigma: int, *, mixed: int = -1) -> tuple[Any, Any, Any]:
    """Coefficients of du^2, du dv (half) and dv^2 of the metric G of the normal."""
    return (1, mixed * sigma * cosine, 1)


def curvature_candidates(phi: Any, *, part: str = "1/2") -> tuple[Any, Any]:
    """Two numbers of which the larger is the larger principal curvature in absolute value."""
    half = sp.Rational(part) * phi
    return (sp.tan(half), sp.cot(half))


def angle_range(k_max: Any, *, factor: str = "2") -> tuple[Any, Any]:
    """Least and largest angle phi for curvatures up to k_max."""
    least = sp.Rational(factor) * sp.atan(1 / k_max)
    return (least, sp.pi - least)


def distortion(cosine: Any, *, power: int = 1) -> Any:
    """Lower bound of (eq:BLD) on sqrt(G/g), for |cos phi|; the upper one is its inverse."""
    return ((1 - cosine) / (1 + cosine)) ** power


def distortion_constant(k_max: Any, *, power: int = 2) -> Any:
    """Upper bound of (eq:BLD) by k_max; the lower one is its inverse."""
    return k_max**power


def eta(k_max: Any, *, share: str = "1/6") -> Any:
    """Bound on delta, pi/(6 k_max), in the proof of (lem:maximal)."""
    return sp.Rational(share) * sp.pi / k_max


def projected_normal(normal: sp.Matrix, centre: sp.Matrix, *, factor: int = 1) -> sp.Matrix:
    """Part of the normal at right angles to the normal at the centre."""
    return normal - factor * normal.dot(centre) * centre


def is_bounded_distortion(derivative: sp.Matrix, constant: Any, *, oriented: bool = True) -> bool:
    """Whether a linear map of the plane has the properties (i) and (ii) with this constant L."""
    squares = list((derivative.T * derivative).eigenvals())
    within = all(constant**-2 <= s <= constant**2 for s in squares)
    return bool(within and (derivative.det() > 0 or not oriented))
