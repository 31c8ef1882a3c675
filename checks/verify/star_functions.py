"""Functions on a star decided at rational points: coordinates on rays, continuity, slopes."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from checks.evidence import Evidence, Setting
from checks.verify.sampled import Decided, decided
from checks.verify.star_sectors import ORIGIN, SHARES, ZERO, at, stars
from theory.star import Point, Star, dot2, point


def _asymptotic(star: Star, i: int, x: Point, even: int) -> tuple[Fraction, Fraction]:
    """Coefficients (u, v) of x in sector i along its ray of even and of odd index."""
    first, second = star.widths(i, x)
    c, d = first / star.sine(i), second / star.sine(i)
    return (d, c) if i % 2 == even else (c, d)


def ray_coordinates(
    setting: Setting, *, parity: int = 0, along: str = "u", even: int = 0, ahead: int = 0
) -> Evidence:
    """Values of (u_i, v_i) and (u_(i+1), v_(i+1)) on the ray of S_i and S_(i+1).

    parity: of i; along: the coordinate that is said to run from 0 to l_i; even: parity of the
    sectors whose own ray is a u-line; ahead: added to the index of the ray.
    """

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            for i in star.rays:
                if i % 2 != parity:
                    continue
                for p in SHARES:
                    t = p * star.length(i)
                    x = point(t, star.ray(i + ahead), ZERO, ORIGIN)
                    wanted = (t, ZERO) if along == "u" else (ZERO, t)
                    here = _asymptotic(star, i, x, even)
                    there = _asymptotic(star, i + 1, x, even)
                    yield (
                        here == wanted == there,
                        (
                            f"(u, v) = {here} on S_{i}, {there} on S_{i + 1}, not {wanted}: "
                            f"{at(star, x)}"
                        ),
                    )

    return decided(
        rows(),
        shown="on the ray of S_i and S_(i+1) one coordinate vanishes and the other is the distance "
        "from the origin, in [0, l_i), the same from both sectors",
    )


def odd_ray_coordinates(
    setting: Setting, *, parity: int = 1, along: str = "v", even: int = 0, ahead: int = 0
) -> Evidence:
    """Values of (u_i, v_i) and (u_(i+1), v_(i+1)) on the ray of S_i and S_(i+1), i odd."""
    return ray_coordinates(setting, parity=parity, along=along, even=even, ahead=ahead)


def rays(setting: Setting, *, odd_count: bool = False, families: int = 2) -> Evidence:
    """Rays of a star, their number and the families to which the sectors assign them.

    odd_count: whether stars of 2m + 1 sectors are taken; families: the number of families that
    take turns.
    """

    def rows() -> Iterator[Decided]:
        for m in (2, 3, 4, 5):
            count = 2 * m + odd_count
            kinds = [i % families for i in range(1, count + 1)]
            differ = all(a != b for a, b in pairwise([*kinds, kinds[0]]))
            yield differ, f"{count} rays: two neighbours of one family"
            yield (
                kinds.count(0) == m == kinds.count(1),
                f"{count} rays: {kinds.count(0)} u-rays and {kinds.count(1)} v-rays",
            )
        for star in stars(setting):
            yield (
                len(set(star.directions)) == 2 * (len(star.rays) // 2),
                f"{len(set(star.directions))} rays",
            )

    return decided(
        rows(),
        shown="2m different rays leave the origin, each the common ray of two sectors; u- and "
        "v-rays can take turns around the origin because their number is even, m of each",
    )


def not_one_to_one(setting: Setting, *, signed: bool = False, ahead: int = 1) -> Evidence:
    """Two points with the same (u, v) on either side of each ray, as near as one likes.

    signed: whether the coordinate across the ray changes its sign there, like eta; ahead: the
    second point is taken towards ray i + ahead.
    """

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            for i in star.rays:
                for small in (Fraction(1, 10), Fraction(1, 10**6)):
                    t = star.length(i) / 2 if small > Fraction(1, 100) else small
                    x = point(t, star.ray(i), small, star.ray(i - 1))
                    y = point(t, star.ray(i), small, star.ray(i + ahead))
                    here, there = _asymptotic(star, i, x, 0), _asymptotic(star, i + 1, y, 0)
                    if signed:
                        there = (there[0], -there[1]) if i % 2 == 0 else (-there[0], there[1])
                    yield (
                        x != y and here == there,
                        f"(u, v) = {here} and {there} tell the points apart: {at(star, x)}",
                    )

    return decided(
        rows(),
        shown="t s_i + e s_(i-1) and t s_i + e s_(i+1) are two points with the same (u, v), for "
        "every t and e > 0: so too in every open set that meets the ray",
    )


def pasting(setting: Setting, *, closed: bool = True, differ: str = "0") -> Evidence:
    """Piecewise linear functions of (u, v) that agree on common rays, near the points of rays.

    closed: whether each sector holds both of its rays, so that the functions must agree on both,
    and not only the first; differ: difference of their slopes along the rays that they share.
    """
    rng = setting.random()

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            n = len(star.rays)
            slopes = [Fraction(rng.randint(-9, 9)) for _ in range(n)]
            others = [s + rng.randint(1, 9) for s in slopes]
            for i in star.rays:
                for p in SHARES[1:]:
                    x = point(p * star.length(i), star.ray(i), ZERO, ORIGIN)
                    yield star.in_sector(i, x), f"S_{i} is not closed in T: {at(star, x)}"
                    gap = Fraction(1, 10**9)
                    values = []
                    for j, side in ((i, i - 1), (i + 1, i + 1)):
                        y = point(Fraction(1), x, gap, star.ray(side))
                        k = (j - 1) % n + 1
                        first, second = star.widths(k, y)
                        seam = others if not closed and j == i else slopes
                        own, before = seam[k - 1], slopes[k - 2]
                        own += Fraction(differ) if j == i else 0
                        values.append((first * before + second * own) / star.sine(k))
                    jump = abs(values[0] - values[1])
                    yield jump <= 100 * gap, f"jump {float(jump):.6g}: {at(star, x)}"

    return decided(
        rows(),
        shown="each S_i holds both of its rays and is the part of T in a closed cone, so closed in "
        "T; continuous functions on finitely many closed sets that agree where these meet are "
        "continuous on the union (pasting lemma), seen on piecewise linear functions",
    )


def lipschitz(setting: Setting, *, jump: str = "0", bounded: bool = True) -> Evidence:
    """Quotients of continuous functions, linear in (u, v) on each sector, at all pairs of points.

    Slopes at most 1 along both rays, so at most 2/s against distances in a sector, s the least
    sine. For two points of neighbouring sectors a path along their pair of coordinates is longer
    than their distance by at most sqrt(2) sqrt((1 + 1/s)^2 + 1/s^2); of others, a path through the
    origin by at most 2/c, c the least sine of the angle or 1. jump: of the functions on the rays;
    bounded: whether the slope is, else the square root of the distance is added.
    """
    rng = setting.random()

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            n = len(star.rays)
            slopes = [Fraction(rng.randint(-8, 8), 8) for _ in range(n)]
            shifts = [Fraction(jump) * (k % 2) for k in range(n)]
            found = []
            for i in star.rays:
                for p in (*SHARES, Fraction(1, 10**8)):
                    for q in (*SHARES, Fraction(1, 10**8)):
                        c, d = p * star.length(i - 1), q * star.length(i)
                        x = point(c, star.ray(i - 1), d, star.ray(i))
                        value = c * slopes[i - 2] + d * slopes[i - 1]
                        value += shifts[i - 1] if c and d else 0
                        if not bounded:
                            value += Fraction(float(dot2(x, x)) ** 0.25)
                        found.append((x, value))
            s = min(star.sine(i) for i in star.rays)
            stretch = 4 / s**2 * max(2 * ((1 + 1 / s) ** 2 + 1 / s**2), 4 / s**2)
            for k, (x, f) in enumerate(found):
                for y, g in found[k + 1 :: 3]:
                    square = (x[0] - y[0]) ** 2 + (x[1] - y[1]) ** 2
                    yield (
                        (f - g) ** 2 <= stretch * square,
                        (
                            f"values {float(f):.6g} and {float(g):.6g} at the squared distance "
                            f"{float(square):.3g}: {at(star, x)}"
                        ),
                    )

    return decided(
        rows(),
        shown="a continuous function with bounded derivatives on each sector is Lipschitz on T: "
        "two points are joined in T by a path not longer than a constant times their distance, "
        "through the pair of coordinates of neighbouring sectors, else through the origin; the "
        "constant holds at all pairs of points tried",
    )
