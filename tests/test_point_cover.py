"""Random points lie in exactly one kept quad; a cover with a fault is found out."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from discrete.exact_angle import ExactAngle
from discrete.greedy import grown
from discrete.greedy_parameters import GreedyParameters
from discrete.greedy_tree import GreedyTree
from discrete.greedy_walk import walked
from discrete.point_cover import contained, point_cover, random_points
from discrete.sector_quads import disk_points, sector_quads


def tree_of(radius: object, step: str, sectors: int, cutoff: str) -> GreedyTree:
    return grown(
        GreedyParameters(
            radius=Fraction(radius),
            step=Fraction(step),
            sectors=sectors,
            cutoff=ExactAngle(half_turns=Fraction(cutoff)),
        )
    )


SETS = [(3, "0.04", 4, "3/4"), (4, "0.04", 8, "4/5"), (4, "0.05", 12, "4/5"), (2, "0.1", 6, "1/2")]


@pytest.mark.parametrize("case", SETS)
def test_every_point_lies_in_one_quad(case: tuple):
    cover = point_cover(tree_of(*case), 20_000, seed=1)
    assert cover.points == 20_000
    assert (cover.uncovered, cover.twice) == (0, 0)


@pytest.mark.parametrize("case", SETS)
def test_fill_by_positions_keeps_the_quads_of_the_sweep(case: tuple):
    tree = tree_of(*case)
    for path, sector, found in walked(tree):
        quads = sector_quads(tree.parameters, sector, found)
        assert (path, quads.kept.sum()) == (path, found.quads)


def test_walk_visits_the_sectors_of_the_tree():
    tree = tree_of(5, "0.05", 4, "3/4")
    assert sorted(path for path, _, _ in walked(tree)) == sorted(tree.paths)


def test_sides_lie_where_the_heights_say():
    tree = tree_of(4, "0.04", 4, "3/4")
    for _, sector, found in walked(tree):
        heights = sector_quads(tree.parameters, sector, found).heights
        assert heights[:, 0] == pytest.approx(sector.first_heights, rel=1e-11)
        assert heights[0] == pytest.approx(sector.second_heights, rel=1e-11)


def test_points_are_uniform_by_area():
    tree = tree_of(2, "0.1", 4, "3/4")
    z = random_points(tree, 40_000, seed=3)
    rho = 2 * np.arctanh(np.abs(z))
    for inner in (0.5, 1.0, 1.7):
        share = (np.cosh(inner) - 1) / (np.cosh(2) - 1)
        assert (rho < inner).mean() == pytest.approx(share, abs=0.01)
    assert (np.angle(z) < np.pi / 6).mean() == pytest.approx(1 / 3, abs=0.01)


def test_sector_left_out_is_found_out():
    tree = tree_of(3, "0.04", 4, "3/4")
    leaf = ~np.isin(np.arange(len(tree.sectors)), tree.sectors["parent"])
    share = (tree.sectors["area"] * tree.sectors["copies"])[leaf] / tree.parameters.area
    k = int(np.flatnonzero(leaf)[np.argmax(share)])
    maimed = replace(tree, sectors=np.delete(tree.sectors, k))
    cover = point_cover(maimed, 20_000, seed=1)
    assert cover.uncovered / cover.points == pytest.approx(share.max(), abs=0.01)
    assert cover.twice == 0


def test_quad_moved_is_found_out():
    tree = tree_of(2, "0.1", 4, "3/4")
    corners = np.concatenate(
        [
            disk_points(s.place, sector_quads(tree.parameters, s, found).corners())
            for _, s, found in walked(tree)
            if s.mirrored
        ]
    )
    points = random_points(tree, 20_000, seed=2)
    held = contained(points, corners)
    doubled = contained(points, np.concatenate([corners, corners[50:51]]))
    assert held.max() == 1
    assert doubled.max() == 2
    assert (contained(points, np.delete(corners, 50, axis=0)) < held).any()
