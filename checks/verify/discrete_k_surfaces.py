"""Checks of section 4: discrete K-surfaces on grids and complexes, their normals recovered."""

from typing import Any

import numpy as np
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import discrete_surfaces as printed
from checks.verify.discrete_lelieuvre import Grid, minus, placed, rational_net
from checks.verify.spherical_samples import star_net
from discrete.spherical_net import SphericalNet, edge_step, surface_points
from theory.vectors import Vector, cross, dot, scaled

_ORDERS = (2, 3)


def _unit(vector: Vector) -> Vector | None:
    """Rational multiple of length one, or None where there is none or the vector is 0."""
    length = sp.sqrt(dot(vector, vector))
    if length == 0 or not length.is_Rational:
        return None
    return scaled(1 / length, vector)


def _star_normal(points: Grid, i: int, j: int) -> Vector | None:
    """Unit vector orthogonal to all edges at a vertex of a grid, up to its sign, or None."""
    n, m = len(points), len(points[0])
    edges = [
        minus(points[k][h], points[i][j])
        for k, h in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1))
        if 0 <= k < n and 0 <= h < m
    ]
    vertical = [e for e in edges[1:] if any(entry != 0 for entry in cross(edges[0], e))]
    if not vertical:
        return None
    found = _unit(cross(edges[0], vertical[0]))
    if found is None or any(dot(found, e) != 0 for e in edges):
        return None
    return found


def recovered_normals(points: Grid) -> tuple[list[list[Vector]] | None, str]:
    """Normals with which a grid of rational points is a K-surface, or None and the obstacle.

    An edge N_1 x N_0 is orthogonal to both normals, so each normal is that of its star up to sign;
    the sign at (0, 0) is a choice, that of the others is tried.
    """
    normals: list[list[Vector]] = []
    for i, row in enumerate(points):
        normals.append([])
        for j, p in enumerate(row):
            normal = _star_normal(points, i, j)
            if normal is None:
                return None, f"the star of the vertex ({i}, {j}) is not planar"
            if i or j:
                k, h = (i, j - 1) if j else (i - 1, j)
                step = printed.step_v if j else printed.step_u
                edge = minus(p, points[k][h])
                signs = [s for s in (1, -1) if step(normals[k][h], scaled(s, normal)) == edge]
                if not signs:
                    return None, f"no sign of the normal at ({i}, {j}) gives the edge to it"
                normal = scaled(signs[0], normal)
            normals[-1].append(normal)
    for i in range(len(points) - 1):
        for j in range(len(points[0])):
            edge = minus(points[i + 1][j], points[i][j])
            if printed.step_u(normals[i][j], normals[i + 1][j]) != edge:
                return None, f"the u-edge from ({i}, {j}) is not N_1 x N_0"
    return normals, ""


def definition(setting: Setting, *, moved: str = "") -> Evidence:
    """def:K-surf: an instance of rational points is recognised, from the points alone.

    moved: near-misses, the points with one "vertex" lifted along its normal, one vertex moved
    "sideways" in the plane of its star, or all "scaled" by 2; they must be refused.
    """
    normals = rational_net()
    points = [list(row) for row in placed(normals)]
    if moved == "scaled":
        points = [[scaled(2, p) for p in row] for row in points]
    elif moved:
        shift = normals[1][1] if moved == "vertex" else minus(points[2][1], points[1][1])
        step = scaled(sp.Rational(-1, 100), shift)
        points[1][1] = minus(points[1][1], step)
    found, obstacle = recovered_normals(points)
    same = found is not None and found in (
        [list(row) for row in normals],
        [[scaled(-1, n) for n in row] for row in normals],
    )
    return statement(
        same,
        shown="a surface of 3 by 3 quads is recognised from its points: the planes of its stars "
        "give the normals that it was made of, up to one common sign",
        witness=obstacle or "other normals were found",
    )


def near_misses(setting: Setting, *, moved: str = "vertex,sideways,scaled") -> Evidence:
    """Whether grids that are no K-surface are refused; moved: names of the near-misses."""
    for name in moved.split(","):
        refused = definition(setting, moved=name)
        if refused.outcome != "fail":
            return statement(False, shown="", witness=f"near-miss {name or 'none'} is accepted")
    return statement(
        True,
        shown="refused: one vertex lifted along its normal by 1/100, one moved by 1/100 of an edge "
        "in the plane of its star, all points scaled by 2",
        witness="",
    )


