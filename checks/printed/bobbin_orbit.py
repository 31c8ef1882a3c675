"""The asymptotic coordinates of Minding's bobbin as printed (eq:bobbin, eq:econs, eq:sg-soln)."""

from typing import Any

import sympy as sp

Pair = tuple[Any, Any]


def metric(du: Any, dv: Any, phi: Any, sigma: Any, *, factor: int = 2) -> Any:
    """Metric in asymptotic coordinates (displayed before eq:bobbin)."""
    return du**2 + factor * sigma * sp.cos(phi) * du * dv + dv**2


def metric_by_half_angles(
    du: Any, dv: Any, phi: Any, sigma: int, *, exchanged: bool = False
) -> Any:
    """Two cases of the metric for sigma = +1 and -1 (displayed before eq:bobbin)."""
    cos2, sin2 = sp.cos(phi / 2) ** 2, sp.sin(phi / 2) ** 2
    if (sigma == 1) is exchanged:
        cos2, sin2 = sin2, cos2
    return cos2 * (du + dv) ** 2 + sin2 * (du - dv) ** 2


def first_order(
    cos_half: Any, sin_half: Any, sigma: int, *, along: Any = 1, about: Any = 1
) -> Pair:
    """Right sides for ds/dxi and (alpha/kappa) cosh s, by cos(phi/2) and sin(phi/2) (eq:bobbin).

    along, about: factors of the two, printed as 1.
    """
    plus, minus = sp.Rational(1 + sigma, 2), sp.Rational(1 - sigma, 2)
    return along * (plus * cos_half + minus * sin_half), about * (
        plus * sin_half + minus * cos_half
    )


def alpha(kappa: Any, *, shift: int = 1) -> Any:
    """Rate of the azimuth along the asymptotic curves (after eq:bobbin)."""
    return kappa / sp.sqrt(kappa**2 + shift)


def azimuth(u: Any, v: Any, rate: Any, *, weight: int = -1) -> Any:
    """Azimuth by the asymptotic coordinates (normalisation before eq:bobbin)."""
    return rate * u + weight * rate * v


def energy(s: Any, ds: Any, kappa: Any, *, shift: int = 1, sign: int = 1) -> Any:
    """Defect that vanishes on a solution (eq:econs)."""
    return ds**2 + sign * sp.cosh(s) ** 2 / (kappa**2 + shift) - 1


def potential(s: Any, kappa: Any, *, factor: str = "1/2") -> Any:
    """Potential of the unit mass (after the proof of the lemma)."""
    return sp.Rational(factor) * sp.cosh(s) ** 2 / (kappa**2 + 1)


def angle(s: Any, kappa: Any, sigma: int, *, shift: int = 1, exchanged: bool = False) -> Any:
    """Angle between the asymptotic directions (eq:sg-soln)."""
    ratio = sp.cosh(s) / sp.sqrt(kappa**2 + shift)
    first, second = sp.asin(ratio), sp.acos(ratio)
    if exchanged:
        first, second = second, first
    return (1 + sigma) * first + (1 - sigma) * second


def product_step(s: Any, ds: Any, phi: Any, kappa: Any, *, factor: Any = "1/2") -> Pair:
    """Middle and right of the first display of the proof."""
    return sp.cosh(s) / sp.sqrt(kappa**2 + 1) * ds, sp.Rational(factor) * sp.sin(phi)


def quotient_step(cos_half: Any, sin_half: Any, sigma: int, dphi: Any, *, weight: int = -1) -> Pair:
    """Middle and right of the second display of the proof."""
    plus, minus = sp.Rational(1 + sigma, 2), sp.Rational(1 - sigma, 2)
    top = plus * cos_half + weight * minus * sin_half
    bottom = plus * cos_half + minus * sin_half
    return top / bottom * dphi / 2, sigma * dphi / 2


def height_rate_squared(s: Any, ds: Any, kappa: Any, *, power: int = 2) -> Pair:
    """Middle and right of (eq:zprime)."""
    room = kappa**2 - sp.sinh(s) ** 2
    return (1 - sp.sinh(s) ** 2 / kappa**2) * ds**2, room**power / (kappa**2 * (kappa**2 + 1))


def edge_radius(kappa: Any, *, shift: int = 1) -> Any:
    """Radius of the singular edge (after eq:zprime)."""
    return sp.sqrt(kappa**2 + shift) / kappa


def expansion_orders(*, radius: int = 2, height: int = 3) -> tuple[int, int]:
    """Orders of the leading terms of rho - rho_c and z - z_c (after eq:zprime)."""
    return radius, height
