"""Amsler sectors patched around a point: consistency on the rays, regularity, smoothness."""

from collections.abc import Iterator
from fractions import Fraction
from math import cosh, pi, sqrt
from typing import Any

import sympy as sp
from flint import arb

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import amsler as sectors
from checks.printed import amsler_patches as printed
from checks.printed import m_stars as stars
from checks.verify.amsler_patches import ORDER, axis, coefficient, on_sphere
from checks.verify.ball_bounds import Row, bounded
from checks.verify.m_stars import ALPHA, components, ray
from checks.verify.nets import minus
from checks.verify.recursion_disk import FloatRow, compared
from checks.verify.sampled import Decided, decided
from checks.verify.star_sectors import at
from checks.verify.star_sectors import stars as random_stars
from theory import amsler_disk, painleve, painleve_float
from theory import sector_series as series
from theory.star import Point, Star, point
from theory.vectors import Vector, added, cross, derivative, dot, scaled

T = sp.Symbol("t", positive=True)
_SHARES = (Fraction(0), Fraction(1, 3), Fraction(4, 5), Fraction(1), Fraction(11, 10))


def directions(
    setting: Setting, *, even: int = 0, exchanged: bool = True, shift: int = 0
) -> Evidence:
    """Directions (e_u, e_v) of the sectors 1 and 2 against u e_u + v e_v = x; u on even rays."""
    c, d = sp.symbols("c d", positive=True)
    residuals: dict[str, Any] = {}
    for i in (1, 2):
        e_u, e_v = printed.patch_directions(i, ray, even=even, exchanged=exchanged, shift=shift)
        u, v = (d, c) if i % 2 == 0 else (c, d)
        x = stars.sector_point(ray, i, c, d)
        residuals[f"u e_u + v e_v - x, i = {i}"] = minus(added(scaled(u, e_u), scaled(v, e_v)), x)
        residuals[f"unit vectors normal to e_3, i = {i}"] = [
            dot(e_u, e_u) - 1, dot(e_v, e_v) - 1, dot(e_u, printed.E_3), dot(e_v, printed.E_3)
        ]  # fmt: skip
    return identities(
        setting,
        residuals,
        shown="e_u is the ray of even index and e_v that of odd index of each sector: unit vectors "
        "normal to e_3 with x = u e_u + v e_v",
    )


def _data(i: int, t: Any, *, on: str, exchanged: bool, sign_v: int) -> tuple[Vector, Vector]:
    """Printed N and r of sector i on its edge of the u- or the v-line, at the distance t."""
    e_u, e_v = printed.patch_directions(i, ray, exchanged=exchanged)
    zero: Vector = (sp.Integer(0),) * 3
    if on == "u":
        return printed.normal_on_u(t, printed.E_3, e_u), printed.line(t, zero, e_u)
    return printed.normal_on_v(t, printed.E_3, e_v, sign=sign_v), printed.line(t, zero, e_v)


def rays_consistent(
    setting: Setting, *, exchanged: bool = True, apart: int = 1, sign_v: int = -1
) -> Evidence:
    """N and r on the rays 1 and 2 from both sectors; apart: the other sector is i + apart.

    sign_v: of the sine in N(0, v), in the second sector of each pair.
    """
    residuals: dict[str, Any] = {}
    for i in (1, 2):
        on = "u" if i % 2 == 0 else "v"
        normal, place = _data(i, T, on=on, exchanged=exchanged, sign_v=-1)
        other, there = _data(i + apart, T, on=on, exchanged=exchanged, sign_v=sign_v)
        residuals[f"N on ray {i}"] = minus(normal, other)
        residuals[f"r on ray {i}"] = minus(place, there)
        residuals[f"r on ray {i} - t s_{i}"] = minus(place, scaled(T, ray(i)))
    return identities(
        setting,
        residuals,
        shown="on an even ray v = 0, on an odd ray u = 0, and both sectors give N and r = t s_i by "
        "the same formula",
    )


def origin_consistent(
    setting: Setting, *, at_distance: int = 0, exchanged: bool = True
) -> Evidence:
    """N and r of the sectors 1, 2, 3 at u = v = 0, on both edges."""
    residuals: dict[str, Any] = {}
    for i in (1, 2, 3):
        for on in ("u", "v"):
            normal, place = _data(i, sp.Integer(at_distance), on=on, exchanged=exchanged, sign_v=-1)
            residuals[f"N - e_3, sector {i}, {on}"] = minus(normal, printed.E_3)
            residuals[f"r, sector {i}, {on}"] = place
    return identities(
        setting, residuals, shown="r = 0 and N = e_3 at the origin from either edge of every sector"
    )


