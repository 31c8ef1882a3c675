"""Sectors between bent asymptotic lines: the series by two routes, and the integrated surfaces."""

from itertools import pairwise
from math import cos, log2, pi, sin

import numpy as np
import pytest
import sympy as sp

from theory import assembled_float, painleve_float
from theory import sector_series as series
from theory.bent_curves import binormals, frame_coefficients, lelieuvre_series, position_series
from theory.errors import DomainError
from theory.goursat_angle import goursat_angle
from theory.moutard import goursat_series

E_1, E_3 = (1, 0, 0), (0, 0, 1)
COSINE, SINE = sp.Rational(5, 13), sp.Rational(12, 13)
BENT_U, BENT_V = (sp.Rational(1, 2), sp.Integer(-1)), (sp.Integer(2),)


def _value(p, i, j):
    terms = {(0, 0, *m[2:]): c for m, c in p.terms() if m[:2] == (i, j)}
    expr = series.RING.from_dict(terms).as_expr()
    return sp.sympify(expr).subs({series.C: COSINE, series.S: SINE})


def _positions(sigma, torsion_v):
    normal = goursat_series(
        binormals(E_1, E_3, BENT_U, -1, order=4),
        binormals((COSINE, sigma * SINE, 0), E_3, BENT_V, torsion_v, order=4),
    )
    return position_series(lelieuvre_series(normal, 3))


@pytest.mark.parametrize("sigma", [1, -1])
def test_both_routes_give_the_same_surface(sigma):
    found = series.sector_series(sigma=sigma, on_u=BENT_U, on_v=BENT_V, order=3)
    for (i, j), vector in _positions(sigma, 1).items():
        assert [_value(p, i, j) for p in found.position] == list(vector)


def test_torsions_of_one_sign_make_another_surface():
    found = series.sector_series(sigma=1, on_u=BENT_U, on_v=BENT_V, order=3)
    vector = _positions(1, -1)[0, 1]
    assert [_value(p, 0, 1) for p in found.position] != list(vector)


def test_a_circle_has_constant_curvature_and_no_torsion():
    rows = frame_coefficients(E_1, E_3, (sp.Integer(1),), 0, order=6)
    t = sp.Symbol("t")
    for n, row in enumerate(rows):
        assert row[0][0] == sp.diff(sp.cos(t), t, n).subs(t, 0) / sp.factorial(n)
        assert row[2] == ((0, 0, 1) if n == 0 else (0, 0, 0))


def test_ray_frames_of_a_straight_line_turn_about_it():
    frames = assembled_float.ray_frames(0.0, lambda t: 0.0, -1, 1.0, 4)
    assert frames[-1, 0] == pytest.approx([1, 0, 0], abs=1e-10)
    assert frames[-1, 2] == pytest.approx([0, sin(1), cos(1)], abs=1e-10)


def _sphere_defect(steps):
    sectors = assembled_float.assembled(
        [pi / 2] * 4, [lambda t: 1 + t, lambda t: -1.0] * 2, length=0.5, steps=steps
    )
    return max(float(np.abs(np.linalg.norm(s.normal, axis=2) - 1).max()) for s in sectors)


def test_the_normal_stays_on_the_sphere_to_second_order():
    errors = [_sphere_defect(n) for n in (8, 16, 32, 64)]
    assert all(1.9 < log2(a / b) < 2.1 for a, b in pairwise(errors))


def test_the_angle_converges_to_second_order():
    values = [goursat_angle(1.0, 0.5, -0.3, 1.0, steps=n)[-1, -1] for n in (8, 16, 32, 64, 128)]
    steps = [abs(b - a) for a, b in pairwise(values)]
    assert all(1.9 < log2(a / b) < 2.1 for a, b in pairwise(steps))


def test_the_edges_have_the_given_rates():
    theta = goursat_angle(1.0, 0.5, -0.3, 1.0, steps=10)
    assert theta[-1, 0] == pytest.approx(1.5, abs=1e-14)
    assert theta[0, -1] == pytest.approx(0.7, abs=1e-14)


def test_the_angle_between_straight_edges_is_that_of_painleve_iii():
    errors = [
        abs(goursat_angle(1.0, 0.0, 0.0, 1.0, steps=n)[-1, -1] - painleve_float.angle(1.0, 2.0))
        for n in (8, 16, 32, 64)
    ]
    assert all(1.9 < log2(a / b) < 2.1 for a, b in pairwise(errors))


def test_counts_of_crossings_and_turns():
    turn = [2 * pi * k / 60 for k in range(60)]
    assert assembled_float.upward_crossings([sin(3 * t + 0.1) for t in turn]) == 3
    assert assembled_float.winding([(cos(2 * t), -sin(2 * t), 1.0) for t in turn]) == -2


@pytest.mark.parametrize(
    ("angles", "length", "steps"),
    [
        ([pi / 2] * 3, 0.5, 4),
        ([pi, pi / 3, pi / 3, pi / 3], 0.5, 4),
        ([pi / 2] * 4, 0.0, 4),
        ([pi / 2] * 4, float("nan"), 4),
        ([pi / 2] * 4, 0.5, 0),
    ],
)
def test_data_of_no_assembly_are_refused(angles, length, steps):
    with pytest.raises(DomainError):
        assembled_float.assembled(angles, [lambda t: 0.0] * 4, length=length, steps=steps)
