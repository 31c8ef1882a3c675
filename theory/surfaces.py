"""Pseudospherical fronts with elementary coordinates: pseudosphere, Dini's and Kuen's surface.

Each is written in chi and theta, linear in the asymptotic coordinates u and v (unit speed, torsion
-1 along u and +1 along v); the normal is smooth across the cuspidal edges, and tan(phi/4) belongs
to the smooth angle phi from r_u to r_v about it: the edges are the zeros of sin phi. That these are
such surfaces is verified by the checks (position, normal and angle agree), never assumed.
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp
from sympy.polys.fields import field

from theory.asymptotic_net import AsymptoticNet
from theory.vectors import Vector, cross, dot


@dataclass(frozen=True, kw_only=True)
class Cylindrical:
    """Vector calculus by components along the radius at angle theta, the circle and the axis.

    All expressions are rational functions of x = e^chi and theta, kept in lowest terms; chi_rates,
    theta_rates: derivatives of chi and theta along "u" and "v", constants.
    """

    x: sp.Symbol
    theta: sp.Symbol
    chi_rates: dict[str, Any]
    theta_rates: dict[str, Any]

    def reduced(self, expr: Any) -> Any:
        """Rational function in lowest terms."""
        fractions, *_ = field([self.x, self.theta], sp.QQ)
        return fractions.from_expr(sp.sympify(expr)).as_expr()

    def dot(self, a: Vector, b: Vector) -> Any:
        """Inner product."""
        return self.reduced(dot(a, b))

    def cross(self, a: Vector, b: Vector) -> Vector:
        """Cross product."""
        product = cross(a, b)
        return self.reduced(product[0]), self.reduced(product[1]), self.reduced(product[2])

    def rate(self, scalar: Any, along: str) -> Any:
        """Partial derivative of a scalar field."""
        return self.reduced(self._plain_rate(scalar, along))

    def derivative(self, a: Vector, along: str) -> Vector:
        """Partial derivative of a vector field, whose components turn with theta."""
        turn = self.theta_rates[along]
        return (
            self.reduced(self._plain_rate(a[0], along) - turn * a[1]),
            self.reduced(self._plain_rate(a[1], along) + turn * a[0]),
            self.rate(a[2], along),
        )

    def _plain_rate(self, scalar: Any, along: str) -> Any:
        scalar = sp.sympify(scalar)
        by_chi = self.chi_rates[along] * self.x * scalar.diff(self.x)
        return by_chi + self.theta_rates[along] * scalar.diff(self.theta)


@dataclass(frozen=True, kw_only=True)
class Front:
    """Position, unit normal and tan(phi/4) of a front as expressions in chi and theta.

    position, normal: components along the radius at angle theta, the circle and the axis; rates:
    derivatives of chi and theta along "u" and "v", constants.
    """

    name: str
    chi: sp.Symbol
    theta: sp.Symbol
    rates: dict[str, tuple[Any, Any]]
    position: Vector
    normal: Vector
    quarter_tangent: Any

    def net(self, side: int) -> AsymptoticNet:
        """Return the front on the side of its edges where sin phi has this sign (+1 or -1)."""
        tangent = self._rational(self.quarter_tangent)
        whole = (1 + tangent**2) ** 2
        cosine = (1 - 6 * tangent**2 + tangent**4) / whole
        sine = 4 * tangent * (1 - tangent**2) / whole
        return AsymptoticNet(
            name=f"{self.name}, sigma = {side:+d}",
            calculus=Cylindrical(
                x=sp.Symbol("exp_chi", positive=True),
                theta=self.theta,
                chi_rates={along: pair[0] for along, pair in self.rates.items()},
                theta_rates={along: pair[1] for along, pair in self.rates.items()},
            ),
            r_u=self._tangent("u"),
            r_v=self._tangent("v"),
            normal=self._rational_vector(self.normal),
            sigma=side,
            cos_phi=sp.cancel(side * cosine),
            sin_phi=sp.cancel(side * sine),
        )

    def _tangent(self, along: str) -> Vector:
        """Return the derivative of the position along "u" or "v"."""
        chi_rate, theta_rate = self.rates[along]
        radial, angular, axial = (
            chi_rate * entry.diff(self.chi) + theta_rate * entry.diff(self.theta)
            for entry in self.position
        )
        turned = (
            radial - theta_rate * self.position[1],
            angular + theta_rate * self.position[0],
            axial,
        )
        return self._rational_vector(turned)

    def _rational(self, expr: Any) -> Any:
        """Expression in x = e^chi and theta, for one with no chi outside exponents."""
        x = sp.Symbol("exp_chi", positive=True)
        functions = {
            sp.cosh(self.chi): (x + 1 / x) / 2,
            sp.sinh(self.chi): (x - 1 / x) / 2,
            sp.tanh(self.chi): (x**2 - 1) / (x**2 + 1),
            sp.exp(-self.chi): 1 / x,
        }
        return sp.cancel(sp.sympify(expr).xreplace(functions))

    def _rational_vector(self, a: Vector) -> Vector:
        return (self._rational(a[0]), self._rational(a[1]), self._rational(a[2]))

    def at(self, components: Vector, u: Any, v: Any) -> Vector:
        """Return a vector field of the front in R^3, as a function of the asymptotic coordinates.

        components: radial, angular and axial, such as those of position and normal.
        """
        (chi_u, theta_u), (chi_v, theta_v) = self.rates["u"], self.rates["v"]
        angle = theta_u * u + theta_v * v
        place = {self.chi: chi_u * u + chi_v * v, self.theta: angle}
        radial, angular, axial = (sp.sympify(entry).subs(place) for entry in components)
        c, s = sp.cos(angle), sp.sin(angle)
        return (radial * c - angular * s, radial * s + angular * c, axial)


def _symbols() -> tuple[sp.Symbol, sp.Symbol]:
    chi, theta = sp.symbols("chi theta", real=True)
    return chi, theta


def dini(a: Any) -> Front:
    """Dini's surface from the soliton phi = 4 arctan exp(-chi), chi = a u + v/a, theta = v - u.

    a: positive rational; a = 1 is the pseudosphere, the others wind up along the axis.
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
        position=(k / sp.cosh(chi), sp.Integer(0), axial - k * sp.tanh(chi)),
        normal=(-k * sp.tanh(chi), m, -k / sp.cosh(chi)),
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
        position=(2 * c / q, -2 * theta * c / q, chi - 2 * s * c / q),
        normal=(2 * theta / q, (c**2 - theta**2) / q, -2 * theta * s / q),
        quarter_tangent=theta / c,
    )
