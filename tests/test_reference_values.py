"""Reference values of Bessel functions, the bobbin and periodic Amsler surfaces, beside scipy."""

from fractions import Fraction
from math import asinh, cosh, pi, sin, sqrt, tan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, minimize_scalar
from scipy.special import iv

from theory import bessel_reference as bessel
from theory import bobbin_reference as bobbin
from theory import painleve_float
from theory import periodic_amsler_reference as amsler
from theory.errors import DomainError, InsufficientPrecisionError, SingularEdgeError


@given(x=st.fractions(Fraction(1, 1000), 50, max_denominator=1000), digits=st.integers(1, 60))
def test_the_inverse_of_i0_undoes_it(x: Fraction, digits: int):
    back = bessel.inverse_i0(
        lambda: mp.besseli(0, mp.mpf(x.numerator) / x.denominator), digits=digits
    )
    with mp.workdps(digits + 10):
        assert abs(back - mp.mpf(x.numerator) / x.denominator) <= x * mp.mpf(10) ** -digits


def test_bessel_values_agree_with_scipy():
    assert abs(bessel.i0(Fraction(5, 2)) - iv(0, 2.5)) < 1e-14
    assert abs(bessel.i1(Fraction(5, 2)) - iv(1, 2.5)) < 1e-14
    assert abs(bessel.fixed_point() - brentq(lambda x: iv(0, x) - 3, 0, 5)) < 1e-11
    touching = minimize_scalar(lambda w: iv(0, 2 * w * w) / (3 * w * w), bracket=(0.5, 1, 1.5))
    assert abs(bessel.supporting_constant() - touching.fun) < 1e-14
    # The minimum is flat: its place is known to the root of the precision.
    assert abs(bessel.supporting_argument() - touching.x) < 1e-7


def test_the_inverse_next_to_1_and_far_away():
    with mp.workdps(60):
        x = bessel.inverse_i0(Fraction(10**40 + 1, 10**40), digits=40)
        # I_0 = 1 + x^2/4 + x^4/64 + ...
        assert abs(x**2 / 4 + x**4 / 64 - mp.mpf(10) ** -40) < mp.mpf(10) ** -78
        x = bessel.inverse_i0(10**300, digits=40)
        assert abs(mp.besseli(0, x) / mp.mpf(10) ** 300 - 1) < mp.mpf(10) ** -36
        x = bessel.inverse_i0(1 + Fraction(1, 10**200))
        assert abs(x**2 / 4 * mp.mpf(10) ** 200 - 1) < mp.mpf(10) ** -28
    assert bessel.inverse_i0(1) == 0


def _bobbin_float(kappa: float, end: float) -> tuple[float, float]:
    """Arc length and height at xi = end by Runge-Kutta from s'' = -sinh s cosh s/(kappa^2 + 1)."""
    square = kappa**2 + 1

    def force(_xi, state):
        s, rate, _ = state
        return (
            rate,
            -np.sinh(s) * np.cosh(s) / square,
            (kappa**2 - np.sinh(s) ** 2) / (kappa * sqrt(square)),
        )

    start = (0.0, kappa / sqrt(square), 0.0)
    solution = solve_ivp(force, (0, end), start, method="DOP853", rtol=1e-12, atol=1e-13)
    return solution.y[0, -1], solution.y[2, -1]


@pytest.mark.parametrize("kappa", [Fraction(1, 2), Fraction(2), Fraction(20)])
@pytest.mark.parametrize("xi", [Fraction(1, 3), Fraction(9)])
def test_elliptic_functions_solve_the_equation_of_the_bobbin(kappa: Fraction, xi: Fraction):
    s, z = _bobbin_float(float(kappa), float(xi))
    assert abs(bobbin.arc_length(kappa, xi) - s) < 1e-10
    assert abs(bobbin.radius(kappa, xi) - cosh(s) / float(kappa)) < 1e-10
    assert abs(bobbin.height(kappa, xi) - z) < 1e-10


def test_the_bobbin_turns_at_a_quarter_of_its_period():
    def quarter():
        return bobbin.period(3, digits=40) / 4

    with mp.workdps(40):
        assert abs(bobbin.turning_point(3) - quarter()) < mp.mpf(10) ** -28
        turned = bobbin.arc_length(3, quarter, digits=30)
        assert abs(turned - bobbin.half_length(3)) < mp.mpf(10) ** -29
        once = bobbin.height(3, lambda: 4 * quarter(), digits=30)
        assert abs(once - 4 * bobbin.height(3, quarter)) < mp.mpf(10) ** -28
    assert abs(bobbin.half_length(3) - asinh(3)) < 1e-14
    assert bobbin.arc_length(3, 0) == bobbin.height(3, 0) == 0


def test_a_bobbin_with_a_flat_throat_climbs_like_a_pendulum():
    """For small kappa z = kappa (xi/2 + sin(2 xi)/4) up to the relative size kappa^2."""
    with mp.workdps(40):
        found = bobbin.height(Fraction(1, 10**60), 10**6) * mp.mpf(10) ** 60
        assert abs(found - (mp.mpf(10) ** 6 / 2 + mp.sin(2 * 10**6) / 4)) < mp.mpf(10) ** -23


@given(radius=st.fractions(Fraction(1, 1000), 400, max_denominator=1000))
def test_the_best_bobbin_has_the_curvature_cosh_of_the_radius(radius: Fraction):
    """Both curvatures are equal where kappa^2 = cosh^2 R, which the search does not know."""
    with mp.workdps(40):
        wanted = mp.cosh(mp.mpf(radius.numerator) / radius.denominator)
        assert abs(bobbin.least_max_curvature(radius, digits=35) / wanted - 1) < mp.mpf(10) ** -34


