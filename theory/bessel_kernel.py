r"""Kernel of (x g')' = c g + source on x > 0, and quotients of f(w) = I_0(2 sqrt w).

Here x = z^2/4, f(w) = sum w^k/k!^2, and f(c x) solves the equation without a source. The solution
that is regular at 0 with g(0) = 0 is

    g(x) = integral of k_c(x, y) source(y) dy from 0 to x,
    k_c(x, y) = 2 (I_0(t) K_0(s) - K_0(t) I_0(s)),  t = 2 sqrt(c x),  s = 2 sqrt(c y),

and k_c = sum over i, j of positive terms: it is positive for y < x and grows with c and x.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import factorial
from typing import Any

from flint import arb

from theory.bounded_series import symmetric

SMALL = 2
TERMS = 16


@dataclass(frozen=True, kw_only=True)
class LinearResponse:
    """Solution g at the place z for the source y b(y), b a step function from 0 to z.

    c: exact ball > 0; with_k, with_i: integrals of y b(y) K_0(s) dy and y b(y) I_0(s) dy so far.
    """

    c: Any
    z: Any
    with_k: Any
    with_i: Any

    @classmethod
    def at_origin(cls, c: Any) -> LinearResponse:
        """Response at z = 0."""
        return cls(c=c, z=arb(0), with_k=arb(0), with_i=arb(0))

    def advanced(self, z: Any, height: Any) -> LinearResponse:
        """Response at the larger z, where b = height from self.z to z; both exact.

        By parts, s^3 K_0 integrates to -(s^3 K_1 + 2 s^2 K_2) and s^3 I_0 to s^3 I_1 - 2 s^2 I_2,
        and y dy = s^3 ds/(8 c^2).
        """
        old, new, scale = self._argument(self.z), self._argument(z), height / (8 * self.c**2)
        return LinearResponse(
            c=self.c,
            z=z,
            with_k=self.with_k + scale * (_k_part(old) - _k_part(new)),
            with_i=self.with_i + scale * (_i_part(new) - _i_part(old)),
        )

    def value(self) -> Any:
        """Ball around g at z > 0."""
        t = self._argument(self.z)
        return 2 * (t.bessel_i(0) * self.with_k - t.bessel_k(0) * self.with_i)

    def _argument(self, z: Any) -> Any:
        return z * self.c.sqrt()


def _k_part(s: Any) -> Any:
    return arb(4) if s == 0 else s**3 * s.bessel_k(1) + 2 * s**2 * s.bessel_k(2)


def _i_part(s: Any) -> Any:
    return s**3 * s.bessel_i(1) - 2 * s**2 * s.bessel_i(2)


def unit_response(w: Any) -> Any:
    """Ball around (f(w) - 1 - w)/w^2 = sum w^k/(k + 2)!^2, for exact w >= 0.

    x^2 times its value at c x is the response to the source y, b = 1.
    """
    if w > SMALL:
        return (w.hypgeom_0f1(1) - 1 - w) / w**2
    terms = [w**k / factorial(k + 2) ** 2 for k in range(TERMS)]
    # Each term left out is less than half of the one before it.
    return sum(terms, arb(0)) + symmetric(2 * w**TERMS / factorial(TERMS + 2) ** 2)


def quotient_from_below(upper: Any, lower: Any) -> Any:
    """Lower bound of (f(upper) - f(lower))/(upper - lower) for exact upper > lower >= 0.

    f' is convex there, so that its mean is at least its value at the midpoint; where the
    difference is large the quotient itself is sharper.
    """
    middle = ((upper + lower) / 2).hypgeom_0f1(2).lower()
    if upper - lower > 1:
        direct = (upper.hypgeom_0f1(1) - lower.hypgeom_0f1(1)) / (upper - lower)
        return middle.max(direct.lower())
    return middle
