"""Frames and contours of branched nets, and the bounds of the distance to the singular edge."""

import math

import numpy as np
import pytest
import sympy as sp

from checks.evidence import Setting
from checks.verify import amsler_balls as disks
from checks.verify import disk_surgery, reversals
from discrete.branched_net import BranchedNet, regular_star, surgery
from discrete.errors import DiscreteError
from discrete.net_contours import contour_meets_circle, middle_angles, middle_distances, value_at
from discrete.net_frames import net_frames
from discrete.placed_frames import placed_distances, placed_frames
from discrete.sl2_frames import triple_of
from theory import amsler_balls, amsler_disk


def cut_star() -> BranchedNet:
    return surgery(regular_star(2, edge_length=0.1, edges=8), 1, (3, 3))


def test_frames_of_a_sector_are_those_walked_edge_by_edge():
    net = regular_star(3, edge_length=0.2, edges=5)
    walked = np.array(net_frames(net.placed[0].sector.net, math))
    assert np.abs(np.moveaxis(placed_frames(net)[0], 0, 2) - walked).max() < 1e-13


def test_sectors_fit_along_their_seams_also_after_surgery():
    net = cut_star()
    places = [np.array(triple_of(tuple(g))) for g in placed_frames(net)]
    for seam in net.seams:
        for one, other in zip(seam.path, seam.onto, strict=True):
            gap = places[seam.first][:, *one] - places[seam.second][:, *other]
            assert np.abs(gap).max() < 1e-12


def test_rays_of_a_star_are_geodesics_from_the_centre():
    distances = placed_distances(regular_star(2, edge_length=0.3, edges=4))
    for found in distances:
        assert found[:, 0] == pytest.approx(0.3 * np.arange(5), abs=1e-13)


def contour(step: float, level: float, radius: float) -> float:
    net = regular_star(2, edge_length=step, edges=math.ceil(3.6 / step))
    (distances,) = placed_distances(BranchedNet(placed=net.placed[:1], seams=()))
    angles, middles = middle_angles(net.placed[0].sector), middle_distances(distances)
    return contour_meets_circle(angles, middles, step=step, level=level, radius=radius)


def test_contour_meets_circle_where_the_continuum_says():
    level, radius = 3 * math.pi / 4, 3.0
    u = contour(0.01, level, radius)
    # The contour is u v = c; the v-line through (u, 0) leaves the disk there.
    c = 0.8140509067
    assert u * amsler_disk.rim(math.pi / 2, u, radius) == pytest.approx(c, abs=1e-4)


def test_a_contour_outside_the_circle_is_refused():
    with pytest.raises(DiscreteError, match="does not cross"):
        contour(0.05, 3 * math.pi / 4, 0.3)


def test_value_at_is_exact_on_vertices():
    grid = np.add.outer(np.arange(20.0) ** 2, np.arange(20.0))
    assert value_at(grid, step=0.5, u=3.5, v=2.0) == pytest.approx(49 + 4)


def test_net_in_the_disk_agrees_with_the_frames():
    net = regular_star(2, edge_length=0.1, edges=10)
    radii = disk_surgery.disk_radii(disk_surgery.amsler_disk_net(0.1, 10))
    assert np.abs(radii - placed_distances(net)[0]).max() < 1e-12


def test_bounds_of_the_distance_are_attained_on_the_mirror_line():
    mirror = {amsler_balls.DV: amsler_balls.DU}
    assert sp.simplify(amsler_balls.length_excess().subs(mirror)) == 0
    assert amsler_balls.sum_excess().subs(amsler_balls.ROOT_V, amsler_balls.ROOT_U) == 0


def test_the_largest_disk_lies_between_the_two_printed_radii():
    radius = disks.edge_radius()
    assert radius.is_finite()
    assert radius.rad() < 1e-15
    assert radius > 1
    assert radius < 1.5


def test_a_fold_along_a_line_has_no_reversal_and_an_unfolded_net_is_told_apart():
    assert reversals.folded_along_line(Setting()).outcome == "pass"
    assert reversals.folded_along_line(Setting(), left="below").outcome == "fail"
    assert reversals.folded_along_line(Setting(), form="unequal").outcome == "fail"
