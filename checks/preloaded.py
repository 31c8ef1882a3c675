"""What the fork server imports once, so that a child starts warm: for `checks.runner` alone.

Importing this module does work, the one exception to the rule of the house: the server can only
import, and a tenth of a second that each of hundreds of children would spend on sympy's first
steps is spent here once.
"""

import sympy as sp

from checks.zero import vanishes


def _first_steps() -> None:
    u, v = sp.symbols("u v", real=True)
    k = sp.Symbol("k", positive=True)
    vanishes(sp.sin(u) ** 2 + sp.cos(u) ** 2 - 1)
    vanishes(sp.cosh(u + v) ** 2 - sp.sinh(u + v) ** 2 - 1)
    vanishes(1 / sp.sqrt(k**2 + 1) - sp.sqrt(k**2 + 1) / (k**2 + 1))
    sp.simplify(sp.sin(u) ** 2 + sp.cos(u) ** 2)
    sp.solve(u**2 - 2, u)
    sp.Matrix([[u, v], [v, u]]).inv()
    sp.integrate(sp.cos(u), (u, 0, 1))


_first_steps()
