"""Checks of section 4: discrete assembly of a net around one vertex."""

from collections.abc import Iterator, Sequence
from math import pi, sin
from typing import Any

import numpy as np
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import spherical_nets as printed
from checks.printed import spherical_quads
from checks.verify.discrete_k_surfaces import three_parameters
from checks.verify.discrete_lelieuvre import minus
from checks.verify.forced_sums import forced_sums
from checks.verify.householder import roots
from checks.verify.spherical_samples import ray, reverses_orientation
from checks.verify.vertex_angles import net_defect
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.gluing import star
from discrete.spherical_net import assembled, edge_step, surface_points
from theory.vectors import Vector, dot

Curve = list[Vector]
_LENGTHS = ((1, 1, 1, 1), (2, 2, 2, 2), (3, 2, 4, 1), (2, 1, 3, 2, 1, 2), (1, 2) * 4)


def _curves(
    order: int,
    lengths: Sequence[int],
    *,
    half_tangent: str = "1/10",
    winding: int | None = None,
    turn: str = "1/20",
) -> list[Curve]:
    """Rational curves with the conditions (i), (ii), (iii), the lengths taken in turn.

    turn: half-tangent of the left turns, of alternating sign; winding: 1 - m by default.
    """
    times = 1 - order if winding is None else winding
    found = []
    for k in range(2 * order):
        angle = 2 * pi * times * k / (2 * order) + 0.1 * sin(2.3 * k) * (turn != "0")
        edges = lengths[k % len(lengths)]
        turns = [sp.Rational(turn) * (-1) ** (k + j) for j in range(edges - 1)]
        found.append(ray(angle, edges, edge=sp.Rational(half_tangent), turns=turns))
    return found


def _samples() -> Iterator[tuple[str, list[Curve]]]:
    """Data of discrete assembly: short and long curves, geodesics and curves that turn."""
    for order in (2, 3, 4):
        for half_tangent in ("1/10", "1/4", "1/2"):
            for turn in ("0", "1/20"):
                for lengths in ((1,), (2,), (3, 1, 2)):
                    name = (
                        f"2m = {2 * order}, edges 2 arctan {half_tangent}, turns {turn}, l = "
                        f"{lengths}"
                    )
                    yield name, _curves(order, lengths, half_tangent=half_tangent, turn=turn)


def _closing_defect(curves: list[Curve]) -> str:
    """What is wrong with the surface of the assembled net, or nothing."""
    net = assembled(curves)
    points = surface_points(net)
    for edge, (one, other) in enumerate(net.complex.edges.tolist()):
        if minus(points[other], points[one]) != edge_step(net, edge, one):
            return f"edge {edge} of the surface does not close"
    return ""


def _right_angles() -> list[Curve]:
    """Four geodesics at right angles with two edges of cosine 3/5 each."""
    return [ray(-pi / 2 * k, 2, edge=sp.Rational(1, 2)) for k in range(4)]


def assembly(
    setting: Setting,
    *,
    data: str = "any",
    winding: int = 0,
    longer: bool = False,
    least: str = "-1",
) -> Evidence:
    """lem:discrete_assembly: whether (i) to (iii) give a spherical Chebyshev net and a surface.

    data: "any", or "reversing" for those whose rhombi all reverse the orientation; winding: added
    to that of the directions, against (ii); longer: the last curve has longer edges, against (iii);
    least: of the angles of a rhombus in `forced_sums`.
    """
    tried = met = 0
    samples = list(_samples())
    if data == "any":
        samples.insert(0, ("four geodesics at right angles, cos = 3/5, l = 2", _right_angles()))
    if winding:
        samples = [("2m = 6", _curves(3, (2,), winding=winding - 2))]
    if longer:
        first = _curves(2, (2,), turn="0")
        samples = [("2m = 4", [*first[:3], _curves(2, (2,), half_tangent="1/9", turn="0")[3]])]
    for name, curves in samples:
        tried += 1
        if data == "reversing" and not reverses_orientation(assembled(curves)):
            continue
        met += 1
        if defect := net_defect(assembled(curves)) or _closing_defect(curves):
            return Evidence(
                outcome="fail", grade="exact", witness=f"{name}: {defect}", tried=tried, met=met
            )
    # The sums of angles are enclosed in balls, the sides and the surface are exact.
    instances = Evidence(
        outcome="pass" if met else "undecided", grade="certified", tried=tried, met=met
    )
    return combined(
        {
            "instances": instances,
            "degrees": _star_degrees(),
            "sums": forced_sums(setting, least=least),
        },
        shown="where all rhombi reverse the orientation, angles in (-pi, 0) leave one sum at "
        "vertices of degree 4 and keep the range at degrees 2 and 3, and five stars have no others "
        f"but the centre; {met} of {tried} sets of 4, 6 and 8 rational curves reverse it, and "
        "these give a spherical Chebyshev net and a surface that closes",
    )


