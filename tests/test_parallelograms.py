"""Angles and areas of Chebyshev parallelograms, against a quad closed by the half-turn."""

import math

import pytest

from discrete.geodesics import angle_at, polar
from discrete.parallelograms import half_defect, neighbour_angle, quad_area, side_product
from discrete.quad_rule import close_quad
from discrete.space_forms import H2, S2


@pytest.mark.parametrize("space", [H2, S2], ids=["H2", "S2"])
@pytest.mark.parametrize(("a", "b", "angle"), [(0.3, 0.3, 1.0), (0.2, 0.7, 2.1), (0.05, 0.4, 0.3)])
def test_angles_of_a_quad_closed_by_the_half_turn(space, a: float, b: float, angle: float):
    p, p1, p2 = (1.0, 0.0, 0.0), polar(space, math, 0.0, a), polar(space, math, angle, b)
    p12 = close_quad(space.dot, p, p1, p2)
    neighbour = angle_at(space, math, p1, p12, p)
    q = side_product(space, math, a, b)
    assert abs(neighbour_angle(math, q, angle) - neighbour) < 1e-12
    excess = 2 * angle + 2 * neighbour - 2 * math.pi
    assert abs(quad_area(space, math, q, angle) - space.curvature * excess) < 1e-12
    assert half_defect(math, q, angle) * space.curvature < 0
    assert quad_area(space, math, q, angle) > 0
