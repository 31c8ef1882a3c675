"""Numbers that the errata and hypotheses of sections 5 and 5.1 quote, by scipy or mpmath alone."""

from math import acosh, cosh, log, pi, sinh, sqrt, tan

import pytest
from flint import arb
from mpmath import mp
from scipy.optimize import brentq
from scipy.special import i0

from checks.verify.recursion_disk import crossing_of_circle
from theory import amsler_disk, painleve_float, periodic_amsler_bounds
from theory.precision import working


def axis_length(radius: float, offset: float, cosine: float) -> float:
    """Length to the rim by the hyperbolic law of cosines."""

    def excess(length: float) -> float:
        straight = cosh(offset) * cosh(length)
        return straight + sinh(offset) * sinh(length) * cosine - cosh(radius)

    return float(brentq(excess, 0, 2 * radius + 1, xtol=1e-13))


def test_the_lengths_of_axes():
    assert axis_length(4, 1, 0) == pytest.approx(acosh(cosh(4) / cosh(1)))
    assert axis_length(4, 1, 0) ** 2 == pytest.approx(12.71, abs=0.005)
    assert axis_length(4, 1, 0.8) ** 2 == pytest.approx(9.55, abs=0.005)
    assert 1 / 0.001 * axis_length(4, 3.999, 0) == pytest.approx(44.7, abs=0.05)


def test_the_rectangle_of_the_axes_gives_another_place():
    contour = painleve_float.crossing(pi / 2, 3 * pi / 4)
    edge = contour**2 / (4 * 3)
    far = amsler_disk.rim(pi / 2, edge, 3.0)
    assert far > 3
    assert painleve_float.angle(pi / 2, 2 * sqrt(edge * far)) == pytest.approx(2.374, abs=5e-4)
    assert 3 * pi / 4 == pytest.approx(2.356, abs=5e-4)
    apart = 1 - crossing_of_circle(pi / 2, 3.0, contour) / edge
    assert round(100 * apart) == 2


def test_the_decay_of_the_smallest_angle():
    with mp.workdps(30):
        t = mp.findroot(lambda t: t * mp.besseli(1, t) - mp.besseli(0, t), 1.6)
        scale = mp.sqrt(t / 2) / mp.sqrt(mp.besseli(0, t) / 3)

        def share(radius: int) -> mp.mpf:
            return 1 / mp.besseli(0, 2 * scale * mp.sqrt(radius))

        assert float(2 * scale) == pytest.approx(2.342, abs=5e-4)
        assert float(mp.sqrt(2) * scale) == pytest.approx(1.656, abs=5e-4)
        assert float(-mp.log(share(10**4)) / 100) == pytest.approx(2.306, abs=5e-4)
        assert float(-mp.log(share(10**6)) / 1000) == pytest.approx(2.337, abs=5e-4)
        assert float(share(10**4) * mp.mpf(10) ** 101) == pytest.approx(7.3, abs=0.05)
        printed = mp.exp(-scale * mp.sqrt(2 * 10**4))
        assert float(printed * mp.mpf(10) ** 72) == pytest.approx(1.2, abs=0.05)
        assert float(share(1)) == pytest.approx(0.342, abs=5e-4)


def test_angles_and_energies_of_small_disks():
    assert painleve_float.crossing(pi / 2, 1.6) < 0.5  # so phi > 1.6 at u = v = 1/4
    assert log(1 / tan(pi / 12)) == pytest.approx(1.317, abs=5e-4)
    assert 1 / tan(pi / 6) == pytest.approx(1.732, abs=5e-4)
    assert tan(9 / 8) == pytest.approx(2.093, abs=5e-4)
    assert 1 / i0(1) == pytest.approx(0.79, abs=5e-3)


@pytest.mark.parametrize("place", [5.0, 9.0, 30.0])
def test_the_overshoot_is_that_of_the_least_moment(place):
    """Slope (z_1 - h)/(sqrt(2) z) from pi/2 to pi, stepped by the midpoint rule."""
    moment = (place - pi / (2 * sqrt(2))) / sqrt(2)
    steps = 20_000
    z = place
    for _ in range(steps):
        half = z + pi / (4 * steps) * z / moment
        z += pi / (2 * steps) * half / moment
    with working(64):
        found = float(periodic_amsler_bounds.overshoot(arb(place)).mid())
    assert found == pytest.approx((z - place) / sqrt(2), rel=1e-6)
