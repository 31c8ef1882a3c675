r"""The coframe du, dv of unit-speed asymptotic curves, from principal directions and Codazzi.

omega_1, omega_2 is the coframe of the principal directions, omega_12 = a omega_1 + b omega_2 the
connection: d omega_1 = a omega_1 ^ omega_2, d omega_2 = b omega_1 ^ omega_2, and the equations of
Codazzi are e_2(k_1) = a (k_1 - k_2), e_1(k_2) = b (k_1 - k_2). With H = phi/2 the principal
curvatures are tan H and -cot H; omega_1 = cos H (du + dv) and omega_2 = sin H (dv - du).
"""

from typing import Any

import sympy as sp

#: Half of the angle phi, and its derivatives along the principal directions.
H = sp.Symbol("H", positive=True)
ALONG = sp.symbols("H_1 H_2", real=True)


def connection(first: Any, second: Any) -> tuple[Any, Any]:
    """Coefficients a, b of the connection for principal curvatures that are functions of H."""
    gap = first - second
    return sp.diff(first, H) * ALONG[1] / gap, sp.diff(second, H) * ALONG[0] / gap


def exterior(factors: tuple[Any, Any], first: Any, second: Any) -> Any:
    """Coefficient of d(f omega_1 + g omega_2) by omega_1 ^ omega_2, f and g functions of H."""
    f, g = factors
    a, b = connection(first, second)
    return f * a + g * b - sp.diff(f, H) * ALONG[1] + sp.diff(g, H) * ALONG[0]


def asymptotic_coframe() -> dict[str, tuple[Any, Any]]:
    """Coefficients of du and dv by omega_1 and omega_2."""
    along, across = 1 / (2 * sp.cos(H)), 1 / (2 * sp.sin(H))
    return {"du": (along, -across), "dv": (along, across)}


def metric() -> tuple[Any, Any, Any]:
    """Coefficients of omega_1^2 + omega_2^2 by du^2, 2 du dv, dv^2."""
    c, s = sp.cos(H) ** 2, sp.sin(H) ** 2
    return c + s, c - s, c + s
