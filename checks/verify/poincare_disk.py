"""Section 4.1, items (A) to (C): metric, distance, isometries and geodesics of the disk."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import poincare_disk as printed
from discrete import geodesics, poincare_disk
from discrete.space_forms import H2
from theory import hyperbolic_plane as plane

X, Y = plane.X, plane.Y
A, B, C, D = sp.symbols("a b c d", real=True)
_INSIDE = {"z": 1 - X**2 - Y**2, "z0": 1 - A**2 - B**2, "w": 1 - C**2 - D**2}


def metric(setting: Setting, *, numerator: int = 4, power: int = 1) -> Evidence:
    """Gauss curvature of the printed metric, and its comparison with that of the hyperboloid."""
    factor = printed.metric_factor(X, Y, numerator=numerator, power=power)
    return identities(
        setting,
        {
            "K + 1": plane.conformal_curvature(factor) + 1,
            "printed minus induced": list(plane.disk_metric() - factor * sp.eye(2)),
        },
        where=[_INSIDE["z"]],
        shown="the curvature is -1 and the metric is that of the hyperboloid",
    )


def distance(setting: Setting, *, factor: int = 2, sign: int = -1) -> Evidence:
    """Printed cosh d against the Minkowski product of the points of the hyperboloid.

    Also against the arc length of a radius, the shortest way from the origin, since |dz| >= d|z|.
    """
    z, w = (X, Y), (C, D)
    first, second = plane.hyperboloid_point(*z), plane.hyperboloid_point(*w)
    product = first[0] * second[0] - first[1] * second[1] - first[2] * second[2]
    t = sp.Symbol("t", positive=True)
    ray = printed.cosh_distance((0, 0), (t, 0), factor=factor, sign=sign)
    rate = sp.diff(ray, t) ** 2 - (ray**2 - 1) * plane.disk_metric()[0, 0].subs({X: t, Y: 0})
    cosh_d = printed.cosh_distance(z, w, factor=factor, sign=sign)
    return identities(
        setting,
        {
            "cosh d + <X, Y>": cosh_d - product,
            "cosh d at the origin": ray.subs(t, 0) - 1,
            "(d cosh d/dr)^2 - sinh(d)^2 g": rate,
        },
        where=[_INSIDE["z"], _INSIDE["w"], 1 - t],
        shown="cosh d is minus the Minkowski product, and along a radius dd/dr is the root of the "
        "factor of the metric",
    )


def radius(setting: Setting, *, factor: str = "2") -> Evidence:
    """Printed distance from the origin against the arc length of a radius, and against (A)."""
    r = sp.Symbol("r", positive=True)
    claimed = printed.radius(r, sp, factor=factor)
    ray = printed.cosh_distance((0, 0), (r, 0))
    speed = 2 / (1 - r**2)
    return identities(
        setting,
        {
            "at 0": claimed.subs(r, 0),
            "d'^2 - g": sp.diff(claimed, r) ** 2 - plane.disk_metric()[0, 0].subs({X: r, Y: 0}),
            "d' - root of g": sp.diff(claimed, r) - speed,
            "(A): (d cosh d/dr)^2 - (cosh(d)^2 - 1) d'^2": sp.diff(ray, r) ** 2
            - (ray**2 - 1) * sp.diff(claimed, r) ** 2,
        },
        where=[1 - r],
        shown="2 artanh r vanishes at the origin and grows at the rate 2/(1 - r^2) of the arc "
        "length; formula (A) grows at the same rate",
    )


def _pulled_back(map_: Any) -> Any:
    """Determinant of the differential of a conformal map of (X, Y)."""
    re, im = map_
    return sp.diff(re, X) * sp.diff(im, Y) - sp.diff(re, Y) * sp.diff(im, X)


def _covariance(**options: Any) -> list[Any]:
    """Differences f(t z; t z0) - t f(z; z0) for |t| = 1: what holds for z0 > 0 holds for all z0."""
    t = (sp.cos(C), sp.sin(C))
    turned = printed.moebius(printed.times(t, (X, Y)), printed.times(t, (A, B)), **options)
    plain = printed.times(t, printed.moebius((X, Y), (A, B), **options))
    return [turned[k] - plain[k] for k in range(2)]


def isometry(setting: Setting, *, denominator: int = 1, conjugated: bool = True) -> Evidence:
    """Whether the printed maps are the orientation preserving isometries, all of them.

    Each is one: holomorphic, with the right Jacobian. All: to every unit vector of the disk one and
    only one of them takes the vector 1 at 0, and an isometry is known by what it does to a vector.
    """
    turn = (sp.cos(C), sp.sin(C))
    options: dict[str, Any] = {"denominator": denominator, "conjugated": conjugated}
    re, im = printed.moebius((X, Y), (A, 0), **options)
    gap = 1 - re**2 - im**2
    image = printed.moebius((X, Y), (A, B), turn=turn, **options)
    at_origin = {X: 0, Y: 0}
    place = printed.times(turn, (A, B))
    slope = [sp.diff(part, X).subs(at_origin) for part in image]
    unit = 1 - A**2 - B**2
    return identities(
        setting,
        {
            "f(0) - e^(i theta) z0": [image[k].subs(at_origin) - place[k] for k in range(2)],
            "f'(0) - e^(i theta) (1 - |f(0)|^2)": [slope[k] - turn[k] * unit for k in range(2)],
            "f(t z; t z0) - t f(z; z0)": _covariance(**options),
            "Cauchy-Riemann": [sp.diff(re, X) - sp.diff(im, Y), sp.diff(re, Y) + sp.diff(im, X)],
            "metric": _pulled_back((re, im)) * (1 - X**2 - Y**2) ** 2 - gap**2,
        },
        where=[_INSIDE["z"], _INSIDE["z0"]],
        shown="each map is holomorphic and preserves the metric; theta is the argument of f'(0) "
        "and z0 = e^(-i theta) f(0), so every unit vector is reached by one map and one only",
    )


def derivative(setting: Setting, *, coefficient: int = -1) -> Evidence:
    """Printed f'(0; z0) against the derivative of the printed map."""
    re, im = printed.moebius((X, Y), (A, B))
    at_origin = {X: 0, Y: 0}
    claimed = printed.derivative_at_origin((A, B), coefficient=coefficient)
    return identities(
        setting,
        {
            "real part": sp.diff(re, X).subs(at_origin) - claimed,
            "imaginary part": sp.diff(im, X).subs(at_origin),
        },
        where=[_INSIDE["z0"]],
        shown="the derivative at 0 is 1 - |z0|^2, positive for |z0| < 1",
    )


