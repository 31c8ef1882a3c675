"""The half-turn that closes a Chebyshev quad, in both spaces by one body of tests."""

import math

import mpmath
import numpy as np
import pytest
import sympy as sp
from discrete_samples import BASE, SPACES, angles, apart, corner, directions, distance, lengths
from flint import arb, ctx
from hypothesis import assume, given

from discrete import isometries
from discrete.errors import AntipodalError, DiscreteError, NotFiniteError, OffSpaceError
from discrete.geodesics import angle_at, polar
from discrete.quad_rule import close_quad, closed_quad
from discrete.space_forms import H2, S2, dot_h2, dot_s2

in_both_spaces = pytest.mark.parametrize("space", SPACES, ids=lambda s: s.name)


def plain_midpoint(dot, p, p1, p2):
    """Mutant: the point reflection through the middle of the chord, without the factor k."""
    del dot
    return tuple(p1[i] + p2[i] - p[i] for i in range(3))


def swapped_sign(dot, p, p1, p2):
    """Mutant: k s + p instead of k s - p."""
    s = tuple(p1[i] + p2[i] for i in range(3))
    k = 2 * dot(p, s) / dot(s, s)
    return tuple(k * s[i] + p[i] for i in range(3))


def half_factor(dot, p, p1, p2):
    """Mutant: the factor 2 is missing, which gives the midpoint of p1 p2 moved away."""
    s = tuple(p1[i] + p2[i] for i in range(3))
    k = dot(p, s) / dot(s, s)
    return tuple(k * s[i] - p[i] for i in range(3))


def wrong_metric(dot, p, p1, p2):
    """Mutant: the product of the other space in k."""
    return close_quad(dot_s2 if dot is dot_h2 else dot_h2, p, p1, p2)


def defects(space, rule, p, p1, p2):
    """How far the fourth vertex is from the space, and its sides from the opposite ones."""
    p12 = rule(space.dot, p, p1, p2)
    chords = ((p, p1, p2, p12), (p, p2, p1, p12))
    return (
        abs(space.residual(p12)),
        *(abs(space.dot(a, b) - space.dot(c, d)) for a, b, c, d in chords),
    )


# Rounding of products of triples up to cosh(2.8) = 8: a few hundred units of 1e-16.
ROUNDING = 1e-12


@in_both_spaces
@given(a=lengths, b=lengths, angle=angles, turn=directions, away=lengths)
def test_close_quad_makes_opposite_sides_equal(space, a, b, angle, turn, away):
    p = polar(space, math, 0.3, away)
    p1, p2 = corner(space, p, turn, angle, a, b)
    assume(space is H2 or space.dot(p1, p2) > -0.99)
    assert max(defects(space, close_quad, p, p1, p2)) < ROUNDING * 100


@pytest.mark.parametrize("mutant", [plain_midpoint, swapped_sign, half_factor, wrong_metric])
@in_both_spaces
def test_sides_equal_rejects(space, mutant):
    p1, p2 = corner(space, BASE, 0.2, 1.1, 0.5, 0.8)
    assert max(defects(space, close_quad, BASE, p1, p2)) < ROUNDING
    assert max(defects(space, mutant, BASE, p1, p2)) > 0.01


@in_both_spaces
@given(a=lengths, b=lengths, angle=angles, turn=directions)
def test_the_quad_is_symmetric_in_its_vertices(space, a, b, angle, turn):
    p1, p2 = corner(space, BASE, turn, angle, a, b)
    assume(space is H2 or space.dot(p1, p2) > -0.99)
    p12 = close_quad(space.dot, BASE, p1, p2)
    assume(space is H2 or space.dot(BASE, p12) > -0.99)
    assert apart(close_quad(space.dot, p12, p1, p2), BASE) < 1e-11
    assert apart(close_quad(space.dot, p1, BASE, p12), p2) < 1e-11
    assert apart(close_quad(space.dot, BASE, p2, p1), p12) == 0


