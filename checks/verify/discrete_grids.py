"""Checks of section 4: grids in the faces of a complex and the quadgraph that they form."""

from collections.abc import Callable
from fractions import Fraction
from math import floor
from typing import Any

import numpy as np

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.printed import discrete_surfaces as printed
from checks.verify import quad_meshes
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import ComplexError
from discrete.gluing import grid, rectangle, side
from discrete.signed_graph import IntArray

_SIZES = [(n, m) for n in range(1, 6) for m in range(1, 6)]


def grid_in_a_face(setting: Setting, *, first_u: int = 0, first_v: int = 1) -> Evidence:
    """Whether the grid M_k reaches all four sides of its rectangle, with the right cells.

    The cells are the unit squares with all four corners in M_k: there must be i_k j_k of them,
    the faces of the shipped rectangle, for all i_k, j_k up to 5.
    """
    failed = ""
    for n, m in _SIZES:
        nodes = printed.grid_nodes(n, m, first_u=first_u, first_v=first_v)
        missed = [
            name
            for name, on in (
                ("u = 0", {j for i, j in nodes if i == 0}),
                ("u = u_k", {j for i, j in nodes if i == n}),
                ("v = 0", {i for i, j in nodes if j == 0}),
                ("v = v_k", {i for i, j in nodes if j == m}),
            )
            if not on
        ]
        cells = sum(set(printed.grid_face(i, j)) <= nodes for i in range(n) for j in range(m))
        if missed or cells != len(rectangle(n, m).faces):
            failed = failed or (
                f"i_k = {n}, j_k = {m}: no node on the side {', '.join(missed) or 'none'}; "
                f"{cells} cells in place of {n * m}"
            )
    return statement(
        not failed,
        shown="the grid has nodes on all four sides and i_k j_k cells, for i_k, j_k up to 5",
        witness=failed,
    )


def _samples() -> dict[str, tuple[AsymptoticComplex, list[Fraction]]]:
    """Complexes with the length of each edge, a rational number for each ribbon."""
    found = {}
    for name, complex_ in quad_meshes.corpus().items():
        ribbon = quad_meshes.ribbons(complex_)
        lengths = [1 + Fraction(k * k + 3 * k + 1, 7 + 2 * k) for k in range(int(ribbon.max()) + 1)]
        found[name] = complex_, [lengths[r] for r in ribbon]
    return found


def commensurable(
    setting: Setting, *, alike: bool = True, bound: str = "1/2", infinite: bool = False
) -> Evidence:
    """Whether all sides become multiples of epsilon when each moves by at most bound * epsilon.

    The sides of one ribbon (opposite or shared) must stay equal; alike: whether all are rounded by
    one rule, else those of odd edges are rounded up; infinite: lets the sides tend to 0.
    """
    half, failed = Fraction(bound), ""
    for name, (complex_, lengths) in _samples().items():
        if infinite:
            lengths = [length / 10**9 for length in lengths]
        ribbon = quad_meshes.ribbons(complex_)
        for epsilon in (Fraction(1), Fraction(1, 10), Fraction(1, 1000)):
            parts = [
                floor(length / epsilon + Fraction(1, 2)) + (not alike and k % 2)
                for k, length in enumerate(lengths)
            ]
            moved = max(abs(n * epsilon - x) for n, x in zip(parts, lengths, strict=True))
            per_ribbon = {(int(r), n) for r, n in zip(ribbon, parts, strict=True)}
            if moved > half * epsilon or min(parts) < 1 or len(per_ribbon) != ribbon.max() + 1:
                failed = failed or (
                    f"{name}, epsilon = {epsilon}: a side moves by {moved}, the least number of "
                    f"parts is {min(parts)}, {len(per_ribbon)} lengths for {ribbon.max() + 1} "
                    "ribbons"
                )
    return statement(
        not failed,
        shown="on six complexes with different lengths of the ribbons all sides become positive "
        "multiples of epsilon = 1, 1/10, 1/1000 by moving at most epsilon/2, equal sides alike",
        witness=failed,
    )


