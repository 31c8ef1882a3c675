"""The certified route of PIII: containment beside odefun, comparison, families, refusals."""

import subprocess
import sys
from fractions import Fraction
from itertools import pairwise

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from odefun_route import fresh_odefun

from theory import painleve
from theory.enclosure import Enclosure
from theory.errors import (
    DomainError,
    InsufficientPrecisionError,
    PastFirstCrossingError,
    PastFirstMaximumError,
)
from theory.precision import working

ODEFUN_DIGITS = 22
ODEFUN_ERROR = Fraction(1, 10**17)
"""odefun promises 22 digits of each step; five are left to its accumulated error."""

ANGLES = st.fractions(Fraction(1, 20), 3, max_denominator=50)
FAMILY = arb("0.03141", "0.0000157")
"""Initial angles within a relative 5e-4 of 0.03141: their relative width is 1e-3."""


def pi_part(n: int):
    return lambda: arb.pi() / n


def exact(value: mp.mpf) -> Fraction:
    sign, mantissa, exponent, _ = value._mpf_
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def assert_encloses(found: Enclosure, value: mp.mpf, error: Fraction, digits: int) -> None:
    """Near the value, narrow, and with a decimal."""
    low, high = found.ends()
    assert low - error <= exact(value) <= high + error
    assert found.is_accurate_to(digits)
    assert found.decimal(digits) is not None


def below(first: Enclosure, second: Enclosure) -> bool:
    return first.ends()[1] < second.ends()[0]


@settings(max_examples=12)
@given(
    phi0=ANGLES,
    z=st.fractions(1, 7, max_denominator=20),
    digits=st.integers(1, 40),
)
def test_angle_and_slope_contain_what_odefun_finds(phi0: Fraction, z: Fraction, digits: int):
    with mp.workdps(ODEFUN_DIGITS):
        start, end = (mp.mpf(q.numerator) / q.denominator for q in (phi0, z))
        angle, slope = fresh_odefun(start)(end)
    assert_encloses(painleve.angle(phi0, z, digits=digits), angle, ODEFUN_ERROR, digits)
    assert_encloses(painleve.slope(phi0, z, digits=digits), slope, ODEFUN_ERROR, digits)


def test_the_first_crossing_of_pi_solves_the_equation_of_odefun():
    found = painleve.crossing(pi_part(100), arb.pi, digits=20)
    with mp.workdps(ODEFUN_DIGITS):
        z = mp.mpf(found.midpoint[0]) * mp.mpf(2) ** found.midpoint[1]
        angle, slope = fresh_odefun(mp.pi / 100)(z)
        assert slope > 1
        assert abs(angle - mp.pi) < exact_tolerance()
    assert found.is_accurate_to(20)


def exact_tolerance() -> mp.mpf:
    return mp.mpf(ODEFUN_ERROR.numerator) / ODEFUN_ERROR.denominator


def test_diagonal_contains_a_quadrature_of_odefun():
    with mp.workdps(ODEFUN_DIGITS):
        solution = fresh_odefun(mp.mpf(1))
        beyond = mp.quad(lambda z: mp.cos(solution(z)[0] / 2), [1, 2, 3, 4])
    found = [painleve.diagonal(1, z, digits=25) for z in (4, 1)]
    with working(200):
        difference = Enclosure.of(found[0].ball() - found[1].ball())
    low, high = difference.ends()
    assert low - ODEFUN_ERROR <= exact(beyond) <= high + ODEFUN_ERROR


def test_small_z_by_the_terms_found_by_hand():
    """Phi = phi0 + s x + s c x^2/4 + (s c^2/4 - s^3/2) x^3/9 + O(x^4), s, c those of phi0."""
    z = Fraction(1, 1000)
    x = z**2 / 4
    with working(200):
        s, c = arb(1).sin_cos()
        terms = 1 + s * _q(x) + s * c / 4 * _q(x) ** 2 + (s * c**2 / 4 - s**3 / 2) * _q(x) ** 3 / 9
        rate = _q(z) / 2 * (s + s * c / 2 * _q(x) + (s * c**2 / 4 - s**3 / 2) * _q(x) ** 2 / 3)
        angle, slope = painleve.angle(1, z, digits=30), painleve.slope(1, z, digits=25)
        assert abs(angle.ball() - terms) < _q(x) ** 4
        assert abs(slope.ball() - rate) < _q(x) ** 3
        # cos(phi/2) = C - S/2 (phi - phi0) + O(x^2), and the integral of x by z is z x/3.
        half_sine, half_cosine = (arb(1) / 2).sin_cos()
        length = half_cosine * _q(z) - half_sine / 2 * s * _q(z * x / 3)
        assert abs(painleve.diagonal(1, z, digits=25).ball() - length) < _q(z) * _q(x) ** 2


