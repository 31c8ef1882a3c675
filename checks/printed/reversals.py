"""Reversals of hyperbolic Chebyshev nets as printed (section 4.1, reversal)."""

from collections.abc import Mapping, Sequence
from math import prod
from typing import Any

from checks.printed.poincare_disk import Pair, moebius

#: Neighbours of a node: (p, 0) along the u-line, (0, q) along the v-line, p, q = +-1.
Star = Mapping[tuple[int, int], Pair]
QUADS = ((1, 1), (1, -1), (-1, 1), (-1, -1))


def oriented(a: Pair, b: Pair, *, omega: int = 1) -> Any:
    """Orientation of two vectors at the origin, as the area form of that sign."""
    return omega * (a[0] * b[1] - a[1] * b[0])


def orientations(
    centre: Pair, star: Star, *, omega: int = 1, quads: int = 4, moved: bool = True
) -> list[Any]:
    """Factors of the product (reversal), in the order of QUADS; quads: how many are taken.

    moved: whether the neighbours are moved by f(.; -centre), or the differences taken as they are.
    """
    away = (-centre[0], -centre[1])

    def vector(at: tuple[int, int]) -> Pair:
        z = star[at]
        return moebius(z, away) if moved else (z[0] - centre[0], z[1] - centre[1])

    return [oriented(vector((p, 0)), vector((0, q)), omega=omega) for p, q in QUADS[:quads]]


def is_reversal(factors: Sequence[Any], *, strict: bool = False, form: str = "product") -> bool:
    """Whether there is a reversal at a node with these factors (reversal).

    strict: `<` for `<=`; form: the `product` as printed, their `sum`, or `unequal` for the reading
    that two of the quads are oriented against each other or one has collapsed.
    """
    if form == "unequal":
        signs = {p * q * _sign(x) for (p, q), x in zip(QUADS, factors, strict=True)}
        return len(signs) > 1 or 0 in signs
    value = prod(factors) if form == "product" else sum(factors)
    return bool(value < 0) if strict else bool(value <= 0)


def _sign(x: Any) -> int:
    return int(x > 0) - int(x < 0)
