"""Section 4.1: planar vertex stars with the lengths and angles of a net, quad by quad and whole."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt
import sympy as sp
from sympy.polys.fields import field

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.verify import geometric_nets as nets
from checks.verify.geometric_nets import Recipe
from discrete.branched_net import BranchedNet
from discrete.edge_lengths import space_length
from discrete.geodesics import angle_at, determinant, difference, sine_and_cosine_part
from discrete.k_surface import KSurface, k_surface
from discrete.lelieuvre import positions
from discrete.planar_stars import star_surface
from discrete.quad_rule import close_quad
from discrete.space_forms import H2, Triple, dot_h2, dot_s2

FloatArray = npt.NDArray[np.float64]

# tanh of half the two edges, and the tangent of half the angle from the u- to the v-edge: elements
# of a field of fractions, in which the shipped bodies run exactly and without simplification.
FIELD, T1, T2, P = field("t_1, t_2, p", sp.QQ)
_COS, _SIN = (1 - P**2) / (1 + P**2), 2 * P / (1 + P**2)
_ORIGIN = (FIELD.one, FIELD.zero, FIELD.zero)
_AROUND = ((0, 0), (1, 0), (1, 1), (0, 1))
_ROUNDING = 1e-10  # some hundred steps in float64, angles of edges of length 1/10


def plane_corners() -> list[Triple]:
    """Corners of a parallelogram of H^2 with the first one at the origin."""
    (c1, s1), (c2, s2) = (((1 + t**2) / (1 - t**2), 2 * t / (1 - t**2)) for t in (T1, T2))
    p1, p2 = (c1, s1, FIELD.zero), (c2, s2 * _COS, s2 * _SIN)
    return [_ORIGIN, p1, close_quad(dot_h2, _ORIGIN, p1, p2), p2]


def quad_normals(scale: str, v_sign: int, *, half_turn: bool) -> list[Triple]:
    """Normals at the corners: along u-edges the normal moves to their left, along v to the right.

    scale: tan(s/2) = scale t for a step s; v_sign: -1 for the right.
    """
    steps = [FIELD(sp.QQ(sp.Rational(scale).p, sp.Rational(scale).q)) * t for t in (T1, T2)]
    (c1, s1), (c2, s2) = (((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)) for t in steps)
    n1 = (c1, FIELD.zero, s1)
    n2 = (c2, -v_sign * s2 * _SIN, v_sign * s2 * _COS)
    far = close_quad(dot_s2, _ORIGIN, n1, n2)
    if not half_turn:
        far = tuple(a + b - c for a, b, c in zip(n1, n2, _ORIGIN, strict=True))
    return [_ORIGIN, n1, far, n2]


def space_corners(normals: list[Triple]) -> list[Triple]:
    """Corners of the quad in space with these normals, by the shipped formula of Lelieuvre."""
    grid = np.empty((3, 2, 2), dtype=object)
    for (i, j), normal in zip(_AROUND, normals, strict=True):
        grid[:, i, j] = normal
    found = positions(grid, np.array([FIELD.zero] * 3, dtype=object))
    return [tuple(found[:, i, j].tolist()) for i, j in _AROUND]


def quad(
    setting: Setting, *, scale: str = "1", v_sign: int = -1, half_turn: bool = True
) -> Evidence:
    """Star, lengths and angles at each corner of a quad in space and of the quad of H^2.

    scale: tan(s/2) = scale tanh(a/2) for the steps s of the normal; v_sign: side to which it moves
    along v-edges; half_turn: rule that closes the quad of normals.
    """
    plane, normals = plane_corners(), quad_normals(scale, v_sign, half_turn=half_turn)
    space = space_corners(normals)
    sides = [2 * t / (1 + t**2) for t in (T1, T2, T1, T2)]  # tanh a
    cosh = (1 + T1**2) / (1 - T1**2) * (1 + T2**2) / (1 - T2**2)
    found: dict[str, Any] = {}
    for k in range(4):
        onwards, back = (k + 1) % 4, (k - 1) % 4
        one, other = difference(space[onwards], space[k]), difference(space[back], space[k])
        sine, cosine = sine_and_cosine_part(H2, plane[k], plane[onwards], plane[back])
        found |= {
            f"corner {k}, normal and next edge": dot_s2(normals[k], one),
            f"corner {k}, normal and last edge": dot_s2(normals[k], other),
            f"corner {k}, length": dot_s2(one, one) - sides[k] ** 2,
            f"corner {k}, cosine": dot_s2(one, other) * cosh - cosine,
            f"corner {k}, sine": determinant(normals[k], one, other) * cosh - sine,
        }
    positive = [sp.Symbol(name, positive=True) for name in ("t_1", "t_2")]
    unknown = (*positive, sp.Symbol("p", real=True))
    return identities(
        setting,
        {name: residual.as_expr(*unknown) for name, residual in found.items()},
        where=[1 - t for t in positive],
        shown="for any two edges a, b and either orientation: the shipped half-turns and formula "
        "of Lelieuvre give a quad in space whose edges at each corner are normal to the normal, "
        "with the lengths tanh a, tanh b and the signed angle that the quad of H^2 has there",
    )


def corner_vectors(surface: KSurface) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Normals at the corners of the faces, and edges to the next and the last: (faces, 4, 3)."""
    at = surface.points[surface.complex.faces]
    return (
        surface.normals[surface.complex.faces],
        np.asarray(np.roll(at, -1, axis=1) - at),
        np.asarray(np.roll(at, 1, axis=1) - at),
    )


