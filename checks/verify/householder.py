"""Checks of section 4: the fourth normal of a quad, its quadratic equation, (eq:householder)."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import discrete_surfaces, spherical_quads
from checks.verify.discrete_lelieuvre import minus
from checks.verify.unit_vectors import Corner, corner, quad_symbols, symbols
from discrete.isometries import half_turn, reflection
from discrete.quad_rule import close_quad
from discrete.space_forms import dot_s2
from theory.vectors import Vector, added, cross, dot, scaled

NU = sp.Symbol("nu", real=True)
_E: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))


def _at(x: str, y: str, z: str) -> Vector:
    """Rational vector."""
    return (sp.Rational(x), sp.Rational(y), sp.Rational(z))


def moutard_net(setting: Setting, *, sign: int = -1, antipodal: bool = False) -> Evidence:
    """Whether the condition forces N_12 = nu (N_1 + N_2) - N_0, for some nu.

    With A = N_0 + N_12 and B = N_1 + N_2, |B|^2 A - <A, B> B = B x (A x B): where A x B = 0 and
    B is not 0, A = nu B for nu = <A, B>/|B|^2. antipodal: drops N_1 + N_2 != 0.
    """
    n_0, n_1, n_2, n_12 = quad_symbols()
    half = sp.Rational(1, 2)
    condition = discrete_surfaces.factored(n_0, n_1, n_2, n_12, half=half)
    b = added(n_1, n_2)
    a = added(n_0, n_12)
    nu = dot(a, b) / dot(b, b)
    if antipodal:
        e = (sp.Integer(1), sp.Integer(0), sp.Integer(0))
        n_0, n_1, n_12 = e, (0, 1, 0), (0, 0, 1)
        n_2 = scaled(-1, n_1)
        closed = discrete_surfaces.factored(n_0, n_1, n_2, n_12, half=half)
        found = {"condition": closed, "N_12 + N_0, B = 0": added(n_0, n_12)}
        return identities(setting, found, shown="the condition forces a Moutard net")
    stated = spherical_quads.moutard(n_0, n_1, n_2, nu, sign=sign)
    forced = scaled(2 / dot(b, b), cross(b, condition))
    back = spherical_quads.moutard(n_0, n_1, n_2, NU, sign=sign)
    return identities(
        setting,
        {
            "N_12 minus nu B - N_0": minus(minus(n_12, stated), forced),
            "converse": discrete_surfaces.factored(n_0, n_1, n_2, back, half=half),
        },
        shown="N_12 - nu (N_1 + N_2) + N_0 = B x (A x B)/|B|^2 with nu = <A, B>/|B|^2, so it is 0 "
        "where the condition holds and B = N_1 + N_2 is not 0; conversely every nu satisfies it",
    )


def norm_of_fourth(setting: Setting, *, middle: int = -2, power: int = 2) -> Evidence:
    """First line for <N_12, N_12>, for any vectors."""
    n_0, n_1, n_2, _ = quad_symbols()
    n_12 = spherical_quads.moutard(n_0, n_1, n_2, NU)
    stated = spherical_quads.squared_norm(n_0, n_1, n_2, NU, middle=middle, power=power)
    return identities(
        setting,
        {"<N_12, N_12>": dot(n_12, n_12) - stated},
        shown="the square of nu (N_1 + N_2) - N_0 is as written, for any three vectors and nu",
    )


def norm_of_fourth_unit(
    setting: Setting, *, middle: int = -2, constant: int = 1, unit: bool = True
) -> Evidence:
    """Second line for <N_12, N_12>; unit: whether N_0 is a unit vector, N_1 and N_2 arbitrary."""
    n_0, n_1, n_2, _ = quad_symbols()
    if unit:
        n_0 = corner().n_2
    n_12 = spherical_quads.moutard(n_0, n_1, n_2, NU)
    stated = spherical_quads.squared_norm_unit(n_0, n_1, n_2, NU, middle=middle, constant=constant)
    return identities(
        setting,
        {"<N_12, N_12>": dot(n_12, n_12) - stated},
        shown="the second line is the first for every unit vector N_0",
    )


def quadratic(setting: Setting, *, middle: int = -2, unit: bool = True) -> Evidence:
    """Whether <N_12, N_12> - 1 is the right side of the third line, so that both vanish at once."""
    n_0, n_1, n_2, _ = quad_symbols()
    if unit:
        n_0 = corner().n_2
    n_12 = spherical_quads.moutard(n_0, n_1, n_2, NU)
    stated = spherical_quads.quadratic(n_0, n_1, n_2, NU, middle=middle)
    return identities(
        setting,
        {"<N_12, N_12> - 1": dot(n_12, n_12) - 1 - stated},
        shown="<N_12, N_12> - 1 is nu (nu |N_1 + N_2|^2 - 2 <N_1 + N_2, N_0>) for every unit "
        "vector N_0",
    )


def roots(setting: Setting, *, factor: str = "2") -> Evidence:
    """Whether the two roots are nu = 0, which gives -N_0, and the quotient."""
    n_0, n_1, n_2, _ = quad_symbols()
    nu = spherical_quads.root(n_0, n_1, n_2, factor=sp.Rational(factor))
    s = added(n_1, n_2)
    product = dot(s, s) * NU * (NU - nu)
    return identities(
        setting,
        {
            "quadratic form": spherical_quads.quadratic(n_0, n_1, n_2, NU) - product,
            "N_12 for nu = 0": added(spherical_quads.moutard(n_0, n_1, n_2, 0), n_0),
        },
        shown="the quadratic form is |N_1 + N_2|^2 nu (nu - nu_2) with nu_2 the quotient, so these "
        "are all its roots where N_1 + N_2 is not 0, and nu = 0 gives -N_0",
    )


def householder(setting: Setting, *, factor: str = "1", identity: int = -1) -> Evidence:
    """(eq:householder) against the root nu != 0 and the shipped half-turn, and its norm."""
    n_0, n_1, n_2, _ = quad_symbols()
    stated = spherical_quads.householder(
        n_0, n_1, n_2, factor=sp.Rational(factor), identity=identity
    )
    nu = spherical_quads.root(n_0, n_1, n_2)
    rhombus = (_E, _at("3/5", "4/5", "0"), _at("3/5", "0", "4/5"))
    far = spherical_quads.householder(*rhombus, factor=sp.Rational(factor), identity=identity)
    return identities(
        setting,
        {
            "|N_12|^2 - 1 for N_0 = (1, 0, 0), N_1 = (3/5, 4/5, 0), N_2 = (3/5, 0, 4/5)": (
                dot(far, far) - 1
            ),
            "the root nu_2": minus(stated, spherical_quads.moutard(n_0, n_1, n_2, nu)),
            "shipped half-turn": minus(stated, close_quad(dot_s2, n_0, n_1, n_2)),
            "|N_12|^2 - |N_0|^2": dot(stated, stated) - dot(n_0, n_0),
        },
        shown="the matrix times N_0 is nu_2 (N_1 + N_2) - N_0, it is what the shipped rule gives, "
        "and it has the length of N_0, for any three vectors with N_1 + N_2 not 0",
    )


def desired_root(setting: Setting, *, chosen: str = "second") -> Evidence:
    """Which root tends to N_0 when N_1 and N_2 do: N_i = N_0 + t a_i, t to 0.

    chosen: "first" (nu = 0) or "second".
    """
    t = sp.Symbol("t", real=True)
    base, first, second = symbols("n"), symbols("a"), symbols("b")
    n_1, n_2 = added(base, scaled(t, first)), added(base, scaled(t, second))
    nu = spherical_quads.root(base, n_1, n_2) if chosen == "second" else sp.Integer(0)
    n_12 = spherical_quads.moutard(base, n_1, n_2, nu)
    # The denominator |N_1 + N_2|^2 is 4 |N_0|^2 at t = 0, so the quotient is continuous there.
    limit = tuple(sp.cancel(entry.subs(t, 0)) for entry in n_12)
    antipode = spherical_quads.moutard(base, n_1, n_2, sp.Integer(0))
    return identities(
        setting,
        {"limit minus N_0": minus(limit, base), "antipode": added(antipode, base)},
        shown="nu = 0 gives -N_0 whatever N_1 and N_2 are; the other root, a quotient whose "
        "denominator tends to 4, tends to N_0 when N_1 and N_2 do",
    )


def _equal_edges() -> Corner:
    """Corner with two edges of one length."""
    x = sp.Symbol("x", positive=True)
    return corner(x=x, y=x)


def reflection_in_plane(
    setting: Setting, *, equal_edges: bool = False, mirror: str = "plane"
) -> Evidence:
    """Whether the fourth normal is the mirror image of N_0 in the plane of N_1 and N_2.

    equal_edges: requires <N_0, N_1> = <N_0, N_2>; mirror: "plane" of N_1, N_2, or "bisector", the
    plane orthogonal to N_1 + N_2, whose reflection is minus the half-turn.
    """
    found = {}
    if not equal_edges:
        n_1, n_2 = _at("3/5", "4/5", "0"), _at("0", "0", "1")
        image = reflection(dot_s2, cross(n_1, n_2), _E)
        far = spherical_quads.moutard(_E, n_1, n_2, spherical_quads.root(_E, n_1, n_2))
        found["N_0 = (1, 0, 0), N_1 = (3/5, 4/5, 0), N_2 = (0, 0, 1)"] = minus(far, image)
    c = _equal_edges() if equal_edges else corner()
    normal = cross(c.n_1, c.n_2) if mirror == "plane" else added(c.n_1, c.n_2)
    nu = spherical_quads.root(c.n_0, c.n_1, c.n_2)
    far = spherical_quads.moutard(c.n_0, c.n_1, c.n_2, nu)
    found["N_12 minus mirror image"] = minus(far, reflection(dot_s2, normal, c.n_0))
    found["N_12 minus half-turn"] = minus(far, half_turn(dot_s2, added(c.n_1, c.n_2), c.n_0))
    return identities(
        setting,
        found,
        shown="for edges of equal length the half-turn about N_1 + N_2 and the reflection in the "
        "plane of N_1 and N_2 move N_0 to the same point, which is N_12",
    )


def any_three_corners(setting: Setting, *, shared: str = "neighbours") -> Evidence:
    """Whether the same formula gives each normal of a quad from the three others.

    shared: which two normals the formula is given, the "neighbours" of the unknown one, or by
    mistake its "opposite" and one neighbour.
    """
    c = corner()
    n = {"0": c.n_0, "1": c.n_1, "2": c.n_2, "12": close_quad(dot_s2, c.n_0, c.n_1, c.n_2)}
    quads = {"0": ("12", "1", "2"), "1": ("2", "0", "12"), "2": ("1", "0", "12")}
    found: dict[str, Any] = {}
    for name, (opposite, first, second) in quads.items():
        args = (n[opposite], n[first], n[second])
        if shared != "neighbours":
            args = (n[first], n[opposite], n[second])
        nu = spherical_quads.root(*args)
        found[f"N_{name}"] = minus(n[name], spherical_quads.moutard(*args, nu))
    return identities(
        setting,
        found,
        shown="with N_12 from N_0, N_1, N_2 in general position the relabelled formula gives back "
        "each of N_0, N_1 and N_2 from the other three",
    )


def determination(
    setting: Setting, *, shared: str = "neighbours", antipodal: bool = False
) -> Evidence:
    """Both parts of the claim on three corners; antipodal: lets the neighbours of the fourth be so.

    The condition is symmetric in all four corners up to its sign, so uniqueness is shown for one.
    """
    return combined(
        {
            "formula": any_three_corners(setting, shared=shared),
            "Moutard net": moutard_net(setting, antipodal=antipodal),
            "two roots": roots(setting),
        },
        shown="the relabelled formula gives each normal from the three others in general position, "
        "and where the neighbours of the unknown one are not antipodal only minus the opposite "
        "normal is another solution",
    )
