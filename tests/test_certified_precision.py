"""Enclosures as data, the rounding they decide, and flint's context left as it was found."""

import json
import pickle
from decimal import Decimal
from fractions import Fraction
from math import floor

import pytest
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp

from theory import bessel, bobbin_values, painleve, periodic_amsler
from theory.enclosure import Enclosure
from theory.errors import InsufficientPrecisionError, PastFirstMaximumError, UndecidedError
from theory.interval_newton import newton_image, root
from theory.precision import ball_of, certified, coarse, working

FAMILY = arb("0.5", "1e-4")
CALLS = {
    "angle": lambda: painleve.angle(Fraction(1, 3), 7, digits=25),
    "crossing": lambda: painleve.crossing(lambda: arb.pi() / 100, arb.pi, digits=25),
    "diagonal": lambda: painleve.diagonal(Fraction(1, 3), 7, digits=25),
    "family": lambda: painleve.slope(FAMILY, 2),
    "inverse_i0": lambda: bessel.inverse_i0(7, digits=25),
    "height": lambda: bobbin_values.height(2, 9, digits=25),
    "periodic": lambda: periodic_amsler.max_curvature(2, digits=25),
}


@pytest.fixture
def disturbed():
    """A caller's own precision and series length, put back to what the tests started with."""
    before = ctx.prec, ctx.cap
    ctx.prec, ctx.cap = 11, 2
    yield 11, 2
    ctx.prec, ctx.cap = before


@pytest.mark.parametrize("name", CALLS)
def test_a_disturbed_context_changes_nothing_and_is_left_alone(name: str):
    before = ctx.prec, ctx.cap
    undisturbed = CALLS[name]()
    try:
        for bits, length in ((11, 2), (5000, 1), (64, 10_000)):
            ctx.prec, ctx.cap = bits, length
            assert CALLS[name]() == undisturbed
            assert (ctx.prec, ctx.cap) == (bits, length)
    finally:
        ctx.prec, ctx.cap = before


