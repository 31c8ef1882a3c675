"""Checks of the definitions of quad-graphs and asymptotic complexes: instances and near misses.

The printed conditions, face by face and pair by pair, against the arrays of the library.
"""

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from itertools import permutations, product
from random import Random

import numpy as np

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed import asymptotic_complexes as printed
from checks.verify.asymptotic_complexes_samples import (
    coordinates,
    disks,
    generator,
    others,
    samples,
    turned,
)
from discrete import quad_graph
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import ComplexError
from discrete.face_coordinates import FaceCoordinates, Point

Faces = Sequence[Sequence[int]]
_PARTS = tuple(Fraction(n, 5) for n in range(6))


def _compared(
    candidates: Sequence[Faces],
    as_printed: Callable[[Faces], bool],
    as_built: Callable[[Faces], bool],
    shown: str,
) -> Evidence:
    """Evidence that two decisions agree on all candidates, some accepted and some refused."""
    accepted = 0
    for faces in candidates:
        expected = as_printed(faces)
        accepted += expected
        if expected != as_built(faces):
            verb = "accepts" if expected else "refuses"
            return statement(
                False, shown="", witness=f"the definition {verb} the faces {faces}, the library not"
            )
    refused = len(candidates) - accepted
    return Evidence(
        outcome="pass" if accepted and refused else "undecided",
        grade="exact",
        residual="0",
        tried=len(candidates),
        met=len(candidates),
        shown=f"{shown}: {accepted} instances accepted, {refused} near misses refused",
    )


def regular_face(setting: Setting, *, edges: bool = True, vertices: bool = True) -> Evidence:
    """Item (i): every quadrilateral with corners among 4 vertices, all 256 of them."""
    candidates = [(corners,) for corners in product(range(4), repeat=4)]
    return _compared(
        candidates,
        lambda faces: printed.is_regular_face(faces[0], edges=edges, vertices=vertices),
        lambda faces: quad_graph.repeated_corner(np.array(faces)) is None,
        "edges and vertices pairwise distinct",
    )


def regular_meeting(setting: Setting, *, most_vertices: int = 1, most_edges: int = 1) -> Evidence:
    """Item (ii): one rectangle and every other one with corners among 8 vertices."""
    first = (0, 1, 2, 3)
    candidates = [(first, other) for other in permutations(range(8), 4)]
    return _compared(
        candidates,
        lambda faces: printed.meet_regularly(
            faces[0], faces[1], most_vertices=most_vertices, most_edges=most_edges
        ),
        lambda faces: quad_graph.double_contact(np.array(faces)) is None,
        "two faces meet in nothing, one vertex, or one edge",
    )


def _is_quad_graph(faces: Faces) -> bool:
    array = np.array(faces)
    if quad_graph.repeated_corner(array) is not None:
        return False
    sides = quad_graph.sides(array)
    return (
        quad_graph.crowded_edge(sides) is None
        and quad_graph.double_contact(array) is None
        and quad_graph.pinched_vertex(sides) is None
    )


def _numbered(faces: Faces) -> Faces:
    """Faces with their vertices numbered from 0 without gaps."""
    used = sorted({corner for face in faces for corner in face})
    return tuple(tuple(used.index(corner) for corner in face) for face in faces)


def _gathered(rng: Random, count: int, *, faces: int = 3, vertices: int = 8) -> list[Faces]:
    """Random triples of quadrilaterals with few vertices, and some that surely fit together."""
    drawn = [
        _numbered([rng.sample(range(vertices), 4) for _ in range(faces)]) for _ in range(count)
    ]
    pinched = ((0, 1, 2, 3), (0, 4, 5, 6))
    book = ((0, 1, 2, 3), (0, 1, 4, 5), (0, 1, 6, 7))
    fitting = [complex_.faces.tolist() for complex_ in (disks() | others()).values()]
    return [pinched, book, *drawn, *fitting]


def quad_graphs(
    setting: Setting, *, corners: int = 4, most: int = 2, fans: int = 1, regular: bool = True
) -> Evidence:
    """Definition of a quad-graph on samples and on random triples of quadrilaterals."""
    limits = {"corners": corners, "most": most, "fans": fans}
    return _compared(
        _gathered(setting.random(), 400),
        lambda faces: printed.is_quad_graph(faces, **limits, regular=regular),
        _is_quad_graph,
        "strongly regular cells of a surface",
    )


