"""A K-surface of a million vertices from a branched net, warm.

Run by `make bench`; the machine is named in the report of pytest-benchmark, and nothing is decided.
"""

import pytest

from discrete.branched_net import regular_star, surgery
from discrete.k_surface import k_surface


@pytest.fixture(scope="module")
def net():
    """Star of six sectors with one branch point put in, its complex already glued."""
    found = surgery(regular_star(3, edge_length=0.002, edges=410), 0, (200, 200))
    assert found.complex.vertex_count > 10**6
    return found


@pytest.mark.benchmark(group="K-surface of a million vertices")
def test_million_vertices(benchmark, net):
    surface = benchmark.pedantic(k_surface, args=(net,), rounds=5, warmup_rounds=1)
    benchmark.extra_info["vertices"] = net.complex.vertex_count
    assert surface.mismatch < 1e-9
