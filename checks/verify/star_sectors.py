"""Sets of a star decided at rational points: sectors, patches, rays, coordinates, continuity.

Random stars with rational unit directions, m = 2 to 5; memberships by cross products, exactly.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction

from checks.evidence import Evidence, Setting
from checks.printed import m_stars as printed
from checks.verify.sampled import Decided, decided
from theory.star import Point, Star, cross2, point, random_star, unit
from theory.vectors import Vector

ORDERS = (2, 2, 3, 3, 4, 5)
ZERO = Fraction(0)
ORIGIN: Point = (ZERO, ZERO)
SHARES = (ZERO, Fraction(1, 7), Fraction(1, 2), Fraction(99, 100))
#: Directions in which a neighbourhood is tried.
COMPASS = tuple(unit(Fraction(k, 4)) for k in range(-24, 25, 3))


def plain_star() -> Star:
    """Star of four rays at the angles 2 atan(1/2), pi, 3 pi/2 and 2 pi."""
    directions = tuple(
        (Fraction(x), Fraction(y)) for x, y in (("3/5", "4/5"), (-1, 0), (0, -1), (1, 0))
    )
    return Star(directions=directions, lengths=tuple(map(Fraction, (1, 2, 1, 3))))


def stars(setting: Setting) -> Iterator[Star]:
    """Plain star, and random ones of the orders 2 to 5."""
    rng = setting.random()
    yield plain_star()
    for order in ORDERS:
        yield random_star(rng, order)


def _vector(p: Point) -> Vector:
    return (p[0], p[1], ZERO)


def _plane(a: Vector) -> Point:
    return (a[0], a[1])


def at(star: Star, x: Point) -> str:
    """Place of a point as text."""
    rays = ", ".join(f"({s[0]}, {s[1]})" for s in star.directions)
    lengths = ", ".join(map(str, star.lengths))
    return f"x = ({x[0]}, {x[1]}) in the star of rays {rays} and lengths {lengths}"


def _stated(star: Star, i: int, c: Fraction, d: Fraction, first: int, second: int) -> Point:
    def s(j: int) -> Vector:
        return _vector(star.ray(j))

    return _plane(printed.sector_point(s, i, c, d, first=first, second=second))


def sectors(
    setting: Setting, *, first: int = -1, second: int = 0, closed: bool = False
) -> Evidence:
    """Points c s_(i-1) + d s_i of (def:sectors) at shares of the lengths, the last share 1.

    first, second: shifts of the indices of the two rays and lengths; closed: <= l for < l.
    """

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            for i in star.rays:
                lengths = star.length(i + first), star.length(i + second)
                for p in (*SHARES, Fraction(1)):
                    for q in (*SHARES, Fraction(1)):
                        c, d = p * lengths[0], q * lengths[1]
                        x = _stated(star, i, c, d, first, second)
                        inside = printed.in_range(c, lengths[0], closed=closed)
                        inside = inside and printed.in_range(d, lengths[1], closed=closed)
                        told = "stated to lie" if inside else "stated not to lie"
                        yield inside == star.in_sector(i, x), f"{told} in S_{i}: {at(star, x)}"

    return decided(
        rows(),
        shown="on random stars, l_0 read as l_2m, the half-open parallelograms are the parts of "
        "the cones between neighbouring rays that two strips cut out",
    )


def _slack(star: Star, x: Point) -> Fraction:
    """Least distance of x, inside the star, from the outer sides and from other rays' lines."""
    room = []
    for i in star.sectors_of(x):
        first, second = star.widths(i, x)
        sine = star.sine(i)
        room += [star.length(i - 1) * sine - first, star.length(i) * sine - second]
        room += [width for width in (first, second) if width > 0]
    return min(room)


