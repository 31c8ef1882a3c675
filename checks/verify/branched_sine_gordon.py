"""Checks of the sine-Gordon equation on domains with several branch points (thm:sg-branched)."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import branched_sine_gordon as printed
from checks.printed import fundamental_forms
from checks.verify.nets import ROUTES, all_nets, over_nets, squared_norm
from checks.verify.tilings import charge, implied, over, random_tilings
from theory.asymptotic_net import AsymptoticNet
from theory.asymptotic_tiling import Face, Tiling, Vertex
from theory.reparametrisation import Change, changed
from theory.star_field import StarField, lengths
from theory.tiling_angles import PI, Relation, TilingAngles, added, scaled


def _rule(
    angles: TilingAngles, *, choice: str, regular: int, sign: int, area_percent: int
) -> Relation:
    """Left side minus right side of (sg-global), times 100, as a relation.

    choice: of phi at a corner with several limits; the constants are those of the formula.
    """
    orders = angles.tiling.branch_points.values()
    value = sum((printed.concentration(m, regular=regular, sign=sign) for m in orders), sp.S.Zero)
    return added(
        scaled(100, angles.rim_sum(choice)),
        scaled(-area_percent, angles.area()),
        {PI: -100 * int(sp.expand(value / sp.pi))},
    )


def sum_rule(
    setting: Setting,
    *,
    only_off_rays: bool = True,
    choice: str = "first",
    regular: int = 2,
    sign: int = -1,
    area_percent: int = 100,
    matched: bool = True,
    continuous: bool = True,
) -> Evidence:
    """(sg-global) as a consequence of what every surface over a random tiling satisfies.

    only_off_rays: whether corners on curves that leave a branch point inside are excluded; choice:
    of phi at a corner with several limits; matched, continuous: see theory.tiling_angles.
    """
    tilings, tried = random_tilings(setting, only_off_rays=only_off_rays)
    rows = (
        (
            angles.tiling,
            angles.is_consistent()
            and angles.implies(
                _rule(angles, choice=choice, regular=regular, sign=sign, area_percent=area_percent)
            ),
        )
        for angles in over(tilings, matched=matched, continuous=continuous)
    )
    return implied(
        rows,
        tried=tried,
        met=len(tilings),
        what="the sum rule",
        shown="on 30 random tiled disks, a third of them with three branch points or more and a "
        "third with reflex corners, the rule holds for every surface: exact ranks; for other "
        "tilings it follows by hand, as in the proof, from their stars and rectangles",
    )


def limits_on_rays(
    setting: Setting, *, choice: str = "middle", regular: int = 2, matched: bool = True
) -> Evidence:
    """(sg-global) with corners and jumps anywhere, phi taken from the middle quadrant inside."""
    return sum_rule(
        setting,
        only_off_rays=False,
        choice=choice,
        regular=regular,
        matched=matched,
        continuous=False,
    )


def boundary_fan(setting: Setting, *, count: int = 4, regular: int = 2) -> Evidence:
    """(sg-global) on count of the six sectors of a star of order 3, its centre on the boundary."""
    field, rays = StarField(order=3), lengths(3)
    polygon = field.fan(count, rays)
    left = field.alternating_sum(polygon, last=field.family(count))
    area = sum(field.area_from_p(*corner) for corner in field.star(rays)[:count])
    return identities(
        setting,
        {f"{count} of 6 sectors, the branch point on the boundary": sp.expand(left - area)},
        shown="the sum over two sectors at a branch point between two curves of one family is "
        "their area",
    )


def theorem(
    setting: Setting,
    *,
    on_boundary: bool = True,
    only_off_rays: bool = False,
    regular: int = 2,
    sign: int = -1,
    matched: bool = True,
) -> Evidence:
    """(thm:sg-branched) for all Hamburger polygons, or those that the hypotheses leave.

    on_boundary: whether a branch point may lie on the polygon, where it is not in the domain;
    only_off_rays: whether corners on curves that leave a branch point inside are excluded.
    """
    parts = {}
    if on_boundary:
        parts["on the boundary"] = boundary_fan(setting)
    parts["inside"] = sum_rule(
        setting,
        only_off_rays=only_off_rays,
        regular=regular,
        sign=sign,
        matched=matched,
    )
    return combined(parts, shown=parts["inside"].shown)


_FLIPS: dict[str, Change] = {"u": ((-1, 0), (0, 1)), "v": ((1, 0), (0, -1))}


def one_angle(setting: Setting, *, flips: str = "u,v", cosine_power: int = 1) -> Evidence:
    """The conditions of the theorem on phi: one angle, that of (eq:def_phi), also after flips."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        found = {}
        for name, seen in {
            "": net,
            **{f", flip {f}": changed(net, _FLIPS[f]) for f in flips.split(",")},
        }.items():
            dot = seen.calculus.dot
            cosine = fundamental_forms.cosine(
                dot(seen.r_u, seen.r_v), seen.sigma, sigma_power=cosine_power
            )
            area = squared_norm(seen, seen.calculus.cross(seen.r_u, seen.r_v))
            found[f"cosine{name}"] = cosine - net.cos_phi
            found[f"sine^2{name}"] = area - net.sin_phi**2
            found[f"cos^2 + sin^2 - 1{name}"] = cosine**2 + area - 1
        return found

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"cosine and sine belong to one angle in (0, pi), the same after flips, {ROUTES}",
    )


