"""Four vectors known by their inner products only, for identities that need no coordinates."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations_with_replacement
from typing import Any

import sympy as sp

NAMES = ("0", "1", "2", "12")
#: Linear combination of N_0, N_1, N_2, N_12: name to coefficient.
Combination = Mapping[str, Any]

COSINE, P, Q = sp.symbols("c p q", real=True)


def vector(name: str) -> dict[str, Any]:
    """One of the four vectors as a combination."""
    return {name: sp.Integer(1)}


def plus(*terms: tuple[Any, Combination]) -> dict[str, Any]:
    """Sum of multiples of combinations."""
    found: dict[str, Any] = {}
    for factor, term in terms:
        for name, value in term.items():
            found[name] = found.get(name, 0) + factor * value
    return found


@dataclass(frozen=True, kw_only=True)
class Gram:
    """Inner products of N_0, N_1, N_2 and N_12; products: of each pair of names, sorted."""

    products: Mapping[tuple[str, str], Any]

    def inner(self, a: Combination, b: Combination) -> Any:
        """Inner product of two combinations."""
        total = sp.Integer(0)
        for one, x in a.items():
            for other, y in b.items():
                pair = (one, other) if NAMES.index(one) <= NAMES.index(other) else (other, one)
                total += x * y * self.products[pair]
        return sp.expand(total)

    def determinant(self) -> Any:
        """Determinant of the Gram matrix, which vanishes for four vectors of R^3."""
        rows = [[self.inner(vector(a), vector(b)) for b in NAMES] for a in NAMES]
        return sp.expand(sp.Matrix(rows).det(method="berkowitz"))


def general() -> Gram:
    """Four vectors of any lengths: ten free inner products."""
    return Gram(
        products={
            pair: sp.Symbol(f"g_{pair[0]}_{pair[1]}", real=True)
            for pair in combinations_with_replacement(NAMES, 2)
        }
    )


def rhombus(*, longer: Any = 0) -> Gram:
    """Unit vectors with <N_0, N_1> = <N_0, N_2> = <N_12, N_1> = <N_12, N_2> = c.

    The diagonals p = <N_0, N_12> and q = <N_1, N_2> are free; longer: what is added to
    <N_0, N_2> and <N_12, N_1>, so that the quad is a Chebyshev quad and no rhombus.
    """
    other = COSINE + longer
    products = {(name, name): sp.Integer(1) for name in NAMES} | {
        ("0", "1"): COSINE,
        ("0", "2"): other,
        ("1", "12"): other,
        ("2", "12"): COSINE,
        ("0", "12"): P,
        ("1", "2"): Q,
    }
    return Gram(products=products)
