"""Branched hyperbolic nets: sectors around a vertex, and sectors put in where a corner is cut out.

A ray is a side of two sectors, given by the lengths of its edges and its left turns, seen from the
normal's side. Sectors are glued vertex by vertex into an asymptotic complex; a sector that was cut
keeps the quads (i, j) with i < cut[0] or j < cut[1].
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import SurgeryError
from discrete.complex_surgery import restricted
from discrete.errors import AngleError, NotFiniteError, ShapeError
from discrete.gluing import Glued, Seam, glued, grid, rectangle
from discrete.members import whole_number
from discrete.sector import FloatArray, Sector, frozen_array
from discrete.signed_graph import BoolArray, IntArray

#: Allowed deviation of the angles around a vertex from their sum, in radians.
ANGLE_SUM = 1e-12


@dataclass(frozen=True, kw_only=True, eq=False)
class Ray:
    """Polyline from a vertex: lengths of its n edges on H^2, its n - 1 left turns (0: geodesic)."""

    lengths: FloatArray
    left_turns: FloatArray

    def __post_init__(self) -> None:
        for name in ("lengths", "left_turns"):
            found = frozen_array(getattr(self, name))
            if not np.isfinite(found).all():
                raise NotFiniteError(f"{name} of a ray: {found.tolist()}, not all finite")
            object.__setattr__(self, name, found)
        if len(self.left_turns) != max(len(self.lengths) - 1, 0):
            raise ShapeError(f"a ray of {len(self.lengths)} edges has one left turn fewer")


def geodesic_ray(lengths: object) -> Ray:
    """Ray without turns."""
    found = frozen_array(lengths)
    return Ray(lengths=found, left_turns=np.zeros(max(len(found) - 1, 0)))


@dataclass(frozen=True, kw_only=True, eq=False)
class Placed:
    """Sector and its place: its apex is a vertex of the sector `parent` (-1: of none).

    side: +1 where its v-edges lie to the left of its u-edges; bearing: angle to the left from the
    parent's u-edge at the apex to its own; cut: corner from which its quads are cut out, or None.
    """

    sector: Sector
    side: int
    parent: int
    apex: tuple[int, int]
    bearing: float
    cut: tuple[int, int] | None = None

    @property
    def kept(self) -> BoolArray:
        """Whether each quad is kept: an array (n, m)."""
        n, m = self.sector.shape
        i, j = self.cut or (n, m)
        return np.asarray((np.arange(n)[:, np.newaxis] < i) | (np.arange(m) < j))


@dataclass(frozen=True, kw_only=True)
class NetSeam:
    """Vertices (i, j) of one sector that are those of another, in order along a common line."""

    first: int
    path: tuple[tuple[int, int], ...]
    second: int
    onto: tuple[tuple[int, int], ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class BranchedNet:
    """Hyperbolic Chebyshev net with branch points: sectors and the seams between them.

    A parent stands before its daughters.
    """

    placed: tuple[Placed, ...]
    seams: tuple[NetSeam, ...]

    @cached_property
    def _glued(self) -> tuple[Glued, list[IntArray]]:
        pieces, numbers = [], []
        for place in self.placed:
            piece, number = rectangle(*place.sector.shape), grid(*place.sector.shape)
            if place.cut is not None:
                piece, place_of = restricted(piece, place.kept.ravel())
                number = place_of[number]
            pieces.append(piece)
            numbers.append(number)
        seams = [
            Seam(
                first=seam.first,
                path=[int(numbers[seam.first][at]) for at in seam.path],
                second=seam.second,
                onto=[int(numbers[seam.second][at]) for at in seam.onto],
            )
            for seam in self.seams
        ]
        return glued(pieces, seams), numbers

    @property
    def complex(self) -> AsymptoticComplex:
        """Asymptotic complex of the net."""
        return self._glued[0].complex

    @cached_property
    def places(self) -> list[IntArray]:
        """For each sector the vertices of the complex at its own: (n + 1, m + 1), -1 if cut out."""
        found, numbers = self._glued
        return [
            np.where(number >= 0, place[number], -1)
            for number, place in zip(numbers, found.places, strict=True)
        ]

    @cached_property
    def corner_angles(self) -> FloatArray:
        """Angles of the faces of the complex at their corners: an array (faces, 4)."""
        return np.concatenate([p.sector.corner_angles()[p.kept] for p in self.placed])


def _fan(
    rays: Sequence[Ray], angles: Sequence[float], side: int
) -> list[tuple[Sector, int, float]]:
    """Sectors between consecutive rays, the even ones u-rays: with side and bearing of the u-edge.

    side: +1 where the rays follow one another to the left, else -1.
    """
    found, bearing = [], 0.0
    for k, angle in enumerate(angles):
        first, second = rays[k], rays[k + 1]
        near, far = -side * first.left_turns, side * second.left_turns
        pairs = [(first.lengths, near), (second.lengths, far)]
        (u, u_turns), (v, v_turns) = pairs if k % 2 == 0 else pairs[::-1]
        sector = Sector(
            u_lengths=u, v_lengths=v, corner_angle=angle, u_turns=u_turns, v_turns=v_turns
        )
        own = side if k % 2 == 0 else -side
        found.append((sector, own, bearing + (0.0 if k % 2 == 0 else side * angle)))
        bearing += side * angle
    return found


def _require_sum(angles: Sequence[float], total: float, where: str) -> None:
    try:
        finite = bool(np.isfinite(np.array(angles, dtype=np.float64)).all())
    except (TypeError, ValueError) as error:
        raise AngleError(f"{where}: the angles {angles!r} are no numbers") from error
    if not finite or min(angles) <= 0:
        raise AngleError(f"{where}: the angles {list(angles)} must be positive")
    if abs(sum(angles) - total) > ANGLE_SUM * len(angles):
        raise AngleError(f"{where}: the angles add up to {sum(angles)}, expected {total}")


def _side(
    sector: Sector, name: str, start: tuple[int, int] = (0, 0)
) -> tuple[tuple[int, int], ...]:
    """Vertices of the u- or v-line of a sector from a vertex on."""
    (i, j), (n, m) = start, sector.shape
    if name == "u":
        return tuple((k, j) for k in range(i, n + 1))
    return tuple((i, k) for k in range(j, m + 1))


def _inner_seams(fan: Sequence[tuple[Sector, int, float]], start: int) -> list[NetSeam]:
    """Seams between consecutive sectors of a fan, numbered from `start` on."""
    return [
        NetSeam(
            first=start + k,
            path=_side(fan[k][0], "v" if k % 2 == 0 else "u"),
            second=start + k + 1,
            onto=_side(fan[k + 1][0], "v" if k % 2 == 0 else "u"),
        )
        for k in range(len(fan) - 1)
    ]


def star(rays: Sequence[Ray], angles: Sequence[float]) -> BranchedNet:
    """Net of 2m sectors around a vertex, ray k between the sectors k - 1 and k (prop:assembly).

    angles: corner angles, of sum 2 pi; even rays are u-lines. Raises AngleError, ShapeError.
    """
    if len(rays) != len(angles) or len(rays) < 4 or len(rays) % 2:
        raise ShapeError(f"{len(rays)} rays and {len(angles)} angles: as many, even, four or more")
    _require_sum(angles, 2 * np.pi, "the star")
    fan = _fan([*rays, rays[0]], angles, 1)
    last = len(fan) - 1
    closing = NetSeam(
        first=last, path=_side(fan[last][0], "u"), second=0, onto=_side(fan[0][0], "u")
    )
    placed = tuple(
        Placed(sector=sector, side=side, parent=-1, apex=(0, 0), bearing=bearing)
        for sector, side, bearing in fan
    )
    return BranchedNet(placed=placed, seams=(*_inner_seams(fan, 0), closing))


def regular_star(order: int, *, edge_length: float, edges: int) -> BranchedNet:
    """Star of 2m equal Amsler sectors, m the order of saddleness at its centre, m >= 2.

    Raises ShapeError, EdgeLengthError.
    """
    if whole_number(order, "the order of saddleness") < 2 or whole_number(edges, "edges") < 1:
        raise ShapeError(f"order {order} with {edges} edges a ray: take 2 or more, with 1 or more")
    ray = geodesic_ray(np.full(edges, edge_length))
    return star([ray] * (2 * order), [np.pi / order] * (2 * order))


def surgery(
    net: BranchedNet,
    number: int,
    apex: tuple[int, int],
    *,
    rays: Sequence[Ray] | None = None,
    angles: Sequence[float] | None = None,
) -> BranchedNet:
    """Net in which the corner of a sector from vertex `apex` on is replaced by 2k + 1 sectors.

    rays: the 2k new ones, in the order from the sector's u-line to its v-line, by default two
    geodesics with the lengths of these lines; angles: the 2k + 1 new ones, whose sum is the angle
    that was cut out, by default equal (lem:surgery). Raises DiscreteError and its subclasses.
    """
    parent = _parent(net, number, apex)
    sector, (i, j) = parent.sector, apex
    u, v = sector.u_lengths[i:], sector.v_lengths[j:]
    inner = [geodesic_ray(v), geodesic_ray(u)] if rays is None else list(rays)
    if len(inner) % 2 or not inner:
        raise ShapeError(f"{len(inner)} new rays: u- and v-rays alternate, so their number is even")
    total = float(sector.angles[i, j])
    count = len(inner) + 1
    shares = [total / count] * count if angles is None else list(angles)
    if len(shares) != count:
        raise ShapeError(f"{len(shares)} angles for {count} new sectors")
    _require_sum(shares, total, f"the corner of sector {number} at {apex}")
    first = Ray(lengths=u, left_turns=-parent.side * sector.u_line_turns(i, j))
    last = Ray(lengths=v, left_turns=parent.side * sector.v_line_turns(i, j))
    fan = _fan([first, *inner, last], shares, parent.side)
    start = len(net.placed)
    new = [
        Placed(sector=s, side=side, parent=number, apex=apex, bearing=bearing)
        for s, side, bearing in fan
    ]
    outer = (
        NetSeam(
            first=number, path=_side(sector, "u", apex), second=start, onto=_side(fan[0][0], "u")
        ),
        NetSeam(
            first=number,
            path=_side(sector, "v", apex),
            second=start + count - 1,
            onto=_side(fan[-1][0], "v"),
        ),
    )
    placed = list(net.placed)
    placed[number] = replace(parent, cut=apex)
    return BranchedNet(
        placed=(*placed, *new), seams=(*net.seams, *_inner_seams(fan, start), *outer)
    )


def _parent(net: BranchedNet, number: int, apex: tuple[int, int]) -> Placed:
    """Sector to be cut; refuses one that is cut already, and a vertex that is not inside."""
    if not 0 <= whole_number(number, "the sector") < len(net.placed):
        raise SurgeryError(f"the net has no sector {number}")
    place = net.placed[number]
    n, m = place.sector.shape
    if not isinstance(apex, Sequence) or len(apex) != 2:
        raise SurgeryError(f"the apex {apex!r} is no vertex (i, j) of sector {number}")
    for index in apex:
        whole_number(index, "an index of the apex")
    if place.cut is not None:
        raise SurgeryError(f"sector {number} is cut at {place.cut} already: cut its daughters")
    if not (0 < apex[0] < n and 0 < apex[1] < m):
        raise SurgeryError(f"vertex {apex} is not inside sector {number} of {n} by {m} quads")
    return place
