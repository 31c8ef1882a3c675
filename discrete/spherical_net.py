"""Spherical nets on asymptotic complexes: assembly from curves, surgery, the surface in space.

A net gives each vertex of a complex a unit normal; scalars of any kind (rational, arb, float). Its
quads are closed by the half-turn rule, so opposite sides are equal (def:sphchebnet).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from discrete import geodesics
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_surgery import boundary_segment
from discrete.errors import CoincidentVerticesError, ShapeError
from discrete.gluing import Seam, fan, glued, grid
from discrete.goursat_fill import fill
from discrete.quad_rule import require_not_antipodal, require_on_space
from discrete.signed_graph import IntArray
from discrete.space_forms import S2, Scalar, Triple, cross_s2, dot_s2

Curve = Sequence[Triple]
ObjectArray = npt.NDArray[Any]


@dataclass(frozen=True, kw_only=True, eq=False)
class SphericalNet:
    """Unit normals at the vertices of an asymptotic complex.

    Normals in floats are checked, those of the ends of an edge against one another as well. Raises
    ShapeError, NotFiniteError, OffSpaceError, CoincidentVerticesError, AntipodalError, naming the
    vertex.
    """

    complex: AsymptoticComplex
    normals: tuple[Triple, ...]

    def __post_init__(self) -> None:
        if len(self.normals) != self.complex.vertex_count:
            raise ShapeError(
                f"{len(self.normals)} normals for {self.complex.vertex_count} vertices"
            )
        _require_floats(self.complex, self.normals)


def _require_floats(complex_: AsymptoticComplex, normals: tuple[Triple, ...]) -> None:
    """Refuse normals in floats that are no unit vectors, or no edge of the net joins."""
    if not all(isinstance(entry, float) for normal in normals for entry in normal):
        return  # balls, fractions and symbols are for those who know what they prove
    for vertex, normal in enumerate(normals):
        require_on_space(S2, normal, str(vertex))
    for start, end in complex_.edges.tolist():
        a, b = normals[start], normals[end]
        if a == b:
            raise CoincidentVerticesError(
                f"vertices {start} and {end} of an edge have one normal, {tuple(a)}: the edge has "
                "no length, take another normal"
            )
        require_not_antipodal(S2, a, b, f"{start} and {end}")


def _sector_normals(number: int, first: Curve, second: Curve) -> list[list[Triple]]:
    """Normals of sector `number` between two curves, by its u- and v-edges: the even ones are u."""
    u, v = (first, second) if number % 2 == 0 else (second, first)
    return fill(dot_s2, u, v)


def _placed(
    places: Sequence[IntArray], sectors: Sequence[list[list[Triple]]], normals: dict[int, Triple]
) -> None:
    """Enter the normals of the sectors at the vertices that theirs have become."""
    for nodes, place in zip(sectors, places, strict=True):
        numbers = grid(len(nodes) - 1, len(nodes[0]) - 1)
        for (i, j), vertex in np.ndenumerate(numbers):
            normals.setdefault(int(place[vertex]), nodes[i][j])


def _in_order(normals: dict[int, Triple]) -> tuple[Triple, ...]:
    return tuple(normals[vertex] for vertex in range(len(normals)))


def assembled(curves: Sequence[Curve]) -> SphericalNet:
    """Net of 2m sectors between these curves from one normal (lem:discrete_assembly).

    Sector i lies between the curves i and i + 1; the even curves consist of u-edges. Raises
    ShapeError unless their number is even, at least 4, and all start at one normal.
    """
    if len(curves) < 4 or len(curves) % 2:
        raise ShapeError(f"{len(curves)} curves: their number must be even and at least 4")
    if any(tuple(curve[0]) != tuple(curves[0][0]) for curve in curves):
        raise ShapeError("the curves must start at the same normal")
    around = [*curves, curves[0]]
    pieces, seams, rays = fan([len(curve) - 1 for curve in around])
    closing = Seam(first=len(pieces) - 1, path=rays[-1], second=0, onto=rays[0])
    found = glued(pieces, [*seams, closing])
    normals: dict[int, Triple] = {}
    sectors = [_sector_normals(i, around[i], around[i + 1]) for i in range(len(curves))]
    _placed(found.places, sectors, normals)
    return SphericalNet(complex=found.complex, normals=_in_order(normals))


def attached_with_places(
    net: SphericalNet, corner: int, curves: Sequence[Curve]
) -> tuple[SphericalNet, IntArray]:
    """Net with sectors put in at a corner vertex, and the new number of each old vertex.

    curves: an even number of curves from the corner's normal, in the order from the maximal
    u-segment of the corner to its v-segment, between which the sectors lie; the old vertices keep
    their normals. Raises SurgeryError, GluingError, ShapeError.
    """
    if len(curves) % 2:
        raise ShapeError(f"{len(curves)} new curves at vertex {corner}: an even number is needed")
    along_u, along_v = (boundary_segment(net.complex, corner, along_u=u) for u in (True, False))
    outer = [[net.normals[v] for v in path] for path in (along_u, along_v)]
    around = [outer[0], *curves, outer[1]]
    pieces, seams, rays = fan([len(curve) - 1 for curve in around])
    # The old complex comes first, so that face 0 and with it the orientation stay what they were.
    inner = [
        Seam(first=seam.first + 1, path=seam.path, second=seam.second + 1, onto=seam.onto)
        for seam in seams
    ]
    sides = [
        Seam(first=0, path=along_u, second=1, onto=rays[0]),
        Seam(first=0, path=along_v, second=len(pieces), onto=rays[-1]),
    ]
    found = glued([net.complex, *pieces], [*inner, *sides])
    normals = {int(found.places[0][v]): n for v, n in enumerate(net.normals)}
    sectors = [_sector_normals(i, around[i], around[i + 1]) for i in range(len(pieces))]
    _placed(found.places[1:], sectors, normals)
    return SphericalNet(complex=found.complex, normals=_in_order(normals)), found.places[0]


def geodesic_curve(
    functions: Any, start: Triple, along: Triple, edge: Scalar, edges: int
) -> list[Triple]:
    """Equally spaced normals on the geodesic that leaves `start` with the unit tangent `along`."""
    return [geodesics.point_along(S2, functions, start, along, k * edge) for k in range(edges + 1)]


def corner_angles(net: SphericalNet, functions: Any) -> ObjectArray:
    """Signed angle of each face at its corners: an array (faces, 4) of scalars, in (-pi, pi].

    Counterclockwise in the complex, its orientation being that of face 0, and on S^2 seen from
    outside; negative where the net reverses orientation. Raises ShapeError on a one-sided complex.
    """
    sines, cosines = corner_parts(net)
    found = np.empty(sines.shape, dtype=object)
    for at, sine in np.ndenumerate(sines):
        found[at] = functions.atan2(sine, cosines[at])
    return found


def corner_parts(net: SphericalNet) -> tuple[ObjectArray, ObjectArray]:
    """Sine and cosine of each corner angle, times the same positive factor: arrays (faces, 4)."""
    signs = net.complex.orientation
    if signs is None:
        raise ShapeError("the complex is one-sided: its angles have no common sign")
    faces = net.complex.faces
    sines, cosines = (np.empty(faces.shape, dtype=object) for _ in range(2))
    for face, sign in enumerate(signs):
        corners = [net.normals[v] for v in faces[face]]
        for k in range(4):
            after, before = corners[(k + 1) % 4], corners[(k - 1) % 4]
            if sign < 0:
                after, before = before, after
            parts = geodesics.sine_and_cosine_part(S2, corners[k], after, before)
            sines[face, k], cosines[face, k] = parts
    return sines, cosines


def edge_step(net: SphericalNet, edge: int, start: int) -> Triple:
    """Vector of an edge of the surface from its end `start` (eq:d_lelieuvre)."""
    one, other = (int(v) for v in net.complex.edges[edge])
    end = other if start == one else one
    step = cross_s2(net.normals[end], net.normals[start])
    if net.complex.edge_is_u[edge]:
        return step
    return (-step[0], -step[1], -step[2])


def surface_points(net: SphericalNet, origin: int = 0, *, last: bool = False) -> list[Triple]:
    """Vertices of the K-surface of a net, the origin at 0, summed along a spanning tree.

    last: the tree that visits the latest vertex first (depth first) instead of the earliest.
    """
    around: dict[int, list[int]] = {}
    for edge, ends in enumerate(net.complex.edges):
        for v in ends:
            around.setdefault(int(v), []).append(edge)
    points: dict[int, Triple] = {origin: (0, 0, 0)}
    waiting = [origin]
    while waiting:
        at = waiting.pop(-1 if last else 0)
        for edge in around[at]:
            one, other = (int(v) for v in net.complex.edges[edge])
            end = other if at == one else one
            if end not in points:
                p, step = points[at], edge_step(net, edge, at)
                points[end] = (p[0] + step[0], p[1] + step[1], p[2] + step[2])
                waiting.append(end)
    return [points[v] for v in range(net.complex.vertex_count)]
