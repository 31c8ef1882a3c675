"""Nets made twice, by angles and by half-turns; areas without angles; what the checks refuse."""

import math
from importlib import import_module

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis.strategies import floats

from checks.evidence import Setting
from checks.verify import geometric_nets as nets
from checks.verify import planar_stars
from checks.verify.announced_nets import complex_from_places
from checks.verify.net_deformation import crossing_edges, vertex_places
from checks.verify.net_topology import given_complex
from discrete.complex_maps import isomorphism
from discrete.geodesics import polar
from discrete.space_forms import H2, ORIGIN

#: Rounding of triples up to distance 3, as angles of edges of length 1/10.
ROUNDING = 1e-11


@settings(max_examples=40, deadline=None, derandomize=True)
@given(a=floats(0.01, 2), b=floats(0.01, 2), turn=floats(0, 6))
def test_the_area_of_a_right_triangle_is_that_of_its_legs(a, b, turn):
    p, q = (polar(H2, math, turn, a), polar(H2, math, turn + math.pi / 2, b))
    area = nets.triangle_area(math, ORIGIN, p, q)
    expected = 2 * math.atan(math.tanh(a / 2) * math.tanh(b / 2))
    assert math.isclose(area, expected, rel_tol=1e-9)
    assert math.isclose(nets.triangle_area(math, ORIGIN, q, p), -expected, rel_tol=1e-9)


@pytest.mark.parametrize("recipe", nets.LARGE)
def test_both_routes_give_the_same_angles_and_the_same_seams(recipe):
    net = nets.float_net(recipe)
    nodes = nets.sector_nodes(recipe, math, float(recipe.edge_length))
    angles = np.abs(planar_stars.angles_in_disk(nets.face_corners(net, nodes)))
    assert np.abs(angles - net.corner_angles).max() < ROUNDING
    advanced = nets.corner_angles(
        net, nets.sector_angles(recipe, math, float(recipe.edge_length)), math.pi
    )
    assert np.abs(advanced.astype(float) - net.corner_angles).max() < ROUNDING
    assert vertex_places(net, nodes)[1] < ROUNDING


@pytest.mark.parametrize("recipe", nets.SMALL)
def test_areas_by_triangles_are_those_by_angles(recipe):
    net = nets.float_net(recipe)
    nodes = nets.sector_nodes(recipe, math, float(recipe.edge_length))
    areas = nets.quad_areas(math, nets.face_corners(net, nodes))
    defects = 2 * np.pi - net.corner_angles.sum(axis=1)
    assert np.abs(np.array(areas) - defects).max() < ROUNDING


def test_a_bow_tie_crosses_itself_once():
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    assert crossing_edges(square) == 0
    assert crossing_edges(square[[0, 2, 1, 3]]) == 1


def test_the_complex_of_a_recipe_is_not_that_of_another():
    first, second = nets.SMALL[0], nets.SMALL[1]
    assert isomorphism(given_complex(first), nets.float_net(first).complex) is not None
    assert isomorphism(given_complex(first), nets.float_net(second).complex) is None


def test_places_identify_the_common_vertices_of_two_quads():
    a, b, c, d, e, f = ((1.0, x, y) for y in (0.0, 0.1) for x in (0.0, 0.1, 0.2))
    found = complex_from_places([(a, b, e, d), (b, c, f, e)])
    assert found.vertex_count == 6
    assert found.is_disk


CHECKS = [
    ("net_balance:floats", {"percent": 101}),
    ("net_balance:balls", {"regular": 3}),
    ("net_balance:balls", {"corners": True}),
    ("planar_stars:whole", {"gap": "1/100"}),
    ("planar_stars:quad", {"scale": "101/100"}),
    ("net_topology:branch_points", {"interior": False}),
    ("net_deformation:composite", {"folded": True}),
    ("intrinsic_second_form:second_form", {"sign": -1}),
    ("robust_index:disturbed", {"percent": 101}),
    ("robust_index:encoded", {"offset": 2}),
    ("announced_nets:surgery_adds", {"gained": 2}),
    ("announced_nets:distinguishes", {"least": 8}),
    ("smooth_sectors:cannot_refine", {"smooth": False}),
    ("discussion:distributed", {"order": 4}),
]


@pytest.mark.parametrize(("run", "mutant"), CHECKS)
def test_a_check_passes_as_it_stands_and_fails_on_its_mutant(run, mutant):
    module, name = run.split(":")
    check = getattr(import_module(f"checks.verify.{module}"), name)
    assert check(Setting()).outcome == "pass"
    broken = check(Setting(), **mutant)
    assert broken.outcome == "fail"
    assert broken.witness
