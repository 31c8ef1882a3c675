"""Checks of section 4: the discrete Goursat problem and the Chebyshev nets that it gives."""

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp
from flint import arb, ctx

from checks.ball import enclosure
from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import discrete_surfaces, spherical_quads
from checks.verify.discrete_lelieuvre import Grid, minus, placed
from checks.verify.goursat_samples import curved_side, far_sides
from checks.verify.householder import determination
from checks.verify.unit_vectors import X, Y, Z, corner
from discrete.goursat_fill import fill
from discrete.quad_rule import close_quad
from discrete.space_forms import dot_s2
from theory.reparametrisation import substituted
from theory.surfaces import dini, pseudosphere
from theory.vectors import Vector, dot

_EDGES = 4


def _by_columns(first: Sequence[Vector], second: Sequence[Vector], factor: Any) -> Grid:
    """Net on two sides by the printed root, column by column."""
    nodes: list[list[Vector]] = [[n] for n in first]
    nodes[0] = list(second)
    for j in range(1, len(second)):
        for i in range(1, len(first)):
            known = (nodes[i - 1][j - 1], nodes[i][j - 1], nodes[i - 1][j])
            nu = spherical_quads.root(*known, factor=factor)
            nodes[i].append(spherical_quads.moutard(*known, nu))
    return nodes


def goursat_solution(setting: Setting, *, factor: str = "2") -> Evidence:
    """Whether the printed root, applied from two sides on, gives the net that the rule gives.

    Rational sides with turns and unequal edges; the printed root goes by columns, the shipped fill
    by rows, and the condition is tested on every quad.
    """
    sides = curved_side(1, edges=_EDGES), curved_side(2, edges=_EDGES)
    nodes = _by_columns(*sides, sp.Rational(factor))
    shipped = fill(dot_s2, *sides)
    found: dict[str, Any] = {}
    for i, row in enumerate(nodes):
        for j, n in enumerate(row):
            found[f"node ({i}, {j})"] = minus(n, shipped[i][j])
            found[f"|N|^2 - 1 at ({i}, {j})"] = dot(n, n) - 1
            if i and j:
                quad = (nodes[i - 1][j - 1], nodes[i][j - 1], nodes[i - 1][j], n)
                found[f"condition at ({i}, {j})"] = discrete_surfaces.factored(
                    *quad, half=sp.Rational(1, 2)
                )
    return identities(
        setting,
        found,
        shown="the 25 normals on 4 by 4 quads, the other two sides among them, follow from two "
        "sides with turns and unequal edges: by columns and by rows alike, in rational numbers",
    )


def equal_steps(setting: Setting, *, odd_edge: str = "1/10", opposite: bool = True) -> Evidence:
    """Whether equal steps on two sides give equal steps everywhere.

    On one quad with any two edge lengths each side is as long as the opposite one; on a rational
    net of 4 by 4 quads all steps are cos delta. odd_edge: half-tangent of the v-edges in place of
    1/10; opposite: on the quad compares opposite sides, else adjacent ones.
    """
    c = corner(X, Y, Z)
    far = close_quad(dot_s2, c.n_0, c.n_1, c.n_2)
    first, second = c.cosines if opposite else c.cosines[::-1]
    found: dict[str, Any] = {
        "<N_2, N_12> - <N_0, N_1>": dot(c.n_2, far) - first,
        "<N_1, N_12> - <N_0, N_2>": dot(c.n_1, far) - second,
    }
    sides = far_sides(_EDGES, _EDGES)[0], far_sides(_EDGES, _EDGES, edge=sp.Rational(odd_edge))[1]
    nodes = _by_columns(*sides, 2)
    cosine = dot(nodes[0][0], nodes[1][0])
    for i, row in enumerate(nodes):
        for j, n in enumerate(row):
            if i + 1 < len(nodes):
                found[f"u-step from ({i}, {j})"] = dot(n, nodes[i + 1][j]) - cosine
            if j + 1 < len(row):
                found[f"v-step from ({i}, {j})"] = dot(n, row[j + 1]) - cosine
    return identities(
        setting,
        found,
        shown="the rule makes opposite sides equal, for any two lengths and any angle; so all 40 "
        "steps of a net on two curved sides have the product cos delta of the given ones",
    )


