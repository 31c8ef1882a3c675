"""Checks of lemma (lem:surgery) as a whole, and of the front that its pieces make up."""

from fractions import Fraction

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from checks.printed.surgery import Sizes
from checks.verify import surgery_gluing as gluing
from checks.verify import surgery_sectors as series
from checks.verify.surgery_fronts import conserved_speeds, fronts_agree
from theory import quad_complex, star_saddle
from theory.quad_surgery import replaced, square_grid

_ANGLES = (sp.pi / 2, sp.pi / 3, sp.pi * 2 / 5, sp.pi * 5 / 6)


def _index(sectors: int, order: int) -> Evidence:
    """Index of the normal at the point for several angles cut out, against 1 - order."""
    for angle in _ANGLES:
        fan = (angle / sectors,) * sectors
        star = (sp.pi - angle, angle, sp.pi - angle, *fan)
        found = star_saddle.winding_number(star) if len(star) % 2 == 0 else None
        if found != 1 - order:
            return statement(
                False,
                shown="",
                witness=f"the normal winds {found} times about the star with {len(star)} sectors, "
                f"the angle cut out being {angle}; a branch point of order {order} has {1 - order}",
            )
    return statement(True, shown=f"index {1 - order}", witness="")


def _interior(sectors: int, order: int, vertex: tuple[int, int]) -> Evidence:
    """Degree of the vertex after surgery on a grid: an inner vertex with 2 order edges."""
    grid = square_grid(4, 3)
    start = next(quad for quad in grid if quad[0] == vertex)
    after = replaced(grid, start, vertex, sectors=sectors)
    found = quad_complex.defects(after)
    degree = quad_complex.interior_degrees(after).get(vertex)
    return statement(
        not found and degree == 2 * order,
        shown="an inner vertex",
        witness=found[0]
        if found
        else f"{vertex} is an inner vertex with {degree} edges; on the rim there is no degree",
    )


def _rays_have_length(length: Fraction) -> Evidence:
    """The glued complex for new rays of this length."""
    sizes = Sizes(
        u=Fraction(1),
        v=Fraction(1),
        u_max=Fraction(2),
        v_max=Fraction(3),
        u_new=length,
        v_new=length,
    )
    found, _ = gluing.glued(sizes)
    return statement(not found, shown="a disk", witness="; ".join(found[:1]))


def lemma(
    setting: Setting,
    *,
    fourth: int = 2,
    sectors: int = 3,
    order: int = 3,
    interior: bool = True,
    harmonic: bool = True,
    ray: str = "1",
) -> Evidence:
    """Existence: a complex, fronts on its faces that agree on edges, and a branch point.

    fourth: where chi_4 lands; sectors: how many replace the one cut out; order: of the branch
    point; interior: whether (u*, v*) is inside Omega_0 or on its edge;
    harmonic: whether N_uv is parallel to N; ray: length of the new rays.
    """
    return combined(
        {
            "maps": gluing.attaching(setting, fourth=fourth),
            "lengths": _rays_have_length(Fraction(ray)),
            "point": _interior(sectors, order, (2, 1) if interior else (0, 1)),
            "index": _index(sectors, order),
            "harmonic": conserved_speeds(setting, harmonic=harmonic),
            "side": series.side_sector(setting),
            "middle": series.middle_sector(setting),
            "opposite side": series.opposite_side_sector(setting),
            "edges": series.edges_agree(setting, fourth=fourth),
        },
        shown="with chi_4 landing in Omega_2 six rectangles form a disk with (u*, v*) inside; the "
        "three normals are unit and harmonic with speeds that persist, the fronts agree on the "
        "four edges, and (u*, v*) has six rays and index -2, so it is a branch point of order 3",
    )


def assembled(
    setting: Setting, *, fourth: int = 2, start: bool = True, second: int = 2
) -> Evidence:
    """Branched front on the complex: continuous across all edges, r_0 on Omega^*.

    fourth, second: where chi_4 and chi_2 land; start: whether r_1, r_2, r_3 all start from z_1.
    """
    return combined(
        {
            "complex": gluing.attaching(setting, fourth=fourth, second=second),
            "first edge": fronts_agree(setting, outer=0, start=start),
            "edges": series.edges_agree(setting, fourth=fourth, starts="1,2,3" if start else "1,2"),
        },
        shown="the maps glue a strongly regular disk of six faces, on Omega^* the front is r_0 by "
        "definition, and across the four glued edges places and normals agree",
    )