def _star_degrees() -> Evidence:
    """Whether all vertices of stars but the centre have degree 4, at the boundary 2 or 3."""
    wrong = ""
    for lengths in _LENGTHS:
        complex_ = star(list(lengths))
        inside = np.flatnonzero(~complex_.is_boundary)
        allowed = {0: [len(lengths)]}
        for v in range(complex_.vertex_count):
            degrees = allowed.get(v, [4] if v in inside else [2, 3])
            if complex_.degree[v] not in degrees:
                wrong = wrong or f"l = {lengths}: vertex {v} has degree {complex_.degree[v]}"
    return statement(not wrong, shown="degrees of stars", witness=wrong)


def _closure(complex_: AsymptoticComplex, known: set[int]) -> set[int]:
    """Vertices that quads with one unknown corner give one after the other."""
    found, grew = set(known), True
    while grew:
        grew = False
        for corners in complex_.faces.tolist():
            unknown = set(corners) - found
            if len(unknown) == 1:
                found |= unknown
                grew = True
    return found


def _on_rays(complex_: AsymptoticComplex, lengths: Sequence[int]) -> set[int]:
    """Vertex 0 of a star and the first vertices of its rays, so many on each."""
    found = {0}
    for edge in np.flatnonzero((complex_.edges == 0).any(axis=1)):
        found.add(int(complex_.edges[edge].sum()))
    families = dict.fromkeys(sorted(found - {0}))
    order = _ray_order(complex_, list(families))
    for first, length in zip(order, lengths, strict=True):
        before, at = 0, first
        for _ in range(length - 1):
            before, at = at, _straight_on(complex_, before, at)
            found.add(at)
    return found


def _ray_order(complex_: AsymptoticComplex, firsts: list[int]) -> list[int]:
    """First vertices of the rays in the order in which the faces at vertex 0 join them."""
    order = [int(complex_.faces[0][1])]
    faces = complex_.faces[(complex_.faces == 0).any(axis=1)]
    following = int(complex_.faces[0][3])
    while following != order[0]:
        order.append(following)
        joined = {v for face in faces.tolist() if following in face for v in (face[1], face[3])} - {
            order[-1],
            order[-2],
        }
        following = joined.pop()
    if sorted(order) != sorted(firsts):
        raise ValueError(f"the rays {order} are not all of {firsts}")
    return order


def _straight_on(complex_: AsymptoticComplex, before: int, at: int) -> int:
    """Next vertex on the line of the edge from `before` to `at`: in no face with `before`."""
    beside = {v for face in complex_.faces.tolist() if before in face and at in face for v in face}
    edges = complex_.edges[(complex_.edges == at).any(axis=1)]
    onwards = {int(edge.sum()) - at for edge in edges} - beside
    return onwards.pop()


