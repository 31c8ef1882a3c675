"""Winding numbers, the normal near a branch point, and its bounds: the rooms behind section 3.3."""

from itertools import pairwise
from math import pi, sin

import numpy as np
import pytest
import sympy as sp
from flint import arb, fmpq

from checks.ball import NoBallError
from checks.ball_arguments import value_on
from checks.evidence import Setting
from checks.searches import smooth_near_star, star_normals
from checks.verify import (
    branched_limits,
    normal_graphs,
    normal_index,
    normal_separation,
    normal_turning,
)
from theory import normal_bounds, star_normal, star_saddle
from theory.errors import UndecidedError
from theory.polynomial_graph import PolynomialGraph, circle, real_power
from theory.sector_normals import sector_normals
from theory.winding import X, Y, winding_by_arcs, winding_by_zeros

SETTING = Setting()
STRAIGHT = np.zeros(1)


def trigonometric_loop(n: int):
    return lambda t: circle(t, fmpq(3, 2), turns=n)


@pytest.mark.parametrize("turns", [-3, -1, 1, 2, 5])
def test_both_routes_count_the_turns_of_a_power(turns: int):
    assert winding_by_arcs(trigonometric_loop(turns)) == turns
    z = X + sp.I * (Y if turns > 0 else -Y)
    power = sp.expand(z ** abs(turns))
    assert winding_by_zeros((sp.re(power), sp.im(power)), 0, sp.Rational(3, 2)) == turns


def test_zeros_outside_of_the_circle_do_not_count():
    field = (sp.re(sp.expand((X + sp.I * Y) * (X + sp.I * Y - 2))),
             sp.im(sp.expand((X + sp.I * Y) * (X + sp.I * Y - 2))))  # fmt: skip
    counts = {radius: winding_by_zeros(field, 0, radius) for radius in (1, 3)}
    assert counts == {1: 1, 3: 2}


def test_a_zero_on_the_circle_is_refused_by_both_routes():
    with pytest.raises(UndecidedError):
        winding_by_zeros((X - 1, Y), 0, 1)
    with pytest.raises(UndecidedError):
        winding_by_arcs(lambda t: (circle(t, fmpq(1))[0] - 1, circle(t, fmpq(1))[1]), depth=8)


def test_an_arc_is_no_closed_curve():
    with pytest.raises(ValueError, match="not closed"):
        winding_by_arcs(lambda t: circle(t / 4, fmpq(1)))


@pytest.mark.parametrize("order", [2, 3, 5])
def test_the_gradient_of_a_real_power_has_one_zero_and_this_degree(order: int):
    graph = PolynomialGraph(height=real_power(order))
    assert winding_by_zeros(graph.gradient, 0, 1) == 1 - order
    expected = -((order * (order - 1)) ** 2) * (X**2 + Y**2) ** (order - 2)
    assert sp.expand(graph.hessian_determinant - expected) == 0


def test_the_upward_normal_of_a_plane():
    a, b, c = PolynomialGraph(height=2 * X - 3 * Y).normal(arb(7), arb(5))
    assert (a, b, c) == (-2, 3, 1)


@pytest.mark.parametrize("name", sorted(normal_turning.STARS))
def test_a_star_has_the_total_angle_two_pi_and_m_minus_1_sheets(name: str):
    angles = normal_turning.STARS[name]
    assert sum(angles) == 2 * sp.pi
    assert all(0 < angle < sp.pi for angle in angles)
    for target in (sp.Rational(3, 101), sp.Rational(64, 101)):
        assert len(star_normal.preimages(angles, target)) == len(angles) // 2 - 1


def test_the_image_of_a_ray_is_no_target():
    with pytest.raises(ValueError, match="image of a ray"):
        star_normal.preimages(star_saddle.regular_star(3), sp.Rational(1, 4))


def test_the_tangent_map_sends_rays_to_their_quarter_turns():
    a, b = sp.symbols("a b", positive=True)
    matrix = star_normal.sector_map((a, b), 0)
    assert sp.simplify(matrix * sp.Matrix([1, 0]) - sp.Matrix([0, 1])) == sp.zeros(2, 1)


