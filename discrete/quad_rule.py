"""The rule that closes a Chebyshev quad: a half-turn, on the sphere and in the hyperbolic plane.

The quad p, p1, p12, p2 has d(p, p1) = d(p2, p12) and d(p, p2) = d(p1, p12); the lengths of the two
pairs may differ. It is symmetric under the half-turn about the midpoint of either diagonal. With
equal lengths this is (eq:householder) on S^2 and (poincare-ddg) on H^2.
"""

from math import isfinite

from discrete.errors import AntipodalError, NotFiniteError, OffSpaceError
from discrete.space_forms import Product, SpaceForm, Triple

#: Residual <p, p> - K, relative to p0^2, that float64 input may have.
ON_SPACE = 1e-8
#: Square of |p1 + p2| below which float64 leaves less than half its digits to the half-turn.
NEARLY_ANTIPODAL = 1e-16


def close_quad(dot: Product, p: Triple, p1: Triple, p2: Triple) -> Triple:
    """Vertex p12 that closes the Chebyshev quad p, p1, p12, p2 (eq:householder, poincare-ddg).

    Half-turn of p about the midpoint of p1 p2, so opposite sides are equal. p, p1, p2: triples of
    float, (n,) array, arb, mpf or sympy.Expr, on one space. Undefined where <p1 + p2, p1 + p2> = 0
    (antipodal p1, p2 on S^2).
    """
    s = (p1[0] + p2[0], p1[1] + p2[1], p1[2] + p2[2])
    k = 2 * dot(p, s) / dot(s, s)
    return (k * s[0] - p[0], k * s[1] - p[1], k * s[2] - p[2])


def require_on_space(space: SpaceForm, p: Triple, name: str) -> None:
    """Refuse a float triple that is not a point of the space; name: what to call it.

    Raises NotFiniteError, OffSpaceError.
    """
    if not all(isfinite(entry) for entry in p):
        raise NotFiniteError(f"vertex {name} has a coordinate that is not finite: {tuple(p)}")
    defect = space.residual(p)
    near = abs(defect) <= ON_SPACE * max(1.0, p[0] * p[0])  # false for NaN, where p0^2 overflows
    if not near or (space.curvature < 0 and p[0] <= 0):
        raise OffSpaceError(
            f"vertex {name} = {tuple(p)} is no point of {space.name}: <x, x> = "
            f"{space.dot(p, p)}, expected {space.curvature}"
        )


def require_not_antipodal(space: SpaceForm, p1: Triple, p2: Triple, names: str) -> None:
    """Refuse float vertices about whose midpoint no half-turn is determined.

    names: what to call the two. Raises AntipodalError; never on H^2.
    """
    s = (p1[0] + p2[0], p1[1] + p2[1], p1[2] + p2[2])
    if space.curvature > 0 and space.dot(s, s) < NEARLY_ANTIPODAL:
        raise AntipodalError(
            f"vertices {names} are antipodal, or nearly: {tuple(p1)} and {tuple(p2)}; no half-turn "
            "that exchanges them is singled out: shorten the edges, or stop the net before"
        )


def closed_quad(space: SpaceForm, p: Triple, p1: Triple, p2: Triple) -> Triple:
    """Vertex that closes a Chebyshev quad whose float vertices come from a user.

    Raises NotFiniteError, OffSpaceError, AntipodalError, naming the vertex; also where so long
    edges of H^2 leave p12 without digits.
    """
    for name, vertex in (("p", p), ("p1", p1), ("p2", p2)):
        require_on_space(space, vertex, name)
    require_not_antipodal(space, p1, p2, "p1 and p2")
    p12 = close_quad(space.dot, p, p1, p2)
    require_on_space(space, p12, "p12")
    return p12
