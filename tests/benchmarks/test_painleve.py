"""The certified 40-digit first crossing of pi beside mpmath.odefun, warm, in one run.

Run by `make bench`; the ratio is printed and recorded, and decides nothing.
"""

import sys

import pytest
from flint import arb
from mpmath import mp
from odefun_route import fresh_odefun

from theory import painleve, painleve_reference

DIGITS = 40
GROUP = f"first crossing of pi from pi/100, {DIGITS} digits"


@pytest.fixture(scope="module")
def medians():
    """Medians of this run in seconds, by route."""
    return {}


def certified() -> str | None:
    """Certified decimal of the crossing."""
    found = painleve.crossing(lambda: arb.pi() / 100, arb.pi, digits=DIGITS)
    return found.decimal(DIGITS)


def reference() -> object:
    """Crossing by the reference route."""
    return painleve_reference.crossing(lambda: mp.pi / 100, mp.pi, digits=DIGITS)


def by_odefun() -> object:
    """Crossing by a fresh odefun object that starts from the series at z = 1, root included.

    The guesses of the secant method lie within 0.01 of the root, which helps odefun.
    """
    with mp.workdps(DIGITS + 2):
        solution = fresh_odefun(mp.pi / 100)
        return mp.findroot(lambda z: solution(z)[0] - mp.pi, (6.75, 6.76))


@pytest.mark.benchmark(group=GROUP)
@pytest.mark.parametrize("route", [certified, reference, by_odefun], ids=lambda f: f.__name__)
def test_first_crossing(benchmark, medians, route):
    rounds = 1 if route is by_odefun else 20
    found = benchmark.pedantic(route, rounds=rounds, warmup_rounds=rounds // 20)
    medians[route.__name__] = benchmark.stats.stats.median
    with mp.workdps(DIGITS):
        assert abs(mp.mpf(found) - reference()) < mp.mpf(10) ** (2 - DIGITS)


@pytest.mark.benchmark(group="odefun over certified")
def test_ratio(benchmark, medians, capsys):
    ratio = medians["by_odefun"] / medians["certified"]
    benchmark.extra_info["odefun / certified"] = ratio
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        sys.stdout.write(f"\nodefun takes {ratio:.0f} times as long as the certified route\n")
