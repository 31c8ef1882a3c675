"""Order of saddleness: definition, leading forms, asymptotic directions at all kinds of points."""

from collections.abc import Iterable, Iterator
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import assembly as printed
from checks.verify import sampled
from checks.verify.amsler_patches import on_sphere
from checks.verify.assembly import C, S, carried, moutard_normal, ray_values, read
from checks.verify.nets import general_nets
from checks.verify.sampled import Decided
from checks.zero import vanishes
from theory import sector_series as series
from theory import star_saddle
from theory.bent_curves import lelieuvre_series
from theory.vectors import added, dot, scaled

#: Angles over pi of stars of the orders 2 to 5.
ANGLES = (
    ("1/2", "1/2", "1/2", "1/2"),
    ("1/3", "2/3", "3/4", "1/4"),
    ("1/3",) * 6,
    ("1/2", "1/4", "1/4", "1/4", "1/2", "1/4"),
    ("1/4",) * 8,
    ("1/5",) * 10,
)


def _stars() -> Iterator[tuple[Any, ...]]:
    for angles in ANGLES:
        yield tuple(sp.pi * sp.Rational(a) for a in angles)


def _decided(rows: Iterable[Decided], *, shown: str) -> Evidence:
    """Counts on stars, exact: that the signs alternate on any star is the leading form."""
    return sampled.decided(rows, shown=shown, grade="exact")


def order_of_saddleness(setting: Setting, *, per_order: int = 2, offset: int = 0) -> Evidence:
    """Half the number of sectors against the numbers of sides above and below the tangent plane."""
    del setting

    def rows() -> Iterator[Decided]:
        for angles in _stars():
            order = printed.order_of_saddleness(len(angles), per_order=per_order, offset=offset)
            sides = star_saddle.count_sides(angles)
            yield (
                sides == (order, order),
                f"angles {angles}: order {order}, sectors above and below {sides}",
            )

    return _decided(
        rows(),
        shown="a star of 2m sectors of unequal angles has m sectors above the tangent plane and m "
        "below: m is the number of undulations, 2 for a smooth saddle",
    )


def leading_form(setting: Setting, *, sign: int = -1, factor: int = 1) -> Evidence:
    """Second-order part of the height over the tangent plane on sectors of either orientation."""
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        height = carried(sigma).position
        for i, j in ((0, 0), (1, 0), (0, 1), (2, 0), (0, 2)):
            residuals[f"u^{i} v^{j}, sigma = {sigma}"] = read(height, i, j)[2]
        residuals[f"u v, sigma = {sigma}"] = read(height, 1, 1)[2] - sign * factor * sigma * S
    return identities(
        setting,
        residuals,
        shown="with arbitrary curvatures r.e_3 = -sigma sin(alpha_i) u v + cubic terms on S_i, "
        "sigma alternating from sector to sector: on small circuits the sign is that of the star, "
        "with a simple change at each of the 2m rays, half of them upwards",
    )


def assembled_order(setting: Setting, *, sign: int = -1, offset: int = 0) -> Evidence:
    """Leading forms of the assembled sectors, and the count of their signs."""
    return combined(
        {
            "leading form": leading_form(setting, sign=sign),
            "count": order_of_saddleness(setting, offset=offset),
        },
        shown="the leading forms of the assembled sectors are those of the quadratic saddle over "
        "the star, whose signs alternate over 2m sectors: m_p = m",
    )


def dupin(setting: Setting, *, power: int = 1, sign: int = -1) -> Evidence:
    """Second form along u, v and mixed on any net, and at a branch point; power: of sin phi."""
    residuals: dict[str, Any] = {}
    for net in general_nets():
        product = net.calculus.dot
        residuals[f"N.r_uu, {net.name}"] = product(net.d(net.r_u, "u"), net.normal)
        residuals[f"N.r_vv, {net.name}"] = product(net.d(net.r_v, "v"), net.normal)
        residuals[f"N.r_uv, {net.name}"] = product(net.d(net.r_u, "v"), net.normal) - (
            sign * net.sigma * net.sin_phi**power
        )
    return combined(
        {
            "smooth points": identities(setting, residuals, shown="second form"),
            "branch point": leading_form(setting, sign=sign),
        },
        shown="to second order the height over the tangent plane is -sigma sin(phi) u v at smooth "
        "points and -sigma sin(alpha_i) u v on each sector at a branch point: zero along the "
        "asymptotic directions and nowhere else",
    )


