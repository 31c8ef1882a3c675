"""Complexes: the corpus through every invariant, an oracle, and what is refused with its reason."""

import networkx as nx
import numpy as np
import pytest
from complexes import CORPUS, face_at, random_complex

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import (
    ComplexError,
    FaceError,
    GluingError,
    LabelError,
    RegularityError,
    SurfaceError,
    SurgeryError,
)
from discrete.complex_surgery import attached, boundary_segment, quadrant, surgery
from discrete.gluing import Seam, fan, glued, grid, rectangle, side, star

RANDOM = {f"random {n}": random_complex(np.random.default_rng(n), 4) for n in range(12)}
EVERY = pytest.mark.parametrize("complex_", (CORPUS | RANDOM).values(), ids=CORPUS | RANDOM)


def dual(complex_: AsymptoticComplex) -> nx.Graph:
    graph = nx.Graph()
    graph.add_nodes_from(range(len(complex_.faces)))
    graph.add_edges_from(complex_.dual_links.tolist())
    return graph


def skeleton(complex_: AsymptoticComplex) -> nx.Graph:
    return nx.Graph(complex_.edges.tolist())


def ring(rectangles: int, *, reverse: bool = False) -> AsymptoticComplex:
    """Band of rectangles glued along v-edges into a cylinder, or reversed into a Moebius band."""
    ends = side(1, 1, "u = n"), side(1, 1, "u = 0")
    seams = [
        Seam(first=k, path=ends[0], second=(k + 1) % rectangles, onto=ends[1])
        for k in range(rectangles)
    ]
    if reverse:
        seams[-1] = Seam(first=rectangles - 1, path=ends[0], second=0, onto=ends[1][::-1])
    return glued([rectangle(1, 1)] * rectangles, seams).complex


@EVERY
def test_it_is_a_disk_with_a_checkerboard(complex_):
    assert complex_.is_disk
    assert complex_.is_simply_connected
    colours = complex_.checkerboard
    one, other = complex_.dual_links.T
    assert (colours[one] == -colours[other]).all()
    assert complex_.odd_dual_cycle is None
    assert nx.is_bipartite(dual(complex_))


@EVERY
def test_the_oracle_sees_the_same_graph(complex_):
    graph = skeleton(complex_)
    assert graph.number_of_nodes() == complex_.vertex_count
    assert dict(graph.degree()) == dict(enumerate(complex_.degree.tolist()))
    assert nx.check_planarity(graph)[0]
    assert nx.is_connected(graph) == nx.is_connected(dual(complex_)) == complex_.is_connected
    assert nx.is_connected(nx.Graph(complex_.boundary_edges.tolist()))
    assert complex_.boundary_circles == 1


@EVERY
def test_the_degrees_count_faces(complex_):
    inside = ~complex_.is_boundary
    assert (complex_.degree[inside] % 2 == 0).all()
    assert (complex_.degree == complex_.face_count + complex_.is_boundary).all()
    assert (2 * complex_.saddle_order[inside] == complex_.degree[inside]).all()
    # Corner vertices are the boundary vertices with an odd number of faces.
    assert (complex_.is_corner == (complex_.is_boundary & (complex_.face_count % 2 == 1))).all()


@EVERY
def test_as_many_u_as_v_edges_at_every_interior_vertex(complex_):
    u_edges = complex_.edges[complex_.edge_is_u]
    u_degree = np.bincount(u_edges.ravel(), minlength=complex_.vertex_count)
    inside = ~complex_.is_boundary
    assert (2 * u_degree[inside] == complex_.degree[inside]).all()


@EVERY
def test_orientation_turns_against_the_checkerboard_only_across_reflected_edges(complex_):
    signs = complex_.orientation
    one, other = complex_.dual_links.T
    assert ((signs[one] != signs[other]) == complex_.sides.same_direction).all()


@EVERY
def test_the_whole_curvature_is_that_of_a_disk(complex_):
    """Sum of 4 - degree inside and 3 - degree on the boundary is 4 for a disk of quads."""
    total = (4 - complex_.is_boundary - complex_.degree).sum()
    assert total == 4 * complex_.euler_characteristic


@pytest.mark.parametrize("lengths", [[1] * 4, [2, 3, 4, 5], [3, 1, 2, 1, 1, 4], [2] * 12])
def test_a_star_has_the_faces_and_vertices_counted_by_hand(lengths):
    complex_ = star(lengths)
    pairs = list(zip(lengths, lengths[1:] + lengths[:1], strict=True))
    assert len(complex_.faces) == sum(a * b for a, b in pairs)
    assert complex_.vertex_count == 1 + sum(lengths) + len(complex_.faces)
    assert complex_.saddle_order[0] == len(lengths) // 2
    assert complex_.is_corner.sum() == len(lengths)


