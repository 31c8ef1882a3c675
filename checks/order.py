"""Order to which an analytic expression vanishes, decided exactly derivative by derivative."""

from random import Random

import sympy as sp

from checks.ball import nonzero_point
from checks.zero import vanishes


def order_of_zero(expr: sp.Expr, variable: sp.Symbol, at: sp.Expr, *, most: int = 6) -> int:
    """Order to which an analytic expression vanishes at a value of the variable.

    Raises ValueError where it is not certain, or higher than most.
    """
    for order in range(most):
        value = expr.subs(variable, at)
        if not vanishes(value):
            if nonzero_point(value, Random(0)) is None:
                raise ValueError(f"neither 0 nor certainly nonzero: {value}")
            return order
        expr = sp.diff(expr, variable)
    raise ValueError(f"vanishes to an order above {most}")
