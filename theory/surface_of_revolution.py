"""Surfaces of revolution about the z-axis, from the derivatives of a unit-speed meridian.

The point at arc length s and azimuth theta is (rho cos theta, rho sin theta, z), where rho(s) > 0
and rho_s^2 + z_s^2 = 1; s and theta are orthogonal, and lines of curvature.
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp

from theory.vectors import Vector, cross, dot, scaled

Form = tuple[Any, Any, Any]


@dataclass(frozen=True, kw_only=True)
class Meridian:
    """Radius and height of a unit-speed meridian with their derivatives at one arc length."""

    rho: Any
    rho_s: Any
    rho_ss: Any
    z_s: Any
    z_ss: Any


def meridian(rho: Any, s: sp.Symbol) -> Meridian:
    """Unit-speed meridian that climbs (z_s >= 0), of radius rho(s); real where |rho_s| <= 1."""
    rho_s = sp.diff(rho, s)
    z_s = sp.sqrt(1 - rho_s**2)
    return Meridian(rho=rho, rho_s=rho_s, rho_ss=sp.diff(rho_s, s), z_s=z_s, z_ss=sp.diff(z_s, s))


def generic_meridian() -> Meridian:
    """Climbing unit-speed meridian whose rho > 0, rho_s and rho_ss are free symbols."""
    rho = sp.Symbol("rho", positive=True)
    rho_s, rho_ss = sp.symbols("rho_s rho_ss", real=True)
    z_s = sp.sqrt(1 - rho_s**2)
    return Meridian(rho=rho, rho_s=rho_s, rho_ss=rho_ss, z_s=z_s, z_ss=-rho_s * rho_ss / z_s)


def rotated(rho: Any, z: Any, theta: Any) -> Vector:
    """Vector of radial component rho and height z in the half-plane of azimuth theta."""
    return (rho * sp.cos(theta), rho * sp.sin(theta), z)


def tangents(curve: Meridian, theta: Any) -> tuple[Vector, Vector]:
    """Tangent vectors r_s and r_theta."""
    r_theta = (-curve.rho * sp.sin(theta), curve.rho * sp.cos(theta), sp.Integer(0))
    return rotated(curve.rho_s, curve.z_s, theta), r_theta


def second_derivatives(curve: Meridian, theta: Any) -> tuple[Vector, Vector, Vector]:
    """Second derivatives r_ss, r_s_theta and r_theta_theta."""
    r_s_theta = (-curve.rho_s * sp.sin(theta), curve.rho_s * sp.cos(theta), sp.Integer(0))
    return (
        rotated(curve.rho_ss, curve.z_ss, theta),
        r_s_theta,
        rotated(-curve.rho, sp.Integer(0), theta),
    )


def first_form(curve: Meridian, theta: Any) -> Form:
    """Coefficients E, F, G of the induced metric in the coordinates (s, theta)."""
    r_s, r_theta = tangents(curve, theta)
    return dot(r_s, r_s), dot(r_s, r_theta), dot(r_theta, r_theta)


def unit_normal(curve: Meridian, theta: Any) -> Vector:
    """Vector r_s x r_theta / rho, a unit normal; it points to the axis if z_s > 0."""
    return scaled(1 / curve.rho, cross(*tangents(curve, theta)))


def second_form(curve: Meridian, theta: Any) -> Form:
    """Coefficients e, f, g of the second fundamental form d^2 r . N in (s, theta)."""
    normal = unit_normal(curve, theta)
    e, f, g = (dot(vector, normal) for vector in second_derivatives(curve, theta))
    return e, f, g


def gauss_curvature(curve: Meridian, theta: Any) -> Any:
    """Gauss curvature, by the determinants of the two forms."""
    (first_e, first_f, first_g) = first_form(curve, theta)
    (e, f, g) = second_form(curve, theta)
    return (e * g - f**2) / (first_e * first_g - first_f**2)


def principal_curvatures(curve: Meridian, theta: Any) -> tuple[Any, Any]:
    """Principal curvatures: of the meridian (longitudinal) and of the parallel (azimuthal)."""
    first, second = first_form(curve, theta), second_form(curve, theta)
    return second[0] / first[0], second[2] / first[2]


def asymptotic_rates(curve: Meridian, theta: Any) -> tuple[Any, Any]:
    """Squares of ds/dl and d theta/dl along an asymptotic line of arc length l; needs K < 0."""
    first, second = first_form(curve, theta), second_form(curve, theta)
    slope = -second[0] / second[2]
    ds_dl = 1 / (first[0] + first[2] * slope)
    return ds_dl, slope * ds_dl


def curvature_of_parallel(curve: Meridian, theta: sp.Symbol) -> Any:
    """Square of the curvature in R^3 of the circle s = const, by |r' x r''|^2 / |r'|^6."""
    _, velocity = tangents(curve, theta)
    acceleration = second_derivatives(curve, theta)[2]
    binormal = cross(velocity, acceleration)
    return dot(binormal, binormal) / dot(velocity, velocity) ** 3
