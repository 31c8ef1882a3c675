"""The Bessel bounds on whole ranges: enclosures, kernel, both routes, and what breaks them."""

from dataclasses import replace
from fractions import Fraction
from itertools import islice

import pytest
from flint import arb, ctx
from hypothesis import given, settings
from hypothesis.strategies import floats, integers
from mpmath import mp

from checks.certificates import painleve_tube
from checks.certificates.amsler_bounds import verdict
from checks.certificates.painleve_tube import NotEnclosedError, grid, tube
from checks.evidence import Setting
from checks.stored import load
from checks.verify import amsler_bounds as room
from theory import amsler_bounds, painleve_reference
from theory.amsler_bounds import cells, column
from theory.bessel_kernel import LinearResponse, quotient_from_below, unit_response
from theory.errors import DomainError
from theory.precision import working
from theory.sinc_quotients import sinc, sinc_defect, sinc_fall, sinc_quotient

TOP = Fraction("3.1316")
STEP = Fraction(1, 20)


def holds(ball: arb, value: object) -> bool:
    """Whether the ball, no wider than a tenth of itself, meets the number good to 25 digits."""
    text = mp.nstr(value, 25)
    return bool(ball.is_finite() and ball.overlaps(arb(text)) and ball.rad() < 1)


@pytest.fixture
def balls():
    with working(64):
        yield


@settings(max_examples=40, deadline=None, derandomize=True)
@given(w=floats(0.01, 12), v=floats(0.01, 12))
def test_quotients_of_the_sine_are_enclosed(w, v):
    with working(64), mp.workdps(40):
        t, s = mp.sqrt(mp.mpf(w)), mp.sqrt(mp.mpf(v))
        first, second = mp.sin(t) / t, mp.sin(s) / s
        assert holds(sinc(arb(w)), first)
        assert holds(sinc_defect(arb(w)), (1 - first) / w)
        assert holds(sinc_fall(arb(w)), -mp.diff(lambda x: mp.sin(mp.sqrt(x)) / mp.sqrt(x), w))
        if abs(w - v) > 1e-3:
            assert holds(sinc_quotient(arb(w), arb(v)), (second - first) / (mp.mpf(w) - v))


def test_quotient_of_equal_squares_is_the_slope(balls):
    assert sinc_quotient(arb(2), arb(2)).overlaps(sinc_fall(arb(2)))


@pytest.mark.parametrize("function", [sinc, sinc_defect, sinc_fall])
def test_squares_beyond_the_series_are_refused(balls, function):
    with pytest.raises(DomainError, match="20"):
        function(arb(21))


@pytest.mark.parametrize(("c", "z"), [(1, 3), (1, 12), ("0.3", 2), ("0.004", 3)])
def test_response_to_a_unit_source_is_the_closed_form(balls, c, z):
    c, z = arb(c).mid(), arb(z)
    response = LinearResponse.at_origin(c)
    for k in range(1, 9):
        response = response.advanced((z * k / 8).mid(), arb(1))
    x = z**2 / 4
    closed = x**2 * unit_response((c * x).mid())
    assert response.value().overlaps(closed)
    assert response.value().rad() < closed / 10**6


def test_response_to_steps_is_the_integral_of_the_kernel(balls):
    heights, z, c = (3, 1, 5), 4, Fraction(3, 4)
    response = LinearResponse.at_origin(arb(3) / 4)
    for k, height in enumerate(heights, start=1):
        response = response.advanced(arb(z) * k / 3 if k < 3 else arb(z), arb(height))

    def kernel(y):
        t, s = mp.sqrt(c) * z, 2 * mp.sqrt(c * y)
        return 2 * (mp.besseli(0, t) * mp.besselk(0, s) - mp.besselk(0, t) * mp.besseli(0, s))

    places = [(mp.mpf(z) * k / 3) ** 2 / 4 for k in range(4)]
    parts = [
        mp.quad(lambda y, b=b: kernel(y) * y * b, [places[k], places[k + 1]])
        for k, b in enumerate(heights)
    ]
    assert abs(float(response.value().mid()) / float(sum(parts)) - 1) < 1e-9


@settings(max_examples=30, deadline=None, derandomize=True)
@given(a=floats(0, 80), b=floats(1e-6, 40))
def test_the_quotient_of_bessel_functions_is_bounded_from_below(a, b):
    with working(64), mp.workdps(40):
        low, high = mp.mpf(a), mp.mpf(a) + mp.mpf(b)
        f = [mp.besseli(0, 2 * mp.sqrt(w)) for w in (low, high)]
        bound = quotient_from_below(arb(a) + arb(b), arb(a))
        assert float(bound) <= float((f[1] - f[0]) / (high - low)) * (1 + 1e-12)


