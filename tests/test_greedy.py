"""The greedy algorithm covers the disk, and finds the same cuts as a plain fill of a sector."""

import math
import re
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from discrete.errors import AngleError, EdgeLengthError, ShapeError
from discrete.exact_angle import ExactAngle
from discrete.greedy import grown
from discrete.greedy_parameters import GreedyParameters
from discrete.sector import amsler_sector


def parameters(
    radius: object = 3, step: object = "0.02", sectors: int = 4, cutoff: object = "3/4"
) -> GreedyParameters:
    """Parameters with a cutoff in half turns."""
    return GreedyParameters(
        radius=Fraction(radius),
        step=Fraction(step),
        sectors=sectors,
        cutoff=ExactAngle(half_turns=Fraction(cutoff)),
    )


SETS = [(4, "3/4"), (8, "4/5"), (12, "4/5"), (4, "9/10"), (6, "1/2")]


@pytest.mark.parametrize(("sectors", "cutoff"), SETS)
@pytest.mark.parametrize("radius", [1, "5/2", 5])
def test_kept_quads_tile_the_disk(radius: object, sectors: int, cutoff: str) -> None:
    given = parameters(radius, "0.03", sectors, cutoff)
    tree = grown(given)
    assert tree.terminated
    assert tree.area == pytest.approx(given.area, rel=1e-12)


@given(
    radius=st.fractions(Fraction(1, 2), 5, max_denominator=50),
    step=st.fractions(Fraction(1, 50), Fraction(3, 10), max_denominator=500),
    sectors=st.sampled_from([4, 6, 8, 10, 16, 40]),
    share=st.fractions(Fraction(1, 100), Fraction(49, 50), max_denominator=100),
)
@settings(max_examples=300, deadline=None, derandomize=True)
def test_any_disk_is_tiled(radius: Fraction, step: Fraction, sectors: int, share: Fraction) -> None:
    phi0 = Fraction(2, sectors)
    run = parameters(radius, step, sectors, phi0 + share * (1 - phi0))
    tree = grown(run, max_cuts=10**5)
    assert tree.terminated
    assert tree.area == pytest.approx(run.area, rel=1e-11)
    assert tree.max_angle <= float(run.cutoff)


def test_first_cut_is_that_of_a_plain_fill() -> None:
    run = parameters(3, "0.05")
    count = 61 + 20
    sector = amsler_sector([0.05] * count, [0.05] * count, math.pi / 2)
    heights = np.empty((count + 1, count + 1))
    axis = np.cosh(0.05 * np.arange(count + 1))
    heights[0], heights[:, 0] = axis, axis
    for i in range(count):
        for j in range(count):
            cosine = math.cos(sector.angles[i, j])
            diagonal = math.cosh(0.05) ** 2 - math.sinh(0.05) ** 2 * cosine
            k = 2 * math.cosh(0.05) / (1 + diagonal)
            heights[i + 1, j + 1] = k * (heights[i + 1, j] + heights[i, j + 1]) - heights[i, j]
    bad = (heights[:-1, :-1] <= math.cosh(3)) & (sector.angles > 3 * math.pi / 4)
    rows, columns = np.flatnonzero(bad.any(axis=0)), np.flatnonzero(bad.any(axis=1))
    first = grown(run).sectors[0]
    assert (first["i_cut"], first["k_cut"]) == (columns[0] - 1, rows[0] - 1)
    assert first["cut_angle"] == pytest.approx(sector.angles[columns[0] - 1, rows[0] - 1])


def test_margin_of_the_ring_does_not_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    run = parameters(5, "0.05", 8, "4/5")
    narrow = grown(run)
    monkeypatch.setattr("discrete.greedy.MARGIN", 1.2)
    wide = grown(run)
    assert wide.margin > narrow.margin
    for name in ("parent", "i_cut", "k_cut", "quads"):
        assert (wide.sectors[name] == narrow.sectors[name]).all()


def test_narrow_ring_is_widened(monkeypatch: pytest.MonkeyPatch) -> None:
    run = parameters(4, "0.05")
    usual = grown(run)
    monkeypatch.setattr("discrete.greedy.MARGIN", 0.01)
    assert grown(run).margin > 0.01
    assert (grown(run).sectors["i_cut"] == usual.sectors["i_cut"]).all()


