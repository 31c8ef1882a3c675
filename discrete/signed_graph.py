"""Signed graphs: signs of the nodes that agree or differ along each link as it says, if any."""

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order, connected_components

IntArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]


def linked(nodes: int, links: IntArray) -> coo_array:
    """Adjacency matrix of the graph with these links, an array (k, 2) of nodes."""
    ones = np.ones(len(links), dtype=np.int8)
    return coo_array((ones, (links[:, 0], links[:, 1])), shape=(nodes, nodes))


def components(nodes: int, links: IntArray) -> tuple[int, IntArray]:
    """Number of components of the graph and the component of each node."""
    count, labels = connected_components(linked(nodes, links), directed=False)
    return int(count), labels.astype(np.int64)


def _lifted(nodes: int, links: IntArray, differ: BoolArray) -> IntArray:
    """Component of each node of the double cover: node n is lifted to n and n + nodes."""
    one, other = links[:, 0], links[:, 1]
    same_sheet = np.stack([one, np.where(differ, other + nodes, other)], axis=1)
    next_sheet = np.stack([one + nodes, np.where(differ, other, other + nodes)], axis=1)
    return components(2 * nodes, np.concatenate([same_sheet, next_sheet]))[1]


def signs(nodes: int, links: IntArray, differ: BoolArray) -> IntArray | None:
    """Signs +1 or -1 of the nodes, which differ exactly along the links where differ says so.

    The first node of each component has +1. None where a cycle has an odd number of differences:
    the double cover of its component is then connected.
    """
    lift = _lifted(nodes, links, differ)
    if np.any(lift[:nodes] == lift[nodes:]):
        return None
    # Components are numbered as they are met, so the first node of each is on the lower sheet.
    return np.where(lift[:nodes] < lift[nodes:], 1, -1).astype(np.int64)


def _path_to_root(parents: IntArray, node: int) -> list[int]:
    path = [node]
    while parents[path[-1]] >= 0:
        path.append(int(parents[path[-1]]))
    return path


def odd_cycle(nodes: int, links: IntArray) -> list[int] | None:
    """Nodes of a cycle of odd length in cyclic order, or None if the graph is bipartite."""
    lift = _lifted(nodes, links, np.ones(len(links), dtype=np.bool_))
    bad = np.flatnonzero(lift[:nodes] == lift[nodes:])
    if not len(bad):
        return None
    order, parents = breadth_first_order(linked(nodes, links).tocsr(), int(bad[0]), directed=False)
    depth = np.full(nodes, -1, dtype=np.int64)
    depth[order[0]] = 0
    for node in order[1:]:
        depth[node] = depth[parents[node]] + 1
    inside = depth[links[:, 0]] >= 0
    even = (depth[links[:, 0]] - depth[links[:, 1]]) % 2 == 0
    one, other = (int(n) for n in links[np.flatnonzero(inside & even)[0]])
    first, second = _path_to_root(parents, one), _path_to_root(parents, other)
    while len(first) > 1 and len(second) > 1 and first[-2] == second[-2]:
        first.pop()
        second.pop()
    return first + second[-2::-1]
