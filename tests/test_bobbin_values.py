"""Certified values of Minding's bobbin: beside mpmath's solution of the equations of motion."""

from fractions import Fraction

import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp

from theory import bobbin_values as bobbin
from theory.enclosure import Enclosure
from theory.errors import DomainError, InsufficientPrecisionError
from theory.precision import ball_of, working

DIGITS = 25
ERROR = Fraction(1, 10**18)
"""mpmath works with 22 digits; four are left to the accumulated error of odefun."""


def mpf(value: Fraction) -> mp.mpf:
    return mp.mpf(value.numerator) / value.denominator


def fraction(value: mp.mpf) -> Fraction:
    sign, mantissa, exponent, _ = value._mpf_
    return (-1) ** sign * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def near(found: Enclosure, value: mp.mpf) -> bool:
    low, high = found.ends()
    return low - ERROR <= fraction(value) <= high + ERROR


@pytest.mark.parametrize(("kappa", "xi"), [(3, 2), (1, 3), (Fraction(1, 5), 1)])
def test_the_orbit_contains_the_motion_in_the_potential(kappa: Fraction, xi: int):
    """Solve s'' = -sinh s cosh s/(kappa^2 + 1), the height's rate being a nonnegative root."""
    with mp.workdps(22):
        k = mpf(Fraction(kappa))
        square = k**2 + 1
        orbit = mp.odefun(
            lambda _, y: [
                y[1],
                -mp.sinh(y[0]) * mp.cosh(y[0]) / square,
                (k**2 - mp.sinh(y[0]) ** 2) / (k * mp.sqrt(square)),
            ],
            0,
            [0, k / mp.sqrt(square), 0],
        )
        arc, _, height = orbit(xi)
        assert near(bobbin.arc_length(kappa, xi, digits=DIGITS), arc)
        assert near(bobbin.radius(kappa, xi, digits=DIGITS), mp.cosh(arc) / k)
        assert near(bobbin.height(kappa, xi, digits=DIGITS), height)


@given(
    kappa=st.fractions(Fraction(1, 10), 50, max_denominator=20),
    psi=st.fractions(Fraction(1, 20), 9, max_denominator=20),
)
def test_the_orbit_contains_quadratures_over_many_turns(kappa: Fraction, psi: Fraction):
    """By psi with sinh s = kappa sin psi, ds/dxi = sqrt(kappa^2 - sinh^2 s)/sqrt(kappa^2 + 1)."""
    with mp.workdps(30):
        k, end = mpf(kappa), mpf(psi)
        turns = [n * mp.pi / 2 for n in range(int(2 * end / mp.pi) + 1)]
        corners = sorted({*turns, *(t + mp.atan(1 / k) for t in turns), end, mp.mpf(0)})
        corners = [corner for corner in corners if corner <= end]
        root = mp.sqrt(k**2 + 1)
        xi = mp.quad(lambda p: root / mp.sqrt(1 + (k * mp.sin(p)) ** 2), corners)
        height = mp.quad(lambda p: k * mp.cos(p) ** 2 / mp.sqrt(1 + (k * mp.sin(p)) ** 2), corners)
        arc = mp.asinh(k * mp.sin(end))
        place = fraction(xi)
        assert near(bobbin.arc_length(kappa, place, digits=DIGITS), arc)
        assert near(bobbin.radius(kappa, place, digits=DIGITS), mp.cosh(arc) / k)
        assert near(bobbin.height(kappa, place, digits=DIGITS), height)
        assert near(bobbin.height(kappa, -place, digits=DIGITS), -height)
        assert near(bobbin.arc_length(kappa, -place, digits=DIGITS), -arc)


@given(kappa=st.fractions(Fraction(1, 100), 100, max_denominator=100))
def test_the_quarter_period_by_a_quadrature(kappa: Fraction):
    """From the throat to s = L: the integral of ds/s', regular in sinh s = kappa sin psi."""
    with mp.workdps(30):
        k = mpf(kappa)
        quarter = mp.quad(
            lambda psi: mp.sqrt(k**2 + 1) / mp.sqrt(1 + k**2 * mp.sin(psi) ** 2),
            [0, mp.atan(1 / k), mp.pi / 2],
        )
        assert near(bobbin.turning_point(kappa, digits=DIGITS), quarter)
        assert near(bobbin.period(kappa, digits=DIGITS), 4 * quarter)
        assert near(bobbin.half_length(kappa, digits=DIGITS), mp.asinh(k))