def test_executor_gives_the_same_tree() -> None:
    run = parameters(5, "0.02")
    alone = grown(run)
    with ThreadPoolExecutor(2) as executor:
        shared = grown(run, executor=executor)
    assert alone.sectors.tobytes() == shared.sectors.tobytes()
    assert len(alone.sectors) > 40


def test_limit_of_cuts_leaves_a_partial_tree() -> None:
    run = parameters(6, "0.05")
    whole = grown(run)
    for limit in (3, 4, 50, 300):
        partial = grown(run, max_cuts=limit)
        cuts = partial.sectors["copies"][partial.sectors["cut"]].sum()
        assert not partial.terminated
        assert limit < cuts <= limit + 8
        assert partial.area < whole.area
    assert grown(run, max_cuts=whole.branch_point_count).terminated


def test_branch_points_are_symmetric() -> None:
    tree = grown(parameters(4, "0.02", 6, "4/5"))
    points = list(tree.branch_points())
    assert len(points) + 1 == tree.branch_point_count
    assert len({point.path for point in points}) == len(points)
    where = np.array([point.rho * np.exp(1j * point.theta) for point in points])
    for image in (where * np.exp(1j * math.pi / 3), where.conj()):
        assert abs(image[:, None] - where).min(axis=1).max() < 1e-12
    parents = {point.path: point for point in points}
    for point in points:
        if point.generation > 1:
            assert parents[point.parent].generation == point.generation - 1
            assert point.rho > parents[point.parent].rho


def test_cut_on_a_side_is_counted() -> None:
    tree = grown(parameters(6, "1/2"))
    assert tree.unresolved_cuts > 0
    assert tree.area == pytest.approx(tree.parameters.area, rel=1e-12)


@pytest.mark.parametrize(
    ("changed", "error", "says"),
    [
        ({"radius": 0}, EdgeLengthError, "radius is 0: expected more than 0"),
        ({"radius": 301}, EdgeLengthError, "at most 300"),
        ({"radius": 3.0}, EdgeLengthError, "radius = 3.0: give an integer or a Fraction"),
        ({"step": Fraction(0)}, EdgeLengthError, "step is 0"),
        ({"radius": Fraction(1, 4), "step": Fraction(1, 3)}, EdgeLengthError, "at most the radius"),
        ({"step": Fraction(3, 5)}, EdgeLengthError, "at most 1/2"),
        ({"sectors": 2}, ShapeError, "even number of 4 or more"),
        ({"sectors": 5}, ShapeError, "5 initial sectors"),
        ({"sectors": 4.0}, ShapeError, "even integer"),
        ({"cutoff": ExactAngle(half_turns=Fraction(1, 2))}, AngleError, "between phi0 = pi/2"),
        ({"cutoff": ExactAngle(half_turns=Fraction(1))}, AngleError, "and pi"),
        ({"cutoff": ExactAngle(radians=Fraction(22, 7))}, AngleError, "22/7"),
    ],
)
def test_bad_parameters_are_refused(changed: dict, error: type[Exception], says: str) -> None:
    usual = {
        "radius": Fraction(3),
        "step": Fraction(1, 50),
        "sectors": 4,
        "cutoff": ExactAngle(half_turns=Fraction(3, 4)),
    }
    with pytest.raises(error, match=re.escape(says)):
        GreedyParameters(**{**usual, **changed})


@pytest.mark.parametrize("limit", [0, -1, True, 1.5])
def test_bad_limit_is_refused(limit: object) -> None:
    with pytest.raises(ShapeError, match="max_cuts"):
        grown(parameters(1), max_cuts=limit)


@given(st.fractions(max_denominator=1000), st.fractions(max_denominator=1000))
def test_sign_of_an_exact_angle(radians: Fraction, half_turns: Fraction) -> None:
    angle = ExactAngle(radians=radians, half_turns=half_turns)
    value = float(radians) + float(half_turns) * math.pi
    assert angle.sign() == np.sign(value) if abs(value) > 1e-9 else True
    assert (angle - angle).sign() == 0


def test_sign_beyond_the_digits_of_float64() -> None:
    close = ExactAngle(radians=Fraction("-3.14159265358979323846264338327950288"), half_turns=1)
    assert close.sign() == 1
    assert (ExactAngle() - close).sign() == -1
    assert str(ExactAngle(half_turns=Fraction(-3, 4), radians=Fraction(1, 2))) == "1/2 + -3*pi/4"