def asymptotic_curves(setting: Setting, *, first: int = 0, exchanged: bool = False) -> Evidence:
    """Whether the discrete curves are the lines of u- and of v-edges of the grid, end to end.

    first: where the curves begin; exchanged: takes the u-curves for v-curves, a near-miss.
    """
    failed = ""
    for n, m in _SIZES:
        numbers = grid(n, m)
        complex_ = rectangle(n, m)
        curves = [(printed.u_curve(n, j, first=first), True) for j in range(m + 1)]
        curves += [(printed.v_curve(i, m, first=first), False) for i in range(n + 1)]
        for nodes, is_u in curves:
            path = np.array([numbers[at] for at in sorted(nodes)])
            edges = complex_.edge_between(path[:-1], path[1:])
            wanted = is_u != exchanged
            whole = len(path) == (n if is_u else m) + 1
            if not (whole and (edges >= 0).all() and (complex_.edge_is_u[edges] == wanted).all()):
                failed = failed or f"{n} by {m} quads, curve {sorted(nodes)}"
        ends = {tuple(side(n, m, "v = 0")), tuple(side(n, m, "v = n"))}
        both = {tuple(numbers[at] for at in sorted(printed.u_curve(n, j))) for j in (0, m)}
        if ends != both:
            failed = failed or f"{n} by {m} quads: the sides v = 0 and v = v_k are no u-curves"
    return statement(
        not failed,
        shown="on all grids up to 5 by 5 quads each curve is a chain of edges of its family from "
        "side to side, and the sides themselves are among the curves",
        witness=failed,
    )


def _quadgraph(n: int, m: int, width: int) -> str:
    """What is wrong with the faces of a grid of n by m, or nothing."""
    faces = [
        [i * (m + 2) + j for i, j in printed.grid_face(i, j, width=width)]
        for i in range(n + 1 - width)
        for j in range(m + 1 - width)
    ]
    _, numbered = np.unique(np.array(faces), return_inverse=True)
    try:
        complex_ = AsymptoticComplex(faces=numbered.reshape(-1, 4))
    except ComplexError as error:
        return str(error)
    shipped = rectangle(n, m)
    same = np.array_equal(complex_.faces, shipped.faces) and complex_.is_disk
    return "" if same else "the faces are not those of the rectangle"


def grid_is_a_quadgraph(setting: Setting, *, width: int = 1) -> Evidence:
    """Whether the unit squares of a grid are the faces of a quadgraph; width: of the squares."""
    failed = ""
    for n, m in _SIZES:
        if min(n, m) >= width and (wrong := _quadgraph(n, m, width)):
            failed = failed or f"{n} by {m}: {wrong}"
    return statement(
        not failed,
        shown="for all grids up to 5 by 5 the squares form a strongly regular quadgraph with two "
        "alternating families of edges, a disk, the same as the shipped rectangle",
        witness=failed,
    )


def quadgraph_of_a_complex(setting: Setting, *, first: int = 0, common: bool = True) -> Evidence:
    """Whether the grids of the faces form one quadgraph with the topology of the complex.

    first: where the grids begin, 0 for the whole boundary of each face; common: whether shared
    sides are divided alike.
    """
    parts: dict[str, Evidence] = {}
    for name, complex_ in quad_meshes.corpus().items():
        ribbon = quad_meshes.ribbons(complex_)
        counts = [int(1 + r % 3) for r in ribbon]
        parts[name] = _one_quadgraph(complex_, counts, first, common)
        if parts[name].outcome == "fail":
            break
    return combined(
        parts,
        shown="on six complexes, whose faces become grids of 1 to 3 quads each way, the grids form "
        "an asymptotic complex: a disk with the same corners and the same branch points",
    )


