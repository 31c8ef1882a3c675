"""Section 4.1, remark on ramification: sheets of K-surfaces at the vertices of hyperbolic nets."""

import math
from collections.abc import Iterator
from fractions import Fraction

import numpy as np
import numpy.typing as npt
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed.reversals import QUADS
from checks.verify.disk_surgery import cut_net
from checks.verify.reversals import Pair, Star, line_fold, signed_stars
from discrete.branched_net import BranchedNet, regular_star, surgery
from discrete.geodesics import angle_at
from discrete.index import angle_sums, interior_vertices, normal_winding
from discrete.k_surface import KSurface, k_surface
from discrete.poincare_disk import from_disk
from discrete.space_forms import H2
from theory import star_saddle

FloatArray = npt.NDArray[np.float64]


def _direction(centre: Pair, z: Pair) -> float:
    """Direction at the node of the geodesic to another point, in units of a turn."""
    x, y = (float(part) for part in z)
    a, b = (float(part) for part in centre)
    moved = (complex(x, y) - complex(a, b)) / (1 - complex(x, y) * complex(a, -b))
    return math.atan2(moved.imag, moved.real)


def _covered(centre: Pair, star: Star, quads: int) -> set[int]:
    """Numbers of quads over the directions at a node, which the rays of the star divide."""
    rays = {at: _direction(centre, z) for at, z in star.items()}
    cuts = sorted(set(rays.values()))
    found = set()
    for k, low in enumerate(cuts):
        high = cuts[k + 1] if k + 1 < len(cuts) else cuts[0] + 2 * math.pi
        middle, count = (low + high) / 2, 0
        for p, q in QUADS[:quads]:
            one, width = rays[p, 0], math.remainder(rays[0, q] - rays[p, 0], 2 * math.pi)
            place = math.remainder(middle - one, 2 * math.pi)
            count += (0 < place < width) if width > 0 else (width < place < 0)
        if high - low > 1e-9:
            found.add(count)
    return found


def single_sheet(setting: Setting, *, folds: str = "allowed", quads: int = 4) -> Evidence:
    """Whether four quads with angle sum 2 pi at a node cover each direction once.

    folds: `allowed`, as printed, or `excluded`: all quads have the orientation of the net.
    """
    met = tried = 0
    for centre, star, signs in [line_fold(), *signed_stars(setting)]:
        tried += 1
        at = from_disk(tuple(map(float, centre)))
        ends = {key: from_disk(tuple(map(float, z))) for key, z in star.items()}
        angles = [abs(angle_at(H2, math, at, ends[p, 0], ends[0, q])) for p, q in QUADS]
        alike = len(set(signs)) == 1 and 0 not in signs
        if abs(sum(angles) - 2 * math.pi) > 1e-9 or (folds == "excluded" and not alike):
            continue
        if 0 in signs:
            continue
        met += 1
        if (covered := _covered(centre, star, quads)) != {1}:
            around = ", ".join(f"{key}: ({z[0]}, {z[1]})" for key, z in star.items())
            return statement(
                False,
                shown="",
                witness=f"node ({centre[0]}, {centre[1]}), neighbours {around}: the four angles "
                f"add up to 2 pi, yet the directions there lie in {sorted(covered)} quads",
            )
    return Evidence(
        outcome="pass" if met else "undecided",
        grade="numeric",
        digits=9,
        tried=tried,
        met=met,
        shown="where the quads are oriented alike and their angles add up to 2 pi, each direction "
        "lies in one of them",
    )


def _nets() -> Iterator[tuple[str, BranchedNet]]:
    for order in (2, 3, 4, 6):
        yield f"star of order {order}", regular_star(order, edge_length=0.1, edges=5)
    once = cut_net(4)
    yield "four cuts", once
    yield "a cut in a daughter", surgery(once, 4, (1, 1))


def _space_angles(surface: KSurface) -> FloatArray:
    """Angles between the edges of each face in space at its corners, an array (faces, 4)."""
    at = surface.points[surface.complex.faces]
    ahead = np.roll(at, -1, axis=1) - at
    behind = np.roll(at, 1, axis=1) - at
    cross = np.linalg.norm(np.cross(ahead, behind), axis=2)
    return np.asarray(np.arctan2(cross, np.einsum("fki,fki->fk", ahead, behind)))


def surfaces(setting: Setting, *, turns: int = 2, stretch: str = "0") -> Evidence:
    """Angle sums in space of K-surfaces from normals: 2 pi inside, less on the boundary.

    The angles are those of the hyperbolic net. turns: sum inside in units of pi; stretch: share by
    which the surface is stretched along an axis before it is measured.
    """
    del setting
    worst, tried = 0.0, 0
    for name, net in _nets():
        surface = k_surface(net)
        points = surface.points * np.array([1.0, 1.0, 1.0 + float(Fraction(stretch))])
        surface = KSurface(
            complex=surface.complex, points=points, normals=surface.normals, mismatch=0.0
        )
        angles = _space_angles(surface)
        sums = angle_sums(net.complex, angles)
        inside = ~net.complex.is_boundary
        gap = max(
            float(np.abs(sums[inside] - turns * math.pi).max()),
            float(np.abs(angles - net.corner_angles).max()),
        )
        worst, tried = max(worst, gap), tried + net.complex.vertex_count
        if gap > 1e-9 or float(sums[~inside].max()) >= 2 * math.pi:
            return Evidence(
                outcome="fail", grade="numeric", digits=9, tried=tried, met=tried,
                witness=f"{name}: an angle or its sum is off by {gap:.2g}; the largest sum on the "
                f"boundary is {float(sums[~inside].max()):.4f}",
            )  # fmt: skip
    return Evidence(
        outcome="pass", grade="numeric", digits=9, residual=f"{worst:.0e}", tried=tried, met=tried,
        shown="K-surfaces made from their normals on the sphere have at each vertex the angles of "
        "the hyperbolic net, with sum 2 pi inside, also at branch points, and less outside",
    )  # fmt: skip


def normals(setting: Setting, *, shift: int = 1, orders: str = "branched") -> Evidence:
    """Winding of the normals about that of a vertex: 1 - m, against the smooth star.

    shift: the claim is m - shift; orders: `branched`, or `all`, with the plain saddle.
    """
    del setting
    tried = 0
    for order in (3, 4, 5, 6) if orders == "branched" else (2, 3):
        net = regular_star(order, edge_length=0.1, edges=3)
        surface = k_surface(net)
        winding = normal_winding(net.complex, surface.normals)
        inside = interior_vertices(net.complex)
        found = (
            int(winding[net.complex.saddle_order[inside] == order][0])
            if order > 2
            else int(winding[0])
        )
        smooth = star_saddle.winding_number((sp.pi / order,) * (2 * order))
        tried += 1
        if abs(found) != order - shift or found != smooth or abs(found) < 2:
            return statement(
                False, shown="", witness=f"degree {2 * order}: the normals wind {found} times, "
                f"those of the smooth star {smooth} times",
            )  # fmt: skip
    return Evidence(
        outcome="pass", grade="numeric", digits=12, tried=tried, met=tried,
        shown="about a vertex of degree 2m the normals wind 1 - m times, for m = 3, ..., 6, as "
        "about the smooth star",
    )  # fmt: skip
