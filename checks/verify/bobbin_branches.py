"""Quarter periods of Minding's bobbin: every sign of s' and of s, by w = |tan psi| > 0.

Between turning points sin psi = slope * w/sqrt(1 + w^2) and cos psi = side / sqrt(1 + w^2), where
slope = sgn s' and side = sgn s: four branches, which together (with s = 0 as their common limit)
are every non-constant solution. Any w > 0 is on the surface, so a witness always is.
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp

from theory.bobbin import KAPPA, S
from theory.pseudospherical_revolution import PSI, Flow
from theory.vectors import Vector, cross

W = sp.Symbol("w", positive=True)
SINE = W / sp.sqrt(1 + W**2)
SIGNS = (1, -1)


@dataclass(frozen=True, kw_only=True)
class Branch:
    """One sign of s' (slope) and one of s (side)."""

    slope: int
    side: int

    @property
    def name(self) -> str:
        """Both signs and the parameter, for a witness."""
        signs = {1: ">", -1: "<"}
        return f"s' {signs[self.slope]} 0, s {signs[self.side]} 0, w = |tan psi|"

    def value(self, expr: Any) -> Any:
        """Expression of psi on this branch, each square root in lowest terms."""
        signs = {sp.sin(PSI): self.slope * SINE, sp.cos(PSI): self.side / sp.sqrt(1 + W**2)}
        return lowest_roots(sp.sympify(expr).subs(signs))

    def vector(self, a: Vector) -> Vector:
        """Vector of expressions of psi on this branch."""
        return (self.value(a[0]), self.value(a[1]), self.value(a[2]))


BRANCHES = tuple(Branch(slope=slope, side=side) for slope in SIGNS for side in SIGNS)


def _lowest_root(power: sp.Pow) -> sp.Expr:
    top, bottom = sp.fraction(sp.factor(power.base))
    return top**power.exp / bottom**power.exp


def lowest_roots(expr: sp.Expr) -> sp.Expr:
    """Factor what stands under each root, so that squares of positive symbols leave it.

    Numerators and denominators part: the denominators met here, sums of squares, are positive.
    """
    return expr.replace(
        lambda e: e.is_Pow and e.exp.is_Rational and e.exp.q == 2,
        _lowest_root,
    )


def solved_rate(energy_at_rest: sp.Expr, slope: int) -> sp.Expr:
    """Velocity s' of this sign, where s'^2 + energy_at_rest = 0."""
    return slope * sp.sqrt(-energy_at_rest)


def inside(expr: Any) -> Any:
    """Expression of s and kappa with kappa^2 = sinh^2 s + w^2, that is, for any w > 0, |s| < L."""
    return lowest_roots(sp.sympify(expr).subs(KAPPA, sp.sqrt(sp.sinh(S) ** 2 + W**2)))


def unit_cross(r_u: Vector, r_v: Vector, flow: Flow, branch: Branch) -> Vector:
    """Vector r_u x r_v over its length 2 alpha^2 rho |sin psi|, on one branch."""
    length = 2 * flow.alpha**2 * flow.rho * SINE
    a = branch.vector(cross(r_u, r_v))
    by = branch.value(length)
    return (a[0] / by, a[1] / by, a[2] / by)
