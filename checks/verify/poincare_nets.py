"""Section 4.1: the rhombus in the disk, its sides and its fourth vertex, against the half-turn."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import poincare_disk as printed
from discrete import isometries, poincare_disk
from discrete.quad_rule import close_quad
from discrete.space_forms import ORIGIN, dot_h2

X, Y, T, A, B, C, D = sp.symbols("x y t a b c d", real=True)
DELTA = sp.Symbol("Delta", positive=True)
_SMALL = 1 - X**2 - Y**2


def _turned(w: Any, t: Any) -> Any:
    """Complex number w turned by the angle whose half has the tangent t: the same modulus."""
    turn = ((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2))
    return printed.times(turn, w)


def known_sides(
    setting: Setting, *, side: str = "2 tanh(Delta/2)", modulus: str = "Delta/2"
) -> Evidence:
    """Whether the stated sides and w_j fit (eq:hyp_radius), d(0, w) = 2 artanh |w|."""
    length = printed.side(DELTA, sp, form=side)
    size = printed.neighbour_modulus(DELTA, sp, form=modulus)
    return identities(
        setting,
        {"tanh(d/2) - |w_1|": sp.tanh(length / 2) - size},
        where=[2 - DELTA],
        shown=f"with d = {side} and |w_j| = {modulus}, |w_j| = tanh(d/2)",
    )


def first_node(setting: Setting, *, side: str = "2 tanh(Delta/2)") -> Evidence:
    """Stated side against the first two nodes 0 and tanh(Delta/2) of an axis (item C, Amsler)."""
    node = printed.on_ray(1, DELTA, sp.Integer(0), sp)
    return identities(
        setting,
        {"tanh(d/2) - |zeta_1|": sp.tanh(printed.side(DELTA, sp, form=side) / 2) - node[0]},
        where=[2 - DELTA],
        shown=f"the first node of an axis lies at the distance {side} from 0",
    )


def normalised(setting: Setting, *, modulus: str = "Delta/2") -> Evidence:
    """Stated w_1 against the image under f(.; -zeta_0) of the next node at the distance Delta.

    zeta_1 = f(gamma_beta(1); zeta_0), as in item (C).
    """
    beta = sp.Symbol("beta", real=True)
    z0 = (A, B)
    node = printed.moebius(printed.on_ray(1, DELTA, beta, sp), z0)
    w = printed.moebius(node, (-A, -B))
    size = printed.neighbour_modulus(DELTA, sp, form=modulus)
    w0 = printed.moebius(z0, (-A, -B))
    return identities(
        setting,
        {
            "w_0": list(w0),
            "w_1": [w[0] - size * sp.cos(beta), w[1] - size * sp.sin(beta)],
        },
        where=[1 - A**2 - B**2],
        shown=f"w_0 = 0 and w_1 = {modulus} e^(i beta) for a node at the distance Delta",
    )


def closing_lengths(
    setting: Setting, *, side: str = "2 tanh(Delta/2)", modulus: str = "Delta/2", sign: int = 1
) -> Evidence:
    """Whether the stated sides at w_12 are those of the vertex of the formula, and no other's.

    w_1 = r e^(i beta), w_2 = r e^(-i beta). The two circles about them through 0 meet in 0 and once
    more: their radical axis is the real line, on which the equation is quadratic.
    """
    beta, r, x = sp.symbols("beta r x", positive=True)
    w1, w2 = (r * sp.cos(beta), r * sp.sin(beta)), (r * sp.cos(beta), -r * sp.sin(beta))
    w12 = printed.fourth(w1, w2, r**2, sign=sign)
    known = printed.cosh_distance((0, 0), w1)
    on_line = sp.numer(sp.together(printed.cosh_distance((x, 0), w1) - known))
    roots = sp.Poly(on_line, x)
    size = printed.neighbour_modulus(DELTA, sp, form=modulus)
    half = sp.tanh(printed.side(DELTA, sp, form=side) / 2)
    stated = (1 + half**2) / (1 - half**2)
    return combined(
        {
            "sides": identities(
                setting,
                {
                    "cosh d(w_12, w_1) - cosh d(0, w_1)": printed.cosh_distance(w12, w1) - known,
                    "cosh d(w_12, w_2) - cosh d(0, w_2)": printed.cosh_distance(w12, w2) - known,
                    "cosh d(0, w_1) - cosh of the stated side": known.subs(r, size).simplify()
                    - stated,
                },
                where=[1 - r, 2 - DELTA],
                shown="",
            ),
            "no other": statement(
                roots.degree() == 2 and roots.eval(0) == 0,
                shown="",
                witness=f"the equation of the circles on their axis is {on_line} = 0",
            ),
        },
        shown=f"w_12 is the one point but 0 at the distance {side} from w_1 and w_2",
    )


def rule(
    setting: Setting, *, sign: int = 1, weight: str = "1", back: int = 1, rhombus: bool = True
) -> Evidence:
    """Printed rule against the half-turn of the hyperboloid, for all rhombi.

    At zeta_0 = 0 the two fourth vertices agree; f(.; zeta_0) is the translation that takes 0 to
    zeta_0, with which the half-turn commutes; and on rational rhombi elsewhere they agree exactly.
    rhombus: whether the two known sides are equal.
    """
    w1 = (X, Y)
    w2 = _turned(w1, T) if rhombus else (C, D)
    modulus = printed.square(w1) if rhombus else sp.sqrt(printed.square(w1) * printed.square(w2))
    ours = close_quad(dot_h2, ORIGIN, poincare_disk.from_disk(w1), poincare_disk.from_disk(w2))
    theirs = poincare_disk.from_disk(printed.fourth(w1, w2, modulus, sign=sign, weight=weight))
    centre = poincare_disk.from_disk((A, B))
    moved = isometries.translation(dot_h2, ORIGIN, centre, poincare_disk.from_disk((X, Y)))
    seen = poincare_disk.from_disk(printed.moebius((X, Y), (back * A, back * B)))
    return combined(
        {
            "elsewhere": _rational_rhombi(setting, sign=sign, weight=weight, back=back),
            "at 0": identities(
                setting,
                {"w_12": [theirs[k] - ours[k] for k in range(3)]},
                where=[_SMALL, 1 - C**2 - D**2],
                shown="",
            ),
            "f is the translation": identities(
                setting,
                {"f": [seen[k] - moved[k] for k in range(3)]},
                where=[_SMALL, 1 - A**2 - B**2],
                shown="",
            ),
        },
        shown="the printed fourth vertex is that of the half-turn about the midpoint of zeta_1 and "
        "zeta_2, for all rhombi",
    )


_TURNS = ((0, "1/3"), ("1/2", 2), ("-1/5", "7/4"), (3, "-2/3"))
_CENTRES = ((0, "1/2"), ("-2/3", "1/4"), ("3/5", "-3/5"))


def _rational_rhombi(setting: Setting, *, sign: int, weight: str, back: int) -> Evidence:
    """Printed rule at rhombi with rational vertices, against the half-turn, exactly."""
    del setting
    R = sp.Rational
    for centre in _CENTRES:
        for first, turn in _TURNS:
            z0 = (R(centre[0]), R(centre[1]))
            w1 = _turned((R(2, 5), R(0)), R(first))
            z1, z2 = (printed.moebius(w, z0) for w in (w1, _turned(w1, R(turn))))
            found = printed.closed(z0, z1, z2, sp, sign=sign, weight=weight, back=back)
            ours = poincare_disk.to_disk(
                close_quad(dot_h2, *(poincare_disk.from_disk(z) for z in (z0, z1, z2)))
            )
            if found != ours:
                where = f"zeta_0 = {z0}, zeta_1 = {z1}, zeta_2 = {z2}"
                return statement(False, shown="", witness=f"{found} in place of {ours}: {where}")
    return statement(True, shown="rational rhombi", witness="")


def _reduced(z: Any) -> Any:
    """Both parts as reduced quotients of polynomials."""
    return (sp.cancel(z[0]), sp.cancel(z[1]))


def either_diagonal(setting: Setting, *, sign: int = 1, swapped: bool = False) -> Evidence:
    """Printed rule from the other three vertices of a rhombus that it has closed from 0, w_1 > 0.

    swapped: whether a side is taken for a diagonal, which the claim does not allow.
    """
    w0, w1 = (sp.Integer(0), sp.Integer(0)), (X, sp.Integer(0))
    w2 = _turned(w1, T)
    w12 = _reduced(printed.fourth(w1, w2, printed.square(w1), sign=sign))
    cases = {
        "from w_12": ((w12, w1, w2), w0),
        "from w_1": ((w1, w12, w0) if swapped else (w1, w0, w12), w1 if swapped else w2),
        "from w_2": ((w2, w12, w0), w1),
        "exchanged": ((w12, w2, w1), w0),
    }
    residuals = {}
    for name, ((start, one, two), expected) in cases.items():
        away = (-start[0], -start[1])
        e1, e2 = _reduced(printed.moebius(one, away)), _reduced(printed.moebius(two, away))
        modulus = sp.cancel(printed.square(e1))
        opposite = _reduced(printed.fourth(e1, e2, modulus, sign=sign))
        found = _reduced(printed.moebius(opposite, start))
        residuals[name] = [found[k] - expected[k] for k in range(2)]
        residuals[f"{name}: equal sides"] = printed.square(e1) - printed.square(e2)
    return identities(
        setting,
        residuals,
        where=[1 - X**2],
        shown="the rule gives back the fourth vertex from every vertex of the rhombus",
    )
