"""Sectors between curves of arbitrary curvature, as series: frames, normals, gluing, regularity.

Curvatures are quadratic Taylor polynomials with symbols as coefficients, angles symbols. Route
one: the angle and a frame carried along v-lines (theory.sector_series). Route two: Frenet-Serret
on both edges, the vector Moutard equation, the Lelieuvre formulae (theory.bent_curves).
"""

from collections.abc import Sequence
from functools import cache
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.positivity import positivity
from checks.printed import amsler_patches as straight
from checks.printed import assembly as printed
from checks.printed import asymptotic_frames as frames
from checks.verify.amsler_patches import (
    E_1,
    axis,
    coefficient,
    existence_identities,
    on_sphere,
    sphere_identities,
)
from checks.verify.m_stars import ALPHA, ray
from checks.verify.nets import minus
from theory import sector_series as series
from theory.bent_curves import binormals, frame_coefficients, lelieuvre_series, position_series
from theory.moutard import goursat_series
from theory.vectors import Vector, added, cross, dot, scaled

K, H = series.K[:3], series.H[:3]
C, S = series.C, series.S
E_3 = printed.E_3
ORDER = 5
#: Degree to which the edges of a sector are compared.
HIGH = 6
#: Degree of sectors with rational data, and the data: cos alpha, sin alpha, curvatures.
DEGREE = 8
_COSINE, _SINE = sp.Rational(3, 5), sp.Rational(4, 5)
_BENT_U = (sp.Integer(1), sp.Rational(-1, 2), sp.Rational(2, 3))
_BENT_V = (sp.Rational(-3, 4), sp.Rational(1, 3), sp.Rational(1, 5))
Triples = dict[tuple[int, int], Vector]


@cache
def carried(
    sigma: int, on_u: tuple[Any, ...] = K, on_v: tuple[Any, ...] = H, order: int = ORDER
) -> Any:
    """Sector by its angle and a carried frame."""
    return series.sector_series(sigma=sigma, on_u=on_u, on_v=on_v, order=order)


def read(field: Sequence[Any], i: int, j: int) -> Vector:
    """Coefficient of u^i v^j of a triple of series."""
    x, y, z = (coefficient(p, i, j) for p in field)
    return (x, y, z)


def reduced(a: Sequence[Any]) -> list[Any]:
    """Entries reduced by C^2 + S^2 = 1."""
    return [on_sphere(e) for e in a]


def frenet_frames_exist(
    setting: Setting, *, torsion: int = -1, back: int = 1, orthonormal: bool = True
) -> Evidence:
    """Systems of (eq:frames) with an unknown curvature: skew, and the Picard bounds.

    orthonormal: whether the frame starts as one, else its first vector is doubled.
    """
    kappa = sp.Function("kappa")(sp.Symbol("t", real=True))
    residuals: dict[str, Any] = {}
    for name, matrix in (
        ("u", sp.Matrix(frames.frenet_u(kappa, torsion=torsion, back=back))),
        ("v", sp.Matrix(frames.frenet_v(kappa, torsion=-torsion, back=-back))),
    ):
        residuals[f"A + A^T, {name}"] = list(matrix + matrix.T)
    start = E_1 if orthonormal else scaled(2, E_1)
    rows = frame_coefficients(start, E_3, K, -1, order=ORDER)
    for n in range(ORDER + 1):
        for a in range(3):
            for b in range(a, 3):
                product = sum(dot(rows[k][a], rows[n - k][b]) for k in range(n + 1))
                residuals[f"product {a}{b}, t^{n}"] = product - int(a == b and n == 0)
    s, t, bound = sp.symbols("s t M", positive=True)
    n_any = sp.Symbol("n", positive=True, integer=True)
    step = bound * sp.integrate((bound * s) ** n_any / sp.factorial(n_any), (s, 0, t))
    claimed = (bound * t) ** (n_any + 1) / sp.factorial(n_any + 1)
    residuals["step of Picard's iteration, over the next bound, - 1"] = (
        sp.simplify(sp.combsimp(sp.expand_power_base(step / claimed))) - 1
    )
    return identities(
        setting,
        residuals,
        shown="F' = A F is linear: Picard's steps are at most (M t)^n/n! where |A| <= M, so that F "
        "exists and is unique on every [0, l], l < L (textbook); A + A^T = 0, so F F^T stays 1; "
        f"seen to degree {ORDER} for an arbitrary quadratic curvature",
    )


