"""Checks of the W^{2,2} energy of a domain into which a singular edge comes (section 5)."""

from collections.abc import Iterator
from fractions import Fraction
from math import log, pi
from typing import Any

import sympy as sp
from mpmath import mp

from checks.ball import enclosure
from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.verify.ball_bounds import Row, bounded
from checks.verify.convergence import order as observed_order
from theory import bobbin, edge_energy, painleve
from theory.amsler import C0, S0, U, V, goursat_series
from theory.edge_energy_float import energy_between
from theory.painleve_float import crossing, slope

CUT = sp.Symbol("eta", positive=True)


def _grows(contact: str, power: int) -> Evidence:
    """Whether the energy outside the distance eta of the edge has no bound as eta tends to 0."""
    limit = sp.limit(edge_energy.energy_outside(contact, CUT, power=power), CUT, 0, "+")
    return statement(
        limit == sp.oo,
        shown=f"edge met as {contact}: infinite",
        witness=f"edge met as {contact}, curvatures to the power {power}: the energy is finite, "
        f"{sp.nsimplify(limit)} times a constant",
    )


def _bounded_below(setting: Setting) -> Evidence:
    """Density >= 4/e - 2 for phi = e or pi - e: 4/sin phi - 2 sin phi and sin e <= e."""
    phi = sp.Symbol("phi", positive=True)
    return identities(
        setting,
        {"density": edge_energy.density(phi) - 4 / sp.sin(phi) + 2 * sp.sin(phi)},
        shown="4/sin phi - 2 sin phi",
    )


def _touching(setting: Setting) -> Evidence:
    """A smooth net whose angle is pi at one point and less around it: pi - u^2 - v^2 + ..."""
    series = goursat_series(3, on_u=-(U**2), on_v=-(V**2)).subs({S0: 0, C0: -1})
    low = sum(c * U**i * V**j for (i, j), c in sp.Poly(series, U, V).terms() if i + j <= 2)
    return identities(setting, {"second order": low + U**2 + V**2}, shown="it touches the edge")


def willmore(
    setting: Setting, *, power: int = 2, curve: str = "crossing", point: str = "point, smooth"
) -> Evidence:
    """Whether the energy is infinite where an edge is crossed, and where phi touches pi smoothly.

    power: of the curvatures; curve, point: how the edge is met (theory.edge_energy.CONTACTS).
    """
    y = sp.Symbol("y", positive=True)
    pole = sp.limit((bobbin.KAPPA - y) * bobbin.bending_density(y), y, bobbin.KAPPA, "-")
    return combined(
        {
            "a curve": _grows(curve, power),
            "a point": _grows(point, power),
            "density": _bounded_below(setting),
            "a net that touches": _touching(setting),
            "bobbin": statement(
                bool(pole.is_positive), shown="a simple pole", witness=f"the residue is {pole}"
            ),
        },
        shown="the density is 4/sin phi - 2 sin phi >= 4/e - 2, e the angle from the edge: its "
        "integral is infinite over every neighbourhood of an edge that is crossed, e <= c t, and "
        "of a point where phi is of class C^{1,1} and touches pi, e <= c r^2",
    )


def amsler_crosses(setting: Setting, *, level: str = "1", least: str = "7/100") -> Evidence:
    """Slope of phi at z* = level * crossing of pi, between least and 2: the edge is crossed."""
    del setting

    def rows() -> Iterator[Row]:
        for name in ("1/100", "1", "3/2", "3"):
            corner = Fraction(name)
            place = painleve.crossing(corner, _pi, digits=30).ball()
            rate = painleve.slope(corner, place * enclosure(sp.Rational(level), {}), digits=15)
            # phi' is largest, at most 2, where phi = pi: phi'^2/2 + cos phi falls with z.
            yield f"slope at the edge, phi_0 = {name}", rate.ball(), 2
            yield f"least slope, phi_0 = {name}", enclosure(sp.Rational(least), {}), rate.ball()

    return bounded(
        rows(),
        shown="phi passes through pi at a rate between 7/100 and 2: the edge is crossed",
        sampled=True,
    )


def amsler_growth(setting: Setting, *, factor: str = "1", order: int = 1) -> Evidence:
    """Energy of an Amsler sector by halving pi - phi, against 2 factor z*/phi'(z*) log 2.

    The distance from it falls with pi - phi at this order.
    """
    del setting
    corner = 1.0
    place = crossing(corner, pi)
    rate = 2 * float(Fraction(factor)) * place / slope(corner, place) * log(2)
    levels = [2.0**-k for k in range(3, 8)]
    errors = [energy_between(corner, gap, gap / 2) - rate for gap in levels]
    with mp.workdps(15):
        return observed_order(
            [mp.mpf(level) for level in levels],
            [mp.mpf(error) for error in errors],
            order,
            digits=8,
            shown="energy gained by halving pi - phi, less 2 z*/phi'(z*) log 2",
        )


def _pi() -> Any:
    return enclosure(sp.pi, {})