def edge_families(setting: Setting, *, step: int = 1) -> Evidence:
    """Item (ii) of the complex: all labellings of the edges of small quad-graphs, by trial.

    step: how far apart around a face the edges of different families are.
    """
    small = {
        "block of 2 by 2": disks()["smooth star"],
        "monkey star": disks()["monkey star"],
        "cylinder of 3": others()["cylinder of 3"],
    }
    for name, complex_ in small.items():
        labellings = _labellings(complex_.sides.edge_of.tolist(), step=step)
        library = tuple(int(u) for u in complex_.edge_is_u)
        if library not in labellings or len(labellings) != 2:
            return statement(
                False,
                shown="",
                witness=f"{name}: {len(labellings)} labellings; that of the library is "
                f"{'one' if library in labellings else 'none'} of them",
            )
    fan = quad_graph.sides(np.array([[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]]))
    left = _labellings(fan.edge_of.tolist(), step=step)
    return statement(
        not left,
        shown="the edges of each sample have just two labellings, one of them the library's, the "
        "other with the families swapped; three rectangles around a vertex have none",
        witness=f"three rectangles around a vertex have the labelling {left[:1]}",
    )


def _labellings(edge_of: Sequence[Sequence[int]], *, step: int) -> list[tuple[int, ...]]:
    """Every family (1 for u) of the edges for which those around each face are as printed."""
    found: list[dict[int, int]] = [{}]
    for edges in edge_of:
        found = [
            {**known, **dict(zip(edges, trial, strict=True))}
            for known in found
            for trial in product((0, 1), repeat=4)
            if printed.alternates(trial, step=step)
            and all(known.get(e, t) == t for e, t in zip(edges, trial, strict=True))
        ]
    return [tuple(known[edge] for edge in sorted(known)) for known in found]


def face_coordinates(setting: Setting, *, positive: bool = True, across: int = 1) -> Evidence:
    """Item (i) of the complex: rectangles of random sizes, each side of a face on its own side.

    positive: whether u_k, v_k > 0 is asked; across: from a corner to which next one sides run.
    """
    rng = generator(setting)
    for name, complex_ in samples(setting, simply_connected=False, random=4).items():
        chart = coordinates(turned(complex_, rng), rng)
        for face in range(len(chart.sizes)):
            if witness := _not_a_rectangle(chart, face, across):
                return statement(False, shown="", witness=f"{name}: {witness}")
    lengths = [Fraction(n) for n in (1, 2, 0, -1)]
    for u, v in product(lengths, lengths):
        asked = (u > 0 and v > 0) or not positive
        if _is_built(((0, 1, 2, 3),), ((u, v),)) != asked:
            where = f"[0, {u}] x [0, {v}]"
            return statement(False, shown="", witness=f"no homeomorphism of a face to {where}")
    return statement(
        True,
        shown="every face has a rectangle, its corners and sides those of the face; sides that are "
        "not positive are refused",
        witness="",
    )


def _is_built(faces: Faces, sizes: Sequence[Point]) -> bool:
    """Whether the library accepts these faces with rectangles of these sizes."""
    try:
        FaceCoordinates(complex=AsymptoticComplex(faces=np.array(faces)), sizes=sizes)
    except ComplexError:
        return False
    return True


def _not_a_rectangle(chart: FaceCoordinates, face: int, across: int) -> str:
    corners, (u, v) = chart.complex.faces[face].tolist(), chart.sizes[face]
    at = [chart.corner(face, corner) for corner in range(4)]
    if sorted(at) != sorted(product((Fraction(0), u), (Fraction(0), v))):
        return f"the corners of face {face} are {at}"
    for side in range(4):
        ends = (corners[side], corners[(side + across) % 4])
        points = [chart.on_edge(face, ends, part) for part in _PARTS]
        constant = 1 - side % 2
        if len({point[constant] for point in points}) != 1 or len(set(points)) != len(points):
            return f"side {side} of face {face} is no side of the rectangle"
    return ""


def attaching_u(
    setting: Setting, *, reversal: bool = True, sign: int = -1, share: str = "1"
) -> Evidence:
    """Item (iii): attaching maps along u-edges of random complexes against the two printed ones.

    reversal: whether u -> u_k - u is allowed; sign, share: its constants.
    """
    return _attaching(setting, 0, reversal=reversal, sign=sign, share=share)


def attaching_v(
    setting: Setting, *, reversal: bool = True, sign: int = -1, share: str = "1"
) -> Evidence:
    """Item (iii), last sentence: the same along v-edges."""
    return _attaching(setting, 1, reversal=reversal, sign=sign, share=share)


def _attaching(setting: Setting, along: int, *, reversal: bool, sign: int, share: str) -> Evidence:
    """Evidence for the edges along one coordinate, 0 for u and 1 for v."""
    rng = generator(setting)
    kept = turned_round = 0
    for name, complex_ in samples(setting, simply_connected=False, random=4).items():
        chart = coordinates(turned(complex_, rng), rng)
        for pair in chart.complex.sides.matched.tolist():
            if pair[0] % 2 != along:
                continue
            kinds = [
                reversed_
                for reversed_ in ((False, True) if reversal else (False,))
                if _is_attached(chart, pair, along, reversed_=reversed_, sign=sign, share=share)
            ]
            if not kinds:
                return statement(False, shown="", witness=_attaching_witness(name, chart, pair))
            kept, turned_round = kept + (not kinds[0]), turned_round + kinds[0]
    tried = kept + turned_round
    return Evidence(
        outcome="pass" if kept and turned_round else "undecided",
        grade="exact",
        residual="0",
        tried=tried,
        met=tried,
        shown=f"on every common edge the coordinate along it is kept ({kept} edges) or reversed "
        f"({turned_round}), the other one is constant and at an end, and the lengths agree",
    )