def assembly_frames(
    setting: Setting, *, torsion_v: int = 1, curvature_sign: int = 1, start: int = 1
) -> Evidence:
    """Frames of the surface on both edges of a sector against (eq:frames) and their start.

    On u = 0 those of the frame carried along v-lines, on v = 0 those of the Moutard normal. start:
    sign of the normal there.
    """
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        found = carried(sigma, order=HIGH)
        tangents = [read(found.r_v, 0, n) for n in range(HIGH + 1)]
        normals = [read(found.normal, 0, n) for n in range(HIGH + 1)]
        matrix = frames.frenet_v(sp.Symbol("kappa"), torsion=torsion_v, back=-torsion_v)
        residuals |= _frame_defects(
            f"v, sigma = {sigma}", tangents, normals, matrix, H, curvature_sign
        )
        tangent, normal = printed.initial_frame(axis(sigma), sign=start)
        residuals[f"r_v(0), sigma = {sigma}"] = reduced(minus(tangents[0], tangent))
        residuals[f"N(0), sigma = {sigma}"] = minus(normals[0], normal)
        moutard = moutard_normal(sigma, K[:2], H[:2], ORDER - 1)
        r_u, _ = lelieuvre_series(moutard, ORDER - 2)
        tangents = [r_u[n, 0] for n in range(ORDER - 1)]
        normals = [moutard[n, 0] for n in range(ORDER - 1)]
        matrix = frames.frenet_u(sp.Symbol("kappa"))
        residuals |= _frame_defects(
            f"u, sigma = {sigma}", tangents, normals, matrix, K[:2], curvature_sign
        )
        residuals[f"r_u(0), sigma = {sigma}"] = minus(
            tangents[0], printed.initial_frame(E_1, sign=start)[0]
        )
    return identities(
        setting,
        residuals,
        shown="on both edges of sectors of either orientation the frame of the surface solves its "
        "system of (eq:frames) with the given curvature, from s_i and e_3; to degree "
        f"{HIGH - 1} on v-edges and {ORDER - 2} on u-edges, angle and coefficients arbitrary",
    )


def _frame_defects(
    name: str,
    tangents: list[Vector],
    normals: list[Vector],
    matrix: Any,
    moduli: tuple[Any, ...],
    sign: int,
) -> dict[str, Any]:
    """Coefficients of d(frame) - A frame, frame = (T, N x T, N)."""
    sides = []
    for n in range(len(tangents)):
        total: Vector = (sp.Integer(0),) * 3
        for k in range(n + 1):
            total = added(total, cross(normals[k], tangents[n - k]))
        sides.append(total)
    rows = (tangents, sides, normals)
    kappa = sp.Symbol("kappa")
    found: dict[str, Any] = {}
    for n in range(len(tangents) - 1):
        for a in range(3):
            stated: Vector = (sp.Integer(0),) * 3
            for b in range(3):
                entry = sp.sympify(matrix[a][b])
                constant, slope = entry.subs(kappa, 0), sp.diff(entry, kappa)
                stated = added(stated, scaled(constant, rows[b][n]))
                for k, modulus in enumerate(moduli[: n + 1]):
                    stated = added(stated, scaled(sign * slope * modulus, rows[b][n - k]))
            derived = scaled(n + 1, rows[a][n + 1])
            found[f"{name}, row {a + 1}, t^{n}"] = reduced(minus(derived, stated))
    return found


@cache
def moutard_normal(
    sigma: int, on_u: tuple[Any, ...], on_v: tuple[Any, ...], order: int, torsion_v: int = 1
) -> Any:
    """Normal of a sector by Frenet-Serret on both edges and the vector Moutard equation."""
    return goursat_series(
        binormals(E_1, E_3, on_u, -1, order=order),
        binormals(axis(sigma), E_3, on_v, torsion_v, order=order),
        degree=order,
    )


def boundary_normal(setting: Setting, *, torsion_v: int = 1, other: bool = False) -> Evidence:
    """Normal on both edges of a sector against the binormals of its two curves alone.

    other: whether the curvatures of the two edges are exchanged.
    """
    residuals: dict[str, Any] = {}
    on_u, on_v = (H, K) if other else (K, H)
    for sigma in (1, -1):
        found = carried(sigma, order=HIGH)
        first = binormals(E_1, E_3, on_u, -1, order=HIGH)
        second = binormals(axis(sigma), E_3, on_v, torsion_v, order=HIGH)
        for n in range(HIGH + 1):
            residuals[f"N on v = 0, u^{n}, sigma = {sigma}"] = reduced(
                minus(read(found.normal, n, 0), first[n])
            )
            residuals[f"N on u = 0, v^{n}, sigma = {sigma}"] = reduced(
                minus(read(found.normal, 0, n), second[n])
            )
    return identities(
        setting,
        residuals,
        shown="on each edge N is the binormal of that edge's curve, whatever the other edge; to "
        f"degree {HIGH}",
    )


