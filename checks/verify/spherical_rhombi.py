"""Checks of section 4: quads with four equal sides, (eq:d_chebyshev), lem:construct's proof."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import discrete_surfaces, spherical_quads
from checks.verify import gram
from checks.verify.gram import Combination, Gram, plus, vector
from checks.verify.unit_vectors import Corner, X, Y, Z, corner
from discrete.quad_rule import close_quad
from discrete.space_forms import dot_s2
from theory.vectors import Vector, added, dot, scaled

_N0, _N1, _N2, _N12 = (vector(name) for name in gram.NAMES)
_FIRST_SUM = plus((1, _N0), (1, _N12))
_SECOND_SUM = plus((1, _N1), (1, _N2))
_FIRST_DIAGONAL = plus((1, _N0), (-1, _N12))
_SECOND_DIAGONAL = plus((1, _N1), (-1, _N2))


def _corner(equal: bool) -> Corner:
    return corner(X, X, Z) if equal else corner(X, Y, Z)


def _fourth(c: Corner, *, root: str = "second", factor: Any = 2) -> tuple[Any, Vector]:
    """Root nu as printed and the fourth normal that it gives."""
    nu = sp.Integer(0)
    if root == "second":
        nu = spherical_quads.root(c.n_0, c.n_1, c.n_2, factor=factor)
    return nu, spherical_quads.moutard(c.n_0, c.n_1, c.n_2, nu)


def edge_angle(setting: Setting, *, unit: bool = True) -> Evidence:
    """Whether equal chords from N_0 mean equal inner products; unit: |N_1| = |N_2| = 1."""
    found = gram.general().products
    if unit:
        found = {pair: 1 if pair[0] == pair[1] else g for pair, g in found.items()}
    g = Gram(products=found)
    chords = [plus((1, _N0), (-1, n)) for n in (_N1, _N2)]
    first, second = (g.inner(chord, chord) for chord in chords)
    difference = g.inner(_N0, _N1) - g.inner(_N0, _N2)
    return identities(
        setting,
        {"difference of squared chords": second - first - 2 * difference},
        shown="|N_0 - N_2|^2 - |N_0 - N_1|^2 = 2 (<N_0, N_1> - <N_0, N_2>) for unit vectors, so "
        "one difference vanishes with the other",
    )


def rhombus_sum(
    setting: Setting, *, equal: bool = True, twice: str = "2", root: str = "second"
) -> Evidence:
    """First line of the proof of lem:Chebyshev, for any nu; equal: <N_0, N_1> = <N_0, N_2>.

    <N_12 - N_0, N_12 + N_0> with N_12 + N_0 = nu (N_1 + N_2), and its value 0 for both roots.
    """
    c = _corner(equal)
    found = {}
    for name in ("first", "second"):
        nu, n_12 = _fourth(c, root=name)
        stated = spherical_quads.rhombus_sum(
            c.n_1, c.n_2, n_12, nu, c.cosines[0], twice=sp.Rational(twice)
        )
        product = dot(added(n_12, scaled(-1, c.n_0)), added(n_12, c.n_0))
        found[f"{name} root: product"] = product
        found[f"{name} root: right side"] = product - stated
    return identities(
        setting,
        found,
        shown="both roots give unit vectors, so the product is 0, and with <N_0, N_1> = <N_0, N_2> "
        "= cos delta it is nu (<N_12, N_1 + N_2> - 2 cos delta)",
    )


def rhombus_difference(setting: Setting, *, equal: bool = True, sign: int = -1) -> Evidence:
    """Second line of the proof of lem:Chebyshev, both equalities for both roots."""
    c = _corner(equal)
    found = {}
    for name in ("first", "second"):
        nu, n_12 = _fourth(c, root=name)
        s = added(c.n_1, c.n_2)
        found[f"{name} root: nu <N_1 + N_2, N_1 - N_2>"] = spherical_quads.rhombus_difference(
            c.n_1, c.n_2, s, nu, sign=sign
        )
        found[f"{name} root: nu <N_12, N_1 - N_2>"] = spherical_quads.rhombus_difference(
            c.n_1, c.n_2, n_12, nu, sign=sign
        )
    return identities(
        setting,
        found,
        shown="both products vanish where <N_0, N_1> = <N_0, N_2>; even without the second factor "
        "nu, since <N_12, N_1 - N_2> = nu <N_1 + N_2, N_1 - N_2> - <N_0, N_1 - N_2>",
    )


def sides_of_the_quad(
    setting: Setting, *, root: str = "second", equal: bool = True, factor: str = "2"
) -> Evidence:
    """Whether <N_12, N_1> = <N_12, N_2> = cos delta for the printed root, all delta in (0, pi).

    nu = 0 at delta = pi/2 is among these; root: "first" takes nu = 0 always.
    """
    c = _corner(equal)
    _, n_12 = _fourth(c, root=root, factor=sp.Rational(factor))
    cosine = c.cosines[0]
    return identities(
        setting,
        {
            "<N_12, N_1> - cos delta": dot(n_12, c.n_1) - cosine,
            "<N_12, N_2> - cos delta": dot(n_12, c.n_2) - cosine,
        },
        shown="for every delta in (0, pi), pi/2 among them, and every angle at N_0 between the two "
        "edges, both inner products are cos delta",
    )


def implication(setting: Setting, *, root: str = "second") -> Evidence:
    """Whether the two lines alone force the sides, as linear equations in the two products.

    nu (a + b - 2 c) = 0 and nu (a - b) = 0 for a = <N_12, N_1>, b = <N_12, N_2>; root: "second" has
    nu != 0 (delta != pi/2), "first" nu = 0.
    """
    a, b, cosine = sp.symbols("a b c", real=True)
    nu = sp.Symbol("nu", nonzero=True, real=True) if root == "second" else sp.Integer(0)
    lines = [nu * (a + b - 2 * cosine), nu * (a - b)]
    solved = sp.solve(lines, [a, b], dict=True)
    forced = solved == [{a: cosine, b: cosine}]
    return statement(
        forced,
        shown="for nu != 0 the two lines have one solution, a = b = cos delta",
        witness="nu = 0: both lines are 0 = 0, as for N_12 = -N_0, where <N_12, N_1> = -cos delta",
    )


def d_chebyshev(
    setting: Setting, *, root: str = "second", equal: bool = True, factor: str = "2"
) -> Evidence:
    """(eq:d_chebyshev): the implication, where nu != 0, and its conclusion for every delta."""
    return combined(
        {
            "implication": implication(setting, root=root),
            "conclusion": sides_of_the_quad(setting, root=root, equal=equal, factor=factor),
        },
        shown="for nu != 0 the two lines force a = b = cos delta; the conclusion holds for every "
        "delta, also where nu = 0 and both lines are empty (delta = pi/2, N_12 = -N_0)",
    )


def spherical_rhombus(
    setting: Setting, *, equal: bool = True, factor: str = "2", root: str = "second"
) -> Evidence:
    """lem:Chebyshev for the unit vector of the root nu_2, and for the shipped rule.

    equal: |N_0 - N_1| = |N_0 - N_2|. All four sides are compared, and the norm of N_12.
    """
    c = _corner(equal)
    _, n_12 = _fourth(c, root=root, factor=sp.Rational(factor))
    shipped = close_quad(dot_s2, c.n_0, c.n_1, c.n_2)
    found: dict[str, Any] = {"|N_12|^2 - 1": dot(n_12, n_12) - 1}
    sides = {"N_0 N_2": dot(c.n_0, c.n_2)}
    for name, far in (("printed", n_12), ("shipped", shipped)):
        sides |= {f"N_1 N_12, {name}": dot(c.n_1, far), f"N_12 N_2, {name}": dot(far, c.n_2)}
    first = dot(c.n_0, c.n_1)
    found |= {f"side {name} minus side N_0 N_1": side - first for name, side in sides.items()}
    return identities(
        setting,
        found,
        shown="with two equal edges at N_0, of any length below pi and at any angle, all four "
        "sides are equal and N_12 is a unit vector",
    )


def _over(setting: Setting, found: dict[str, Any], shown: str) -> Evidence:
    return identities(setting, found, shown=shown)


def orthogonal_to_total(setting: Setting, *, last: int = -1, longer: bool = False) -> Evidence:
    """<N_0 - N_12, N_0 + N_1 + N_2 + N_12>: the expansion, for any vectors, and its value 0.

    last: sign of <N_12, N_1 + N_2>; longer: lets one side of the quad, N_12 N_2, have its own
    length.
    """
    total = plus((1, _FIRST_SUM), (1, _SECOND_SUM))
    any_four, rhombus = gram.general(), _rhombus(longer)

    def expanded(g: Gram) -> Any:
        squares = g.inner(_N0, _N0) - g.inner(_N12, _N12)
        return squares + g.inner(_N0, _SECOND_SUM) + last * g.inner(_N12, _SECOND_SUM)

    left = any_four.inner(_FIRST_DIAGONAL, total)
    return _over(
        setting,
        {"expansion": left - expanded(any_four), "value": rhombus.inner(_FIRST_DIAGONAL, total)},
        "the expansion holds for any four vectors, and its value is 0 for four unit vectors with "
        "four equal sides",
    )


def _rhombus(longer: bool) -> Gram:
    """Rhombus; longer: with <N_12, N_2> free, so that three sides only are equal."""
    g = gram.rhombus()
    if not longer:
        return g
    return Gram(products=dict(g.products) | {("2", "12"): sp.Symbol("e", real=True)})


def _orthogonal(
    setting: Setting, diagonal: Combination, *, unit: bool, longer: bool, which: str
) -> Evidence:
    g = _rhombus(longer)
    if not unit:
        names = ("0", "1")
        free = {(n, n): sp.Symbol(f"l_{n}", positive=True) for n in names}
        g = Gram(products=dict(g.products) | free)
    return identities(
        setting,
        {
            "N_0 + N_12": g.inner(_FIRST_SUM, diagonal),
            "N_1 + N_2": g.inner(_SECOND_SUM, diagonal),
        },
        shown=f"both sums are orthogonal to {which} for four unit vectors with four equal sides, "
        "whatever the diagonals",
    )


def sums_and_first_diagonal(
    setting: Setting, *, unit: bool = True, longer: bool = False
) -> Evidence:
    """Whether both sums are orthogonal to N_0 - N_12; unit, longer: hypotheses dropped."""
    return _orthogonal(setting, _FIRST_DIAGONAL, unit=unit, longer=longer, which="N_0 - N_12")


def sums_and_second_diagonal(
    setting: Setting, *, unit: bool = True, longer: bool = False
) -> Evidence:
    """Whether both sums are orthogonal to N_1 - N_2; unit, longer: hypotheses dropped."""
    return _orthogonal(setting, _SECOND_DIAGONAL, unit=unit, longer=longer, which="N_1 - N_2")


def diagonals(setting: Setting, *, longer: bool = False, degenerate: bool = False) -> Evidence:
    """Whether the diagonals are orthogonal, and independent where neither is zero.

    degenerate: drops N_0 != N_12 (p = 1).
    """
    g = _rhombus(longer)
    product = g.inner(_FIRST_DIAGONAL, _SECOND_DIAGONAL)
    squares = [g.inner(d, d) for d in (_FIRST_DIAGONAL, _SECOND_DIAGONAL)]
    parts = {
        "product": identities(
            setting,
            {
                "product": product,
                "gram determinant": squares[0] * squares[1]
                - product**2
                - 4 * (1 - gram.P) * (1 - gram.Q),
            },
            shown="",
        )
    }
    # Unit vectors are different exactly if their product is below 1: p = 1 - a, q = 1 - b.
    a, b = sp.symbols("a b", positive=True)
    area = (4 * (1 - gram.P) * (1 - gram.Q)).subs(
        {gram.P: 1 if degenerate else 1 - a, gram.Q: 1 - b}
    )
    parts["independent"] = statement(
        bool(area.is_positive),
        shown="",
        witness="N_0 = N_12, p = 1: N_0 - N_12 = 0, so the two diagonals are dependent",
    )
    return combined(
        parts,
        shown="the inner product of the diagonals vanishes and their Gram determinant is "
        "4 (1 - p) (1 - q), which is positive unless p = 1 or q = 1: they are independent where "
        "neither is zero",
    )


def sums_parallel(
    setting: Setting, *, longer: bool = False, degenerate: bool = False, third: int = 0
) -> Evidence:
    """Whether N_0 + N_12 and N_1 + N_2 are parallel for a rhombus that is not degenerate.

    Four vectors of R^3 have a vanishing Gram determinant, which for a rhombus is (1 - p) (1 - q)
    times that of the two sums, up to 1/4; and on coordinates the printed condition vanishes.
    degenerate: N_0 = N_12 with N_1, N_2 free; third: edges of a third length at N_12.
    """
    g = _rhombus(longer)
    a, b, ab = (
        g.inner(one, other)
        for one, other in (
            (_FIRST_SUM, _FIRST_SUM),
            (_SECOND_SUM, _SECOND_SUM),
            (_FIRST_SUM, _SECOND_SUM),
        )
    )
    factored = (1 - gram.P) * (1 - gram.Q) * (a * b - ab**2) / 4
    c = corner(X, X, Z)
    far = c.n_0 if degenerate else close_quad(dot_s2, c.n_0, c.n_1, c.n_2)
    if third:
        far = close_quad(dot_s2, far, c.n_1, c.n_0)
    condition = discrete_surfaces.product_of_sums(c.n_0, c.n_1, c.n_2, far)
    return identities(
        setting,
        {
            "Gram determinant": g.determinant() - factored,
            "(eq:d_compatible)": condition,
        },
        shown="the Gram determinant of a rhombus, 0 in R^3, is (1 - p)(1 - q)/4 times that of the "
        "two sums: these are parallel unless p = 1 or q = 1; with coordinates (eq:d_compatible) "
        "holds for every rhombus of the rule",
    )
