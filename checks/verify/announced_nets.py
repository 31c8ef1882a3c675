"""What introduction and discussion announce of nets: surgery, topology, classes, no stretching."""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import sympy as sp
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.verify import convergence
from checks.verify import geometric_nets as nets
from checks.verify.geometric_nets import Cut, Recipe
from checks.verify.net_topology import given_complex
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.branched_net import BranchedNet, geodesic_ray, star
from discrete.complex_maps import isomorphism
from discrete.geodesics import distance
from discrete.index import interior_vertices, normal_winding
from discrete.k_surface import k_surface
from discrete.space_forms import H2, Triple
from theory import star_saddle

_ROUNDING = 1e-10


def _winding_at(net: BranchedNet, vertex: int) -> int:
    inside = interior_vertices(net.complex)
    found = normal_winding(net.complex, k_surface(net).normals)
    return int(found[inside == vertex][0])


def surgery_adds(setting: Setting, *, gained: int = 1, kept: bool = True) -> Evidence:
    """Surgeries one after the other: the new branch points, and what is left of the surface.

    gained: branch points that each adds; kept: whether the rest of the surface is to stay.
    """
    del setting
    done = 0
    for recipe in nets.LARGE:
        for n, cut in enumerate(recipe.cuts):
            before = nets.float_net(replace(recipe, cuts=recipe.cuts[:n]))
            after = nets.float_net(replace(recipe, cuts=recipe.cuts[: n + 1]))
            old = int(before.places[cut.sector][cut.apex])
            new = int(after.places[cut.sector][cut.apex])
            turns = _winding_at(before, old), _winding_at(after, new)
            more = len(after.complex.branch_points) - len(before.complex.branch_points)
            surfaces = k_surface(before), k_surface(after)
            gap = 0.0
            for one, other in zip(before.places, after.places, strict=False):
                common = (one >= 0) & (other >= 0)
                moved = surfaces[1].points[other[common]] - surfaces[0].points[one[common]]
                gap = max(gap, float(np.abs(moved).max()))
            done += 1
            expected = (-1, -1 - (cut.inserted - 1) // 2)
            if more != gained or turns != expected or (gap > _ROUNDING) == kept:
                return Evidence(
                    outcome="fail",
                    grade="numeric",
                    witness=f"a surgery with {cut.inserted} sectors adds {more} branch points, the "
                    f"index goes from {turns[0]} to {turns[1]}, the rest moves by {gap:.1e}",
                )
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=10,
        tried=done,
        met=done,
        shown="each surgery with 2k + 1 sectors turns one point of index -1 into a branch point of "
        "index -1 - k, k = 1, 2 or 3, and leaves the rest of the surface where it was",
    )


def complex_from_places(corners: list[tuple[Triple, ...]], *, digits: int = 8) -> AsymptoticComplex:
    """Complex of quads in the disk whose corners are one vertex where they are at one place."""
    flat = np.array([corner for face in corners for corner in face], dtype=np.float64)
    _, numbers = np.unique(np.round(flat, digits) + 0.0, axis=0, return_inverse=True)
    return AsymptoticComplex(faces=numbers.reshape(-1, 4))


def encodes_complex(setting: Setting, *, digits: int = 8, dropped: int = 0) -> Evidence:
    """Whether the places of the quads in the disk alone give back the complex.

    digits: to which places are compared; dropped: surgeries that the complex given lacks.
    """
    del setting
    for number, recipe in enumerate(nets.LARGE):
        net = nets.float_net(recipe)
        nodes = nets.sector_nodes(recipe, math, float(recipe.edge_length))
        corners = nets.face_corners(net, nodes)
        wanted = given_complex(replace(recipe, cuts=recipe.cuts[: len(recipe.cuts) - dropped]))
        try:
            found = complex_from_places(corners, digits=digits)
            images = isomorphism(found, wanted)
            told = "not isomorphic to the one given"
        except ValueError as error:
            images, told = None, str(error)
        if images is None:
            return Evidence(
                outcome="fail",
                grade="numeric",
                witness=f"net {number}: the complex of the places is {told}",
            )
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=digits,
        tried=len(nets.LARGE),
        met=len(nets.LARGE),
        shown="quads of the disk with their corners identified by place give back the complexes "
        "made by combinatorial surgery, with branch points of orders 3 to 5",
    )


