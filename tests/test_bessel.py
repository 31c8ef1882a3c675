"""Certified Bessel values: beside mpmath, inverted, and at the ends of their domains."""

from fractions import Fraction

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from theory import bessel
from theory.enclosure import Enclosure
from theory.errors import DomainError, InsufficientPrecisionError
from theory.precision import ball_of, working

ARGUMENTS = st.fractions(0, 500, max_denominator=1000)
DIGITS = st.integers(1, 80)
ERROR_DIGITS = 90
"""Digits of the mpmath values, ten more than any that is asked for."""


def near(found: Enclosure, value: mp.mpf) -> bool:
    """Whether the mpmath value lies within its own error of the enclosure."""
    sign, mantissa, exponent, _ = value._mpf_
    exact = (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    low, high = found.ends()
    error = abs(exact) * Fraction(1, 10 ** (ERROR_DIGITS - 5))
    return low - error <= exact <= high + error


@given(x=ARGUMENTS, digits=DIGITS)
def test_i0_and_i1_contain_the_mpmath_values(x: Fraction, digits: int):
    for order, function in enumerate((bessel.i0, bessel.i1)):
        found = function(x, digits=digits)
        with mp.workdps(ERROR_DIGITS):
            assert near(found, mp.besseli(order, mp.mpf(x.numerator) / x.denominator))
        assert found.is_accurate_to(digits)


@given(y=st.fractions(1, 10**6, max_denominator=10**6), digits=DIGITS)
def test_the_inverse_brackets_y_by_i0_of_its_ends(y: Fraction, digits: int):
    found = bessel.inverse_i0(y, digits=digits)
    assert found.is_accurate_to(digits)
    low, high = found.ends()
    with working(600):
        at_low, at_high = (ball_of(end).bessel_i(0) for end in (low, high))
        assert at_low <= ball_of(y) <= at_high or (y == 1 and low == high == 0)


@pytest.mark.parametrize("power", [-200, -30, 30, 300, 10_000])
def test_the_inverse_next_to_1_and_far_away(power: int):
    y = 1 + Fraction(10) ** power
    found = bessel.inverse_i0(y, digits=20)
    low, high = found.ends()
    with working(2000):
        assert ball_of(low).bessel_i(0) < ball_of(y) < ball_of(high).bessel_i(0)
    assert found.is_accurate_to(20)


@settings(max_examples=20)
@given(low=st.fractions(1, 100, max_denominator=100), more=st.fractions(Fraction(1, 100), 10))
def test_the_inverse_grows(low: Fraction, more: Fraction):
    first, second = bessel.inverse_i0(low), bessel.inverse_i0(low + more)
    assert first.ends()[1] < second.ends()[0]


@pytest.mark.parametrize("digits", [1, 30, 80])
def test_the_supporting_quadratic_touches_from_below(digits: int):
    constant, argument, scale = (
        function(digits=digits)
        for function in (
            bessel.supporting_constant,
            bessel.supporting_argument,
            bessel.supporting_scale,
        )
    )
    with mp.workdps(ERROR_DIGITS):
        touching = mp.findroot(lambda t: t * mp.besseli(1, t) - mp.besseli(0, t), 1.6)
        least = mp.besseli(0, touching) * 2 / (3 * touching)
        assert near(constant, least)
        assert near(argument, mp.sqrt(touching / 2))
        assert near(scale, 1 / mp.sqrt(least))
    assert all(found.is_accurate_to(digits) for found in (constant, argument, scale))


@given(w=st.fractions(Fraction(1, 50), 4, max_denominator=50))
def test_no_point_of_the_curve_is_below_the_supporting_quadratic(w: Fraction):
    with working(200):
        place = ball_of(w)
        curve = (2 * place**2).bessel_i(0) / (3 * place**2)
        assert curve > bessel.supporting_constant(digits=30).ball() * (1 - arb(10) ** -25)


def test_the_fixed_point_of_the_ratio_bound():
    low, high = bessel.fixed_point(digits=40).ends()
    with working(300):
        assert ball_of(low).bessel_i(0) < 3 < ball_of(high).bessel_i(0)
    assert bessel.fixed_point(digits=40) == bessel.inverse_i0(3, digits=40)
    assert bessel.inverse_i0(1).ends() == (0, 0)


@pytest.mark.parametrize(
    ("function", "argument", "error"),
    [
        (bessel.inverse_i0, Fraction(1, 2), DomainError),
        (bessel.inverse_i0, -3, DomainError),
        (bessel.inverse_i0, lambda: arb(10) ** arb(10) ** 7, DomainError),
        (bessel.i0, 10**6 + 1, DomainError),
        (bessel.i1, 1.5, TypeError),
        (bessel.inverse_i0, lambda: arb(2).sqrt() ** 2 - 1, InsufficientPrecisionError),
        (bessel.inverse_i0, arb(2, 1e-3), InsufficientPrecisionError),
    ],
)
def test_bad_arguments_are_named(function, argument, error):
    with pytest.raises(error):
        function(argument)


def test_too_few_bits_raise():
    with pytest.raises(InsufficientPrecisionError):
        bessel.inverse_i0(2, digits=50, limit=60)