def _pieces(tiling: Tiling, *, refine: bool) -> tuple[Tiling, list[list[int]]]:
    """Faces round each branch point as stars, and the others one by one."""
    fine = tiling.refined() if refine else tiling
    around: dict[Vertex, list[int]] = {vertex: [] for vertex in fine.branch_points}
    single = []
    for index, face in enumerate(fine.faces):
        centres = [vertex for vertex in face if vertex in around]
        for vertex in centres:
            around[vertex].append(index)
        if not centres:
            single.append([index])
    return fine, [*around.values(), *single]


def _piece(tiling: Tiling, faces: list[int]) -> Tiling:
    chosen: tuple[Face, ...] = tuple(tiling.faces[index] for index in faces)
    return Tiling(faces=chosen)


def decomposition(setting: Setting, *, refine: bool = True, per_order: int = 2) -> Evidence:
    """Stars round the branch points and single rectangles that make up random tilings.

    refine: whether each rectangle is divided in four first, so that no star meets another;
    per_order: sectors of a star by its order.
    """
    tilings, tried = random_tilings(setting, smallest_charge=1)
    wrong = []
    for tiling in tilings:
        fine, pieces = _pieces(tiling, refine=refine)
        covered = sorted(index for piece in pieces for index in piece)
        if covered != list(range(len(fine.faces))):
            wrong.append("a rectangle belongs to two stars")
            break
        for piece in pieces:
            part = _piece(fine, piece)
            corners = TilingAngles(tiling=part).rim_corners()
            order = max(part.branch_points.values(), default=2)
            sides = per_order * order
            if not (part.is_disk() and len(piece) in (1, sides) and len(corners) in (4, sides)):
                wrong.append(f"a piece of {len(piece)} faces has {len(corners)} corners")
    found = statement(
        not wrong,
        shown="30 random tilings with branch points of order 3 to 5 are unions, without overlap, "
        "of stars of 2m rectangles and single rectangles, each bounded by a Hamburger polygon",
        witness="; ".join(wrong[:1]),
    )
    return Evidence(
        outcome=found.outcome,
        grade=found.grade,
        residual=found.residual,
        witness=found.witness,
        shown=found.shown,
        tried=tried,
        met=len(tilings),
    )


def additivity(setting: Setting, *, matched: bool = True, left_out: int = 0) -> Evidence:
    """Sums over stars and rectangles against the sum over the whole, also across jumps of phi.

    The relations at branch points are not used; left_out: number of pieces that are not counted.
    """
    tilings, tried = random_tilings(
        setting, smallest_charge=1, only_off_rays=False, wanted=8, most_faces=28
    )
    rows = []
    for tiling in tilings:
        fine, pieces = _pieces(tiling, refine=True)
        angles = TilingAngles(tiling=fine, matched=matched)
        total = added(*(_sum_over(angles, piece) for piece in pieces[: len(pieces) - left_out]))
        relation = added(angles.rim_sum("middle"), scaled(-1, total))
        rows.append((fine, angles.implies(relation, branched=False)))
    return implied(
        rows,
        tried=tried,
        met=len(tilings),
        what="additivity",
        shown="on 8 tilings the sums over the pieces add up to that over the boundary, pieces "
        "with corners on the sides of others and jumps across the rays included",
    )


def _sum_over(angles: TilingAngles, piece: list[int]) -> Relation:
    """Alternating sum over the boundary of a piece: a rectangle, or the star round its centre."""
    if len(piece) == 1:
        return angles.face_sum(piece[0])
    part = _piece(angles.tiling, piece)
    inside = TilingAngles(tiling=part).rim_sum("first")
    return {(piece[index], position): c for (index, position), c in inside.items()}


def undulations(setting: Setting, *, per_charge: int = 2) -> Evidence:
    """Corners of the boundary, the reflex ones negative, by the charges of the branch points.

    per_charge: additional corners for a branch point of order 3; two of them, one above and one
    below, are an undulation.
    """
    tilings, tried = random_tilings(setting)
    wrong = []
    for tiling in tilings:
        corners = sum(2 - tiling.degrees[vertex] for vertex in tiling.rim)
        if corners != 4 + per_charge * charge(tiling):
            wrong.append(f"{corners} corners for charge {charge(tiling)}")
    return statement(
        not wrong,
        shown="on 30 random tilings the corners of the boundary, reflex ones negative, number 4 + "
        f"2 sum (m - 2): order 3 adds a sector above and one below, out to the boundary ({tried} "
        "tried)",
        witness="; ".join(wrong[:2]),
    )
