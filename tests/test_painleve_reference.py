"""The reference and the float64 route of PIII, beside odefun and limits in closed form."""

from fractions import Fraction

import mpmath
import pytest
from flint import arb
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mp
from odefun_route import fresh_odefun

from theory import painleve, painleve_float, painleve_series
from theory import painleve_reference as reference
from theory.enclosure import Enclosure
from theory.errors import DomainError, InsufficientPrecisionError, PastFirstMaximumError

POINTS = [
    (Fraction(1, 100), Fraction(5)),
    (Fraction(1), Fraction(1, 1000)),
    (Fraction(1), Fraction(3)),
    (Fraction(3, 2), Fraction(40)),
    (Fraction(31, 10), Fraction(12)),
    (Fraction(1, 10**12), Fraction(31)),
]
FLOAT_ERROR = 2e-11
"""Relative tolerance 1e-13 of the Runge-Kutta method, times its steps up to z = 40."""


@pytest.mark.parametrize(("phi0", "z"), [(Fraction(1), 6), (Fraction(1, 7), 4), (Fraction(3), 5)])
def test_odefun_gives_the_same_solution(phi0: Fraction, z: int):
    with mp.workdps(22):
        angle, slope = fresh_odefun(mp.mpf(phi0.numerator) / phi0.denominator)(z)
        assert abs(reference.angle(phi0, z, digits=22) - angle) < mp.mpf(10) ** -18
        assert abs(reference.slope(phi0, z, digits=22) - slope) < mp.mpf(10) ** -18


@pytest.mark.parametrize(("phi0", "z"), POINTS)
@pytest.mark.parametrize("name", ["angle", "slope", "diagonal"])
def test_float64_agrees_within_its_error(name: str, phi0: Fraction, z: Fraction):
    exact = getattr(reference, name)(phi0, z, digits=18)
    estimate = getattr(painleve_float, name)(float(phi0), float(z))
    size = max(abs(exact), float(phi0) if name == "angle" else float(z) * float(phi0))
    assert abs(exact - estimate) < FLOAT_ERROR * size


@pytest.mark.parametrize(
    ("phi0", "level"), [(0.01, 3.0), (1.0, 4.0), (0.5, 0.5 + 1e-9), (3.0, 3.1)]
)
def test_crossings_agree_in_float64(phi0: float, level: float):
    exact = reference.crossing(Fraction(phi0), Fraction(level), digits=18)
    assert abs(painleve_float.crossing(phi0, level) - exact) < 1e-6 * exact
    if level - phi0 > 1e-3:
        assert abs(painleve_float.crossing(phi0, level) - exact) < 1e-10 * exact


def test_small_angles_follow_the_bessel_function():
    """phi/phi0 = I_0(z) up to the relative size phi^2 of the cubic term of the sine."""
    phi0, z = Fraction(1, 10**40), 20
    with mp.workdps(60):
        scale = mp.mpf(10) ** -40
        assert abs(reference.angle(phi0, z, digits=50) / scale - mp.besseli(0, z)) < 1e-40
        assert abs(reference.slope(phi0, z, digits=50) / scale - mp.besseli(1, z)) < 1e-40
        assert abs(reference.diagonal(phi0, z, digits=50) - z) < mp.mpf(10) ** -45


def test_angles_near_pi_oscillate_like_the_other_bessel_function():
    def phi0():
        return mp.pi - mp.mpf(10) ** -40

    with mp.workdps(60):
        gap = (mp.pi - reference.angle(phi0, 30, digits=55)) * mp.mpf(10) ** 40
        assert abs(gap - mp.besselj(0, 30)) < mp.mpf(10) ** -14
        slope = reference.slope(phi0, 30, digits=30) * mp.mpf(10) ** 40
        assert abs(slope / mp.besselj(1, 30) - 1) < mp.mpf(10) ** -29


def test_it_solves_the_equation_and_starts_as_it_should():
    """Central differences with step h: their error is of order h^2."""
    phi0 = Fraction(1, 3)
    with mp.workdps(65):
        z, h = mp.mpf(5), mp.mpf(10) ** -12
        before, at, after = (reference.angle(phi0, z + k * h, digits=60) for k in (-1, 0, 1))
        slope = (after - before) / (2 * h)
        residual = (after - 2 * at + before) / h**2 + slope / z - mp.sin(at)
        assert abs(residual) < 1e-23
        assert abs(slope - reference.slope(phi0, z)) < 1e-23
        assert abs(reference.angle(phi0, 0, digits=60) - mp.mpf(1) / 3) < mp.mpf(10) ** -60
        assert reference.slope(phi0, 0) == 0
        assert reference.diagonal(phi0, 0) == 0


def test_the_diagonal_is_the_integral():
    with mp.workdps(20):
        wanted = mp.quad(
            lambda z: mp.cos(reference.angle(1, z, digits=22) / 2), [0, 3, 6], maxdegree=4
        )
        assert abs(reference.diagonal(1, 6) - wanted) < 1e-17


