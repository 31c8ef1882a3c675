"""What the certified route rests on, changed: the balls must then miss the reference route.

At the orders of a certified value the remainders are far below its digits, whatever is changed in
them; so the pieces are made here with few terms.
"""

from fractions import Fraction

import pytest
from flint import arb

from theory import bounded_series, majorant, painleve_reference, painleve_step
from theory.majorant import SineBound, State
from theory.painleve_origin import origin_piece
from theory.painleve_step import regular_piece
from theory.precision import working

BITS = 200
REFERENCE_DIGITS = 30
REFERENCE_ERROR = arb("1e-27")
PHI0 = Fraction(1)
SLOW = Fraction(1, 10**6)
"""Initial angle whose solution is small at z = 12 and grows like exp(z): its sine too."""
SMALL = Fraction(1, 32)
"""Start of the smallest disk: there the first bounds are nearly attained."""


def reference(name: str, phi0: Fraction, z: Fraction) -> arb:
    value = getattr(painleve_reference, name)(phi0, z, digits=REFERENCE_DIGITS)
    sign, mantissa, exponent, _ = value._mpf_
    return arb(((-1) ** sign * int(mantissa), int(exponent))) + arb(0, REFERENCE_ERROR)


def ball(value: Fraction) -> arb:
    return arb(value.numerator) / value.denominator


def misses(found: arb, value: arb) -> bool:
    """Whether the balls certainly have no number in common."""
    return found.is_finite() and not found.overlaps(value)


def first_piece(phi0: Fraction, order: int, until: Fraction | None = None):
    end = None if until is None else ball(until)
    return origin_piece(ball(phi0), until=end, order=order)


def second_piece(phi0: Fraction, z: Fraction, order: int, until: Fraction | None = None):
    angle, slope = (reference(name, phi0, z) for name in ("angle", "slope"))
    end = None if until is None else ball(until)
    return regular_piece(ball(z), angle, slope, order=order, until=end)


def origin_gap(order: int, phi0: Fraction = PHI0, until: Fraction | None = None) -> bool:
    """Whether the series at the origin misses the reference at the end of its piece."""
    with working(BITS):
        piece = first_piece(phi0, order, until)
        z = Fraction(str(float(piece.end)))
        found = piece.angle(piece.local(ball(z)))
        return misses(found, reference("angle", phi0, z))


def step_gap(order: int, phi0: Fraction = PHI0, z: Fraction = Fraction(2), length=None) -> bool:
    """Whether a Taylor step from z misses the reference at its end."""
    with working(BITS):
        piece = second_piece(phi0, z, order, None if length is None else z + length)
        end = Fraction(str(float(piece.end)))
        found = piece.angle(piece.local(ball(end)))
        return misses(found, reference("angle", phi0, end))


def halved(tail):
    return lambda bound, ratio, order: tail(bound, ratio, order) / 2


def small_disks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Make the disks so small that |phi - phi(z)| <= M is nearly attained at their edge."""
    monkeypatch.setattr(painleve_step, "FAR_ENOUGH", 1e-3)
    monkeypatch.setattr(painleve_step, "PACE", 1e-3)


@pytest.mark.parametrize("order", [1, 2, 3, 5, 8])
def test_the_pieces_enclose_the_reference_at_any_order(order: int):
    assert not origin_gap(order)
    assert not origin_gap(order, until=SMALL)
    assert not step_gap(order)
    assert not step_gap(order, phi0=Fraction(1, 30), z=Fraction(4))
    assert not step_gap(order, phi0=SLOW, z=Fraction(12))


def test_half_the_tail_at_the_origin_is_caught(monkeypatch: pytest.MonkeyPatch):
    assert not origin_gap(1, until=SMALL)
    monkeypatch.setattr(bounded_series, "geometric_tail", halved(bounded_series.geometric_tail))
    assert origin_gap(1, until=SMALL)


def test_half_the_tail_of_a_step_is_caught(monkeypatch: pytest.MonkeyPatch):
    small_disks(monkeypatch)
    short = Fraction(1, 100_000)
    assert not step_gap(1, length=short)
    monkeypatch.setattr(bounded_series, "geometric_tail", halved(bounded_series.geometric_tail))
    assert step_gap(1, length=short)


@pytest.mark.parametrize("order", [2, 4, 8])
def test_no_tail_at_all_is_caught(monkeypatch: pytest.MonkeyPatch, order: int):
    monkeypatch.setattr("theory.bounded_series.geometric_tail", lambda *_: arb(0))
    assert origin_gap(order)
    assert step_gap(order)


@pytest.mark.parametrize("order", [4, 8])
def test_the_sine_at_the_centre_is_no_a_priori_enclosure(
    monkeypatch: pytest.MonkeyPatch, order: int
):
    """Take S(0) for S(u), as if |sin phi| were largest at the centre of the disk."""
    monkeypatch.setattr(SineBound, "__call__", lambda self, _: self.sine)
    assert origin_gap(order, phi0=Fraction(1, 30))
    assert step_gap(order, phi0=SLOW, z=Fraction(12))


@pytest.mark.parametrize("order", [1, 2, 3])
def test_a_disk_without_a_proof_is_no_a_priori_enclosure(
    monkeypatch: pytest.MonkeyPatch, order: int
):
    """Accept the first candidate of each step, whose rate has not grown."""

    def unproved(state, s, clock, _force):
        return State(s=s, u=(state.u + clock * state.v).upper(), v=state.v)

    monkeypatch.setattr(painleve_step, "grown", unproved)
    assert step_gap(order, phi0=Fraction(1, 30), z=Fraction(4))


def test_the_first_disk_is_refused_where_its_bound_is_not_kept():
    sine = SineBound.about(arb(1))
    with working(64):
        for radius in (0.01, 0.1, 0.25):
            bound = majorant.least_disk(sine, arb(radius))
            assert arb(radius) * sine(bound) <= bound * (1 + arb(2) ** -50)
        with pytest.raises(ArithmeticError, match="no a-priori enclosure"):
            majorant.least_disk(sine, arb(4))


def test_grown_bounds_dominate_the_majorant_in_closed_form():
    """phi_0 = pi, v(0) = 2: u'' = sinh u has u = 4 artanh(tan(s/2)), infinite at s = pi/2."""
    with working(64):
        sine = SineBound.about(arb.pi())
        state = State(s=arb(0), u=arb(0), v=arb(2))
        while state.s < arb("1.5"):
            s = (state.s + arb(1) / 64).mid()
            larger = majorant.grown(state, s, arb(1) / 64, lambda _s, u, _v: sine(u))
            assert larger is not None
            exact = 4 * (s / 2).tan().atanh()
            assert exact < larger.u
            assert larger.u < exact * arb("1.05") or s > arb("1.4")
            state = larger
        assert majorant.grown(state, arb(2), arb(2) - state.s, lambda _s, u, _v: sine(u)) is None
