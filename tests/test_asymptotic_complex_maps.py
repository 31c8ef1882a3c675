"""Fans, dual cycles, refinements, isomorphisms and coordinates of complexes; what needs what."""

from fractions import Fraction
from itertools import pairwise

import networkx as nx
import numpy as np
import pytest
from complexes import CORPUS, ball_angles, exact_angles, face_at
from flint import arb, ctx

from checks.evidence import Setting
from checks.verify import discrete_charges
from checks.verify.asymptotic_complexes_samples import band, coordinates, torus
from checks.verify.asymptotic_complexes_topology import has_families, homology
from checks.verify.binary_rank import binary_rank, bits
from checks.verify.exact_winding import winding
from discrete import charges as charges_module
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.charges import charges
from discrete.complex_errors import GluingError, UndecidedError
from discrete.complex_maps import isomorphism
from discrete.complex_surgery import surgery
from discrete.dual_cycles import crossings, fundamental_cycles, simple_cycles
from discrete.face_coordinates import FaceCoordinates
from discrete.gluing import rectangle, star
from discrete.hamburger import polygon_around
from discrete.index import angle_sums, ramified_vertex
from discrete.quad_graph import mislabelled_edge, repeated_corner, sides
from discrete.refinement import refined
from discrete.vertex_fan import vertex_fan

SMALL = {name: c for name, c in CORPUS.items() if len(c.faces) <= 60}
CLOSED = {"torus": torus(3, 4), "cylinder": band(3), "Moebius band": band(4, twisted=True)}
EVERY = pytest.mark.parametrize("complex_", (SMALL | CLOSED).values(), ids=SMALL | CLOSED)
FAN_OF_THREE = np.array([[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]])


def dual(complex_: AsymptoticComplex) -> nx.Graph:
    graph = nx.Graph()
    graph.add_nodes_from(range(len(complex_.faces)))
    graph.add_edges_from(complex_.dual_links.tolist())
    return graph


@EVERY
def test_fans_go_once_around(complex_):
    for vertex in range(complex_.vertex_count):
        fan = vertex_fan(complex_, vertex)
        assert sorted(fan.faces) == np.flatnonzero((complex_.faces == vertex).any(axis=1)).tolist()
        assert sorted(fan.edges) == np.flatnonzero((complex_.edges == vertex).any(axis=1)).tolist()
        assert fan.closed == (not complex_.is_boundary[vertex])
        families = complex_.edge_is_u[list(fan.edges)]
        assert all(a != b for a, b in pairwise(families))
        assert not fan.closed or families[0] != families[-1]


@EVERY
def test_fundamental_cycles_are_as_many_as_the_oracle_finds(complex_):
    found = fundamental_cycles(complex_)
    assert len(found) == len(nx.cycle_basis(dual(complex_)))
    near = {frozenset(link) for link in complex_.dual_links.tolist()}
    for cycle in found:
        assert len(set(cycle)) == len(cycle)
        assert all(frozenset(p) in near for p in zip(cycle, cycle[1:] + cycle[:1], strict=True))


@pytest.mark.parametrize("complex_", [rectangle(3, 3), star([1] * 6), torus(3, 3)])
def test_simple_cycles_are_those_of_the_oracle(complex_):
    found = list(simple_cycles(complex_, longest=6))
    expected = list(nx.simple_cycles(dual(complex_), length_bound=6))
    assert len(found) == len(expected)
    assert {frozenset(c) for c in found} == {frozenset(c) for c in expected}


def test_the_ring_of_a_block_crosses_twice_as_many_v_as_u_edges():
    ring = max(simple_cycles(rectangle(3, 2), longest=6), key=len)
    assert crossings(rectangle(3, 2), ring) == (2, 4)


@EVERY
def test_refinement_keeps_the_surface_and_the_branch_points(complex_):
    fine = refined(complex_)
    assert len(fine.faces) == 4 * len(complex_.faces)
    assert fine.euler_characteristic == complex_.euler_characteristic
    assert fine.boundary_circles == complex_.boundary_circles
    assert (fine.orientation is None) == (complex_.orientation is None)
    assert fine.branch_points.tolist() == complex_.branch_points.tolist()


@pytest.mark.parametrize("name", SMALL)
def test_an_isomorphism_is_found_whatever_the_numbers(name):
    complex_, rng = SMALL[name], np.random.default_rng(1)
    numbers, order = rng.permutation(complex_.vertex_count), rng.permutation(len(complex_.faces))
    other = AsymptoticComplex(faces=numbers[complex_.faces][order][:, [2, 3, 0, 1]])
    images = isomorphism(complex_, other)
    assert images is not None
    assert sorted(images) == list(range(complex_.vertex_count))
    assert (other.edge_between(*images[complex_.edges].T) >= 0).all()


def test_a_mirror_image_is_isomorphic():
    # Rays that read differently backwards, so that no turn of a face will do.
    complex_ = star([1, 2, 1, 2, 1, 1, 3, 1])
    for swap in ([1, 0, 3, 2], [3, 2, 1, 0]):
        mirrored = AsymptoticComplex(faces=complex_.faces[:, swap])
        images = isomorphism(complex_, mirrored)
        assert images is not None
        assert (mirrored.degree[images] == complex_.degree).all()


