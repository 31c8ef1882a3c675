"""Every bound of theory.folded_corner_surface against a direct computation that it must contain."""

from fractions import Fraction
from itertools import pairwise

import mpmath
import numpy as np
import pytest
from flint import arb, ctx

from theory.folded_corner import FoldedCorner
from theory.folded_corner_surface import CornerSurfaces, ball, surfaces

FAMILIES = (
    surfaces(Fraction(1, 40)),
    CornerSurfaces(
        net=FoldedCorner(t=Fraction(1, 12), spare=Fraction(1, 30)),
        scale=Fraction(1, 50),
        step=Fraction(1, 5000),
    ),
)


@pytest.fixture(params=FAMILIES, ids=["small", "large"], name="family")
def _family(request: pytest.FixtureRequest):
    with ctx.workprec(192):
        yield request.param


def _angle(direction):
    return float(np.arctan2(float(direction[1]), float(direction[0])))


def _displacement(family: CornerSurfaces) -> float:
    """Largest displacement of A by turns put off to the ends of their lengths, any of the two."""
    net, step = family.net, float(family.step)
    alphas = [-_angle(net.steep), _angle(net.bent), _angle(net.turn)]
    jumps = [step * (np.exp(1j * a) - np.exp(1j * b)) for a, b in pairwise(alphas)]
    return max(abs(jumps[0]), abs(jumps[1]), abs(sum(jumps)))


def test_turning_late_displaces_less_than_the_bound(family: CornerSurfaces):
    assert family.smoothing() >= _displacement(family)


def test_every_scale_up_to_the_largest_is_meant(family: CornerSurfaces):
    assert family.size.contains(arb(0))
    assert family.size.contains(ball(family.scale))
    assert not family.size.contains(ball(family.scale * 2))


def test_the_remainders_of_the_square_are_contained(family: CornerSurfaces):
    size = mpmath.mpf(family.scale.numerator) / family.scale.denominator
    far = size * 2 * int(family.net.extent)
    remainder = (mpmath.exp(far) - 1 - far) / size
    assert family.position_error().upper() >= float(remainder) + _displacement(family)
    end = float(family.net.arm + 1 + 2 * family.net.spare)
    assert family.normal_error().upper() >= float(size) * end**2 / 2 + _displacement(family)


def test_the_curvature_is_that_of_the_least_angle(family: CornerSurfaces):
    shift = float(family.scale * family.net.extent) ** 2
    least = 4 * np.arctan(float(family.net.t)) - shift
    assert family.largest_curvature().upper() >= (1 - 1e-12) / np.tan(least / 2)
    assert family.largest_curvature().contains(arb(family.net.curvature.numerator)
                                               / family.net.curvature.denominator)  # fmt: skip


def test_the_rim_of_the_box_is_farther_than_the_margin(family: CornerSurfaces):
    net = family.net
    side, a, b = float(net.spare), *(np.exp(1j * _angle(z)) for z in (net.bent, net.steep))
    turns = np.linspace(-1, 1, 2001)
    rim = [abs(side * (a * x - b * y)) for x, y in ((1, turns), (turns, 1))]
    least = min(float(np.min(row)) for row in rim)
    assert family.box_margin().upper() <= least - 2 * float(family.normal_error().lower())
    # One number holds for all scales: the upper end leaves the smoothing alone.
    lowest = least - 2 * float(family.normal_error().upper())
    assert family.box_margin().lower() <= lowest + 1e-9


def test_a_shadow_is_shortened_by_more_than_the_slope_of_the_hyperboloid(family: CornerSurfaces):
    size = float(family.scale)
    far = np.expm1(2 * float(family.net.extent) * size)
    for length in (0.5, 1.0, 2.0):
        # Along a ray, out to where the square may reach, the slope is largest.
        inner, outer = far - size * length, far
        distance = (np.arcsinh(outer) - np.arcsinh(inner)) / size
        assert family._shrunk(arb(length)).lower() <= distance


def test_disk_and_separation_leave_room_for_every_error(family: CornerSurfaces):
    net, error = family.net, float(family.position_error().upper())
    centre = net.position(net.double_point()[1])
    walls = []
    for k in range(4001):
        s = net.extent * k / 4000
        walls += [net.position((s, Fraction(0))), net.position((Fraction(0), -s))]
    nearest = min(np.hypot(*(float(x) - float(c) for x, c in zip(w, centre, strict=True)))
                  for w in walls)  # fmt: skip
    assert family.room().lower() <= nearest - 2 * error
    low, high = family.separation()
    right, left = net.double_point()
    middle = float(net.position(right)[0] - net.position(left)[0])
    off = 2 * float(net.spare) + 2 * error
    assert low.lower() <= middle - off
    assert high.upper() >= middle + off
