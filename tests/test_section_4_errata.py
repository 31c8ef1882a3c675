"""Numbers that the errata of section 4 quote, by numpy and fractions, and nets they speak of."""

from fractions import Fraction
from math import acos, atan, cos, pi, sin, tan

import numpy as np
import pytest
from flint import ctx

from checks.verify.discrete_surgery import _broken
from checks.verify.spherical_samples import balled, reverses_orientation
from checks.verify.surgery_samples import (
    between_two_slots,
    half_monkey_star,
    operated,
    samples,
    slotted,
)
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
    n, s = np.array([1.0, 0.0, 0.0]), np.array([1.2, 0.8, 0.8])
    printed = (np.outer(s, s) / (s @ s) - np.eye(3)) @ n
    assert 17 * printed == pytest.approx([-8, 6, 6])
    assert printed @ printed == pytest.approx(8 / 17)
    right = (2 * np.outer(s, s) / (s @ s) - np.eye(3)) @ n
    assert 17 * right == pytest.approx([1, 12, 12])


def test_the_half_turn_is_no_reflection():
    one = [Fraction(3, 5), Fraction(4, 5), 0]
    half_turn = half_turned([1, 0, 0], one, [0, 0, 1])
    assert half_turn == [Fraction(n, 25) for n in (-16, 12, 15)]
    normal = [Fraction(4, 5), Fraction(-3, 5), 0]
    assert sum(a * b for a, b in zip(normal, one, strict=True)) == 0
    mirrored = [e - 2 * normal[0] * n for e, n in zip([1, 0, 0], normal, strict=True)]
    assert mirrored == [Fraction(n, 25) for n in (-7, 24, 0)]


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


def test_geodesics_at_right_angles_turn_a_rhombus_over_at_the_eighth_small_edge():
    delta = acos(99 / 101)
    u = [[cos(k * delta), sin(k * delta), 0.0] for k in range(9)]
    nodes = [[[x, 0.0, -y] for x, y, _ in u]]
    for k in range(1, 9):
        nodes.append([u[k]])
        for j in range(1, 9):
            known = nodes[k - 1][j - 1], nodes[k][j - 1], nodes[k - 1][j]
            nodes[k].append(half_turned(*known))
    turns = [determinant(nodes[k][k], nodes[k + 1][k], nodes[k][k + 1]) for k in range(8)]
    assert [turn < 0 for turn in turns] == [True] * 7 + [False]


def test_curves_that_fold_back_turn_all_rhombi_at_their_second_edges_over():
    c, s = Fraction(99, 101), Fraction(20, 101)
    start, one, other = [1, 0, 0], [c, s, 0], [c, 0, -s]
    far = half_turned(start, one, other)
    assert determinant(start, one, other) < 0
    assert half_turned(one, start, far) == other
    assert determinant(one, start, far) > 0


def test_surgery_that_gives_two_far_ends_the_degree_five():
    net = between_two_slots(at_corner=0.5, beside=0.4)
    assert net_defect(net) == ""
    with ctx.workprec(192):
        old = balled(net)
        found = operated(old, 0, (1, 1))
        assert _broken(old, found, reverses_orientation(found.net)) == ""
    ends = found.places[[1, 3]]
    assert net.complex.degree[[1, 3]].tolist() == [4, 4]
    assert found.net.complex.degree[ends].tolist() == [5, 5]
    assert found.net.complex.is_boundary[ends].all()


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
    assert far_angle(0.7 * pi) + 2 * 0.8 * pi == pytest.approx(1.895 * pi, abs=0.001)
    least = 2 * atan((99 / 101) / tan(0.053 * pi))
    assert far_angle(least) == pytest.approx(0.106 * pi, rel=1e-9)
    assert least > 0.89 * pi
    assert far_angle(0.88 * pi) > 0.106 * pi
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
