"""The proposition on assembly as a whole: gluing to a C^{1,1} graph, explicit lengths."""

from collections.abc import Iterator
from fractions import Fraction
from math import pi, sqrt
from typing import Any

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.verify.amsler_patches import E_1, axis
from checks.verify.assembly import (
    HIGH,
    ORDER,
    assembly_frames,
    carried,
    corner_limit,
    frenet_frames_exist,
    glue,
    goursat,
    origin,
    read,
    reduced,
)
from checks.verify.nets import minus
from checks.verify.patched_sectors import continuous_derivative
from checks.verify.recursion_disk import FloatRow, compared
from theory.goursat_angle import goursat_angle


def smooth_across(setting: Setting, *, chart: str = "star", extra: int = 0) -> Evidence:
    """Derivative of r across a ray of curvature 1, in the plane of the star or as a graph.

    chart: "star" or "tangent plane", the surface being a graph there near the corner, its gradient
    (-N_1/N_3, -N_2/N_3); extra: difference of the curvatures prescribed on the ray.
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
            "tangent planes": glue(setting, extra=extra),
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
    """All parts of (prop:assembly) for arbitrary angles and quadratic curvatures, as series.

    extra: difference of the curvatures on the two sides of a ray; torsion_v: of the odd rays;
    turned: angle left between the first tangents of two sectors on their ray; straight_angle:
    whether the angle pi is admitted.
    """
    return combined(
        {
            "frames exist": frenet_frames_exist(setting),
            "origin": origin(setting),
            "sectors": goursat(setting, torsion_v=torsion_v),
            "frames on the rays": assembly_frames(setting),
            "gluing": glue(setting, extra=extra, turned=turned),
            "corner": corner_limit(setting, straight_angle=straight_angle),
            "graph": smooth_across(setting, chart="tangent plane"),
        },
        shown="for arbitrary angles and curvatures (existence by Picard's iteration and, textbook, "
        "linear equations and smooth dependence; identities by series with symbols, to degree "
        f"{ORDER} inside and {HIGH} on rays): every sector exists, its frames on the rays are the "
        "given ones, position and normal agree on the rays, and |N_u x N_v| -> sin alpha_i > 0 "
        "makes it a C^{1,1} graph near 0",
    )


def lengths(setting: Setting, *, share: str = "1", rise: str = "1") -> Evidence:
    """Largest and least angle on squares of the explicit length of an assembly.

    With |kappa| <= M on both edges |theta - alpha| <= M (u + v) + u v, so that the length l with
    2 M l + l^2 = min(alpha, pi - alpha) keeps theta in (0, pi). share: of that minimum; rise:
    factor of the bound.
    """
    del setting

    def rows() -> Iterator[FloatRow]:
        for alpha in (0.3, 1.0, pi / 2, 2.0, 2.8):
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
        "bounds and extreme constant curvatures",
    )
