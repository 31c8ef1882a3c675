"""The Hessian determinant of a piecewise quadratic function, in the very weak sense.

For smooth w, det D^2 w = (w_x w_y)_xy - (w_x^2)_yy / 2 - (w_y^2)_xx / 2; the right side needs one
derivative of w only. At small slopes it is the Gauss curvature that the metric of the graph of w
determines.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

X, Y = sp.symbols("x y", real=True)
Point = tuple[Any, Any]


@dataclass(frozen=True, kw_only=True)
class Piece:
    """Triangle with its three corners, counterclockwise, and the height w on it."""

    corners: tuple[Point, Point, Point]
    height: sp.Expr


def _cross(a: Point, b: Point) -> Any:
    return a[0] * b[1] - a[1] * b[0]


def sector_saddle(rays: Sequence[Point]) -> tuple[Piece, ...]:
    """Saddles of det D^2 w = -1 in the sectors between rays, of alternate sign, C^1 across them.

    rays: an even number of vectors, counterclockwise, successive ones less than pi apart. In a
    sector w is the product of the coordinates along its two rays times the area they span, so its
    normal derivative on a ray depends on that ray alone. The pieces are triangles at the origin.
    """
    pieces = []
    for index, (a, b) in enumerate(zip(rays, [*rays[1:], rays[0]], strict=True)):
        height = _cross((X, Y), b) * _cross(a, (X, Y)) / _cross(a, b)
        pieces.append(Piece(corners=((0, 0), a, b), height=sp.expand((-1) ** index * height)))
    return tuple(pieces)


def creased_saddle() -> tuple[Piece, ...]:
    """Graph over [-1, 1]^2 of |x| + x y + y^2/2: det D^2 w = -1 off a crease on x = 0."""
    saddle = X * Y + Y**2 / 2
    return (
        Piece(corners=((0, -1), (1, -1), (1, 1)), height=X + saddle),
        Piece(corners=((0, -1), (1, 1), (0, 1)), height=X + saddle),
        Piece(corners=((0, -1), (0, 1), (-1, 1)), height=-X + saddle),
        Piece(corners=((0, -1), (-1, 1), (-1, -1)), height=-X + saddle),
    )


def triangle_integral(f: sp.Expr, corners: tuple[Point, Point, Point]) -> sp.Expr:
    """Integral of a polynomial in X, Y over a counterclockwise triangle."""
    s, t = sp.symbols("s t")
    origin, a, b = corners
    edges = [(c[0] - origin[0], c[1] - origin[1]) for c in (a, b)]
    moved = {
        X: origin[0] + s * edges[0][0] + t * edges[1][0],
        Y: origin[1] + s * edges[0][1] + t * edges[1][1],
    }
    terms = sp.Poly(f.subs(moved, simultaneous=True), s, t).terms()
    # The moment of s^i t^j over the unit triangle is i! j! / (i + j + 2)!.
    moments = [
        c * sp.factorial(i) * sp.factorial(j) / sp.factorial(i + j + 2) for (i, j), c in terms
    ]
    return _cross(edges[0], edges[1]) * sum(moments)


def pointwise_determinants(pieces: tuple[Piece, ...]) -> set[sp.Expr]:
    """Values of det D^2 w inside the pieces."""
    return {sp.expand(sp.hessian(piece.height, (X, Y)).det()) for piece in pieces}


def weak_determinant(pieces: tuple[Piece, ...], test: sp.Expr) -> sp.Expr:
    """Pairing of the very weak det D^2 w with a polynomial that vanishes doubly at the boundary."""
    total = sp.Integer(0)
    for piece in pieces:
        w_x, w_y = piece.height.diff(X), piece.height.diff(Y)
        density = (
            w_x * w_y * test.diff(X, Y)
            - w_x**2 * test.diff(Y, 2) / 2
            - w_y**2 * test.diff(X, 2) / 2
        )
        total += triangle_integral(density, piece.corners)
    return total
