r"""sin t/t and the quotients that are left of it when exact zeros are divided out, by balls.

With w = t^2 these are entire functions of w:

    S(w) = sin t/t,  T(w) = (1 - S(w))/w,  D(w, v) = (S(v) - S(w))/(w - v),  D(w, w) = -S'(w).

Their series are cut where each further term is, on |w| <= 20, less than half of the one before it;
every value carries the bound on what is left out.
"""

from __future__ import annotations

from math import factorial
from typing import Any

from flint import arb, arb_poly

from theory.bounded_series import symmetric
from theory.enclosure import Enclosure
from theory.errors import DomainError

LARGEST_SQUARE = 20
#: 20^24/49! < 2^-104: what is left out does not count beside the width of the balls used.
TERMS = 24


def sinc(w: Any) -> Any:
    """Ball around S(w) for a ball |w| <= 20 (eq:defC). Raises DomainError."""
    return _value([_sign(k) / factorial(2 * k + 1) for k in range(TERMS)], w)


def sinc_defect(w: Any) -> Any:
    """Ball around T(w) = (1 - S(w))/w for a ball |w| <= 20. Raises DomainError."""
    return _value([_sign(k) / factorial(2 * k + 3) for k in range(TERMS)], w)


def sinc_fall(w: Any) -> Any:
    """Ball around -S'(w) for a ball |w| <= 20. Raises DomainError."""
    return _value([_sign(k) * (k + 1) / factorial(2 * k + 3) for k in range(TERMS)], w)


def sinc_quotient(w: Any, v: Any) -> Any:
    """Ball around D(w, v) = (S(v) - S(w))/(w - v), also where w and v overlap.

    It is the mean of -S' between v and w. -S' falls on [-1, 20], as S'' = j_2(t)/(4 t^2) for the
    spherical Bessel function j_2, which is positive up to its first zero t = 5.76 (and S'' has
    positive terms for w < 0). So D lies between the values of -S' at the two ends. Raises
    DomainError outside [-1, 20].
    """
    ends = sinc_fall(arb(w.lower())).union(sinc_fall(arb(w.upper())))
    ends = ends.union(sinc_fall(arb(v.lower()))).union(sinc_fall(arb(v.upper())))
    if w - v > 1:
        direct = (sinc(v) - sinc(w)) / (w - v)
        return direct if direct.rad() < ends.rad() else ends
    return ends


def _sign(k: int) -> Any:
    return arb(-1 if k % 2 else 1)


def _value(terms: list[Any], w: Any) -> Any:
    """Value of the series at w; each term left out is less than half of the one before it."""
    if not abs(w) <= LARGEST_SQUARE:
        raise DomainError(f"the square must not exceed {LARGEST_SQUARE}", Enclosure.if_finite(w))
    rest = 2 * abs(w) ** TERMS / factorial(2 * TERMS + 1)
    return arb_poly(terms)(w) + symmetric(rest)
