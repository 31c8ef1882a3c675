"""Nets of Minding's bobbins with the angles of the continuum, for tests of convergence."""

import math
from fractions import Fraction

import numpy as np

from discrete.sector import Sector
from theory import bobbin_reference


def bobbin_angle(kappa: int, xi: Fraction) -> float:
    """Angle phi(u + v) of the bobbin's asymptotic lines: r_u + r_v = 2 s' on a meridian."""
    s = float(bobbin_reference.arc_length(Fraction(kappa), xi, digits=20))
    return 2 * math.acos(math.sqrt((kappa**2 - math.sinh(s) ** 2) / (kappa**2 + 1)))


def bobbin_sector(kappa: int, side: Fraction, n: int) -> Sector:
    """Net of the bobbin from a point of its throat: its lines turn by phi_u for each length."""
    h = side / n
    phi = [bobbin_angle(kappa, k * h) for k in range(n + 1)]
    turns = [(phi[k + 1] - phi[k - 1]) / 2 for k in range(1, n)]
    # The angle at the vertex of a quad is phi at its middle less a quarter of its area.
    corner = phi[1] - float(h) ** 2 * math.sin(phi[0]) / 4
    lengths = np.full(n, float(h))
    return Sector(
        u_lengths=lengths, v_lengths=lengths, corner_angle=corner, u_turns=turns, v_turns=turns
    )