def corner_limit(
    setting: Setting, *, along_normal: bool = False, sign: int = 1, next_ray: bool = False
) -> Evidence:
    """Limit of N_u x N_v at the corner against the printed value, up to a sign.

    along_normal: whether the value is multiplied by e_3; sign: 0 for a value 0; next_ray: the
    value of sector i + 1.
    """
    residuals: dict[str, Any] = {}
    for i in (1, 2):
        e_u, e_v = printed.patch_directions(i, ray)
        n_u = tuple(e.subs(T, 0) for e in derivative(printed.normal_on_u(T, printed.E_3, e_u), T))
        n_v = tuple(e.subs(T, 0) for e in derivative(printed.normal_on_v(T, printed.E_3, e_v), T))
        limit = cross((n_u[0], n_u[1], n_u[2]), (n_v[0], n_v[1], n_v[2]))
        value = printed.corner_limit(i + next_ray, ray, sign=sign * (1 if i % 2 == 0 else -1))
        stated = scaled(value, printed.E_3) if along_normal else (value,)
        if len(stated) != len(limit):
            return statement(
                False,
                shown="",
                witness=f"on S_{i} the limit is the vector {tuple(map(sp.trigsimp, limit))}, "
                f"the printed value the number {sp.trigsimp(value)}",
            )
        residuals[f"limit on S_{i}"] = [a - b for a, b in zip(limit, stated, strict=True)]
        residuals[f"value on S_{i} - sin alpha_{i}"] = abs(sign) * sp.sin(ALPHA[i]) - dot(
            cross(printed.E_3, ray(i - 1)), ray(i)
        )
    return identities(
        setting,
        residuals,
        shown="N is of class C^{1M} up to the corner, where N_u = e_3 x e_u, N_v = -e_3 x e_v and "
        "N_u x N_v = +-(s*_(i-1).s_i) e_3, + for even i, with s*_(i-1).s_i = sin(alpha_i) > 0",
    )


def regular_rectangle(setting: Setting, *, share: str = "9/10", slope: str = "1") -> Evidence:
    """Angle theta of r_u and r_v on rectangles with c d = share (pi - alpha), by Painleve III.

    slope: bound on theta_uv = sin theta.
    """
    del setting

    def rows() -> Iterator[Row]:
        for k in range(1, 12):
            angle = arb.pi() * k / 12

            def alpha(k: int = k) -> Any:
                return arb.pi() * k / 12

            for part in (Fraction(1, 20), Fraction(1, 2), Fraction(1)):
                q = Fraction(share) * part

                def z(k: int = k, q: Fraction = q) -> Any:
                    product = (arb.pi() - arb.pi() * k / 12) * q.numerator / q.denominator
                    return 2 * product.sqrt()

                place = f"alpha = {k} pi/12, u v = {q} (pi - alpha)"
                theta = painleve.angle(alpha, z, digits=20).ball()
                room = (arb.pi() - angle) * q.numerator / q.denominator
                rise = arb(Fraction(slope).numerator) / Fraction(slope).denominator
                yield f"theta, {place}", theta, arb.pi()
                yield f"theta - alpha, {place}", theta - angle, rise * room
                yield f"alpha, {place}", angle, theta

    return bounded(
        rows(),
        shown="|N_u x N_v| = sin theta with alpha <= theta <= alpha + u v, as 0 <= theta_uv <= 1 "
        "(by hand), so that it is positive on every rectangle with c d < pi - alpha; seen on balls "
        "of Painleve III for alpha = pi/12 to 11 pi/12",
        sampled=True,
    )


def _union_point(star: Star, sides: list[tuple[Fraction, Fraction]], x: Point, rays: bool) -> bool:
    """Whether x lies in the union of the rectangles with these sides along their two rays."""
    for i in star.rays:
        first, second = star.widths(i, x)
        c, d = first / star.sine(i), second / star.sine(i)
        low = c >= 0 and d >= 0 if rays else c > 0 and d > 0
        if low and c < sides[i - 1][0] and d < sides[i - 1][1]:
            return True
    return False


