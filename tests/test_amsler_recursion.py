"""Theory of the recursion on Amsler sectors: comparison, growth of I_0, rays, layout, daughters."""

from itertools import pairwise
from math import acosh, cos, cosh, pi, sin, sinh, sqrt, tanh

import pytest
import sympy as sp
from flint import arb
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import i0, i1, iv

from theory import (
    amsler_disk,
    bessel_growth,
    comparison,
    daughter_sectors,
    kink,
    painleve_float,
    rim_distance,
)
from theory.errors import DomainError, UndecidedError

LAYOUT_ERROR = 1e-9
"""Tolerance 1e-12 of the Runge-Kutta method, with room to accumulate over a few units."""


def test_the_wronskian_rate_agrees_with_a_numerical_derivative():
    k, phi_n, h = 0.3, 0.7, 1e-4

    def wronskian(z):
        phi, slope = painleve_float.angle(phi_n, z), painleve_float.slope(phi_n, z)
        c = sqrt(k)
        return z * (slope / phi_n * i0(c * z) - phi / phi_n * c * i1(c * z))

    z = 1.3
    phi = painleve_float.angle(phi_n, z)
    u, v = comparison.unknowns()
    rate = comparison.wronskian_rate(sp.sin(phi) / phi_n, sp.Float(k) * v)
    value = float(rate.subs({u: phi / phi_n, v: i0(sqrt(k) * z)}))
    numeric = (wronskian(z + h) - wronskian(z - h)) / (2 * h) / z
    assert value == pytest.approx(numeric, abs=1e-6)  # h^2 and the rounding error over h


@pytest.mark.parametrize("n", [1, 2, 4])
def test_iterates_and_kernel_agree(n):
    symbol = sp.Symbol("n", positive=True, integer=True)
    step = comparison.iterated_power(symbol).subs(symbol, n)
    assert sp.simplify(step - comparison.kernel_power(n)) == 0


def test_the_numerator_of_the_slope_of_sin_t_over_t():
    t = sp.Symbol("t", positive=True)
    numerator, its_slope = comparison.sinc_slope(t)
    assert float(numerator.subs(t, 2.0)) == pytest.approx(2 * cos(2) - sin(2))
    assert float(its_slope.subs(t, 2.0)) == pytest.approx(-2 * sin(2))


@pytest.mark.parametrize("x", [0.3, 2.0, 11.0])
def test_the_ratio_is_that_of_bessel_functions(x):
    found = float(bessel_growth.ratio(arb(x) ** 2 / 4).mid())
    assert found == pytest.approx(2 * i1(x) / (x * i0(x)), rel=1e-13)


@pytest.mark.parametrize(("quotient", "s"), [(4.0, 0.5), (4.0, 2.3), (1.0, 2.0), (3.0, 0.0)])
def test_the_surplus_is_the_logarithmic_slope_of_the_quotient(quotient, s):
    found = float(bessel_growth.surplus(arb(quotient), arb(s)).mid())
    if s == 0:
        assert found == pytest.approx(quotient)
        return
    x = sqrt(2 * s * quotient)
    expected = (x * i1(x) / i0(x) - 2 * s * i1(s) / i0(s)) / s
    assert found == pytest.approx(expected, rel=1e-12)


def test_the_rate_of_growth_agrees_with_a_numerical_derivative():
    zero, one, place = bessel_growth.symbols()
    x, h = 1.7, 1e-5
    value = float(bessel_growth.rate_of_growth().subs({zero: i0(x), one: i1(x), place: x}))
    numeric = ((x + h) * i1(x + h) / i0(x + h) - (x - h) * i1(x - h) / i0(x - h)) / (2 * h)
    assert value == pytest.approx(numeric, abs=1e-8)


def test_a_cover_reaches_from_end_to_end_without_gaps():
    cells, place = bessel_growth.cover(lambda s: 1 + s * s, arb(0), arb(2))
    assert place is None
    assert cells[0].contains(0)
    assert cells[-1].contains(2)
    assert all(a.overlaps(b) for a, b in pairwise(cells))
    assert not any(cell > arb("2.001") for cell in cells)


def test_a_cover_finds_a_place_where_the_function_is_negative():
    _, place = bessel_growth.cover(lambda s: arb(1) - s, arb(0), arb(2))
    assert place > 1


def test_a_cover_does_not_pass_a_double_zero():
    with pytest.raises(UndecidedError):
        bessel_growth.cover(lambda s: (s - arb("0.7")) ** 2, arb(0), arb(2))


@pytest.mark.parametrize("a", [1, -1, 2])
def test_kinks_solve_the_sine_gordon_equation(a):
    point = {kink.U: sp.Rational(1, 3), kink.V: sp.Rational(1, 5)}
    q = kink.quarter_tangent(a, -2).subs(point)
    assert float(kink.mixed(a, -2).subs(point)) == pytest.approx(float(kink.sine(q)))
    assert float(kink.sine(q)) == pytest.approx(sin(4 * float(sp.atan(q))))


