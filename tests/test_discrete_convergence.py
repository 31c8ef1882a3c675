"""Nets on Amsler sectors against the continuum: angles and distances as the edges shrink."""

import math
from itertools import pairwise

import pytest
from discrete_samples import BASE

from discrete import geodesics, net_frames, sl2_frames
from discrete.angle_advance import checked_net_angles
from discrete.goursat_fill import fill
from discrete.space_forms import H2
from theory import painleve_float

LEVELS = (16, 32, 64, 128, 256)
STARS = (2, 3, 6)  # sectors of the angle pi/m


def observed_orders(errors):
    """Orders between neighbouring levels, each of half the edge length of the one before."""
    return [math.log2(abs(a / b)) for a, b in pairwise(errors)]


@pytest.mark.parametrize("m", STARS)
@pytest.mark.parametrize(("offset", "expected"), [(0.5, 2), (0.0, 1), (1.0, 1)])
def test_order_of_the_angle_of_a_quad(m, offset, expected):
    # The angle of quad (i, j) belongs to its centre; at its first or last vertex it is of order 1.
    errors = []
    for count in LEVELS:
        step = 1 / count
        net = checked_net_angles(H2, [step] * count, [step] * count, math.pi / m)
        i, j = count // 2, count - 1
        z = 2 * math.sqrt((i + offset) * (j + offset)) * step
        errors.append(net.angles[i, j] - painleve_float.angle(math.pi / m, z))
    assert all(expected - 0.1 < order < expected + 0.1 for order in observed_orders(errors))


@pytest.mark.parametrize("m", STARS)
def test_order_of_the_distance_along_the_diagonal(m):
    # The line u = v is the axis of symmetry of the sector, a geodesic of length int cos(phi/2) dz.
    exact = painleve_float.diagonal(math.pi / m, 2.0)
    errors = []
    for count in LEVELS[:4]:
        step = 1 / count
        net = checked_net_angles(H2, [step] * count, [step] * count, math.pi / m)
        g = net_frames.relative_frame(net, math, (0, 0), (count, count))
        errors.append(sl2_frames.distance_from_start(math, g) - exact)
    assert all(1.9 < order < 2.1 for order in observed_orders(errors))


def test_order_rejects_an_angle_off_by_one_step_in_a_hundred():
    errors = []
    for count in LEVELS:
        net = checked_net_angles(H2, [1.01 / count] * count, [1 / count] * count, math.pi / 2)
        z = 2 * math.sqrt((count // 2 + 0.5) * (count - 0.5)) / count
        errors.append(net.angles[count // 2, count - 1] - painleve_float.angle(math.pi / 2, z))
    assert not all(1.9 < order < 2.1 for order in observed_orders(errors))


def test_the_net_folds_over_at_the_singular_edge_and_the_angles_go_on():
    # With sides 2 the angle passes pi at z = 2.73; the half-turn and the angles agree beyond.
    count, step = 40, 0.05
    net = checked_net_angles(H2, [step] * count, [step] * count, math.pi / 2)
    side = [k * step for k in range(count + 1)]
    first, second = (
        [geodesics.polar(H2, math, turn, s) for s in side] for turn in (0.0, math.pi / 2)
    )
    nodes = fill(H2.dot, first, second)
    assert nodes[0][0] == BASE
    assert net.angles.max() > math.pi + 0.5
    for i in range(0, count, 3):
        for j in range(0, count, 3):
            seen = geodesics.angle_at(H2, math, nodes[i][j], nodes[i + 1][j], nodes[i][j + 1])
            assert abs(math.remainder(seen - net.angles[i, j], 2 * math.pi)) < 1e-9
