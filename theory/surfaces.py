"""Pseudospherical fronts with elementary coordinates: pseudosphere, Dini's and Kuen's surface.

Each is written in chi and theta, linear in the asymptotic coordinates u and v (unit speed, torsion
-1 along u and +1 along v); the normal is smooth across the cuspidal edges, and tan(phi/4) belongs to
the smooth angle phi from r_u to r_v about it: the edges are the zeros of sin phi. That these are
such surfaces is verified by the checks (position, normal and angle agree), never assumed.
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp

from theory.asymptotic_net import AsymptoticNet, Cartesian
from theory.vectors import Vector


@dataclass(frozen=True, kw_only=True)
class Front:
    """Position, unit normal and tan(phi/4) of a front as expressions in two symbols.

    chi, theta: the symbols; rates: their derivatives along "u" and "v", constants.
    """

    name: str
    chi: sp.Symbol
    theta: sp.Symbol
    rates: dict[str, tuple[Any, Any]]
    position: Vector
    normal: Vector
    quarter_tangent: Any

    def net(self, side: int) -> AsymptoticNet:
        """Return the front on the side of its edges where sin phi has this sign (+1 or -1).

        Differentiated directly; its fields are rational functions of e^chi, tan(theta/2), theta.
        """
        plain = Cartesian(symbols=(self.chi, self.theta), rates=dict(self.rates))
        whole = (1 + self.quarter_tangent**2) ** 2
        cosine = (1 - 6 * self.quarter_tangent**2 + self.quarter_tangent**4) / whole
        sine = 4 * self.quarter_tangent * (1 - self.quarter_tangent**2) / whole
        return AsymptoticNet(
            name=f"{self.name}, sigma = {side:+d}",
            calculus=self._rational_calculus(),
            r_u=self._rational_vector(plain.derivative(self.position, "u")),
            r_v=self._rational_vector(plain.derivative(self.position, "v")),
            normal=self._rational_vector(self.normal),
            sigma=side,
            cos_phi=self._rational(side * cosine),
            sin_phi=self._rational(side * sine),
        )

    def _rational_calculus(self) -> Cartesian:
        x, t = _rational_symbols()
        rates = {
            along: (chi_rate * x, theta_rate * (1 + t**2) / 2, theta_rate)
            for along, (chi_rate, theta_rate) in self.rates.items()
        }
        return Cartesian(symbols=(x, t, self.theta), rates=rates, rational=True)

    def _rational(self, expr: Any) -> Any:
        """Expression in e^chi, tan(theta/2) and theta, for one that has no chi outside exponents."""
        x, t = _rational_symbols()
        functions = {
            sp.cosh(self.chi): (x + 1 / x) / 2,
            sp.sinh(self.chi): (x - 1 / x) / 2,
            sp.tanh(self.chi): (x**2 - 1) / (x**2 + 1),
            sp.exp(-self.chi): 1 / x,
            sp.cos(self.theta): (1 - t**2) / (1 + t**2),
            sp.sin(self.theta): 2 * t / (1 + t**2),
        }
        return sp.cancel(sp.sympify(expr).xreplace(functions))

    def _rational_vector(self, a: Vector) -> Vector:
        return (self._rational(a[0]), self._rational(a[1]), self._rational(a[2]))

    def at(self, vector: Vector, u: Any, v: Any) -> Vector:
        """Return a vector field of the front as a function of the asymptotic coordinates."""
        (chi_u, theta_u), (chi_v, theta_v) = self.rates["u"], self.rates["v"]
        place = {self.chi: chi_u * u + chi_v * v, self.theta: theta_u * u + theta_v * v}
        first, second, third = (sp.sympify(entry).subs(place) for entry in vector)
        return (first, second, third)


def _symbols() -> tuple[sp.Symbol, sp.Symbol]:
    chi, theta = sp.symbols("chi theta", real=True)
    return chi, theta


def _rational_symbols() -> tuple[sp.Symbol, sp.Symbol]:
    return sp.Symbol("exp_chi", positive=True), sp.Symbol("tan_half_theta", real=True)


def _turned(radial: Any, angular: Any, axial: Any, theta: sp.Symbol) -> Vector:
    """Vector with these components along the radius at angle theta, the circle and the axis."""
    c, s = sp.cos(theta), sp.sin(theta)
    return (radial * c - angular * s, radial * s + angular * c, axial)


def dini(a: Any) -> Front:
    """Dini's surface from the soliton phi = 4 arctan exp(-chi), chi = a u + v/a, theta = v - u.

    a: positive number or symbol; a = 1 is the pseudosphere, the others wind up along the axis.
    """
    chi, theta = _symbols()
    a = sp.sympify(a)
    k, m = 2 * a / (1 + a**2), (a**2 - 1) / (a**2 + 1)
    axial = k * chi + m * theta
    return Front(
        name="pseudosphere" if a == 1 else "Dini",
        chi=chi,
        theta=theta,
        rates={"u": (a, sp.Integer(-1)), "v": (1 / a, sp.Integer(1))},
        position=_turned(k / sp.cosh(chi), sp.Integer(0), axial - k * sp.tanh(chi), theta),
        normal=_turned(-k * sp.tanh(chi), m, -k / sp.cosh(chi), theta),
        quarter_tangent=sp.exp(-chi),
    )


def pseudosphere() -> Front:
    """Beltrami's pseudosphere, chi = u + v and theta = v - u, with its edge at chi = 0."""
    return dini(1)


def kuen() -> Front:
    """Kuen's surface, from two solitons with chi = u + v that have merged; theta = v - u."""
    chi, theta = _symbols()
    c, s = sp.cosh(chi), sp.sinh(chi)
    q = c**2 + theta**2
    return Front(
        name="Kuen",
        chi=chi,
        theta=theta,
        rates={"u": (sp.Integer(1), sp.Integer(-1)), "v": (sp.Integer(1), sp.Integer(1))},
        position=_turned(2 * c / q, -2 * theta * c / q, chi - 2 * s * c / q, theta),
        normal=_turned(2 * theta / q, (c**2 - theta**2) / q, -2 * theta * s / q, theta),
        quarter_tangent=theta / c,
    )