_STARS = {
    "smooth, right angles": ("1/2",) * 4,
    "smooth, skew": ("1/3", "2/3", "1/3", "2/3"),
    "four sectors, kinked": ("1/3", "1/2", "2/3", "1/2"),
    "monkey": ("1/3",) * 6,
    "order 3, unequal": ("1/3", "1/4", "5/12", "1/3", "1/4", "5/12"),
    "order 4": ("1/4",) * 8,
    "order 5": ("1/5",) * 10,
}


def distinguishes(setting: Setting, *, least: int = 6) -> Evidence:
    """Degree at the centre of nets, and whether the saddle over the star there is of class C^2.

    least: degree from which a net is taken for one with a branch point, whose index is not -1.
    """
    del setting
    wrong = []
    for name, shares in _STARS.items():
        angles = tuple(sp.Rational(share) * sp.pi for share in shares)
        rays = [geodesic_ray(np.full(2, 0.1))] * len(angles)
        complex_ = star(rays, [float(angle) for angle in angles]).complex
        degree = int(complex_.degree[~complex_.is_boundary].max())
        smooth = all(star_saddle.hessian_jump(angles, i) == 0 for i in range(len(angles)))
        branched = star_saddle.winding_number(angles) != -1
        if (degree >= least) != branched or (smooth and degree >= least):
            told = (
                "of class C^2" if smooth else "with a branch point" if branched else "of index -1"
            )
            wrong.append(f"{name}: degree {degree}, {told}")
    return Evidence(
        outcome="fail" if wrong else "pass",
        grade="exact",
        residual="" if wrong else "0",
        tried=len(_STARS),
        met=len(_STARS),
        witness="; ".join(wrong),
        shown="the degree at the centre of the net is above 4 exactly for the saddles of index "
        "below -1, none of which is C^2; the C^2 ones have degree 4, as has a C^{1,1} one without "
        "branch point",
    )


def _strain_at_branch_points(recipe: Recipe) -> float:
    """Largest relative change of a diagonal of the quads at branch points, from H^2 to space."""
    net = nets.float_net(recipe)
    corners = nets.face_corners(net, nets.sector_nodes(recipe, math, float(recipe.edge_length)))
    touching = np.isin(net.complex.faces, net.complex.branch_points).any(axis=1)
    points = k_surface(net).points[net.complex.faces]
    found = 0.0
    for face in np.flatnonzero(touching).tolist():
        for a, b in ((0, 2), (1, 3)):
            straight = float(np.linalg.norm(points[face, a] - points[face, b]))
            found = max(
                found, abs(straight / distance(H2, math, corners[face][a], corners[face][b]) - 1)
            )
    return found


def no_stretching(setting: Setting, *, order: int = 2) -> Evidence:
    """Order in the edge length of the strain of the quads that touch a branch point."""
    del setting
    counts = (3, 6, 12, 24)
    levels = [
        Recipe(
            order=3,
            edge_length=Fraction(3, 5 * n),
            edges=n,
            cuts=(Cut(sector=1, apex=(n // 3, n // 3), inserted=5),),
        )
        for n in counts
    ]
    return convergence.order(
        [mp.mpf(1) / n for n in counts],
        [mp.mpf(_strain_at_branch_points(recipe)) for recipe in levels],
        order,
        digits=10,
        shown="at branch points of the orders 3 and 4 quads are strained, from H^2 to space, in "
        "proportion to the square of their size, so that the stretching energy there vanishes in "
        "the limit",
    )