def edge_length(setting: Setting, *, length: str = "sin", factor: str = "1") -> Evidence:
    """Whether an edge of the surface has the length sin delta, 0 < delta < pi.

    For two normals at any distance, and along all edges of a rational net; length: "sin", or
    "chord" for |N_1 - N_0|.
    """
    c = corner()
    chord = minus(c.n_1, c.n_0)
    claimed = {
        "sin": spherical_quads.edge_length(sp.Rational(factor) * c.sines[0]) ** 2,
        "chord": dot(chord, chord),
    }[length]
    step = discrete_surfaces.step_u(c.n_0, c.n_1)
    back = discrete_surfaces.step_v(c.n_0, c.n_1)
    found = {
        "u-edge": dot(step, step) - claimed,
        "v-edge": dot(back, back) - claimed,
    }
    normals = _by_columns(*far_sides(3, 3), 2)
    points = placed(normals)
    cosine = dot(normals[0][0], normals[1][0])
    for i, row in enumerate(points):
        for j, p in enumerate(row):
            for k, m in ((i + 1, j), (i, j + 1)):
                if k < len(points) and m < len(row):
                    edge = minus(points[k][m], p)
                    found[f"edge ({i}, {j}) - ({k}, {m})"] = dot(edge, edge) - (1 - cosine**2)
    parts = {
        "squares": identities(setting, found, shown=""),
        "sign": statement(
            bool(c.sines[0].is_positive), shown="", witness="sin delta is not positive"
        ),
    }
    return combined(
        parts,
        shown="|N_1 x N_0|^2 = sin^2 delta for normals at any distance delta in (0, pi), where "
        "sin delta > 0; so it is along all 24 edges of a surface summed from rational normals",
    )


def _opposite_edges(nodes: Grid) -> dict[str, Any]:
    """Squared lengths of opposite edges of each quad, their differences."""
    found = {}
    for i in range(len(nodes) - 1):
        for j in range(len(nodes[0]) - 1):
            a, b = nodes[i][j], nodes[i + 1][j]
            d, c = nodes[i][j + 1], nodes[i + 1][j + 1]
            for name, (p, q, r, s) in {"u": (a, b, d, c), "v": (a, d, b, c)}.items():
                one, other = minus(q, p), minus(s, r)
                found[f"{name}-edges of quad ({i}, {j})"] = dot(one, one) - dot(other, other)
    return found


def chebyshev_nets(setting: Setting, *, rule: str = "root") -> Evidence:
    """Whether r and N are discrete Chebyshev nets: opposite edges of every quad are equal.

    rule: how the normals are found, by the printed "root" or, in the last quad, by the other root,
    the "antipode".
    """
    sides = curved_side(1, edges=_EDGES), curved_side(2, edges=_EDGES)
    normals = _by_columns(*sides, 2)
    if rule == "antipode":
        last = normals[_EDGES - 1][_EDGES - 1]
        row = [*normals[_EDGES][:_EDGES], tuple(-entry for entry in last)]
        normals = [*normals[:_EDGES], row]
    found = {f"normals, {name}": value for name, value in _opposite_edges(normals).items()}
    found |= {f"points, {name}": value for name, value in _opposite_edges(placed(normals)).items()}
    return identities(
        setting,
        found,
        shown="opposite edges of all 16 quads are equal on S^2 and in space, for sides with turns "
        "and unequal edges, in rational numbers",
    )


def _solved_order(known: set[tuple[int, int]], n: int, m: int) -> list[tuple[int, int]]:
    """Nodes in the order in which quads with one unknown corner give them."""
    known = set(known)
    order: list[tuple[int, int]] = []
    while True:
        for i in range(n):
            for j in range(m):
                corners = set(discrete_surfaces.grid_face(i, j))
                if len(unknown := corners - known) == 1:
                    order.extend(unknown)
                    known |= unknown
                    break
            else:
                continue
            break
        else:
            return order