@pytest.mark.parametrize(("kappa", "radius"), [(2, 1), (2, 1.4), (5, 0.1), (1.1, 0.9)])
def test_the_largest_curvature_on_a_disk_is_the_largest_at_any_height(kappa, radius):
    """Curvatures a = sqrt((kappa^2 + 1)/cosh^2 s - 1) and 1/a at 2001 heights |s| <= R."""
    heights = np.linspace(-radius, radius, 2001)
    about = np.sqrt((kappa**2 + 1) / np.cosh(heights) ** 2 - 1)
    wanted = max(about.max(), (1 / about).max())
    found = bobbin.disk_max_curvature(Fraction(kappa), Fraction(radius))
    assert abs(found / wanted - 1) < 1e-12


def _rim_angle_float(radius: float, phi0: float) -> float:
    """Angle at distance R along the mirror line, from scipy alone."""
    z = brentq(lambda z: painleve_float.diagonal(phi0, z) - radius, 1e-9,
               painleve_float.crossing(phi0, pi))  # fmt: skip
    return painleve_float.angle(phi0, z)


@pytest.mark.parametrize(("radius", "sectors"), [(1, 6), (2, 8), (3, 16), (3, 20)])
def test_the_curvature_of_periodic_amsler_surfaces_agrees_with_scipy(radius: int, sectors: int):
    phi0 = 2 * pi / sectors
    rim = _rim_angle_float(radius, phi0)
    wanted = max(1 / tan(phi0 / 2), tan(rim / 2))
    assert abs(amsler.max_curvature(radius, sectors) / wanted - 1) < 1e-9


def _end_of_geodesic(radius: float, phi0: float, share: float) -> float:
    """Angle phi at the end of the geodesic from the apex that splits phi0 in this share.

    Geodesic equations of du^2 + 2 cos phi du dv + dv^2, scipy throughout.
    """
    solution = painleve_float._integrated(phi0, painleve_float.crossing(phi0, pi),
                                          dense_output=True).sol  # fmt: skip

    def at(u: float, v: float) -> tuple[float, float]:
        z = 2 * sqrt(max(u * v, 0))
        phi, rate, _ = solution(z) if z > 1e-3 else (phi0, sin(phi0) * z / 2, 0)
        return phi, rate / z if z > 1e-3 else sin(phi0) / 2

    def force(_s, state):
        u, v, du, dv = state
        phi, by_z = at(u, v)
        phi_u, phi_v = 2 * v * by_z, 2 * u * by_z
        cot, csc = 1 / tan(phi), 1 / sin(phi)
        return (
            du,
            dv,
            -cot * phi_u * du**2 + csc * phi_v * dv**2,
            csc * phi_u * du**2 - cot * phi_v * dv**2,
        )

    first = sin((1 - share) * phi0) / sin(phi0), sin(share * phi0) / sin(phi0)
    ended = solve_ivp(force, (0, radius), (0, 0, *first), method="DOP853", rtol=1e-10, atol=1e-12)
    u, v, du, dv = ended.y[:, -1]
    phi = at(u, v)[0]
    # The unit speed is kept only if the Christoffel symbols are those of the metric.
    assert abs(du**2 + 2 * np.cos(phi) * du * dv + dv**2 - 1) < 1e-8
    return phi


def test_the_angle_on_the_rim_is_largest_on_the_mirror_line():
    angles = [_end_of_geodesic(1.5, pi / 3, share) for share in (0.1, 0.25, 0.4, 0.5, 0.6)]
    assert max(angles) == angles[3]
    assert abs(angles[3] - _rim_angle_float(1.5, pi / 3)) < 1e-7
    assert abs(angles[2] - angles[4]) < 1e-7


@settings(max_examples=8)
@given(radius=st.fractions(Fraction(1, 10), 4, max_denominator=50))
def test_no_number_of_sectors_is_better_than_the_best(radius: Fraction):
    best = amsler.best_sectors(radius)
    least = amsler.max_curvature(radius, digits=15)
    for other in {best - 2, best + 2, best + 4} - {2}:
        try:
            assert amsler.max_curvature(radius, other, digits=15) >= least
        except SingularEdgeError:
            assert other < best


REFUSED = [
    (lambda: bessel.i0(-1), DomainError, "x must lie in"),
    (lambda: bessel.i0(mp.inf), DomainError, "finite"),
    (lambda: bessel.inverse_i0(Fraction(9, 10)), DomainError, "1 or more"),
    (lambda: bessel.fixed_point(digits=10**4), InsufficientPrecisionError, "at most 2000"),
    (lambda: bobbin.arc_length(0, 1), DomainError, "kappa must be positive"),
    (lambda: bobbin.period(-1), DomainError, "kappa must be positive"),
    (lambda: bobbin.least_max_curvature(0), DomainError, "radius must lie in"),
    (lambda: bobbin.least_max_curvature(10**7), DomainError, "radius must lie in"),
    (lambda: bobbin.disk_max_curvature(1, 1), DomainError, "singular edge"),
    (lambda: amsler.max_curvature(0, 6), DomainError, "radius must lie in"),
    (lambda: amsler.max_curvature(1, 5), DomainError, "even integer"),
    (lambda: amsler.max_curvature(1, 2), DomainError, "even integer"),
    (lambda: amsler.max_curvature(5, 6), SingularEdgeError, "singular edge"),
    (lambda: amsler.best_sectors(-1), DomainError, "radius must lie in"),
]


@pytest.mark.parametrize(("call", "error", "said"), REFUSED)
def test_what_is_outside_the_domain_has_a_named_error(call, error, said):
    with pytest.raises(error, match=said):
        call()
