"""Section 4.1: surgery on nets in the disk, by the printed formulas and by the nets of discrete."""

import math
from collections import Counter
from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.printed import amsler_disk, poincare_disk
from checks.printed.disk_net import ARRAYS, filled_disk
from discrete.branched_net import BranchedNet, Ray, geodesic_ray, star, surgery
from discrete.complex_surgery import attached, restricted
from discrete.errors import DiscreteError
from discrete.index import angle_sums
from discrete.placed_frames import placed_frames
from discrete.poincare_disk import to_disk
from discrete.sl2_frames import triple_of
from theory import daughter_sectors
from theory.quad_complex import interior_degrees
from theory.quad_surgery import replaced, square_grid

FloatArray = npt.NDArray[np.float64]
_SIZE, _CUT = 6, 3


def disk_angles(z: FloatArray) -> FloatArray:
    """Angles at the nodes (n, m) by (eq:angle)."""
    corners = tuple(z[:, :-1, :-1]), tuple(z[:, 1:, :-1]), tuple(z[:, :-1, 1:])
    return np.asarray(poincare_disk.angle(*corners, ARRAYS))


def disk_radii(z: FloatArray) -> FloatArray:
    """Distances of the nodes from the origin by (eq:hyp_radius)."""
    return np.asarray(poincare_disk.radius(np.hypot(z[0], z[1]), ARRAYS))


def amsler_disk_net(step: float, edges: int) -> FloatArray:
    """Nodes of a quadrant of the Amsler net with the angle pi/2, from the printed data."""
    k = np.arange(edges + 1)
    first, second = amsler_disk.boundary_data(k, k, step, ARRAYS)
    return filled_disk(np.array(first), np.array(second))


def disk_daughter(
    step: float,
    edges: int,
    count: int,
    *,
    weight: int = 2,
    divisor: int = 3,
    principal: bool = False,
) -> tuple[FloatArray, FloatArray]:
    """Distances and angles of the sector beside the parent's v-line, cut at node (edges, edges)."""
    z = amsler_disk_net(step, edges + count + 1)
    centre = tuple(z[:, edges, edges].tolist())
    away = (-centre[0], -centre[1])
    near = [tuple(z[:, edges + 1, edges].tolist()), tuple(z[:, edges, edges + 1].tolist())]
    moved = [poincare_disk.moebius((p[0], p[1]), away) for p in near]
    beta = [Fraction(math.atan2(w[1], w[0]) / math.pi) for w in moved]
    part = poincare_disk.trisecting(
        beta[1], beta[0], weight=weight, divisor=divisor, principal=principal
    )
    ray = poincare_disk.on_ray(np.arange(count + 1), step, float(part) * math.pi, ARRAYS)
    new = np.array(poincare_disk.moebius(ray, (centre[0], centre[1])))
    net = filled_disk(new, z[:, edges, edges : edges + count + 1])
    return disk_radii(net), disk_angles(net)


def three_equal(setting: Setting, *, principal: bool = True, divisor: int = 3) -> Evidence:
    """Whether (eq:trisect) divides the removed angle in three equal parts, in each quadrant.

    Exact, in units of pi: the removed angle is centred at the middle of each quadrant, as that of
    the example. principal: whether arg is taken in (-pi, pi].
    """
    del setting
    for quadrant in range(4):
        for opening in (Fraction(1, 2), Fraction(13, 25), Fraction(3, 4)):
            middle = Fraction(2 * quadrant + 1, 4)
            first, second = middle - opening / 2, middle + opening / 2
            options: dict[str, Any] = {"divisor": divisor, "principal": principal}
            one = poincare_disk.trisecting(first, second, **options)
            two = poincare_disk.trisecting(second, first, **options)
            parts = [one - first, two - one, second - two]
            if any((part - opening / 3) % 2 for part in parts):
                return statement(
                    False,
                    shown="",
                    witness=f"quadrant {quadrant + 1}, arguments {first} pi and {second} pi: the "
                    f"directions are {one} pi and {two} pi, not {first + opening / 3} pi and "
                    f"{second - opening / 3} pi",
                )
    return statement(
        True, shown="in all four quadrants the parts are a third of the angle", witness=""
    )


def cut_net(cuts: int = 4) -> BranchedNet:
    """Star of four quarter planes with the corner of the first `cuts` quadrants replaced."""
    net = star([geodesic_ray([0.1] * _SIZE)] * 4, [math.pi / 2] * 4)
    for quadrant in range(cuts):
        net = surgery(net, quadrant, (_CUT, _CUT))
    return net


def _by_quads(cuts: int) -> Counter[int]:
    """Interior degrees after the same surgeries on a grid of squares."""
    quads, centre = square_grid(2 * _SIZE, 2 * _SIZE), _SIZE
    for number, (a, b) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))[:cuts]):
        x, y = centre + a * _CUT, centre + b * _CUT
        wanted = {(x, y), (x + a, y), (x + a, y + b), (x, y + b)}
        quad = next(q for q in quads if set(q) == wanted)
        quads = replaced(quads, quad, (x, y), ray=_CUT, name=f"quadrant {number}")
    return Counter(interior_degrees(quads).values())


