"""The index of a branch point is robust: against disturbances, other data, and in the limit."""

from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.positivity import positivity
from checks.verify import branched_limits
from checks.verify import geometric_nets as nets
from checks.verify.asymptotic_complexes_samples import generator
from checks.verify.normal_separation import collar_claims
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.branched_net import BranchedNet, Ray, star, surgery
from discrete.index import interior_vertices, normal_winding
from discrete.k_surface import KSurface, k_surface
from discrete.vertex_fan import vertex_fan
from theory import star_saddle

FloatArray = npt.NDArray[np.float64]


def _neighbours(complex_: AsymptoticComplex, vertex: int) -> list[int]:
    """Neighbours of an interior vertex in cyclic order."""
    ends = complex_.edges[list(vertex_fan(complex_, vertex).edges)]
    return [int(b) if int(a) == vertex else int(a) for a, b in ends]


def _loop(surface: KSurface, vertex: int) -> FloatArray:
    """Normals of the neighbours in the tangent plane of the normal at a vertex: (degree, 2)."""
    normal = surface.normals[vertex]
    first = surface.edge_vectors()[0]
    first = first - (first @ normal) * normal
    first /= np.linalg.norm(first)
    axes = np.stack([first, np.cross(normal, first)], axis=1)
    return np.asarray(surface.normals[_neighbours(surface.complex, vertex)] @ axes)


def _nearest(loop: FloatArray) -> FloatArray:
    """Point of a closed polygon nearest to 0."""
    following = np.roll(loop, -1, axis=0)
    along = following - loop
    share = np.clip(-(loop * along).sum(axis=1) / (along**2).sum(axis=1), 0, 1)
    feet = loop + share[:, np.newaxis] * along
    return np.asarray(feet[np.argmin((feet**2).sum(axis=1))])


def _winding(loop: FloatArray) -> int:
    following = np.roll(loop, -1, axis=0)
    cross = loop[:, 0] * following[:, 1] - loop[:, 1] * following[:, 0]
    turns = np.arctan2(cross, (loop * following).sum(axis=1)).sum()
    return abs(round(float(turns) / (2 * np.pi)))


def disturbed(setting: Setting, *, percent: int = 99) -> Evidence:
    """Winding of the normal about branch points after disturbances of a share of its distance.

    percent: of the distance from N(p) to the loop of the normals around it. The loop is moved as
    a whole towards N(p), which is the worst, and each of its corners in a random direction.
    """
    rng = generator(setting)
    found = np.inf
    tried = 0
    for recipe in nets.LARGE:
        surface = k_surface(nets.float_net(recipe))
        for vertex in surface.complex.branch_points.tolist():
            loop, order = _loop(surface, vertex), int(surface.complex.saddle_order[vertex])
            foot = _nearest(loop)
            size = float(np.linalg.norm(foot))
            directions = rng.normal(size=(20, *loop.shape))
            directions /= np.linalg.norm(directions, axis=2, keepdims=True)
            moves = [-foot[np.newaxis], *(size * directions)]
            for move in moves:
                tried += 1
                turns = _winding(loop + percent / 100 * move)
                if turns != order - 1:
                    return Evidence(
                        outcome="fail",
                        grade="numeric",
                        tried=tried,
                        met=tried,
                        witness=f"order {order}: moved by {percent} % of the distance {size:.3g} "
                        f"from N(p), the normals wind {turns} times about it, not {order - 1}",
                    )
            found = min(found, size)
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=10,
        tried=tried,
        met=tried,
        shown="normals around ten branch points of orders 3 to 5 wind as often after every "
        "disturbance below their distance from N(p), the worst one and random ones, so that none "
        f"becomes a regular point; least distance {found:.2g}",
    )


def _random_net(rng: np.random.Generator) -> BranchedNet:
    """Star between rays that turn, of unequal angles and lengths, after a random surgery."""
    count = 2 * int(rng.integers(2, 6))
    rays = [
        Ray(lengths=rng.uniform(0.05, 0.1, 5), left_turns=rng.uniform(-0.1, 0.1, 4))
        for _ in range(count)
    ]
    shares = rng.uniform(0.8, 1.2, count)
    net = star(rays, (shares * 2 * np.pi / shares.sum()).tolist())
    number, apex = int(rng.integers(count)), (2, int(rng.integers(1, 4)))
    sector = net.placed[number].sector
    parts = rng.uniform(0.8, 1.2, 3)
    total = float(sector.angles[apex])
    return surgery(net, number, apex, angles=(total * parts / parts.sum()).tolist())