def patched_star(
    setting: Setting,
    *,
    rays_included: bool = False,
    same_lengths: bool = True,
    longer: str = "1",
) -> Evidence:
    """Union of the rectangles J_i against the star of the lengths to which they are cut.

    rays_included: whether J_i holds its two rays, 0 <= u_i; same_lengths: whether neighbours are
    cut to the lesser length on their common ray; longer: factor of the lengths to which they are.
    """
    rng = setting.random()

    def rows() -> Iterator[Decided]:
        for star in random_stars(setting):
            n = len(star.rays)
            given = [(Fraction(rng.randint(2, 9), 5), Fraction(rng.randint(2, 9), 5))
                     for _ in star.rays]  # fmt: skip
            lengths = [min(given[i - 1][1], given[i % n][0]) for i in star.rays]
            cut = [(lengths[i - 2], lengths[i - 1]) for i in star.rays]
            sides = [(a * Fraction(longer), b * Fraction(longer)) for a, b in cut]
            sides = sides if same_lengths else given
            wanted = Star(directions=star.directions, lengths=tuple(lengths))
            for i in star.rays:
                for p in _SHARES:
                    for q in _SHARES:
                        c, d = p * lengths[i - 2], q * lengths[i - 1]
                        x = point(c, star.ray(i - 1), d, star.ray(i))
                        inside = _union_point(star, sides, x, rays_included)
                        told = "in" if inside else "not in"
                        yield (
                            inside == bool(wanted.sectors_of(x)),
                            f"{told} the union of the J_i: {at(wanted, x)}",
                        )

    return decided(
        rows(),
        shown="rectangles that hold their two rays, cut to the lesser of the two lengths on each "
        "common ray, make the m-star of these lengths",
    )


def star_angles(setting: Setting, *, sectors_number: int = 6, third: int = 3) -> Evidence:
    """Angles pi/third of this number of sectors as data of an m-star."""
    del setting
    angles = [Fraction(1, third)] * sectors_number
    return statement(
        stars.is_star(angles, [Fraction(1)] * sectors_number),
        shown="six angles pi/3: each in (0, pi), even in number, of sum 2 pi",
        witness=f"{sectors_number} angles pi/{third}: the sum is {sum(angles)} pi",
    )


def _edge_angles(i: int, bend: int) -> tuple[Any, Any]:
    """Angles of r_u and r_v on ray 1 or 2 at the distance t, in the sectors i and i + 1.

    On an edge of curvature bend: theta_u = -sigma kappa on a u-line, theta_v = sigma kappa on a
    v-line, sigma = -1 in the sectors of even index.
    """
    sigma, kappa = (-1 if i % 2 == 0 else 1), bend
    rate = -sigma * kappa if i % 2 == 0 else sigma * kappa
    return ALPHA[i] + rate * T, ALPHA[i + 1] - rate * T


def continuous_derivative(setting: Setting, *, bend: int = 0, exchanged: bool = False) -> Evidence:
    """Derivative of r in the plane of the star on both sides of the rays 1 and 2.

    In the frame (T, N x T) of the ray the other asymptotic tangent has, before the ray, the angle
    -theta, after it +theta. bend: geodesic curvature of the rays; exchanged: angles exchanged.
    """
    residuals: dict[str, Any] = {}
    for i in (1, 2):
        before, after = _edge_angles(i, bend)
        if exchanged:
            before, after = after, before
        own: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
        back: Vector = (sp.cos(before), -sp.sin(before), sp.Integer(0))
        ahead: Vector = (sp.cos(after), sp.sin(after), sp.Integer(0))
        a, b = components(ray(i - 1), ray(i), ray(i + 1))
        image = added(scaled(a, own), scaled(b, ahead))
        residuals[f"derivative along s_(i-1) on ray {i}"] = minus(back, image)
    return combined(
        {
            "rate of the angle": _edge_rates(setting),
            "derivative": identities(
                setting, residuals, where=(sp.pi - ALPHA[1], sp.pi - ALPHA[2]), shown="continuous"
            ),
        },
        shown="across a straight ray the derivative of r is continuous even in the plane of the "
        "star: in the frame of the ray both sides map the star's vectors by the same rotation; "
        "smooth on each closed sector, the derivative is Lipschitz on the star",
    )


