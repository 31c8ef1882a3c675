"""The definition of the hyperbolic plane, its circles, and surfaces of negative curvature."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import branched_surfaces
from theory import hyperbolic_plane as plane

X, Y = plane.X, plane.Y


def metric(setting: Setting, *, numerator: int = 4, power: int = 2) -> Evidence:
    """Compare the printed metric with that of the hyperboloid."""
    factor = branched_surfaces.poincare_factor(X, Y, numerator=numerator, power=power)
    return identities(
        setting,
        {"printed minus induced": list(plane.disk_metric() - factor * sp.eye(2))},
        shown="the metric is that of the hyperboloid -X0^2 + X1^2 + X2^2 = -1 in its disk",
    )


def curvature(setting: Setting, *, numerator: int = 4, power: int = 2, value: int = -1) -> Evidence:
    """Gauss curvature of the printed metric."""
    factor = branched_surfaces.poincare_factor(X, Y, numerator=numerator, power=power)
    return identities(
        setting,
        {"K minus its value": plane.conformal_curvature(factor) - value},
        shown="the metric has the constant curvature -1",
    )


def symmetry(setting: Setting, *, numerator: int = 4, power: int = 2) -> Evidence:
    """Killing fields of the printed metric with polynomial entries, and their boundary values."""
    factor = branched_surfaces.poincare_factor(X, Y, numerator=numerator, power=power)
    fields = plane.killing_fields(factor, degree=3)
    boundary = [sp.rem(sp.expand(X * a + Y * b), X**2 + Y**2 - 1, X) for a, b in fields]
    return statement(
        len(fields) == 3 and all(entry == 0 for entry in boundary),
        shown="the Killing fields form an algebra of dimension 3, the largest on a surface; all "
        "are tangent to the unit circle, so that their flows preserve the disk",
        witness=f"the Killing fields found are {fields}",
    )


def completeness(setting: Setting, *, numerator: int = 4, power: int = 2) -> Evidence:
    """Length of the radii, by the pole of the factor at the boundary."""
    factor = branched_surfaces.poincare_factor(X, Y, numerator=numerator, power=power)
    pole = plane.boundary_pole(factor)
    return statement(
        pole >= 2,
        shown="the radii have infinite length: the square root of the factor has a pole of order "
        "1 at the boundary; the disk is convex, hence simply connected",
        witness=f"the factor has a pole of order {pole} at the boundary: the radii have finite "
        "length",
    )


def perimeter_growth(setting: Setting, *, curvature: int = -1, rate: int = 1) -> Evidence:
    """Exponential rate of the perimeter of a disk, from the Jacobi equation L'' = -K L.

    For K = -1 the perimeter is also computed in the disk model.
    """
    radius = sp.Symbol("R", positive=True)
    length = plane.jacobi_perimeter(radius, curvature=curvature)
    growth = sp.limit(sp.log(length) / radius, radius, sp.oo) if curvature <= 0 else sp.Integer(0)
    found = {
        "rate": statement(
            growth == rate,
            shown="rate of growth",
            witness=f"the perimeter {length} has the exponential rate {growth}, not {rate}",
        )
    }
    if curvature == -1:
        found["disk model"] = identities(
            setting,
            {"2 pi sinh R - perimeter": length - plane.perimeter(radius)},
            shown="perimeter",
        )
    return combined(found, shown="the perimeter is 2 pi sinh R, of exponential rate 1")


def disk_area(setting: Setting, *, shift: int = 1) -> Evidence:
    """Area of a geodesic disk by integration in the disk model against 2 pi (cosh R - shift)."""
    radius = sp.Symbol("R", positive=True)
    return identities(
        setting,
        {"area": plane.area(radius) - 2 * sp.pi * (sp.cosh(radius) - shift)},
        shown="a disk of radius R has the area 2 pi (cosh R - 1)",
    )


_PROFILES = (sp.sinh, lambda r: sp.sinh(2 * r) / 2, lambda r: sp.sinh(r) + r**3, lambda r: r + r**3)


def negative_curvature_growth(
    setting: Setting, *, bounded_away: bool = True, opposite: bool = False
) -> Evidence:
    """Exponential rate of the perimeter on rotationally symmetric planes with K < 0.

    The perimeter at distance r is 2 pi L(r), K = -L''/L. bounded_away: only those with K below a
    negative number at infinity too; opposite: the claim is turned into its opposite.
    """
    r = sp.Symbol("r", positive=True)
    tried = []
    for profile in _PROFILES:
        length: Any = profile(r)
        kappa = -sp.diff(length, r, 2) / length
        if bounded_away and sp.limit(kappa, r, sp.oo) == 0:
            continue
        tried.append((length, sp.limit(sp.log(length) / r, r, sp.oo)))
    slow = [length for length, rate in tried if bool(rate > 0) == opposite]
    return _growth_evidence(setting, slow, tried=len(_PROFILES), met=len(tried))


def _growth_evidence(setting: Setting, slow: list[Any], *, tried: int, met: int) -> Evidence:
    r, delta = sp.symbols("r delta", positive=True)
    length, kappa = sp.Function("L")(r), sp.Function("K")(r)
    model = sp.sinh(delta * r) / delta
    wronskian = sp.diff(length, r) * model - length * sp.diff(model, r)
    slope = sp.diff(wronskian, r).subs(sp.diff(length, r, 2), -kappa * length)
    if slow:
        return Evidence(
            outcome="fail",
            grade="exact",
            tried=tried,
            met=met,
            witness=f"perimeter 2 pi ({slow[0]}) with K = -L''/L < 0",
        )
    return identities(
        setting,
        {"Wronskian of L and sinh(delta r)/delta": slope + (kappa + delta**2) * length * model},
        shown="where K <= -delta^2 the ratio of the perimeter to that of curvature -delta^2 grows; "
        "on the samples the rate is positive",
    )


def swelling(setting: Setting, *, where: str = "centre", curvature: int = 1) -> Evidence:
    """Total curvature inside a circle of a disk swollen by a factor that depends on the radius.

    The metric is h (dx^2 + dy^2), h a function of q = x^2 + y^2; it falls with q if the swelling
    is larger near the centre. curvature: the claimed sign of the integral of K.
    """
    q = sp.Symbol("q", positive=True)
    h = sp.Function("h", positive=True)
    steep, level = sp.symbols("s h_0", positive=True)
    total = -2 * sp.pi * q * sp.diff(h(q), q) / h(q)
    factor = h(X**2 + Y**2)
    density = sp.simplify(plane.conformal_curvature(factor).doit() * factor)
    on_ray = density.subs(Y, 0).subs(X, sp.sqrt(q)).doit()
    slope = -steep if where == "centre" else steep
    value = total.subs(sp.diff(h(q), q), slope).subs(h(q), level)
    sign = 1 if value.is_positive else -1
    return combined(
        {
            "primitive": identities(
                setting, {"pi K h - d total/dq": sp.pi * on_ray - sp.diff(total, q)}, shown=""
            ),
            "sign": statement(sign == curvature, shown="", witness=f"the integral of K is {value}"),
        },
        shown="the integral of K inside the circle q is -2 pi q h'/h: positive where the swelling "
        "decreases outwards, negative where it increases",
    )


def no_flat_map(setting: Setting, *, curvature: int = -1) -> Evidence:
    """Curvature of the metric that an arbitrary conformal map into the plane induces.

    In conformal coordinates of a surface an isometric map into the plane is conformal.
    """
    a, b = sp.Function("a")(X, Y), sp.Function("b")(X, Y)
    factor = a**2 + b**2
    rules = {
        sp.diff(b, X): -sp.diff(a, Y),
        sp.diff(b, Y): sp.diff(a, X),
        sp.diff(b, X, 2): -sp.diff(a, X, Y),
        sp.diff(b, Y, 2): sp.diff(a, X, Y),
        sp.diff(a, Y, 2): -sp.diff(a, X, 2),
    }
    flat = plane.conformal_curvature(factor)
    return combined(
        {
            "flat": identities(
                setting, {"K of |f'|^2 |dz|^2": flat.subs(rules).doit().subs(rules)}, shown=""
            ),
            "curved": statement(
                curvature != 0, shown="", witness="a metric of curvature 0 has an isometric map"
            ),
        },
        shown="the metric |f'|^2 |dz|^2 of a conformal map into the plane has curvature 0, not -1",
    )


def swelling_at_margin(setting: Setting, *, where: str = "margin", curvature: int = -1) -> Evidence:
    """Total curvature of a disk that swells more near its margin: see `swelling`."""
    return swelling(setting, where=where, curvature=curvature)
