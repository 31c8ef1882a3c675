"""Numbers that the errata of section 4 quote, by numpy and fractions, and nets they speak of."""

from fractions import Fraction
from math import acos, atan, cos, pi, sin, tan

import numpy as np
import pytest

from checks.verify.surgery_samples import between_two_slots, half_monkey_star, samples, slotted
from checks.verify.vertex_angles import net_defect


def half_turned(p, p1, p2):
    """Vector p after the half-turn about p1 + p2."""
    s = [a + b for a, b in zip(p1, p2, strict=True)]
    k = 2 * sum(a * b for a, b in zip(p, s, strict=True)) / sum(a * a for a in s)
    return [k * a - b for a, b in zip(s, p, strict=True)]


def determinant(a, b, c):
    return (
        a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
    )


def test_the_matrix_without_its_factor_two():
    n = np.array([1.0, 0.0, 0.0])
    s = n + n
    printed = (np.outer(s, s) / (s @ s) - np.eye(3)) @ n
    assert np.abs(printed).max() == 0
    assert np.abs((2 * np.outer(s, s) / (s @ s) - np.eye(3)) @ n - n).max() == 0


def test_the_half_turn_is_no_reflection():
    assert half_turned([1, 0, 0], [1, 0, 0], [0, 1, 0]) == [0, 1, 0]


def test_the_rhombus_that_keeps_its_orientation():
    c, s = Fraction(3, 5), Fraction(4, 5)
    first = [[1, 0, 0], [c, s, 0], [2 * c * c - 1, 2 * c * s, 0]]
    second = [[x, 0, -y] for x, y, _ in first]
    middle = half_turned(first[0], first[1], second[1])
    right = half_turned(first[1], first[2], middle)
    left = half_turned(second[1], middle, second[2])
    assert middle == [Fraction(1, 17), Fraction(12, 17), Fraction(-12, 17)]
    assert right == [Fraction(n, 1765) for n in (-1341, 712, -900)]
    assert left == [Fraction(n, 1765) for n in (-1341, 900, -712)]
    assert determinant(middle, right, left) == Fraction(373744, 3115225)
    assert determinant(first[0], first[1], second[1]) == Fraction(-16, 25)


def far_angle(angle: float) -> float:
    """Angle of the surface at the far end of a rhombus with cos delta = 99/101."""
    delta = acos(99 / 101)
    p = np.array([1.0, 0.0, 0.0])
    one = np.array([cos(delta), sin(delta), 0.0])
    turn = angle - pi
    other = np.array([cos(delta), sin(delta) * cos(turn), sin(delta) * sin(turn)])
    far = np.array(half_turned(p, one, other))
    to_far, to_p = np.cross(far, one), np.cross(p, one)
    cosine = to_far @ to_p / np.linalg.norm(to_far) / np.linalg.norm(to_p)
    return pi - acos(cosine)


def test_the_angles_between_two_slots():
    least = 2 * atan((99 / 101) / tan(0.05 * pi))
    assert far_angle(least) == pytest.approx(0.1 * pi, rel=1e-9)
    assert least > 0.89 * pi
    assert far_angle(0.88 * pi) > 0.1 * pi
    assert 2 * least > 2 * pi - 0.7 * pi


def test_equal_angles_at_the_neighbour_of_three_rhombi():
    at_q = far_angle(0.6 * pi)
    new = (2 * pi - at_q) / 3
    assert far_angle(new) / pi == pytest.approx(0.46, abs=0.005)
    assert 3 * 0.6 + 0.46 > 2


def test_the_nets_of_the_surgery_checks_are_spherical_chebyshev_nets():
    hard = [between_two_slots(), slotted(), half_monkey_star()]
    for net in [*hard, *(net for _, net in samples())]:
        assert net_defect(net) == ""
        assert net.complex.is_disk