def test_a_million_vertices():
    complex_ = star([409] * 6)
    assert complex_.vertex_count == 1 + 6 * 409 + 6 * 409**2 > 10**6
    assert complex_.is_disk
    assert complex_.branch_points.tolist() == [0]
    assert complex_.checkerboard is not None


@pytest.mark.parametrize("added", [1, 2, 4])
def test_surgery_adds_to_the_order_of_its_vertex_alone(added):
    middle = int(grid(6, 5)[3, 2])
    before = rectangle(6, 5)
    after, at = surgery(before, middle, face_at(before, middle), [2, 3] * added)
    assert after.is_disk
    assert after.saddle_order[at] == 2 + added
    assert after.branch_points.tolist() == [at]


def test_surgery_removes_the_quadrant_and_puts_in_the_new_sectors():
    middle = int(grid(6, 5)[3, 2])
    before = rectangle(6, 5)
    cut = quadrant(before, middle, face_at(before, middle))
    assert cut.shape == (2, 3)  # rows run along u
    after, _ = surgery(before, middle, face_at(before, middle), [4, 7])
    assert len(after.faces) == 30 - 6 + 3 * 4 + 4 * 7 + 7 * 2


def test_a_corner_is_closed_by_three_sectors():
    before = rectangle(3, 2)
    assert boundary_segment(before, 0, along_u=True).tolist() == side(3, 2, "v = 0").tolist()
    after, places = attached(before, 0, [5, 6])
    assert not after.is_boundary[places[0]]
    assert after.saddle_order[places[0]] == 2
    assert len(after.faces) == 6 + 3 * 5 + 5 * 6 + 6 * 2


def test_a_monkey_star_is_a_smooth_star_after_surgery():
    """The two grids of figure (fig:skeleton): assembly and surgery give one complex."""
    smooth = star([2] * 4)
    operated, _ = surgery(smooth, 0, face_at(smooth, 0), [2, 2])
    assert nx.is_isomorphic(skeleton(operated), skeleton(star([2] * 6)))
    other, _ = surgery(smooth, 0, face_at(smooth, 0), [2, 1])
    assert not nx.is_isomorphic(skeleton(other), skeleton(star([2] * 6)))


def test_a_cylinder_of_three_has_no_checkerboard():
    band = ring(3)
    assert (band.is_connected, band.euler_characteristic, band.boundary_circles) == (True, 0, 2)
    assert not band.is_simply_connected
    assert band.checkerboard is None
    assert sorted(band.odd_dual_cycle) == [0, 1, 2]
    assert ring(4).checkerboard is not None


def test_an_odd_cycle_is_a_closed_path_of_neighbours():
    band = ring(5)
    cycle = band.odd_dual_cycle
    links = {frozenset(link) for link in band.dual_links.tolist()}
    assert len(cycle) % 2 == 1
    assert all(frozenset(p) in links for p in zip(cycle, cycle[1:] + cycle[:1], strict=True))


def test_the_surface_of_a_box_has_no_second_family():
    """The cube: three faces at each vertex, so that u- and v-edges cannot alternate."""
    cube = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
    with pytest.raises(LabelError, match=r"u-edge of one face and a v-edge of another"):
        AsymptoticComplex(faces=np.array(cube))


REFUSED = {
    "a corner twice": ([[0, 1, 2, 1]], FaceError, "face 0 has a vertex twice"),
    "a gap": ([[0, 1, 2, 4]], FaceError, "vertex 3 is in no face"),
    "negative": ([[0, 1, 2, -1]], FaceError, "vertex -1 is negative"),
    "triangles": ([[0, 1, 2]], FaceError, "shape"),
    "no face": (np.zeros((0, 4), dtype=int), FaceError, "shape"),
    "floats": ([[0.0, 1.0, 2.0, np.nan]], FaceError, "integers"),
    "three at an edge": (
        [[0, 1, 2, 3], [0, 1, 4, 5], [0, 1, 6, 7]],
        SurfaceError,
        r"edge \(0, 1\) is in three faces",
    ),
    "two fans": ([[0, 1, 2, 3], [0, 4, 5, 6]], SurfaceError, "vertex 0 are not one fan"),
    "two common edges": ([[0, 1, 2, 3], [0, 1, 2, 4]], RegularityError, "faces 0 and 1"),
    "opposite corners": ([[0, 1, 2, 3], [0, 4, 2, 5]], RegularityError, "faces 0 and 1"),
    "swapped labels": ([[0, 1, 2, 3], [1, 2, 5, 4]], LabelError, r"edge \(1, 2\) is a u-edge"),
}