def _one_quadgraph(
    complex_: AsymptoticComplex, counts: list[int], first: int, common: bool
) -> Evidence:
    def nodes(n: int, m: int) -> set[tuple[int, int]]:
        return printed.grid_nodes(n, m, first_u=first, first_v=first)

    faces, vertices = quad_meshes.divided(complex_, counts, nodes=nodes)
    if not common:
        # The grid of the last face is divided once more along u: its neighbours are not.
        halved = counts.copy()
        edge = complex_.sides.edge_of[-1, 0]
        halved[edge] += 1
        faces, vertices = quad_meshes.divided(complex_, halved, nodes=nodes)
    wrong = _topology_defect(complex_, faces, vertices)
    return statement(not wrong, shown="", witness=wrong)


def _topology_defect(complex_: AsymptoticComplex, faces: Any, vertices: int) -> str:
    if not len(faces):
        return "no quad is left"
    try:
        found = AsymptoticComplex(faces=faces)
    except ComplexError as error:
        return str(error)
    orders = sorted(found.saddle_order[found.branch_points].tolist())
    expected = sorted(complex_.saddle_order[complex_.branch_points].tolist())
    if not found.is_disk or found.vertex_count != vertices:
        return f"no disk: Euler characteristic {found.euler_characteristic}"
    if orders != expected:
        return f"branch points of the orders {orders} in place of {expected}"
    if found.is_corner.sum() != complex_.is_corner.sum():
        return f"{found.is_corner.sum()} corners in place of {complex_.is_corner.sum()}"
    return ""


def _entries(numbers: IntArray) -> Callable[[int, int], int]:
    return lambda i, j: int(numbers[i, j])


def shift_notation(setting: Setting, *, exchanged: bool = False) -> Evidence:
    """Whether f_0, f_1, f_2, f_12 are the values at p, p_u, p_v, p_uv of each quad of the grid.

    Near-miss: the two shifts exchanged, which takes u for v.
    """
    shifts = {"first": (0, 1), "second": (1, 0)} if exchanged else {}
    failed = ""
    for n, m in _SIZES:
        numbers, complex_ = grid(n, m), rectangle(n, m)
        for face, (i, j) in enumerate(np.ndindex(n, m)):
            f_0, f_1, f_2, f_12 = printed.shifted(_entries(numbers), i, j, **shifts)
            if [f_0, f_1, f_12, f_2] != complex_.faces[face].tolist():
                failed = failed or f"quad ({i}, {j}) of {n} by {m}: f_1 is at vertex {f_1}"
    return statement(
        not failed,
        shown="on all grids up to 5 by 5 the four values are those at p, p_u, p_v, p_uv",
        witness=failed,
    )


def colorable(setting: Setting, *, ring: bool = False) -> Evidence:
    """Whether two-colourings of the faces and alternating divisions of the edges exist together.

    On unlabelled faces of disks: those of the corpus and stars of 3 to 8 quads, odd and even; both
    numbers must agree, 2 (exchanging names) or 0. ring: adds a ring of three quads, which is not
    simply connected.
    """
    meshes = {name: complex_.faces for name, complex_ in quad_meshes.corpus().items()}
    meshes |= {f"star of {k} quads": quad_meshes.odd_star(k) for k in range(3, 9)}
    if ring:
        meshes["ring of 3 quads"] = quad_meshes.ring(3)
    failed, numbers = "", set()
    for name, faces in meshes.items():
        # The corners of every other face are turned on, so that no labelling is given away.
        turned = np.array([np.roll(face, k % 4) for k, face in enumerate(faces)])
        colours, families = quad_meshes.colourings(turned), quad_meshes.labellings(turned)
        numbers.add(colours)
        if colours != families:
            failed = failed or f"{name}: {colours} colourings and {families} divisions"
    return statement(
        not failed and numbers == {0, 2},
        shown="on 12 simply connected quadgraphs there are two colourings and two divisions, or (3 "
        "stars with an odd number of quads) neither",
        witness=failed or f"numbers of colourings {sorted(numbers)}",
    )
