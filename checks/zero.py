"""Prove that a sympy expression vanishes identically, by a normal form.

The expression is written as a quotient of polynomials in the free symbols, the unknown functions
and their derivatives, t = tan(x/2) for each angle x, one exponential for each exponent, and one
generator for each square root, whose square is known. A numerator that reduces to 0 is a proof,
valid wherever the expression is defined; anything else proves nothing.
"""

from collections.abc import Callable, Iterable
from math import lcm
from typing import Any

import sympy as sp

_HYPERBOLIC = (sp.sinh, sp.cosh, sp.tanh, sp.sech, sp.csch, sp.coth)
# sin(n x) is of degree 2n in tan(x/2): past this it becomes a generator, its relations forgotten.
_MOST_MULTIPLE = 24
_RECIPROCAL = (sp.tan, sp.cot, sp.sec, sp.csc)


def _ordered(atoms: Iterable[sp.Expr]) -> list[sp.Expr]:
    return sorted(atoms, key=sp.default_sort_key)


def _in_common_units(calls: list[sp.Expr], prefix: str) -> dict[sp.Expr, tuple[sp.Symbol, int]]:
    """Give each call f(q x), q rational, as an integer multiple of one symbol for its x."""
    split = {call: call.args[0].as_coeff_Mul(rational=True) for call in calls}
    bases = _ordered({base for _, base in split.values()})
    units = {
        base: (
            sp.Dummy(f"{prefix}{index}", real=base.is_extended_real or None),
            lcm(*(int(q.q) for q, other in split.values() if other == base)),
        )
        for index, base in enumerate(bases)
    }
    return {call: (units[base][0], int(q * units[base][1])) for call, (q, base) in split.items()}


def _replace_calls(
    expr: sp.Expr, kinds: tuple[type, ...], prefix: str, value: Callable[..., sp.Expr]
) -> sp.Expr:
    """Replace each call of these kinds by value(call, symbol, integer multiple)."""
    while calls := _ordered(c for c in expr.atoms(*kinds) if not c.args[0].has(*kinds)):
        units = _in_common_units(calls, prefix)
        expr = expr.xreplace({c: value(c, symbol, n) for c, (symbol, n) in units.items()})
        prefix += "_"
    return expr


def _half_tangent(call: sp.Expr, t: sp.Symbol, n: int) -> sp.Expr:
    """Sine or cosine of n x through t = tan(x/2)."""
    if abs(n) > _MOST_MULTIPLE:
        return sp.Dummy(str(call), real=t.is_real)
    power = sp.expand((1 + sp.I * t) ** (2 * abs(n)))
    real, imaginary = power.as_real_imag()
    sign = -1 if n < 0 else 1
    top = real if isinstance(call, sp.cos) else sign * imaginary
    return top / (1 + t**2) ** abs(n)


def _exponential(call: sp.Expr, e: sp.Symbol, n: int) -> sp.Expr:
    return e**n


def _elementary(expr: sp.Expr) -> sp.Expr:
    """Leave only sines, cosines and exponentials of single terms."""
    expr = expr.doit().rewrite(_HYPERBOLIC, sp.exp).rewrite(_RECIPROCAL, sp.cos)
    expr = expr.replace(
        lambda e: isinstance(e, sp.sin | sp.cos | sp.exp),
        lambda e: e.func(sp.expand(e.args[0])),
    )
    expr = sp.expand(expr, deep=True, power_exp=True, mul=False, multinomial=False,
                     power_base=False, log=False, basic=False)  # fmt: skip
    sums = {c: sp.expand_trig(c) for c in expr.atoms(sp.sin, sp.cos) if c.args[0].is_Add}
    return expr.xreplace(sums)


def _opaque(expr: sp.Expr) -> sp.Expr:
    """Replace unknown functions and their derivatives, the outermost first, by symbols."""
    calls = _ordered(expr.atoms(sp.Derivative)) + _ordered(
        expr.atoms(sp.core.function.AppliedUndef)
    )
    for index, call in enumerate(calls):
        expr = expr.xreplace({call: sp.Dummy(f"_f{index}", real=True)})
    return expr


def _roots(expr: sp.Expr) -> tuple[sp.Expr, list[tuple[sp.Symbol, sp.Expr]]]:
    """Replace square roots, the innermost first, by symbols; return their radicands too."""
    radicands: list[tuple[sp.Symbol, sp.Expr]] = []
    while powers := _ordered(
        p for p in expr.atoms(sp.Pow) if p.exp.is_Rational and p.exp.q == 2 and not _root(p.base)
    ):
        base = powers[0].base
        known = [s for s, radicand in radicands if radicand == base]
        # A root may be 0, so it is not declared positive: sign(sqrt(x)) is not 1.
        symbol = known[0] if known else sp.Dummy("_r", nonnegative=base.is_extended_real or None)
        if not known:
            radicands.append((symbol, base))
        expr = expr.xreplace({p: symbol ** (2 * p.exp) for p in powers if p.base == base})
    return expr, radicands


def _root(expr: sp.Expr) -> bool:
    return any(p.exp.is_Rational and not p.exp.is_Integer for p in expr.atoms(sp.Pow))


def _numerator(expr: sp.Expr) -> sp.Expr:
    return sp.expand(sp.fraction(sp.together(expr))[0])


def _reduce(expr: sp.Expr, radicands: list[tuple[sp.Symbol, sp.Expr]]) -> sp.Expr:
    """Numerator of expr, of degree at most one in each root: vanishing is then a proof."""
    top = _numerator(expr)
    for symbol, radicand in reversed(radicands):
        reduced = sum(
            coefficient * radicand ** (power // 2) * symbol ** (power % 2)
            for (power,), coefficient in sp.Poly(top, symbol).terms()
        )
        top = _numerator(reduced)
    return top


def vanishes(expr: Any) -> bool:
    """Return whether the scalar expression reduces to 0: True is a proof, False proves nothing.

    Raises TypeError for what is no scalar expression.
    """
    expr = sp.sympify(expr)
    if not isinstance(expr, sp.Expr) or expr.is_Matrix:
        raise TypeError(f"expected a scalar expression, got {type(expr).__name__}")
    expr = _opaque(_elementary(expr))
    expr = _replace_calls(expr, (sp.sin, sp.cos), "_t", _half_tangent)
    expr = _replace_calls(expr, (sp.exp,), "_e", _exponential)
    expr, radicands = _roots(expr)
    try:
        return bool(_reduce(expr, radicands) == 0)
    except sp.PolynomialError:  # a root inside a logarithm, say
        return False
