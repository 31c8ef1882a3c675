"""Objects of the opening of section 5: rays, helicoidal nets, edges, bounds of the energy."""

from fractions import Fraction
from itertools import pairwise
from math import cos, log, pi, sin, sqrt

import pytest
import sympy as sp
from flint import arb
from scipy.integrate import quad

from checks.evidence import Setting
from checks.verify import energy_scaling, periodic_amsler_growth
from theory import bobbin, edge_energy, helicoidal_net, painleve, periodic_amsler
from theory import periodic_amsler_bounds as bounds
from theory.amsler_ray_float import rim_point
from theory.edge_energy_float import energy_between
from theory.painleve_float import angle, crossing, diagonal


def test_the_middle_ray_runs_along_the_mirror_line():
    u, v = rim_point(pi / 4, 0.5, 2.0, steps=48)
    assert u == pytest.approx(v, rel=1e-6)
    assert diagonal(pi / 4, 2 * u) == pytest.approx(2, rel=1e-5)


def test_a_small_disk_is_flat():
    corner, part, distance = 1.2, 0.3, 1e-3
    u, v = rim_point(corner, part, distance, steps=4)
    flat = (sin(0.7 * corner) / sin(corner) * distance, sin(0.3 * corner) / sin(corner) * distance)
    assert (u, v) == pytest.approx(flat, rel=1e-6)


def test_the_order_of_the_runge_kutta_method():
    fine = rim_point(1.0, 0.3, 1.5, steps=96)[0]
    errors = [abs(rim_point(1.0, 0.3, 1.5, steps=n)[0] - fine) for n in (6, 12, 24)]
    orders = [log(a / b, 2) for a, b in pairwise(errors)]
    # phi is a function of u v, smooth at the apex: the full order is seen.
    assert all(3.5 < order < 5.5 for order in orders)


@pytest.mark.parametrize(
    ("kind", "scale", "pitch", "place"),
    [("axis", 1.1, 0.4, 0.5), ("horocycle", 1.3, 0.2, 0.1), ("point", 1.0, 0.3, 0.9)],
)
def test_a_helicoidal_net_solves_the_sine_gordon_equation(kind, scale, pitch, place):
    """F'' = sin f in xi, from the profile: d xi/ds = |K|/sin f by the area element."""
    s = sp.Symbol("s", positive=True)
    square = scale**2 * helicoidal_net.squared_profile(kind, s)
    f = 2 * sp.atan(sp.sqrt(helicoidal_net.squared_half_tangent(square, sp.Float(pitch))))
    step = sp.sin(f) / sp.sqrt(square)
    twice = sp.diff(sp.diff(f, s) * step, s) * step
    assert float((twice - sp.sin(f)).subs(s, place)) == pytest.approx(0, abs=1e-10)


def test_the_helicoidal_net_of_pitch_zero_is_the_bobbin():
    square = 4 / (bobbin.KAPPA**2 + 1) * helicoidal_net.squared_profile("axis", bobbin.S)
    tangent = helicoidal_net.squared_half_tangent(square, sp.Integer(0))
    longitudinal, _ = bobbin.squared_curvatures()
    assert sp.simplify((tangent - longitudinal).rewrite(sp.exp)) == 0


def test_the_density_near_an_edge():
    assert edge_energy.leading(2) == (4, -1)
    assert edge_energy.leading(1) == (2, 0)


@pytest.mark.parametrize("contact", edge_energy.CONTACTS)
def test_only_two_ways_of_meeting_an_edge_cost_infinite_energy(contact):
    cut = sp.Symbol("eta", positive=True)
    limit = sp.limit(edge_energy.energy_outside(contact, cut), cut, 0, "+")
    assert (limit == sp.oo) == (contact in ("crossing", "point, smooth"))


def test_the_energy_between_two_angles_by_adaptive_quadrature():
    corner, outer, inner = 0.8, 0.5, 0.05
    ends = [crossing(corner, pi - gap) for gap in (outer, inner)]

    def density(z: float) -> float:
        phi = angle(corner, z)
        # tan^2 + cot^2 of phi/2, written apart from 4/sin - 2 sin.
        return (
            ((1 - cos(phi)) / (1 + cos(phi)) + (1 + cos(phi)) / (1 - cos(phi))) * sin(phi) * z / 2
        )

    expected = quad(density, *ends, epsrel=1e-10)[0]
    assert energy_between(corner, outer, inner) == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize("radius", [8, 12, 20])
def test_the_bounds_for_all_radii_hold_where_the_energy_is_known(radius):
    energy = periodic_amsler.max_curvature(radius).ball().log()
    assert float(bounds.log_lower(sp.Integer(radius))) < energy
    assert energy < float(bounds.log_upper(sp.Integer(radius)))


@pytest.mark.parametrize("part", [100, 1000, 10**6])
def test_the_overshoot_is_bounded(part):
    def corner():
        return arb.pi() / part

    half, edge = (
        painleve.crossing(corner, lambda k=k: k * arb.pi() / 2, digits=20).ball() for k in (1, 2)
    )
    assert (edge - half) / arb(2).sqrt() < bounds.overshoot(half)
    assert bounds.overshoot(half) < bounds.overshoot(arb(5))


def test_the_edge_for_a_hundred_half_sectors():
    place = crossing(pi / 100, pi)
    assert float(bounds.edge_distance()) == pytest.approx(diagonal(pi / 100, place), rel=1e-8)


def test_the_least_curvature_grows_with_the_disk():
    radii = [Fraction(k, 2) for k in range(2, 13)]
    values = [periodic_amsler.max_curvature(r).ball() for r in radii]
    assert all(not a > b for a, b in pairwise(values))
    assert values[-1] > sqrt(2) * values[0]


def test_a_range_that_the_proof_does_not_reach_is_undecided():
    """At R = 12 the bound from below gives 4.2: 2/5 of R is true there, and not proved."""
    assert periodic_amsler_growth._beyond(Setting(), "2/5", "2", "1").outcome == "undecided"


def test_a_linear_bound_does_not_exist_near_zero():
    found = energy_scaling.scaling_symbol(Setting())
    assert found.outcome == "fail"
    assert "log cosh R" in found.witness


def test_a_disk_that_touches_the_edge_of_the_bobbin_has_finite_energy():
    """Radius L about the throat: max curvature infinite, bending energy finite (kappa = 1).

    By the density over (theta, y), y = sinh s: 1/2 (2/(1 - y) + ...), weighted by the width of the
    disk, cosh L = cosh s cosh tau.
    """
    length = float(sp.asinh(1))

    def width(y: float) -> float:
        return float(sp.acosh(sp.cosh(length) / sp.sqrt(1 + sp.Float(y) ** 2)))

    density = sp.lambdify("y", bobbin.bending_density(sp.Symbol("y")).subs(bobbin.KAPPA, 1))
    energies = [
        quad(lambda y: density(y) * width(y), 0, 1 - 10.0**-k, limit=200, epsrel=1e-6)[0]
        for k in (4, 6, 8)
    ]
    gains = [b - a for a, b in pairwise(energies)]
    assert gains[1] < 0.2 * gains[0] < 0.02