def k_surface_definition(
    setting: Setting, *, moved: str = "", refused: str = "vertex,sideways,scaled"
) -> Evidence:
    """def:K-surf: the instance is recognised and the near-misses are refused."""
    return combined(
        {
            "instance": definition(setting, moved=moved),
            "near-misses": near_misses(setting, moved=refused),
        },
        shown="a surface of 3 by 3 quads is recognised from its points, with the normals that it "
        "was made of up to one sign; refused are one vertex lifted along its normal by 1/100, one "
        "moved in the plane of its star by 1/100 of an edge, and all points scaled by 2",
    )


def planar_stars(setting: Setting, *, lifted: bool = False, longer: bool = False) -> Evidence:
    """Whether all vertex stars are planar, also around vertices of degree 4 and 6.

    Rational stars of order 2 and 3 between curves with turns; lifted: vertex 0 is moved along its
    normal; longer: N at vertex 0 is replaced by the next one.
    """
    found = {}
    for order in _ORDERS:
        net = star_net(order)
        if longer:
            net = SphericalNet(complex=net.complex, normals=(net.normals[1], *net.normals[1:]))
        points = surface_points(net)
        if lifted:
            points[0] = minus(points[0], scaled(sp.Rational(1, 100), net.normals[0]))
        for edge, (one, other) in enumerate(net.complex.edges.tolist()):
            vector = minus(points[other], points[one])
            for v in (one, other):
                name = f"order {order}: edge {edge} at vertex {v}"
                found[name] = dot(net.normals[v], vector)
    return identities(
        setting,
        found,
        shown="every edge at every vertex is orthogonal to the normal there, in rational numbers, "
        "on stars whose centre has the degree 4 or 6",
    )


def closing(setting: Setting, *, spoiled: str = "") -> Evidence:
    """Whether the Lelieuvre equations close on rational stars of order 2 and 3, by two trees.

    The vertices are summed along a breadth first and a depth first tree from different origins.
    spoiled: a "normal" turned by a small rotation, or a "family", one edge taken for the other.
    """
    found: dict[str, Any] = {}
    for order in _ORDERS:
        net = star_net(order)
        if spoiled == "normal":
            turned = net.normals[-1]
            c, s = sp.Rational(99, 101), sp.Rational(20, 101)
            other = (turned[0], c * turned[1] - s * turned[2], s * turned[1] + c * turned[2])
            net = SphericalNet(complex=net.complex, normals=(*net.normals[:-1], other))
        first = surface_points(net)
        second = surface_points(net, net.complex.vertex_count - 1, last=True)
        shift = minus(first[0], second[0])
        for v, (p, q) in enumerate(zip(first, second, strict=True)):
            found[f"order {order}, vertex {v}, two paths"] = minus(minus(p, q), shift)
        for edge, (one, other_end) in enumerate(net.complex.edges.tolist()):
            vector = edge_step(net, edge, one)
            if spoiled == "family" and edge == 0:
                vector = scaled(-1, vector)
            gap = minus(minus(first[other_end], first[one]), vector)
            found[f"order {order}, edge {edge}"] = gap
    return identities(
        setting,
        found,
        shown="on stars of order 2 and 3 between rational curves with turns, sums along two "
        "spanning trees from two origins differ by one translation, and every edge is as the "
        "equations say",
    )


def _ring() -> tuple[list[Vector], list[tuple[int, int, bool]]]:
    """Normals and edges (from, to, is u) of a ring of four rhombi on S^2 with sides of one length.

    Vertices 0 to 3 at the latitude arcsin(1/sqrt 5), 4 to 7 at minus that, turned by 60 degrees.
    """
    a, b = 2 / sp.sqrt(5), 1 / sp.sqrt(5)
    c, s = sp.Rational(1, 2), sp.sqrt(3) / 2
    quarter = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    upper = [(a * x, a * y, b) for x, y in quarter]
    lower = [(a * (c * x - s * y), a * (s * x + c * y), -b) for x, y in quarter]
    edges = [(row + k, row + (k + 1) % 4, True) for row in (0, 4) for k in range(4)]
    edges += [(k, k + 4, False) for k in range(4)]
    return [*upper, *lower], edges


