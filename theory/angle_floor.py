"""How low an angle falls that loses at most a factor at a cut and stops falling when small.

The angle is phi*/I_0(X). A cut multiplies it by at least max(1/q, X^2/Y^2): below the threshold
phi*/I_0(Y) it does not fall. From above, the lowest place that one cut can reach stays above the
threshold iff I_0(X) <= I_0(Y) max(1/q, X^2/Y^2) on 0 <= X <= Y. I_0(X)/X^2 = sum (X^2)^(k-1)/(4^k
k!^2) is convex in X^2 (each term is), so that only the ends X^2 = Y^2/q and Y^2 of its range count:
the condition is I_0(Y) >= q I_0(Y/sqrt(q)). In w = Y^2/4 the difference is

    1 - q + sum over k >= 2 of (1 - q^(1-k)) w^k/k!^2,

negative at 0 and increasing: it has one zero w_0 > 0, and the condition is w >= w_0.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from flint import arb
from mpmath import mp

from theory import bessel, bessel_reference
from theory.enclosure import Enclosure
from theory.interval_newton import root
from theory.precision import certified

DROP = 3
MOST_W = 16


def coefficient(k: int, drop: Fraction, scale: Fraction) -> Fraction:
    """Coefficient of w^k/k!^2 in I_0(2 sqrt w) - drop I_0(2 sqrt(w/scale))."""
    return 1 - drop / scale**k


def excess(w: Any, *, drop: Any = DROP, scale: Any = DROP) -> Any:
    """Ball of I_0(2 sqrt w) - drop I_0(2 sqrt(w/scale)) at a ball w >= 0."""
    return w.hypgeom_0f1(1) - drop * (w / scale).hypgeom_0f1(1)


def least_w(*, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Zero w_0 of the excess for q = 3, certified by interval Newton."""
    return certified(_least_w, digits=digits, limit=limit)


def least_radius(*, digits: int = 15, limit: int | None = None) -> Enclosure:
    """Least R from which no angle falls below phi*/I_0(2 alpha* sqrt R): w_0/alpha*^2."""

    def compute() -> Any:
        return _least_w() / bessel.supporting_scale(digits=digits + 10).ball() ** 2

    return certified(compute, digits=digits, limit=limit)


def least_radius_reference(*, digits: int = 25) -> Any:
    """The same radius by mpmath's secant method on I_0(Y) = 3 I_0(Y/sqrt 3): an mpf, no proof."""
    with mp.workdps(digits + 10):
        y = mp.findroot(lambda y: mp.besseli(0, y) - 3 * mp.besseli(0, y / mp.sqrt(3)), (3, 4))
        return y**2 / (4 * bessel_reference.supporting_scale(digits=digits) ** 2)


def lowest_share(y: Any, *, drop: int = DROP, places: int = 400) -> Any:
    """Least I_0(Y) max(1/q, X^2/Y^2)/I_0(X) over a grid of X in [0, Y), by mpmath: no proof.

    At X = Y it is 1; below 1, an angle above the threshold can fall below it.
    """
    shares = []
    for n in range(places):
        x = y * n / places
        kept = max(mp.mpf(1) / drop, (x / y) ** 2)
        shares.append(kept * mp.besseli(0, y) / mp.besseli(0, x))
    return min(shares)


def lowest_on_path(
    kept: Callable[[Fraction], Fraction], start: Fraction, *, cuts: int = 200
) -> Fraction:
    """Least angle when each of so many cuts keeps just the share kept(angle), exactly."""
    angle = lowest = start
    for _ in range(cuts):
        angle *= kept(angle)
        lowest = min(lowest, angle)
    return lowest


def _least_w() -> Any:
    def slope(w: Any) -> Any:
        return w.hypgeom_0f1(2) - (w / DROP).hypgeom_0f1(2)

    return root(lambda w: excess(w), slope, arb(1), arb(MOST_W))
