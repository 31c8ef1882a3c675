"""Checks of section 4: patches of hyperboloids on the quads of a surface with planar stars.

A patch through the four edges of a skew quad is rational bilinear with weights w; it depends on
rho = w_0 w_12/(w_1 w_2) alone. Along the edge from x to y, at the ratio tau of weights, its tangent
plane is spanned by the edge and a + rho tau b, where a and b are the other edges at x and at y.
"""

from dataclasses import dataclass
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.verify.discrete_lelieuvre import minus
from checks.verify.quad_meshes import odd_star
from checks.verify.spherical_samples import star_net
from discrete.signed_graph import IntArray
from discrete.spherical_net import surface_points
from theory.vectors import Vector, added, scaled, triple

_TAU = sp.Symbol("tau", positive=True)


@dataclass(frozen=True, kw_only=True)
class Contact:
    """Two quads along an edge e from x to y: the other edges a at x and b at y in each of them.

    inverse: whether rho of each quad counts inverted at x, its corners 1 and 3.
    """

    faces: tuple[int, int]
    e: Vector
    a: tuple[Vector, Vector]
    b: tuple[Vector, Vector]
    inverse: tuple[bool, bool]

    def carried(self, rho: Any) -> Any:
        """Value of rho of the second quad from that of the first, by equal tangent planes."""
        own = 1 / rho if self.inverse[0] else rho
        (a_1, a_2), (b_1, b_2) = self.a, self.b
        found = -own * triple(self.e, b_1, a_2) / triple(self.e, a_1, b_2)
        return 1 / found if self.inverse[1] else found

    def defect(self, first: Any, second: Any) -> Any:
        """Determinant of the edge and both directions in the tangent planes, at every tau."""
        rho = [
            1 / r if inverse else r
            for r, inverse in zip((first, second), self.inverse, strict=True)
        ]
        one, other = (
            added(a, scaled(r * _TAU, b)) for a, b, r in zip(self.a, self.b, rho, strict=True)
        )
        return triple(self.e, one, other)


def contacts(faces: IntArray, points: list[Vector]) -> list[Contact]:
    """All contacts of two quads along an edge."""
    seen: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for face, corners in enumerate(faces.tolist()):
        for k in range(4):
            low, high = sorted((corners[k], corners[(k + 1) % 4]))
            seen.setdefault((low, high), []).append((face, k))
    found = []
    for (x, y), sides in seen.items():
        if len(sides) != 2:
            continue
        ends = [_other_edges(faces[face].tolist(), k, x, points) for face, k in sides]
        found.append(
            Contact(
                faces=(sides[0][0], sides[1][0]),
                e=minus(points[y], points[x]),
                a=(ends[0][0], ends[1][0]),
                b=(ends[0][1], ends[1][1]),
                inverse=(ends[0][2], ends[1][2]),
            )
        )
    return found


def _other_edges(
    corners: list[int], k: int, x: int, points: list[Vector]
) -> tuple[Vector, Vector, bool]:
    """Edges at x and at the other end of side k of a face, and whether x is its corner 1 or 3."""
    one, other = corners[k], corners[(k + 1) % 4]
    before, after = corners[(k - 1) % 4], corners[(k + 2) % 4]
    at_one, at_other = minus(points[before], points[one]), minus(points[after], points[other])
    return (at_one, at_other, k % 2 == 1) if one == x else (at_other, at_one, k % 2 == 0)


def weights(found: list[Contact], count: int) -> list[Any]:
    """Value of rho of each quad, 1 for quad 0, carried along a spanning tree of the quads."""
    rho: dict[int, Any] = {0: sp.Integer(1)}
    while len(rho) < count:
        for contact in found:
            one, other = contact.faces
            if one in rho and other not in rho:
                rho[other] = contact.carried(rho[one])
            elif other in rho and one not in rho:
                rho[one] = _backwards(contact).carried(rho[other])
    return [rho[face] for face in range(count)]


