"""Checks of section 4: the discrete Lelieuvre equations and the condition that they close."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities
from checks.printed import discrete_surfaces as printed
from checks.verify.goursat_samples import curved_side, far_sides
from checks.verify.unit_vectors import quad_symbols, symbols
from discrete.goursat_fill import fill
from discrete.lelieuvre import positions
from discrete.space_forms import dot_s2
from theory.vectors import Vector, added, cross, dot, scaled

Grid = Sequence[Sequence[Vector]]


def minus(a: Vector, b: Vector) -> Vector:
    """Difference of two triples."""
    return added(a, scaled(-1, b))


def placed(normals: Grid) -> Grid:
    """Vertices [i][j] of the K-surface with these normals by the shipped summation, r(0, 0) = 0."""
    array = np.array(normals, dtype=object).transpose(2, 0, 1)
    found = positions(array, np.array([sp.Integer(0)] * 3, dtype=object))
    return [[tuple(found[:, i, j]) for j in range(array.shape[2])] for i in range(array.shape[1])]


def rational_net(u_edges: int = 3, v_edges: int = 3) -> Grid:
    """Normals [i][j] of a net of rational rhombi between two curved sides, by the shipped rule."""
    return fill(dot_s2, *far_sides(u_edges, v_edges))


def _steps(normals: Grid, points: Grid, *, sign_u: int, sign_v: int) -> dict[str, Any]:
    """Each edge of the surface minus what (eq:d_lelieuvre) makes of the normals at its ends."""
    found: dict[str, Any] = {}
    for i, row in enumerate(normals):
        for j, n in enumerate(row):
            if i + 1 < len(normals):
                edge = minus(points[i + 1][j], points[i][j])
                step = printed.step_u(n, normals[i + 1][j], sign=sign_u)
                found[f"u-edge from ({i}, {j})"] = minus(edge, step)
            if j + 1 < len(row):
                edge = minus(points[i][j + 1], points[i][j])
                step = printed.step_v(n, row[j + 1], sign=sign_v)
                found[f"v-edge from ({i}, {j})"] = minus(edge, step)
    return found


def steps_of_a_surface(setting: Setting, *, sign_u: int = 1, sign_v: int = -1) -> Evidence:
    """Whether (eq:d_lelieuvre) holds along all edges of a surface summed from rational normals."""
    normals = rational_net()
    return identities(
        setting,
        _steps(normals, placed(normals), sign_u=sign_u, sign_v=sign_v),
        shown="both equations hold along all 24 edges of a surface of 3 by 3 quads, the last row "
        "and column included, though its vertices were summed along one column and the rows only",
    )


def steps_in_a_moved_frame(setting: Setting, *, sign_u: int = 1, sign_v: int = -1) -> Evidence:
    """Whether (eq:d_lelieuvre) follows from planar vertex stars and turning normals.

    An edge e of length sin s leaves at a right angle to N_0; along a u-edge N turns about it by
    -s, along a v-edge by +s, as on a surface whose torsions are -1 and +1.
    """
    s = sp.Symbol("s", real=True)
    found = {}
    for name, step, sign, turn in (
        ("u", printed.step_u, sign_u, -1),
        ("v", printed.step_v, sign_v, 1),
    ):
        t = sp.Symbol("t", real=True)
        normal, along = (0, 0, 1), (sp.cos(t), sp.sin(t), 0)
        turned = added(scaled(sp.cos(s), normal), scaled(turn * sp.sin(s), cross(along, normal)))
        found[f"{name}-edge"] = minus(scaled(sp.sin(s), along), step(normal, turned, sign=sign))
    return identities(
        setting,
        found,
        shown="an edge of length sin s at a right angle to the normal, about which the normal "
        "turns by -s (u) or s (v), is what the equations give, for every s and direction",
    )


def orthogonal(setting: Setting, *, swapped: bool = False) -> Evidence:
    """Whether the four edges at a vertex are orthogonal to its normal.

    For any five normals, closed or not, and on the vertices of a surface of rational normals;
    swapped: the normal of the neighbour to the right is taken instead.
    """
    at, right, left, up, down = (symbols(name) for name in "nrlud")
    tested = right if swapped else at
    found = {
        "r(i+1, j) - r": dot(printed.step_u(at, right), tested),
        "r(i-1, j) - r": dot(scaled(-1, printed.step_u(left, at)), tested),
        "r(i, j+1) - r": dot(printed.step_v(at, up), tested),
        "r(i, j-1) - r": dot(scaled(-1, printed.step_v(down, at)), tested),
    }
    normals = rational_net()
    points = placed(normals)
    for i, j in ((1, 1), (1, 2), (2, 1), (2, 2)):
        n = normals[i + 1][j] if swapped else normals[i][j]
        for k, m in ((i + 1, j), (i - 1, j), (i, j + 1), (i, j - 1)):
            found[f"edge ({i}, {j}) - ({k}, {m})"] = dot(n, minus(points[k][m], points[i][j]))
    return identities(
        setting,
        found,
        shown="the steps to all four neighbours are orthogonal to the normal, for any normals, and "
        "at the 4 inner vertices of a surface of 3 by 3 quads",
    )


def labellings(setting: Setting, *, families: str = "kept", sign: int = 1) -> Evidence:
    """Whether the equations are the same for each of the four vertices labelled 0.

    From each vertex the neighbours along the u- and the v-edge are labelled 1 and 2; families:
    "exchanged" takes the u-edge for a v-edge from every other vertex; sign: of the second equation
    read backwards.
    """
    normal = dict(zip(("0", "1", "2", "12"), quad_symbols(), strict=True))
    along_u = {"0": "1", "1": "0", "2": "12", "12": "2"}
    along_v = {"0": "2", "2": "0", "1": "12", "12": "1"}
    found = {}
    for zero in ("0", "1", "2", "12"):
        one, two = along_u[zero], along_v[zero]
        if families == "exchanged" and zero in ("1", "2"):
            one, two = two, one
        reference = {
            frozenset(("0", "1")): ("0", "1", printed.step_u),
            frozenset(("2", "12")): ("2", "12", printed.step_u),
            frozenset(("0", "2")): ("0", "2", printed.step_v),
            frozenset(("1", "12")): ("1", "12", printed.step_v),
        }
        for end, step in ((one, printed.step_u), (two, printed.step_v)):
            start, tip, own = reference[frozenset((zero, end))]
            expected = own(normal[start], normal[tip])
            got = step(normal[zero], normal[end])
            back = got if (zero, end) == (start, tip) else scaled(-sign, got)
            found[f"edge {zero} - {end} seen from {zero}"] = minus(back, expected)
    return identities(
        setting,
        found,
        shown="each edge of a quad has the same vector whichever vertex is labelled 0, for any "
        "four normals: each equation is antisymmetric in the ends of its edge, and names no face",
    )


def two_paths(setting: Setting, *, second: int = -1, last: int = 1) -> Evidence:
    """Whether both ways around a quad are as written; second, last: signs of the last terms."""
    n_0, n_1, n_2, n_12 = quad_symbols()
    r_0 = symbols("r")
    r_1, r_2 = added(r_0, printed.step_u(n_0, n_1)), added(r_0, printed.step_v(n_0, n_2))
    return identities(
        setting,
        {
            "0 - 1 - 12": minus(
                added(r_1, printed.step_v(n_1, n_12)),
                printed.far_by_1(r_0, n_0, n_1, n_12, second=second),
            ),
            "0 - 2 - 12": minus(
                added(r_2, printed.step_u(n_2, n_12)),
                printed.far_by_2(r_0, n_0, n_2, n_12, second=last),
            ),
        },
        shown="stepping by (eq:d_lelieuvre) along either path gives the written sums, for any "
        "normals",
    )


def compatible(setting: Setting, *, last: int = 1, sign: int = 1) -> Evidence:
    """(eq:d_compatible): both equalities, as identities in four arbitrary normals."""
    n = quad_symbols()
    n_0, n_1, n_2, n_12 = n
    r_0 = symbols("r")
    gap = minus(
        added(added(r_0, printed.step_u(n_0, n_1)), printed.step_v(n_1, n_12)),
        added(added(r_0, printed.step_v(n_0, n_2)), printed.step_u(n_2, n_12)),
    )
    stated = printed.gap_of_paths(*n, last=last)
    return identities(
        setting,
        {
            "gap of the two paths": minus(gap, stated),
            "product of the sums": minus(stated, printed.product_of_sums(*n, sign=sign)),
        },
        shown="the gap between both ways around a quad is the sum of four products and the product "
        "of the two sums, so one vanishes exactly with the other",
    )


def _lines(**changed: Any) -> Mapping[str, Vector]:
    """The three lines of (eqn:discreteconstantcurvaturepde) for four arbitrary normals."""
    n = quad_symbols()
    quarter, half = sp.Rational(1, 4), changed.get("half", sp.Rational(1, 2))
    return {
        "discretised": printed.discretised(
            *n, quarter=quarter, difference=changed.get("difference", -1)
        ),
        "expanded": printed.expanded(*n, half=half, last=changed.get("last", -1)),
        "factored": printed.factored(*n, half=half, sign=changed.get("sign", 1)),
    }


def condition_expanded(setting: Setting, *, half: str = "2/4", last: int = -1) -> Evidence:
    """First against second line of (eqn:discreteconstantcurvaturepde)."""
    lines = _lines(half=sp.Rational(half), last=last)
    return identities(
        setting,
        {"second line": minus(lines["discretised"], lines["expanded"])},
        shown="the first line is the second for any four vectors, unit or not",
    )


def condition_factored(setting: Setting, *, half: str = "1/2", sign: int = 1) -> Evidence:
    """First and second against third line of (eqn:discreteconstantcurvaturepde)."""
    lines = _lines(sign=sign)
    third = scaled(sp.Rational(half) * 2, lines["factored"])
    return identities(
        setting,
        {
            "second line": minus(lines["expanded"], third),
            "first line": minus(lines["discretised"], third),
        },
        shown="all three lines agree for any four vectors",
    )


def same_condition(setting: Setting, *, factor: str = "-1/2") -> Evidence:
    """Whether the discretised condition is a constant times that of the discrete equations."""
    n = quad_symbols()
    discretised = printed.discretised(*n, quarter=sp.Rational(1, 4))
    closed = scaled(sp.Rational(factor), printed.gap_of_paths(*n))
    return identities(
        setting,
        {"discretised minus factor times gap": minus(discretised, closed)},
        shown="the discretised compatibility condition is -1/2 times the gap between the two paths "
        "of the discrete equations, identically in four arbitrary vectors: no mesh size enters",
    )


def normal_before_position(setting: Setting, *, rule: str = "half-turn") -> Evidence:
    """The two steps on rational data: normals from two sides, then vertices that close.

    rule: "half-turn", or "reflection", by which the far normal is the mirror image of N_0 in the
    plane of the origin and the two neighbours, a plane that halves no quad of unequal edges.
    """
    first, second = curved_side(1), curved_side(2)
    normals = _filled(first, second, rule)
    points = placed(normals)
    quads = [(i, j) for i in range(len(first) - 1) for j in range(len(second) - 1)]
    found = _steps(normals, points, sign_u=1, sign_v=-1)
    for i, j in quads:
        n = (normals[i][j], normals[i + 1][j], normals[i][j + 1], normals[i + 1][j + 1])
        found[f"N_uv x N on quad ({i}, {j})"] = printed.discretised(*n, quarter=sp.Rational(1, 4))
    for i, row in enumerate(normals):
        found |= {f"|N|^2 - 1 at ({i}, {j})": dot(n, n) - 1 for j, n in enumerate(row)}
    return identities(
        setting,
        found,
        shown="from rational normals on two sides, of unequal edges, the rule gives unit normals "
        "that are discretely Lorentz harmonic on every quad, and from them a surface that closes",
    )


def _filled(first: Sequence[Vector], second: Sequence[Vector], rule: str) -> Grid:
    if rule == "half-turn":
        return fill(dot_s2, first, second)
    rows = [list(second)]
    for i in range(1, len(first)):
        row = [first[i]]
        for before, at in pairwise(rows[i - 1]):
            axis = cross(row[-1], at)
            share = 2 * dot(before, axis) / dot(axis, axis)
            row.append(minus(before, scaled(share, axis)))
        rows.append(row)
    return rows
