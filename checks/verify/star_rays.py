"""Checks of the rays of a branch point: families, angles, and the jumps of phi across them."""

from itertools import combinations
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import branched_sine_gordon as printed
from theory import star_saddle
from theory.star_field import StarField


def _twelfths(*parts: int) -> tuple[Any, ...]:
    return tuple(sp.pi * sp.Rational(k, 12) for k in parts)


STARS: tuple[tuple[Any, ...], ...] = (
    star_saddle.regular_star(3),
    star_saddle.regular_star(4),
    _twelfths(2, 5, 3, 4, 6, 4),
    _twelfths(2, 3, 2, 3, 4, 4, 3, 3),
)
"""Stars in which no two neighbouring angles add up to pi."""


SURGERY: tuple[tuple[Any, ...], ...] = (
    (*_twelfths(2, 2, 2), *_twelfths(6, 6, 6)),
    (*_twelfths(1, 2, 1), *_twelfths(8, 4, 8)),
    (*_twelfths(1, 1, 1, 1, 1), *_twelfths(7, 5, 7)),
)
"""Stars made at a smooth point, a sector of angle a replaced by 3 or 5 sectors."""


def _jumps(angles: tuple[Any, ...]) -> list[Any]:
    phi = star_saddle.asymptotic_angles(angles)
    return [phi[i] - phi[i - 1] for i in range(len(phi))]


def jumps(setting: Setting, *, continuous_rays: int = 0, smallest: int = 3) -> Evidence:
    """Rays of stars across which phi is continuous: at most continuous_rays of them.

    Jumps of seven stars, three of which come from surgery; and for orders from smallest to 6 the
    largest sets of rays without a jump: two of them that bound no common sector would use up 2 pi.
    """
    wrong = []
    for angles in (*STARS, *SURGERY):
        count = sum(bool(sp.simplify(jump) == 0) for jump in _jumps(angles))
        if count > continuous_rays:
            shown = ", ".join(map(str, angles))
            wrong.append(f"phi is continuous across {count} rays of the star of angles {shown}")
    for m in range(smallest, 7):
        if (most := _most_continuous(m)) > continuous_rays and not wrong:
            wrong.append(f"for m = {m} the angles may leave {most} rays without a jump")
    a, b = sp.symbols("alpha beta", positive=True)
    jump = StarField(order=3).centre
    generic = {
        "jump - (sum of neighbours - pi)": (jump(2) - jump(1)).subs(
            {sp.Symbol("alpha_1", positive=True): a, sp.Symbol("alpha_2", positive=True): b}
        )
        - (a + b - sp.pi)
    }
    return combined(
        {
            "rays": statement(not wrong, shown="", witness="; ".join(wrong)),
            "jump": identities(setting, generic, shown=""),
        },
        shown="phi jumps across a ray unless the angles beside it add up to pi; for m >= 3 two "
        "such rays have a sector in common, so there are two at most, as after surgery",
    )


def _most_continuous(m: int) -> int:
    """Largest set of rays of an m-star that can be without a jump, by the sum of the angles.

    Two rays with four sectors beside them use up 2 pi, possible only if these are all.
    """
    rays = range(2 * m)

    def compatible(i: int, k: int) -> bool:
        beside = {(i - 1) % (2 * m), i, (k - 1) % (2 * m), k}
        return len(beside) < 4 or len(beside) == 2 * m

    return max(
        size
        for size in range(1, 2 * m + 1)
        for chosen in combinations(rays, size)
        if all(compatible(i, k) for i, k in combinations(chosen, 2))
    )


def sector_angle_by_parity(setting: Setting, *, even: int = 0) -> Evidence:
    """Caption of the figure against cos phi = sigma r_u . r_v on seven stars."""
    residuals = {
        f"star {n}, sector {j}": phi - printed.sector_angle_by_parity(angles[j], j, even=even)
        for n, angles in enumerate((*STARS, *SURGERY))
        for j, phi in enumerate(star_saddle.asymptotic_angles(angles))
    }
    return identities(
        setting,
        residuals,
        shown="with ray 0 a u-curve and sector 0 after it, phi is alpha on even sectors and "
        "pi - alpha on odd ones",
    )


def sector_angle(setting: Setting, *, swapped: bool = False, whole: int = 1) -> Evidence:
    """Angle at the centre against cos phi = sigma r_u . r_v, sin phi = |r_u x r_v|."""
    alpha = sp.Symbol("alpha", positive=True)
    residuals = {}
    for turn in (1, -1):
        r_u, r_v = (sp.Integer(1), sp.Integer(0)), (sp.cos(alpha), turn * sp.sin(alpha))
        product = r_u[0] * r_v[0] + r_u[1] * r_v[1]
        area = r_u[0] * r_v[1] - r_u[1] * r_v[0]
        phi = printed.sector_angle(alpha, (turn == 1) != swapped, whole=whole)
        residuals[f"cosine, turn {turn}"] = sp.cos(phi) - turn * product
        residuals[f"sine, turn {turn}"] = sp.sin(phi) - turn * area
    return identities(
        setting,
        residuals,
        shown="for r_u, r_v that leave the point at an angle alpha in (0, pi), of either sense",
    )


def alternating_rays(setting: Setting, *, per_family: int = 0, shift: int = 1) -> Evidence:
    """Torsion of the rays of seven stars by the sense in which the normal turns along them.

    Along a ray the gradient of the saddle is normal to it: +1 where it lies to the left. shift:
    number of rays after which the sign is to change; per_family: added to the claimed number m.
    """
    wrong = []
    for angles in (*STARS, *SURGERY):
        rays = range(len(angles))
        senses = [
            sp.simplify(
                sp.sin(star_saddle.gradient_angle(angles, i) - star_saddle.ray_angle(angles, i))
            )
            for i in rays
        ]
        counts = senses.count(1), senses.count(-1)
        changes = all(senses[i] == -senses[i - shift] for i in rays)
        distinct = all(0 < angle < sp.pi for angle in angles)
        if not (changes and distinct and set(counts) == {len(angles) // 2 + per_family}):
            wrong.append(f"star of {len(angles)} rays: {counts}")
    return statement(
        not wrong,
        shown="on seven stars of order 3 and 4 the rays have distinct tangents, and the normal "
        "turns to the left and to the right of them in turn: m rays of each torsion",
        witness="; ".join(wrong),
    )


def angles_at_centre(setting: Setting, *, turns: int = 1, percent: int = 100) -> Evidence:
    """Sum of the angles between neighbouring tangents of the rays, from their inner products."""
    residuals = {}
    for n, angles in enumerate((*STARS, *SURGERY)):
        rays = [star_saddle.direction(star_saddle.ray_angle(angles, i)) for i in range(len(angles))]
        total = sum(sp.acos(sp.simplify((rays[i - 1].T * ray)[0, 0])) for i, ray in enumerate(rays))
        residuals[f"star {n}"] = sp.simplify(
            sp.nsimplify(total / sp.pi) - 2 * turns * sp.Rational(percent, 100)
        )
    return identities(
        setting,
        residuals,
        shown="the directions of the rays of seven stars, one turn of the tangent plane, make "
        "angles of sum 2 pi",
    )