def figure(setting: Setting, *, sides: str = "adjacent", missing: int = 0) -> Evidence:
    """fig:scri: (a) three corners determine the fourth; (b) two sides determine all other nodes.

    sides: the data on "adjacent" or "opposite" sides; missing: nodes left out at the end of one.
    """
    failed = ""
    for n in range(1, 6):
        for m in range(1, 6):
            second = discrete_surfaces.v_curve(0, m)
            first = discrete_surfaces.u_curve(n - missing, 0)
            if sides == "opposite":
                first = discrete_surfaces.v_curve(n, m)
            order = _solved_order(first | second, n, m)
            everything = discrete_surfaces.grid_nodes(n, m, first_v=0)
            solved = set(order) | first | second
            if solved != everything or len(order) != n * m:
                failed = failed or (
                    f"{n} by {m} quads: {len(order)} nodes are solved for, "
                    f"{len(everything - solved)} stay open, with {n * m} quads"
                )
    parts = {
        "(a)": determination(setting),
        "(b)": statement(not failed, shown="", witness=failed),
    }
    return combined(
        parts,
        shown="(a) the normals at three corners determine the fourth; (b) on all grids up to 5 by "
        "5 quads the data on two adjacent sides leave as many nodes as there are quads, and each "
        "quad gives one of them in turn",
    )


def _chord_defect(
    normal: Vector, variable: sp.Symbol, place: Any, step: Any, delta: Any, others: dict[Any, Any]
) -> arb:
    """Ball around <N(a), N(a + step)> - cos delta; positive where the chord is below delta."""
    one = [entry.subs({variable: place, **others}) for entry in normal]
    other = [entry.subs({variable: place + step, **others}) for entry in normal]
    return enclosure(dot(tuple(one), tuple(other)) - sp.cos(delta), {})


def _brackets(speeds: tuple[str, str], bits: int) -> Iterator[tuple[str, arb, arb]]:
    """Where, and the defect of the chord from there after delta and after delta (1 + delta^2)."""
    u, v = sp.symbols("u v", real=True)
    s = sp.Symbol("s", real=True)
    for front in (pseudosphere(), dini(2)):
        _, _, normal = substituted(front, ((1, 0), (0, 1)), u, v, normal_sign=1)
        for variable, other, speed in ((u, v, speeds[0]), (v, u, speeds[1])):
            moved = tuple(entry.subs(variable, sp.Rational(speed) * s) for entry in normal)
            for place in ("1/2", "1", "3/2"):
                for delta in (sp.Rational(1, 20), sp.Rational(1, 100)):
                    at = sp.Rational(place)
                    with ctx.workprec(bits):
                        low, high = (
                            _chord_defect(moved, s, at, step, delta, {other: 1})
                            for step in (delta, delta * (1 + delta**2))
                        )
                    yield f"{front.name}, {variable}-line at {at}, delta = {delta}", low, high


def equal_steps_on_sides(
    setting: Setting, *, speed_u: str = "1", speed_v: str = "1", bits: int = 256
) -> Evidence:
    """Whether a step of angle exactly delta exists along u- and v-lines, of length about delta.

    Unit torsion means |N_u| = |N_v| = 1, so the arc over [a, a + delta] is not below its chord:
    that is at most delta, and it exceeds delta before a + delta (1 + delta^2). Signs by balls, at
    points of the lines of the pseudosphere and of Dini's surface. speed: of the parameter.
    """
    tried = 0
    for where, low, high in _brackets((speed_u, speed_v), bits):
        tried += 1
        if low < 0 or high > 0:
            return Evidence(
                outcome="fail",
                grade="numeric",
                tried=tried,
                met=tried,
                witness=f"{where}: cos chord - cos delta = {low.str(8, radius=False)} after delta, "
                f"{high.str(8, radius=False)} after delta (1 + delta^2)",
            )
        if not (low > 0 and high < 0):
            return Evidence(outcome="undecided", grade="numeric", shown=f"not decided: {where}")
    return Evidence(
        outcome="pass",
        grade="numeric",
        digits=60,
        tried=tried,
        met=tried,
        shown="along u- and v-lines of the pseudosphere and of Dini's surface, at three points and "
        "for delta = 1/20 and 1/100, the next normal at the angle delta exactly lies between "
        "delta and delta (1 + delta^2): one delta serves both families",
    )
