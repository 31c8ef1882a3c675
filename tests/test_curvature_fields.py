"""Fields and energies of branched nets: sectors add up, two rules for areas, the continuum."""

import math
from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from bobbin_nets import bobbin_angle, bobbin_sector
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import dblquad, quad

from discrete.branched_net import BranchedNet, Placed, geodesic_ray, regular_star, star, surgery
from discrete.curvature_energy import energies, sector_energies
from discrete.curvature_fields import curvature_fields
from discrete.errors import AngleError
from theory import painleve_float

LEVELS = (16, 32, 64, 128)
SIDE = 0.7


def is_second_order(errors) -> bool:
    return all(abs(math.log2(a / b) - 2) < 0.1 for a, b in pairwise(errors))


def branched(order: int, edges: int, cuts: int) -> BranchedNet:
    """Star with surgery in its first sector, and in the middle daughter of each cut again."""
    net = regular_star(order, edge_length=SIDE / edges, edges=edges)
    number, size = 0, edges
    for _ in range(cuts):
        size = size // 2
        net = surgery(net, number, (size, size))
        number = len(net.placed) - 2
    return net


@settings(max_examples=25, deadline=None, derandomize=True)
@given(order=st.integers(2, 5), edges=st.integers(8, 24), cuts=st.integers(0, 3))
def test_sectors_add_up_to_the_whole(order, edges, cuts):
    net = branched(order, edges, cuts)
    whole, parts = energies(net), sector_energies(net)
    assert len(parts) == 2 * order + 3 * cuts
    for name in ("willmore", "area", "quadrature"):
        assert sum(getattr(part, name) for part in parts) == pytest.approx(getattr(whole, name))
    assert whole.min_angle == min(part.min_angle for part in parts)
    assert whole.max_angle == max(part.max_angle for part in parts)
    assert whole.max_curvature == max(part.max_curvature for part in parts)


@settings(max_examples=25, deadline=None, derandomize=True)
@given(order=st.integers(2, 5), edges=st.integers(8, 24), cuts=st.integers(0, 3))
def test_principal_curvatures_have_the_product_minus_one(order, edges, cuts):
    fields = curvature_fields(branched(order, edges, cuts))
    assert fields.first * fields.second == pytest.approx(-1)
    # Their sum is twice the mean curvature, -2 cot(phi).
    assert fields.first + fields.second == pytest.approx(-2 / np.tan(fields.angles), abs=1e-12)
    assert (fields.max_curvatures >= 1).all()


def test_sectors_of_the_fields_are_those_of_the_net():
    net = branched(2, 8, 1)
    fields = curvature_fields(net)
    assert np.bincount(fields.sectors).tolist() == [int(place.kept.sum()) for place in net.placed]
    first = net.placed[0].sector
    assert fields.angles[0] == pytest.approx(
        (first.angles[0, 0] + np.pi - first.other_angles[0, 0]) / 2
    )


@pytest.mark.parametrize("order", [2, 3, 6])
def test_both_areas_of_a_branched_net_agree_with_second_order(order):
    gaps = []
    for n in LEVELS:
        found = energies(branched(order, n, 2))
        gaps.append(abs(found.area - found.quadrature))
    assert is_second_order(gaps)


@pytest.mark.parametrize("order", [2, 3, 6])
def test_energies_of_amsler_stars_tend_to_painleve_three(order):
    corner = math.pi / order

    def phi(v: float, u: float) -> float:
        return painleve_float.angle(corner, 2 * math.sqrt(u * v))

    def density(v: float, u: float) -> float:
        return 4 / math.sin(phi(v, u)) - 2 * math.sin(phi(v, u))

    area = dblquad(lambda v, u: math.sin(phi(v, u)), 0, SIDE, 0, SIDE, epsabs=1e-9)[0]
    willmore = dblquad(density, 0, SIDE, 0, SIDE, epsabs=1e-8)[0]
    errors: dict[str, list[float]] = {"area": [], "quadrature": [], "willmore": []}
    for n in LEVELS:
        found = sector_energies(regular_star(order, edge_length=SIDE / n, edges=n))[0]
        errors["area"].append(abs(found.area - area))
        errors["quadrature"].append(abs(found.quadrature - area))
        errors["willmore"].append(abs(found.willmore - willmore))
    assert all(map(is_second_order, errors.values()))


def test_a_net_beyond_a_singular_edge_is_refused_with_its_face():
    ray = geodesic_ray(np.full(30, 0.1))
    with pytest.raises(AngleError, match=r"face \d+ of the net has the angle"):
        curvature_fields(star([ray] * 4, [math.pi / 2] * 4))


def test_energy_of_a_bobbin_sector_tends_to_elliptic_functions():
    """The angle of a bobbin depends on u + v alone: one integral over the triangle weights."""
    kappa, side = 1, Fraction(1, 2)
    length = float(side)

    def weight(t: float) -> float:
        return min(t, 2 * length - t)

    def integral(function) -> float:
        def weighted(t: float) -> float:
            return weight(t) * function(bobbin_angle(kappa, Fraction(t)))

        halves = ((0.0, length), (length, 2 * length))
        return sum(quad(weighted, *ends, epsabs=1e-9)[0] for ends in halves)

    area = integral(math.sin)
    willmore = integral(lambda phi: 4 / math.sin(phi) - 2 * math.sin(phi))
    gaps: list[tuple[float, float]] = []
    for n in LEVELS:
        placed = Placed(
            sector=bobbin_sector(kappa, side, n), side=1, parent=-1, apex=(0, 0), bearing=0.0
        )
        found = sector_energies(BranchedNet(placed=(placed,), seams=()))[0]
        gaps.append((abs(found.area - area), abs(found.willmore - willmore)))
    assert is_second_order([gap[0] for gap in gaps])
    assert is_second_order([gap[1] for gap in gaps])
