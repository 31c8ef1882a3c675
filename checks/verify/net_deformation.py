"""Section 4.1: the deformation from the net in the disk to the surface, and its isometry."""

import math
from fractions import Fraction

import numpy as np
import numpy.typing as npt
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.verify import convergence
from checks.verify import geometric_nets as nets
from checks.verify.geometric_nets import Recipe, Rows
from checks.verify.planar_stars import angles_in_disk, angles_in_space
from discrete.branched_net import BranchedNet
from discrete.geodesics import distance
from discrete.hamburger import polygon_around
from discrete.k_surface import k_surface
from discrete.lelieuvre import lelieuvre_surface
from discrete.space_forms import H2

FloatArray = npt.NDArray[np.float64]

_ROUNDING = 1e-10
_FOLDED = Recipe(order=2, edge_length=Fraction(1, 5), edges=10)
"""Amsler net of angle pi/2 beyond its singular edge."""


def vertex_places(net: BranchedNet, nodes: list[Rows]) -> tuple[FloatArray, float]:
    """Triples of the vertices, an array (vertices, 3), and how far sectors differ on seams."""
    found = np.full((net.complex.vertex_count, 3), np.nan)
    gap = 0.0
    for place, rows in zip(net.places, nodes, strict=True):
        kept = place >= 0
        triples = np.array(rows, dtype=np.float64)[kept]
        known = np.abs(found[place[kept]] - triples)
        gap = max(gap, float(np.nanmax(known, initial=0.0)))
        found[place[kept]] = triples
    return found, gap


def crossing_edges(polygon: FloatArray) -> int:
    """Number of pairs of edges of a closed polygon in the plane that cross, neighbours apart."""
    ends = np.roll(polygon, -1, axis=0)

    def turn(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
        one, other = b - a, c - a
        return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])

    first, last = polygon[:, np.newaxis], ends[:, np.newaxis]
    apart = turn(first, last, polygon[np.newaxis]) * turn(first, last, ends[np.newaxis]) < 0
    return int((apart & apart.T).sum()) // 2


def _not_injective(net: BranchedNet, places: FloatArray, angles: FloatArray) -> str:
    """What keeps zeta from being one-to-one, or nothing.

    Quads of one orientation, angles of sum 2 pi inside and a simple boundary make it a
    homeomorphism onto a disk; geodesics are straight in the projective view.
    """
    orientation = net.complex.orientation
    if orientation is None:
        return "the complex has no orientation"
    signed = angles * orientation[:, np.newaxis] * np.sign(angles[0, 0])
    folded = np.flatnonzero((signed <= 0).any(axis=1))
    if len(folded):
        corners = np.round(signed[folded[0]], 3).tolist()
        return f"{len(folded)} quads are flipped, one with the signed angles {corners}"
    sums = np.bincount(net.complex.faces.ravel(), signed.ravel())
    off = np.abs(sums - 2 * np.pi)[~net.complex.is_boundary].max()
    if off > _ROUNDING:
        return f"the angles around a vertex miss 2 pi by {off:.3g}"
    rim = polygon_around(net.complex, np.ones(len(net.complex.faces), dtype=np.bool_)).path
    crossings = crossing_edges(places[rim, 1:] / places[rim, :1])
    return f"its boundary crosses itself {crossings} times" if crossings else ""


def _deviations(net: BranchedNet, places: FloatArray, angles: FloatArray) -> dict[str, float]:
    """Deviations of angles and of edge lengths, these up to one factor, under y = r o zeta^-1."""
    surface = k_surface(net, route=lelieuvre_surface)
    edges = net.complex.edges
    ratios = [
        float(np.linalg.norm(vector)) / distance(H2, math, tuple(places[a]), tuple(places[b]))
        for (a, b), vector in zip(edges.tolist(), surface.edge_vectors(), strict=True)
    ]
    return {
        "ratio of lengths": max(ratios) / min(ratios) - 1,
        "angle": float(np.abs(angles_in_space(surface) - angles).max()),
        "place of a common vertex in space": surface.mismatch,
    }


def composite(setting: Setting, *, folded: bool = False, percent: int = 100) -> Evidence:
    """Whether y = r o zeta^-1 is defined and isometric on five nets, vertex by vertex.

    folded: whether a net beyond its singular edge is among them; percent: of the angle of a
    corner that y is to preserve.
    """
    del setting
    recipes = (*nets.LARGE, _FOLDED) if folded else nets.LARGE
    worst = 0.0
    for number, recipe in enumerate(recipes):
        net = nets.float_net(recipe)
        nodes = nets.sector_nodes(recipe, math, float(recipe.edge_length))
        places, gap = vertex_places(net, nodes)
        angles = angles_in_disk(nets.face_corners(net, nodes))
        found = _deviations(net, places, angles * percent / 100)
        found["place of a common vertex in the disk"] = gap
        wrong = [f"{name} off by {value:.3g}" for name, value in found.items() if value > _ROUNDING]
        if problem := _not_injective(net, places, angles):
            wrong.insert(0, f"zeta is not one-to-one: {problem}")
        if wrong:
            return Evidence(
                outcome="fail",
                grade="numeric",
                tried=number + 1,
                met=number + 1,
                witness=f"net {number}: {wrong[0]}",
            )
        worst = max(worst, *found.values())
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=10,
        residual=f"{worst:.1e}",
        tried=len(recipes),
        met=len(recipes),
        shown="on five nets with up to four branch points zeta is one-to-one on the disk that the "
        "complex is, and y takes the quads between triples of H^2 to those of Lelieuvre's surface "
        "with the same signed angles and one ratio of all edges",
    )


def _diagonals(recipe: Recipe) -> float:
    """Largest relative change of a diagonal of a quad under y."""
    net = nets.float_net(recipe)
    nodes = nets.sector_nodes(recipe, math, float(recipe.edge_length))
    places, _ = vertex_places(net, nodes)
    points = k_surface(net).points
    pairs = np.concatenate([net.complex.faces[:, [0, 2]], net.complex.faces[:, [1, 3]]]).tolist()
    changes = (
        abs(
            float(np.linalg.norm(points[a] - points[b]))
            / distance(H2, math, tuple(places[a]), tuple(places[b]))
            - 1
        )
        for a, b in pairs
    )
    return float(max(changes))


def limit(setting: Setting, *, order: int = 2) -> Evidence:
    """Order in the edge length of the relative change of lengths, the diagonals of the quads."""
    del setting
    counts = (3, 6, 12, 24)
    levels = [
        Recipe(
            order=3,
            edge_length=Fraction(3, 5 * n),
            edges=n,
            cuts=(nets.Cut(sector=1, apex=(n // 3, n // 3)),),
        )
        for n in counts
    ]
    return convergence.order(
        [mp.mpf(1) / n for n in counts],
        [mp.mpf(_diagonals(recipe)) for recipe in levels],
        order,
        digits=10,
        shown="diagonals of the quads of a net with two branch points keep their lengths up to "
        "the square of the edge length",
    )