@pytest.mark.parametrize("angle", [0.4, 1.2, pi / 2, 2.5])
def test_the_normal_of_an_amsler_sector_keeps_its_distance(angle: float):
    cells, length = 40, 0.8
    grid = sector_normals((0.0, angle), STRAIGHT, STRAIGHT, length, cells)
    assert np.max(np.abs(np.sum(grid**2, axis=2) - 1)) < 1e-3
    distance = np.linalg.norm(grid - grid[0, 0], axis=2)
    # The angle grows along the diagonal: phi_0 of the whole square is the apex's, or pi - phi.
    t = length / cells * (np.arange(cells + 1)[:, None] + np.arange(cells + 1)[None, :])
    room = min(angle, pi - angle - length**2)
    if room > 0:
        assert np.all(distance >= normal_bounds.floor(t, sin(room / 2)) - 1e-4)


def test_the_normal_of_a_sector_is_of_second_order_in_the_step():
    bend = np.array([1.0, -2.0])
    corners = [
        sector_normals((0.0, 1.0), bend, bend, 0.5, cells)[-1, -1] for cells in (8, 16, 32, 64, 128)
    ]
    errors = [float(np.linalg.norm(c - corners[-1])) for c in corners[:-1]]
    gaps = [float(np.linalg.norm(a - b)) for a, b in pairwise(corners)]
    orders = [np.log2(a / b) for a, b in pairwise(gaps)]
    assert errors == sorted(errors, reverse=True)
    assert all(1.9 < order < 2.1 for order in orders)


def test_the_half_turn_rule_agrees_with_picard_iteration():
    step = 0.5 / star_normals.CELLS
    bend = np.array([1.0, 0.5, -1.0, 2.0])
    along_u = star_normals.boundary(np.array([1.0, 0.0, 0.0]), -1.0, bend, step)
    along_v = star_normals.boundary(np.array([np.cos(1.0), np.sin(1.0), 0.0]), 1.0, bend, step)
    filled = star_normals.fill(along_u, along_v)
    solved = sector_normals((0.0, 1.0), bend, bend, 0.5, star_normals.CELLS)
    assert np.max(np.abs(filled - solved)) < 1e-4


def test_a_smooth_saddle_has_no_distance_to_itself():
    """Constant angles give the quadratic saddle over a smooth star of order 2."""
    alpha = 1.0
    star = smooth_near_star.star_hessians((alpha, pi - alpha, alpha, pi - alpha))
    cells = smooth_near_star.CELLS
    step = 2 * smooth_near_star.REACH / cells
    theta, psi = np.zeros(cells), np.full(cells, alpha)
    # What is left is the area of the cells at the rim, counted whole or not at all.
    assert smooth_near_star.mean_square(theta, psi, step, star) < 0.1
    assert smooth_near_star.mean_square(theta, psi + 0.3, step, star) > 0.2


def test_a_value_on_balls_contains_the_values_inside():
    x = sp.Symbol("x", real=True)
    expr = sp.sin(x) ** 2 / (1 + sp.cosh(x)) + sp.Rational(1, 3)
    ball = value_on(expr, {x: arb("1.0", "0.1")})
    assert ball.contains(value_on(expr, {x: arb("1.05")}))
    with pytest.raises(NoBallError):
        value_on(sp.gamma(x), {x: arb(1)})
    with pytest.raises(KeyError):
        value_on(x + 1, {})


def test_the_cone_slope_belongs_to_the_least_angle():
    k = sp.Symbol("k", positive=True)
    half = normal_bounds.least_angle(k) / 2
    assert sp.simplify(sp.sin(half) - normal_bounds.cone_slope(k)) == 0
    assert normal_bounds.cone_volume(sp.Integer(1), sp.Integer(1)) == sp.pi / 3


@pytest.mark.parametrize(
    ("check", "mutant"),
    [
        (normal_index.well_defined, {"around": True, "sense": 1, "hole": True}),
        (normal_graphs.graph_normal, {"sign": 1}),
        (normal_turning.sheets, {"shift": 0}),
        (normal_separation.separation, {"share": "101/100"}),
        (branched_limits.branched_limit, {"order": 3}),
        (branched_limits.degree_stable, {"percent": 101}),
    ],
)
def test_the_check_fails_on_its_mutant(check, mutant):
    found = check(SETTING, **mutant)
    assert found.outcome == "fail"
    assert found.witness
