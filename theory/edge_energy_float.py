"""Bending energy of an Amsler sector between two angles near its singular edge, in float64."""

from math import pi, sin

from theory.painleve_float import angle, crossing


def energy_between(corner: float, outer: float, inner: float, *, nodes: int = 24) -> float:
    """Bending energy where outer > pi - phi > inner, per unit of log(u/v)/2.

    There du dv = (z/2) dz dw with u = (z/2) e^w, v = (z/2) e^-w, and the density by du dv is
    4/sin(phi) - 2 sin(phi); by Gauss's rule with this number of nodes.
    """
    from numpy.polynomial.legendre import leggauss

    first, last = (crossing(corner, pi - gap) for gap in (outer, inner))
    half = (last - first) / 2
    total = 0.0
    for node, weight in zip(*leggauss(nodes), strict=True):
        z = first + half * (1 + float(node))
        sine = sin(angle(corner, z))
        total += float(weight) * (4 / sine - 2 * sine) * z / 2
    return half * total
