"""Power series with a proved remainder, from a bound of the function on a complex disk.

Cauchy: where f is analytic on |t| <= r and |f| <= B there (or |f - f(0)| <= B), its coefficients
obey |a_k| <= B r^-k (for k >= 1), so that what follows the first n terms is at most
B q^n / (1 - q) with q = |t|/r < 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import log
from typing import Any

from flint import arb, arb_poly, ctx

from theory.errors import UndecidedError


def geometric_tail(bound: Any, ratio: Any, order: int) -> Any:
    """Bound B q^n / (1 - q) on the terms from order n of a series with |a_k| r^k <= B."""
    if not ratio < 1:
        raise UndecidedError("the argument is not certainly inside the disk")
    return bound * ratio**order / (1 - ratio)


def symmetric(bound: Any) -> Any:
    """Ball of this radius about 0."""
    return arb(0, abs(bound).upper())


@dataclass(frozen=True, kw_only=True)
class BoundedSeries:
    """Function sum a_k t^k on |t| < radius: terms[k] = a_k radius^k, and bound >= the others'.

    radius, bound: exact balls; at least the first term is there if bound is one of |f - f(0)|.
    """

    terms: tuple[Any, ...]
    radius: Any
    bound: Any

    def __call__(self, t: Any) -> Any:
        """Ball around the value at the ball t."""
        return self._own(t / self.radius) + self._tail(t)

    @cached_property
    def _own(self) -> Any:
        return arb_poly(list(self.terms))

    def integral(self, t: Any) -> Any:
        """Ball around the integral from 0 to t."""
        terms = tuple(a / (k + 1) for k, a in enumerate(self.terms))
        return t * (arb_poly(list(terms))(t / self.radius) + self._tail(t))

    def integral_by_root(self, t: Any) -> Any:
        """Ball around the integral of f(t) dt/sqrt(t) from 0 to t > 0."""
        terms = tuple(a / (2 * k + 1) for k, a in enumerate(self.terms))
        return 2 * t.sqrt() * (arb_poly(list(terms))(t / self.radius) + self._tail(t))

    def truncated(self, order: int) -> BoundedSeries:
        """Series of the same function with fewer terms kept."""
        return BoundedSeries(terms=self.terms[:order], radius=self.radius, bound=self.bound)

    def _tail(self, t: Any) -> Any:
        """Ball about 0 that holds the rest; what is integrated is divided by more than 1."""
        ratio = arb((abs(t) / self.radius).upper())
        return symmetric(geometric_tail(self.bound, ratio, len(self.terms)))


def terms_needed(bound: Any, scale: Any, ratio: Any) -> int:
    """Order at which the tail is about 2^-prec of scale > 0, at least 2."""
    size, rate = (bound / scale).log(), -ratio.log()
    if not (size.is_finite() and rate > 0):
        raise UndecidedError("no finite bound on the series")
    return max(2, int((ctx.prec * log(2) + max(float(size.mid()), 0.0)) / float(rate.mid())) + 2)