def unique(setting: Setting, *, missing: int = 0, larger: bool = False) -> Evidence:
    """Whether the curves determine N on exactly the rectangles J_i, and r up to a translation.

    Each vertex has to follow from quads with three known corners; missing: vertices left out at
    the end of the last curve; larger: claims that the rectangles one edge larger follow too.
    """
    failed = ""
    for lengths in _LENGTHS:
        whole = star([n + 1 for n in lengths])
        inner = star(list(lengths))
        known = _on_rays(whole, [*lengths[:-1], lengths[-1] - missing])
        found = _closure(whole, known)
        expected = whole.vertex_count if larger else inner.vertex_count
        if len(found) != expected:
            failed = failed or (
                f"l = {lengths}: {len(found)} vertices follow, {expected} are claimed"
            )
    return combined(
        {
            "vertices": statement(not failed, shown="", witness=failed),
            "two roots": roots(setting),
            "surface": three_parameters(setting),
        },
        shown="in five stars one edge larger the quad rule gets from the curves to the vertices of "
        "the rectangles J_i and no further; each quad leaves the antipode as the only other root, "
        "and r is unique up to a translation",
    )


def _filled(first: Curve, second: Curve) -> list[list[Vector]]:
    """Normals N_i(k, l) of one rectangle by the printed root."""
    nodes: list[list[Vector]] = [list(second), *([n] for n in first[1:])]
    for k in range(1, len(first)):
        for j in range(1, len(second)):
            known = (nodes[k - 1][j - 1], nodes[k][j - 1], nodes[k - 1][j])
            nu = spherical_quads.root(*known)
            nodes[k].append(spherical_quads.moutard(*known, nu))
    return nodes


def assembly_data(setting: Setting, *, exchanged: bool = False) -> Evidence:
    """Whether the data fit the rectangles and their extension is that of the shipped assembly.

    N_i(k, 0) = gamma_(i-1)(k), N_i(0, l) = gamma_i(l); exchanged: gamma_i and gamma_(i-1).
    """
    found: dict[str, Any] = {}
    for order, lengths in ((2, (3, 2, 4, 1)), (3, (2, 1, 3, 2, 1, 2))):
        curves = _curves(order, lengths)
        shipped = set(assembled(curves).normals)
        for i in range(2 * order):
            before, own = curves[(i - 1) % (2 * order)], curves[i]
            if exchanged:
                before, own = own, before
            size = printed.domain(i, lengths)
            if size != (len(before) - 1, len(own) - 1):
                return statement(
                    False,
                    shown="",
                    witness=f"J_{i} is {size}, its curves have {len(before) - 1} and "
                    f"{len(own) - 1} edges",
                )
            nodes = _filled(before, own)
            found[f"order {order}, N_{i}(0, 0)"] = minus(before[0], own[0])
            strange = sum(n not in shipped for row in nodes for n in row)
            found[f"order {order}, normals of J_{i} not in the shipped net"] = sp.Integer(strange)
            cosine = dot(own[0], own[1])
            for k, row in enumerate(nodes):
                for j in range(len(row) - 1):
                    found[f"order {order}, N_{i} step ({k}, {j})"] = (
                        dot(row[j], row[j + 1]) - cosine
                    )
    return identities(
        setting,
        found,
        shown="for 4 and 6 rational curves of different lengths the two curves fit the sides of "
        "J_i, and the printed root gives the normals of the shipped assembly, in equal steps",
    )


def agreement(setting: Setting, *, onto: str = "0") -> Evidence:
    """Whether N_i and N_(i-1) agree on the side attached by chi_i, with its image at (onto, k)."""
    found: dict[str, Any] = {}
    for order, lengths in ((2, (2, 2, 2, 2)), (3, (2, 1, 3, 2, 1, 2))):
        curves = _curves(order, lengths)
        count = 2 * order
        nets = [_filled(curves[(i - 1) % count], curves[i]) for i in range(count)]
        for i in range(count):
            before = nets[(i - 1) % count]
            for k, row in enumerate(nets[i]):
                a, b = printed.attaching_map(k, len(nets[i]) - 1, onto=onto)
                if a >= len(before) or b >= len(before[0]):
                    witness = f"chi_{i}({k}, 0) = {(a, b)} is not in J_{i - 1}"
                    return statement(False, shown="", witness=witness)
                found[f"order {order}, N_{i}({k}, 0)"] = minus(row[0], before[a][b])
    return identities(
        setting,
        found,
        shown="N_i(k, 0) = N_(i-1)(0, k) = gamma_(i-1)(k) for 4 and 6 rational curves",
    )
