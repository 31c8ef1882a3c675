"""Hyperbolic Goursat fill of 2000 x 2000 nodes, one thread: ours beside two others, interleaved.

Run by `make bench`; prints the medians of 20 runs with machine, versions and memory triad. Nothing
here depends on a time.
"""

import math
import platform
import statistics
import sys
from pathlib import Path
from time import perf_counter

import numba
import numpy as np
import pytest
from goursat_rivals import by_antidiagonals, row_loop

from discrete.geodesics import polar
from discrete.goursat_kernel import fill_nodes
from discrete.space_forms import H2, S2

NODES = 2000
RUNS = 20
EXTENT = 1.5  # side of the rectangle; on S^2 the net still has no antipodal neighbours


def sides(space):
    """Array with the two geodesic sides of a rectangle set, at a right angle."""
    nodes = np.zeros((3, NODES, NODES))
    for k in range(NODES):
        length = EXTENT * k / (NODES - 1)
        nodes[:, k, 0] = polar(space, math, 0.0, length)
        nodes[:, 0, k] = polar(space, math, math.pi / 2, length)
    return nodes


def ways(space):
    """The ways to fill, by name; each fills an array in place."""
    return {
        "skewed strips (ours)": lambda nodes: fill_nodes(space, nodes),
        "row loop, compiled": row_loop(space),
        "NumPy anti-diagonals": lambda nodes: by_antidiagonals(space, nodes),
    }


def triad():
    """Memory bandwidth of numba's a = b + s c on arrays of 96 MB each, GB/s, one thread."""

    @numba.njit
    def run(a, b, c):
        for i in range(a.size):
            a[i] = b[i] + 3.0 * c[i]

    a, b, c = (np.ones(12_000_000) for _ in range(3))
    times = []
    for _ in range(8):
        start = perf_counter()
        run(a, b, c)
        times.append(perf_counter() - start)
    return 3 * a.nbytes / statistics.median(times[1:]) / 1e9


def processor():
    """Name of the processor, where the system tells it."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text(encoding="utf-8").splitlines() if info.exists() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def medians(space):
    """Medians in seconds over interleaved runs, and the filled arrays, by way."""
    fills = ways(space)
    arrays = {name: sides(space) for name in fills}
    times = {name: [] for name in fills}
    for run in range(RUNS + 1):
        for name, fill in fills.items():
            start = perf_counter()
            fill(arrays[name])
            if run > 0:  # the first one compiles
                times[name].append(perf_counter() - start)
    return {name: statistics.median(found) for name, found in times.items()}, arrays


@pytest.mark.benchmark(group="Goursat fill")
@pytest.mark.parametrize("space", [H2, S2], ids=lambda s: s.name)
def test_goursat_fill(benchmark, capsys, space):
    found, arrays = medians(space)
    ours, *others = arrays.values()
    for other in others:
        assert np.array_equal(ours, other)
    benchmark.extra_info.update(found)
    benchmark.pedantic(fill_nodes, args=(space, ours), rounds=3)
    best = next(iter(found.values()))
    with capsys.disabled():
        sys.stdout.write(
            f"\n{space.name}, {NODES} x {NODES} nodes, medians of {RUNS} interleaved runs; "
            f"{processor()}, triad {triad():.1f} GB/s; Python {platform.python_version()}, "
            f"numpy {np.__version__}, numba {numba.__version__}\n"
        )
        for name, seconds in found.items():
            rate = 1e9 * seconds / NODES**2
            sys.stdout.write(
                f"{name:22} {1e3 * seconds:8.1f} ms {rate:7.2f} ns/node {seconds / best:6.2f} x\n"
            )