def branch_points(setting: Setting, *, cuts: int = 4, count: int = 4, degree: int = 6) -> Evidence:
    """Interior degrees after one cut in each quadrant, and angle sums there."""
    del setting
    net = cut_net(cuts)
    inside = ~net.complex.is_boundary
    degrees = Counter(net.complex.degree[inside].tolist())
    sums = angle_sums(net.complex, net.corner_angles)[inside]
    branched = {d: k for d, k in degrees.items() if d != 4}
    worst = float(np.abs(sums - 2 * math.pi).max())
    return combined(
        {
            "routes": statement(
                degrees == _by_quads(cuts), shown="", witness=f"{degrees} and {_by_quads(cuts)}"
            ),
            "branch points": statement(
                branched == {degree: count},
                shown="",
                witness=f"interior vertices of a degree other than 4: {branched}",
            ),
            "angle sums": Evidence(
                outcome="pass" if worst < 1e-9 else "fail",
                grade="numeric",
                digits=9,
                witness="" if worst < 1e-9 else f"an angle sum is off by {worst:.2g}",
            ),
        },
        shown=f"{count} interior vertices have degree {degree}, all others 4; all angle sums are "
        "2 pi",
    )


def _shells(complex_: Any, start: int) -> list[tuple[int, int, int]]:
    """Numbers of vertices, of their edges and of boundary vertices at each distance from one."""
    distance = np.full(complex_.vertex_count, -1)
    distance[start] = 0
    edges = complex_.edges
    for step in range(complex_.vertex_count):
        for a, b in ((0, 1), (1, 0)):
            reached = edges[(distance[edges[:, a]] == step), b]
            distance[reached[distance[reached] < 0]] = step + 1
    return [
        (
            int((distance == k).sum()),
            int(complex_.degree[distance == k].sum()),
            int(complex_.is_boundary[distance == k].sum()),
        )
        for k in range(int(distance.max()) + 1)
    ]


def surgery_lemma(setting: Setting, *, rays: int = 2, length: int = _CUT) -> Evidence:
    """Whether the complex of the cut net is that of the surgery lemma, by its shells of vertices.

    The lemma attaches three rectangles at the corner of the complex from which the quadrant is cut
    out. rays: new ones in the lemma; length: of them.
    """
    del setting
    plain, net = cut_net(0), cut_net(1)
    numbers = [place[_CUT, _CUT] for place in (plain.places[0], net.places[0])]
    keep = np.ones(len(plain.complex.faces), dtype=np.bool_)
    keep[: _SIZE * _SIZE] = net.placed[0].kept.ravel()
    part, place = restricted(plain.complex, keep)
    made, moved = attached(part, int(place[numbers[0]]), [length] * rays)
    apex = int(moved[place[numbers[0]]])
    one, other = _shells(net.complex, int(numbers[1])), _shells(made, apex)
    return combined(
        {
            "shells": statement(
                one == other, shown="", witness=f"shells (vertices, edges, boundary) {one} in the "
                f"disk, {other} in the lemma",
            ),
            "interior": statement(
                not bool(made.is_boundary[apex]), shown="", witness="q is on the boundary"
            ),
            "disk": statement(net.complex.is_disk, shown="", witness="no disk"),
        },
        shown="both complexes are disks with equal shells of vertices about q, which is inside",
    )  # fmt: skip


def free_curves(setting: Setting, *, rays: int = 2, stretch: str = "1") -> Evidence:
    """Whether any two polylines with edges Delta that divide the removed angle give a net.

    rays: new curves; stretch: length of the edges of the first new curve over Delta.
    """
    rng = np.random.default_rng(setting.random().getrandbits(32))
    parity = daughter_sectors.closes(rays + 1)
    step, worst, tried = 0.1, 0.0, 20
    for _ in range(tried):
        plain = cut_net(0)
        count = _SIZE - _CUT
        shares = rng.dirichlet([4.0] * (rays + 1)) * plain.placed[0].sector.angles[_CUT, _CUT]
        new = [
            Ray(
                lengths=np.full(count, step * (float(Fraction(stretch)) if k == 0 else 1.0)),
                left_turns=rng.uniform(-0.05, 0.05, count - 1),
            )
            for k in range(rays)
        ]
        try:
            net = surgery(plain, 0, (_CUT, _CUT), rays=new, angles=shares.tolist())
        except DiscreteError as refusal:
            return statement(False, shown="", witness=f"{rays} new curves: {refusal}")
        worst = max(worst, _defect(net))
    fine = parity and worst < 1e-10
    return Evidence(
        outcome="pass" if fine else "fail",
        grade="numeric",
        residual=f"{worst:.1g}",
        digits=10,
        tried=tried,
        met=tried,
        shown="with two random polylines the sectors fit along their lines and every quad "
        "satisfies (poincare-ddg)",
        witness="" if fine else f"a vertex is off by {worst:.2g} in the disk",
    )


def _defect(net: BranchedNet) -> float:
    """Largest gap along a seam, and of a far vertex from that of (poincare-ddg)."""
    worst = 0.0
    places = [np.array(to_disk(triple_of(tuple(g)))) for g in placed_frames(net)]
    for seam in net.seams:
        for one, other in zip(seam.path, seam.onto, strict=True):
            gap = places[seam.first][:, one[0], one[1]] - places[seam.second][:, other[0], other[1]]
            worst = max(worst, float(np.abs(gap).max()))
    for z in places:
        corners = tuple(z[:, :-1, :-1]), tuple(z[:, 1:, :-1]), tuple(z[:, :-1, 1:])
        far = np.array(poincare_disk.closed(*corners, ARRAYS))
        worst = max(worst, float(np.abs(far - z[:, 1:, 1:]).max()))
    return worst