@pytest.mark.parametrize(("start", "alpha"), [(0.4, 0.3), (1.1, 2.0), (0.0, 1.0)])
def test_a_ray_keeps_the_law_of_cosines(start, alpha):
    length = 1.7
    found = float(rim_distance.cosh_radius(start, cos(alpha), length))
    assert found == pytest.approx(
        cosh(start) * cosh(length) + sinh(start) * sinh(length) * cos(alpha)
    )


def test_at_the_least_cosine_the_ray_is_as_long_as_the_radius():
    least = float(rim_distance.least_cosine(2.0, 0.8))
    assert least == pytest.approx(-tanh(0.4) / tanh(2.0))
    reached = acosh(float(rim_distance.cosh_radius(0.8, least, 2.0)))
    assert reached == pytest.approx(2.0)


@pytest.mark.parametrize(("phi0", "u", "v"), [(1.0, 0.4, 1.5), (pi / 2, 0.3, 0.9), (0.3, 2.0, 1.0)])
def test_both_families_of_lines_lead_to_the_same_distance(phi0, u, v):
    first, second = amsler_disk.distance(phi0, u, v), amsler_disk.distance(phi0, v, u)
    assert first == pytest.approx(second, abs=LAYOUT_ERROR)


@pytest.mark.parametrize(("phi0", "w"), [(1.0, 0.8), (pi / 2, 1.27), (0.1, 2.5)])
def test_on_the_mirror_line_the_distance_is_the_diagonal(phi0, w):
    diagonal = painleve_float.diagonal(phi0, 2 * w)
    assert amsler_disk.distance(phi0, w, w) == pytest.approx(diagonal, abs=LAYOUT_ERROR)


def test_the_rim_is_at_the_radius():
    v = amsler_disk.rim(1.0, 0.5, 2.0)
    assert amsler_disk.distance(1.0, 0.5, v) == pytest.approx(2.0, abs=LAYOUT_ERROR)


def test_arguments_outside_of_the_sector_are_refused():
    for call in (lambda: amsler_disk.distance(1.0, -0.1, 1.0), lambda: amsler_disk.rim(1, 3.0, 2)):
        with pytest.raises(DomainError):
            call()


def test_a_v_line_that_meets_the_singular_edge_is_refused():
    with pytest.raises(DomainError):
        amsler_disk.rim(3.1, 1.9, 60.0)


@pytest.mark.parametrize(("number", "names", "turns"), [(1, "uv", [1]), (3, "uvuv", [1, -1, 1])])
def test_rays_and_orientations_of_daughters(number, names, turns):
    assert daughter_sectors.rays(number) == names
    assert daughter_sectors.orientations(number) == turns
    assert daughter_sectors.closes(number)


def test_two_daughters_do_not_close():
    assert not daughter_sectors.closes(2)


@pytest.mark.parametrize("family", ["u", "v"])
def test_the_slope_on_a_shared_edge_follows_the_orientation(family):
    parent = sp.Symbol("p", real=True)
    assert daughter_sectors.slope_on_shared_edge(1, family=family) == parent
    assert daughter_sectors.slope_on_shared_edge(-1, family=family) == -parent


def test_the_linear_solution_is_a_bound_below_and_fails_for_a_larger_constant():
    """Runge-Kutta on PIII against scipy's Bessel function: a route without balls."""
    phi_n, level = 1.0, 1.01
    run = solve_ivp(
        lambda z, y: (y[1], sin(y[0]) - y[1] / z),
        (1e-6, 0.2),
        [phi_n, sin(phi_n) * 5e-7],
        rtol=1e-12,
        atol=1e-14,
    )
    c = sqrt(sin(level) / level)
    grown = run.y[0, -1] / phi_n
    assert iv(0, 0.2 * c) < grown < iv(0, 0.2)
    assert grown < iv(0, 0.2 * 1.01 * c)


def test_the_numbers_that_the_errata_quote():
    """Witnesses of section 5.1 in float64, by scipy alone and by the Runge-Kutta solution."""
    x = brentq(lambda t: i0(t) - 22.5, 0, 10)  # phi* = 9/4, phi_n = 1/10
    assert x**2 == pytest.approx(22.9, abs=0.05)  # u_max = v_max = 1/2: zeta_n = X^2
    assert 0.1 * i0(sqrt(sin(2.25) / 2.25) * x**2) > 7700
    assert painleve_float.angle(0.1, 1.0) < 0.127
    assert painleve_float.angle(0.1, x**2) == pytest.approx(2.94, abs=0.005)
    assert 2.25 / i0(1) == pytest.approx(1.777, abs=0.001)
    last = painleve_float.crossing(279 / 128, 2.25)
    assert painleve_float.angle(279 / 128, last**2 / 2) / 3 == pytest.approx(0.729, abs=0.001)
    assert painleve_float.diagonal(pi / 2, 2.54) == pytest.approx(1.26, abs=0.005)


def test_the_recursion_tends_to_the_angle_that_the_remark_quotes():
    angle, radius = 2.2, 10.0
    for _ in range(60):
        place = painleve_float.crossing(angle, 2.25)
        angle = painleve_float.angle(angle, place**2 / (2 * radius)) / 3
    assert angle == pytest.approx(0.0168, abs=5e-5)
