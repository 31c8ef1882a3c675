r"""Bounds of the least max curvature E(R) of periodic Amsler surfaces, for all radii (ebound).

phi solves (z phi')' = z sin phi, phi(0) = phi_0 = pi/m, phi'(0) = 0; z_1, z_* are the places where
it is pi/2 and pi, and distances are integrals of cos(phi/2) (theory.periodic_amsler).

*From above.* While phi <= pi/2, phi <= phi_0 I_0(z). Take the least m >= 2 I_0(y): for z <= y phi
is at most pi/2 and at most (pi/2) I_0(z)/I_0(y), so that the mirror line is, at z = y, at the
distance y/sqrt 2 at least, and E <= cot(phi_0/2) <= 2 m/pi on the disk of that radius. As moreover
cos(phi/2) >= 1 - phi^2/8 and the integral of I_0^2 from 0 to y is at most (9/8) I_0(y)^2 for
y >= 1, the distance is at least y - 9 pi^2/256: both y = sqrt(2) R and y = R + 7/20 will do.
(The bound on the integral: it holds at 1, and (9/8) 2 I_0 I_1 >= I_0^2 beyond, because r = I_1/I_0
obeys r' = 1 - r/z - r^2, which is positive where r = 4/9, z >= 1, and r(1) > 4/9.)

*From below.* phi'^2/2 + cos phi falls, so that phi' <= sqrt 2 while phi <= pi/2; with h =
pi/(2 sqrt 2), phi(z_1 - t) >= pi/2 - sqrt(2) t for t <= h, and z_1 phi'(z_1) >= (z_1 - h) times the
integral of sin(pi/2 - sqrt(2) t), that is (z_1 - h)/sqrt 2. As z phi' grows, z_* <= z_1
exp(pi/(sqrt(2) (z_1 - h))). The edge phi = pi is therefore at most z_1 + K away, K = (z_* - z_1)/
sqrt 2 being largest for the least z_1. For m >= 100, z_1 >= 5, and then R < z_1 + 11/4. With C^2 =
2/pi, sin phi >= C^2 phi, so that phi/I_0(C z) grows up to z_1: phi_0 I_0(C z_1) <= pi/2. Hence
cot(phi_0/2) >= 1/phi_0 >= (2/pi) I_0(y), y = C (R - 11/4), and I_0(y) >= sinh(y)/y, term by term.
For m < 100 the edge is nearer than 6.
"""

from typing import Any

import sympy as sp
from flint import arb

from theory import painleve

LEAST_HALF = 100
EDGE_WITHIN = 6
LEAST_PLACE = 5


def integral_of_square() -> tuple[Any, Any]:
    """Balls of the integral of I_0^2 over [0, 1] and of I_0(1)^2."""
    # I_0 is increasing and even: the sum over cells at their upper ends is a bound from above.
    cells = 64
    upper = sum(((arb(k + 1) / cells).bessel_i(0) ** 2 for k in range(cells)), arb(0)) / cells
    return upper, arb(1).bessel_i(0) ** 2


def bessel_quotient() -> Any:
    """Ball of I_1(1)/I_0(1)."""
    return arb(1).bessel_i(1) / arb(1).bessel_i(0)


def overshoot(place: Any) -> Any:
    """Bound on the distance from z_1 to the edge along the mirror line, z_1 being this ball."""
    root = arb(2).sqrt()
    h = arb.pi() / (2 * root)
    return place * ((arb.pi() / (root * (place - h))).exp() - 1) / root


def least_place() -> Any:
    """Ball of z_1 for m = LEAST_HALF; for larger m it is larger."""
    return painleve.crossing(_corner, lambda: arb.pi() / 2, digits=15).ball()


def edge_distance() -> Any:
    """Ball of the distance of the edge for m = LEAST_HALF; for smaller m it is nearer."""
    place = painleve.crossing(_corner, arb.pi, digits=30).ball()
    # The integrand cos(phi/2) is 0 at the edge: where the ball of z lies hardly matters.
    return painleve.diagonal(_corner, place.mid(), digits=12).ball() + arb(0, place.rad())


def largest_exponent() -> Any:
    """Rate of log E from above: I_0(sqrt(2) R) <= exp(sqrt(2) R)."""
    return sp.sqrt(2)


def least_exponent() -> Any:
    """Rate of log E from below, C = sqrt(2/pi)."""
    return sp.sqrt(2 / sp.pi)


def log_upper(radius: Any) -> Any:
    """Log of (2/pi)(2 exp(sqrt(2) R) + 1), a bound of E(R) from above; sympy."""
    return sp.log(2 / sp.pi * (2 * sp.exp(largest_exponent() * radius) + 1))


def log_lower(radius: Any) -> Any:
    """Log of (2/pi) sinh(y)/y, y = C (R - 11/4), a bound of E(R) from below; R >= 6, sympy."""
    y = least_exponent() * (radius - sp.Rational(11, 4))
    return sp.log(2 / sp.pi * sp.sinh(y) / y)


def _corner() -> Any:
    return arb.pi() / LEAST_HALF
