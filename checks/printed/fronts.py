"""The class C^{1M}, weakly harmonic normals and pseudospherical fronts of section 3.1."""

from collections.abc import Callable
from typing import Any

from theory.ridge_functions import Ridges, has_continuous_mixed, is_c1
from theory.vectors import Vector, cross, scaled


def is_c1m(terms: Ridges, *, first: bool = True, mixed: bool = True) -> bool:
    """Definition of C^{1M}: first derivatives and the mixed one exist and are continuous."""
    return (not first or is_c1(terms)) and (not mixed or has_continuous_mixed(terms))


def composite(
    f: Callable[..., Any], g: Callable[..., Any], r: Any, s: Any, z: Any, *, second: str = "z"
) -> tuple[Any, Any]:
    """Both sides of the composite h(r, z) = f o g(r, s); second: name of h's second argument."""
    return f(*g(r, {"r": r, "s": s, "z": z}[second])), f(*g(r, s))


def speeds_are_positive(squared: tuple[Any, Any], *, families: int = 2) -> bool:
    """Item (1) of the definition of a weakly harmonic map: N_u . N_u > 0 and N_v . N_v > 0.

    families: how many of the two must be positive.
    """
    return [bool(value > 0) for value in squared].count(True) >= families


def lelieuvre(normal: Vector, n_u: Vector, n_v: Vector, *, sign_v: int = -1) -> tuple[Any, Any]:
    """Right sides of the Lelieuvre equations that define a front: N_u x N and -N_v x N."""
    return cross(n_u, normal), scaled(sign_v, cross(n_v, normal))


def moutard_residual(normal: Vector, mixed: Vector, nu: Any) -> Vector:
    """Item (2) of the definition of a weakly harmonic map: N_uv - nu N."""
    return (
        mixed[0] - nu * normal[0],
        mixed[1] - nu * normal[1],
        mixed[2] - nu * normal[2],
    )
