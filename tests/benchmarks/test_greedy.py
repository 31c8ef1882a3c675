"""Greedy algorithm: seconds on warm kernels, and the cost per area as the disk grows.

Run by `make bench`; the machine is named in the report of pytest-benchmark, and nothing is decided.
"""

from concurrent.futures import Executor, ThreadPoolExecutor
from fractions import Fraction

import pytest

from discrete.exact_angle import ExactAngle
from discrete.greedy import grown
from discrete.greedy_parameters import GreedyParameters


def parameters(radius: int, step: str) -> GreedyParameters:
    """Four initial sectors, cutoff 3 pi/4."""
    return GreedyParameters(
        radius=Fraction(radius),
        step=Fraction(step),
        sectors=4,
        cutoff=ExactAngle(half_turns=Fraction(3, 4)),
    )


@pytest.fixture(scope="module")
def executor():
    """Two threads, with kernels that are warm."""
    grown(parameters(2, "0.05"))
    with ThreadPoolExecutor(2) as threads:
        yield threads


@pytest.mark.benchmark(group="greedy algorithm, two threads")
@pytest.mark.parametrize(
    ("radius", "step", "rounds"), [(4, "0.02", 9), (6, "0.02", 9), (8, "0.02", 5), (10, "0.02", 3)]
)
def test_disk(benchmark, executor: Executor, radius: int, step: str, rounds: int):
    run = parameters(radius, step)
    tree = benchmark.pedantic(
        grown, args=(run,), kwargs={"executor": executor}, rounds=rounds, warmup_rounds=1
    )
    kept = int((tree.sectors["quads"] * tree.sectors["copies"]).sum())
    benchmark.extra_info.update(
        sectors=tree.sector_count, branch_points=tree.branch_point_count, quads=kept
    )
    assert tree.area == pytest.approx(run.area, rel=1e-12)


@pytest.mark.benchmark(group="greedy algorithm, two threads")
def test_largest_disk(benchmark, executor: Executor):
    """Radius 14, edges of length 0.04: more than a million branch points."""
    run = parameters(14, "0.04")
    tree = benchmark.pedantic(
        grown, args=(run,), kwargs={"executor": executor, "max_cuts": 2 * 10**6}, rounds=1
    )
    benchmark.extra_info.update(branch_points=tree.branch_point_count)
    assert tree.terminated
