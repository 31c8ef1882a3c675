"""Evidence that expressions are positive wherever their symbols are, by coefficients of one sign.

With e^x = 1 + t for each symbol x in an exponential (t > 0 where x > 0), a quotient of polynomials
whose coefficients are all positive is positive: a proof. A ball that is negative at positive
rational values refutes it, and so does an expression that vanishes.
"""

from collections.abc import Mapping
from functools import cache
from random import Random

import sympy as sp
from flint import arb, ctx

from checks.ball import enclosure
from checks.evidence import Evidence, Setting
from checks.zero import vanishes

_HYPERBOLIC = (sp.sinh, sp.cosh, sp.tanh, sp.sech, sp.csch, sp.coth)


@cache
def _growth(x: sp.Symbol) -> sp.Symbol:
    return sp.Dummy(f"t_{x.name}", positive=True)


def _without_exponentials(expr: sp.Expr) -> sp.Expr:
    """Write each e^(n x), n an integer, as (1 + t)^n with t > 0 where x > 0."""
    expr = sp.expand(expr.rewrite(_HYPERBOLIC, sp.exp), power_exp=True, mul=False)
    calls: dict[sp.Expr, sp.Expr] = {}
    for call in expr.atoms(sp.exp):
        n, x = call.args[0].as_coeff_Mul(rational=True)
        if n.is_Integer and x.is_Symbol:
            calls[call] = (1 + _growth(x)) ** n
    return expr.xreplace(calls)


def _one_sign(polynomial: sp.Expr) -> int:
    """Sign that all coefficients share, 0 if they do not."""
    symbols = sorted(polynomial.free_symbols, key=str)
    coefficients = sp.Poly(polynomial, *symbols).coeffs() if symbols else [polynomial]
    signs = {sp.sign(c) for c in coefficients}
    return int(signs.pop()) if len(signs) == 1 and signs <= {1, -1} else 0


def proved_positive(expr: sp.Expr) -> bool:
    """Whether expr > 0 follows for all positive values of its symbols; False proves nothing."""
    top, bottom = sp.fraction(sp.cancel(sp.together(_without_exponentials(sp.sympify(expr)))))
    try:
        return _one_sign(sp.expand(top)) * _one_sign(sp.expand(bottom)) == 1
    except sp.PolynomialError:
        return False


def _refutation(expr: sp.Expr, rng: Random, *, tries: int = 40, bits: int = 128) -> str:
    """Positive rational values where expr is certainly not positive, as text; else empty."""
    if vanishes(expr):
        return "it vanishes identically"
    symbols = sorted(expr.free_symbols, key=str)
    for _ in range(tries):
        point = {s: sp.Rational(rng.randint(1, 40), rng.randint(7, 13)) for s in symbols}
        with ctx.workprec(bits):
            value: arb = enclosure(expr, point)
            if value.is_finite() and value < 0:
                at = ", ".join(f"{symbol} = {number}" for symbol, number in point.items())
                return f"its value is {value.str(8, radius=False)}" + (f" at {at}" if at else "")
    return ""


def positivity(setting: Setting, claims: Mapping[str, sp.Expr], *, shown: str) -> Evidence:
    """Evidence that every expression is positive for all positive values of its symbols.

    Undecided where neither proof nor refutation was found. Raises ValueError if claims is empty.
    """
    if not claims:
        raise ValueError("no expression given: nothing to prove")
    rng, tried, unproved = setting.random(), len(claims), []
    for name, expr in claims.items():
        if proved_positive(expr):
            continue
        if witness := _refutation(sp.sympify(expr), rng):
            return Evidence(
                outcome="fail",
                grade="exact",
                tried=tried,
                met=tried,
                shown=shown,
                witness=f"{name} is not positive: {witness}",
            )
        unproved.append(name)
    if unproved:
        return Evidence(
            outcome="undecided",
            grade="exact",
            tried=tried,
            met=tried,
            shown=f"not decided: {', '.join(unproved)}",
        )
    return Evidence(
        outcome="pass", grade="exact", residual="0", tried=tried, met=tried, shown=shown
    )