@in_both_spaces
@given(a=lengths, b=lengths, angle=angles, turn=directions, away=lengths)
def test_close_quad_commutes_with_isometries(space, a, b, angle, turn, away):
    p1, p2 = corner(space, BASE, turn, angle, a, b)
    assume(space is H2 or space.dot(p1, p2) > -0.9)
    q = polar(space, math, 1.0, away)
    moves = (
        lambda x: isometries.translation(space.dot, BASE, q, x),
        lambda x: isometries.rotation(space, math, q, 0.7, x),
        lambda x: isometries.reflection(space.dot, (0.0, 0.6, -0.8), x),
    )
    p12 = close_quad(space.dot, BASE, p1, p2)
    for move in moves:
        moved = close_quad(space.dot, move(BASE), move(p1), move(p2))
        assert apart(moved, move(p12)) < 1e-10


@in_both_spaces
def test_isometry_test_sees_a_map_that_is_none(space):
    p1, p2 = corner(space, BASE, 0.2, 1.1, 0.5, 0.8)

    def stretch(x):
        return (x[0], 1.01 * x[1], x[2])

    moved = close_quad(space.dot, stretch(BASE), stretch(p1), stretch(p2))
    assert apart(moved, stretch(close_quad(space.dot, BASE, p1, p2))) > 1e-4


@in_both_spaces
def test_every_kind_of_number_gives_the_same_vertex(space):
    points = ((3, 1, 2), (5, -2, 1), (4, 2, 2))  # the rule is homogeneous: no unit length needed
    exact = close_quad(space.dot, *(tuple(map(sp.Rational, p)) for p in points))
    floats = close_quad(space.dot, *(tuple(map(float, p)) for p in points))
    arrays = close_quad(space.dot, *(tuple(np.full(2, float(x)) for x in p) for p in points))
    with mpmath.workdps(40):
        multi = close_quad(space.dot, *(tuple(map(mpmath.mpf, p)) for p in points))
        assert all(
            abs(m - mpmath.mpf(e.p) / e.q) < 1e-38 for m, e in zip(multi, exact, strict=True)
        )
    with ctx.workprec(128):
        balls = close_quad(space.dot, *(tuple(map(arb, p)) for p in points))
        for ball, e in zip(balls, exact, strict=True):
            assert ball.is_finite()
            assert ball.rad() < 1e-35
            assert ball.overlaps(arb(e.p) / e.q)
    for f, a, e in zip(floats, arrays, exact, strict=True):
        assert abs(f - float(e)) < 1e-14
        assert (a == f).all()


def test_the_rule_covers_parallelograms_that_are_no_rhombi():
    p1, p2 = corner(H2, BASE, 0.0, 1.0, 0.3, 1.1)
    p12 = close_quad(dot_h2, BASE, p1, p2)
    assert abs(distance(H2, p2, p12) - 0.3) < 1e-14
    assert abs(distance(H2, p1, p12) - 1.1) < 1e-14
    assert abs(angle_at(H2, math, p12, p2, p1) + angle_at(H2, math, BASE, p1, p2)) != 0
    assert abs(angle_at(H2, math, p12, p2, p1) - angle_at(H2, math, BASE, p1, p2)) < 1e-13


def test_bad_vertices_are_named():
    good = polar(S2, math, 0.5, 0.4)
    opposite = tuple(-x for x in good)
    with pytest.raises(AntipodalError, match=r"p1 .* p2"):
        closed_quad(S2, BASE, good, opposite)
    with pytest.raises(NotFiniteError, match="vertex p2"):
        closed_quad(S2, BASE, good, (math.nan, 0.0, 0.0))
    with pytest.raises(OffSpaceError, match=r"vertex p1 .* no point of H2"):
        closed_quad(H2, BASE, (1.0, 0.5, 0.0), BASE)
    with pytest.raises(OffSpaceError, match="vertex p "):
        closed_quad(H2, (-1.0, 0.0, 0.0), BASE, BASE)
    assert issubclass(AntipodalError, DiscreteError)


@in_both_spaces
def test_good_vertices_pass_the_door(space):
    p1, p2 = corner(space, BASE, 0.2, 1.1, 0.5, 0.8)
    assert closed_quad(space, BASE, p1, p2) == close_quad(space.dot, BASE, p1, p2)
