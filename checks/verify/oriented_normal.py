"""Checks of section 3.1, item (F): the normal that agrees with an orientation of the surface.

On the tangent plane of a graph with any gradient, with a basis X, Y of known orientation:
X = a X_1 + b X_2 and Y = c X_1 + d X_2, where d is such that ad - bc is +D or -D with D > 0.
"""

from itertools import product
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import asymptotic_frames as printed
from theory.orientation import TangentPlane, density, generic_plane
from theory.vectors import Vector, cross, dot, scaled


def _basis(plane: TangentPlane, handed: int) -> tuple[Vector, Vector, Any, Any]:
    """Basis X, Y of the plane, its determinant in the coordinate basis, and |X x Y|."""
    a, size = sp.symbols("a D", positive=True)
    b, c = sp.symbols("b c", real=True)
    determinant = handed * size
    x = plane.vector(a, b)
    y = plane.vector(c, (determinant + b * c) / a)
    return x, y, determinant, size * sp.sqrt(1 + plane.slope_1**2 + plane.slope_2**2)


def _tangents(plane: TangentPlane) -> tuple[Vector, Vector, Any]:
    """Any two tangent vectors and the determinant of their components."""
    p, q, r, s = sp.symbols("p q r s", real=True)
    return plane.vector(p, q), plane.vector(r, s), p * s - q * r


def graph_orientation(setting: Setting, *, second: int = 2) -> Evidence:
    """Item (F): dx_1 ^ dx_2 is 1 on the coordinate basis of a graph, so it vanishes nowhere."""
    plane = generic_plane()
    first, other = plane.basis
    x, y, determinant = _tangents(plane)
    residuals = {
        "omega on the basis": printed.graph_orientation(first, other, second=second) - 1,
        "omega on any pair": printed.graph_orientation(x, y, second=second) - determinant,
    }
    return identities(
        setting,
        residuals,
        shown="dx_1 ^ dx_2 of two tangent vectors of any graph "
        "is the determinant of their components, 1 on the basis",
    )


def compatible_normal(setting: Setting, *, side: int = 1) -> Evidence:
    """Item (F): exactly one unit normal has omega(X, Y) = beta (X x Y).N with a positive beta.

    For omega = dx_1 ^ dx_2 on a graph; side: 1 for the upward normal, -1 for the downward one.
    """
    plane = generic_plane()
    normal = scaled(side, plane.upward_normal)
    first, other = plane.basis
    beta = density(printed.graph_orientation(first, other), first, other, normal)
    beta = sp.simplify(beta)
    x, y, _ = _tangents(plane)
    value = printed.compatible(beta, x, y, normal, cross)
    exists = identities(
        setting,
        {
            "unit length": dot(normal, normal) - 1,
            "omega - beta (X x Y).N": printed.graph_orientation(x, y) - value,
        },
        shown="the relation holds with one beta for all X and Y",
    )
    positive = statement(
        bool(beta.is_positive),
        shown="beta is positive",
        witness=f"beta = {beta} is not positive, for N = {normal}",
    )
    return combined(
        {"relation": exists, "sign": positive},
        shown="the upward unit normal of any "
        "graph satisfies the relation for all X, Y with beta = 1/sqrt(1 + |grad w|^2) "
        "> 0; the other unit normal needs beta < 0",
    )


def oriented_normal(setting: Setting, *, oriented: bool = True, sign: int = 1) -> Evidence:
    """(eq:Nfront): the formula gives the unit normal that the definition with omega selects.

    For bases X, Y and forms omega of either orientation; omega(X, Y) = s D w with w > 0.
    """
    plane = generic_plane()
    weight = sp.Symbol("omega_0", positive=True)
    residuals: dict[str, Any] = {}
    for handed, side in product((1, -1), repeat=2):
        x, y, determinant, norm = _basis(plane, handed)
        value = side * weight * determinant
        normal = printed.oriented_normal(value, x, y, norm, cross, oriented=oriented, sign=sign)
        where = f"basis {handed:+d}, omega {side:+d}"
        beta = weight / sp.sqrt(1 + plane.slope_1**2 + plane.slope_2**2)
        p, q, components = _tangents(plane)
        stated = printed.compatible(beta, p, q, normal, cross)
        residuals[f"{where}: N.N - 1"] = dot(normal, normal) - 1
        residuals[f"{where}: omega - beta (P x Q).N"] = side * weight * components - stated
        upward = plane.upward_normal
        residuals[f"{where}: N"] = tuple(
            found - side * expected for found, expected in zip(normal, upward, strict=True)
        )
    return identities(
        setting,
        residuals,
        shown="for both orientations of the basis and of omega, "
        "the formula is the one unit normal with omega(P, Q) = beta (P x Q).N, beta "
        "> 0, for all tangent P, Q",
    )


def flip_insensitive(
    setting: Setting, *, oriented: bool = True, flips: str = "u,v,both"
) -> Evidence:
    """Item (F): N^omega is the same for (r_u, r_v), (-r_u, r_v), (r_u, -r_v).

    flips: names of the flips, with commas between; "exchange" takes (r_v, r_u) with the value of
    omega(r_u, r_v), so it is no flip.
    """
    plane = generic_plane()
    residuals: dict[str, Any] = {}
    signs = {"u": (-1, 1), "v": (1, -1), "both": (-1, -1)}
    for handed in (1, -1):
        x, y, value, norm = _basis(plane, handed)
        before = printed.oriented_normal(value, x, y, norm, cross, oriented=oriented)
        for name in flips.split(","):
            if name == "exchange":
                first, other, new_value = y, x, value
            else:
                e, f = signs[name]
                first, other, new_value = scaled(e, x), scaled(f, y), e * f * value
            after = printed.oriented_normal(new_value, first, other, norm, cross, oriented=oriented)
            residuals[f"basis {handed:+d}, {name}"] = tuple(
                new - old for new, old in zip(after, before, strict=True)
            )
    return identities(
        setting,
        residuals,
        shown="the formula gives the same vector after u -> -u, after v -> -v and after both",
    )


def continuous(setting: Setting, *, oriented: bool = True) -> Evidence:
    """Item (F): in any asymptotic parametrisation N^omega is one continuous function of grad w.

    For omega = dx_1 ^ dx_2 on a C^1 graph: (-w_1, -w_2, 1)/sqrt(1 + w_1^2 + w_2^2), whatever the
    basis (r_u, r_v) and its orientation.
    """
    plane = generic_plane()
    residuals: dict[str, Any] = {}
    for handed in (1, -1):
        x, y, _, norm = _basis(plane, handed)
        value = sp.expand(printed.graph_orientation(x, y))
        normal = printed.oriented_normal(value, x, y, norm, cross, oriented=oriented)
        residuals[f"basis {handed:+d}: |X x Y|^2"] = dot(cross(x, y), cross(x, y)) - norm**2
        residuals[f"basis {handed:+d}: N"] = tuple(
            found - expected for found, expected in zip(normal, plane.upward_normal, strict=True)
        )
    return identities(
        setting,
        residuals,
        shown="in every basis of the tangent plane, of either "
        "orientation, the formula gives the upward unit normal, which is continuous "
        "where the gradient of w is",
    )
