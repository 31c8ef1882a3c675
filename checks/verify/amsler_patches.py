"""Boundary data of an Amsler sector, its Goursat problem, and the front that it determines.

By a rotation of space n = e_3; e_u, e_v at arbitrary angles. Taylor coefficients come from two
computations that share no code: the angle and a carried frame (theory.sector_series), and the
vector Moutard equation with Frenet data on both axes (theory.moutard, theory.bent_curves).
"""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import amsler_patches as printed
from checks.printed import asymptotic_frames as frames
from checks.verify.nets import minus, system_defects
from theory import sector_series as series
from theory.bent_curves import binormals, lelieuvre_series
from theory.moutard import Series, goursat_series
from theory.vectors import Vector, added, cross, derivative, dot, scaled

T = sp.Symbol("t", real=True)
A, B = sp.symbols("a b", real=True)
E_U: Vector = (sp.cos(A), sp.sin(A), sp.Integer(0))
E_V: Vector = (sp.cos(B), sp.sin(B), sp.Integer(0))
N_0 = printed.E_3
Z: Vector = sp.symbols("z_1 z_2 z_3", real=True)
ORDER = 5


def axis(sigma: int) -> Vector:
    """Direction e_v where e_u = e_1 and the corner has the cosine C and the sine S."""
    return (series.C, sigma * series.S, sp.Integer(0))


E_1: Vector = (sp.Integer(1), sp.Integer(0), sp.Integer(0))


def coefficient(p: Any, i: int, j: int) -> Any:
    """Coefficient of u^i v^j of a series of theory.sector_series, as an expression."""
    ring = p.ring
    terms = {(0, 0, *m[2:]): c for m, c in p.terms() if m[:2] == (i, j)}
    return ring.from_dict(terms).as_expr()


def on_sphere(expr: Any) -> Any:
    """Expression reduced by C^2 + S^2 = 1."""
    return sp.rem(sp.expand(expr), series.S**2 + series.C**2 - 1, series.S)


def _taylor(a: Vector, n: int) -> Vector:
    """Coefficient of t^n of a vector field."""
    x, y, z = (sp.diff(entry, T, n).subs(T, 0) / sp.factorial(n) for entry in a)
    return (x, y, z)


def boundary_normals(
    setting: Setting, *, sign_u: int = 1, sign_v: int = -1, rate: int = 1
) -> Evidence:
    """Both lines of (amsler-frame): unit-speed turns about e_u and e_v, and the carried frame."""
    on_u = printed.normal_on_u(T, N_0, E_U, sign=sign_u, rate=rate)
    on_v = printed.normal_on_v(T, N_0, E_V, sign=sign_v, rate=rate)
    residuals: dict[str, Any] = {
        "N_u - N x e_u": minus(derivative(on_u, T), cross(on_u, E_U)),
        "N_v + N x e_v": added(derivative(on_v, T), cross(on_v, E_V)),
        "N(0, 0) - n": minus(_taylor(on_u, 0), N_0),
        "N(0, 0) - n on the other line": minus(_taylor(on_v, 0), N_0),
    }
    for sigma in (1, -1):
        found = series.sector_series(sigma=sigma, on_u=(), on_v=(), order=ORDER)
        edges = (
            (printed.normal_on_u(T, N_0, E_1, sign=sign_u, rate=rate), "u"),
            (printed.normal_on_v(T, N_0, axis(sigma), sign=sign_v, rate=rate), "v"),
        )
        for edge, along in edges:
            for n in range(ORDER + 1):
                place = (n, 0) if along == "u" else (0, n)
                residuals[f"coefficient of {along}^{n}, sigma = {sigma}"] = [
                    on_sphere(coefficient(p, *place) - q)
                    for p, q in zip(found.normal, _taylor(edge, n), strict=True)
                ]
    return identities(
        setting,
        residuals,
        shown="along a straight line of tangent e the normal of torsion -1 obeys N' = N x e, that "
        "of torsion +1 N' = -N x e: linear equations that the printed N solve, and the frame "
        f"carried into a sector of constant angle on its edges agrees to degree {ORDER}",
    )


