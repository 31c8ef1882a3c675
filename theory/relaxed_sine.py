"""Sine and cosine of a power series whose coefficients are found one after another.

From S' = C F' and C' = -S F': k s_k = sum (j + 1) a_(j+1) c_(k-1-j), and likewise for c_k. Such
products are relaxed (van der Hoeven): the square of index pairs is cut into blocks, each multiplied
as soon as its coefficients are there, so that fast polynomial multiplication serves.
"""

from __future__ import annotations

from collections.abc import Callable
from operator import mul
from typing import Any

from flint import arb, arb_poly

Balls = list[Any]
#: Appends the next coefficient to the list, given that list and the s_0, ..., s_k known so far.
Recurrence = Callable[[Balls, Balls], None]

BLOCK = 32


def solve(start: Balls, order: int, recurrence: Recurrence) -> Balls:
    """Coefficients a_0, ..., a_(order-1) of F, each new one from those of sin F known so far.

    start: the coefficients given as data, at least a_0. After s_k is known, recurrence must append
    a_(k+1) if it is not there yet.
    """
    unknown = _Relaxed(start, order, recurrence)
    unknown.fill(0, 1 << max(order - 1, BLOCK).bit_length())
    return unknown.a[:order]


class _Relaxed:
    """State of one relaxed solution: a of F, d of F', s and c of sin F and cos F."""

    def __init__(self, start: Balls, order: int, recurrence: Recurrence) -> None:
        self.a, self.order, self.recurrence = list(start), order, recurrence
        sine, cosine = start[0].sin_cos()
        self.d: Balls = []
        self.s, self.c = [sine], [cosine]
        self.with_c, self.with_s = ([arb(0)] * order for _ in range(2))

    def fill(self, low: int, high: int) -> None:
        """Find the coefficients low, ..., high - 1, those before being known."""
        if low >= self.order:
            return
        if high - low <= BLOCK:
            for k in range(low, min(high, self.order)):
                self._find(k, low)
            return
        middle = (low + high) // 2
        self.fill(low, middle)
        if middle < self.order:
            self._multiply_block(low, middle, min(high, self.order))
            self.fill(middle, high)

    def _find(self, k: int, low: int) -> None:
        """Find s_k, c_k, then the coefficient of F, with what no block has added to their sums."""
        if k:
            with_c = self.with_c[k] + _remaining(self.d, self.c, k, low)
            with_s = self.with_s[k] + _remaining(self.d, self.s, k, low)
            self.s.append(with_c / k)
            self.c.append(-with_s / k)
        self.recurrence(self.a, self.s)
        self.d.append((k + 1) * self.a[k + 1])

    def _multiply_block(self, low: int, middle: int, high: int) -> None:
        """Add to the sums of middle, ..., high - 1 what the coefficients before middle give."""
        for other, sums in ((self.c, self.with_c), (self.s, self.with_s)):
            product = _product(self.d[low:middle], other[: high - low])
            if low:
                product += _product(other[low:middle], self.d[: high - low])
            first = middle - low - 1
            for offset, term in enumerate(product.coeffs()[first : high - low - 1]):
                sums[middle + offset] += term


def _product(first: Balls, second: Balls) -> Any:
    return arb_poly(first) * arb_poly(second)


def _remaining(d: Balls, other: Balls, k: int, low: int) -> Any:
    """Sum of d_i other_(k-1-i) over the pairs with an index in low, ..., k - 1."""
    found = sum(map(mul, d[low:k], other[k - 1 - low :: -1] if low else reversed(other)), arb(0))
    if low:
        found += sum(map(mul, other[low:k], d[k - 1 - low :: -1]), arb(0))
    return found
