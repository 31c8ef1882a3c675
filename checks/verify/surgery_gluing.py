"""Checks of section 3.4: the domains of surgery, their gluing, and what complex results."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from random import Random
from typing import Any

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed import surgery as printed
from checks.printed.surgery import Sizes
from theory import quad_complex
from theory.glued_rectangles import (
    Place,
    Point,
    Rectangle,
    attachment_defects,
    quotient,
)
from theory.quad_surgery import replaced, square_grid

_SAMPLES = 12


def _length(rng: Random) -> Fraction:
    return Fraction(rng.randint(1, 30), rng.randint(2, 9))


def samples(setting: Setting) -> Iterator[Sizes]:
    """Random admissible lengths; in the first ones the new rays are as long as the old edges."""
    rng = setting.random()
    for k in range(_SAMPLES):
        u, v, rest_u, rest_v = (_length(rng) for _ in range(4))
        same = k == 0
        yield Sizes(
            u=u,
            v=v,
            u_max=u + rest_u,
            v_max=v + rest_v,
            u_new=rest_u if same else _length(rng),
            v_new=rest_v if same else _length(rng),
        )


def star_rectangles(s: Sizes) -> list[Rectangle]:
    """Divide the L-shaped Omega^* by its two lines through (u*, v*)."""
    zero = Fraction(0)
    corners = (
        ((zero, zero), (s.u, s.v)),
        ((s.u, zero), (s.u_max, s.v)),
        ((zero, s.v), (s.u, s.v_max)),
    )
    return [Rectangle(domain="Omega*", low=low, high=high) for low, high in corners]


def new_rectangles(s: Sizes) -> list[Rectangle]:
    """Return the rectangles Omega_1, Omega_2, Omega_3."""
    zero = Fraction(0)
    return [
        Rectangle(domain=name, low=(zero, zero), high=far)
        for name, far in printed.new_domains(s).items()
    ]


def branch_place(s: Sizes) -> Place:
    """Return the point (u*, v*) of Omega^*."""
    return "Omega*", (s.u, s.v)


def _needed(s: Sizes) -> list[tuple[str, Point]]:
    """Points of the two edges at (u*, v*) that must stay in Omega^*."""
    half_u, half_v = (s.u + s.u_max) / 2, (s.v + s.v_max) / 2
    return [
        ("the branch point", (s.u, s.v)),
        ("the middle of the u-edge", (half_u, s.v)),
        ("the middle of the v-edge", (s.u, half_v)),
        ("the end of the u-edge", (s.u_max, s.v)),
    ]


def _point_on_the_rim(s: Sizes) -> Sizes:
    """Move the point to the edge u = 0 of Omega_0."""
    return replace(s, u=Fraction(0), u_max=s.u_max - s.u)


def _broken_domain(s: Sizes, *, closed: bool, cut: bool) -> str:
    """Say how Omega^* fails to be what the lemma needs; empty where it does not."""
    sizes = f"u* = {s.u}, v* = {s.v}, u_max = {s.u_max}, v_max = {s.v_max}"
    for name, (u, v) in _needed(s):
        if cut and not printed.in_star_domain(s, (u, v), closed=closed):
            return f"{sizes}: {name} ({u}, {v}) is not in Omega^*"
    rectangles = star_rectangles(s) + new_rectangles(s)
    if flat := [r for r in rectangles if not (r.low[0] < r.high[0] and r.low[1] < r.high[1])]:
        return f"{sizes}: a rectangle of {flat[0].domain} has a side of length 0"
    for point in _grid(s):
        inside = printed.in_star_domain(s, point, closed=closed) if cut else True
        if inside != any(r.contains(point) for r in star_rectangles(s)):
            where = f"({point[0]}, {point[1]})"
            return f"{sizes}: {where} is in only one of Omega^* and the three rectangles"
    return ""


def domains(
    setting: Setting, *, closed: bool = True, cut: bool = True, interior: bool = True
) -> Evidence:
    """Omega^* has the edges that are glued, is the union of three rectangles, and no more.

    closed: whether the quadrant that is taken away contains its edges; cut: whether it is taken
    away at all; interior: whether (u*, v*) is inside Omega_0 or on its edge u = 0.
    """
    for s in samples(setting):
        sizes = s if interior else _point_on_the_rim(s)
        if witness := _broken_domain(sizes, closed=closed, cut=cut):
            return statement(False, shown="", witness=witness)
    return statement(
        True,
        shown="with the edges of the quadrant kept, Omega^* is the union of three closed "
        "rectangles that meet in (u*, v*)",
        witness="",
    )


def _grid(s: Sizes) -> list[Point]:
    """Points on and between all lines that bound a rectangle."""

    def places(inner: Fraction, end: Fraction) -> list[Fraction]:
        return [Fraction(0), inner / 2, inner, (inner + end) / 2, end]

    return [(u, v) for u in places(s.u, s.u_max) for v in places(s.v, s.v_max)]


def _complex(s: Sizes, names: tuple[str, ...], **changes: Any) -> tuple[list[str], list[Any]]:
    """Defects of the attaching maps of these names and of the complex, and its quads."""
    rectangles = star_rectangles(s) + new_rectangles(s)
    maps = {k: m for k, m in printed.attachments(s, **changes).items() if k in names}
    used = {segment[0][0] for pair in maps.values() for segment in pair}
    kept = [r for r in rectangles if r.domain in used | {"Omega*"}]
    found = attachment_defects(kept, maps)
    quads = quotient(kept, maps.values())
    return found or quad_complex.defects(quads), quads


def glued(s: Sizes) -> tuple[list[str], list[Any]]:
    """Defects and quads of the complex with chi_4 landing in Omega_2."""
    return _complex(s, ("chi_1", "chi_2", "chi_3", "chi_4"), fourth=2)


def attaching(
    setting: Setting,
    *,
    second: int = 2,
    fourth: int = 3,
    shifts: str = "u,v",
    reverse: bool = False,
) -> Evidence:
    """Maps of (eq:attaching): bijections of whole edges, which glue a disk; parameters as there."""
    names = ("chi_1", "chi_2", "chi_3", "chi_4")
    for s in samples(setting):
        found, quads = _complex(
            s, names, second=second, fourth=fourth, shifts=shifts, reverse=reverse
        )
        inner = quad_complex.interior_degrees(quads)
        if not found and list(inner) != [branch_place(s)]:
            found = [f"the inner vertices are {list(inner)}, not (u*, v*) alone"]
        if found:
            lengths = f"u~ = {s.u_new}, v~ = {s.v_new}, v_max - v* = {s.v_max - s.v}"
            return statement(False, shown="", witness=f"{lengths}: {found[0]}")
    return statement(
        True,
        shown="each map takes a whole edge to a whole edge of the same family and length, no edge "
        "is used twice, and the six rectangles form a strongly regular disk whose one inner "
        "vertex is (u*, v*)",
        witness="",
    )


def stages(
    setting: Setting, *, line: str = "u", keeps_point: bool = True, faces: int = 4
) -> Evidence:
    """Stages (a) to (c) of fig:asymptoticcoordinatepatches: 1, 3 and 4 rectangles.

    line: the axis of Omega_1 that chi_1 glues to the u-edge; keeps_point: whether Omega^* has its
    edges at (u*, v*); faces: number of rectangles in stage (c).
    """
    for s in samples(setting):
        maps = printed.attachments(s, fourth=2)
        source, target = maps["chi_1"]
        if line == "v":
            source = maps["chi_4"][0]
        parts = star_rectangles(s) if keeps_point else star_rectangles(s)[:1]
        kept = parts + new_rectangles(s)[:1]
        found = attachment_defects(kept, {"chi_1": (source, target)})
        quads = quotient(kept, [(source, target)])
        found = found or quad_complex.defects(quads)
        degree = quad_complex.degrees(quads)[branch_place(s)]
        on_rim = branch_place(s) in quad_complex.boundary_vertices(quads)
        if not found and (len(quads), degree, on_rim) != (faces, 5, True):
            found = [f"{len(quads)} faces, {degree} edges at (u*, v*)"]
        if found:
            return statement(False, shown="", witness=f"stage (c): {found[0]}")
    return statement(
        True,
        shown="Omega^* is the rectangle without its far quadrant; with Omega_1 glued along its "
        "u-line there are four faces, (u*, v*) is on the rim and five edges leave it",
        witness="",
    )


def rays(setting: Setting, *, number: int = 6, sectors: int = 3) -> Evidence:
    """Edges at (u*, v*) after surgery, in the glued complex and by surgery on a grid.

    number: of the rays; sectors: how many replace the one cut out.
    """
    grid = square_grid(4, 3)
    start = next(quad for quad in grid if quad[0] == (2, 1))
    cut = replaced(grid, start, (2, 1), sectors=sectors)
    on_grid = quad_complex.interior_degrees(cut)[2, 1]
    found = {on_grid}
    for s in samples(setting):
        _, quads = glued(s)
        found.add(quad_complex.interior_degrees(quads)[branch_place(s)])
    return statement(
        found == {number},
        shown="six edges meet at (u*, v*), u- and v-edges in turn, in the complex of the "
        "attaching maps and after surgery on a grid, where four met before",
        witness=f"{on_grid} edges meet after surgery on a grid with {sectors} new sectors; on the "
        f"grid and in the glued complex together {sorted(found)}, not {number} alone",
    )


def _surgery_at(
    quads: list[Any], vertex: Any, start: int, change: dict[str, Any], name: str
) -> tuple[list[str], list[Any], list[Any]]:
    """Complaints, quads and the vertices whose degree changed after one surgery."""
    faces = [quad for quad in quads if vertex in quad]
    after = replaced(quads, faces[start % len(faces)], vertex, name=name, **change)
    before, now = quad_complex.interior_degrees(quads), quad_complex.interior_degrees(after)
    changed = [v for v, degree in now.items() if degree != before.get(v, 4)]
    return quad_complex.defects(after), after, changed


def _one_surgery(
    quads: list[Any], vertex: Any, start: int, change: dict[str, Any], gain: int, name: str
) -> tuple[str, list[Any]]:
    """Say what is wrong with a surgery, and return the quads after it."""
    before = quad_complex.interior_degrees(quads)[vertex]
    found, after, changed = _surgery_at(quads, vertex, start, change, name)
    now = quad_complex.interior_degrees(after)[vertex]
    if found:
        return f"{name}: {found[0]}", after
    if now != before + gain:
        return f"{name} at {vertex}: {before} edges become {now}", after
    if [v for v in changed if v != vertex]:
        return f"{name}: the degree of {changed} changes", after
    return "", after


def repeated(
    setting: Setting, *, sectors: int = 3, gain: int = 2, to_the_rim: bool = True
) -> Evidence:
    """Surgery in a face, on a glued edge and at a branch point, one after the other.

    sectors: new ones for the one cut out; gain: by how much 2m grows; to_the_rim: whether the
    sector cut out ends on the rim of the complex, or after its first quad.
    """
    quads = square_grid(4, 4)
    places: list[tuple[Any, int, str]] = [
        ((2, 2), -1, "first"),
        (("first", 0, 1, 1), -1, "in a face"),
        ((3, 2), 1, "on an edge"),
        ((2, 2), 1, "at the branch point"),
    ]
    change = {"sectors": sectors, "reach": None if to_the_rim else 1}
    for vertex, start, name in places:
        wrong, quads = _one_surgery(quads, vertex, start, change, gain, name)
        if wrong:
            return statement(False, shown="", witness=wrong)
    return statement(
        True,
        shown="four surgeries, at a regular point, inside a new face, on a glued edge and again at "
        "the first branch point: each adds 2 to 2m there, changes no other inner vertex, and "
        "leaves a strongly regular disk with alternating families",
        witness="",
    )


def generations(setting: Setting, *, sectors: int = 3, second: int = 2) -> Evidence:
    """Second generation of branch points: surgery inside the new sectors of a first surgery.

    second: number of branch points of the second generation, in as many new sectors.
    """
    quads = square_grid(4, 4)
    start = next(quad for quad in quads if quad[0] == (2, 2))
    quads = replaced(quads, start, (2, 2), sectors=sectors, name="first")
    for k in range(min(second, sectors)):
        vertex = ("first", k, 1, 1)
        face = next(quad for quad in quads if quad[0] == vertex)
        quads = replaced(quads, face, vertex, sectors=sectors, name=f"second {k}")
    found = quad_complex.defects(quads)
    orders = sorted(d for d in quad_complex.interior_degrees(quads).values() if d > 4)
    wanted = [6] * (1 + second)
    return statement(
        not found and orders == wanted and second >= 1,
        shown="with branch points inside two of the new sectors the complex is still a strongly "
        "regular disk, with three vertices of degree 6",
        witness=found[0] if found else f"the inner vertices above degree 4 have degrees {orders}",
    )
