r"""Certified values of Minding's bobbin in elliptic functions (ex:bobbin, eq:econs, eq:c2energy).

The arc length s from the throat obeys s'^2 = (kappa^2 - sinh^2 s)/(kappa^2 + 1) in xi = u + v, with
s(0) = 0 and s'(0) > 0 here. Put sinh s = kappa sin psi. Then

    psi'^2 = (1 + kappa^2 sin^2 psi)/(1 + kappa^2),

and with psi = a - pi/2, k^2 = kappa^2/(kappa^2 + 1), a'^2 = 1 - k^2 sin^2 a: the amplitude
a = am(xi + K, k), so that sinh s = -kappa cn(xi + K) and z' = (kappa^2 - sinh^2 s)/(kappa
sqrt(kappa^2 + 1)) = k sin^2 a. The period is 4 K; s turns at the odd multiples of K.
Real arguments and the keywords digits and limit are those of theory.painleve.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import acb, arb

from theory.enclosure import Enclosure
from theory.errors import DomainError, UndecidedError
from theory.precision import Real, ball_of, certified

LARGEST_KAPPA = 10**100


def arc_length(kappa: Real, xi: Real, *, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Signed arc length s(xi) from the throat along a meridian.

    >>> arc_length(1, 1, digits=20).decimal(20)
    ''
    """

    def compute() -> Any:
        throat, place = positive(kappa), ball_of(xi)
        return arb(0) if place == 0 else _sinh_of_arc(throat, place).asinh()

    return certified(compute, inputs=(kappa, xi), digits=digits, limit=limit)