def test_the_first_maximum_is_one_and_no_level_above_it_is_crossed():
    place, top = reference.first_maximum(1, digits=40)
    with mp.workdps(45):
        assert abs(reference.slope(1, place, digits=10)) < mp.mpf(10) ** -38
        assert abs(reference.angle(1, place, digits=40) - top) < mp.mpf(10) ** -38
        gap = mp.mpf(10) ** -25
        z = reference.crossing(1, top - gap, digits=25)
        # Near the maximum phi falls by phi''/2 times the square of the distance.
        bend = -mp.sin(top)
        assert abs((place - z) ** 2 * bend / 2 / gap - 1) < 1e-9
        with pytest.raises(PastFirstMaximumError, match="above the first maximum"):
            reference.crossing(1, top + gap)
    with pytest.raises(PastFirstMaximumError):
        painleve_float.crossing(1.0, float(top) + 1e-6)


@settings(max_examples=30)
@given(
    phi0=st.fractions(Fraction(1, 1000), Fraction(31, 10), max_denominator=10**4),
    share=st.fractions(Fraction(1, 1000), 1, max_denominator=1000),
    digits=st.integers(2, 40),
)
def test_crossing_inverts_the_angle(phi0: Fraction, share: Fraction, digits: int):
    def level():
        start = mp.mpf(phi0.numerator) / phi0.denominator
        return start + (mp.pi - start) * share.numerator / share.denominator

    z = reference.crossing(phi0, level, digits=digits + 2)
    with mp.workdps(digits + 10):
        assert abs(reference.angle(phi0, z, digits=digits + 8) - level()) < mp.mpf(10) ** -digits


@settings(max_examples=20)
@given(
    phi0=st.fractions(Fraction(1, 1000), Fraction(31, 10), max_denominator=10**4),
    z=st.fractions(0, 15, max_denominator=100),
    digits=st.integers(1, 40),
)
def test_more_digits_only_refine(phi0: Fraction, z: Fraction, digits: int):
    for name in ("angle", "slope", "diagonal"):
        function = getattr(reference, name)
        few, many = function(phi0, z, digits=digits), function(phi0, z, digits=digits + 20)
        with mp.workdps(digits + 30):
            assert abs(few - many) <= abs(many) * mp.mpf(10) ** -digits


def _as_fraction(number) -> Fraction:
    sign, mantissa, exponent, _ = number._mpf_
    return (-1) ** sign * int(mantissa) * Fraction(2) ** int(exponent)


def _decimals(enclosure: Enclosure) -> int:
    """Digits to which the enclosure is accurate, and ten more."""
    low, high = enclosure.ends()
    return max(20, int(mp.log10(abs(low + high) / (high - low + Fraction(1, 10**200)))) + 10)


@settings(max_examples=40)
@given(
    share=st.fractions(Fraction(1, 1000), Fraction(999, 1000), max_denominator=1000),
    z=st.fractions(Fraction(1, 100), 25, max_denominator=100),
    digits=st.integers(1, 40),
    name=st.sampled_from(["angle", "slope", "diagonal"]),
)
def test_the_certified_enclosure_contains_the_reference(share, z, digits: int, name: str):
    p, q = share.numerator, share.denominator
    enclosure = getattr(painleve, name)(lambda: arb.pi() * p / q, z, digits=digits)
    number = getattr(reference, name)(lambda: mp.pi * p / q, z, digits=_decimals(enclosure))
    assert enclosure.is_accurate_to(digits)
    assert enclosure.contains(_as_fraction(number))


@settings(max_examples=30)
@given(
    share=st.fractions(Fraction(1, 1000), Fraction(999, 1000), max_denominator=1000),
    height=st.fractions(Fraction(1, 100), 1, max_denominator=100),
    digits=st.integers(1, 40),
)
def test_the_certified_crossing_contains_the_reference(share, height, digits: int):
    ratio = share + height * (1 - share)
    p, q, a, b = *share.as_integer_ratio(), *ratio.as_integer_ratio()
    enclosure = painleve.crossing(lambda: arb.pi() * p / q, lambda: arb.pi() * a / b, digits=digits)
    number = reference.crossing(
        lambda: mp.pi * p / q, lambda: mp.pi * a / b, digits=_decimals(enclosure)
    )
    assert enclosure.is_accurate_to(digits)
    assert enclosure.contains(_as_fraction(number))


def _below(first: Enclosure, second: Enclosure) -> bool:
    return first.ends()[1] < second.ends()[0]


SHARES = st.fractions(Fraction(1, 1000), Fraction(999, 1000), max_denominator=1000)


