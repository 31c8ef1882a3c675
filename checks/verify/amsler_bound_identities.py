"""Identities on which the certificate of the Bessel bounds rests (boundCphi*)."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities

X, S = sp.symbols("x s", positive=True)
C, E, SIGMA = sp.symbols("c e sigma", positive=True)
U = sp.Function("U")(X)
#: f(c x) and f(x), f(w) = I_0(2 sqrt w), for which w f'' + f' = f.
SCALED, PLAIN = sp.Function("F")(X), sp.Function("f")(X)


def _applied(g: sp.Expr) -> sp.Expr:
    """Left side (x g')' of the equations, by (x F')' = c F, (x f')' = f and (x U')' = sigma U."""
    rules = {
        sp.diff(unknown, X, 2): (rate * unknown - sp.diff(unknown, X)) / X
        for unknown, rate in ((SCALED, C), (PLAIN, sp.Integer(1)), (U, SIGMA))
    }
    return sp.diff(X * sp.diff(g, X), X).doit().subs(rules)


def _gaps(source_power: int) -> dict[str, sp.Expr]:
    """Residuals of the equations of M, W and the unit response; sigma stands for sin phi/phi."""
    m, q = (SCALED - U) / E, (C - SIGMA) / (E * X)
    w, defect = (PLAIN - U) / E, (1 - SIGMA) / (E * U**2)
    unit = (SCALED - 1 - C * X) / C**2
    return {
        "(x M')' - c M - x q U": _applied(m) - C * m - X**source_power * q * U,
        "(x W')' - W - U^3 T": _applied(w) - w - U ** (source_power + 2) * defect,
        "unit response": _applied(unit) - C * unit - X,
    }


def _by_parts(factor: int) -> dict[str, sp.Expr]:
    """Residuals of the integrals of s^3 K_0 and s^3 I_0, by the rules of Bessel functions."""
    k0, k1, i0, i1 = (sp.Function(name)(S) for name in ("K0", "K1", "I0", "I1"))
    rules = {
        sp.diff(k0, S): -k1,
        sp.diff(k1, S): -k0 - k1 / S,
        sp.diff(i0, S): i1,
        sp.diff(i1, S): i0 - i1 / S,
    }
    of_k = -(S**3 * k1 + factor * S**2 * (k0 + 2 * k1 / S))
    of_i = S**3 * i1 - factor * S**2 * (i0 - 2 * i1 / S)
    wronskian = S * (i0 * k1 + i1 * k0)
    return {
        "s^3 K_0": sp.expand(sp.diff(of_k, S).subs(rules) - S**3 * k0),
        "s^3 I_0": sp.expand(sp.diff(of_i, S).subs(rules) - S**3 * i0),
        "kernel's jump is constant": sp.expand(sp.diff(wronskian, S).subs(rules)),
    }


def gap_identities(setting: Setting, *, source_power: int = 1, by_parts: int = 2) -> Evidence:
    """Equations of both gaps with their exact zeros divided out, and the kernel's integrals."""
    return identities(
        setting,
        {
            **_gaps(source_power),
            **_by_parts(by_parts),
        },
        shown="the gaps over phi_n^2 solve linear equations with sources that are regular and "
        "positive as phi_n tends to 0, and Bessel's kernel solves them",
    )
