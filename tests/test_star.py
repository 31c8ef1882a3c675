"""Rational stars of the plane: what is refused, and that sectors fill the neighbourhood."""

from fractions import Fraction
from random import Random

import pytest

from theory.errors import DomainError
from theory.star import Star, point, random_star, sample_points

QUADRANTS = ((0, 1), (-1, 0), (0, -1), (1, 0))
SHARES = (Fraction(1, 5), Fraction(1, 2), Fraction(9, 10))


def _star(directions, lengths=(1, 1, 1, 1)):
    return Star(
        directions=tuple((Fraction(x), Fraction(y)) for x, y in directions),
        lengths=tuple(map(Fraction, lengths)),
    )


@pytest.mark.parametrize(
    ("directions", "lengths"),
    [
        (QUADRANTS, (1, 1, 0, 1)),
        (QUADRANTS, (1, 1, 1)),
        (((0, 2), *QUADRANTS[1:]), (1, 1, 1, 1)),
        (QUADRANTS[::-1], (1, 1, 1, 1)),
        (((0, 1), (0, -1), (1, 0)), (1, 1, 1)),
        (QUADRANTS * 2, (1,) * 8),
    ],
)
def test_data_of_no_star_are_refused(directions, lengths):
    with pytest.raises(DomainError):
        _star(directions, lengths)


def test_the_outer_sides_do_not_belong_to_a_sector():
    star = _star(QUADRANTS)
    assert star.in_sector(1, (Fraction(1, 2), Fraction(0)))
    assert not star.in_sector(1, (Fraction(1), Fraction(1, 2)))


@pytest.mark.parametrize("order", [2, 3, 4, 5])
def test_interiors_are_disjoint_and_combinations_are_inside(order):
    star = random_star(Random(order), order)
    for i in star.rays:
        for x in sample_points(star, i, SHARES):
            assert star.sectors_of(x) == (i,)
            assert star.inside_sector(i, x)


def test_a_point_of_a_ray_is_in_two_sectors():
    star = random_star(Random(7), 3)
    for i in star.rays:
        x = point(star.length(i) / 2, star.ray(i), Fraction(0), star.ray(i))
        assert set(star.sectors_of(x)) == {i, i % 6 + 1}
        assert not any(star.inside_sector(j, x) for j in star.rays)