def simply_connected(setting: Setting, *, ring: bool = False) -> Evidence:
    """Whether rhombi that close force the surface to close; ring: on a complex with a hole.

    A ring of four rhombi has closing quads, and the sum of the steps around it must vanish; on a
    disk, the boundary of a star of order 3, it does.
    """
    if not ring:
        return closing(setting)
    normals, edges = _ring()
    found: dict[str, Any] = {}
    cosine = sp.Rational(1, 5)
    for one, other, _ in edges:
        found[f"side {one} {other}"] = dot(normals[one], normals[other]) - cosine
    for k in range(4):
        after = (k + 1) % 4
        found[f"quad {k}"] = printed.product_of_sums(
            normals[k], normals[after], normals[k + 4], normals[after + 4]
        )
    around = (sp.Integer(0),) * 3
    for one, other, is_u in edges[:4]:
        step = (printed.step_u if is_u else printed.step_v)(normals[one], normals[other])
        around = minus(around, scaled(-1, step))
    found["sum around the ring"] = around
    return identities(setting, found, shown="the surface of a ring closes")


def construction(setting: Setting, *, spoiled: str = "", ring: bool = False) -> Evidence:
    """lem:construct on rational stars: the equations close, and give a K-surface."""
    return combined(
        {
            "closing": closing(setting, spoiled=spoiled),
            "simply connected": simply_connected(setting, ring=ring),
        },
        shown="on rational stars of order 2 and 3 the equations close around every quad and "
        "along any path, so the net of normals gives a surface",
    )


def three_parameters(setting: Setting, *, parameters: int = 3, pieces: int = 1) -> Evidence:
    """Number of parameters of the surfaces of one net: 3 times the kernel of the edge differences.

    From the exact rank of the incidence matrix of edges and vertices. pieces: copies of the
    complex, so that it is connected for 1 only.
    """
    failed = ""
    for order in _ORDERS:
        complex_ = star_net(order).complex
        vertices, edges = complex_.vertex_count, complex_.edges
        rows = np.zeros((pieces * len(edges), pieces * vertices), dtype=np.int64)
        for piece in range(pieces):
            for k, (one, other) in enumerate(edges.tolist()):
                at = piece * len(edges) + k
                rows[at, piece * vertices + one], rows[at, piece * vertices + other] = -1, 1
        rank = sp.Matrix(rows.tolist()).rank()
        dimension = 3 * (pieces * vertices - rank)
        if dimension != parameters:
            failed = failed or (
                f"order {order}, {pieces} piece(s): {pieces * vertices} vertices, rank {rank}: "
                f"{dimension} parameters"
            )
    return statement(
        not failed,
        shown="the differences along edges have the rank V - 1 on connected complexes, so surfaces "
        "with the same normals differ by a constant vector: 3 parameters",
        witness=failed,
    )


def reduction(setting: Setting, *, sign: int = 1, rule: str = "kept") -> Evidence:
    """Whether normals and surfaces determine each other: from normals to points and back.

    The recovered normals are those of the start up to one sign, are unit vectors, and every quad
    is a rhombus again. sign: replaces r by its image under the reflection z -> sign z; rule:
    "stretched" stretches r.
    """
    normals = rational_net()
    points = placed(normals)
    if sign != 1 or rule == "stretched":
        factor = sp.Integer(sign) if rule == "kept" else sp.Rational(101, 100)
        points = [[(p[0], p[1], factor * p[2]) for p in row] for row in points]
    found, obstacle = recovered_normals(points)
    if found is None:
        return statement(False, shown="", witness=obstacle)
    cosine = dot(normals[0][0], normals[1][0])
    products: dict[str, Any] = {}
    for i, row in enumerate(found):
        for j, n in enumerate(row):
            if i + 1 < len(found):
                products[f"u-edge ({i}, {j})"] = dot(n, found[i + 1][j]) - cosine
            if j + 1 < len(row):
                products[f"v-edge ({i}, {j})"] = dot(n, row[j + 1]) - cosine
    return identities(
        setting,
        products,
        shown="a surface of 3 by 3 quads gives back a spherical net of rhombi, so surfaces with "
        "equal edges and spherical Chebyshev nets are the same data up to translation and sign",
    )