def _edge_rates(setting: Setting) -> Evidence:
    """Rates of theta on the edges of the series of a sector: -sigma kappa^u and sigma kappa^v."""
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        found = series.sector_series(
            sigma=sigma, on_u=series.K[:2], on_v=series.H[:2], order=ORDER - 1
        )
        for n in range(ORDER - 2):
            for along, moduli, sense in (("u", series.K, -sigma), ("v", series.H, sigma)):
                place = (n + 1, 0) if along == "u" else (0, n + 1)
                rate = (n + 1) * coefficient(found.theta_excess, *place)
                residuals[f"{along}^{n}, sigma = {sigma}"] = rate - (
                    sense * moduli[n] if n < 2 else 0
                )
                cosine = coefficient(
                    sum((p * q for p, q in zip(found.r_u, found.r_v, strict=True)),
                        series.RING.zero), *place
                )  # fmt: skip
                _, stated = series.sine_and_cosine(found.theta_excess, ORDER - 1)
                residuals[f"cos theta, {along}^{n + 1}, sigma = {sigma}"] = on_sphere(
                    cosine - coefficient(stated, *place)
                )
    return identities(setting, residuals, shown="rates of theta on the edges")


def amsler_sectors(setting: Setting, *, bend_u: int = 0, bend_v: int = 0) -> Evidence:
    """Edges of the sectors of either parity, straight; bend: their curvatures."""
    residuals: dict[str, Any] = {}
    accepted = True
    for sigma in (1, -1):
        found = series.sector_series(sigma=sigma, on_u=(bend_u,), on_v=(bend_v,), order=ORDER)
        for n in range(1, ORDER + 1):
            residuals[f"r_u on v = 0, u^{n}, sigma = {sigma}"] = [
                coefficient(p, n, 0) for p in found.r_u
            ]
            residuals[f"r_v on u = 0, v^{n}, sigma = {sigma}"] = [
                on_sphere(coefficient(p, 0, n)) for p in found.r_v
            ]
        residuals[f"r_v at the corner, sigma = {sigma}"] = [
            on_sphere(coefficient(p, 0, 0) - e) for p, e in zip(found.r_v, axis(sigma), strict=True)
        ]
        curvatures = (
            -sigma * coefficient(found.theta_excess, 1, 0),
            sigma * coefficient(found.theta_excess, 0, 1),
        )
        accepted = accepted and sectors.is_amsler_sector(curvatures)
    return combined(
        {
            "straight edges": identities(setting, residuals, shown="straight"),
            "definition": statement(accepted, shown="", witness="an edge is curved at the corner"),
        },
        shown="both edges of the sectors of either orientation are straight (tangents constant to "
        f"degree {ORDER}, and by theta constant on the axes to all degrees), as the definition of "
        "an Amsler sector asks; the front exists on the whole quadrant, which the star restricts",
    )


def monkey_saddle(
    setting: Setting, *, sectors_number: int = 6, radius: str = "1", curvature: str = "-1"
) -> Evidence:
    """Six sectors of angle pi/3 on the disk of radius 1: regular, of the area of K = -1.

    sectors_number: of angle 2 pi over it; radius: that reached along the v-lines; curvature: K of
    the area 2 pi (cosh(sqrt(-K) R) - 1)/(-K) of the disk R = 1.
    """
    del setting
    alpha, reach = 2 * pi / sectors_number, float(Fraction(radius))
    k = -float(Fraction(curvature))

    def rows() -> Iterator[FloatRow]:
        from scipy.integrate import quad

        def strip(u: float) -> float:
            v = amsler_disk.rim(alpha, u, reach)
            z = 2 * sqrt(u * v)
            return painleve_float.slope(alpha, z) * z / (2 * u)

        largest = 0.0
        for step in range(1, 20):
            u = reach * step / 20
            v = amsler_disk.rim(alpha, u, reach)
            largest = max(largest, painleve_float.angle(alpha, 2 * sqrt(u * v)))
        yield "largest angle on the disk", largest, pi
        area = 6 * quad(strip, 1e-9, reach * (1 - 1e-9), epsabs=1e-10, epsrel=1e-10)[0]
        wanted = 2 * pi * (cosh(sqrt(k)) - 1) / k
        yield "area of the six sectors within the radius, minus that of K = -1", area, wanted
        yield "area of the disk of K = -1, minus that of the six sectors", wanted, area

    return compared(
        rows(),
        shown="the disk of geodesic radius 1 stays off theta = pi in each of the six sectors, and "
        "their areas, integrals of sin theta, add up to 2 pi (cosh 1 - 1): the disk of K = -1",
    )