@pytest.mark.parametrize(("faces", "error", "message"), REFUSED.values(), ids=REFUSED)
def test_what_is_no_complex_is_refused(faces, error, message):
    with pytest.raises(error, match=message):
        AsymptoticComplex(faces=np.array(faces))


def test_two_rectangles_with_one_family_on_their_edge_are_a_complex():
    """The near miss of the swapped labels."""
    assert AsymptoticComplex(faces=np.array([[0, 1, 2, 3], [2, 5, 4, 1]])).is_disk


def test_a_reversed_seam_is_caught():
    """Wrong attaching map: the last ray of a star reversed, or that of a band."""
    sectors, seams, rays = fan([2, 2, 2, 2, 2])
    wrong = Seam(first=3, path=rays[-1], second=0, onto=rays[0][::-1])
    with pytest.raises(ComplexError):
        glued(sectors, [*seams, wrong])
    assert ring(5).orientation is not None
    twisted = ring(5, reverse=True)
    assert twisted.orientation is None
    assert not twisted.is_disk


def test_swapped_families_are_caught():
    with pytest.raises(GluingError, match="edge 0 is a v-edge of piece 0 and not of piece 1"):
        glued(
            [rectangle(2, 2)] * 2,
            [Seam(first=0, path=side(2, 2, "u = n"), second=1, onto=side(2, 2, "v = 0"))],
        )
    swapped = star([2] * 6).faces.copy()
    swapped[0] = swapped[0][[0, 3, 2, 1]]
    with pytest.raises(LabelError):
        AsymptoticComplex(faces=swapped)


def seam(path, onto, second=1):
    return Seam(first=0, path=path, second=second, onto=onto)


BAD_SEAMS = {
    "lengths": ([seam([0, 3], [0, 3, 6])], "1 edges cannot be glued to 2"),
    "inside": ([seam([1, 4], [0, 3])], "inside"),
    "no edge": ([seam([0, 8], [0, 3])], r"no edge joins the vertices \(0, 8\)"),
    "no vertex": ([seam([0, 9], [0, 3])], "needs two vertices of the piece"),
    "one vertex": ([seam([0], [0])], "needs two vertices"),
    "no piece": ([seam([0, 3], [0, 3], second=2)], "there is no piece 2"),
    "twice": ([seam([0, 3], [0, 3]), seam([3, 0], [1, 2])], "not of piece 1"),
    "taken": ([seam([0, 3], [0, 3]), seam([3, 0], [2, 5])], "glued already"),
}


@pytest.mark.parametrize(("seams", "message"), BAD_SEAMS.values(), ids=BAD_SEAMS)
def test_a_seam_that_does_not_fit_is_refused(seams, message):
    with pytest.raises(GluingError, match=message):
        glued([rectangle(2, 2)] * 2, seams)


def test_a_star_needs_alternating_rays():
    with pytest.raises(GluingError, match="5 rays"):
        star([1] * 5)
    with pytest.raises(GluingError, match="2 rays"):
        star([1] * 2)
    with pytest.raises(GluingError, match="empty"):
        star([1, 0, 1, 1])


def test_surgery_refuses_what_it_cannot_do():
    complex_ = CORPUS["operated grid"]
    with pytest.raises(SurgeryError, match="vertex 0 is no corner"):
        attached(star([1] * 4), 0, [1, 1])
    with pytest.raises(SurgeryError, match="an even number is needed"):
        attached(rectangle(2, 2), 0, [1])
    corner = int(np.flatnonzero(complex_.is_corner)[0])
    with pytest.raises(SurgeryError, match="is on the boundary"):
        surgery(complex_, corner, face_at(complex_, corner), [1, 1])
    grid_ = rectangle(6, 6)
    with pytest.raises(SurgeryError, match="face 35 does not meet vertex 8"):
        surgery(grid_, 8, 35, [1, 1])


def test_a_quadrant_with_a_branch_point_in_it_is_refused():
    middle = int(grid(6, 6)[3, 3])
    before = rectangle(6, 6)
    after, _ = surgery(before, middle, face_at(before, middle), [3, 3])
    refused = 0
    for vertex in np.flatnonzero(after.saddle_order == 2):
        for face in np.flatnonzero((after.faces == vertex).any(axis=1)):
            try:
                surgery(after, int(vertex), int(face), [1, 1])
            except SurgeryError as error:
                refused += "branch point" in str(error)
    assert refused > 0