def boundary_lines(
    setting: Setting, *, argument: str = "first", sign_v: int = -1, direction: int = 1
) -> Evidence:
    """Third line of (amsler-frame) against the Lelieuvre formulae integrated from the normals."""
    on_u = printed.normal_on_u(T, N_0, E_U)
    on_v = printed.normal_on_v(T, N_0, E_V)
    rate_u = cross(derivative(on_u, T), on_u)
    rate_v = scaled(sign_v, cross(derivative(on_v, T), on_v))
    place = printed.second_line_place(sp.Symbol("v", positive=True), argument=argument)
    v = sp.Symbol("v", positive=True)

    def position(u: Any, w: Any) -> Vector:
        along = rate_u if w == 0 else rate_v
        length = u if w == 0 else w
        x, y, z = (sp.integrate(sp.trigsimp(sp.expand(e)), (T, 0, length)) for e in along)
        return added(Z, (x, y, z))

    return identities(
        setting,
        {
            "r(u, 0) - z - u e_u": minus(position(v, sp.Integer(0)), printed.line(v, Z, E_U)),
            "second formula": minus(position(*place), printed.line(v, Z, E_V, sign=direction)),
        },
        shown="integrating r_u = N_u x N and r_v = -N_v x N along the edges gives the straight "
        "lines z + u e_u on v = 0 and z + v e_v on u = 0",
    )


def solves_u(setting: Setting, *, torsion: int = -1, back: int = 1, kappa: int = 0) -> Evidence:
    """Data on v = 0 in the first system of (eq:frames), with kappa^u = 0."""
    normal = printed.normal_on_u(T, N_0, E_U)
    return _solves(setting, normal, E_U, frames.frenet_u(kappa, torsion=torsion, back=back), "u")


def solves_v(setting: Setting, *, torsion: int = 1, back: int = -1, kappa: int = 0) -> Evidence:
    """Data on u = 0 in the second system of (eq:frames), with kappa^v = 0."""
    normal = printed.normal_on_v(T, N_0, E_V)
    return _solves(setting, normal, E_V, frames.frenet_v(kappa, torsion=torsion, back=back), "v")


def _solves(setting: Setting, normal: Vector, e: Vector, matrix: Any, along: str) -> Evidence:
    tangent = derivative(printed.line(T, Z, e), T)
    frame = frames.frame(tangent, normal, cross)
    defects = system_defects([derivative(a, T) for a in frame], matrix, frame)
    return identities(
        setting,
        defects,
        shown=f"the frame of the printed data on the {along}-line solves its system with curvature "
        "0, row by row",
    )


def sphere_identities(sign: int) -> dict[str, Any]:
    """Consequences of N_uv = sign (N_u.N_v) N for N.N and the speeds, N not assumed unit."""
    u, v = series.U, series.V
    x, y, z = (sp.Function(name)(u, v) for name in ("n_1", "n_2", "n_3"))
    normal: Vector = (x, y, z)
    n_u, n_v = derivative(normal, u), derivative(normal, v)
    product = dot(n_u, n_v)
    rule = {sp.diff(e, u, v): sign * product * e for e in normal}
    excess = dot(normal, normal) - 1
    return {
        "(N.N - 1)_uv + 2 (N_u.N_v)(N.N - 1)": sp.diff(excess, u, v).subs(rule)
        + 2 * product * excess,
        "(N_u.N_u)_v + (N_u.N_v)(N.N - 1)_u": sp.diff(dot(n_u, n_u), v).subs(rule)
        + product * sp.diff(excess, u),
        "(N_v.N_v)_u + (N_u.N_v)(N.N - 1)_v": sp.diff(dot(n_v, n_v), u).subs(rule)
        + product * sp.diff(excess, v),
    }