def inverse(setting: Setting, *, shift: int = -1, denominator: int = -1) -> Evidence:
    """Printed inverse against the printed map, and against f(w; -z0)."""
    z, z0 = (X, Y), (A, B)
    back = printed.inverse(printed.moebius(z, z0), z0, shift=shift, denominator=denominator)
    quotient = printed.inverse(z, z0, shift=shift, denominator=denominator)
    forth = printed.moebius(quotient, z0)
    other = printed.moebius(z, (-A, -B))
    return identities(
        setting,
        {
            "inverse of f(z)": [back[k] - z[k] for k in range(2)],
            "f of the inverse": [forth[k] - z[k] for k in range(2)],
            "f(w; -z0)": [quotient[k] - other[k] for k in range(2)],
        },
        where=[_INSIDE["z"], _INSIDE["z0"]],
        shown="(w - z0)/(1 - w conj z0) is f(w; -z0) and inverts f on either side",
    )


def no_rotation(setting: Setting, *, denominator: int = 1, sign: int = 1) -> Evidence:
    """Whether the maps without rotation take any vertex to 0 and back, and are enough.

    sign: of z0 in f(0; z0) = z0. A rotation put between leaves the fourth vertex where it is.
    """
    c, s = sp.cos(C), sp.sin(C)
    z0, away = (A, B), (-A, -B)
    out = printed.moebius(z0, away, denominator=denominator)
    back = printed.moebius((0, 0), z0, denominator=denominator)
    w1, w2, modulus = (X, Y), (D, sp.Symbol("e", real=True)), sp.Symbol("r", positive=True)
    plain = printed.times((c, s), printed.fourth(w1, w2, modulus))
    turned = printed.fourth(printed.times((c, s), w1), printed.times((c, s), w2), modulus)
    round_trip = printed.moebius(printed.moebius((X, Y), away), z0, denominator=denominator)
    return identities(
        setting,
        {
            "f(z0; -z0)": list(out),
            "f(0; z0) - z0": [back[k] - sign * z0[k] for k in range(2)],
            "there and back": [round_trip[k] - (X, Y)[k] for k in range(2)],
            "the rule commutes with rotations": [plain[k] - turned[k] for k in range(2)],
        },
        where=[_INSIDE["z"], _INSIDE["z0"]],
        shown="f(.; -z0) takes z0 to 0 and f(.; z0) takes it back; the fourth vertex turns with "
        "its neighbours, so a rotation in between would change nothing",
    )


def equally_spaced(setting: Setting, *, rate: str = "1/2") -> Evidence:
    """Points gamma_beta(n) against points at the distance n Delta in the hyperboloid."""
    n = sp.Symbol("n", integer=True)
    spacing = sp.Symbol("Delta", positive=True)
    beta = sp.Symbol("beta", real=True)
    here = printed.on_ray(n, spacing, beta, sp, rate=rate)
    after = printed.on_ray(n + 1, spacing, beta, sp, rate=rate)
    seen = poincare_disk.to_disk(geodesics.polar(H2, sp, beta, n * spacing))
    return identities(
        setting,
        {
            "printed minus view of the hyperboloid": [here[k] - seen[k] for k in range(2)],
            "cosh d(n, n + 1) - cosh Delta": printed.cosh_distance(here, after) - sp.cosh(spacing),
            "on the line of direction beta": here[0] * sp.sin(beta) - here[1] * sp.cos(beta),
        },
        shown="the points lie on a diameter, n Delta from 0 and Delta from the next one",
    )


def equally_spaced_elsewhere(
    setting: Setting, *, rate: str = "1/2", denominator: int = 1
) -> Evidence:
    """Images of equally spaced points: f keeps (A), and its derivative at 0 keeps directions."""
    z, w, z0 = (X, Y), (C, D), (A, B)
    moved = [printed.moebius(p, (A, 0), denominator=denominator) for p in (z, w)]
    there = printed.moebius((0, 0), z0, denominator=denominator)
    image = printed.moebius(z, z0, denominator=denominator)
    slope = [sp.diff(part, X).subs({X: 0, Y: 0}) for part in image]
    return combined(
        {
            "f": identities(
                setting,
                {
                    "f(0) - z0": [there[k] - z0[k] for k in range(2)],
                    "f'(0) - (1 - |z0|^2)": [slope[0] - (1 - A**2 - B**2), slope[1]],
                    "f(t z; t z0) - t f(z; z0)": _covariance(denominator=denominator),
                    "cosh d kept": printed.cosh_distance(*moved) - printed.cosh_distance(z, w),
                },
                where=list(_INSIDE.values()),
                shown="",
            ),
            "gamma": equally_spaced(setting, rate=rate),
        },
        shown="f keeps distances, takes 0 to z0, and its derivative there is positive: the image "
        "of the ray of direction beta leaves z0 in the direction beta, so all geodesics are met",
    )
