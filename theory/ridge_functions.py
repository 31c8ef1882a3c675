"""Sums of powers |a u + b v|^p: functions of two variables whose derivatives lose continuity.

Along a line a u + b v = 0 such a term has the continuous derivatives that its power allows, and no
more; terms of a sum lie on different lines, so that none repairs another.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import sympy as sp


@dataclass(frozen=True, kw_only=True)
class Ridge:
    """Function coefficient |s|^power sgn(s)^odd of s = u direction[0] + v direction[1]."""

    coefficient: sp.Rational
    direction: tuple[int, int]
    power: sp.Rational
    odd: bool = False


Ridges = Sequence[Ridge]


def derivative(term: Ridge, axis: int) -> Ridge:
    """Partial derivative in u (axis 0) or v (axis 1), off the line s = 0."""
    slope = term.coefficient * term.power * term.direction[axis]
    return replace(term, coefficient=slope, power=term.power - 1, odd=not term.odd)


def is_continuous(term: Ridge) -> bool:
    """Whether the term, with its limits on the line s = 0, is continuous."""
    return bool(term.coefficient == 0 or term.power > 0 or (term.power == 0 and not term.odd))


def _axes_continuous(terms: Ridges, axes: Sequence[int]) -> bool:
    for axis in axes:
        terms = [derivative(term, axis) for term in terms]
        if not all(is_continuous(term) for term in terms):
            return False
    return True


def is_c1(terms: Ridges) -> bool:
    """Whether both first derivatives are continuous."""
    return all(_axes_continuous(terms, [axis]) for axis in (0, 1))


def has_continuous_mixed(terms: Ridges) -> bool:
    """Whether the derivative in u and v is continuous, and the same in either order.

    Taken off the lines: whether the first derivatives are continuous is a question of its own.
    """
    orders = [[derivative(derivative(t, a), b) for t in terms] for a, b in ((0, 1), (1, 0))]
    return orders[0] == orders[1] and all(is_continuous(term) for term in orders[0])


def has_second(terms: Ridges, axis: int) -> bool:
    """Whether the second derivative along one axis is continuous."""
    return _axes_continuous(terms, (axis, axis))


def pulled_back(terms: Ridges, images: tuple[tuple[int, int], tuple[int, int]]) -> list[Ridge]:
    """Terms after the linear substitution u = images[0] . (r, s), v = images[1] . (r, s)."""
    return [
        replace(
            term,
            direction=(
                term.direction[0] * images[0][0] + term.direction[1] * images[1][0],
                term.direction[0] * images[0][1] + term.direction[1] * images[1][1],
            ),
        )
        for term in terms
    ]