def _picard() -> dict[str, Any]:
    """Step of Picard's iteration for theta_uv = sin theta on the bound (u v)^n/n!^2."""
    u, v, s, t = sp.symbols("u v s t", positive=True)
    n = sp.Symbol("n", positive=True, integer=True)
    inner = sp.integrate(s**n, (s, 0, u)) * sp.integrate(t**n, (t, 0, v)) / sp.factorial(n) ** 2
    bound = (u * v) ** (n + 1) / sp.factorial(n + 1) ** 2
    ratio = sp.simplify(sp.gammasimp(sp.combsimp(sp.expand_power_base(inner / bound))))
    return {"integral of the bound over the next bound, minus 1": ratio - 1}


def _zero_curvature() -> dict[str, Any]:
    """Mixed derivatives of the frame carried by theta: they commute if theta_uv = sin theta."""
    u, v = series.U, series.V
    theta = sp.Function("theta")(u, v)
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        kappa = -sigma * sp.diff(theta, u)
        tilt, cosine = sigma * sp.sin(theta), sp.cos(theta)
        a = sp.Matrix([[0, kappa, 0], [-kappa, 0, -1], [0, 1, 0]])
        b = sp.Matrix([[0, 0, -tilt], [0, 0, cosine], [tilt, -cosine, 0]])
        defect = sp.diff(a, v) - sp.diff(b, u) + a * b - b * a
        residuals[f"compatibility of the frame, sigma = {sigma}"] = list(
            defect.subs(sp.diff(theta, u, v), sp.sin(theta))
        )
    return residuals


def existence_identities() -> dict[str, Any]:
    """Identities behind the existence of a sector: Picard's step, compatibility of the frame."""
    return _picard() | _zero_curvature()


def straight_sector(
    sigma: int, *, order: int = ORDER, torsion_v: int = 1
) -> tuple[series.SectorSeries, Series]:
    """Series of an Amsler sector by its angle, and of its normal by the Moutard equation."""
    first = series.sector_series(sigma=sigma, on_u=(), on_v=(), order=order)
    second = goursat_series(
        binormals(E_1, N_0, (), -1, order=order),
        binormals(axis(sigma), N_0, (), torsion_v, order=order),
        degree=order,
    )
    return first, second


def goursat(setting: Setting, *, sign: int = -1, torsion_v: int = 1) -> Evidence:
    """Goursat problem of the Moutard equation: existence on the quadrant, values on the sphere."""
    residuals = sphere_identities(sign) | existence_identities()
    for sigma in (1, -1):
        first, second = straight_sector(sigma, torsion_v=torsion_v)
        for (i, j), vector in second.items():
            if i + j <= ORDER:
                residuals[f"two series, u^{i} v^{j}, sigma = {sigma}"] = [
                    on_sphere(coefficient(p, i, j) - q)
                    for p, q in zip(first.normal, vector, strict=True)
                ]
    return identities(
        setting,
        residuals,
        shown="theta_uv = sin theta is solved on the whole quadrant by Picard's iteration, whose "
        "n-th step is at most (u v)^n/n!^2; the frame is carried by linear equations that commute "
        "(textbook: linear equations, smooth dependence), so N exists there, smooth with its "
        "smooth data up to the edges. For any solution N.N - 1 obeys a linear Goursat problem with "
        "data 0, hence N.N = N_u.N_u = N_v.N_v = 1; the series of both routes agree to degree "
        f"{ORDER}",
    )


def goursat_boundary(
    setting: Setting, *, sign_u: int = 1, sign_v: int = -1, corner: int = 0
) -> Evidence:
    """Solution carried into the sector on its edges against the data; corner: (u, v) at n."""
    residuals: dict[str, Any] = {
        "data at the corner": minus(
            printed.normal_on_u(sp.Integer(corner), N_0, E_U, sign=sign_u),
            printed.normal_on_v(sp.Integer(0), N_0, E_V, sign=sign_v),
        )
    }
    for sigma in (1, -1):
        first = series.sector_series(sigma=sigma, on_u=(), on_v=(), order=ORDER + 1)
        for n in range(ORDER + 2):
            on_u = _taylor(printed.normal_on_u(T, N_0, E_1, sign=sign_u), n)
            on_v = _taylor(printed.normal_on_v(T, N_0, axis(sigma), sign=sign_v), n)
            for along, edge, place in (("u", on_u, (n, 0)), ("v", on_v, (0, n))):
                residuals[f"{along}^{n}, sigma = {sigma}"] = [
                    on_sphere(coefficient(p, *place) - q)
                    for p, q in zip(first.normal, edge, strict=True)
                ]
    return identities(
        setting,
        residuals,
        shown="the data agree at the corner, and the normal carried along v-lines from v = 0 takes "
        f"the printed values on both edges, to degree {ORDER + 1}",
    )