def goursat(setting: Setting, *, sign: int = -1, torsion_v: int = 1) -> Evidence:
    """Normal and position of a sector by both routes, and what holds for every solution."""
    residuals = sphere_identities(sign) | existence_identities()
    # A wrong sign or torsion shows at degree 2, at a tenth of the cost of the whole.
    low = identities(setting, residuals | _rational_sector(1, torsion_v, 2), shown="low degrees")
    if low.outcome == "fail":
        return low
    residuals = {}
    for sigma in (1, -1):
        residuals |= _two_routes(sigma, torsion_v)
        residuals |= _rational_sector(sigma, torsion_v, DEGREE)
    return combined(
        {
            "any solution, low degrees": low,
            "two routes": identities(setting, residuals, shown="two routes"),
        },
        shown="with arbitrary smooth data theta_uv = sin theta has a solution on the rectangle, by "
        "Picard's iteration with steps (u v)^n/n!^2, and the frame follows from linear equations "
        "that commute (textbook); every solution stays on the sphere with the speeds of its data; "
        f"N to degree {ORDER} and r to degree {ORDER + 1} agree with the vector Moutard equation "
        "and the Lelieuvre formulae, angle and six coefficients of the curvatures arbitrary, and "
        f"to degree {DEGREE} for a rational angle and curvatures",
    )


def _two_routes(sigma: int, torsion_v: int) -> dict[str, Any]:
    found = carried(sigma)
    normal = moutard_normal(sigma, K, H, ORDER + 1, torsion_v)
    position = position_series(lelieuvre_series(normal, ORDER))
    residuals: dict[str, Any] = {}
    for i in range(ORDER + 2):
        for j in range(ORDER + 2 - i):
            if i + j <= ORDER:
                residuals[f"N, u^{i} v^{j}, sigma = {sigma}"] = reduced(
                    minus(read(found.normal, i, j), normal[i, j])
                )
            residuals[f"r, u^{i} v^{j}, sigma = {sigma}"] = reduced(
                minus(read(found.position, i, j), position[i, j])
            )
    return residuals


def _rational_sector(sigma: int, torsion_v: int, degree: int) -> dict[str, Any]:
    """Both routes to the normal of a sector with rational data, to this degree."""
    found = series.sector_series(sigma=sigma, on_u=_BENT_U, on_v=_BENT_V, order=degree)
    e_v: Vector = (_COSINE, sigma * _SINE, sp.Integer(0))
    normal = goursat_series(
        binormals(E_1, E_3, _BENT_U, -1, order=degree),
        binormals(e_v, E_3, _BENT_V, torsion_v, order=degree),
        degree=degree,
    )
    residuals: dict[str, Any] = {}
    for i in range(degree + 1):
        for j in range(degree + 1 - i):
            value = read(found.normal, i, j)
            residuals[f"N of the rational sector, u^{i} v^{j}, sigma = {sigma}"] = [
                sp.sympify(a).subs({C: _COSINE, S: _SINE}) - b
                for a, b in zip(value, normal[i, j], strict=True)
            ]
    return residuals


def _turned(a: Vector, sigma: int) -> Vector:
    """Components of a vector along e_v, e_3 x e_v, e_3."""
    return (C * a[0] + sigma * S * a[1], -sigma * S * a[0] + C * a[1], a[2])


def ray_values(along: str, sigma: int, *, extra: int = 0, torsion: int = 0) -> dict[str, Vector]:
    """N and r on an edge of a sector, in the frame of its tangent at the corner.

    extra: added to the curvature of that edge; torsion: 0 for that of the edge, else of a curve
    in its place.
    """
    moduli = K if along == "u" else H
    bent = (moduli[0] + extra, *moduli[1:])
    found = carried(sigma, *((bent, H) if along == "u" else (K, bent)), order=HIGH)
    values: dict[str, Vector] = {}
    for n in range(HIGH + 1):
        place = (n, 0) if along == "u" else (0, n)
        for name, field in (("N", found.normal), ("r", found.position)):
            value = read(field, *place)
            values[f"{name}, t^{n}"] = value if along == "u" else _turned(value, sigma)
    if torsion:
        for n, normal in enumerate(binormals(E_1, E_3, bent, torsion, order=HIGH)):
            values[f"N, t^{n}"] = normal
    return values


