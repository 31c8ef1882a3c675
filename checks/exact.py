"""Evidence from exact identities: proved by a normal form, or refuted at a rational point."""

from collections.abc import Mapping, Sequence
from functools import partial
from random import Random
from typing import Any

import sympy as sp

from checks.ball import nonzero_point
from checks.evidence import Evidence, Setting, weaker
from checks.zero import vanishes

# A point tried before the proof: a false identity is refuted there at a hundredth of the cost.
_FIRST_TRIES = 2


def _scalars(name: str, value: Any) -> list[tuple[str, sp.Expr]]:
    """Entries of the value by name, with every derivative that can be carried out done."""
    if isinstance(value, sp.MatrixBase | list | tuple):
        return [(f"{name}[{i}]", sp.sympify(entry).doit()) for i, entry in enumerate(value)]
    return [(name, sp.sympify(value).doit())]


def _refutation(
    name: str, expr: sp.Expr, rng: Random, where: Sequence[sp.Expr], *, tries: int = 40
) -> str:
    """Say where expr is not 0, in rational numbers; empty where no such point was found."""
    if expr.is_Rational:
        return "" if expr == 0 else f"{name}: left minus right is {expr}"
    found = nonzero_point(expr, rng, where=where, tries=tries)
    if found is None:
        return ""
    point, value = found
    at = ", ".join(f"{symbol} = {number}" for symbol, number in point.items())
    return f"{name}: left minus right is {value}" + (f" at {at}" if at else "")


def identities(
    setting: Setting,
    residuals: Mapping[str, Any],
    *,
    shown: str,
    where: Sequence[sp.Expr] = (),
) -> Evidence:
    """Evidence that every residual (left side minus right side) vanishes identically.

    residuals: name to scalar, tuple or matrix of sympy expressions, all parts real; where: what the
    hypotheses make positive. A false residual is refuted by a ball at a rational point that meets
    them; undecided where neither proof nor refutation is found. Raises ValueError if one is empty.
    """
    if not residuals:
        raise ValueError("no residual given: nothing to prove")
    if any(isinstance(value, list | tuple) and not value for value in residuals.values()):
        raise ValueError("a residual without entries: nothing to prove")
    rng = setting.random()
    scalars = [pair for name, value in residuals.items() for pair in _scalars(name, value)]
    found = partial(Evidence, grade="exact", tried=len(scalars), met=len(scalars))
    for name, expr in scalars:
        if witness := _refutation(name, expr, rng, where, tries=_FIRST_TRIES):
            return found(outcome="fail", witness=witness, shown=shown)
    open_names = []
    for name, expr in scalars:
        if vanishes(expr):
            continue
        if witness := _refutation(name, expr, rng, where):
            return found(outcome="fail", witness=witness, shown=shown)
        open_names.append(name)
    if open_names:
        undecided = f"not decided: {', '.join(open_names)}"
        return found(outcome="undecided", shown=undecided)
    return found(outcome="pass", residual="0", shown=shown)


def statement(true: bool, *, shown: str, witness: str) -> Evidence:
    """Evidence from one exactly decided proposition; witness says what refutes it."""
    # Equality, for sympy's true is no bool; an undecided relation equals neither.
    if true not in (True, False):
        raise TypeError(f"expected True or False, got {type(true).__name__}")
    if true:
        return Evidence(outcome="pass", grade="exact", residual="0", shown=shown)
    return Evidence(outcome="fail", grade="exact", witness=witness, shown=shown)


def combined(parts: Mapping[str, Evidence], *, shown: str) -> Evidence:
    """One piece of evidence from several: the first failure, else undecided, else all pass.

    The grade is the weakest among the parts. Raises ValueError if there are no parts.
    """
    if not parts:
        raise ValueError("no parts given: nothing to combine")
    grade = next(iter(parts.values())).grade
    for part in parts.values():
        grade = weaker(grade, part.grade)
    tried, met = sum(p.tried for p in parts.values()), sum(p.met for p in parts.values())
    for name, part in parts.items():
        if part.outcome == "fail":
            return Evidence(outcome="fail", grade=part.grade, witness=f"{name}: {part.witness}",
                            tried=tried, met=met, shown=shown)  # fmt: skip
    undecided = [name for name, part in parts.items() if part.outcome == "undecided"]
    if undecided:
        return Evidence(outcome="undecided", grade=grade, tried=tried, met=met,
                        shown=f"not decided: {', '.join(undecided)}")  # fmt: skip
    return Evidence(outcome="pass", grade=grade, residual="0" if grade == "exact" else "",
                    tried=tried, met=met, shown=shown)  # fmt: skip