def _q(value: Fraction) -> arb:
    return arb(value.numerator) / value.denominator


def test_exact_values_at_the_origin():
    assert painleve.slope(1, 0) == painleve.diagonal(1, 0) == painleve.crossing(1, Fraction(1))
    assert painleve.slope(1, 0).ends() == (0, 0)
    assert painleve.angle(1, 0).ends() == (1, 1)
    level = pi_part(7)
    assert painleve.crossing(level, level).ends() == (0, 0)


def test_beyond_the_crossing_the_angle_oscillates_about_pi():
    """Multiply by phi': E = phi'^2/2 + cos phi falls, by phi'^2/z: and is at least cos phi."""
    energies = []
    for z in (8, 20, 60):
        angle, slope = (f(pi_part(100), z, digits=30) for f in (painleve.angle, painleve.slope))
        with working(200):
            energies.append(slope.ball() ** 2 / 2 + angle.ball().cos())
        assert angle.is_accurate_to(30)
    with working(200):
        energies.append(painleve.angle(pi_part(100), 200, digits=30).ball().cos())
    assert all(first > second for first, second in pairwise(energies))
    assert energies[-1] > -1


@settings(max_examples=25)
@given(phi0=ANGLES, part=st.fractions(Fraction(1, 20), Fraction(9, 10), max_denominator=20))
def test_the_angle_grows_with_z_up_to_the_crossing(phi0: Fraction, part: Fraction):
    first = painleve.crossing(phi0, arb.pi)
    z = part * first.ends()[0]
    assert below(painleve.angle(phi0, z), painleve.angle(phi0, z * Fraction(101, 100)))
    assert painleve.slope(phi0, z).ends()[0] > 0


@settings(max_examples=25)
@given(phi0=ANGLES, part=st.fractions(Fraction(1, 20), 1, max_denominator=20))
def test_a_larger_initial_angle_stays_larger_up_to_its_crossing(phi0: Fraction, part: Fraction):
    larger = phi0 * Fraction(102, 100)
    z = part * painleve.crossing(larger, arb.pi).ends()[0]
    assert below(painleve.angle(phi0, z), painleve.angle(larger, z))
    assert below(painleve.diagonal(larger, z), painleve.diagonal(phi0, z))
    assert below(painleve.crossing(larger, arb.pi), painleve.crossing(phi0, arb.pi))


@settings(max_examples=25)
@given(phi0=ANGLES, part=st.fractions(Fraction(1, 100), 1, max_denominator=100))
def test_the_angle_at_a_crossing_is_the_level(phi0: Fraction, part: Fraction):
    level = phi0 + part * (Fraction(22, 7) - phi0) * Fraction(99, 100)
    place = painleve.crossing(phi0, level, digits=40)
    middle = Fraction(place.midpoint[0]) * Fraction(2) ** place.midpoint[1]
    low, high = painleve.angle(phi0, middle, digits=35).ends()
    assert abs((low + high) / 2 - level) < Fraction(1, 10**30)


def test_levels_next_to_the_first_maximum():
    with pytest.raises(PastFirstMaximumError) as raised:
        painleve.crossing(pi_part(100), 6)
    highest = raised.value.enclosure
    assert highest is not None
    low, high = highest.ends()
    assert Fraction(22, 7) < low <= high < 6
    # phi'' = sin phi < 0 there, so that the level is met a root of the distance earlier.
    place = painleve.crossing(pi_part(100), low - Fraction(1, 10**10))
    assert 0 < painleve.slope(pi_part(100), place.ends()[1]).ends()[0] < Fraction(1, 10**4)
    with pytest.raises(PastFirstMaximumError):
        painleve.crossing(pi_part(100), high + Fraction(1, 10**14))


def test_next_to_pi_the_deviation_is_a_bessel_function():
    """Phi = pi - e J_0(z) + O(e^3), so phi = pi at the first zero of J_0, its maximum at J_1's."""
    deviation = Fraction(1, 10**30)

    def phi0():
        return arb.pi() - arb(10) ** -30

    with mp.workdps(40):
        zero, turn = mp.besseljzero(0, 1), mp.besseljzero(1, 1)
        height = -mp.besselj(0, turn)
    assert abs(painleve.crossing(phi0, arb.pi, digits=35).ends()[0] - exact(zero)) < 10**-30
    with pytest.raises(PastFirstMaximumError):
        painleve.crossing(phi0, lambda: arb.pi() + _q(deviation * exact(height) * 1001 / 1000))
    below_top = painleve.crossing(phi0, lambda: arb.pi() + _q(deviation * exact(height) * 99 / 100))
    assert exact(zero) < below_top.ends()[0] < exact(turn)