def directions_and_order(
    setting: Setting, *, per_order: int = 2, doubled: bool = False
) -> Evidence:
    """Directions in which the quadratic saddle over a star vanishes, against 2 m_p.

    per_order: directions per unit of the order; doubled: whether opposite ones count once.
    """
    del setting

    def rows() -> Iterator[Decided]:
        for angles in _stars():
            zeros = 0
            for i in range(len(angles)):
                ray = star_saddle.direction(star_saddle.ray_angle(angles, i))
                form = (ray.T * star_saddle.sector_hessian(angles, i) * ray)[0, 0]
                zeros += vanishes(form)
                middle = star_saddle.middle_height(angles, i)
                yield not vanishes(middle), f"the form of sector {i} of {angles} vanishes inside"
            zeros //= 2 if doubled else 1
            above, _ = star_saddle.count_sides(angles)
            yield (
                zeros == per_order * above,
                f"angles {angles}: {zeros} asymptotic directions, m_p = {above}",
            )

    return _decided(
        rows(),
        shown="over stars of the orders 2 to 5 with unequal angles the form vanishes along the 2m "
        "rays only, and is above the plane on m sectors: 2 m_p asymptotic directions leave p",
    )


def order_elsewhere(setting: Setting, *, expected: int = 2, through: bool = True) -> Evidence:
    """Order at interior points, points of rays and the centre of a monkey saddle.

    Near a point of a ray the two lines across it leave at the angles theta' and -theta, and the
    ray goes on backwards. expected: the order off the centre; through: whether the ray goes on.
    """

    def rows() -> Iterator[Decided]:
        for numerator in range(1, 6):
            theta = sp.pi * sp.Rational(numerator, 6)
            inside = (theta, sp.pi - theta) * 2
            yield from _has_order(inside, expected, f"inside a sector, theta = {theta}")
            for other in (sp.pi / 4, sp.pi / 2, 2 * sp.pi / 3):
                behind = (sp.pi - other, sp.pi - theta) if through else (2 * sp.pi - other - theta,)
                on_ray = (other, *behind, theta)
                yield from _has_order(on_ray, expected, f"on a ray, angles {theta}, {other}")
        yield from _has_order(star_saddle.regular_star(3), 3, "centre of the monkey saddle")
        yield from _has_order(star_saddle.regular_star(2), 2, "centre of the saddle")

    return combined(
        {
            "counts": _decided(rows(), shown="counts"),
            "angles on both sides of a ray": identities(setting, _angle_sums(), shown="angles"),
        },
        shown="inside a sector and on a ray four asymptotic directions leave, of angles that add "
        "up to 2 pi in pairs of sum pi: m_p = 2; at the centre of the monkey saddle m_p = 3",
    )


def _angle_sums() -> dict[str, Any]:
    """Angle of r_u and r_v on a ray from both sides: N is common, and r_v at theta from r_u."""
    residuals: dict[str, Any] = {}
    for along in ("u", "v"):
        first = ray_values(along, 1)
        second = ray_values(along, -1)
        residuals[f"N on a {along}-ray from both sides"] = [
            on_sphere(a - b)
            for name in first
            if name.startswith("N")
            for a, b in zip(first[name], second[name], strict=True)
        ]
    return residuals


def _has_order(angles: tuple[Any, ...], order: int, place: str) -> Iterator[Decided]:
    sides = star_saddle.count_sides(angles)
    yield sides == (order, order), f"{place}: sectors above and below {sides}, not {order}"
    total = sp.simplify(sum(angles) - 2 * sp.pi)
    yield total == 0, f"{place}: the angles are short of 2 pi by {total}"


def windings(setting: Setting, *, offset: int = 0, sense: int = 1) -> Evidence:
    """Turns of the normal about the centre of the quadratic saddle over a star: 1 - m."""
    del setting

    def rows() -> Iterator[Decided]:
        for angles in _stars():
            found = sense * star_saddle.winding_number(angles)
            expected = 1 - printed.order_of_saddleness(len(angles)) + offset
            yield found == expected, f"angles {angles}: {found} turns, not {expected}"

    return _decided(
        rows(),
        shown="over stars of the orders 2 to 5 the gradient turns 1 - m times: J_p = -1 at the "
        "centre of the saddle, -2 of the monkey saddle",
    )


