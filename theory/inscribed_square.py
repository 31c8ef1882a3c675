r"""Lower bound of the max curvature of C^2 isometric immersions of a geodesic disk (e2).

Let the principal curvatures be at most E = cot(delta/2) in size on the disk of radius R, so that
delta <= phi <= pi - delta for the angle phi of the asymptotic lines. In asymptotic coordinates
about the centre the straight way from (0, 0) to (u, v) has a length of at most
sqrt(u^2 + v^2 + 2 |u v| cos delta). The square |u|, |v| <= a with 2 a cos(delta/2) = R is thus laid
out in the disk, one to one or not. The alternating sum of phi over its corners is the integral of
sin phi over it (eq:hazzidakis): at least 4 a^2 sin delta and at most 2 (pi - delta) - 2 delta.
With 4 a^2 sin delta = 2 R^2 tan(delta/2) that is R^2 <= E (pi - 2 delta).
"""

from typing import Any

import sympy as sp
from flint import arb

from theory.enclosure import Enclosure
from theory.errors import DomainError
from theory.precision import Real, ball_of, certified

HALVINGS = 60


def half_side(radius: Any, delta: Any) -> Any:
    """Half the side of the largest square that the bound on phi keeps in the disk; sympy.

    >>> half_side(sp.Integer(1), sp.pi / 2)
    sqrt(2)/2
    """
    return radius / (2 * sp.cos(delta / 2))


def squared_length(u: Any, v: Any, angle: Any) -> Any:
    """Square of the length of the segment to (u, v) where phi has one value; sympy."""
    return u**2 + v**2 + 2 * u * v * sp.cos(angle)


def largest_square_of_radius(energy: Any) -> Any:
    """Ball of E (pi - 2 delta) with cot(delta/2) = E, for E >= 1; it grows with E from 0."""
    return energy * (arb.pi() - 4 * (1 / energy).atan())


def least_energy(radius: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Solution E of R^2 = E (pi - 2 delta), a bound of every C^2 immersion from below.

    radius: positive. Raises DomainError.

    >>> least_energy(2, digits=12).decimal(12)
    '2.48368113338'
    """

    def compute() -> Any:
        r = ball_of(radius)
        if not r > 0:
            raise DomainError("the radius must be positive", Enclosure.if_finite(r))
        low, high = arb(1), 2 * r**2 + 2
        for _ in range(HALVINGS + 4 * digits):
            middle = ((low + high) / 2).mid()
            if largest_square_of_radius(middle) < r**2:
                low = middle
            elif largest_square_of_radius(middle) > r**2:
                high = middle
            else:
                break
        return low.union(high)

    return certified(compute, inputs=(radius,), digits=digits, limit=limit)