def _backwards(contact: Contact) -> Contact:
    return Contact(
        faces=contact.faces[::-1],
        e=contact.e,
        a=contact.a[::-1],
        b=contact.b[::-1],
        inverse=contact.inverse[::-1],
    )


def _planar_star(sectors: int) -> tuple[IntArray, list[Vector]]:
    """Quads around a vertex with planar stars at it and its neighbours, for any number of sectors.

    The edges e_k are in the plane z = 0; the far vertex of quad k is beta_k e_(k+1) + e_k at the
    height z_k, where det(e_k, f_k, f_(k-1)) = 0 makes the star of neighbour k planar. That leaves
    (-1)^n times the product of the beta_k, which is 1 with one beta of the sign (-1)^n.
    """
    # Directions at half-tangents, counterclockwise, with turns below pi.
    halves = [sp.Rational(n, 10) for n in range(-sectors * 8, sectors * 8, 16)]
    edges = [((1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)) for t in halves]

    def area(i: int, j: int) -> Any:
        (a, b), (c, d) = edges[i % sectors], edges[j % sectors]
        return a * d - b * c

    betas = [sp.Integer(1)] * sectors
    betas[-1] = sp.Integer((-1) ** sectors)
    heights = [sp.Integer(1)]
    for k in range(1, sectors):
        heights.append(-heights[-1] * betas[k] * area(k, k + 1) / area(k - 1, k))
    far = []
    for k in range(sectors):
        (a, b), (c, d) = edges[k], edges[(k + 1) % sectors]
        far.append((a + betas[k] * c, b + betas[k] * d, heights[k]))
    near: list[Vector] = [(x, y, sp.Integer(0)) for x, y in edges]
    centre: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(0))
    return odd_star(sectors), [centre, *near, *far]


def _joined(setting: Setting, faces: IntArray, points: list[Vector], positive: bool) -> Evidence:
    """Evidence that one choice of rho makes all tangent planes agree; positive: and rho > 0."""
    found = contacts(faces, points)
    rho = weights(found, len(faces))
    defects: dict[str, Any] = {
        f"quads {c.faces[0]} and {c.faces[1]}": c.defect(rho[c.faces[0]], rho[c.faces[1]])
        for c in found
    }
    parts = {"tangent planes": identities(setting, defects, shown="", where=[_TAU])}
    if positive:
        parts["positive"] = statement(
            all(bool(r > 0) for r in rho), shown="", witness=f"weights {rho}"
        )
    return combined(parts, shown="")


def hyperboloid_patches(
    setting: Setting, *, sectors: int = 6, lifted: bool = False, first: str = "1"
) -> Evidence:
    """Whether a surface with planar stars and even degrees extends by patches of hyperboloids.

    On surfaces of rational stars of order 2 and 3, and on a star of `sectors` quads with planar
    vertex stars that is no K-surface. lifted: moves vertex 0 off the plane of its neighbours;
    first: factor by which rho of quad 0 is changed after the others were found.
    """
    parts = {}
    for order in (2, 3):
        net = star_net(order)
        points = [tuple(sp.sympify(x) for x in p) for p in surface_points(net)]
        if lifted:
            points[0] = minus(points[0], scaled(sp.Rational(1, 100), net.normals[0]))
        parts[f"star of order {order}"] = _joined(setting, net.complex.faces, points, True)
        if parts[f"star of order {order}"].outcome == "fail":
            break
    faces, points = _planar_star(sectors)
    parts[f"planar stars around {sectors} quads"] = _joined(setting, faces, points, False)
    if first != "1":
        net = star_net(2)
        found = contacts(net.complex.faces, surface_points(net))
        rho = weights(found, len(net.complex.faces))
        rho[0] *= sp.Rational(first)
        parts["changed"] = identities(
            setting, {str(c.faces): c.defect(*(rho[f] for f in c.faces)) for c in found}, shown=""
        )
    return combined(
        parts,
        shown="on rational surfaces of order 2 and 3 one choice of positive weights makes the "
        "tangent planes of neighbouring patches agree along every edge, so the patches join "
        "smoothly; around a vertex the weights close up for an even number of quads",
    )