def test_the_context_comes_back_after_an_error(disturbed):
    with pytest.raises(PastFirstMaximumError):
        painleve.crossing(1, 6)
    with pytest.raises(InsufficientPrecisionError):
        painleve.angle(1, 9, digits=40, limit=64)
    with pytest.raises(ZeroDivisionError):
        painleve.diagonal(lambda: arb(1) / 0 if 1 // 0 else arb(1), 9)
    with pytest.raises(KeyboardInterrupt):
        _interrupted()
    assert (ctx.prec, ctx.cap) == disturbed


def _interrupted() -> None:
    with working(300, series_length=77):
        assert (ctx.prec, ctx.cap) == (300, 77)
        raise KeyboardInterrupt


def test_an_argument_that_disturbs_the_context_is_contained():
    def phi0():
        value = arb.pi() / 10
        ctx.cap = 1
        return value

    before = ctx.prec, ctx.cap
    assert painleve.diagonal(phi0, 3, digits=20) == painleve.diagonal(
        lambda: arb.pi() / 10, 3, digits=20
    )
    assert (ctx.prec, ctx.cap) == before


@pytest.mark.parametrize("name", CALLS)
def test_results_travel_exactly(name: str):
    found = CALLS[name]()
    assert pickle.loads(pickle.dumps(found)) == found
    plain = json.loads(json.dumps([found.midpoint, found.radius]))
    assert Enclosure(midpoint=tuple(plain[0]), radius=tuple(plain[1])) == found
    for bits in (8, 1000):
        with working(bits):
            assert Enclosure.of(found.ball()) == found


@given(st.integers(-(2**200), 2**200), st.integers(0, 2**40), st.integers(-300, 300))
def test_a_ball_is_never_narrower_and_as_wide_for_short_radii(mantissa, radius, exponent):
    found = Enclosure(midpoint=(mantissa, -70), radius=(radius, exponent))
    (low, high), (wider_low, wider_high) = found.ends(), Enclosure.of(found.ball()).ends()
    assert wider_low <= low <= high <= wider_high
    if radius < 2**30:
        assert (low, high) == (wider_low, wider_high)


def test_errors_travel_with_their_enclosure():
    with pytest.raises(PastFirstMaximumError) as raised:
        painleve.crossing(1, 6)
    again = pickle.loads(pickle.dumps(raised.value))
    assert type(again) is PastFirstMaximumError
    assert str(again) == str(raised.value) == "level above the first maximum"
    assert again.enclosure == raised.value.enclosure is not None


@given(
    middle=st.fractions(-(10**6), 10**6),
    exponent=st.integers(0, 30),
    digits=st.integers(1, 12),
)
def test_a_decimal_is_decided_only_where_both_ends_agree(middle, exponent, digits):
    found = Enclosure(midpoint=(floor(middle * 2**40), -40), radius=(1, -exponent))
    decimal = found.decimal(digits)
    if decimal is None:
        low, high = (f"{Decimal(e.numerator) / e.denominator:.{digits - 1}e}" for e in found.ends())
        assert Decimal(low) != Decimal(high)
        return
    shown, error = Fraction(decimal), Fraction(found.decimal_error(digits))
    for end in found.ends():
        assert abs(end - shown) <= error
        assert abs(end - shown) <= abs(shown) * Fraction(5, 10**digits)
    assert len(Decimal(decimal).as_tuple().digits) == digits or shown == 0


@pytest.mark.parametrize(
    ("value", "digits", "shown"),
    [
        (Fraction(5, 4), 2, "1.2"),
        (Fraction(7, 4), 2, "1.8"),
        (Fraction(-5, 2), 1, "-2"),
        (Fraction(999, 8), 2, "1.2e+2"),
        (Fraction(9999, 10**4), 3, None),
        (Fraction(1, 1024), 3, "0.000977"),
        (Fraction(1, 2**40), 3, "9.09e-13"),
        (Fraction(2**40), 13, "1099511627776"),
        (Fraction(0), 5, "0"),
    ],
)
def test_exact_numbers_are_written_to_the_nearest_decimal_ties_to_even(value, digits, shown):
    if value.denominator & (value.denominator - 1):
        with working(60):
            found = Enclosure.of(ball_of(value))
        assert found.decimal(digits) == "1.00"
        return
    exponent = value.denominator.bit_length() - 1
    found = Enclosure(midpoint=(value.numerator, -exponent), radius=(0, 0))
    assert found.decimal(digits) == shown


def test_thousands_of_digits_are_written():
    with mp.workdps(10_010):
        expected = mp.nstr(mp.pi, 10_000)
    assert certified(arb.pi, digits=10_000).decimal(10_000) == expected


def test_the_bits_rise_until_cancellation_is_overcome():
    """1 - cos(10^-40) is 10^-80/2 to 80 digits."""
    found = certified(lambda: 1 - (arb(10) ** -40).cos(), digits=30)
    assert found.decimal(30) == "5.00000000000000000000000000000e-81"


def test_what_no_precision_decides_ends_at_the_limit():
    bits: list[int] = []

    def compute():
        bits.append(ctx.prec)
        return arb(1).sin() ** 2 + arb(1).cos() ** 2 - 1

    with pytest.raises(InsufficientPrecisionError, match="2000 bits") as raised:
        certified(compute, digits=5, limit=2000)
    assert bits[-1] == 2000
    assert bits == sorted(bits)
    assert raised.value.enclosure.contains(0)

    def undecided():
        raise UndecidedError("never", None)

    with pytest.raises(InsufficientPrecisionError):
        certified(undecided, digits=5, limit=500)


@given(st.floats(1e-200, 1e200), st.integers(2, 40))
def test_a_coarse_number_is_short_and_just_below(value, bits):
    found = coarse(value, bits=bits)
    assert found.is_exact()
    assert found <= arb(value)
    assert found >= arb(value) * (1 - arb(2) ** (2 - bits))
    assert int(found.man_exp()[0]).bit_length() <= bits + 1


def test_roots_are_isolated_or_refused():
    with working(200):
        found = root(lambda t: t * t - 2, lambda t: 2 * t, arb(0), arb(2))
        assert found.overlaps(arb(2).sqrt())
        assert found.rel_accuracy_bits() > 180
        assert newton_image(arb(0), lambda t: 2 * t, arb(0), arb(0, 1)) is None
        with pytest.raises(UndecidedError):
            root(lambda t: (t - 1) ** 3, lambda t: 3 * (t - 1) ** 2, arb(0), arb(3))
        with pytest.raises(UndecidedError):
            root(lambda t: t * t + 1, lambda t: 2 * t, arb(0), arb(2))