@given(part=st.fractions(-1, 1, max_denominator=30), z=st.fractions(0, 6, max_denominator=30))
@settings(max_examples=15)
def test_a_family_encloses_its_members(part: Fraction, z: Fraction):
    low, high = Enclosure.of(FAMILY).ends()
    member = (low + high) / 2 + part * (high - low) / 2
    for function, place in (
        (painleve.angle, z),
        (painleve.slope, z),
        (painleve.diagonal, z),
        (painleve.crossing, Fraction(2)),
        (painleve.crossing, arb.pi),
    ):
        family, single = function(FAMILY, place), function(member, place, digits=20)
        assert family.ends()[0] <= single.ends()[0]
        assert single.ends()[1] <= family.ends()[1]


def test_a_family_is_as_narrow_as_its_ends_allow():
    low, high = Enclosure.of(FAMILY).ends()
    for function, place in (
        (painleve.angle, 6),
        (painleve.diagonal, 6),
        (painleve.crossing, arb.pi),
    ):
        family = function(FAMILY, place).ends()
        ends = [function(end, place).ends()[0] for end in (low, high)]
        spread = abs(ends[1] - ends[0])
        # Radii of flint have 30 bits; the ends are given to 15 digits.
        most = spread * (1 + Fraction(1, 2**28)) + Fraction(1, 10**13)
        assert spread - Fraction(1, 10**13) <= family[1] - family[0] <= most


def test_a_family_is_refused_beyond_its_first_crossing():
    for function in (painleve.angle, painleve.diagonal):
        with pytest.raises(PastFirstCrossingError) as raised:
            function(FAMILY, 7)
        assert raised.value.enclosure is not None
    with pytest.raises(DomainError):
        painleve.crossing(FAMILY, 4)
    with pytest.raises(DomainError):
        painleve.slope(arb(0, 1), 1)


@pytest.mark.parametrize(
    ("function", "arguments", "error"),
    [
        (painleve.angle, (0, 1), DomainError),
        (painleve.angle, (4, 1), DomainError),
        (painleve.angle, (-1, 1), DomainError),
        (painleve.angle, (1, -1), DomainError),
        (painleve.angle, (1, 1001), DomainError),
        (painleve.angle, (arb("nan"), 1), DomainError),
        (painleve.angle, (0.5, 1), TypeError),
        (painleve.angle, ("1/2", 1), TypeError),
        (painleve.crossing, (1, Fraction(1, 2)), DomainError),
        (painleve.crossing, (1, 6), PastFirstMaximumError),
        (painleve.angle, (arb.pi, 1), InsufficientPrecisionError),
    ],
)
def test_bad_arguments_are_named(function, arguments, error):
    with pytest.raises(error):
        function(*arguments)


@pytest.mark.parametrize("digits", [0, -3, 10_001, 2.0, True])
def test_digits_out_of_range(digits):
    with pytest.raises(DomainError, match="digits"):
        painleve.angle(1, 1, digits=digits)


@pytest.mark.parametrize("limit", [20, 64, 100, 160])
def test_too_few_bits_raise_and_never_mislead(limit: int):
    for function, place in ((painleve.angle, 9), (painleve.crossing, arb.pi)):
        with pytest.raises(InsufficientPrecisionError, match=r"50 digits.*bits") as raised:
            function(pi_part(100), place, digits=50, limit=limit)
        wide = raised.value.enclosure
        if wide is not None:
            low, high = function(pi_part(100), place, digits=60).ends()
            assert wide.ends()[0] <= low <= high <= wide.ends()[1]


def test_an_input_of_limited_accuracy_ends_the_search_early():
    with pytest.raises(InsufficientPrecisionError, match="no better"):
        painleve.angle(1, arb(3, 1e-12), digits=20)
    assert painleve.angle(1, arb(3, 1e-12), digits=8).is_accurate_to(8)


def test_the_route_imports_flint_alone():
    code = (
        "import sys, theory.painleve, theory.bessel, theory.bobbin_values, theory.periodic_amsler;"
        "heavy = {'sympy', 'mpmath', 'numpy', 'scipy', 'numba'} & set(sys.modules);"
        "sys.exit(', '.join(sorted(heavy)) or 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