def _crossing(surface: KSurface, vertex: int) -> bool:
    """Whether the lines of both families alternate round a vertex in space as in the complex."""
    order = _neighbours(surface.complex, vertex)
    normal = surface.normals[vertex]
    edges = surface.points[order] - surface.points[vertex]
    axes = np.stack([edges[0], np.cross(normal, edges[0])], axis=1)
    seen = edges @ axes
    bearing = np.arctan2(seen[:, 1], seen[:, 0]) % (2 * np.pi)
    bearing[0] = 0.0  # rounding may put the first edge just below a full turn
    ranks = np.argsort(bearing)
    backwards = np.concatenate([ranks[:1], ranks[:0:-1]])
    families = surface.complex.edge_is_u[
        surface.complex.edge_between(np.full(len(order), vertex), np.array(order))
    ]
    cyclic = bool(
        (ranks == np.arange(len(order))).all() or (backwards == np.arange(len(order))).all()
    )
    return cyclic and bool((families != np.roll(families, 1)).all())


def encoded(setting: Setting, *, offset: int = 1, halves: int = 1) -> Evidence:
    """Winding of the normal and crossing of lines in space, against the complex alone.

    offset - halves degree/2 is the index that the degree is to give. The surfaces have unequal
    edges and angles and rays that turn, none of which the complex knows.
    """
    rng = generator(setting)
    points, count = 0, 12
    for number in range(count):
        surface = k_surface(_random_net(rng))
        complex_ = surface.complex
        inside = interior_vertices(complex_)
        winding = normal_winding(complex_, surface.normals)
        wrong = [
            f"degree {degree}, the normal winds {turns} times"
            for degree, turns in zip(
                complex_.degree[inside].tolist(), winding.tolist(), strict=True
            )
            if 2 * (offset - turns) != halves * degree
        ]
        crossed = [v for v in inside.tolist() if not _crossing(surface, v)]
        wrong += [f"the lines at vertex {v} cross in another order" for v in crossed]
        if wrong:
            return Evidence(
                outcome="fail", grade="numeric", witness=f"surface {number}: {wrong[0]}"
            )
        points += len(inside)
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=10,
        tried=points,
        met=points,
        shown=f"at {points} vertices of {count} random surfaces with one or two branch points the "
        "normal winds 1 - m times, 2m the degree in the complex, and u- and v-lines leave the "
        "vertex in the order that the complex has",
    )


def _limit_orders(indices: set[int]) -> list[int]:
    """Orders of stars whose index is one of these."""
    return [
        m for m in range(2, 9) if star_saddle.winding_number(star_saddle.regular_star(m)) in indices
    ]


def limit_index(setting: Setting, *, percent: int = 99, share: str = "7/8") -> Evidence:
    """Whether branch points of index 1 - m, m > 2, are limits of points of index -1.

    On the collar the normal stays share s epsilon away from N(p), for y and all y_n; loops closer
    than percent of that have one degree. share, percent: of the two bounds.
    """
    smooth = branched_limits.smooth_indices(isometric=True)
    orders = _limit_orders(smooth)
    return combined(
        {
            "collar": positivity(setting, collar_claims(share), shown="collar"),
            "degree": branched_limits.degree_stable(setting, percent=percent),
            "orders": statement(
                orders == [2], shown="orders", witness=f"index -1 belongs to the orders {orders}"
            ),
        },
        shown="the bound on the collar is one for all n, the degree of loops closer than it is "
        "the same, C^2 immersions have the index -1, stars of order 3 to 8 have 1 - m: no branch "
        "point turns up in a W^{2,2} limit",
    )


def unbranched_limit(
    setting: Setting, *, isometric: bool = True, order: int = 2, share: str = "7/8"
) -> Evidence:
    """Informal (thm:branched): orders of the points of a limit of unbranched surfaces.

    isometric: whether the approximating surfaces have curvature -1 or are any smooth ones; order:
    that of every point of the limit; share: of the bound on the collar.
    """
    smooth = branched_limits.smooth_indices(isometric=isometric)
    orders = _limit_orders(smooth)
    parts: dict[str, Any] = {
        "limit": branched_limits.branched_limit(
            setting, isometric=isometric, order=order, share=share
        ),
        "unbranched": statement(
            smooth == {-1},
            shown="index -1",
            witness=f"smooth surfaces of any curvature have the indices {sorted(smooth)}",
        ),
    }
    jumps = {
        m: [star_saddle.hessian_jump(star_saddle.regular_star(m), i) for i in range(2 * m)]
        for m in (3, 4)
    }
    bounded = all(bool(sp.Abs(jump) < 10) for row in jumps.values() for jump in row)
    parts["branched surfaces are C^{1,1}"] = statement(
        bounded, shown="bounded jumps", witness=f"jumps {jumps}"
    )
    return combined(
        parts,
        shown=f"of all stars only those of orders {orders} have the index of unbranched surfaces; "
        "the others, C^{1,1} too, keep a distance in L^1 of normals that depends on the bound of "
        "the curvatures alone",
    )
