"""Unit vectors for exact checks: general ones up to a rotation, and rational ones."""

from dataclasses import dataclass
from random import Random
from typing import Any

import sympy as sp

from theory.vectors import Vector

X, Y = sp.symbols("x y", positive=True)
Z = sp.Symbol("z", real=True)


def circle(t: Any) -> tuple[Any, Any]:
    """Cosine and sine of 2 arctan t, rational in t."""
    return (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)


@dataclass(frozen=True, kw_only=True)
class Corner:
    """Unit vectors n_0, n_1, n_2, general up to a rotation, and the cosines of the two edges.

    The edges from n_0 have the lengths 2 arctan x and 2 arctan y, the angle between them is
    2 arctan z.
    """

    n_0: Vector
    n_1: Vector
    n_2: Vector
    cosines: tuple[Any, Any]
    sines: tuple[Any, Any]


def corner(x: Any = X, y: Any = Y, z: Any = Z) -> Corner:
    """Corner with edges of half-tangents x and y and an angle of half-tangent z."""
    c_1, s_1 = circle(x)
    c_2, s_2 = circle(y)
    c, s = circle(z)
    return Corner(
        n_0=(sp.Integer(1), sp.Integer(0), sp.Integer(0)),
        n_1=(c_1, s_1, sp.Integer(0)),
        n_2=(c_2, s_2 * c, s_2 * s),
        cosines=(c_1, c_2),
        sines=(s_1, s_2),
    )


def symbols(name: str) -> Vector:
    """Triple of real symbols."""
    first, second, third = sp.symbols(f"{name}_x {name}_y {name}_z", real=True)
    return first, second, third


def quad_symbols() -> tuple[Vector, Vector, Vector, Vector]:
    """Four triples of real symbols, N_0, N_1, N_2 and N_12."""
    return symbols("a"), symbols("b"), symbols("c"), symbols("d")


def rational_unit(rng: Random, *, spread: int = 1) -> Vector:
    """Random rational point of S^2, within about 2 spread of (1, 0, 0)."""
    s, t = (sp.Rational(rng.randint(-20, 20) * spread, 20) for _ in range(2))
    norm = 1 + s**2 + t**2
    return (2 / norm - 1, 2 * s / norm, 2 * t / norm)
