"""The whole net of a run: one disk, its branch points, and a K-surface by two routes."""

from fractions import Fraction

import networkx
import numpy as np
import pytest

from discrete.branched_net import regular_star, surgery
from discrete.exact_angle import ExactAngle
from discrete.greedy import grown
from discrete.greedy_net import GreedyNet, greedy_net
from discrete.greedy_parameters import GreedyParameters
from discrete.greedy_tree import GreedyTree
from discrete.k_surface import k_surface
from discrete.planar_stars import star_surface

CASES = [
    (1, "1/10", 4, "3/4"),
    (3, "1/20", 4, "3/4"),
    (3, "1/20", 8, "4/5"),
    (4, "1/20", 12, "4/5"),
    (2, "1/10", 6, "1/2"),
]


def tree_of(radius: object, step: str, sectors: int, cutoff: str) -> GreedyTree:
    return grown(
        GreedyParameters(
            radius=Fraction(radius),
            step=Fraction(step),
            sectors=sectors,
            cutoff=ExactAngle(half_turns=Fraction(cutoff)),
        )
    )


@pytest.fixture(scope="module", params=CASES, ids=str)
def case(request: pytest.FixtureRequest) -> tuple[GreedyTree, GreedyNet]:
    tree = tree_of(*request.param)
    return tree, greedy_net(tree)


def edges_of(net: GreedyNet) -> tuple[np.ndarray, np.ndarray]:
    """Edges (E, 2), and the number of quads at each."""
    sides = np.concatenate([net.quads[:, [k, (k + 1) % 4]] for k in range(4)])
    return np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)


def inner(net: GreedyNet) -> np.ndarray:
    edges, count = edges_of(net)
    found = np.ones(len(net.disk), dtype=bool)
    found[edges[count == 1].ravel()] = False
    return found


def test_it_is_a_disk(case):
    _, net = case
    edges, count = edges_of(net)
    assert set(count) == {1, 2}
    assert len(net.disk) - len(edges) + len(net.quads) == 1
    assert (np.unique(net.quads) == np.arange(len(net.disk))).all()
    rim = networkx.Graph(edges[count == 1].tolist())
    assert networkx.is_connected(rim)
    assert set(dict(rim.degree).values()) == {2}


def test_it_has_the_quads_and_branch_points_of_the_tree(case):
    tree, net = case
    assert len(net.quads) == (tree.sectors["quads"] * tree.sectors["copies"]).sum()
    degree = np.bincount(edges_of(net)[0].ravel())
    branched = np.flatnonzero(inner(net) & (degree != 4))
    wanted = {round(p.rho, 8): 0 for p in tree.branch_points()}
    assert len(branched) == tree.branch_point_count
    rho = 2 * np.arctanh(np.abs(net.disk[branched]))
    wanted = [p.rho for p in tree.branch_points()]
    wanted += [0.0] * (tree.parameters.sectors > 4)
    assert np.sort(rho) == pytest.approx(np.sort(wanted), abs=1e-10)
    centre = branched[rho < 1e-9]
    assert (degree[centre] == tree.parameters.sectors).all()
    assert (degree[np.setdiff1d(branched, centre)] == 6).all()


def test_edges_have_one_length_on_the_plane_and_one_in_space(case):
    tree, net = case
    step = float(tree.parameters.step)
    first, second = edges_of(net)[0].T
    z, w = net.disk[first], net.disk[second]
    length = 2 * np.arctanh(np.abs((z - w) / (1 - z.conj() * w)))
    assert length == pytest.approx(step, abs=1e-9)
    vector = net.points[second] - net.points[first]
    assert np.linalg.norm(vector, axis=1) == pytest.approx(np.tanh(step), abs=1e-11)
    for end in (first, second):
        assert np.abs(np.einsum("ij,ij->i", vector, net.normals[end])).max() < 1e-11
    assert np.einsum("ij,ij->i", net.normals[first], net.normals[second]) == pytest.approx(
        1 / np.cosh(step), abs=1e-11
    )


def angles(vertices: np.ndarray, before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """Angles in space between the edges from vertices to two neighbours."""
    a, b = before - vertices, after - vertices
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.einsum("ij,ij->i", a, b))


def test_vertex_stars_are_planar_and_close(case):
    """Angles in space add up to 2 pi at inner vertices, branch points included."""
    _, net = case
    total = np.zeros(len(net.disk))
    corners = net.points[net.quads]
    for k in range(4):
        found = angles(corners[:, k], corners[:, k - 1], corners[:, (k + 1) % 4])
        np.add.at(total, net.quads[:, k], found)
    assert total[inner(net)] == pytest.approx(2 * np.pi, abs=1e-9)


def test_orientation_is_the_same_on_the_plane_and_in_space(case):
    _, net = case
    z, p = net.disk[net.quads], net.points[net.quads]
    left = np.imag((z[:, 2] - z[:, 0]).conj() * (z[:, 3] - z[:, 1]))
    faces = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    up = np.einsum("ij,ij->i", faces, net.normals[net.quads[:, 0]])
    assert (np.sign(left) == np.sign(up)).all()


def test_surface_is_that_of_planar_vertex_stars():
    """A run with one cut in each sector against surgery on a star, by another route in space."""
    tree = tree_of(2, "1/10", 4, "3/4")
    cuts = tree.sectors[tree.sectors["cut"]]
    assert len(cuts) == 1
    i, k = int(cuts["i_cut"][0]), int(cuts["k_cut"][0])
    net = greedy_net(tree)
    star = regular_star(2, edge_length=0.1, edges=26)
    for sector in range(4):
        star = surgery(star, sector, (i, k))
    other = k_surface(star, route=star_surface)
    # Both have the centre at the origin, the normal x3 and the first axis along x1.
    from scipy.spatial import cKDTree

    gap, _ = cKDTree(other.points).query(net.points)
    assert gap.max() < 1e-10


def test_fields_at_the_vertices(case):
    tree, net = case
    angle, curvature = net.vertex_angles, net.vertex_curvatures
    assert tree.min_angle / 2 < angle.min() < angle.max() < np.pi
    assert curvature.min() >= 1
    generation = net.first_quad(net.quad_generations)
    assert generation.min() == 0
    assert generation.max() == net.quad_generations.max()
    assert len(np.unique(net.quad_sectors)) <= tree.sector_count


def test_energy_of_the_sweep_is_between_those_of_whole_quads():
    """Of the quads inside the disk, and of all that meet it; angles and areas measured in space."""
    tree = tree_of(3, "1/40", 4, "3/4")
    net = greedy_net(tree)
    corners = net.points[net.quads]
    a = angles(corners[:, 0], corners[:, 1], corners[:, 3])
    b = angles(corners[:, 1], corners[:, 2], corners[:, 0])
    area = 2 * (np.pi - a - b)
    half = (a + np.pi - b) / 4
    energy = area * (np.tan(half) ** 2 + np.tan(half) ** -2)
    inside = (2 * np.arctanh(np.abs(net.disk[net.quads])) <= 3).all(axis=1)
    for values, found in ((area, tree.area), (energy, tree.willmore)):
        assert values[inside].sum() < found < values.sum()
        assert values.sum() < 1.1 * values[inside].sum()
    assert half == pytest.approx(net.quad_angles / 2, abs=1e-9)