def height_keeps_its_sign(setting: Setting, *, sign: int = -1, bend: int = 0) -> Evidence:
    """Height over the tangent plane at the corner of an Amsler sector, along the whole sector.

    bend: curvature of the edges, 0 for an Amsler sector.
    """
    residuals: dict[str, Any] = {}
    for net in general_nets():
        mixed = net.d(net.r_u, "v")
        stated = scaled(sign * net.sigma * net.sin_phi, net.normal)
        residuals[f"r_uv + sigma sin(phi) N, {net.name}"] = added(mixed, scaled(-1, stated))
    for sigma in (1, -1):
        height = carried(sigma, (bend,), (bend,)).position[2]
        for n in range(5):
            residuals[f"height on v = 0, u^{n}, sigma = {sigma}"] = read((height,) * 3, n, 0)[2]
            residuals[f"height on u = 0, v^{n}, sigma = {sigma}"] = read((height,) * 3, 0, n)[2]
    return identities(
        setting,
        residuals,
        shown="on an Amsler sector the height z over the corner's plane is 0 on both edges and "
        "z_uv = -sigma sin(phi) N.e_3: as long as N.e_3 > 0 it has the sign of -sigma on the whole "
        "sector, so that all 2m changes of sign reach the boundary",
    )


_CASES: tuple[tuple[str, dict[str, Any], bool], ...] = (
    ("straight rays", {"moduli": False}, True),
    ("bent rays", {}, True),
    ("curvatures that differ on the two sides of a ray", {"extra": 1}, False),
    ("odd rays of torsion -1", {"torsion": -1}, False),
    ("the normal of one sector reversed", {"reversed_normal": True}, False),
    ("a normal that is not Lorentz harmonic at the corner", {"bump": 1}, False),
    ("a constant normal along u", {"degenerate": True}, False),
)


def definition(
    setting: Setting,
    *,
    position: bool = True,
    normal: bool = True,
    harmonic: bool = True,
    regular: bool = True,
) -> Evidence:
    """Assembled sectors accepted as m-saddle, near-misses refused (def:m-saddle)."""
    del setting
    wrong = [
        name
        for name, case, member in _CASES
        if printed.is_m_saddle(
            _defects(**case), position=position, normal=normal, harmonic=harmonic, regular=regular
        )
        != member
    ]
    return statement(
        not wrong,
        shown="sectors between straight and between bent rays are accepted; curvatures that differ "
        "across a ray, torsions that do not alternate, a reversed normal, one that is not harmonic "
        "and one that is constant along u are refused",
        witness=f"decided wrongly: {', '.join(wrong)}",
    )


def _defects(
    *,
    moduli: bool = True,
    extra: int = 0,
    torsion: int = 1,
    reversed_normal: bool = False,
    bump: int = 0,
    degenerate: bool = False,
) -> dict[str, bool]:
    """Which conditions of an m-saddle fail, decided on the series of two sectors and their ray.

    bump: tangent part of N_uv at the corner; degenerate: whether N_u is replaced by 0.
    """
    here, there = ray_values("v", 1), ray_values("v", -1, extra=extra)
    sense = -1 if reversed_normal else 1
    jumps = {
        kind: any(
            on_sphere(a - factor * b) != 0
            for name in here
            if name.startswith(kind)
            for a, b in zip(here[name], there[name], strict=True)
        )
        for kind, factor in (("r", 1), ("N", sense))
    }
    on_u, on_v = (series.K[:2], series.H[:2]) if moduli else ((), ())
    normal = dict(moutard_normal(1, on_u, on_v, 3, torsion))
    normal[1, 1] = added(normal[1, 1], (sp.Integer(bump), sp.Integer(0), sp.Integer(0)))
    r_u, r_v = lelieuvre_series(normal, 2)
    closed = all(on_sphere(a - b) == 0 for a, b in zip(r_u[0, 1], r_v[1, 0], strict=True))
    leaves = all(
        on_sphere(a - b) == 0 for a, b in zip(r_v[0, 0], (C, S, sp.Integer(0)), strict=True)
    )
    slope = scaled(0 if degenerate else 1, normal[1, 0])
    return {
        "position": jumps["r"] or not leaves,
        "normal": jumps["N"],
        "harmonic": not closed,
        "regular": on_sphere(dot(slope, slope)) == 0,
    }
