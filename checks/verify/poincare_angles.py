"""Section 4.1: the angle at a node of a net in the disk, its sign, its order, and its thirds."""

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import sympy as sp
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import poincare_disk as printed
from checks.verify import convergence
from discrete import geodesics, poincare_disk
from discrete.space_forms import H2, ORIGIN
from theory import painleve_float

X, Y, C, D = sp.symbols("x y c d", real=True)


def intrinsic(setting: Setting, *, conjugated: bool = True, turn: str = "0") -> Evidence:
    """Printed argument against the angle of two geodesics of the hyperboloid.

    Sine and cosine of the two are in the same positive ratio: at 0 for all neighbours, and at
    rational vertices elsewhere. turn: a tangent by whose angle the second edge is turned further.
    """
    w1, w2 = (X, Y), (C, D)
    sine, cosine = geodesics.sine_and_cosine_part(
        H2, ORIGIN, poincare_disk.from_disk(w1), poincare_disk.from_disk(w2)
    )
    product = printed.edge_product((0, 0), w1, w2, conjugated=conjugated)
    t = sp.Rational(turn)
    re, im = printed.times(product, (1 / sp.sqrt(1 + t**2), t / sp.sqrt(1 + t**2)))
    ratio = 4 / ((1 - X**2 - Y**2) * (1 - C**2 - D**2))
    return combined(
        {
            "at 0": identities(
                setting,
                {"sine": sine - ratio * im, "cosine": cosine - ratio * re},
                where=[1 - X**2 - Y**2, 1 - C**2 - D**2],
                shown="",
            ),
            "elsewhere": _rational_corners(conjugated=conjugated),
        },
        shown="arg(w_2 conj w_1) is the angle from the geodesic to zeta_1 to that to zeta_2, "
        "counted counter-clockwise, in (-pi, pi]",
    )


_CORNERS = (
    (("1/2", "-1/3"), ("1/5", "1/7"), ("2/3", "1/4")),
    (("-3/4", "1/2"), ("-1/2", "2/3"), ("1/9", "1/3")),
    (("0", "4/5"), ("-1/3", "4/5"), ("-1/2", "-1/4")),
)


def _rational_corners(*, conjugated: bool) -> Evidence:
    for corner in _CORNERS:
        zs = [(sp.Rational(x), sp.Rational(y)) for x, y in corner]
        product = printed.edge_product(zs[0], zs[1], zs[2], conjugated=conjugated)
        points = [poincare_disk.from_disk(z) for z in zs]
        sine, cosine = geodesics.sine_and_cosine_part(H2, points[0], points[1], points[2])
        same = sine * product[0] == cosine * product[1] and sine * product[1] >= 0
        if not same or cosine * product[0] < 0:
            return statement(False, shown="", witness=f"another angle at the corner {corner}")
    return statement(True, shown="", witness="")


def clockwise(setting: Setting, *, sign: int = -1) -> Evidence:
    """Printed angle where the v-edge lies clockwise of the u-edge, against the angle between them.

    At the branch point of the example: u-axis along -1, v-axis along i, the second quadrant.
    """
    del setting
    zero, half = sp.Integer(0), sp.Rational(1, 2)
    found = printed.angle((zero, zero), (-half, zero), (zero, half), sp)
    return statement(
        found == sign * sp.pi / 2,
        shown="in a sector of the other orientation the printed value is minus the angle",
        witness=f"w_1 = -1/2, w_2 = i/2 enclose the angle pi/2; the printed value is {found}",
    )


Net = list[list[tuple[float, float]]]


def _amsler_net(step: float, count: int) -> Net:
    """Nodes [j][k] of the printed net on the two axes (Amsler), j, k <= count."""
    axis = [math.tanh(k * step / 2) for k in range(count + 1)]
    nodes = [[(0.0, x) for x in axis]]
    for j in range(1, count + 1):
        row = [(axis[j], 0.0)]
        for k in range(1, count + 1):
            row.append(printed.closed(nodes[j - 1][k - 1], row[k - 1], nodes[j - 1][k], math))
        nodes.append(row)
    return nodes


