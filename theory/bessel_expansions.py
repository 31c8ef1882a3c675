"""Expansions of I_0 at 0 and at infinity, from its equation and from its integral.

I_0 is the solution of f'' + f'/z = f with f(0) = 1, f'(0) = 0 (appendix A).
"""

import sympy as sp


def origin_coefficients(count: int) -> list[sp.Rational]:
    """Coefficients of z^0, ..., z^(count - 1) of I_0, each solved for in the equation."""
    z, unknown = sp.symbols("z a")
    found = [sp.Integer(1), sp.Integer(0)]
    for n in range(2, count):
        f = sum(a * z**k for k, a in enumerate(found)) + unknown * z**n
        residual = sp.expand(z * (sp.diff(f, z, 2) - f) + sp.diff(f, z))
        found.append(sp.solve(residual.coeff(z, n - 1), unknown)[0])
    return found[:count]


def kernel(z: sp.Expr, t: sp.Expr) -> sp.Expr:
    """Integrand e^(z cos t) of the integral over 0 < t < pi, whose mean solves the equation."""
    return sp.exp(z * sp.cos(t))


def kernel_flux(z: sp.Expr, t: sp.Expr) -> sp.Expr:
    """Expression whose t-derivative is the equation applied to the kernel; 0 at 0 and pi."""
    return sp.sin(t) * kernel(z, t) / z


def watson_coefficients(count: int) -> list[sp.Expr]:
    """Coefficients b_j of I_0(z) ~ e^z z^(-1/2) (b_0 + b_1/z + ...) as z tends to infinity.

    With s = 1 - cos t the mean of the kernel is (e^z/pi) times the integral over 0 < s < 2 of
    e^(-z s) s^(-1/2) (2 - s)^(-1/2); Watson's lemma integrates the series of the last factor.
    """
    half = sp.Rational(1, 2)
    return [
        sp.binomial(-half, j) * (-half) ** j / sp.sqrt(2) * sp.gamma(j + half) / sp.pi
        for j in range(count)
    ]
