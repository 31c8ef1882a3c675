"""The limit of edge length 0: two resolutions agree, and the nets converge to it."""

import math
from fractions import Fraction

import numpy as np
import pytest

from discrete.exact_angle import ExactAngle
from discrete.greedy import grown
from discrete.greedy_parameters import GreedyParameters
from theory.errors import DomainError
from theory.greedy_limit import limit_tree
from theory.sector_side import Side, chebyshev_nodes, integration

SETS = [(3, 4, Fraction(3, 4)), (3, 8, Fraction(4, 5)), (Fraction(7, 2), 4, Fraction(3, 4))]


def net_tree(radius: Fraction, step: Fraction, sectors: int, cutoff: Fraction):
    return grown(
        GreedyParameters(
            radius=Fraction(radius),
            step=step,
            sectors=sectors,
            cutoff=ExactAngle(half_turns=cutoff),
        )
    )


def test_integration_matrix_is_exact_on_polynomials():
    nodes = chebyshev_nodes(12, 1.0)
    for degree in range(11):
        found = integration(12) @ nodes**degree
        assert found == pytest.approx(nodes ** (degree + 1) / (degree + 1), abs=1e-14)


def test_side_beyond_a_point_is_the_same_curve():
    s = chebyshev_nodes(24, 2.0)
    side = Side(length=2.0, values=np.stack([np.sin(s), np.cosh(s), np.sinh(s), 0 * s], axis=1))
    rest = side.beyond(0.7, 0.25)
    at = np.linspace(0, 1.3, 7)
    assert rest.at(at)[:, 0] == pytest.approx(np.sin(0.7 + at) - 0.25, abs=1e-13)
    assert rest.rate(at)[:, 1] == pytest.approx(np.sinh(0.7 + at), abs=1e-11)


@pytest.mark.parametrize(("radius", "sectors", "cutoff"), SETS)
def test_two_resolutions_agree(radius: Fraction, sectors: int, cutoff: Fraction):
    arguments = (float(radius), 2 * math.pi / sectors, float(cutoff) * math.pi)
    coarse, fine = (limit_tree(*arguments, nodes=n, margin=m) for n, m in ((36, 0.8), (52, 1.1)))
    assert [cut.path for cut in coarse.cuts] == [cut.path for cut in fine.cuts]
    for first, second in zip(coarse.cuts, fine.cuts, strict=True):
        for name in ("u", "v", "angle", "rho", "theta"):
            assert getattr(first, name) == pytest.approx(getattr(second, name), abs=1e-9)


@pytest.mark.parametrize(("radius", "sectors", "cutoff"), SETS)
def test_nets_have_the_cuts_of_the_limit(radius: Fraction, sectors: int, cutoff: Fraction):
    limit = limit_tree(float(radius), 2 * math.pi / sectors, float(cutoff) * math.pi, nodes=40)
    tree = net_tree(radius, Fraction(1, 200), sectors, cutoff)
    cut = tree.sectors["cut"]
    paths = [path for path, kept in zip(tree.paths, cut, strict=True) if kept]
    assert sorted(paths) == sorted(found.path for found in limit.cuts)


def test_first_cut_is_snapped_to_the_grid():
    """It lies before that of the limit: by a step at most, and half for the angle's first order."""
    limit = limit_tree(3.0, math.pi / 2, 0.75 * math.pi).cuts[0]
    steps = [Fraction(1, 50 * 2**k) for k in range(6)]
    errors = []
    for step in steps:
        first = net_tree(Fraction(3), step, 4, Fraction(3, 4)).sectors[0]
        errors.append(limit.u - first["i_cut"] * float(step))
    assert all(-1e-12 < error < 1.5 * float(h) for error, h in zip(errors, steps, strict=True))


def test_shape_of_the_net_converges_with_order_two_at_the_limit_cut():
    """Where the cut is a vertex of every grid: the mean of the angles before and behind it."""
    from discrete.sector import amsler_sector

    cut = limit_tree(3.0, math.pi / 2, 0.75 * math.pi).cuts[0]
    u, wanted = cut.u, cut.angle
    errors = []
    for n in (8, 16, 32, 64):
        lengths = [u / n] * (n + 1)
        angles = amsler_sector(lengths, lengths, math.pi / 2).angles
        errors.append(abs((angles[n, n] + angles[n - 1, n - 1]) / 2 - wanted))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders == pytest.approx(2, abs=0.1)


@pytest.mark.parametrize(
    "arguments", [(0, 1, 2), (3, 0, 2), (3, 2, 1), (3, 1, 4), (math.nan, 1, 2)]
)
def test_bad_input_is_refused(arguments: tuple[float, ...]):
    with pytest.raises(DomainError, match="expected a positive radius"):
        limit_tree(*arguments)
