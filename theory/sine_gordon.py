"""Compatibility of the frame equations of a surface: mixed derivatives of a moving frame."""

from typing import Any

import sympy as sp

from theory.surfaces import Front


def generic_matrix(name: str, u: sp.Symbol, v: sp.Symbol) -> sp.Matrix:
    """Three by three matrix of unknown functions of u and v."""
    return sp.Matrix(3, 3, lambda i, j: sp.Function(f"{name}{i + 1}{j + 1}", real=True)(u, v))


def mixed_gap(
    a: sp.Matrix, b: sp.Matrix, frame: sp.Matrix, u: sp.Symbol, v: sp.Symbol
) -> sp.Matrix:
    """Difference (F_u)_v - (F_v)_u for a frame with F_u = a F and F_v = b F, by the product rule.

    frame: matrix of unknown functions, whose derivatives are replaced by what the system says.
    """
    along_u, along_v = a * frame, b * frame
    rules = {}
    for entry, by_u, by_v in zip(frame, along_u, along_v, strict=True):
        rules[entry.diff(u)] = by_u
        rules[entry.diff(v)] = by_v
    gap = along_u.diff(v) - along_v.diff(u)
    return gap.applyfunc(lambda expr: sp.expand(expr.xreplace(rules)))


def soliton_angle(front: Front, side: int) -> Any:
    """Angle in (0, pi) of a one-soliton front with tan(phi/4) = e^(-chi), as a function of chi.

    side: +1 for chi > 0, where it is the smooth angle, -1 for chi < 0, where it is pi less.
    """
    smooth = 4 * sp.atan(front.quarter_tangent)
    return smooth if side > 0 else smooth - sp.pi


def corner_difference(angle: Any, rectangle: tuple[Any, Any, Any, Any], chi: sp.Symbol) -> Any:
    """phi(u1, v1) - phi(u0, v1) - phi(u1, v0) + phi(u0, v0) for phi a function of chi = u + v.

    angle: callable on the value of chi; rectangle: u0, u1, v0, v1.
    """
    u0, u1, v0, v1 = rectangle
    corners = ((1, u1 + v1), (-1, u0 + v1), (-1, u1 + v0), (1, u0 + v0))
    return sum((sign * angle(place).subs(chi, place) for sign, place in corners), sp.Integer(0))
