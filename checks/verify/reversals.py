"""Section 4.1: the criterion (reversal), its invariance, and what it says of the quads of a node.

The other route is that of the hyperboloid: a quad is flipped as det(p, p_u, p_v) has another sign.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cache
from itertools import product
from math import prod
from random import Random
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import poincare_disk
from checks.printed import reversals as printed
from discrete.geodesics import determinant
from discrete.goursat_fill import fill
from discrete.poincare_disk import from_disk, to_disk
from discrete.space_forms import dot_h2
from theory import amsler

Pair = tuple[Any, Any]
Star = dict[tuple[int, int], Pair]
#: Unit vectors (a, b)/c.
_TRIPLES = ((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (20, 21, 29), (1, 0, 1))
_MODULI = (Fraction(1, 3), Fraction(1, 10), Fraction(1, 100))
_CENTRES = ((Fraction(0), Fraction(0)), (Fraction(1, 2), Fraction(1, 5)))
_SAMPLES = 1200


def _unit(rng: Random) -> Pair:
    a, b, c = rng.choice(_TRIPLES)
    x, y = Fraction(rng.choice((-1, 1)) * a, c), Fraction(rng.choice((-1, 1)) * b, c)
    return (x, y) if rng.random() < 0.5 else (y, x)


def rational_star(rng: Random) -> tuple[Pair, Star]:
    """Node of the disk and four neighbours at one distance from it, all rational."""
    centre, modulus = rng.choice(_CENTRES), rng.choice(_MODULI)
    star: Star = {}
    for at in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        x, y = _unit(rng)
        star[at] = poincare_disk.moebius((modulus * x, modulus * y), centre)
    return centre, star


def _hyperboloid_signs(centre: Pair, star: Star) -> list[int]:
    """Orientation of each quad against that of the net, by determinants of triples.

    The quad (p, q) of a net without folds has the orientation p q.
    """
    found = []
    for p, q in printed.QUADS:
        value = determinant(from_disk(centre), from_disk(star[p, 0]), from_disk(star[0, q]))
        found.append(p * q * (int(value > 0) - int(value < 0)))
    return found


def signed_stars(setting: Setting) -> Iterator[tuple[Pair, Star, list[int]]]:
    """Random rational stars with the orientations of their quads."""
    rng = setting.random()
    for _ in range(_SAMPLES):
        centre, star = rational_star(rng)
        yield centre, star, _hyperboloid_signs(centre, star)


@cache
def _same_orientation() -> bool:
    """Whether 4 omega(w_1, w_2) is det(p, p_1, p_2) (1 - |w_1|^2)(1 - |w_2|^2), w = f(.; -z).

    An identity of rational functions: each factor of (reversal) has the sign of the determinant.
    """
    _, *field = sp.field("a1 a2 b1 b2 c1 c2", sp.QQ)
    a, b, c = (field[0], field[1]), (field[2], field[3]), (field[4], field[5])
    away = (-a[0], -a[1])
    w1, w2 = poincare_disk.moebius(b, away), poincare_disk.moebius(c, away)
    scale = (1 - poincare_disk.square(w1)) * (1 - poincare_disk.square(w2))
    triples = determinant(from_disk(a), from_disk(b), from_disk(c))
    return bool(triples * scale == 4 * printed.oriented(w1, w2))


def _by_signs(rule: Callable[[list[int], list[int]], bool], *, shown: str) -> Evidence:
    """Evidence that a rule holds for all 81 patterns of signs, hence for all nodes.

    rule: of the signs of the four factors and of the orientations of the quads against the net.
    """
    for signs in product((-1, 0, 1), repeat=4):
        factors = [p * q * x for (p, q), x in zip(printed.QUADS, signs, strict=True)]
        if not rule(factors, list(signs)):
            return statement(False, shown="", witness=f"quads oriented as {signs}")
    return statement(
        _same_orientation(), shown=shown, witness="a factor is no positive multiple of det"
    )


def _shown(centre: Pair, star: Star) -> str:
    around = ", ".join(f"{at}: {_text(z)}" for at, z in star.items())
    return f"node {_text(centre)} with the neighbours {around}"


def _text(z: Pair) -> str:
    return f"({z[0]}, {z[1]})"


def definition(
    setting: Setting, *, strict: bool = False, quads: int = 4, moved: bool = True,
    form: str = "product",
) -> Evidence:  # fmt: skip
    """Whether (reversal) picks the nodes with a collapsed quad or an odd number of flipped ones."""
    seen: Counter[bool] = Counter()
    for centre, star, signs in signed_stars(setting):
        factors = printed.orientations(centre, star, quads=quads, moved=moved)
        found = printed.is_reversal(factors, strict=strict, form=form)
        wanted = 0 in signs or signs.count(-1) % 2 == 1
        seen[wanted] += 1
        if found != wanted:
            return statement(
                False,
                shown="",
                witness=f"{_shown(centre, star)}: signs of the four quads {signs}, yet the "
                f"criterion gives {found}",
            )
    if min(seen.values()) < _SAMPLES // 10:
        return statement(False, shown="", witness=f"hardly a node of one kind: {dict(seen)}")
    return _by_signs(
        lambda factors, signs: (
            printed.is_reversal(factors, strict=strict, form=form)
            == (0 in signs or signs.count(-1) % 2 == 1)
        ),
        shown="(reversal) holds exactly where det(p, p_u, p_v) has another sign on one or three of "
        "the four quads, or vanishes on one: each factor is a positive multiple of it, and all "
        f"patterns of signs were tried, beside {_SAMPLES} rational nodes of both kinds",
    )  # fmt: skip


def detects_folds(setting: Setting, *, form: str = "product", against: str = "any") -> Evidence:
    """Whether (reversal) holds at each node about which the net folds: its quads differ in sign.

    form: as in the criterion; against: `any` quads that differ, or `one` against the other three.
    """
    met = 0
    for centre, star, signs in [line_fold(), *signed_stars(setting)]:
        different = len(set(signs)) > 1
        if against == "one" and signs.count(-1) not in (1, 3):
            continue
        met += different
        found = printed.is_reversal(printed.orientations(centre, star), form=form)
        if found != different and 0 not in signs:
            return statement(
                False,
                shown="",
                witness=f"{_shown(centre, star)}: its quads (1,1), (1,-1), (-1,1), (-1,-1) are "
                f"oriented as {signs}, yet the criterion gives {found}",
            )
    if met < _SAMPLES // 10:
        return statement(False, shown="", witness="hardly a node with a fold")
    return _by_signs(
        lambda factors, signs: (
            0 in signs
            or (against == "one" and signs.count(-1) not in (1, 3))
            or printed.is_reversal(factors, form=form) == (len(set(signs)) > 1)
        ),
        shown="the criterion holds exactly at the nodes whose quads are not all oriented alike",
    )


def line_fold() -> tuple[Pair, Star, list[int]]:
    """Node on a v-line that the u-lines touch from one side: all four quads lie above it."""
    half, zero = Fraction(1, 2), Fraction(0)
    star: Star = {
        (1, 0): (Fraction(-6, 13), Fraction(5, 26)),
        (-1, 0): (Fraction(6, 13), Fraction(5, 26)),
        (0, 1): (half, zero),
        (0, -1): (-half, zero),
    }
    centre = (zero, zero)
    return centre, star, _hyperboloid_signs(centre, star)


def folded_along_line(setting: Setting, *, form: str = "product", left: str = "above") -> Evidence:
    """Whether a net folded along a v-line has no node with (reversal) on that line.

    An exact net: six v-edges on the real axis and one u-edge to each side of it, both to points
    `above` it; left: where that to the left points, `below` giving a net without a fold.
    """
    del setting
    rate, (c, s) = Fraction(1, 20), (Fraction(12, 13), Fraction(5, 13))
    axis, modulus = [Fraction(0)], Fraction(0)
    for _ in range(3):
        modulus = (modulus + rate) / (1 + modulus * rate)
        axis.append(modulus)
    first = {1: (-rate * c, rate * s), -1: (rate * c, rate * s * (1 if left == "above" else -1))}
    strips: dict[tuple[int, int], Pair] = {}
    for p, near in first.items():
        for q in (1, -1):
            line = [from_disk((q * x, Fraction(0))) for x in axis]
            row = fill(dot_h2, [line[0], from_disk(near)], line)[1]
            strips |= {(p, q * k): to_disk(x) for k, x in enumerate(row)}
    points = {q * k: (q * x, Fraction(0)) for q in (1, -1) for k, x in enumerate(axis)}
    below = [at for at, z in strips.items() if z[1] <= 0]
    seen = []
    for k in range(-2, 3):
        star: Star = {(1, 0): strips[1, k], (-1, 0): strips[-1, k],
                      (0, 1): points[k + 1], (0, -1): points[k - 1]}  # fmt: skip
        if printed.is_reversal(printed.orientations(points[k], star), form=form):
            seen.append(k)
    return statement(
        not below and not seen,
        shown="twelve rhombi with a common v-line, all above it, have no reversal at its nodes",
        witness=f"vertices below the v-line: {below}; reversals at its nodes {seen}",
    )


def one_against_three(setting: Setting, *, strict: bool = False, quads: int = 4) -> Evidence:
    """Whether at each reversal one quad is oriented against the three others."""
    zero, half = Fraction(0), Fraction(1, 2)
    straight: Star = {(1, 0): (half, zero), (-1, 0): (-half, zero),
                      (0, 1): (-half, zero), (0, -1): (zero, -half)}  # fmt: skip
    first = ((zero, zero), straight, _hyperboloid_signs((zero, zero), straight))
    met = 0
    for centre, star, signs in [first, *signed_stars(setting)]:
        factors = printed.orientations(centre, star, quads=quads)
        if not printed.is_reversal(factors, strict=strict):
            continue
        met += 1
        if sorted(signs) not in ([-1, 1, 1, 1], [-1, -1, -1, 1]):
            return statement(
                False, shown="", witness=f"{_shown(centre, star)}: a reversal, its quads "
                f"(1,1), (1,-1), (-1,1), (-1,-1) oriented as {signs}",
            )  # fmt: skip
    if met < _SAMPLES // 10:
        return statement(False, shown="", witness="hardly a reversal")
    return _by_signs(
        lambda factors, signs: (
            not printed.is_reversal(factors[:quads], strict=strict)
            or sorted(signs) in ([-1, 1, 1, 1], [-1, -1, -1, 1])
        ),
        shown="at each reversal one quad is oriented against the three others: all patterns of "
        f"signs were tried, beside {met} rational nodes",
    )


def collinear(setting: Setting, *, moved: bool = False, reversal: bool = True) -> Evidence:
    """Whether at each reversal the differences change their orientation between two quads.

    moved: whether the differences are taken after f(.; -centre), or in the disk as they are;
    reversal: whether the nodes looked at are those with a reversal, or those without.
    """
    met = 0
    for centre, star, signs in signed_stars(setting):
        if 0 in signs:
            continue
        if printed.is_reversal(printed.orientations(centre, star)) != reversal:
            continue
        met += 1
        factors = printed.orientations(centre, star, moved=moved)
        seen = {p * q * (x > 0) - p * q * (x < 0)
                for (p, q), x in zip(printed.QUADS, factors, strict=True)}  # fmt: skip
        if len(seen - {0}) < 2:
            kind = "moved to the origin" if moved else "as they are"
            return statement(
                False, shown="", witness=f"{_shown(centre, star)}: quads oriented as {signs}, yet "
                f"the differences {kind} have one orientation in all four",
            )  # fmt: skip
    if met < _SAMPLES // 20:
        return statement(False, shown="", witness="hardly a reversal")
    return _by_signs(
        lambda factors, signs: (
            0 in signs or printed.is_reversal(factors) != reversal or len(set(signs)) > 1
        ),
        shown="at each reversal the orientation of the two differences changes from one quad to "
        f"another: all patterns of signs were tried, beside {met} rational nodes",
    )


def moebius_invariance(
    setting: Setting, *, moved: bool = True, conjugated: bool = True
) -> Evidence:
    """Whether the images of all neighbours turn by one angle when the net is moved by f(.; c, t).

    In the field of rational functions of a, b, c and t, the turn being (1 + i t)^2/(1 + t^2).
    conjugated: whether f has conj(z_0) below; moved: see `reversals.orientations`.
    """
    options = {"moved": moved, "conjugated": conjugated}
    names = ("a1", "a2", "b1", "b2", "c1", "c2", "t")
    point = [Fraction(n, 7) for n in (1, 2, -3, 1, 2, 3, 5)]
    if any(x != 0 for x in _turning_gaps(point, **options)):
        at = ", ".join(f"{name} = {x}" for name, x in zip(names, point, strict=True))
        return statement(False, shown="", witness=f"at {at} the image is not turned by the factor")
    _, *field = sp.field(names, sp.QQ)
    gaps = _turning_gaps(field, **options)
    return statement(
        all(gap == 0 for gap in gaps),
        shown="f(g(a); -g(b)) is f(a; -b) times a number of modulus 1 that does not depend on a, "
        "so that each of the four factors stays as it is: an identity of rational functions",
        witness="the numerators do not cancel",
    )


def _turning_gaps(values: Sequence[Any], *, moved: bool, conjugated: bool) -> list[Any]:
    """Image of a minus its claimed value, and squared modulus of the factor minus 1."""
    a1, a2, b1, b2, c1, c2, t = values
    a, b, c = (a1, a2), (b1, b2), (c1, c2)
    turn = ((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2))

    def motion(z: Pair) -> Pair:
        return poincare_disk.moebius(z, c, turn=turn, conjugated=conjugated)

    def seen(z: Pair, centre: Pair) -> Pair:
        if not moved:
            return (z[0] - centre[0], z[1] - centre[1])
        return poincare_disk.moebius(z, (-centre[0], -centre[1]))

    # The factor, free of a: turn (1 + c conj b)/(1 + b conj c).
    product = poincare_disk.times(c, poincare_disk.conjugate(b))
    above = (1 + product[0], product[1])
    unit = poincare_disk.times(turn, poincare_disk.over(above, poincare_disk.conjugate(above)))
    turned = poincare_disk.times(unit, seen(a, b))
    gaps = [x - y for x, y in zip(seen(motion(a), motion(b)), turned, strict=True)]
    return [*gaps, poincare_disk.square(unit) - 1]


def both_orientations(setting: Setting, *, quads: int = 4) -> Evidence:
    """Whether the product is the same for omega and -omega, the neighbours being any."""
    places = ((1, 0), (-1, 0), (0, 1), (0, -1))
    plain: Star = {at: (Fraction(k + 1, 7), Fraction(k * k, 11)) for k, at in enumerate(places)}
    one, other = _products((Fraction(1, 3), Fraction(1, 7)), plain, quads)
    if one != other:
        return statement(
            False, shown="", witness=f"neighbours {plain}: {one} for omega, {other} for -omega"
        )
    areas = sp.symbols("x0:4 y0:4", real=True)
    vectors = dict(zip(places, zip(areas[:4], areas[4:], strict=True), strict=True))
    first, second = _products((sp.Integer(0), sp.Integer(0)), vectors, quads)
    return identities(
        setting,
        {"product": first - second},
        shown="the four signs cancel in the product, the neighbours being any",
    )


def _products(centre: Pair, star: Star, quads: int) -> tuple[Any, Any]:
    first, second = (
        prod(printed.orientations(centre, star, omega=w, quads=quads)) for w in (1, -1)
    )
    return first, second


def singular_locus(setting: Setting, *, weight: int = 1, floor: str = "1 - |cos|") -> Evidence:
    """Least stretch of a front in asymptotic coordinates: positive wherever r_u x r_v is not 0.

    |r_u x r_v|^2 = sin^2 phi and |dr(w)|^2 >= (1 - |cos phi|) |w|^2, so by the inverse function
    theorem the map is one-to-one near each point with sin phi not 0.
    weight: of cos phi in the metric; floor: the bound of the stretch that is claimed.
    """
    phi, x, y = sp.symbols("phi x y", real=True)
    parts: dict[str, Evidence] = {}
    for sigma in (1, -1):
        metric = amsler.chebyshev_metric(phi, sigma=sigma)
        mixed = weight * sigma * sp.cos(phi)
        form = metric[0, 0] * x**2 + 2 * metric[0, 1] * x * y + metric[1, 1] * y**2
        least = {"1 - |cos|": 1, "2 - |cos|": 2}[floor]
        # For each sign of cos phi the rest is a square times |cos phi|.
        for sign in (1, -1):
            rest = form - (least - sign * sigma * sp.cos(phi)) * (x**2 + y**2)
            parts[f"stretch, sigma = {sigma}, sign {sign}"] = identities(
                setting, {"rest": rest - sign * sigma * sp.cos(phi) * (x + sign * y) ** 2},
                shown="square",
            )  # fmt: skip
        parts[f"area, sigma = {sigma}"] = identities(
            setting,
            {"det": 1 - mixed**2 - sp.sin(phi) ** 2, "metric": metric.det() - 1 + mixed**2},
            shown="det g = sin^2 phi",
        )  # fmt: skip
    return combined(
        parts,
        shown="|r_u x r_v|^2 = sin^2 phi and |dr(w)|^2 >= (1 - |cos phi|) |w|^2: where r_u x r_v "
        "is not 0 the differential is one-to-one, hence the map near the point",
    )
