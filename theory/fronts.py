r"""Pseudospherical fronts, integrated from weakly harmonic normals N on S^2.

Along a u-line of torsion -1 and unit speed the binormal N turns as N_u = N x r_u, along a v-line of
torsion +1 as N_v = -N x r_v; so r_u = N_u x N and r_v = -N_v x N, for every weakly harmonic N.
"""

from typing import Any

import sympy as sp

from theory.vectors import Vector, added, cross, derivative, dot, scaled

U, V = sp.symbols("u v", real=True)


def generic_normal() -> Vector:
    """Return the unit normal in terms of unknown polar angles theta(u, v), psi(u, v)."""
    theta, psi = sp.Function("theta")(U, V), sp.Function("psi")(U, V)
    return (
        sp.sin(theta) * sp.cos(psi),
        sp.sin(theta) * sp.sin(psi),
        sp.cos(theta),
    )


def moutard_rules() -> dict[Any, Any]:
    """Values of theta_uv and psi_uv that make N_uv of the generic normal parallel to N.

    Where sin theta is not 0; from the two tangential components of N_uv, taken at azimuth psi = 0.
    """
    theta, psi = sp.Function("theta")(U, V), sp.Function("psi")(U, V)
    mixed = at_azimuth_0(derivative(generic_normal(), U, V))
    along_meridian = (sp.cos(theta), sp.Integer(0), -sp.sin(theta))
    components = {sp.diff(theta, U, V): dot(mixed, along_meridian), sp.diff(psi, U, V): mixed[1]}
    return {
        unknown: -component.xreplace({unknown: sp.Integer(0)}) / sp.diff(component, unknown)
        for unknown, component in components.items()
    }


def at_azimuth_0(a: Vector) -> Vector:
    """Vector built from the generic normal and its derivatives, where psi is 0.

    A turn about the axis takes psi to psi + const and turns every such vector, so that an equation
    between two of them that holds here holds everywhere.
    """
    psi = sp.Function("psi")(U, V)
    place = {sp.sin(psi): sp.Integer(0), sp.cos(psi): sp.Integer(1)}
    return (a[0].xreplace(place), a[1].xreplace(place), a[2].xreplace(place))


def front_rates(normal: Vector) -> tuple[Vector, Vector]:
    """Return the derivatives r_u and r_v of the front with this normal."""
    return (
        cross(derivative(normal, U), normal),
        scaled(-1, cross(derivative(normal, V), normal)),
    )


def closure(rates: tuple[Vector, Vector]) -> Vector:
    """Difference of the two mixed derivatives: the form r_u du + r_v dv is closed where it is 0."""
    return added(derivative(rates[0], V), scaled(-1, derivative(rates[1], U)))


def period(rates: tuple[Vector, Vector], step: tuple[Any, Any]) -> Vector:
    """Change of the front along the straight path from (0, 0) to step."""
    t = sp.Dummy("t", real=True)
    path = {U: t * step[0], V: t * step[1]}
    speed = [
        sp.simplify((a * step[0] + b * step[1]).subs(path, simultaneous=True))
        for a, b in zip(*rates, strict=True)
    ]
    x, y, z = (sp.integrate(entry, (t, 0, 1)) for entry in speed)
    return (x, y, z)


def degenerate_normal() -> Vector:
    """Return (cos(u - v), sin(u - v), 0): weakly harmonic of rank 1, its front is a line."""
    return (sp.cos(U - V), sp.sin(U - V), sp.Integer(0))


def tractrix_front() -> tuple[Vector, Vector]:
    """Pseudosphere on the whole (u, v)-plane, and a normal that is smooth across its edge.

    The tractrix of parameter s = u + v, turned by the angle v - u: the sense that gives the
    u-lines the torsion -1. The edge is the circle s = 0.
    """
    s, angle = U + V, V - U
    radius, height = 1 / sp.cosh(s), s - sp.tanh(s)
    front = (radius * sp.cos(angle), radius * sp.sin(angle), height)
    normal = (sp.tanh(s) * sp.cos(angle), sp.tanh(s) * sp.sin(angle), 1 / sp.cosh(s))
    return front, normal
