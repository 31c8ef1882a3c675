"""Comparison of PIII with the linear equations between which it lies (eq:integral, boundCphi*).

For z > 0 and unknown functions U = phi/phi_n and V with (z V')' = k z V the quantity
z (U' V - U V') has the derivative z U V (sin phi/phi - k): where sin phi/phi is between k = C^2 and
k = 1, U/V grows from 1 for k = C^2 and falls from 1 for k = 1.
"""

from typing import Any

import sympy as sp

Z = sp.Symbol("z", positive=True)


def wronskian_rate(force: Any, linear: Any) -> Any:
    """Derivative of z (U' V - U V'), where U'' + U'/z = force and V'' + V'/z = linear, over z.

    force, linear: expressions in the symbols U and V of `unknowns`.
    """
    u, v = unknowns()
    big, small = sp.Function("U")(Z), sp.Function("V")(Z)
    wronskian = Z * (big.diff(Z) * small - big * small.diff(Z))
    rate = wronskian.diff(Z).subs(
        {big.diff(Z, 2): force - big.diff(Z) / Z, small.diff(Z, 2): linear - small.diff(Z) / Z}
    )
    return sp.expand(sp.expand(rate / Z).subs({big: u, small: v}))


def unknowns() -> tuple[sp.Symbol, sp.Symbol]:
    """Positive symbols for the values of U and V."""
    return sp.Symbol("U", positive=True), sp.Symbol("V", positive=True)


def iterated_power(n: sp.Symbol) -> Any:
    """Double integral of the integral equation applied to xi^(2 n) in place of sin phi."""
    w, xi = sp.symbols("w xi", positive=True)
    inner = sp.integrate(xi ** (2 * n + 1), (xi, 0, w))
    return sp.powsimp(sp.integrate(inner / w, (w, 0, Z)))


def kernel_power(n: int) -> Any:
    """Single integral of xi log(z/xi) xi^(2 n) from 0 to z, a kernel that is not negative."""
    xi = sp.Symbol("xi", positive=True)
    return sp.simplify(sp.integrate(xi ** (2 * n + 1) * (sp.log(Z) - sp.log(xi)), (xi, 0, Z)))


def sinc_slope(t: sp.Symbol) -> tuple[Any, Any]:
    """Numerator of (sin t/t)' over t^2, and its own derivative -t sin t: it falls from 0."""
    numerator = sp.expand(t**2 * sp.diff(sp.sin(t) / t, t))
    return numerator, sp.expand(sp.diff(numerator, t))


def half_angle(expr: Any, t: sp.Symbol) -> Any:
    """Expression in sin t and cos t by q = tan(t/2), which is positive for 0 < t < pi."""
    q = sp.Symbol("q", positive=True)
    return sp.expand(expr).subs({sp.sin(t): 2 * q / (1 + q**2), sp.cos(t): (1 - q**2) / (1 + q**2)})
