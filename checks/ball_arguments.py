"""Evaluate a sympy expression where its symbols are balls, such as arcs of a curve."""

from collections.abc import Mapping

import sympy as sp
from flint import arb

from checks.ball import NoBallError, enclosure

_FUNCTIONS = {
    sp.sin: arb.sin, sp.cos: arb.cos, sp.exp: arb.exp,
    sp.sinh: arb.sinh, sp.cosh: arb.cosh, sp.tanh: arb.tanh, sp.sech: arb.sech,
}  # fmt: skip


def value_on(expr: sp.Expr, balls: Mapping[sp.Expr, arb]) -> arb:
    """Ball that contains expr at every point of the balls that its symbols are given.

    Raises KeyError for a symbol without a ball, NoBallError for an unforeseen function.
    """
    if expr in balls:
        return balls[expr]
    if not expr.free_symbols:
        return enclosure(expr, {})
    if expr.is_Symbol:
        raise KeyError(f"no ball for {expr}")
    if expr.is_Pow and expr.exp.is_Integer:
        return value_on(expr.base, balls) ** int(expr.exp)
    parts = [value_on(argument, balls) for argument in expr.args]
    if expr.is_Add:
        return sum(parts, arb(0))
    if expr.is_Mul:
        product = arb(1)
        for part in parts:
            product *= part
        return product
    if expr.func in _FUNCTIONS:
        return _FUNCTIONS[expr.func](*parts)
    raise NoBallError(f"no ball version of {expr.func.__name__}")