def neighbourhood(
    setting: Setting, *, closed: bool = False, apart: int = 1, missing: int = 0
) -> Evidence:
    """Openness of T, common points of two sectors, on random stars.

    closed: whether the outer sides belong to the star; apart: sectors S_i, S_(i+apart) are said to
    share ray i; missing: sectors left out of the union, as where the angles do not add up to 2 pi.
    """

    def inside(star: Star, x: Point) -> bool:
        return any(i <= len(star.rays) - missing for i in star.sectors_of(x))

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            yield from _open(star, inside, closed=closed)
            for i in star.rays:
                yield from _common(star, i, apart)

    return decided(
        rows(),
        shown="T holds a disk about each tried point, the origin and points of rays among them, of "
        "a radius equal to its distance from the sides and rays that it does not lie on; S_i and "
        "S_(i+1) share the ray s_i up to l_i, others the origin, and interiors are disjoint",
    )


def _open(star: Star, inside: Callable[[Star, Point], bool], *, closed: bool) -> Iterator[Decided]:
    shares = (*SHARES, Fraction(1)) if closed else SHARES
    for i in star.rays:
        for p in shares:
            for q in shares:
                x = point(p * star.length(i - 1), star.ray(i - 1), q * star.length(i), star.ray(i))
                outer = 1 in (p, q)
                radius = Fraction(1, 100) if outer else Fraction(99, 100) * _slack(star, x)
                for e in COMPASS:
                    y = point(Fraction(1), x, radius, e)
                    yield inside(star, y), f"not a neighbourhood: {at(star, y)}"


def _common(star: Star, i: int, apart: int) -> Iterator[Decided]:
    """Points of sector i and which other sectors hold them."""
    n = len(star.rays)
    after = (i + apart - 1) % n + 1
    for p in SHARES:
        ray = point(p * star.length(i), star.ray(i), ZERO, ORIGIN)
        yield (
            star.in_sector(i, ray) and star.in_sector(after, ray),
            f"not in S_{i} and S_{after}: {at(star, ray)}",
        )
        for q in SHARES[1:]:
            x = point(p * star.length(i), star.ray(i), q * star.length(i - 1), star.ray(i - 1))
            wanted = {i} if p else {i, (i - 2) % n + 1}
            yield set(star.sectors_of(x)) == wanted, f"in {star.sectors_of(x)}: {at(star, x)}"
    beyond = point(star.length(i), star.ray(i), ZERO, ORIGIN)
    yield not star.sectors_of(beyond), f"the end of ray {i} lies in T: {at(star, beyond)}"
    yield star.sectors_of(ORIGIN) == tuple(star.rays), "the origin is not in every sector"


def _pair_point(star: Star, i: int, xi: Fraction, eta: Fraction, *, behind: int = -1) -> Point:
    def s(j: int) -> Vector:
        return _vector(star.ray(j))

    return _plane(printed.pair_point(s, i, xi, eta, positive=eta >= 0, behind=behind))


def coordinates(star: Star, i: int) -> Iterator[tuple[Fraction, Fraction]]:
    """Coordinates in (0, l_i) x (-l_(i-1), l_(i+1))."""
    for p in SHARES[1:]:
        for q in SHARES:
            yield p * star.length(i), q * star.length(i + 1)
            if q:
                yield p * star.length(i), -q * star.length(i - 1)


def _in_interior(star: Star, first: int, second: int, x: Point) -> bool:
    """Whether x is inside the union of two sectors: in one, or on their common ray, not 0."""
    inside = star.inside_sector(first, x) or star.inside_sector(second, x)
    return inside or (x != ORIGIN and star.in_sector(first, x) and star.in_sector(second, x))


def patch(setting: Setting, *, shift: int = 0, range_swapped: bool = False) -> Evidence:
    """Image of (0, l_i) x (-l_(i-1), l_(i+1)) against the interior of two sectors.

    shift: the sectors S_(i-1+shift), S_(i+shift), printed with shift 0; range_swapped: whether the
    range of eta is (-l_(i+1), l_(i-1)).
    """

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            n = len(star.rays)
            for i in star.rays:
                pair = printed.pair_of_sectors(i, shift=shift)
                first, second = ((j - 1) % n + 1 for j in pair)
                for xi, eta in coordinates(star, i):
                    if range_swapped:
                        eta = -eta
                    x = _pair_point(star, i, xi, eta)
                    yield (
                        _in_interior(star, first, second, x),
                        (
                            f"(xi_{i}, eta_{i}) = ({xi}, {eta}) is outside S_{first}, S_{second}: "
                            f"{at(star, x)}"
                        ),
                    )
                for j in (first, second):
                    yield from _covered(star, i, j)

    return decided(
        rows(),
        shown="the coordinates (xi_i, eta_i) of the stated range give points inside S_i, S_(i+1) "
        "and on their common ray, and every such point tried has coordinates in the range",
    )


