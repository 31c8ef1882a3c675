"""Sizes of trees in which every node of a generation has the same number of daughters."""

from typing import Any

import sympy as sp


def nodes(daughters: int, generations: Any, first: Any = 1) -> Any:
    """Nodes in all generations, `first` in the first, each with this many daughters.

    generations: a natural number or a symbol for one.
    """
    k = sp.Symbol("k", integer=True, nonnegative=True)
    total = sp.summation(sp.Integer(daughters) ** k, (k, 0, generations - 1))
    return sp.simplify(first * total)


def rate(daughters: int) -> Any:
    """Limit of log(nodes)/generations, as the number of generations grows."""
    n = sp.Symbol("n", integer=True, positive=True)
    return sp.limit(sp.log(nodes(daughters, n)) / n, n, sp.oo)
