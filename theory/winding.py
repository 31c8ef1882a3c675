"""Winding numbers of closed plane curves about the origin, by zeros and by arcs.

The two routes share no code. Zeros: on the circle z = c + r e, |e| = 1, a polynomial in z and its
conjugate is a Laurent polynomial in e, and it winds as often as it has zeros inside |e| < 1, minus
the order of its pole at e = 0. Arcs: the curve is cut into arcs, each certainly in one of the
four half-planes right, upper, left, lower; neighbours share a point, so the steps from half-plane
to half-plane add up to four times the winding number.
"""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import sympy as sp
from flint import acb, acb_poly, arb, ctx, fmpq

from theory.errors import UndecidedError

X, Y = sp.symbols("x y", real=True)
E = sp.Symbol("e")

Loop = Callable[[arb], tuple[arb, arb]]


def _on_circle(field: tuple[Any, Any], center: Any, radius: Any) -> tuple[sp.Poly, int]:
    """Polynomial in e and the order of the pole that is taken from it."""
    value = sp.expand(sp.sympify(field[0]) + sp.I * sp.sympify(field[1]))
    degree = sp.Poly(value, X, Y).total_degree()
    z, conjugate = center + radius * E, sp.conjugate(center) + radius / E
    place = {X: (z + conjugate) / 2, Y: (z - conjugate) / (2 * sp.I)}
    power = sp.expand(sp.expand(value.subs(place, simultaneous=True)) * E**degree)
    return sp.Poly(power, E, extension=[sp.I]), degree


def winding_by_zeros(field: tuple[Any, Any], center: Any, radius: Any) -> int:
    """Winding number of a polynomial vector field in X, Y along a circle, once counter-clockwise.

    center: Gaussian rational as a sympy number; radius: positive rational. Raises UndecidedError
    where a zero lies on the circle, or too near for the largest precision.
    """
    power, degree = _on_circle(field, sp.sympify(center), sp.sympify(radius))
    inside = 0
    for factor, multiplicity in power.sqf_list()[1]:
        inside += multiplicity * sum(_is_inside(factor))
    return inside - degree


def _is_inside(factor: sp.Poly) -> list[bool]:
    """For each root of a square-free polynomial, whether it lies inside the unit circle."""
    if factor.degree() == 0:
        return []
    for bits in (128, 512, 2048):
        with ctx.workprec(bits):
            roots = acb_poly([_gaussian(a) for a in reversed(factor.all_coeffs())]).roots()
            sizes = [abs(root) for root in roots]
            if all(size < 1 or size > 1 for size in sizes):
                return [bool(size < 1) for size in sizes]
    raise UndecidedError("a zero of the field lies on the circle, or too near to it")


def _gaussian(value: Any) -> acb:
    real, imaginary = sp.expand(value).as_real_imag()
    parts = [arb(fmpq(int(q.p), int(q.q))) for q in (sp.Rational(real), sp.Rational(imaginary))]
    return acb(parts[0], parts[1])


def _half_plane(point: tuple[arb, arb]) -> int | None:
    """0 right, 1 upper, 2 left, 3 lower; None where none is certain."""
    x, y = point
    for label, positive in enumerate((x, y, -x, -y)):
        if positive > 0:
            return label
    return None


def winding_by_arcs(loop: Loop, *, depth: int = 14) -> int:
    """Winding number about the origin of a closed curve given on balls of its parameter in [0, 1].

    Raises UndecidedError where an arc of length 2^-depth is in no half-plane for sure, ValueError
    where the curve is certainly not closed.
    """
    if not all(a.overlaps(b) for a, b in zip(loop(arb(0)), loop(arb(1)), strict=True)):
        raise ValueError("the curve is not closed")
    labels: list[int] = []
    pending = [(Fraction(k, 8), Fraction(k + 1, 8)) for k in reversed(range(8))]
    while pending:
        start, end = pending.pop()
        label = _half_plane(loop(arc(start, end)))
        if label is not None:
            labels.append(label)
            continue
        if end - start <= Fraction(1, 2**depth):
            raise UndecidedError(f"the curve is too near to the origin for t in [{start}, {end}]")
        middle = (start + end) / 2
        pending += [(middle, end), (start, middle)]
    steps = [
        (after - before + 1) % 4 - 1
        for before, after in zip(labels, labels[1:] + labels[:1], strict=True)
    ]
    if 2 in steps:
        raise ValueError("neighbouring arcs in opposite half-planes: the curve is not continuous")
    return sum(steps) // 4


def arc(start: Fraction, end: Fraction) -> arb:
    """Ball that covers a dyadic interval of parameters."""
    middle, radius = (start + end) / 2, (end - start) / 2
    ball = arb(fmpq(middle.numerator, middle.denominator))
    return ball + arb(0, arb(fmpq(radius.numerator, radius.denominator)))
