"""Section 4.1: nets in the disk that have the topology of a complex, and their branch points."""

import math

import numpy as np

from checks.evidence import Evidence, Setting
from checks.printed import hyperbolic_nets as printed
from checks.printed import poincare_disk as printed_disk
from checks.verify import geometric_nets as nets
from checks.verify.geometric_nets import Recipe
from checks.verify.net_deformation import vertex_places
from checks.verify.planar_stars import angles_in_disk
from discrete import complex_surgery, gluing, poincare_disk
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.branched_net import BranchedNet
from discrete.complex_maps import isomorphism
from discrete.geodesics import distance
from discrete.index import normal_winding
from discrete.k_surface import k_surface
from discrete.space_forms import H2, Triple

_ROUNDING = 1e-10


def given_complex(recipe: Recipe) -> AsymptoticComplex:
    """Complex by combinatorial surgery alone: no length, no angle, no sector of a net."""
    complex_ = gluing.star([recipe.edges] * (2 * recipe.order))
    for n, cut in enumerate(recipe.cuts):
        before = nets.float_net(
            Recipe(
                order=recipe.order,
                edge_length=recipe.edge_length,
                edges=recipe.edges,
                cuts=recipe.cuts[:n],
            )
        )
        images = isomorphism(before.complex, complex_)
        if images is None:
            raise ValueError(f"after {n} surgeries net and complex are not isomorphic")
        place, (i, j) = before.places[cut.sector], cut.apex
        corners = images[[place[i, j], place[i + 1, j], place[i + 1, j + 1], place[i, j + 1]]]
        sought = np.sort(corners)
        face = int(np.flatnonzero((np.sort(complex_.faces, axis=1) == sought).all(axis=1))[0])
        along_u, along_v = (count - at - 1 for count, at in zip(place.shape, (i, j), strict=True))
        lengths = [(along_v, along_u)[k % 2] for k in range(cut.inserted - 1)]
        complex_, _ = complex_surgery.surgery(complex_, int(corners[0]), face, lengths)
    return complex_


def _quad_defect(corners: tuple[Triple, ...], length: float, weight: str) -> float:
    """How far a face is from a rhombus of this side that (poincare-ddg) closes."""
    z = [poincare_disk.to_disk(p) for p in corners]
    closed = printed_disk.closed(z[0], z[1], z[3], math, weight=weight)
    sides = [distance(H2, math, corners[k - 1], corners[k]) - length for k in range(4)]
    return float(max(math.dist(closed, z[2]), *(abs(side) for side in sides)))


def _faults(net: BranchedNet, recipe: Recipe, last_edge: float, weight: str) -> list[str]:
    """What keeps the disk's net from being a hyperbolic Chebyshev net on the complex."""
    length = float(recipe.edge_length)
    nodes = nets.sector_nodes(recipe, math, length, last_edge=last_edge)
    corners = nets.face_corners(net, nodes)
    found = []
    if (gap := vertex_places(net, nodes)[1]) > _ROUNDING:
        found.append(f"two sectors put a common vertex {gap:.3g} apart")
    if (defect := max(_quad_defect(c, length, weight) for c in corners)) > _ROUNDING:
        found.append(f"a face is no rhombus closed by (poincare-ddg): off by {defect:.3g}")
    orientation = net.complex.orientation
    angles = angles_in_disk(corners) * (1 if orientation is None else orientation[:, np.newaxis])
    if not ((angles > 0).all() or (angles < 0).all()):
        found.append("quads of both orientations: a reversal")
    sums = np.bincount(net.complex.faces.ravel(), np.abs(angles).ravel())
    if (off := np.abs(sums - 2 * np.pi)[~net.complex.is_boundary].max()) > _ROUNDING:
        found.append(f"the angles around a vertex miss 2 pi by {off:.3g}")
    return found


def inherited(
    setting: Setting, *, last_edge: int = 100, weight: str = "1", branched: bool = True
) -> Evidence:
    """Nets from equally spaced boundary data, quad by quad, on complexes given beforehand.

    last_edge: percent of Delta for the last edge of new curves; weight: of |w_1 w_2| in the rule;
    branched: whether the complex has the surgeries that the net has.
    """
    del setting
    for number, recipe in enumerate(nets.LARGE):
        net = nets.float_net(recipe)
        plain = Recipe(order=2, edge_length=recipe.edge_length, edges=recipe.edges)
        complex_ = given_complex(recipe if branched else plain)
        images = isomorphism(net.complex, complex_)
        if images is None:
            wrong = ["no isomorphism of the complex of the net and the one given"]
        else:
            order = complex_.saddle_order[images]
            same = bool((order == net.complex.saddle_order).all())
            wrong = [] if same else ["a branch point has another order"]
            wrong += _faults(net, recipe, last_edge / 100, weight)
        if wrong:
            return Evidence(
                outcome="fail",
                grade="numeric",
                tried=number + 1,
                met=number + 1,
                witness=f"complex {number}: {wrong[0]}",
            )
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=10,
        tried=len(nets.LARGE),
        met=len(nets.LARGE),
        shown="five complexes made by combinatorial surgery, with up to four branch points of "
        "orders 3 to 5, carry nets of rhombi in the disk, closed by (poincare-ddg), with angles "
        "of sum 2 pi inside and no reversal, and are isomorphic to the complexes of the nets",
    )


def _opened(complex_: AsymptoticComplex, vertex: int) -> tuple[AsymptoticComplex, int]:
    """Complex without one face at a vertex, which so lies on the boundary; its new number."""
    keep = np.ones(len(complex_.faces), dtype=np.bool_)
    keep[np.flatnonzero((complex_.faces == vertex).any(axis=1))[0]] = False
    rest, place = complex_surgery.restricted(complex_, keep)
    return rest, int(place[vertex])


def _misjudged(net: BranchedNet, least: int, interior: bool) -> list[str]:
    """Vertices of a net at which the definition and the normal in space disagree."""

    def named(complex_: AsymptoticComplex, vertex: int) -> bool:
        return printed.is_branch_point(
            int(complex_.degree[vertex]),
            not bool(complex_.is_boundary[vertex]),
            least=least,
            interior=interior,
        )

    complex_ = net.complex
    inside = np.flatnonzero(~complex_.is_boundary)
    winding = normal_winding(complex_, k_surface(net).normals)
    found = []
    for vertex, turns in zip(inside.tolist(), winding.tolist(), strict=True):
        if named(complex_, vertex) != (turns != -1):
            degree = int(complex_.degree[vertex])
            found.append(f"degree {degree}, where the normal winds {turns} times")
        if turns == -1:
            continue
        rest, place = _opened(complex_, vertex)
        if named(rest, place):
            found.append(f"a boundary vertex of degree {int(rest.degree[place])}")
    return found


def branch_points(setting: Setting, *, least: int = 6, interior: bool = True) -> Evidence:
    """Whether the definition names the vertices about which the normal winds other than -1 times.

    least: degree of a branch point; interior: whether it has to lie inside. Near misses: the
    regular vertices, and the branch points after one of their quads is taken away.
    """
    del setting
    count = 0
    for recipe in nets.LARGE:
        net = nets.float_net(recipe)
        if wrong := _misjudged(net, least, interior):
            return Evidence(outcome="fail", grade="numeric", witness=wrong[0])
        count += len(net.complex.branch_points)
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=10,
        tried=len(nets.LARGE),
        met=len(nets.LARGE),
        shown=f"on five nets it names {count} vertices, those about which the normal of the "
        "K-surface winds 1 - m < -1 times, and refuses regular vertices and vertices of degree 6 "
        "or more on a boundary",
    )
