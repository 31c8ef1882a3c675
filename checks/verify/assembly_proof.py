"""The proposition on assembly as a whole: gluing to a C^{1,1} graph, explicit lengths."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from math import pi, sin, sqrt
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.verify.amsler_patches import E_1, axis, coefficient
from checks.verify.assembly import (
    HIGH,
    ORDER,
    carried,
    corner_limit,
    frenet_frames_exist,
    glue,
    goursat,
    origin,
    read,
    reduced,
)
from checks.verify.edge_frames import edge_frames
from checks.verify.nets import minus
from checks.verify.patched_sectors import continuous_derivative
from checks.verify.recursion_disk import FloatRow, compared
from theory import sector_series as series
from theory.goursat_angle import goursat_angle
from theory.vectors import Vector, dot, scaled


def smooth_across(
    setting: Setting, *, chart: str = "tangent plane", extra: int = 0, turned: int = 0
) -> Evidence:
    """Derivative of r across a ray, as a graph or in the plane of the star.

    chart: "tangent plane", the surface being a graph there near the corner, its gradient
    (-N_1/N_3, -N_2/N_3), or "star", with a ray of curvature 1; extra: difference of the curvatures
    prescribed on the ray; turned: angle between the first tangents of the two sectors.
    """
    if chart == "star":
        return continuous_derivative(setting, bend=1 + extra)
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        found = carried(sigma)
        residuals[f"r_u - e_u at the corner, sigma = {sigma}"] = minus(
            read(found.position, 1, 0), E_1
        )
        residuals[f"r_v - e_v at the corner, sigma = {sigma}"] = reduced(
            minus(read(found.position, 0, 1), axis(sigma))
        )
    return combined(
        {
            "projection": identities(setting, residuals, shown="invertible"),
            "tangent planes": glue(setting, extra=extra, turned=turned),
        },
        shown="projected to the tangent plane every sector is a diffeomorphism near the corner, "
        "with the star's own derivative there, so that the surface is a graph near 0; r and the "
        "gradient, a function of N, agree on the rays, and on closed sectors they are smooth: the "
        "graph is C^1 with a Lipschitz gradient",
    )


def proposition(
    setting: Setting,
    *,
    extra: int = 0,
    torsion_v: int = 1,
    turned: int = 0,
    straight_angle: bool = False,
) -> Evidence:
    """Parts of (prop:assembly): identities for any curvatures, series for quadratic ones.

    extra: difference of the curvatures on the two sides of a ray; torsion_v: of the odd rays;
    turned: angle left between the first tangents of two sectors on their ray; straight_angle:
    whether the angle pi is admitted.
    """
    steps: dict[str, Callable[[], Evidence]] = {
        "corner": lambda: corner_limit(setting, straight_angle=straight_angle),
        "origin": lambda: origin(setting),
        "frames exist": lambda: frenet_frames_exist(setting),
        "frames on the rays": lambda: edge_frames(setting),
        "gluing to a graph": lambda: smooth_across(setting, extra=extra, turned=turned),
        "sectors": lambda: goursat(setting, torsion_v=torsion_v),
    }
    parts: dict[str, Evidence] = {}
    for name, step in steps.items():
        parts[name] = step()
        if parts[name].outcome == "fail":
            break
    return combined(
        parts,
        shown="identities for arbitrary functions give the frames on the rays, and what makes a "
        "solution exist (Picard's steps, commuting linear equations; the existence itself, its "
        "smoothness and the graph are textbook); for arbitrary angles and quadratic curvatures "
        f"both routes to a sector agree to degree {ORDER}, position and normal on a ray from both "
        f"sides to degree {HIGH}, and |N_u x N_v| -> sin alpha_i > 0",
    )


def _on_ray(field: Any, along: str, shift: tuple[int, int]) -> list[Vector]:
    """Taylor coefficients on a ray of a field, or of its derivative by u or v (shift)."""
    found = []
    for n in range(ORDER):
        i, j = (n, 0) if along == "u" else (0, n)
        factor = (i + 1 if shift[0] else 1) * (j + 1 if shift[1] else 1)
        found.append(scaled(factor, read(field, i + shift[0], j + shift[1])))
    return found


def _products(first: list[Vector], second: list[Vector], n: int) -> Any:
    """Coefficient of t^n of an inner product."""
    return sum((dot(first[k], second[n - k]) for k in range(n + 1)), sp.Integer(0))


def forms_on_rays(setting: Setting, *, sign: int = 1, curved: int = -1) -> Evidence:
    """Three fundamental forms of sectors of either orientation on their rays, to degree ORDER - 1.

    sign: of N_u.r_v = sigma sin theta; curved: the Gauss curvature claimed.
    """
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        found = carried(sigma, order=HIGH)
        sine, cosine = series.sine_and_cosine(found.theta_excess, HIGH)
        for along in ("u", "v"):
            r_u, r_v = (_on_ray(f, along, (0, 0)) for f in (found.r_u, found.r_v))
            n_u, n_v = (_on_ray(found.normal, along, k) for k in ((1, 0), (0, 1)))
            for n in range(ORDER):
                place = (n, 0) if along == "u" else (0, n)
                s, c = (coefficient(p, *place) for p in (sine, cosine))
                unit = int(n == 0)
                residuals[f"{along}-ray, t^{n}, sigma = {sigma}"] = reduced(
                    [
                        _products(r_u, r_u, n) - unit,
                        _products(r_v, r_v, n) - unit,
                        _products(r_u, r_v, n) - c,
                        _products(n_u, r_u, n),
                        _products(n_v, r_v, n),
                        _products(n_u, r_v, n) - sign * sigma * s,
                        _products(n_v, r_u, n) - sign * sigma * s,
                        _products(n_u, n_u, n) - unit,
                        _products(n_v, n_v, n) - unit,
                        _products(n_u, n_v, n) + c,
                    ]
                )
    return combined(
        {
            "forms": identities(setting, residuals, shown="forms"),
            "jump": identities(setting, _jump(curved), shown="jump"),
        },
        shown="on a ray, from both sides: unit speed, third form 1 along it, h(T, T) = 0 and h(T, "
        "N x T) = -1 or +1 by the family; only h(N x T, N x T) jumps, by 2 (cot theta + cot "
        "theta'), which is finite: second derivatives of the graph are bounded",
    )


def _jump(curved: int) -> dict[str, Any]:
    """Second form in the frame of the ray from its values on T and on a line at +theta, -theta."""
    theta, other, b = sp.symbols("theta theta_2 b", positive=True)
    values = []
    for angle in (other, -theta):
        d = sp.Symbol("d")
        form = 2 * b * sp.cos(angle) * sp.sin(angle) + d * sp.sin(angle) ** 2
        values.append(sp.solve(form, d)[0])
    return {
        "jump": values[0] - values[1] + 2 * b * (sp.cot(theta) + sp.cot(other)),
        "determinant of the second form for b = 1": sp.Matrix([[0, 1], [1, values[0]]]).det()
        - curved,
    }


def lengths(setting: Setting, *, share: str = "1", rise: str = "1") -> Evidence:
    """Largest and least angle on squares of the explicit length of an assembly.

    With |kappa| <= M on both edges |theta - alpha| <= M (u + v) + u v, so that the length l with
    2 M l + l^2 = min(alpha, pi - alpha) keeps theta in (0, pi). share: of that minimum; rise:
    factor of the bound.
    """
    del setting

    def rows() -> Iterator[FloatRow]:
        for alpha in (0.3, 1.0, pi / 2, 2.0, 2.8):
            side = sqrt(float(Fraction(share)) * min(alpha, pi - alpha))
            theta = goursat_angle(alpha, 0.0, 0.0, side, steps=40)
            # sin is concave, so at least its lesser value at the ends, where the rise is positive.
            floor = side**2 * min(sin(alpha), sin(alpha + side**2))
            place = f"alpha = {alpha:.4g}, straight edges, l = {side:.4g}"
            yield f"least rise, {place}", floor, float(theta[-1, -1]) - alpha
            for bound in (0.05, 0.5, 2.0, 8.0):
                room = float(Fraction(share)) * min(alpha, pi - alpha)
                length = sqrt(bound**2 + room) - bound
                for sign_u in (-bound, 0.0, bound):
                    for sign_v in (-bound, bound):
                        theta = goursat_angle(alpha, sign_u, sign_v, length, steps=40)
                        place = f"alpha = {alpha:.4g}, rates {sign_u}, {sign_v}, l = {length:.4g}"
                        limit = float(Fraction(rise)) * (2 * bound * length + length**2)
                        yield f"|theta - alpha|, {place}", float(abs(theta - alpha).max()), limit
                        yield f"theta, {place}", float(theta.max()), pi
                        yield f"-theta, {place}", -float(theta.min()), 0.0

    return compared(
        rows(),
        shown="with |kappa_i| <= M the sector is regular on the square of side l, 2 M l + l^2 = "
        "min(alpha, pi - alpha), as |theta_uv| <= 1 (by hand); seen for five angles, four "
        "bounds and extreme constant curvatures; between straight edges theta rises at the far "
        "corner by no less than l^2 times the least sine",
    )
