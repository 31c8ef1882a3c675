r"""Normal map of a pseudospherical m-saddle to first order at its centre, where N = e_3.

A star is given as in theory.star_saddle, by the angles of its sectors; rays of even number are
u-curves, of torsion -1 and N_u = N x r_u, the others v-curves with N_v = -N x r_v. On sector i the
tangent map sends u s_i + v s_{i+1} to u t_i + v t_{i+1}, where t_i is the image of the ray s_i.
"""

from collections.abc import Sequence
from typing import Any

import sympy as sp

from theory import star_saddle
from theory.vectors import Vector, cross, scaled

E3: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(1))


def ray(angle: Any) -> Vector:
    """Unit tangent vector of a ray that leaves the centre at this angle."""
    return (sp.cos(angle), sp.sin(angle), sp.Integer(0))


def image_of_ray(angle: Any, i: int) -> Vector:
    """Unit tangent at e_3 of the image under N of ray i."""
    return scaled(1 if i % 2 == 0 else -1, cross(E3, ray(angle)))


def image_turns(angles: Sequence[Any], i: int) -> Any:
    """Angle of the image t_i of ray i, in turns, modulo 1; the angles are multiples of pi."""
    beta = star_saddle.ray_angle(angles, i) / (2 * sp.pi)
    quarter = sp.Rational(1, 4)
    return sp.Mod(beta + (quarter if i % 2 == 0 else -quarter), 1)


def _sine_sign(turns: Any) -> int:
    """Sign of the sine of an angle given in turns, a rational."""
    part = sp.Mod(turns, 1)
    if part in (0, sp.Rational(1, 2)):
        return 0
    return 1 if part < sp.Rational(1, 2) else -1


def preimages(angles: Sequence[Any], target: Any) -> list[int]:
    """Sectors whose interior has a point that the tangent map sends to a multiple of the target.

    target: angle of a direction in turns, a rational. By Cramer's rule, with exact signs; raises
    ValueError where the target is the image of a ray.
    """
    found = []
    for i in range(len(angles)):
        first, last = image_turns(angles, i), image_turns(angles, i + 1)
        base = _sine_sign(last - first)
        u, v = _sine_sign(last - target) * base, _sine_sign(target - first) * base
        if 0 in (u, v):
            raise ValueError(f"direction {target} is the image of a ray of sector {i}")
        if u > 0 and v > 0:
            found.append(i)
    return found


def sector_map(angles: Sequence[Any], i: int) -> sp.Matrix:
    """Tangent map of N on sector i, a matrix, from the images of its two rays."""
    rays, images = [], []
    for n in (i, i + 1):
        beta = star_saddle.ray_angle(angles, n)
        rays.append(ray(beta)[:2])
        images.append(image_of_ray(beta, n)[:2])
    return sp.Matrix(images).T * sp.Matrix(rays).T.inv()