def _covered(star: Star, i: int, j: int) -> Iterator[Decided]:
    """Interior points of sector j have coordinates of pair i in the range."""
    for p in SHARES[1:]:
        for q in SHARES[1:]:
            x = point(p * star.length(j - 1), star.ray(j - 1), q * star.length(j), star.ray(j))
            neighbours = (i + 1, i - 1)
            found = False
            for k in neighbours:
                area = cross2(star.ray(i), star.ray(k))
                xi = cross2(x, star.ray(k)) / area
                height = cross2(star.ray(i), x) / area
                found |= 0 < xi < star.length(i) and 0 < height < star.length(k)
            yield found, f"no coordinates (xi_{i}, eta_{i}): {at(star, x)}"


def overlap(setting: Setting, *, shift: int = 1) -> Evidence:
    """Points that the pairs i and i + 1 both cover, and the interior of the sector called S_i.

    shift: its number in (def:sectors) is i + shift; 1 in the numbering of line 480.
    """

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            n = len(star.rays)
            for i in star.rays:
                stated = (printed.overlap(i, shift=shift) - 1) % n + 1
                for xi, eta in coordinates(star, i):
                    x = _pair_point(star, i, xi, eta)
                    after = i % n + 1
                    both = _in_interior(star, after, after % n + 1, x)
                    inside = (eta > 0 and stated == after) or (eta < 0 and stated == i)
                    yield (
                        both == inside,
                        (
                            f"patches {i}, {i + 1} {'both hold' if both else 'do not both hold'} "
                            f"{at(star, x)}"
                        ),
                    )

    return decided(
        rows(), shown="of the points of patch i, those that patch i + 1 holds are the interior "
        "points of the sector between s_i and s_(i+1)",
    )  # fmt: skip


def bi_lipschitz(
    setting: Setting, *, lower: int = 1, folded: bool = False, behind: int = -1
) -> Evidence:
    """Distances in (xi, eta) and in the plane, squared, with constants from the least sine s.

    Across the ray x - y = D s_i + a s_(i+1) - h s_(i-1) with a, h >= 0: its part normal to s_i is
    a sin + h sin >= s (a + h), and |D| <= |x - y| + a + h. So |x - y| <= |D| + a + h and
    D^2 + (a + h)^2 <= ((1 + 1/s)^2 + 1/s^2) |x - y|^2. lower: factor of the last constant's
    inverse; folded: whether both sides of the ray use s_(i+1); behind: i + behind is the index of
    the ray used where eta < 0.
    """

    def rows() -> Iterator[Decided]:
        for star in stars(setting):
            for i in star.rays:
                sine = min(star.sine(i), star.sine(i + 1))
                constant = ((1 + 1 / sine) ** 2 + 1 / sine**2) / lower
                found = list(coordinates(star, i))
                for p in found:
                    for q in found:
                        x, y = (
                            _pair_point(star, i, xi, abs(eta) if folded else eta, behind=behind)
                            for xi, eta in (p, q)
                        )
                        before = (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2
                        after = (x[0] - y[0]) ** 2 + (x[1] - y[1]) ** 2
                        yield (
                            after <= 2 * before and before <= constant * after,
                            (
                                f"squared distances {before} and {after}, coordinates {p} and {q}: "
                                f"{at(star, x)}"
                            ),
                        )

    return decided(
        rows(),
        shown="|x - y| <= sqrt(2) |difference of coordinates|, which is at most sqrt((1 + 1/s)^2 + "
        "1/s^2) |x - y|, s the lesser sine of both angles: by hand from the part of x - y normal "
        "to the ray, where both sides add up, and at all pairs of rational points tried",
    )
