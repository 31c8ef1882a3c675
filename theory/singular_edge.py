"""Singularities of the pseudospherical surfaces of revolution, as fronts.

A front has a unit normal N along with the map f. Where its signed area density
lambda = det(f_1, f_2, N) vanishes and df kills a vector eta, it has a cuspidal edge exactly if
lambda changes at a non-zero rate along eta and N moves along eta (Kokubu, Rossman, Saji, Umehara
and Yamada, Pacific J. Math. 221 (2005) 303-351).
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp

from theory.surface_of_revolution import rotated
from theory.vectors import Vector, derivative, dot, triple

TAU, THETA = sp.symbols("tau theta", real=True)
KAPPA = sp.Symbol("kappa", positive=True)


@dataclass(frozen=True, kw_only=True)
class Front:
    """Derivatives of a front by TAU along the meridian, by THETA around the axis; its normal."""

    along: Vector
    around: Vector
    normal: Vector

    @property
    def area_density(self) -> Any:
        """Signed area density det(f_tau, f_theta, N)."""
        return triple(self.along, self.around, self.normal)


def _front(radius: Any, inclination: Any) -> Front:
    """Front of this radius whose meridian climbs at the angle inclination from the axis."""
    slope, climb = sp.sin(inclination), sp.cos(inclination)
    speed = radius.diff(TAU) / slope
    return Front(
        along=tuple(sp.cancel(speed) * c for c in rotated(slope, climb, THETA)),
        around=(-radius * sp.sin(THETA), radius * sp.cos(THETA), sp.Integer(0)),
        normal=rotated(climb, -slope, THETA),
    )


def bobbin() -> Front:
    """Bobbin by tau, the inclination of its meridian to the axis; singular at tau = pi/2.

    From rho_ss = rho: rho^2 - rho_s^2 is constant, 1/kappa^2 at the throat, and rho_s = sin tau.
    """
    return _front(sp.sqrt(1 / KAPPA**2 + sp.sin(TAU) ** 2), TAU)


def pseudosphere() -> Front:
    """Pseudosphere, rho = rho_s = sin tau, singular at tau = pi/2."""
    return _front(sp.sin(TAU), TAU)


def cone() -> Front:
    """Surface with rho = kappa sinh(tau) and K = -1, whose apex tau = 0 is no edge; kappa < 1."""
    radius, slope = KAPPA * sp.sinh(TAU), KAPPA * sp.cosh(TAU)
    climb = sp.sqrt(1 - slope**2)
    return Front(
        along=rotated(slope, climb, THETA),
        around=(-radius * sp.sin(THETA), radius * sp.cos(THETA), sp.Integer(0)),
        normal=rotated(climb, -slope, THETA),
    )


def edge_invariants(front: Front, tau: Any, null: str) -> dict[str, Any]:
    """Area density, its rate, and the squared lengths of df and dN, along the null direction.

    null: `along` the meridian or `around` the axis; all at this tau.
    """
    variable = {"along": TAU, "around": THETA}[null]
    step = {"along": front.along, "around": front.around}[null]
    moved = derivative(front.normal, variable)
    found = {
        "area density": front.area_density,
        "rate": front.area_density.diff(variable),
        "step": dot(step, step),
        "turn of the normal": dot(moved, moved),
    }
    return {name: sp.simplify(value.subs(TAU, tau)) for name, value in found.items()}
