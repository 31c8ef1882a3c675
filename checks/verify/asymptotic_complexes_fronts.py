"""Checks of branched PS-fronts on complexes and of the definition of a sector, on a tractrix front.

The front is the pseudosphere over the whole plane of its asymptotic coordinates.
"""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import asymptotic_complexes as printed
from checks.printed.fronts import lelieuvre
from checks.verify.asymptotic_complexes_definitions import faces_of_four_sides
from theory.fronts import U, V, tractrix_front
from theory.vectors import Vector, added, cross, derivative, dot, scaled

_SIZE = sp.Rational(1, 2)
_PARTS = ("mirrored", "families swapped", "shifted")


def _on_face(face: int, change: str) -> tuple[Vector, Vector]:
    """Front and normal on face 0 or 1 of a grid of 2 by 1, in the coordinates of the face.

    change: what is done to face 1. The singular edge u + v = 0 of the front crosses face 0.
    """
    place = {U: U + face * _SIZE - _SIZE / 2}
    front, normal = ((x.subs(place), y.subs(place), z.subs(place)) for x, y, z in tractrix_front())
    if face == 1 and change == "mirrored":
        front, normal = ((x, y, -z) for x, y, z in (front, normal))
    if face == 1 and change == "families swapped":
        swap = {U: V, V: U}
        front, normal = (
            (x.subs(swap, simultaneous=True), y.subs(swap, simultaneous=True),
             z.subs(swap, simultaneous=True))
            for x, y, z in (front, normal)
        )  # fmt: skip
    if face == 1 and change == "shifted":
        front = added(front, (sp.Integer(0), sp.Integer(0), sp.Integer(1)))
    return front, normal


def _front_residuals(front: Vector, normal: Vector) -> dict[str, object]:
    """What vanishes for a PS-front of unit speed: Lelieuvre, unit normal, Moutard."""
    n_u, n_v = derivative(normal, U), derivative(normal, V)
    r_u, r_v = lelieuvre(normal, n_u, n_v)
    return {
        "r_u": added(derivative(front, U), scaled(-1, r_u)),
        "r_v": added(derivative(front, V), scaled(-1, r_v)),
        "N.N": dot(normal, normal) - 1,
        "N_u.N_u": dot(n_u, n_u) - 1,
        "N_v.N_v": dot(n_v, n_v) - 1,
        "N_uv x N": cross(derivative(normal, U, V), normal),
    }


def branched_front(setting: Setting, *, change: str = "none") -> Evidence:
    """Definition of a branched PS-front: the tractrix front on a grid of two faces.

    change: what is done to the second face; `none` builds the instance.
    """
    residuals: dict[str, object] = {}
    pieces = [_on_face(face, change) for face in (0, 1)]
    for face, (front, normal) in enumerate(pieces):
        found = _front_residuals(front, normal)
        residuals |= {f"face {face}, {name}": value for name, value in found.items()}
    (first, _), (second, _) = pieces
    edge = [a.subs(U, _SIZE) - b.subs(U, 0) for a, b in zip(first, second, strict=True)]
    residuals["common edge"] = edge
    return identities(
        setting,
        residuals,
        shown="the tractrix front is an analytic PS-front on both faces, one map on their common "
        "edge; mirrored, shifted, or with the families swapped on one face it is none",
    )


def quadrilateral(setting: Setting, *, step: int = 1, curves: str = "lines") -> Evidence:
    """Sides of an asymptotic quadrilateral: two of each family, along asymptotic curves.

    curves: `lines` for the lines of the coordinates, `diagonals` for u - v constant.
    """
    front, normal = _on_face(0, "none")
    second = {
        "u": dot(derivative(front, U, U), normal),
        "v": dot(derivative(front, V, V), normal),
    }
    if curves == "diagonals":
        along = added(derivative(front, U), derivative(front, V))
        second = {"u + v": dot(added(derivative(along, U), derivative(along, V)), normal)}
    return combined(
        {
            "sides": faces_of_four_sides(setting, step=step),
            "asymptotic": identities(setting, second, shown="no normal curvature along the sides"),
        },
        shown="each face has two u- and two v-sides, each meeting both of the other family; they "
        "are asymptotic curves of the front, and the rectangle gives the coordinates",
    )


def sector(setting: Setting, *, sides: str = "none", origin: str = "0") -> Evidence:
    """Definition of a sector: psi = r o tau on K, with tau(p) = (0, 0), needs r on two sides.

    sides: which of the sides u = 0, v = 0 the domain of r contains; origin: tau(p) = (origin, 0).
    """
    domain = printed.sector_domain(_SIZE, _SIZE, sides=sides)
    at = (sp.Rational(origin), sp.Integer(0))
    span = sp.Interval.Ropen(0, _SIZE)
    needed = {
        "p": sp.FiniteSet(at),
        "gamma_u": sp.ProductSet(span, sp.FiniteSet(0)),
        "gamma_v": sp.ProductSet(sp.FiniteSet(0), span),
    }
    for name, points in needed.items():
        if points.is_subset(domain) is not True:
            return statement(
                False,
                shown="",
                witness=f"{name}: tau takes it to {points}, where r is not defined, so that psi "
                "= r o tau fails there",
            )
    if at != (0, 0):
        return statement(False, shown="", witness=f"tau(p) = {at} is no corner of the sector")
    shifted = tuple(x.subs({U: U + 1, V: V + 1}, simultaneous=True) for x in tractrix_front()[0])
    corner = [sp.limit(sp.limit(x, U, 0, "+"), V, 0, "+") for x in shifted]
    value = [x.subs({U: 0, V: 0}) for x in shifted]
    return identities(
        setting,
        {"continuity": [a - b for a, b in zip(corner, value, strict=True)]},
        shown="with r on [0, u_0) x [0, v_0) the tractrix front restricted to a rectangle is a "
        "sector at its corner",
    )
