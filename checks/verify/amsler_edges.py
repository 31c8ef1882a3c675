"""The edges of an Amsler sector: their curvature, and why they are straight lines of R^3."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import amsler as printed
from theory import amsler, fronts
from theory.vectors import cross, derivative, scaled

U, V, PHI0 = amsler.U, amsler.V, amsler.PHI0
ORDER = 4


def edge_by_normal(setting: Setting, *, height: int = 0) -> Evidence:
    """Edge integrated from a normal that runs along a circle of S^2 at unit speed.

    height: five times the distance of the circle's plane from the centre; 0 is a great circle.
    """
    sine = sp.Rational(height, 5)
    cosine = sp.sqrt(1 - sine**2)
    turn = fronts.U / cosine
    normal = (cosine * sp.cos(turn), cosine * sp.sin(turn), sine)
    velocity = cross(derivative(normal, fronts.U), normal)
    return identities(
        setting,
        {"acceleration r_uu of the edge": derivative(velocity, fronts.U)},
        shown="an edge along which N is a great circle of unit speed is a straight line",
    )


def edge_curvature_formula(setting: Setting, *, along: str = "u", sign: int = 1) -> Evidence:
    """Geodesic curvature of asymptotic lines against the derivative of phi, both sigma."""
    phi = sp.Function("phi", positive=True)(U, V)
    index = 0 if along == "u" else 1
    claimed = printed.edge_curvature(phi, U, V, along=along, sign=sign)
    return identities(
        setting,
        {
            f"kappa^{along}, sigma = {sigma}": amsler.edge_curvatures(phi, sigma=sigma)[index]
            - claimed
            for sigma in (1, -1)
        },
        shown=f"kappa^{along} is {'' if sign > 0 else '-'}d_{along} phi, for both signs of sigma",
    )


def edge_derivative(setting: Setting, *, along: str = "u", edge: str = "u=0") -> Evidence:
    """Slope of the Amsler angle on an edge, from its double Taylor series."""
    phi = amsler.goursat_series(ORDER).subs({amsler.S0: sp.sin(PHI0), amsler.C0: sp.cos(PHI0)})
    slope = printed.edge_curvature(phi, U, V, along=along)
    on_edge = slope.subs(U if edge == "u=0" else V, 0)
    return identities(
        setting,
        {f"d_{along} phi on {edge}": sp.expand(on_edge)},
        shown=f"d_{along} phi vanishes on {edge}",
    )


def edge_acceleration(setting: Setting, *, along: str = "u", edge: str = "u=0") -> Evidence:
    """Vector r_uu or r_vv of an Amsler sector on an edge, by Christoffel symbols."""
    phi = sp.Function("phi", positive=True)(U, V)
    series = amsler.goursat_series(ORDER).subs({amsler.S0: sp.sin(PHI0), amsler.C0: sp.cos(PHI0)})
    vector = amsler.accelerations(phi, sigma=1)[0 if along == "u" else 1]
    zero = {(U if edge == "u=0" else V): 0}
    slopes = {
        sp.diff(phi, U): sp.diff(series, U).subs(zero),
        sp.diff(phi, V): sp.diff(series, V).subs(zero),
        phi: PHI0,
    }
    return identities(
        setting,
        {f"r_{along}{along} on {edge}": vector.subs(slopes)},
        shown=f"r_{along}{along} = 0 on {edge}: the curve is a straight line",
    )


def straight_edge(setting: Setting, *, edge: str = "u=0", along: str = "") -> Evidence:
    """Conclusion for one edge, by its acceleration and by the normal along it.

    along: the family of the curve that is the edge; left empty, the one that runs along it.
    """
    family = along or ("v" if edge == "u=0" else "u")
    normal_sign = -1 if family == "v" else 1
    base = (sp.Integer(0), sp.Integer(0), sp.Integer(1))
    tangent = (sp.cos(PHI0), sp.sin(PHI0), sp.Integer(0))
    side = scaled(normal_sign, cross(base, tangent))
    normal = tuple(sp.cos(U) * a + sp.sin(U) * b for a, b in zip(base, side, strict=True))
    velocity = scaled(normal_sign, cross(derivative(normal, U), normal))
    gap = tuple(a - b for a, b in zip(velocity, tangent, strict=True))
    return combined(
        {
            "acceleration": edge_acceleration(setting, along=family, edge=edge),
            "normal": identities(
                setting, {"velocity minus tangent": gap}, shown="the velocity is constant"
            ),
        },
        shown=f"the edge {edge} of an Amsler sector is a straight line of R^3",
    )


def other_edge(setting: Setting, *, along: str = "u") -> Evidence:
    """Conclude for the edge v = 0 as `straight_edge` does for u = 0."""
    return straight_edge(setting, edge="v=0", along=along)