@settings(max_examples=20)
@given(kappa=st.fractions(Fraction(1, 10), 10, max_denominator=10), turns=st.integers(-3, 3))
def test_the_orbit_turns_at_the_edge_and_repeats(kappa: Fraction, turns: int):
    def quarters(number: int):
        return lambda: bobbin.turning_point(kappa, digits=60).ball() * number

    edge = bobbin.arc_length(kappa, quarters(4 * turns + 1), digits=12)
    low, high = bobbin.half_length(kappa, digits=12).ends()
    assert edge.ends()[0] <= high
    assert low <= edge.ends()[1]
    # As much height is gained in every half period.
    one, more = (bobbin.height(kappa, quarters(n), digits=12).ball() for n in (1, 2 * turns + 1))
    with working(60):
        assert (more - (2 * turns + 1) * one).contains(0)


def test_far_along_and_extreme_throats():
    for kappa in (Fraction(1, 10**6), Fraction(10**6)):
        arc = bobbin.arc_length(kappa, 10**5, digits=30)
        _, high = bobbin.half_length(kappa, digits=30).ends()
        assert -high <= arc.ends()[0] <= arc.ends()[1] <= high
        assert arc.is_accurate_to(30)


@given(
    kappa=st.fractions(Fraction(1, 10), 50, max_denominator=20),
    radius=st.fractions(Fraction(1, 10), 4, max_denominator=20),
)
def test_no_bobbin_is_better_than_the_least(kappa: Fraction, radius: Fraction):
    least = bobbin.least_max_curvature(radius, digits=30)
    with working(200):
        room = ball_of(kappa) ** 2 - ball_of(radius).sinh() ** 2
    if room <= 0:
        with pytest.raises(DomainError, match="singular edge"):
            bobbin.disk_max_curvature(kappa, radius)
        return
    assert bobbin.disk_max_curvature(kappa, radius, digits=30).ends()[1] >= least.ends()[0]


@given(radius=st.fractions(Fraction(1, 10), 20, max_denominator=20))
def test_the_least_is_attained_where_throat_and_edge_balance(radius: Fraction):
    least = bobbin.least_max_curvature(radius, digits=20)
    balanced = bobbin.disk_max_curvature(lambda: ball_of(radius).cosh(), radius, digits=20)
    assert balanced.decimal(15) == least.decimal(15)
    for factor in (Fraction(999, 1000), Fraction(1001, 1000)):
        try:
            other = bobbin.disk_max_curvature(
                lambda f=factor: ball_of(f) * ball_of(radius).cosh(), radius, digits=30
            )
        except DomainError:
            assert factor < 1
            continue
        assert other.ends()[0] > least.ends()[1]


def test_disks_off_the_throat_have_larger_curvature():
    """Squares a/cosh^2 s - 1 and its inverse on |s - s0| <= R, over a grid of throats and s0."""
    radius = arb("1.5")
    for eighths in range(1, 25):
        s0 = arb(eighths) / 8
        far, near_by = s0 + radius, (s0 - radius).max(arb(0))
        for step in range(1, 60):
            a = far.cosh() ** 2 * (1 + arb(step) / 20)
            squares = a / near_by.cosh() ** 2 - 1, 1 / (a / far.cosh() ** 2 - 1)
            assert squares[0].max(squares[1]) > radius.cosh() ** 2


@pytest.mark.parametrize(
    ("function", "arguments", "error"),
    [
        (bobbin.arc_length, (0, 1), DomainError),
        (bobbin.period, (-1,), DomainError),
        (bobbin.least_max_curvature, (0,), DomainError),
        (bobbin.disk_max_curvature, (1, 1), DomainError),
        (bobbin.height, (1.0, 1), TypeError),
        (bobbin.disk_max_curvature, (lambda: arb(1).sinh(), 1), InsufficientPrecisionError),
    ],
)
def test_bad_arguments_are_named(function, arguments, error):
    with pytest.raises(error):
        function(*arguments)
