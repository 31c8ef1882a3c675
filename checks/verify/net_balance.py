"""Balance of charges on geometric nets: angles without coordinates against areas without angles."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb, ctx, fmpq

from checks.evidence import Evidence, Setting
from checks.verify import geometric_nets as nets
from checks.verify.asymptotic_complexes_samples import generator
from checks.verify.geometric_nets import Recipe
from discrete.complex_errors import PolygonError
from discrete.elementary import ball_functions
from discrete.face_regions import grown_disk
from discrete.hamburger import HamburgerPolygon, polygon_around
from discrete.space_forms import Scalar

_BITS = 256
_WIDEST = arb(10) ** -40
_ROUNDING = 1e-11  # some thousand roundings in triples up to distance 3


@dataclass(frozen=True, kw_only=True)
class _Side:
    """What a mutant changes: order without charge, where the sum runs, sign, percent of area."""

    regular: int
    corners: bool
    sign: int
    percent: int


def _polygons(recipe: Recipe, rng: np.random.Generator, count: int) -> Iterator[HamburgerPolygon]:
    """Boundary of the net, and of random disks of its faces around random faces."""
    complex_ = nets.float_net(recipe).complex
    faces = len(complex_.faces)
    for size in (faces, *rng.integers(faces // 2, faces, size=count).tolist()):
        try:
            start = int(rng.integers(faces))
            yield polygon_around(complex_, grown_disk(complex_, start, size, rng))
        except PolygonError:
            continue


def _balance(
    polygon: HamburgerPolygon, angles: Any, areas: Sequence[Scalar], pi: Scalar, side: _Side
) -> Scalar:
    """Sum of pi q/2 - Theta less area and charges."""
    rim = set((polygon.corners if side.corners else polygon.path).tolist())
    inside = np.flatnonzero(polygon.inside).tolist()
    residual = pi * int(polygon.quads[sorted(rim)].sum()) / 2
    for face in inside:
        for corner, vertex in enumerate(polygon.complex.faces[face].tolist()):
            if vertex in rim:
                residual -= angles[face][corner]
        residual -= side.percent * areas[face] / 100
    orders = polygon.complex.saddle_order[polygon.enclosed_vertices]
    return residual - side.sign * int((orders - side.regular).sum()) * pi


def _witness(polygon: HamburgerPolygon, residual: str) -> str:
    return (
        f"polygon of {len(polygon.path)} vertices around {int(polygon.inside.sum())} quads and "
        f"{len(polygon.enclosed_branch_points)} branch points: left minus right is {residual}"
    )


def floats(
    setting: Setting, *, regular: int = 2, corners: bool = False, sign: int = -1, percent: int = 100
) -> Evidence:
    """Balance on five nets of up to four branch points, in float64 with the shipped angles."""
    side = _Side(regular=regular, corners=corners, sign=sign, percent=percent)
    rng, worst, tried, several = generator(setting), 0.0, 0, 0
    for recipe in nets.LARGE:
        net = nets.float_net(recipe)
        nodes = nets.sector_nodes(recipe, math, float(recipe.edge_length))
        areas = nets.quad_areas(math, nets.face_corners(net, nodes))
        for polygon in _polygons(recipe, rng, 12):
            tried += 1
            several += len(polygon.enclosed_branch_points) > 1
            residual = _balance(polygon, net.corner_angles, areas, math.pi, side)
            worst = max(worst, abs(residual))
            if abs(residual) > _ROUNDING:
                return Evidence(
                    outcome="fail",
                    grade="numeric",
                    tried=tried,
                    met=tried,
                    residual=f"{abs(residual):.1e}",
                    witness=_witness(polygon, f"{residual:.6g}"),
                )
    return Evidence(
        outcome="pass" if several else "undecided",
        grade="numeric",
        digits=11,
        residual=f"{worst:.1e}",
        tried=tried,
        met=tried,
        shown="boundary sum of the angles advanced without coordinates equals the areas of "
        f"geodesic triangles less the charges; {several} polygons enclose two branch points or "
        "more",
    )


def balls(
    setting: Setting, *, regular: int = 2, corners: bool = False, sign: int = -1, percent: int = 100
) -> Evidence:
    """Balance on three small nets in balls: areas of triangles by their vertices alone."""
    side = _Side(regular=regular, corners=corners, sign=sign, percent=percent)
    rng, widest, tried, charged = generator(setting), arb(0), 0, 0
    with ctx.workprec(_BITS):
        functions = ball_functions()
        for recipe in nets.SMALL:
            net = nets.float_net(recipe)
            length = arb(fmpq(recipe.edge_length.numerator, recipe.edge_length.denominator))
            sectors = nets.sector_angles(recipe, functions, length)
            angles = nets.corner_angles(net, sectors, arb.pi())
            nodes = nets.sector_nodes(recipe, functions, length)
            areas = nets.quad_areas(functions, nets.face_corners(net, nodes))
            for polygon in _polygons(recipe, rng, 6):
                tried += 1
                charged += len(polygon.enclosed_branch_points) > 0
                residual = _balance(polygon, angles, areas, arb.pi(), side)
                if residual != 0:
                    return Evidence(
                        outcome="fail",
                        grade="certified",
                        tried=tried,
                        met=tried,
                        witness=_witness(polygon, residual.str(8, radius=False)),
                    )
                widest = widest.max(abs(residual).upper())
        decided = bool(charged and widest < _WIDEST)
        return Evidence(
            outcome="pass" if decided else "undecided",
            grade="certified",
            residual=widest.str(3, radius=False),
            tried=tried,
            met=tried,
            shown="on three nets the boundary sum of the angles and the areas of geodesic "
            f"triangles less the charges differ by less than 10^-40; {charged} polygons enclose "
            "branch points of order 3 or 4",
        )
