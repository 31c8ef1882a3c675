"""Theory of the generalised sine-Gordon equation: polygons, stars, tilings with branch points."""

from fractions import Fraction
from math import pi, sin, sqrt
from random import Random

import pytest
import sympy as sp
from flint import arb, ctx
from hypothesis import given, settings
from hypothesis import strategies as st

from checks.evidence import Setting
from checks.verify import tilings as corpus
from checks.verify.convergence import observed_orders
from theory import (
    amsler_star_area,
    asymptotic_polygon,
    chebyshev_sector,
    painleve,
    rough_front,
    soliton_rectangle,
)
from theory.asymptotic_tiling import Tiling, star
from theory.star_field import StarField, lengths
from theory.tiling_angles import PI, TilingAngles, added, scaled

SERIES_ERROR = 1e-12
"""Forty terms of the series for x <= 1, rounded."""


def sum_rule(angles: TilingAngles, charge: int, choice: str = "middle"):
    """Relation sum over the rim = area - charge pi."""
    return added(angles.rim_sum(choice), scaled(-1, angles.area()), {PI: charge})


@pytest.mark.parametrize("twelfths", [1, 3, 6, 9, 11])
@pytest.mark.parametrize("x", ["0.04", "0.36", "1"])
def test_the_series_of_the_angle_agrees_with_certified_values(twelfths, x):
    exact = painleve.angle(lambda: arb.pi() * twelfths / 12, lambda: 2 * arb(x).sqrt())
    value = float(amsler_star_area.angle(pi * twelfths / 12, float(x)))
    assert value == pytest.approx(float(exact.ball()), abs=SERIES_ERROR)


def test_the_midpoint_rule_is_of_order_two():
    exact = painleve.angle(1, 2).ball() - 1  # Hazzidakis on [0, 1]^2
    levels = (4, 8, 16, 32)
    errors = [
        amsler_star_area.rectangle_area(1.0, (0.0, 1.0), (0.0, 1.0), n) - float(exact)
        for n in levels
    ]
    orders = observed_orders([1 / n for n in levels], errors)
    assert all(1.9 < order < 2.1 for order in orders)


def test_the_turning_of_a_rough_edge_has_no_difference_quotient():
    quotients = [abs(rough_front.turning(4.0**-k, 1.0)) * 4**k for k in range(2, 8)]
    assert quotients[-1] > 4 * quotients[0]
    assert rough_front.turning(0.0, 1.0) == 0


def test_edges_have_unit_speed_and_the_net_keeps_it():
    cells, length = 16, 0.8
    grid = rough_front.normals(cells, length, 1.2)
    for i in range(cells):
        for j in range(cells + 1):
            a, b = grid[i][j], grid[i + 1][j]
            chord = sqrt(sum((x - y) ** 2 for x, y in zip(a, b, strict=True)))
            assert sum(x * x for x in a) == pytest.approx(1, abs=1e-12)
            first = 2 * sin(length / cells / 2)
            assert chord == pytest.approx(first, rel=0.02)  # an edge is no great circle
            if j:
                start = grid[i][0], grid[i + 1][0]
                other = sqrt(sum((x - y) ** 2 for x, y in zip(*start, strict=True)))
                assert chord == pytest.approx(other, abs=1e-12)  # opposite sides are equal


def test_the_corner_of_a_chebyshev_net_tends_to_the_angle_of_the_sector():
    exact = float(painleve.angle(lambda: arb.pi() / 3, 1).ball())
    levels = (16, 32, 64, 128)
    errors = [chebyshev_sector.far_angle(pi / 3, 0.5, n) - exact for n in levels]
    orders = observed_orders([1 / n for n in levels], errors)
    assert all(0.9 < order < 1.1 for order in orders)


def test_half_turns_keep_the_sides_and_the_hyperboloid():
    columns = chebyshev_sector.net(1.0, 0.6, 6)
    product = chebyshev_sector.product
    for i in range(6):
        for j in range(6):
            p, q, r = columns[i][j], columns[i + 1][j], columns[i][j + 1]
            s = columns[i + 1][j + 1]
            assert product(s, s) == pytest.approx(-1, abs=1e-12)
            assert product(q, s) == pytest.approx(product(p, r), abs=1e-12)
            assert product(r, s) == pytest.approx(product(p, q), abs=1e-12)


def test_a_long_strip_of_the_pseudosphere_has_nearly_the_area_pi():
    with ctx.workprec(100):
        area = soliton_rectangle.area((Fraction(-30), Fraction(0), Fraction(-30), Fraction(0)))
        assert area.is_finite()
        assert abs(area - arb.pi()) < arb("1e-11")  # two corners at 4 arctan e^-30, about 4e-13
        assert not area > arb.pi()