def _at_node(net: Net, j: int, k: int, forward_u: int, forward_v: int) -> float:
    """Angle of the net at node (j, k) between two of its edges, given by their directions +-1."""
    return abs(float(printed.angle(net[j][k], net[j + forward_u][k], net[j][k + forward_v], math)))


def _mean(net: Net, j: int, k: int) -> float:
    """Mean of the four angles at a node, those beside taken from pi."""
    opposite = _at_node(net, j, k, 1, 1) + _at_node(net, j, k, -1, -1)
    beside = _at_node(net, j, k, -1, 1) + _at_node(net, j, k, 1, -1)
    return (opposite + 2 * math.pi - beside) / 4


#: Which angle, and at which place it is meant, in steps from the node.
_PLACES: dict[str, tuple[Callable[[Net, int, int], float], float]] = {
    "at its node": (lambda net, j, k: _at_node(net, j, k, 1, 1), 0.0),
    "at the centre of its quad": (lambda net, j, k: _at_node(net, j, k, 1, 1), 0.5),
    "backwards, at its node": (lambda net, j, k: _at_node(net, j, k, -1, -1), 0.0),
    "mean of four, at the node": (_mean, 0.0),
}


def order(
    setting: Setting, *, place: str = "at its node", order: int = 1, shift: str = "0"
) -> Evidence:
    """Order in Delta of the distance of the printed angle from phi, on an Amsler sector.

    The sector has the angle pi/2; phi(u, v) is Painleve III at z = 2 sqrt(u v); u is near 1/2 and
    v near 1. shift: a further distance from the place at which the angle is meant, in steps.
    """
    del setting
    measure, offset = _PLACES[place]
    levels, errors = [], []
    for count in (16, 32, 64, 128):
        step = 1 / count
        net = _amsler_net(step, count + 1)
        j, k = count // 2, count
        away = offset + float(Fraction(shift))
        z = 2 * math.sqrt((j + away) * (k + away)) * step
        error = measure(net, j, k) - painleve_float.angle(math.pi / 2, z)
        levels.append(mp.mpf(step))
        errors.append(mp.mpf(error))
    return convergence.order(
        levels,
        errors,
        order,
        digits=11,
        shown=f"angle of (eq:angle) taken {place}, Delta = 1/16 to 1/128",
    )


def thirds(
    setting: Setting, *, weight: int = 2, divisor: int = 3, principal: bool = True
) -> Evidence:
    """Printed directions against equal thirds of the angle, modulo 2 pi, exactly in units of pi.

    w_1 in 24 directions, angles from pi/12 to 11 pi/12, as the quadrants of the example need.
    """
    del setting
    options: dict[str, Any] = {"weight": weight, "divisor": divisor, "principal": principal}
    tried = 0
    for first in (Fraction(n, 12) for n in range(-11, 13)):
        for opening in (Fraction(n, 12) for n in range(1, 12)):
            second = first + opening
            tried += 1
            found = (
                printed.trisecting(first, second, **options),
                printed.trisecting(second, first, **options),
            )
            expected = (first + opening / 3, first + 2 * opening / 3)
            if any((a - b) % 2 for a, b in zip(found, expected, strict=True)):
                return Evidence(
                    outcome="fail",
                    grade="exact",
                    tried=tried,
                    met=tried,
                    witness=f"arguments {first} pi and {second} pi: the formulas give {found[0]} "
                    f"pi and {found[1]} pi, thirds are {expected[0]} pi and {expected[1]} pi",
                )
    return Evidence(
        outcome="pass",
        grade="exact",
        residual="0",
        tried=tried,
        met=tried,
        shown="(2 beta_1 + beta_2)/3 and (beta_1 + 2 beta_2)/3 divide the angle in three",
    )