@pytest.mark.parametrize("low", ["1e-6", "1e-3", "0.3", "2.5"])
def test_both_routes_hold_the_reference_values_of_the_family(low):
    first = Fraction(low)
    inner = first * Fraction(1007, 1000)
    with working(64):
        family = arb(first.numerator) / first.denominator
        family = family.union(family * arb("1.01"))
        by_cells = list(islice(cells(family, step=STEP), 40))
        by_tube = list(islice(tube(family, grid(STEP)), 40))
        for kind, stretches in (("cells", by_cells), ("tube", by_tube)):
            for stretch in stretches[::9]:
                z = Fraction(str(float(((stretch.low + stretch.high) / 2).mid())))
                angle = painleve_reference.angle(inner, z, digits=20)
                box = stretch.phi if kind == "cells" else stretch.box
                rise = stretch.rise * (family if kind == "cells" else 1)
                assert holds(box, angle), kind
                assert holds(rise, (angle - mp.mpf(inner.numerator) / inner.denominator) * 4 / z**2)


def test_a_tube_without_its_remainder_misses_the_solution(monkeypatch):
    def without(phi, rate, z, order):
        found = original(phi, rate, z, order)
        return [*found[:-1], arb(0)] if order > painleve_tube.ORDER else found

    def misses() -> bool:
        with working(100):
            steps = grid(Fraction(1, 2))
            last = list(islice(tube(arb(1), steps), 6))[-1]
            z = Fraction(str(float(last.high.mid())))
            value = painleve_reference.angle(Fraction(1), z, digits=25)
            return not last.phi.overlaps(arb(mp.nstr(value, 25)))

    original = painleve_tube._sines
    assert not misses()
    monkeypatch.setattr(painleve_tube, "_sines", without)
    assert misses()


@pytest.mark.parametrize(("low", "high"), [("0.01", "0.0101"), ("1", "1.01"), ("3.13", "3.1305")])
def test_columns_close_by_both_routes(low, high):
    found = column(Fraction(low), Fraction(high), top=TOP, step=STEP)
    assert found.proved
    assert found.gap > 0.1
    with ctx.workprec(64):
        checked = verdict(Fraction(low), Fraction(high), top=TOP, steps=grid(STEP))
    assert not checked.refuted
    assert not checked.open
    # Lower bounds of the same two numbers, each by its own route.
    assert abs(checked.gap / found.gap - 1) < 0.1
    assert checked.quotient > 1 < found.quotient


def test_a_wide_column_is_open_not_proved():
    found = column(Fraction("0.01"), Fraction("0.02"), top=TOP, step=STEP)
    assert not found.proved
    with ctx.workprec(64):
        wide = verdict(Fraction("0.01"), Fraction("0.02"), top=TOP, steps=grid(STEP))
    assert wide.open
    assert not wide.refuted


def test_a_box_that_does_not_close_is_named(monkeypatch):
    monkeypatch.setattr(painleve_tube, "TRIES", 1)
    with ctx.workprec(64), pytest.raises(NotEnclosedError, match="does not close"):
        verdict(Fraction(2), Fraction("2.1"), top=TOP, steps=grid(STEP))


def test_a_smaller_first_part_leaves_the_lower_bound_open(monkeypatch):
    monkeypatch.setattr(
        amsler_bounds, "quotient_from_below", lambda a, b: quotient_from_below(a, b) / 4
    )
    found = column(Fraction(1), Fraction("1.01"), top=TOP, step=STEP)
    assert found.open
    assert not found.proved


def test_a_source_of_the_other_sign_leaves_the_upper_bound_open(monkeypatch):
    monkeypatch.setattr(amsler_bounds, "sinc_defect", lambda w: -sinc_defect(w))
    assert not column(Fraction(1), Fraction("1.01"), top=TOP, step=STEP).proved


@pytest.mark.parametrize(
    ("low", "high", "top"), [("0", "1", "3"), ("1", "1", "3"), ("1", "3.1", "3"), ("1", "2", "4")]
)
def test_columns_outside_the_domain_are_refused(low, high, top):
    with pytest.raises(DomainError, match="0 < low < high"):
        column(Fraction(low), Fraction(high), top=Fraction(top), step=STEP)


@settings(max_examples=20, deadline=None, derandomize=True)
@given(place=integers(0, 700))
def test_a_certificate_with_a_column_left_out_is_refused(place):
    run = load("amsler_bounds")
    columns = run.result["columns"]
    kept = [(Fraction(a), Fraction(b), d) for a, b, d in columns[:place] + columns[place + 1 :]]
    assert room._unsound(run, kept, Fraction("1e-6"))


def test_a_stale_certificate_is_refused(monkeypatch):
    run = load("amsler_bounds")
    sources = {**run.sources, "theory/amsler_bounds.py": "0" * 64}
    monkeypatch.setattr(room, "load", lambda name: replace(run, sources=sources))
    found = room.certificate(Setting())
    assert found.outcome == "fail"
    assert "older" in found.witness


def test_a_column_that_does_not_close_makes_it_undecided(monkeypatch):
    run = load("amsler_bounds")
    rows = [["1e-6", "2.9", 0], ["2.9", "3.1316", 0]]
    monkeypatch.setattr(
        room, "load", lambda name: replace(run, result={**run.result, "columns": rows})
    )
    found = room.certificate(Setting())
    assert found.outcome == "undecided"
