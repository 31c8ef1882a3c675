"""The bounds of the range certificate against the quantities that they bound, by mpmath.

A bound on the wrong side, a step too short or a weight too small would still let a column close:
here each intermediate bound of both routes is compared with its quantity on a member of the family.
"""

from dataclasses import dataclass
from fractions import Fraction
from itertools import islice
from typing import Any

import pytest
from flint import arb, ctx
from mpmath import mp

from checks.certificates.amsler_bounds import _Family, verdict
from checks.certificates.painleve_tube import grid, tube
from checks.stored import load
from checks.verify import amsler_bounds as room
from theory import painleve_reference
from theory.amsler_bounds import gap_cells
from theory.precision import working

TOP = Fraction("3.1316")
STEP = Fraction(1, 20)
DIGITS = 40
#: Ends of a column of phi_n, and how many stretches it is followed; narrow ones leave less room.
COLUMNS = (
    ("1e-3", "1.01e-3", 150),
    ("0.3", "0.303", 80),
    ("2.5", "2.505", 30),
    ("0.3", "0.30000001", 80),
    ("2.5", "2.50000001", 30),
)


@dataclass(frozen=True, kw_only=True)
class Gaps:
    """What the two routes bound, at one z of one solution; f(w) = I_0(2 sqrt w)."""

    upper: Any
    excess: Any
    rate: Any
    q: Any
    source: Any
    shape: Any
    ratio: Any
    growth: Any
    moment: Any

    @classmethod
    def at(cls, inner: Fraction, z: Fraction) -> "Gaps":
        phi_n, place = mp.mpf(inner.numerator) / inner.denominator, mp.mpf(z.numerator)
        place = place / z.denominator
        phi = painleve_reference.angle(inner, z, digits=DIGITS)
        slope = painleve_reference.slope(inner, z, digits=DIGITS)
        x, e, u = place**2 / 4, phi_n**2, phi / phi_n
        c, s = mp.sin(phi_n) / phi_n, mp.sin(phi) / phi

        def f(w):
            return mp.besseli(0, 2 * mp.sqrt(w))

        steepness = mp.sqrt(c) * place * mp.besseli(1, mp.sqrt(c) * place)
        return cls(
            upper=(f(x) - u) / e / x,
            excess=(f(c * x) - u) / e,
            rate=(steepness - place * slope / phi_n) / e,
            q=(c - s) / (e * x),
            source=u**3 * (1 - s) / phi**2,
            shape=(f(c * x) - f(s * x)) / (x * (c - s)),
            ratio=u,
            growth=phi - phi_n,
            moment=place * slope,
        )

    def quotient(self, z: Fraction) -> Any:
        """Value of x^2 q F/M."""
        x = mp.mpf(z.numerator) ** 2 / z.denominator**2 / 4
        return x**2 * self.q * self.shape / self.excess


def places(stretch: Any) -> list[Fraction]:
    """Next to both ends, and the middle."""
    low, high = (Fraction(float(end.mid())) for end in (stretch.low, stretch.high))
    return [low + (high - low) * part / 1000 for part in (1, 500, 999)]


def end(stretch: Any) -> Fraction:
    return Fraction(float(stretch.high.mid()))


def holds(ball: Any, value: Any) -> bool:
    return at_most(ball.lower(), value) and at_least(ball.upper(), value)


def at_most(bound: Any, value: Any) -> bool:
    return mp.mpf(float(bound)) <= value * (1 + mp.mpf(10) ** -9)


def at_least(bound: Any, value: Any) -> bool:
    return mp.mpf(float(bound)) >= value * (1 - mp.mpf(10) ** -9)


def ends_of(low: str, high: str) -> tuple[Any, Fraction]:
    first, last = Fraction(low), Fraction(high)
    family = arb(first.numerator) / first.denominator
    return family.union(arb(last.numerator) / last.denominator), first + (last - first) * 3 / 8


@pytest.mark.parametrize(("low", "high", "count"), COLUMNS)
def test_each_bound_of_the_checker_is_on_its_side(low, high, count):
    with ctx.workprec(64), mp.workdps(DIGITS):
        phi0, inner = ends_of(low, high)
        excess, tightest = None, mp.mpf(10)
        for k, stretch in enumerate(islice(tube(phi0, grid(STEP)), count)):
            family = _Family(stretch=stretch, phi0=phi0, e=phi0**2, c=phi0.sin() / phi0)
            excess = family.excess(excess)
            if k % 8:
                continue
            last = Gaps.at(inner, end(stretch))
            assert at_least(excess.m, last.excess)
            assert at_least(excess.k, last.rate)
            assert holds(stretch.growth, last.growth)
            assert holds(stretch.rate, last.moment)
            bound = family.quotient(excess)
            for z in places(stretch):
                true = Gaps.at(inner, z)
                assert at_least(excess.most, true.q * true.ratio)
                assert holds(family.q(), true.q)
                assert holds(stretch.rise, true.growth * 4 / mp.mpf(float(z)) ** 2)
                assert at_most(family.gap(), true.source)
                assert at_most(bound, true.quotient(z))
                tightest = min(tightest, true.quotient(z) / mp.mpf(float(bound)))
        # Not by far: the bounds follow the quantities.
        assert tightest < 1.2


@pytest.mark.parametrize(("low", "high", "count"), COLUMNS)
def test_each_bound_of_the_run_is_on_its_side(low, high, count):
    with working(64), mp.workdps(DIGITS):
        phi0, inner = ends_of(low, high)
        tightest = mp.mpf(10)
        for k, cell in enumerate(islice(gap_cells(phi0, step=STEP), count)):
            if k % 8:
                continue
            for z in places(cell):
                true = Gaps.at(inner, z)
                assert at_most(cell.gap, true.upper)
                assert at_most(cell.quotient, true.quotient(z))
                tightest = min(tightest, true.quotient(z) / mp.mpf(float(cell.quotient)))
        assert tightest < 1.2


def test_a_column_above_the_largest_threshold_is_not_proved():
    with ctx.workprec(64):
        found = verdict(Fraction(2), Fraction("2.01"), top=Fraction(1), steps=grid(STEP))
    assert "nothing to prove" in found.open


@pytest.mark.parametrize(("top", "reason"), [("1", "above the largest"), ("3.1417", "below pi")])
def test_a_certificate_with_another_largest_threshold_is_refused(top, reason):
    run = load("amsler_bounds")
    columns = [(Fraction(a), Fraction(b), depth) for a, b, depth in run.result["columns"]]
    other = type(run)(
        name=run.name,
        seed=run.seed,
        evaluations=run.evaluations,
        result={**run.result, "top": top},
        sources={},
    )
    assert reason in room._unsound(other, columns, Fraction("1e-6"))