def front(setting: Setting, *, sign_v: int = -1, moutard: int = -1) -> Evidence:
    """Lelieuvre equations for weakly harmonic N: closed, normal N, curvature -1; both parities."""
    residuals = dict(_harmonic_identities(sign_v, moutard))
    for sigma in (1, -1):
        _, normal = straight_sector(sigma)
        r_u, r_v = lelieuvre_series(normal, ORDER - 1)
        for i in range(ORDER - 2):
            for j in range(ORDER - 2 - i):
                mixed = scaled(j + 1, r_u[i, j + 1])
                other = scaled(-sign_v * (i + 1), r_v[i + 1, j])
                residuals[f"r_uv - r_vu, u^{i} v^{j}, sigma = {sigma}"] = [
                    on_sphere(e) for e in minus(mixed, other)
                ]
        start = minus(r_v[0, 0], axis(sigma))
        residuals[f"r_v(0, 0) - e_v, sigma = {sigma}"] = [on_sphere(e) for e in start]
    return identities(
        setting,
        residuals,
        shown="N x N_uv = 0 makes r_u du + r_v dv closed; r_u and r_v are unit vectors normal to N "
        "with r_u x r_v = -N_u x N_v, so that K = -1; the series of both orientations are closed "
        "and leave the origin along e_u, e_v",
    )


def _harmonic_identities(sign_v: int, moutard: int) -> dict[str, Any]:
    """Pointwise identities for N = e_3, arbitrary tangent N_u, N_v and N_uv = -(N_u.N_v) N."""
    p, q, x, y = sp.symbols("p q x y", real=True)
    n_u: Vector = (p, q, sp.Integer(0))
    n_v: Vector = (x, y, sp.Integer(0))
    n_uv = scaled(moutard * dot(n_u, n_v), N_0)
    r_u, r_v = frames.lelieuvre_u(n_u, N_0, cross), frames.lelieuvre_v(n_v, N_0, cross, sign=sign_v)
    r_uv = added(cross(n_uv, N_0), cross(n_u, n_v))
    r_vu = scaled(sign_v, added(cross(n_uv, N_0), cross(n_v, n_u)))
    second = added(scaled(dot(n_u, n_v), N_0), n_uv)
    return {
        "N.N_u stays 0": second,
        "r_uv - r_vu": minus(r_uv, r_vu),
        "r_u.N, r_v.N": [dot(r_u, N_0), dot(r_v, N_0)],
        "speeds": [dot(r_u, r_u) - dot(n_u, n_u), dot(r_v, r_v) - dot(n_v, n_v)],
        "r_u x r_v + N_u x N_v": added(cross(r_u, r_v), cross(n_u, n_v)),
    }


def extends(setting: Setting, *, sign: int = -1, stretched: int = 1) -> Evidence:
    """Speeds of the front up to the edges of a sector; stretched: speed of N_u claimed."""
    n_u: Vector = (sp.cos(A), sp.sin(A), sp.Integer(0))
    r_u = frames.lelieuvre_u(scaled(stretched, n_u), N_0, cross)
    return combined(
        {
            "sphere and speeds": identities(setting, sphere_identities(sign), shown="kept"),
            "existence": identities(setting, existence_identities(), shown="exists"),
            "speed of the front": identities(
                setting, {"r_u.r_u - 1": dot(r_u, r_u) - 1}, shown="unit"
            ),
        },
        shown="N_u, N_v and so r_u, r_v are unit vectors throughout: r is Lipschitz and extends "
        "continuously to the edges; solutions exist on the closed quadrant and are smooth with "
        "their smooth data (textbook: Goursat problem, linear equations), so r is smooth inside",
    )
