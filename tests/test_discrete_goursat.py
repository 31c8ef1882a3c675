"""Goursat fill of a rectangle: generic body, compiled kernel, rivals, and a user's bad sides."""

import math

import mpmath
import numpy as np
import pytest
from discrete_samples import BASE, SPACES, array, polyline
from flint import arb, ctx
from goursat_rivals import by_antidiagonals, row_loop
from hypothesis import given, settings
from hypothesis import strategies as st

from discrete import goursat_kernel
from discrete.errors import AntipodalError, NotFiniteError, OffSpaceError, ShapeError
from discrete.geodesics import polar
from discrete.goursat_fill import fill, filled_rectangle, require_node
from discrete.goursat_kernel import ROWS, STEPS, fill_nodes, filled_array
from discrete.quad_rule import close_quad
from discrete.space_forms import H2, S2

in_both_spaces = pytest.mark.parametrize("space", SPACES, ids=lambda s: s.name)


def random_sides(space, n, m, seed, *, longest=0.05):
    """Two polylines with n and m vertices, edges of all lengths, gently turning."""
    rng = np.random.default_rng(seed)

    def side(count, start):
        edges = rng.uniform(longest / 10, longest, count - 1)
        return polyline(space, start, edges, rng.uniform(-0.1, 0.1, count - 2))

    return side(n, 0.0), side(m, 1.2)


def opposite_sides_defect(space, nodes):
    """Largest difference of the products along opposite sides, and largest residual, of a net."""
    along_u = space.dot(nodes[:, 1:, :], nodes[:, :-1, :])
    along_v = space.dot(nodes[:, :, 1:], nodes[:, :, :-1])
    return max(
        np.abs(along_u - along_u[:, :1]).max(),
        np.abs(along_v - along_v[:1, :]).max(),
        np.abs(space.residual(nodes)).max(),
    )


@in_both_spaces
@settings(max_examples=15)
@given(n=st.integers(2, 25), m=st.integers(2, 25), seed=st.integers(0, 10**6))
def test_opposite_sides_are_equal_all_over_the_net(space, n, m, seed):
    first, second = random_sides(space, n, m, seed)
    nodes = np.array(filled_rectangle(space, first, second)).transpose(2, 0, 1)
    assert opposite_sides_defect(space, nodes) < 1e-10


@in_both_spaces
@pytest.mark.parametrize(
    "shape",
    [(2, 2), (2, 9), (9, 2), (ROWS, 5), (ROWS + 1, STEPS), (ROWS + 2, STEPS + 1), (3, 200),
     (200, 3), (2 * ROWS + 7, 3 * STEPS - 5), (70, 70)],
)  # fmt: skip
def test_the_kernel_is_the_generic_body_bit_by_bit(space, shape):
    first, second = random_sides(space, *shape, seed=sum(shape), longest=0.02)
    expected = np.array(fill(space.dot, first, second)).transpose(2, 0, 1)
    assert np.array_equal(filled_array(space, array(first), array(second)), expected)


@in_both_spaces
def test_the_rivals_of_the_benchmark_fill_the_same_net(space):
    first, second = random_sides(space, 40, 55, seed=3)
    expected = filled_array(space, array(first), array(second))
    for way in (row_loop(space), lambda nodes: by_antidiagonals(space, nodes)):
        nodes = np.zeros_like(expected)
        nodes[:, :, 0], nodes[:, 0, :] = array(first), array(second)
        way(nodes)
        assert np.array_equal(nodes, expected)


def test_the_comparison_sees_swapped_u_and_v():
    first, second = random_sides(H2, 30, 30, seed=5)
    right = filled_array(H2, array(first), array(second))
    assert np.abs(right - filled_array(H2, array(second), array(first))).max() > 0.01


@in_both_spaces
def test_the_equal_sides_test_sees_a_wrong_edge_and_a_wrong_sign(space):
    first, second = random_sides(space, 12, 12, seed=8)
    nodes = filled_array(space, array(first), array(second))
    assert opposite_sides_defect(space, nodes) < 1e-11
    spoilt = nodes.copy()
    spoilt[:, 5, 5] = polar(space, math, 0.1, 0.2)
    assert opposite_sides_defect(space, spoilt) > 1e-4
    mirrored = nodes.copy()
    mirrored[2, 6:, 6:] *= -1
    assert opposite_sides_defect(space, mirrored) > 1e-4


