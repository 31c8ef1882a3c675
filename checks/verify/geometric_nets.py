"""Regular stars of equal rhombi after surgeries, made twice: by angles alone, and by half-turns.

Both routes take the same recipe and any kind of scalars. The angles are advanced from sector to
sector without coordinates; the places are triples of H^2 between geodesics, filled by half-turns,
without an angle but those of the geodesics at their apex. The complex is that of the float net.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from discrete import branched_net
from discrete.angle_advance import NetAngles, net_angles
from discrete.branched_net import BranchedNet, geodesic_ray, regular_star
from discrete.geodesics import (
    angle_at,
    determinant,
    difference,
    direction,
    point_along,
    polar,
    turned_direction,
)
from discrete.goursat_fill import fill
from discrete.index import Angles
from discrete.space_forms import H2, ORIGIN, Scalar, Triple

Rows = list[list[Triple]]


@dataclass(frozen=True, kw_only=True)
class Cut:
    """Surgery: the corner of a sector from vertex `apex` on is replaced by equal sectors."""

    sector: int
    apex: tuple[int, int]
    inserted: int = 3


@dataclass(frozen=True, kw_only=True)
class Recipe:
    """Star of 2 order equal sectors of edges by edges rhombi, and the surgeries in it, in order."""

    order: int
    edge_length: Fraction
    edges: int
    cuts: tuple[Cut, ...] = ()


SMALL = (
    Recipe(order=3, edge_length=Fraction(1, 4), edges=3),
    Recipe(order=2, edge_length=Fraction(1, 4), edges=4, cuts=(Cut(sector=0, apex=(2, 1)),)),
    Recipe(
        order=2,
        edge_length=Fraction(1, 5),
        edges=5,
        cuts=(Cut(sector=1, apex=(2, 1), inserted=5), Cut(sector=4, apex=(1, 2))),
    ),
)
LARGE = (
    *SMALL,
    Recipe(order=5, edge_length=Fraction(1, 8), edges=7, cuts=(Cut(sector=4, apex=(4, 3)),)),
    Recipe(
        order=2,
        edge_length=Fraction(1, 10),
        edges=12,
        cuts=(
            Cut(sector=0, apex=(5, 4)),
            Cut(sector=2, apex=(5, 6), inserted=7),
            Cut(sector=5, apex=(4, 4)),
            Cut(sector=15, apex=(2, 2)),
        ),
    ),
)


def float_net(recipe: Recipe) -> BranchedNet:
    """Net in float64, with its complex."""
    net = regular_star(recipe.order, edge_length=float(recipe.edge_length), edges=recipe.edges)
    for cut in recipe.cuts:
        sector, (i, j) = net.placed[cut.sector].sector, cut.apex
        lengths = (sector.v_lengths[j:], sector.u_lengths[i:])
        rays = [geodesic_ray(lengths[k % 2]) for k in range(cut.inserted - 1)]
        net = branched_net.surgery(net, cut.sector, cut.apex, rays=rays)
    return net


def _inner_angles(
    functions: Any, parent: NetAngles, cut: Cut, length: Scalar, edges: tuple[int, int]
) -> list[NetAngles]:
    """Angles of the sectors put in, from the turns of the lines that bound the corner."""
    (i, j), (n, m) = cut.apex, edges
    a, d = parent.angles, parent.half_defects
    u_turns = [a[k][j] - a[k - 1][j] - d[k - 1][j] for k in range(i + 1, n)]
    v_turns = [a[i][k] - a[i][k - 1] - d[i][k - 1] for k in range(j + 1, m)]
    found = []
    for k in range(cut.inserted):
        found.append(
            net_angles(
                H2,
                functions,
                [length] * (n - i),
                [length] * (m - j),
                a[i][j] / cut.inserted,
                u_turns=u_turns if k == 0 else None,
                v_turns=v_turns if k == cut.inserted - 1 else None,
            )
        )
    return found


def sector_angles(recipe: Recipe, functions: Any, length: Scalar) -> list[NetAngles]:
    """Angles of all sectors, in the order of the net; length: the edge length as a scalar."""
    sides = [length] * recipe.edges
    angle = functions.pi / recipe.order
    found = [net_angles(H2, functions, sides, sides, angle) for _ in range(2 * recipe.order)]
    for cut in recipe.cuts:
        parent = found[cut.sector]
        edges = len(parent.u_lengths), len(parent.v_lengths)
        found += _inner_angles(functions, parent, cut, length, edges)
    return found


def _fan_nodes(rays: Sequence[Sequence[Triple]]) -> list[Rows]:
    """Nodes of the sectors between consecutive rays, the even ones u-rays."""
    return [
        fill(H2.dot, *((rays[k], rays[k + 1]) if k % 2 == 0 else (rays[k + 1], rays[k])))
        for k in range(len(rays) - 1)
    ]


def _new_rays(
    functions: Any, nodes: Rows, cut: Cut, length: Scalar, factor: Scalar
) -> list[list[Triple]]:
    """Rays of the sectors put in: the two lines of the corner, geodesics at equal angles between.

    factor: by which the last edge of the geodesics is longer than the others.
    """
    i, j = cut.apex
    u_line, v_line = [row[j] for row in nodes[i:]], list(nodes[i][j:])
    apex = nodes[i][j]
    along = direction(H2, functions, apex, u_line[1])
    part = angle_at(H2, functions, apex, u_line[1], v_line[1]) / cut.inserted
    rays = [u_line]
    for k in range(1, cut.inserted):
        own = turned_direction(H2, functions, apex, along, k * part)
        count = len(v_line if k % 2 else u_line)
        places = [n * length for n in range(1, count - 1)] + [(count - 2 + factor) * length]
        rays.append([apex, *(point_along(H2, functions, apex, own, at) for at in places)])
    return [*rays, v_line]


def sector_nodes(
    recipe: Recipe, functions: Any, length: Scalar, *, last_edge: Scalar = 1
) -> list[Rows]:
    """Triples of the vertices [i][j] of all sectors, in the order of the net.

    last_edge: ratio of the last edge of new rays to the others.
    """
    rays = []
    for k in range(2 * recipe.order):
        angle = k * functions.pi / recipe.order
        onwards = range(1, recipe.edges + 1)
        rays.append([ORIGIN, *(polar(H2, functions, angle, n * length) for n in onwards)])
    found = _fan_nodes([*rays, rays[0]])
    for cut in recipe.cuts:
        found += _fan_nodes(_new_rays(functions, found[cut.sector], cut, length, last_edge))
    return found


def corner_angles(net: BranchedNet, angles: Sequence[NetAngles], pi: Scalar) -> Angles:
    """Angles of the faces at their corners, an array (faces, 4) of objects."""
    found: list[list[Scalar]] = []
    for place, sector in zip(net.placed, angles, strict=True):
        for i, j in np.argwhere(place.kept).tolist():
            a = sector.angles[i][j]
            b = pi - a - sector.half_defects[i][j]
            found.append([a, b, a, b])
    array = np.empty((len(found), 4), dtype=object)
    for face, corners in enumerate(found):
        array[face] = corners
    return array


def face_corners(net: BranchedNet, nodes: Sequence[Rows]) -> list[tuple[Triple, ...]]:
    """Triples of the corners p, p_u, p_uv, p_v of each face."""
    return [
        (rows[i][j], rows[i + 1][j], rows[i + 1][j + 1], rows[i][j + 1])
        for place, rows in zip(net.placed, nodes, strict=True)
        for i, j in np.argwhere(place.kept).tolist()
    ]


def triangle_area(functions: Any, a: Triple, b: Triple, c: Triple) -> Scalar:
    """Signed area of a geodesic triangle of H^2, positive where it turns from x1 to x2.

    tan(area/2) is the determinant over 1 + the cosh of the three sides: no angle enters.
    """
    volume = determinant(a, difference(b, a), difference(c, a))
    return 2 * functions.atan2(volume, 1 - H2.dot(a, b) - H2.dot(b, c) - H2.dot(c, a))


def quad_areas(functions: Any, corners: Sequence[tuple[Triple, ...]]) -> list[Scalar]:
    """Areas of the faces, each cut into two triangles by the diagonal from p to p_uv."""
    return [
        abs(triangle_area(functions, p, p_u, p_uv) + triangle_area(functions, p, p_uv, p_v))
        for p, p_u, p_uv, p_v in corners
    ]