def _faces_on(chart: FaceCoordinates, pair: Sequence[int]) -> tuple[int, int, tuple[int, int]]:
    face, other = pair[0] // 4, pair[1] // 4
    corners = chart.complex.faces[face]
    return face, other, (int(corners[pair[0] % 4]), int(corners[(pair[0] + 1) % 4]))


def _is_attached(
    chart: FaceCoordinates,
    pair: Sequence[int],
    along: int,
    *,
    reversed_: bool,
    sign: int,
    share: str,
) -> bool:
    face, other, ends = _faces_on(chart, pair)
    length, across = chart.sizes[face][along], 1 - along
    for part in _PARTS:
        one, image = (chart.on_edge(at, ends, part) for at in (face, other))
        wanted = printed.attached(one[along], length, reversed_=reversed_, sign=sign, share=share)
        at_ends = one[across] in (0, chart.sizes[face][across]) and (
            image[across] in (0, chart.sizes[other][across])
        )
        if image[along] != wanted or not at_ends:
            return False
    return length == chart.sizes[other][along]


def _attaching_witness(name: str, chart: FaceCoordinates, pair: Sequence[int]) -> str:
    face, other, ends = _faces_on(chart, pair)
    part = Fraction(1, 5)
    one, image = (chart.on_edge(at, ends, part) for at in (face, other))
    u, v = chart.sizes[face]
    return (
        f"{name}: ({one[0]}, {one[1]}) in a face of the sides {u} by {v}"
        f" goes to ({image[0]}, {image[1]}) in the next"
    )


_ONE, _TWO = Fraction(1), Fraction(2)
_BROKEN: tuple[tuple[Faces, tuple[Point, Point]], ...] = (
    (((0, 1, 2, 3), (0, 1, 2, 4)), ((_ONE, _ONE), (_ONE, _ONE))),  # two common edges
    (((0, 1, 2, 3), (0, 1, 2, 3)), ((_ONE, _ONE), (_ONE, _ONE))),  # four common edges
    (((0, 1, 2, 3), (1, 2, 5, 4)), ((_ONE, _ONE), (_ONE, _ONE))),  # a u-side on a v-side
    (((0, 1, 2, 3), (2, 5, 4, 1)), ((_ONE, _ONE), (_ONE, _TWO))),  # lengths 1 and 2
    (((0, 1, 2, 3), (2, 5, 4, 1)), ((_ONE, _ONE), (_TWO, _ONE))),  # an instance
)


def asymptotic_complex(
    setting: Setting, *, regular: bool = True, families: bool = True, lengths: bool = True
) -> Evidence:
    """Definition of an asymptotic complex on samples with sizes, and with each condition broken.

    regular, families, lengths: the conditions that the definition asks for.
    """
    rng = generator(setting)
    asked = {"regular": regular, "families": families, "lengths": lengths}
    found: list[tuple[Faces, Sequence[Point]]] = list(_BROKEN)
    for complex_ in samples(setting, simply_connected=False, random=4).values():
        chart = coordinates(turned(complex_, rng), rng)
        found.append((chart.complex.faces.tolist(), chart.sizes))
    return _compared(
        [faces for faces, _ in found],
        _each(printed.is_asymptotic_complex(faces, sizes, **asked) for faces, sizes in found),
        _each(_is_built(faces, sizes) for faces, sizes in found),
        "rectangles glued along sides of one family and one length",
    )


def _each(decisions: Iterable[bool]) -> Callable[[Faces], bool]:
    """Decisions taken beforehand, one for each call."""
    taken = iter(list(decisions))
    return lambda _: next(taken)


def faces_of_four_sides(setting: Setting, *, step: int = 1) -> Evidence:
    """Sides of the faces of the samples: two pairs of opposite edges, of the two families."""
    for name, complex_ in samples(setting, simply_connected=False, random=4).items():
        for face, edges in enumerate(complex_.sides.edge_of):
            families = ["u" if u else "v" for u in complex_.edge_is_u[edges]]
            disjoint = all(
                not set(complex_.edges[edges[k]]) & set(complex_.edges[edges[k + 2]])
                for k in (0, 1)
            )
            if not (printed.alternates(families, step=step) and disjoint):
                return statement(
                    False,
                    shown="",
                    witness=f"{name}: face {face} has sides of the families {' '.join(families)}",
                )
    return statement(
        True, shown="every face has two u-sides and two v-sides, opposite ones apart", witness=""
    )