@pytest.mark.parametrize("order", [2, 3, 6])
def test_the_sum_over_a_star_is_its_area_less_its_charge(order):
    field, rays = StarField(order=order), lengths(order)
    found = sp.expand(field.alternating_sum(field.star(rays)) - field.star_area(rays))
    assert found == -(order - 2) * sp.pi


def test_the_angle_on_a_star_solves_the_sine_gordon_equation_where_the_area_density_is_the_sine():
    field = StarField(order=3)
    s, t = sp.symbols("s t", positive=True)
    for j in range(field.size):
        mixed = sp.diff(field.angle((j, s, t)), s, t)
        density = sp.diff(field.area_from_p(j, s, t), s, t)
        assert sp.expand(mixed - field.sigma(j) * density) == 0


def test_no_arc_joins_opposite_corners():
    field = StarField(order=3)
    with pytest.raises(ValueError, match="no asymptotic arc"):
        field.arc_family((0, 1, 1), (3, 1, 1))


@pytest.mark.parametrize("name", sorted(asymptotic_polygon.POLYGONS))
def test_the_polygons_are_simple_and_counter_clockwise(name):
    polygon = asymptotic_polygon.POLYGONS[name]
    area = sum(a * d - b * c for (a, b), (c, d) in asymptotic_polygon.arcs(polygon)) / 2
    assert asymptotic_polygon.is_simple(polygon)
    assert area == len(asymptotic_polygon.cells(polygon))


def test_a_single_rectangle_is_a_tiling_with_hazzidakis_sum():
    angles = TilingAngles(tiling=Tiling(faces=(("a", "b", "c", "d"),)))
    assert angles.rim_sum() == {(0, k): (-1) ** k for k in range(4)}
    assert angles.implies(sum_rule(angles, 0))
    assert not angles.implies(sum_rule(angles, 1))


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10**6), order=st.integers(2, 4), times=st.integers(0, 12))
def test_random_tilings_are_disks_with_the_sum_rule(seed, order, times):
    rng = Random(seed)
    whole = star(order, rng, longest=2, depth=1)
    tiling = whole.trimmed(rng, times, spare=set(whole.branch_points))
    assert tiling.is_disk()
    for (a, b), face in tiling.sides.items():
        other = tiling.sides.get((b, a))
        if other is not None:
            assert face != other
            assert tiling.family(a, b) == tiling.family(b, a)
    charge = sum(m - 2 for m in tiling.branch_points.values())
    corners = sum(2 - tiling.degrees[vertex] for vertex in tiling.rim)
    assert corners == 4 + 2 * charge
    angles = TilingAngles(tiling=tiling)
    assert angles.is_consistent()
    assert angles.implies(sum_rule(angles, charge))
    assert not angles.implies(sum_rule(angles, charge + 1))


def test_a_corner_on_a_branch_ray_needs_the_limit_from_the_middle_quadrant():
    """Star of order 3, rays of length 2, an outer face at ray 0 taken away on either side of it."""
    whole = star(3, Random(0), longest=2, depth=0)
    end = (("ray", 0), 2)
    first = []
    for gone in (face for face in whole.faces if end in face):
        tiling = Tiling(faces=tuple(face for face in whole.faces if face != gone))
        assert tiling.is_disk()
        assert not corpus.off_rays(tiling)
        angles = TilingAngles(tiling=tiling)
        assert angles.implies(sum_rule(angles, 1, "middle"))
        first.append(angles.implies(sum_rule(angles, 1, "first")))
    assert not all(first)


def test_a_refined_tiling_keeps_its_branch_points():
    tiling = star(3, Random(5), longest=3, depth=2)
    fine = tiling.refined()
    assert len(fine.faces) == 4 * len(tiling.faces)
    assert fine.is_disk()
    assert fine.branch_points == tiling.branch_points


def test_the_corpus_keeps_its_promises():
    found, tried = corpus.random_tilings(Setting(), wanted=30)
    assert tried >= len(found) == 30
    assert sum(len(t.branch_points) >= 3 for t in found) >= 10
    assert sum(corpus.has_reflex(t) for t in found) >= 10
    assert {m for t in found for m in t.branch_points.values()} >= {3, 4, 5, 6}
    assert all(corpus.off_rays(t) for t in found)


def test_the_corpus_says_when_it_cannot_be_made():
    with pytest.raises(ValueError, match="tilings tried"):
        corpus.random_tilings(Setting(), wanted=5, most_faces=3, tries=10)