@in_both_spaces
def test_floats_balls_and_mpmath_agree(space):
    first, second = random_sides(space, 9, 8, seed=11)
    floats = fill(space.dot, first, second)[8][7]
    exact = [[tuple(map(arb, p)) for p in side] for side in (first, second)]
    with mpmath.workdps(50):
        multi = [[tuple(map(mpmath.mpf, p)) for p in side] for side in (first, second)]
        reference = fill(space.dot, *multi)[8][7]
    with ctx.workprec(256):
        balls = fill(space.dot, *exact)[8][7]
        for f, m, ball in zip(floats, reference, balls, strict=True):
            assert ball.is_finite()
            assert ball.rad() < 1e-40
            assert abs(ball - arb(mpmath.nstr(m, 50))) < 1e-40
            assert abs(f - m) < 1e-12


def test_the_stored_code_is_renewed_when_the_rule_changes():
    # numba keys its store by the closure: it must hold the source of the rule.
    cells = goursat_kernel.kernel(H2).py_func.__closure__
    assert any("k * s[0] - p[0]" in str(cell.cell_contents) for cell in cells)


def good_sides(space):
    return random_sides(space, 4, 5, seed=1)


@in_both_spaces
@pytest.mark.parametrize(
    "door", [filled_rectangle, lambda s, a, b: filled_array(s, array(a), array(b))]
)
def test_bad_sides_are_named(space, door):
    first, second = good_sides(space)
    with pytest.raises(NotFiniteError, match="vertex 2 of the first side"):
        door(space, [*first[:2], (math.nan, 0.0, 0.0), first[3]], second)
    with pytest.raises(NotFiniteError, match="vertex 1 of the second side"):
        door(space, first, [second[0], (math.inf, 0.0, 0.0), *second[2:]])
    with pytest.raises(OffSpaceError, match="vertex 3 of the first side"):
        door(space, [*first[:3], (1.0, 0.3, 0.0)], second)
    with pytest.raises(ShapeError, match="start at different"):
        door(space, first, [polar(space, math, 0.1, 0.2), *second[1:]])
    with pytest.raises(ShapeError, match="second side has 1 vert"):
        door(space, first, second[:1])


@pytest.mark.parametrize(
    "door", [filled_rectangle, lambda s, a, b: filled_array(s, array(a), array(b))]
)
def test_antipodal_neighbours_are_named(door):
    half = math.pi / 2
    first = [BASE, polar(S2, math, 0.0, half)]
    second = [BASE, polar(S2, math, math.pi, half)]
    with pytest.raises(AntipodalError, match=r"\(0, 1\) and \(1, 0\)"):
        door(S2, first, second)


def test_a_net_that_has_lost_its_digits_is_refused():
    steps = [0.5 * k for k in range(40)]
    first, second = ([polar(H2, math, turn, s) for s in steps] for turn in (0.0, 1.5))
    with pytest.raises(OffSpaceError, match=r"node \(0, \d+\) .*angle_advance"):
        filled_array(H2, array(first), array(second))
    with pytest.raises(NotFiniteError, match=r"node \(2, 3\)"):
        require_node(H2, (math.nan, 0.0, 0.0), 2, 3)


def test_arrays_of_the_wrong_shape_are_refused():
    with pytest.raises(ShapeError, match=r"shape \(3, n, m\)"):
        fill_nodes(H2, np.zeros((2, 4, 4)))
    with pytest.raises(ShapeError, match="float32"):
        fill_nodes(H2, np.zeros((3, 4, 4), dtype=np.float32))
    with pytest.raises(ShapeError, match="first side has the shape"):
        filled_array(H2, np.zeros((4, 3)), np.zeros((3, 3)))
    first, second = (array(side) for side in good_sides(H2))
    with pytest.raises(ShapeError, match="out has the shape"):
        filled_array(H2, first, second, out=np.zeros((3, 9, 9)))


@in_both_spaces
def test_close_quad_is_what_the_fill_uses(space):
    first, second = good_sides(space)
    nodes = fill(space.dot, first, second)
    assert nodes[1][1] == close_quad(space.dot, first[0], first[1], second[1])
    assert [row[0] for row in nodes] == first
    assert nodes[0] == second
