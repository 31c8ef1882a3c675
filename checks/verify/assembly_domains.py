"""Checks of section 4: the rectangles of discrete assembly, how they are attached and labelled."""

from collections.abc import Sequence

import numpy as np

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed import spherical_nets as printed
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import ComplexError
from discrete.gluing import star
from discrete.signed_graph import IntArray, components

_LENGTHS = ((1, 1, 1, 1), (2, 2, 2, 2), (3, 2, 4, 1), (2, 1, 3, 2, 1, 2), (1, 2) * 4)


def _glued_domains(lengths: Sequence[int], onto: str, back: int) -> tuple[IntArray, str]:
    """Faces of the rectangles J_i joined by the maps chi_i, or what does not fit."""
    count = len(lengths)
    sizes = [printed.domain(i, tuple(lengths), back=back) for i in range(1, count + 1)]
    starts = np.cumsum([0, *((n + 1) * (m + 1) for n, m in sizes)])

    def number(i: int, at: tuple[int, int]) -> int:
        return int(starts[i] + at[0] * (sizes[i][1] + 1) + at[1])

    links = []
    for i, (n, _) in enumerate(sizes):
        before = (i - 1) % count
        for k in range(n + 1):
            image = printed.attaching_map(k, n, onto=onto)
            if image[0] > sizes[before][0] or image[1] > sizes[before][1]:
                return np.zeros((0, 4), dtype=np.int64), (
                    f"l = {tuple(lengths)}: chi_{i + 1}({k}, 0) = {image} is not in J_{i} of "
                    f"{sizes[before]}"
                )
            links.append((number(i, (k, 0)), number(before, image)))
    _, place = components(int(starts[-1]), np.array(links, dtype=np.int64))
    faces = []
    for i, (n, m) in enumerate(sizes):
        for a in range(n):
            for b in range(m):
                corners = [(a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1)]
                if i % 2:
                    corners = [corners[0], corners[3], corners[2], corners[1]]
                faces.append([place[number(i, at)] for at in corners])
    used, numbered = np.unique(np.array(faces), return_inverse=True)
    del used
    return numbered.reshape(-1, 4), ""


def _star_defect(lengths: Sequence[int], onto: str, back: int = 1) -> str:
    """What keeps the glued rectangles from being the shipped star, or nothing."""
    faces, wrong = _glued_domains(lengths, onto, back)
    if wrong:
        return wrong
    try:
        found = AsymptoticComplex(faces=faces)
    except ComplexError as error:
        return f"l = {tuple(lengths)}: {error}"
    expected = star(list(lengths))
    same = (
        found.is_disk
        and found.vertex_count == expected.vertex_count
        and sorted(found.saddle_order.tolist()) == sorted(expected.saddle_order.tolist())
    )
    if same:
        return ""
    return (
        f"l = {tuple(lengths)}: {found.vertex_count} vertices in place of "
        f"{expected.vertex_count}, disk: {found.is_disk}"
    )


def attaching(setting: Setting, *, onto: str = "previous") -> Evidence:
    """Whether the maps chi_i make the rectangles J_i a star around one vertex of degree 2m."""
    defects = [_star_defect(lengths, onto) for lengths in _LENGTHS]
    failed = next((defect for defect in defects if defect), "")
    return statement(
        not failed,
        shown="for five sequences of lengths, with 4, 6 and 8 rectangles, the maps identify whole "
        "sides and give the shipped star",
        witness=failed,
    )


def domains(setting: Setting, *, back: int = 1) -> Evidence:
    """Whether the rectangles have the sizes of the shipped star's sectors; back: l_(i - back)."""
    failed = ""
    for lengths in _LENGTHS:
        sizes = [printed.domain(i, lengths, back=back) for i in range(1, len(lengths) + 1)]
        count = sum(n * m for n, m in sizes)
        sides = [n == lengths[i] for i, (n, _) in enumerate(sizes)]
        if count != len(star(list(lengths)).faces) or not all(sides):
            failed = failed or f"l = {lengths}: rectangles {sizes} with {count} quads"
    return statement(
        not failed,
        shown="for five sequences of lengths the rectangles have as many quads as the shipped "
        "star, and J_i has the sides l_(i-1) and l_i, with l_0 = l_2m",
        witness=failed,
    )


def families(setting: Setting, *, odd: bool = False) -> Evidence:
    """Whether u-edges for even i and v-edges for odd i are consistent on every rectangle.

    The two sides gamma_(i-1) and gamma_i of J_i have to be of different families, the curves being
    counted modulo their number; odd: an odd number of curves.
    """
    failed = ""
    for count in range(5 if odd else 4, 13, 2):
        is_u = [i % 2 == 0 for i in range(count)]
        same = [i for i in range(1, count + 1) if is_u[(i - 1) % count] == is_u[i % count]]
        if same:
            failed = failed or f"{count} curves: both sides of J_{same[0]} are of one family"
        elif (star([1] * count).checkerboard is None) or _star_defect([1] * count, "0"):
            failed = failed or f"{count} curves: the star is no asymptotic complex"
    return statement(
        not failed,
        shown="for 4, 6, 8, 10, 12 curves the sides of each rectangle are of different families, "
        "and the shipped star takes the same division",
        witness=failed,
    )
