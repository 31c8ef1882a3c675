"""Nets tend to the continuum as their edges shrink: observed orders within 0.1 on four levels."""

import math
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from bobbin_nets import bobbin_angle, bobbin_sector

from discrete.branched_net import regular_star, surgery
from discrete.curvature_energy import energies
from discrete.k_surface import k_surface
from discrete.net_frames import relative_frame
from discrete.sector import Sector, amsler_sector
from discrete.sl2_frames import distance_from_start
from theory import painleve_float

LEVELS = (20, 40, 80, 160)
LENGTH = 1.2


def order(errors):
    """Orders observed between neighbouring levels, each of which halves the edges."""
    return [math.log2(a / b) for a, b in pairwise(errors)]


def is_second_order(errors) -> bool:
    return all(abs(found - 2) < 0.1 for found in order(errors))


def sector(order_of_star: int, n: int) -> Sector:
    lengths = np.full(n, LENGTH / n)
    return amsler_sector(lengths, lengths, math.pi / order_of_star)


def middle_angles(found: Sector):
    return (found.angles + np.pi - found.other_angles) / 2


@pytest.mark.parametrize("m", [2, 3, 6])
def test_angles_of_amsler_stars_tend_to_painleve_three(m):
    errors = []
    for n in LEVELS:
        h = LENGTH / n
        i, j = 3 * n // 4 - 1, n // 2 - 1
        z = 2 * math.sqrt((i + 0.5) * (j + 0.5)) * h
        exact = painleve_float.angle(math.pi / m, z)
        errors.append(abs(middle_angles(sector(m, n))[i, j] - exact))
    assert is_second_order(errors)


@pytest.mark.parametrize("m", [2, 3, 6])
def test_distances_on_the_mirror_line_tend_to_the_continuum(m):
    errors = []
    for n in LEVELS:
        k = n // 2
        frame = relative_frame(sector(m, n).net, math, (0, 0), (k, k))
        exact = painleve_float.diagonal(math.pi / m, 2 * k * LENGTH / n)
        errors.append(abs(distance_from_start(math, frame) - exact))
    assert is_second_order(errors)


@pytest.mark.parametrize("m", [2, 3, 6])
def test_areas_tend_to_the_integral_of_the_sine(m):
    # The integral of sin phi over a square is phi(far) - phi(u-side) - phi(v-side) + phi(apex).
    side = LENGTH / 2
    exact = painleve_float.angle(math.pi / m, 2 * side) - math.pi / m
    errors = []
    for n in LEVELS:
        k = n // 2
        area = 2 * np.asarray(sector(m, n).net.half_defects)[:k, :k].sum()
        errors.append(abs(area - exact))
    assert is_second_order(errors)


def test_the_curvature_of_a_sector_tends_to_that_of_its_far_corner():
    errors = []
    for n in (40, 80, 160, 320):
        phi = middle_angles(sector(2, n))
        k = n // 2 - 1
        z = (2 * k + 1) * LENGTH / n
        exact = math.tan(painleve_float.angle(math.pi / 2, z) / 2)
        errors.append(abs(math.tan(phi[k, k] / 2) - exact))
    assert is_second_order(errors)


@pytest.mark.parametrize("kappa", [1, 3])
def test_angles_of_bobbins_tend_to_elliptic_functions(kappa):
    side, errors = Fraction(1, 2), []
    for n in LEVELS:
        i = 3 * n // 4 - 1
        exact = bobbin_angle(kappa, (2 * i + 1) * side / n)
        errors.append(abs(middle_angles(bobbin_sector(kappa, side, n))[i, i] - exact))
    assert is_second_order(errors)


def test_the_angle_that_surgery_cuts_out_tends_to_phi_with_the_first_order():
    # One corner angle of a net: phi at the middle of its quad, half an edge beyond the vertex.
    errors = []
    for n in LEVELS:
        k = n // 2
        exact = painleve_float.angle(math.pi / 2, LENGTH)
        errors.append(abs(sector(2, n).angles[k, k] - exact))
    assert all(abs(found - 1) < 0.1 for found in order(errors))


def test_both_neighbours_together_give_that_angle_with_the_second_order():
    errors = []
    for n in LEVELS:
        k = n // 2
        angles = sector(2, n).angles
        exact = painleve_float.angle(math.pi / 2, LENGTH)
        errors.append(abs((angles[k, k] + angles[k - 1, k - 1]) / 2 - exact))
    assert is_second_order(errors)


def test_after_surgery_area_and_willmore_energy_have_expansions_in_the_edge_length():
    # The angle cut out is off by the first order, so both begin with it: one extrapolation takes
    # it away and leaves the second order.
    found = []
    for n in (24, 48, 96, 192, 384, 768):
        net = regular_star(2, edge_length=0.9 / n, edges=n)
        found.append(energies(surgery(net, 0, (n // 2, n // 2))))
    for name in ("area", "willmore"):
        values = np.array([getattr(energy, name) for energy in found])
        extrapolated = 2 * values[1:] - values[:-1]
        assert is_second_order(np.abs(np.diff(extrapolated)).tolist())


def steps_between(places):
    """Distances in space from each level to the next; places: arrays (points, 3), by level."""
    return np.linalg.norm(np.diff(places, axis=0), axis=2).T


@pytest.mark.parametrize("m", [2, 3, 6])
def test_points_in_space_of_amsler_stars_converge_with_the_second_order(m):
    places = []
    for n in (*LEVELS, 2 * LEVELS[-1]):
        net = regular_star(m, edge_length=1 / n, edges=n)
        here = [net.places[number][3 * n // 4, n // 2] for number in (0, 1)]
        places.append(k_surface(net).points[here])
    for errors in steps_between(places):
        assert len(errors) == 4
        assert is_second_order(errors)


def test_points_in_space_after_surgery_have_expansions_in_the_edge_length():
    # The daughters turn with the angle cut out, so with the first order, as the energies do.
    places = []
    for n in (12, 24, 48, 96, 192, 384):
        net = surgery(regular_star(2, edge_length=0.9 / n, edges=n), 0, (n // 2, n // 2))
        daughters = net.places[-3:]
        places.append(k_surface(net).points[[place[n // 4, n // 3] for place in daughters]])
    levels = np.array(places)
    for errors in steps_between(2 * levels[1:] - levels[:-1]):
        assert len(errors) == 4
        assert is_second_order(errors)
