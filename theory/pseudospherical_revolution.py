r"""Asymptotic lines of the pseudospherical surfaces of revolution, through their singular edges.

The meridian's inclination psi, (rho_s, z_s) = (cos psi, sin psi), is a global coordinate: K = -1
says rho_ss = rho, hence rho^2 - rho_s^2 is constant, and every asymptotic line of unit speed turns
about the axis at the constant rate alpha, alpha^2 (1 + rho^2 - rho_s^2) = 1. With xi = u + v,

    ds/dxi = alpha sin psi,  dpsi/dxi = -alpha rho,  dz/dxi = alpha sin^2 psi,  theta_u = +-alpha.

These equations are smooth for all psi: sin psi = 0 is a singular edge. alpha < 1 are the bobbins
of Minding (ex:bobbin), alpha = 1 is the pseudosphere, alpha > 1 are the conical ones.
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp

from theory.surface_of_revolution import Meridian, rotated
from theory.vectors import Vector, added, cross, dot, scaled

U, V, PSI, THETA, Z = sp.symbols("u v psi theta z", real=True)


@dataclass(frozen=True, kw_only=True)
class Flow:
    """Motion of (psi, theta, z) along the asymptotic lines of one surface.

    alpha: rate |d theta/du|; rho: radius, an expression of PSI; sense: sign of d theta/du, where
    d theta/dv = -d theta/du. Raises ValueError for a sense that is not +1 or -1.
    """

    alpha: Any
    rho: Any
    sense: int = 1

    def __post_init__(self) -> None:
        if self.sense not in (1, -1):
            raise ValueError(f"expected a sense of rotation +1 or -1, got {self.sense}")

    @property
    def s_rate(self) -> Any:
        """Climb ds/dxi along the meridian."""
        return self.alpha * sp.sin(PSI)

    @property
    def psi_rate(self) -> Any:
        """Turning d psi/dxi of the meridian."""
        return -self.alpha * self.rho

    @property
    def z_rate(self) -> Any:
        """Climb dz/dxi = z_s ds/dxi, never negative."""
        return sp.sin(PSI) * self.s_rate

    @property
    def meridian(self) -> Meridian:
        """Meridian at inclination psi, where rho_ss = rho and psi_s sin psi = -rho_ss."""
        psi_s = -self.rho / sp.sin(PSI)
        return Meridian(
            rho=self.rho,
            rho_s=sp.cos(PSI),
            rho_ss=self.rho,
            z_s=sp.sin(PSI),
            z_ss=sp.cos(PSI) * psi_s,
        )

    def along(self, expr: Any) -> Any:
        """Rate by xi of an expression of PSI and Z."""
        return self.psi_rate * sp.diff(expr, PSI) + self.z_rate * sp.diff(expr, Z)

    def along_u(self, expr: Any) -> Any:
        """Rate by u at constant v of an expression of U, V, PSI, THETA and Z."""
        turn = self.sense * self.alpha * sp.diff(expr, THETA)
        return sp.diff(expr, U) + turn + self.along(expr)

    def along_v(self, expr: Any) -> Any:
        """Rate by v at constant u of an expression of U, V, PSI, THETA and Z."""
        turn = self.sense * self.alpha * sp.diff(expr, THETA)
        return sp.diff(expr, V) - turn + self.along(expr)

    def vector_u(self, a: Vector) -> Vector:
        """Rate by u of a vector."""
        return (self.along_u(a[0]), self.along_u(a[1]), self.along_u(a[2]))

    def vector_v(self, a: Vector) -> Vector:
        """Rate by v of a vector."""
        return (self.along_v(a[0]), self.along_v(a[1]), self.along_v(a[2]))


def pseudospherical_flow(alpha: Any, *, sense: int = 1) -> Flow:
    """Flow of the surface whose asymptotic lines turn at the rate alpha > 0."""
    return Flow(alpha=alpha, rho=sp.sqrt(1 / alpha**2 - sp.sin(PSI) ** 2), sense=sense)


def asymptotic_tangents(flow: Flow) -> tuple[Vector, Vector]:
    """Tangent vectors r_u and r_v as expressions of PSI and THETA."""
    climb = scaled(flow.s_rate, rotated(sp.cos(PSI), sp.sin(PSI), THETA))
    about = (-flow.rho * sp.sin(THETA), flow.rho * sp.cos(THETA), sp.Integer(0))
    turn = scaled(flow.sense * flow.alpha, about)
    return added(climb, turn), added(climb, scaled(-1, turn))


def meridian_normal() -> Vector:
    """Vector (-z_s, rho_s) in the plane of the meridian: a unit normal, smooth at the edges."""
    return rotated(-sp.sin(PSI), sp.cos(PSI), THETA)


def torsion(velocity: Vector, acceleration: Vector, jerk: Vector) -> Any:
    """Torsion of a curve in R^3 by its first three derivatives; undefined where it is straight."""
    velocity, acceleration, jerk = (_factored(a) for a in (velocity, acceleration, jerk))
    binormal = _factored(cross(velocity, acceleration))
    return sp.factor(dot(binormal, jerk)) / sp.factor(dot(binormal, binormal))


def _factored(a: Vector) -> Vector:
    return (sp.factor(a[0]), sp.factor(a[1]), sp.factor(a[2]))


def torsions(flow: Flow) -> tuple[Any, Any]:
    """Torsions in R^3 of the u-line and the v-line, as expressions of t = tan(psi/2).

    Taken at azimuth 0: turning about the axis moves each family onto itself.
    """
    r_u, r_v = asymptotic_tangents(flow)
    r_uu, r_vv = flow.vector_u(r_u), flow.vector_v(r_v)
    jets = ((r_u, r_uu, flow.vector_u(r_uu)), (r_v, r_vv, flow.vector_v(r_vv)))
    along_u, along_v = (torsion(*(_by_half_tangent(a) for a in jet)) for jet in jets)
    return along_u, along_v


def _by_half_tangent(a: Vector) -> Vector:
    """Vector at azimuth 0 by t = tan(psi/2)."""
    t = sp.Symbol("t", real=True)
    place = {THETA: 0, sp.sin(PSI): 2 * t / (1 + t**2), sp.cos(PSI): (1 - t**2) / (1 + t**2)}
    return (a[0].subs(place), a[1].subs(place), a[2].subs(place))
