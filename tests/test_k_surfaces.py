"""K-surfaces of branched nets: three routes, planar stars, lengths, index, what breaks them."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis.strategies import floats, integers

from discrete import branched_net, lax_pair, lelieuvre, planar_stars
from discrete.branched_net import Ray, geodesic_ray, regular_star, star, surgery
from discrete.curvature_energy import energies
from discrete.edge_lengths import hyperbolic_length, space_length, spherical_length
from discrete.errors import AngleError, DiscreteError, ShapeError
from discrete.index import angle_sums, interior_vertices, normal_winding
from discrete.k_surface import k_surface
from discrete.lax_pair import hirota, sym_surface
from discrete.lelieuvre import closure, lelieuvre_surface
from discrete.planar_stars import star_surface
from discrete.sector import Sector
from discrete.space_frame import SpaceFrame

ROUTES = (lelieuvre_surface, star_surface, sym_surface)
#: Rounding of some hundred steps in float64.
ROUNDING = 1e-11


def random_sector(seed: int) -> Sector:
    rng = np.random.default_rng(seed)
    n, m = rng.integers(2, 9, size=2)
    return Sector(
        u_lengths=rng.uniform(0.02, 0.3, n),
        v_lengths=rng.uniform(0.02, 0.3, m),
        corner_angle=rng.uniform(0.3, 2.5),
        u_turns=rng.uniform(-0.2, 0.2, n - 1),
        v_turns=rng.uniform(-0.2, 0.2, m - 1),
    )


def curved_star():
    """Star of six unequal sectors between rays that turn, with unequal edges."""
    rng = np.random.default_rng(5)
    rays = [
        Ray(lengths=rng.uniform(0.05, 0.12, 7), left_turns=rng.uniform(-0.1, 0.1, 6))
        for _ in range(6)
    ]
    angles = rng.uniform(0.7, 1.3, 6)
    return star(rays, (angles * 2 * np.pi / angles.sum()).tolist())


def corpus():
    once = surgery(regular_star(2, edge_length=0.1, edges=12), 0, (5, 4))
    twice = surgery(surgery(once, 2, (4, 4)), 5, (3, 3))
    five = surgery(
        regular_star(3, edge_length=0.08, edges=9),
        1,
        (3, 4),
        rays=[geodesic_ray(np.full(4, 0.07)) for _ in range(4)],
    )
    return {
        "star of 4": regular_star(2, edge_length=0.1, edges=8),
        "star of 14": regular_star(7, edge_length=0.1, edges=5),
        "curved star": curved_star(),
        "one surgery": once,
        "surgery in a daughter": twice,
        "five sectors put in": five,
    }


NETS = corpus()


@pytest.fixture(params=sorted(NETS))
def net(request):
    return NETS[request.param]


@settings(max_examples=30, deadline=None, derandomize=True)
@given(a=floats(0.001, 3))
def test_lengths_on_the_disk_the_sphere_and_in_space_belong_together(a):
    s, d = spherical_length(math, a), space_length(math, a)
    assert math.isclose(math.sin(s), d, rel_tol=1e-12)
    assert math.isclose(1 / math.cos(s), math.cosh(a), rel_tol=1e-9)
    assert math.isclose(hyperbolic_length(math, d), a, rel_tol=1e-9)


@settings(max_examples=40, deadline=None, derandomize=True)
@given(seed=integers(0, 10_000), side=integers(0, 1))
def test_the_three_routes_agree_on_a_sector(seed, side):
    sector = random_sector(seed)
    frame = SpaceFrame(
        point=np.array([0.3, -1.0, 2.0]),
        normal=np.array([0.0, 0.6, 0.8]),
        along_u=np.array([1.0, 0.0, 0.0]),
        side=1 - 2 * side,
    )
    first, *others = (route(sector, frame) for route in ROUTES)
    for other in others:
        assert np.abs(first[0] - other[0]).max() < ROUNDING
        assert np.abs(first[1] - other[1]).max() < ROUNDING
    assert closure(first[1]) < ROUNDING


@settings(max_examples=20, deadline=None, derandomize=True)
@given(seed=integers(0, 10_000))
def test_hirotas_equation_gives_the_angles_of_the_net(seed):
    sector = random_sector(seed)
    theta = hirota(sector)
    assert np.abs(theta[1:, :-1] + theta[:-1, 1:] - sector.angles).max() < ROUNDING


def test_the_routes_agree_across_branch_points(net):
    first, *others = (k_surface(net, route=route) for route in ROUTES)
    assert np.isfinite(first.points).all()
    for surface in (first, *others):
        assert surface.mismatch < ROUNDING
        assert np.abs(surface.points - first.points).max() < ROUNDING


def test_edges_have_the_lengths_that_the_net_prescribes():
    surface = k_surface(NETS["surgery in a daughter"])
    lengths = np.linalg.norm(surface.edge_vectors(), axis=1)
    assert np.abs(lengths - math.tanh(0.1)).max() < ROUNDING


def test_vertex_stars_are_planar_and_normals_are_unit(net):
    surface = k_surface(net)
    vectors = surface.edge_vectors()
    for end in (0, 1):
        at = surface.normals[net.complex.edges[:, end]]
        assert np.abs(np.einsum("ij,ij->i", at, vectors)).max() < ROUNDING
    assert np.abs(np.linalg.norm(surface.normals, axis=1) - 1).max() < ROUNDING


def test_corner_angles_in_space_are_those_on_the_hyperbolic_plane(net):
    surface = k_surface(net)
    at = surface.points[net.complex.faces]
    one, other = np.roll(at, -1, axis=1) - at, np.roll(at, 1, axis=1) - at
    cosine = np.einsum("fki,fki->fk", one, other)
    sine = np.linalg.norm(np.cross(one, other), axis=2)
    assert np.abs(np.arctan2(sine, cosine) - np.abs(net.corner_angles)).max() < 1e-9


def test_angles_add_up_and_the_normal_winds_as_the_order_says(net):
    inside = interior_vertices(net.complex)
    sums = angle_sums(net.complex, net.corner_angles)[inside]
    assert np.abs(sums - 2 * np.pi).max() < ROUNDING
    winding = normal_winding(net.complex, k_surface(net).normals)
    assert (winding == 1 - net.complex.saddle_order[inside]).all()
    assert net.complex.is_disk


def test_orders_after_surgeries():
    def orders(name):
        found = NETS[name].complex
        return found.saddle_order[found.branch_points].tolist()

    assert orders("star of 4") == []
    assert orders("star of 14") == [7]
    assert orders("surgery in a daughter") == [3, 3, 3]
    assert sorted(orders("five sectors put in")) == [3, 4]


def test_area_of_a_star_tends_to_that_of_its_rhombi():
    found = energies(NETS["star of 4"])
    corners = NETS["star of 4"].corner_angles
    assert found.area == pytest.approx(2 * np.pi * len(corners) - corners.sum())
    assert found.willmore >= 2 * found.area


# Mutants of the geometry: each is caught by one of the properties above.


def broken(net) -> bool:
    """Whether some property of K-surfaces fails: agreement, closure at the seams, planarity."""
    surfaces = [k_surface(net, route=route) for route in ROUTES]
    gap = max(np.nanmax(np.abs(s.points - surfaces[0].points)) for s in surfaces)
    return bool(gap > 1e-6 or max(s.mismatch for s in surfaces) > 1e-6)


def test_nothing_is_broken_as_it_stands(net):
    assert not broken(net)


def test_a_wrong_edge_length_on_the_sphere_is_caught(monkeypatch):
    monkeypatch.setattr(lelieuvre, "spherical_length", lambda functions, a: a)
    assert broken(NETS["one surgery"])


def test_a_sign_in_lelieuvres_formula_is_caught(monkeypatch):
    right = lelieuvre.positions
    monkeypatch.setattr(
        lelieuvre,
        "positions",
        lambda normals, point: 2 * point[:, None, None] - right(normals, point),
    )
    assert broken(NETS["one surgery"])


def test_exchanged_u_and_v_lines_are_caught(monkeypatch):
    moved = planar_stars._moved
    monkeypatch.setattr(
        planar_stars, "_moved", lambda p, n, a, length, twist: moved(p, n, a, length, -twist)
    )
    assert broken(NETS["one surgery"])


def test_a_wrong_power_of_the_spectral_parameter_is_caught(monkeypatch):
    twist = lax_pair._twist
    monkeypatch.setattr(lax_pair, "_twist", lambda t, power, sign: twist(t, 1, sign))
    assert broken(NETS["star of 4"])


def test_a_wrong_turn_of_the_parents_line_is_caught(monkeypatch):
    monkeypatch.setattr(Sector, "u_line_turns", lambda self, i, j: 0 * self.u_lengths[i + 1 :])
    assert broken(surgery(regular_star(2, edge_length=0.1, edges=12), 0, (5, 4)))


def test_a_wrong_attaching_map_is_caught(monkeypatch):
    side = branched_net._side

    def reversed_side(sector, name, start=(0, 0)):
        found = side(sector, name, start)
        return found[::-1] if start != (0, 0) else found

    monkeypatch.setattr(branched_net, "_side", reversed_side)
    net = surgery(regular_star(2, edge_length=0.1, edges=12), 0, (5, 4))
    assert not net.complex.is_disk or broken(net)


@pytest.mark.parametrize(
    ("change", "error", "told"),
    [
        ({"angles": [1.0, 1.0, 1.0, 1.0]}, AngleError, "add up to 4"),
        ({"angles": [7.0, -0.5, 0.1, 0.1]}, AngleError, "positive"),
        ({"angles": [math.nan, 1.0, 1.0, 1.0]}, AngleError, "positive"),
        ({"angles": [math.pi] * 2}, ShapeError, "4 rays and 2 angles"),
    ],
)
def test_angles_that_make_no_star_are_refused(change, error, told):
    rays = [geodesic_ray(np.full(3, 0.1))] * 4
    with pytest.raises(error, match=told):
        star(rays, change["angles"])


@pytest.mark.parametrize(
    ("lengths", "told"),
    [([0.1, -0.1], "length -0.1"), ([0.1, math.nan], "nan"), ([], "no u-edges")],
)
def test_lengths_that_are_none_are_refused(lengths, told):
    with pytest.raises(DiscreteError, match=told):
        star([geodesic_ray(lengths)] * 4, [math.pi / 2] * 4)


@pytest.mark.parametrize(
    ("number", "apex", "told"),
    [(9, (2, 2), "no sector 9"), (0, (0, 2), "not inside"), (0, (8, 2), "not inside")],
)
def test_a_surgery_where_none_can_be_is_refused(number, apex, told):
    with pytest.raises(DiscreteError, match=told):
        surgery(NETS["star of 4"], number, apex)


def test_a_sector_is_cut_once_and_its_angles_are_those_cut_out():
    once = NETS["one surgery"]
    with pytest.raises(DiscreteError, match="cut at"):
        surgery(once, 0, (2, 2))
    with pytest.raises(AngleError, match="add up"):
        surgery(NETS["star of 4"], 1, (3, 3), angles=[0.5, 0.5, 0.5])
    with pytest.raises(ShapeError, match="even"):
        surgery(NETS["star of 4"], 1, (3, 3), rays=[geodesic_ray([0.1])])


def test_a_singular_net_has_no_energy_and_says_where():
    with pytest.raises(AngleError, match="face"):
        energies(regular_star(2, edge_length=0.2, edges=20))


def test_the_rays_of_surgery_have_the_lengths_of_the_lines_cut():
    net = surgery(star([geodesic_ray([0.1] * 4), geodesic_ray([0.2] * 5)] * 2, [np.pi / 2] * 4),
                  0, (1, 2))  # fmt: skip
    shapes = [placed.sector.shape for placed in net.placed[4:]]
    # The lines cut have 3 u- and 3 v-edges; the first new ray belongs to v, the second to u.
    assert shapes == [(3, 3)] * 3
    assert all(np.all(p.sector.u_lengths == 0.1) for p in net.placed[4:])
    assert all(np.all(p.sector.v_lengths == 0.2) for p in net.placed[4:])