def test_complexes_that_the_oracle_tells_apart_have_no_isomorphism():
    smooth = star([2] * 4)
    operated, _ = surgery(smooth, 0, face_at(smooth, 0), [2, 2])
    assert isomorphism(operated, star([2] * 6)) is not None
    assert isomorphism(star([2, 2, 2, 4]), star([2, 4, 2, 2])) is not None
    assert isomorphism(star([2, 2, 2, 4]), star([2, 2, 4, 2])) is None  # u and v swapped
    assert isomorphism(band(4), band(4, twisted=True)) is None


@EVERY
def test_homology_agrees_with_the_topology(complex_):
    found = homology(complex_)
    assert (found.betti == 0) == complex_.is_simply_connected
    assert found.parts == 1


def test_homology_of_a_torus_and_bands():
    assert homology(torus(3, 3)).betti == 2
    assert homology(band(3)).betti == homology(band(3, twisted=True)).betti == 1


def test_what_each_conclusion_of_the_lemma_needs():
    """Even degrees need the families alone; a checkerboard needs simple connectedness too."""
    for complex_ in CLOSED.values():
        assert (complex_.degree[~complex_.is_boundary] % 2 == 0).all()
    assert band(3).checkerboard is None
    assert torus(3, 3).checkerboard is None
    assert torus(4, 4).checkerboard is not None
    # Without families: three rectangles around a vertex, a disk, regular, of degree 3.
    assert repeated_corner(FAN_OF_THREE) is None
    assert not has_families(FAN_OF_THREE.tolist())
    assert mislabelled_edge(sides(FAN_OF_THREE)) is not None


def test_sizes_that_do_not_fit_are_refused():
    one, two = Fraction(1), Fraction(2)
    chart = coordinates(star([1] * 6), np.random.default_rng(0))
    assert chart.corner(0, 2) == chart.sizes[0]
    with pytest.raises(GluingError, match="faces 0 and 1 have a common edge of the lengths 1 and"):
        FaceCoordinates(complex=rectangle(2, 1), sizes=[(one, one), (one, two)])
    with pytest.raises(GluingError, match="face 1 has the sides 1 and 0"):
        FaceCoordinates(complex=rectangle(2, 1), sizes=[(one, one), (one, 0 * one)])
    with pytest.raises(GluingError, match="1 sizes for 2 faces"):
        FaceCoordinates(complex=rectangle(2, 1), sizes=[(one, one)])


def test_binary_rank_is_that_of_elimination_by_hand():
    assert binary_rank([0b110, 0b011, 0b101]) == 2
    assert binary_rank([0b1, 0b10, 0b100, 0]) == 3
    assert bits([3, 3, 1]) == 0b10


def test_winding_counts_turns():
    square = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
    assert winding(square) == 1
    assert winding(square[::-1]) == -1
    assert winding(square * 3) == 3
    assert winding([(3, 1), (4, 1), (4, 2)]) == 0
    with pytest.raises(ValueError, match="meets the origin"):
        winding([(1, 0), (-1, 0), (0, 1)])


def test_a_ball_too_wide_is_undecided():
    complex_ = star([1] * 6)
    fractions = np.full(complex_.faces.shape, Fraction(-1, 3), dtype=object)
    fractions[complex_.faces == 0] = Fraction(-2, 3)
    with ctx.workprec(64):
        angles = ball_angles(fractions)
        assert ramified_vertex(
            complex_, angles, straight_angle=arb.pi(), tolerance=arb("1e-9")
        ) is (None)
        wide = angles + arb(0, 4)
        with pytest.raises(UndecidedError, match="vertex 0"):
            ramified_vertex(complex_, wide, straight_angle=arb.pi(), tolerance=arb("1e-9"))


def test_angles_given_to_the_wrong_corners_break_the_balance(monkeypatch):
    """A mutant of the library itself: the sums of angles are those of the next corners."""
    complex_ = star([2] * 6)
    whole = polygon_around(complex_, np.ones(len(complex_.faces), dtype=bool))
    angles = exact_angles(complex_, np.random.default_rng(0))
    assert charges(whole, angles, straight_angle=Fraction(1)).residual == 0
    monkeypatch.setattr(
        charges_module, "angle_sums", lambda c, a: angle_sums(c, np.roll(a, 1, axis=1))
    )
    monkeypatch.setattr(charges_module, "open_vertex", lambda *_, **__: None)
    assert charges(whole, angles, straight_angle=Fraction(1)).residual != 0


def test_the_check_of_the_balance_fails_on_its_mutants():
    setting = Setting(seed="3")
    assert discrete_charges.balance(setting).outcome == "pass"
    for mutant in ({"regular": 1}, {"sign": 1}, {"corners": True}):
        assert discrete_charges.balance(setting, **mutant).outcome == "fail"