def angles_in_space(surface: KSurface) -> FloatArray:
    """Signed angles of the faces at their corners, seen from the normal's tip: (faces, 4)."""
    normal, one, other = corner_vectors(surface)
    sine = np.einsum("fki,fki->fk", normal, np.cross(one, other))
    return np.asarray(np.arctan2(sine, np.einsum("fki,fki->fk", one, other)))


def angles_in_disk(corners: list[tuple[Triple, ...]]) -> FloatArray:
    """Signed angles of the faces at their corners in H^2, from triples: (faces, 4)."""
    return np.array(
        [
            [angle_at(H2, math, face[k], face[(k + 1) % 4], face[k - 1]) for k in range(4)]
            for face in corners
        ]
    )


def _opened(net: BranchedNet, gap: float) -> BranchedNet:
    """Net whose last sector begins later by an angle: those at its apex exceed their sum by it."""
    last = replace(net.placed[-1], bearing=net.placed[-1].bearing + gap)
    return BranchedNet(placed=(*net.placed[:-1], last), seams=net.seams)


def _deviations(recipe: Recipe, gap: float, percent: int) -> dict[str, float]:
    net = _opened(nets.float_net(recipe), gap)
    surface = k_surface(net, route=star_surface)
    nodes = nets.sector_nodes(recipe, math, float(recipe.edge_length))
    normal, one, _ = corner_vectors(surface)
    angles = angles_in_disk(nets.face_corners(net, nodes))
    length = space_length(math, float(recipe.edge_length)) * percent / 100
    return {
        "gap between sectors": surface.mismatch,
        "height above the plane of a star": float(
            np.abs(np.einsum("fki,fki->fk", normal, one)).max()
        ),
        "length of an edge": float(np.abs(np.linalg.norm(one, axis=2) - length).max()),
        "angle at a vertex": float(np.abs(angles_in_space(surface) - angles).max()),
    }


def whole(setting: Setting, *, gap: str = "0", percent: int = 100) -> Evidence:
    """Surfaces made of planar stars on five nets, against angles between half-turns of triples.

    gap: excess of the angles at an apex over their sum; percent: of tanh Delta for the edges.
    """
    del setting
    worst = 0.0
    for number, recipe in enumerate(nets.LARGE):
        found = _deviations(recipe, float(sp.Rational(gap)), percent)
        worst = max(worst, *found.values())
        for name, value in found.items():
            if value > _ROUNDING:
                return Evidence(
                    outcome="fail",
                    grade="numeric",
                    residual=f"{value:.1e}",
                    tried=number + 1,
                    met=number + 1,
                    witness=f"net {number}: {name} is off by {value:.3g}",
                )
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=10,
        residual=f"{worst:.1e}",
        tried=len(nets.LARGE),
        met=len(nets.LARGE),
        shown="stars with the edges tanh Delta and the angles of the net close up across all "
        "sectors of five nets with up to four branch points, one factor for all edges; the signed "
        "angles are those between triples of H^2 filled by half-turns",
    )
