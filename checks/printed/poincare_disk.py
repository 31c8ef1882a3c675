"""The Poincare disk and the nets in it as printed (section 4.1).

A complex number is a pair (re, im) of scalars of any kind; `field` stands for the functions of that
kind (sympy, mpmath, math). Parameters that are fractions are texts, so that no field rounds them.
"""

from fractions import Fraction
from typing import Any, TypeAlias

Pair: TypeAlias = tuple[Any, Any]


def times(z: Pair, w: Pair) -> Pair:
    """Product of two complex numbers."""
    return (z[0] * w[0] - z[1] * w[1], z[0] * w[1] + z[1] * w[0])


def conjugate(z: Pair) -> Pair:
    """Conjugate of a complex number."""
    return (z[0], -z[1])


def square(z: Pair) -> Any:
    """Square of the modulus."""
    return z[0] * z[0] + z[1] * z[1]


def over(z: Pair, w: Pair) -> Pair:
    """Quotient of two complex numbers."""
    top, bottom = times(z, conjugate(w)), square(w)
    return (top[0] / bottom, top[1] / bottom)


def _scaled(number: str, value: Any) -> Any:
    exact = Fraction(number)
    return exact.numerator * value / exact.denominator


def metric_factor(x: Any, y: Any, *, numerator: int = 4, power: int = 1) -> Any:
    """Factor of dx^2 + dy^2 in the metric of the disk (line 1143)."""
    return numerator / (1 - x**2 - y**2) ** power


def cosh_distance(z: Pair, w: Pair, *, factor: int = 2, sign: int = -1) -> Any:
    """Hyperbolic cosine of the distance of two points (item A)."""
    gap = square((z[0] - w[0], z[1] - w[1]))
    return 1 + factor * gap / ((1 + sign * square(z)) * (1 + sign * square(w)))


def radius(modulus: Any, field: Any, *, factor: str = "2") -> Any:
    """Distance of a point from the origin by its modulus (eq:hyp_radius)."""
    return _scaled(factor, field.atanh(modulus))


def moebius(
    z: Pair, z0: Pair, *, turn: Pair = (1, 0), denominator: int = 1, conjugated: bool = True
) -> Pair:
    """Map f(z; z0, theta), e^(i theta) = turn (eq:mobius)."""
    product = times(z, conjugate(z0) if conjugated else z0)
    below = (1 + denominator * product[0], denominator * product[1])
    return times(turn, over((z[0] + z0[0], z[1] + z0[1]), below))


def derivative_at_origin(z0: Pair, *, coefficient: int = -1) -> Any:
    """Derivative f'(0; z0) (item B)."""
    return 1 + coefficient * square(z0)


def inverse(w: Pair, z0: Pair, *, shift: int = -1, denominator: int = -1) -> Pair:
    """Inverse map in the form of a quotient (item B)."""
    product = times(w, conjugate(z0))
    below = (1 + denominator * product[0], denominator * product[1])
    return over((w[0] + shift * z0[0], w[1] + shift * z0[1]), below)


def on_ray(n: Any, spacing: Any, beta: Any, field: Any, *, rate: str = "1/2") -> Pair:
    """Equally spaced point gamma_beta(n) (item C)."""
    modulus = field.tanh(_scaled(rate, n * spacing))
    return (modulus * field.cos(beta), modulus * field.sin(beta))


def side(spacing: Any, field: Any, *, form: str = "2 tanh(Delta/2)") -> Any:
    """Length of a side of the rhombus (lines 1163, 1167); form: as printed, or another reading."""
    forms = {
        "2 tanh(Delta/2)": lambda: 2 * field.tanh(spacing / 2),
        "2 artanh(Delta/2)": lambda: 2 * field.atanh(spacing / 2),
        "Delta": lambda: spacing,
        "tanh(Delta)": lambda: field.tanh(spacing),
        "101/100 Delta": lambda: spacing * 101 / 100,
    }
    return forms[form]()


def neighbour_modulus(spacing: Any, field: Any, *, form: str = "Delta/2") -> Any:
    """Modulus of w_1 and w_2 (line 1165); form: as printed, or another reading."""
    forms = {
        "Delta/2": lambda: spacing / 2,
        "tanh(Delta/2)": lambda: field.tanh(spacing / 2),
        "tanh(Delta)": lambda: field.tanh(spacing),
        "101/100 tanh(Delta/2)": lambda: field.tanh(spacing / 2) * 101 / 100,
    }
    return forms[form]()


def fourth(w1: Pair, w2: Pair, modulus: Any, *, sign: int = 1, weight: str = "1") -> Pair:
    """Vertex w_12 of the normalised rhombus (poincare-ddg); modulus: |w_1 w_2|."""
    below = 1 + sign * _scaled(weight, modulus)
    return ((w1[0] + w2[0]) / below, (w1[1] + w2[1]) / below)


def closed(
    z0: Pair, z1: Pair, z2: Pair, field: Any, *, sign: int = 1, weight: str = "1", back: int = 1
) -> Pair:
    """Vertex zeta_12 from zeta_0, zeta_1, zeta_2 (poincare-ddg); back: sign of z0 in the return."""
    away = (-z0[0], -z0[1])
    w1, w2 = moebius(z1, away), moebius(z2, away)
    modulus = field.sqrt(square(w1) * square(w2))
    returned = (back * z0[0], back * z0[1])
    return moebius(fourth(w1, w2, modulus, sign=sign, weight=weight), returned)


def edge_product(z0: Pair, z1: Pair, z2: Pair, *, conjugated: bool = True) -> Pair:
    """Number w_2 w_1^* whose argument is the angle at zeta_0 (eq:angle)."""
    away = (-z0[0], -z0[1])
    w1, w2 = moebius(z1, away), moebius(z2, away)
    return times(w2, conjugate(w1) if conjugated else w1)


def angle(z0: Pair, z1: Pair, z2: Pair, field: Any, *, conjugated: bool = True) -> Any:
    """Angle phi at zeta_0, the principal argument (eq:angle)."""
    product = edge_product(z0, z1, z2, conjugated=conjugated)
    return field.atan2(product[1], product[0])


def trisecting(
    first: Fraction,
    second: Fraction,
    *,
    weight: int = 2,
    divisor: int = 3,
    principal: bool = True,
) -> Fraction:
    """Direction phi_1 = arg(w_2 w_1^2)/3 in units of pi (eq:trisect).

    first, second: the arguments of w_1 and w_2; principal: whether arg is the value in (-pi, pi],
    or the sum of the arguments as they are. phi_2 is the same with the two exchanged.
    """
    argument = weight * first + second
    if principal:
        argument = 1 - (1 - argument) % 2
    return argument / divisor