def glue(setting: Setting, *, extra: int = 0, torsion: int = 0, turned: int = 0) -> Evidence:
    """N and r on a ray from both sectors, the second with other angle and other outer edge.

    extra: difference of the two curvatures prescribed on the ray; torsion: that of a curve which
    takes the ray's place in the second sector; turned: angle between the two first tangents.
    """
    residuals: dict[str, Any] = {}
    for along in ("u", "v"):
        first, second = (1, -1) if along == "v" else (-1, 1)
        here = ray_values(along, first)
        there = ray_values(along, second, extra=extra, torsion=torsion)
        others = {C: sp.Symbol("c_2"), S: sp.Symbol("s_2")}
        others |= {m: sp.Symbol(f"{m}_2") for m in (K if along == "v" else H)}
        for name, value in here.items():
            other = tuple(sp.sympify(on_sphere(e)).subs(others) for e in there[name])
            other = (
                sp.cos(turned) * other[0] - sp.sin(turned) * other[1],
                sp.sin(turned) * other[0] + sp.cos(turned) * other[1],
                other[2],
            )
            residuals[f"{name} on a {along}-ray"] = [
                on_sphere(a) - b for a, b in zip(value, other, strict=True)
            ]
    return identities(
        setting,
        residuals,
        shown="on a u- and on a v-ray, N and r have the same series from both sides, to degree "
        f"{HIGH}, whatever the angles and the other edges of the two sectors",
    )


def corner_limit(
    setting: Setting, *, ahead: int = 0, power: int = 1, straight_angle: bool = False
) -> Evidence:
    """Norm of N_u x N_v at the corner of sectors of either orientation, squared; its sign.

    ahead: shift of the second index; straight_angle: whether the angle pi is admitted.
    """
    residuals: dict[str, Any] = {}
    for i, sigma in ((1, 1), (2, -1)):
        found = carried(sigma)
        product = cross(read(found.normal, 1, 0), read(found.normal, 0, 1))
        place = {C: sp.cos(ALPHA[i]), S: sp.sin(ALPHA[i])}
        norm = sp.sympify(dot(product, product)).subs(place)
        value = printed.corner_norm(i, ray, ahead=ahead)
        residuals[f"|N_u x N_v|^2 on S_{i}"] = norm - value ** (2 * power)
        residuals[f"s*_(i-1).s_i - sin alpha_i, i = {i}"] = printed.corner_norm(i, ray) - sp.sin(
            ALPHA[i]
        )
    t = sp.Symbol("t", positive=True)
    angle = sp.pi if straight_angle else 2 * sp.atan(t)
    return combined(
        {
            "norm": identities(setting, residuals, shown="norm"),
            "sign": positivity(
                setting, {"sin alpha": sp.expand_trig(sp.sin(angle))}, shown="positive"
            ),
        },
        shown="N_u, N_v are continuous up to the corner, where |N_u x N_v| = |s*_(i-1).s_i| = sin "
        "alpha_i, 2t/(1 + t^2) > 0 with t = tan(alpha_i/2), whatever the curvatures",
    )


def origin(setting: Setting, *, degree: int = 0, sign: int = 1) -> Evidence:
    """Position and normal at the corner of sectors of either orientation."""
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        found = carried(sigma)
        residuals[f"r, sigma = {sigma}"] = read(found.position, degree, 0)
        residuals[f"N - e_3, sigma = {sigma}"] = minus(
            read(found.normal, degree, 0), scaled(sign, E_3)
        )
    return identities(setting, residuals, shown="r(0, 0) = 0 and N(0, 0) = e_3 in every sector")


def generalises(setting: Setting, *, bend: int = 0, sign_v: int = -1) -> Evidence:
    """Boundary normals for curvatures 0 (bend) against (amsler-frame), as series."""
    t = sp.Symbol("t", real=True)
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        on_u = straight.normal_on_u(t, E_3, E_1)
        on_v = straight.normal_on_v(t, E_3, axis(sigma), sign=sign_v)
        found = carried(sigma, (bend,), (bend,), HIGH)
        for n in range(HIGH + 1):
            for along, edge, place in (("u", on_u, (n, 0)), ("v", on_v, (0, n))):
                stated = [sp.diff(e, t, n).subs(t, 0) / sp.factorial(n) for e in edge]
                value = read(found.normal, *place)
                residuals[f"N on {along}, t^{n}, sigma = {sigma}"] = [
                    on_sphere(a - b) for a, b in zip(value, stated, strict=True)
                ]
    return identities(
        setting,
        residuals,
        shown="for curvatures 0 the frames of an assembly carry the normals of (amsler-frame) and "
        "the sectors are those between straight lines",
    )
