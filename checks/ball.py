"""Evaluate a sympy expression at a rational point in ball arithmetic."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from random import Random
from typing import Any

import sympy as sp
from flint import arb, ctx, fmpq

_FUNCTIONS: dict[Any, Callable[[arb], arb]] = {
    sp.sin: arb.sin, sp.cos: arb.cos, sp.tan: arb.tan, sp.cot: arb.cot,
    sp.sec: arb.sec, sp.csc: arb.csc, sp.exp: arb.exp, sp.log: arb.log,
    sp.sinh: arb.sinh, sp.cosh: arb.cosh, sp.tanh: arb.tanh, sp.coth: arb.coth,
    sp.sech: arb.sech, sp.csch: arb.csch, sp.asin: arb.asin, sp.acos: arb.acos,
    sp.atan: arb.atan, sp.asinh: arb.asinh, sp.acosh: arb.acosh, sp.atanh: arb.atanh,
    sp.Abs: abs,
}  # fmt: skip

Point = Mapping[sp.Expr, sp.Rational]


class NoBallError(TypeError):
    """An expression holds something of which there is no ball version."""


def _power(base: arb, exponent: sp.Expr, point: Point) -> arb:
    if exponent.is_Integer:
        return base ** int(exponent)
    if exponent.is_Rational and exponent.q == 2:
        return base.sqrt() ** int(exponent.p)
    return base ** enclosure(exponent, point)


def enclosure(expr: sp.Expr, point: Point) -> arb:
    """Ball that contains the value of expr at the point, at the precision in force.

    Symbols, and unknown functions with their derivatives, take their value from the point.
    Raises KeyError for one that has none, NoBallError for a function without a ball version.
    """
    if expr in point:
        return enclosure(point[expr], {})
    if expr.is_Rational:
        return arb(fmpq(int(expr.p), int(expr.q)))
    if expr is sp.pi:
        return arb.pi()
    if expr is sp.E:
        return arb(1).exp()
    if expr.is_Symbol or isinstance(expr, sp.Derivative | sp.core.function.AppliedUndef):
        raise KeyError(f"no value for {expr}")
    if expr.is_Pow:
        return _power(enclosure(expr.base, point), expr.exp, point)
    parts = [enclosure(argument, point) for argument in expr.args]
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


def _ordered(expressions: Iterable[sp.Expr]) -> list[sp.Expr]:
    return sorted(expressions, key=lambda e: (str(e), sp.default_sort_key(e)))


def unknowns(expr: sp.Expr) -> list[sp.Expr]:
    """Free symbols, unknown functions and derivatives that a point must give a value."""
    calls = expr.atoms(sp.Derivative) | expr.atoms(sp.core.function.AppliedUndef)
    inside = set().union(*(call.free_symbols for call in calls)) if calls else set()
    # A derivative holds its function: the derivatives go first. Dummies keep what multiplies them.
    ordered = sorted(calls, key=lambda call: (not isinstance(call, sp.Derivative), str(call)))
    dummies = {call: sp.Dummy() for call in ordered}
    bare = expr
    for call in ordered:
        bare = bare.xreplace({call: dummies[call]})
    symbols = (bare.free_symbols - set(dummies.values())) | inside
    return _ordered(calls) + _ordered(symbols)


def random_point(symbols: list[sp.Expr], rng: Random) -> dict[sp.Expr, sp.Rational]:
    """Random rational values in (0, 2) as the symbols' assumptions allow, else of either sign."""
    values = {}
    for s in symbols:
        whole = s.is_integer
        q = sp.Rational(rng.randint(1, 13), 1 if whole else rng.randint(7, 13))
        flip = rng.random() < 0.5
        if s.is_extended_nonpositive or (flip and not s.is_extended_nonnegative):
            q = -q
        values[s] = q
    return values


def _consistent(symbols: list[sp.Expr], point: Point) -> bool:
    """Whether calls of one unknown function have certainly different arguments at the point.

    Only then may their values be chosen independently: f(x^2 - 1) is f((x - 1)(x + 1)).
    """
    calls = [s for s in symbols if isinstance(s, sp.core.function.AppliedUndef)]
    return all(
        one.func != other.func
        or any(enclosure(a - b, point) != 0 for a, b in zip(one.args, other.args, strict=True))
        for n, one in enumerate(calls)
        for other in calls[:n]
    )


def nonzero_point(
    expr: sp.Expr,
    rng: Random,
    *,
    where: Sequence[sp.Expr] = (),
    tries: int = 40,
    bits: int = 128,
) -> tuple[dict[sp.Expr, sp.Rational], str] | None:
    """Rational point where expr is certainly not 0 and its value there as text, if one is found.

    where: expressions that are positive under the hypotheses, so that the point meets them.
    """
    symbols = unknowns(sp.Tuple(expr, *where))
    for _ in range(tries):
        point = random_point(symbols, rng)
        try:
            with ctx.workprec(bits):
                value = enclosure(expr, point)
                if not (value.is_finite() and value != 0 and _consistent(symbols, point)):
                    continue
                if all(enclosure(condition, point) > 0 for condition in where):
                    return point, value.str(8, radius=False)
        except NoBallError:
            return None
    return None