@settings(max_examples=25)
@given(share=SHARES, places=st.tuples(SHARES, SHARES))
def test_the_angle_rises_up_to_the_crossing_of_pi(share: Fraction, places):
    """Places are shares of the first crossing; both routes are asked."""
    phi0 = 3 * share
    near, far = (
        place * Fraction(float(reference.crossing(phi0, mp.pi))) for place in sorted(places)
    )
    if near < far:
        assert _below(painleve.angle(phi0, near, digits=20), painleve.angle(phi0, far, digits=20))
        assert reference.angle(phi0, near) < reference.angle(phi0, far)


@settings(max_examples=25)
@given(shares=st.tuples(SHARES, SHARES), place=SHARES)
def test_a_larger_initial_angle_gives_a_larger_angle(shares, place: Fraction):
    """Comparison up to the first crossing of pi by the larger one."""
    small, large = (3 * share for share in sorted(shares))
    z = place * Fraction(float(reference.crossing(large, mp.pi)))
    if small < large:
        assert _below(painleve.angle(small, z, digits=20), painleve.angle(large, z, digits=20))
        assert reference.angle(small, z) < reference.angle(large, z)


@pytest.mark.parametrize("z", [60, 200])
def test_the_routes_agree_far_into_the_oscillations(z: int):
    enclosure = painleve.angle(1, z, digits=10)
    number = reference.angle(1, z, digits=_decimals(enclosure))
    assert enclosure.contains(_as_fraction(number))
    assert abs(painleve_float.angle(1.0, float(z)) - number) < 1e-10


def test_numbers_next_to_the_end_of_a_domain_are_told_from_it():
    """Each difference is far below the first precision tried."""
    tiny = Fraction(1, 10**90)
    with mp.workdps(30):
        z = reference.crossing(1, 1 + tiny)
        assert abs(z**2 * mp.sin(1) / 4 * mp.mpf(10) ** 90 - 1) < mp.mpf(10) ** -28
        near = reference.crossing(lambda: mp.pi - mp.mpf(10) ** -90, mp.pi)
        assert abs(near - mp.besseljzero(0, 1)) < mp.mpf(10) ** -28
    assert reference.crossing(Fraction(1, 3), Fraction(1, 3)) == 0
    with pytest.raises(DomainError, match="below phi0"):
        reference.crossing(1 + tiny, 1)
    with pytest.raises(DomainError, match="phi0 must lie in"):
        reference.angle(lambda: mp.pi + mp.mpf(10) ** -90, 1)


REFUSED = [
    (lambda: reference.angle(0, 1), DomainError, "phi0 must lie in"),
    (lambda: reference.angle(4, 1), DomainError, "phi0 must lie in"),
    (lambda: reference.angle(mp.pi, 1), InsufficientPrecisionError, "30 digits not reached"),
    (lambda: reference.crossing(mp.e, lambda: +mp.e), InsufficientPrecisionError, "30 digits not"),
    (lambda: reference.angle(1, -1), DomainError, "z must lie in"),
    (lambda: reference.slope(1, 201), DomainError, "z must lie in"),
    (lambda: reference.diagonal(1, mp.inf), DomainError, "not a finite number"),
    (lambda: reference.crossing(2, 1), DomainError, "below phi0"),
    (lambda: reference.crossing(1, 5), PastFirstMaximumError, "first maximum"),
    (lambda: reference.angle(1, 1, digits=0), DomainError, "digits"),
    (lambda: reference.angle(1, 1, digits=10**7), DomainError, "digits"),
    (lambda: reference.angle(1, 1, digits=10**4), InsufficientPrecisionError, "at most 500"),
    (lambda: reference.angle(0.1, 1), TypeError, "not an exact real"),
    (lambda: reference.angle("1", 1), TypeError, "not an exact real"),
    (lambda: reference.angle(True, 1), TypeError, "not an exact real"),
    (lambda: painleve_float.angle(4.0, 1.0), DomainError, "phi0 must lie in"),
    (lambda: painleve_float.slope(1.0, -1.0), DomainError, "z must lie in"),
    (lambda: painleve_float.angle(float("nan"), 1.0), DomainError, "phi0 must lie in"),
    (lambda: painleve_float.diagonal(1.0, float("nan")), DomainError, "z must lie in"),
    (lambda: painleve_float.crossing(2.0, 1.0), DomainError, "level must lie in"),
]


@pytest.mark.parametrize(("call", "error", "said"), REFUSED)
def test_what_is_outside_the_domain_has_a_named_error(call, error, said):
    before = mpmath.mp.prec
    with pytest.raises(error, match=said):
        call()
    assert mpmath.mp.prec == before


def test_a_series_cut_short_is_seen_beside_float64(monkeypatch: pytest.MonkeyPatch):
    """Mutant: a step that is far too long for its order."""
    monkeypatch.setattr(painleve_series, "_order", lambda: 6)
    monkeypatch.setattr(painleve_series, "_reach", lambda *_: mp.one)
    wrong = reference.angle(1, 6, digits=18)
    assert abs(wrong - painleve_float.angle(1.0, 6.0)) > 1e-6
