"""Logarithmic growth of I_0, by balls on whole ranges (rem:amsler_scaling).

x I_0'(x)/I_0(x) = x I_1/I_0 = (x^2/2) f'(w)/f(w) with f(w) = sum w^k/k!^2 and w = x^2/4. It grows
with x > 0, as its derivative is x (1 - (I_1/I_0)^2) and 0 < I_1 < I_0.
"""

from collections.abc import Callable
from typing import Any

import sympy as sp
from flint import arb

from theory.errors import UndecidedError

FINEST_CELL = 2.0**-30
PROBES = 16


def ratio(w: Any) -> Any:
    """Ball of I_1(x)/(x I_0(x)/2) by w = x^2/4 >= 0, which is 1 at 0."""
    return w.hypgeom_0f1(2) / w.hypgeom_0f1(1)


def rate_of_growth() -> Any:
    """Derivative of x I_1/I_0 by I_0' = I_1 and I_1' = I_0 - I_1/x, in `symbols`."""
    x = sp.Symbol("x", positive=True)
    i0, i1 = sp.Function("I0")(x), sp.Function("I1")(x)
    rate = sp.diff(x * i1 / i0, x).subs({sp.diff(i0, x): i1, sp.diff(i1, x): i0 - i1 / x})
    zero, one, place = symbols()
    return sp.expand(rate.subs({i0: zero, i1: one, x: place}))


def symbols() -> tuple[sp.Symbol, sp.Symbol, sp.Symbol]:
    """Positive symbols for I_0, I_1 and x."""
    return (
        sp.Symbol("i0", positive=True),
        sp.Symbol("i1", positive=True),
        sp.Symbol("x", positive=True),
    )


def surplus(quotient: Any, s: Any, *, over: Callable[[Any], Any] = ratio) -> Any:
    """Value of (x I_1(x)/I_0(x) - 2 s I_1(s)/I_0(s))/s at x^2 = 2 s quotient, s >= 0.

    With quotient = R/C it has the sign of the derivative of I_0(x)/I_0(C x^2/(2 R)) by x.
    over: `ratio` on balls, or another form of it for other numbers.
    """
    return quotient * over(s * quotient / 2) - s * over(s * s / 4)


def cover(function: Callable[[Any], Any], start: Any, end: Any) -> tuple[list[Any], Any | None]:
    """Cells that cover [start, end], function > 0 on each of them; a place where it is < 0, if any.

    function: of balls. Place None where it is positive throughout. Raises UndecidedError where a
    cell of the least size does not decide.
    """
    last = arb(end)
    for k in range(PROBES + 1):
        probe = (start + (last - start) * k / PROBES).mid()
        if function(probe) < 0:
            return [], probe
    cells, left, width = [], arb(start), (last - start).mid() / 8
    while not left >= last:
        right = (left + width).min(last).mid()
        cell = left.union(right)
        if function(cell) > 0:
            cells.append(cell)
            left, width = right, width * 2
        elif width < FINEST_CELL:
            raise UndecidedError("a cell of the least size has no certain sign")
        else:
            width = width / 4
    return cells, None
