"""Checks of section 3.1, items (B) and (C): the frames of the asymptotic lines, Lelieuvre."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.printed import asymptotic_frames as printed
from checks.verify.nets import (
    ROUTES,
    all_nets,
    combination,
    every_net,
    minus,
    over_nets,
    system_defects,
)
from theory.asymptotic_net import AsymptoticNet
from theory.forms import coordinate_line_curvatures, first_form
from theory.frames import gram, handedness
from theory.reparametrisation import changed
from theory.surfaces import pseudosphere
from theory.vectors import Vector, scaled


def _tangent(net: AsymptoticNet, along: str) -> Vector:
    return net.r_u if along == "u" else net.r_v


def orthonormal(setting: Setting, *, turned: str = "own", speed: int = 1) -> Evidence:
    """Item (B): (r_u, N x r_u, N) and (r_v, N x r_v, N) are orthonormal and right-handed.

    turned: the second vector of each frame turns the "own" tangent or that of the "other" family;
    speed: of the parametrisation.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for along, other in (("u", "v"), ("v", "u")):
            tangent = scaled(speed, _tangent(net, along))
            source = tangent if turned == "own" else _tangent(net, other)
            second = printed.frame(source, net.normal, net.calculus.cross)[1]
            frame = (tangent, second, net.normal)
            found[f"Gram matrix, {along}"] = gram(net.calculus, frame) - sp.eye(3)
            found[f"handedness, {along}"] = handedness(net.calculus, frame) - 1
        return found

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"both triples are orthonormal and right-handed, {ROUTES}",
    )


def principal_normal(setting: Setting, *, signed: bool = False, towards: str = "side") -> Evidence:
    """Item (B): N x r_u is the principal normal of the u-lines and N x r_v that of the v-lines.

    signed: whether the curvature may be negative; if not it is |r_uu| or |r_vv|, as for the Frenet
    frame of a space curve. towards: "side" for N x r_u, "normal" for N. On the pseudosphere with u
    reversed, and on all nets where the curvature is signed.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for along in ("u", "v"):
            tangent = _tangent(net, along)
            bent = net.d(tangent, along)
            curvature = net.geodesic_curvature(along)
            if not signed:
                curvature = sp.sqrt(net.calculus.dot(bent, bent))
            target = printed.frame(tangent, net.normal, net.calculus.cross)[1]
            if towards == "normal":
                target = net.normal
            found[f"r_{along}{along}"] = minus(bent, scaled(curvature, target))
        return found

    reversed_u = changed(pseudosphere().net(1), ((-1, 0), (0, 1)))
    nets = all_nets() if signed else (reversed_u,)
    return over_nets(
        setting,
        nets,
        residuals,
        shown="r_uu and r_vv are the geodesic curvature, of "
        f"either sign, times N x r_u and N x r_v, {ROUTES}",
    )


def frenet_u(
    setting: Setting, *, torsion: int = -1, back: int = 1, curvature_sign: int = 1
) -> Evidence:
    """First system of (eq:frames), row by row."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        frame = printed.frame(net.r_u, net.normal, net.calculus.cross)
        kappa = curvature_sign * net.geodesic_curvature("u")
        matrix = printed.frenet_u(kappa, torsion=torsion, back=back)
        return system_defects([net.d(a, "u") for a in frame], matrix, frame)

    return over_nets(
        setting, all_nets(), residuals, shown=f"the Frenet system of the u-lines holds, {ROUTES}"
    )


def frenet_v(
    setting: Setting, *, torsion: int = 1, back: int = -1, curvature_sign: int = 1
) -> Evidence:
    """Second system of (eq:frames), row by row."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        frame = printed.frame(net.r_v, net.normal, net.calculus.cross)
        kappa = curvature_sign * net.geodesic_curvature("v")
        matrix = printed.frenet_v(kappa, torsion=torsion, back=back)
        return system_defects([net.d(a, "v") for a in frame], matrix, frame)

    return over_nets(
        setting, all_nets(), residuals, shown=f"the Frenet system of the v-lines holds, {ROUTES}"
    )


def geodesic_curvatures(
    setting: Setting, *, sign_u: int = 1, sign_v: int = 1, power: int = 1
) -> Evidence:
    """Item (B): kappa^u, kappa^v of (eq:frames) are the geodesic curvatures of the metric.

    The entry of the system, r_uu.(N x r_u), against the covariant derivative in the metric alone,
    oriented by N; and it is the whole curvature, r_uu.r_uu = kappa^2. power: of kappa in r_uu.r_uu.
    """

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        product = net.calculus.dot
        metric = first_form(net.calculus, net.r_u, net.r_v)
        area = net.sigma * net.sin_phi
        intrinsic = coordinate_line_curvatures(metric, area, net.calculus.rate)
        found: dict[str, Any] = {}
        for along, sign, inner in zip("uv", (sign_u, sign_v), intrinsic, strict=True):
            bent = net.d(_tangent(net, along), along)
            kappa = net.geodesic_curvature(along)
            found[f"geodesic curvature of the {along}-lines"] = kappa - sign * inner
            found[f"whole curvature of the {along}-lines"] = product(bent, bent) - kappa ** (
                2 * power
            )
        return found

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"the entries are the geodesic curvatures that the metric gives, {ROUTES}",
    )


def normal_derivative(setting: Setting, *, sign: int = 1) -> Evidence:
    """Item (C): N_u = N x r_u, from the last row of the first system of (eq:frames)."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        frame = printed.frame(net.r_u, net.normal, net.calculus.cross)
        row = printed.frenet_u(net.geodesic_curvature("u"))[2]
        stated = printed.normal_along_u(net.r_u, net.normal, net.calculus.cross, sign=sign)
        return {
            "from the system": minus(combination(row, frame), stated),
            "differentiated": minus(net.d(net.normal, "u"), stated),
        }

    return over_nets(setting, all_nets(), residuals, shown=f"N_u = N x r_u, {ROUTES}")


def right_handed(setting: Setting, *, sign_u: int = 1, sign_v: int = -1) -> Evidence:
    """Item (C): (r_u, N_u, N) and (r_v, -N_v, N) are right-handed orthonormal frames."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        n_u, n_v = net.d(net.normal, "u"), net.d(net.normal, "v")
        first = printed.right_handed_u(net.r_u, n_u, net.normal, sign=sign_u)
        second = printed.right_handed_v(net.r_v, n_v, net.normal, sign=sign_v)
        return {
            "Gram matrix, u": gram(net.calculus, first) - sp.eye(3),
            "handedness, u": handedness(net.calculus, first) - 1,
            "Gram matrix, v": gram(net.calculus, second) - sp.eye(3),
            "handedness, v": handedness(net.calculus, second) - 1,
        }

    return over_nets(
        setting,
        all_nets(),
        residuals,
        shown=f"both frames are orthonormal and right-handed, {ROUTES}",
    )


def lelieuvre_u(setting: Setting, *, sign: int = 1, along: str = "u") -> Evidence:
    """First formula of (eq:lelieuvre); along: the coordinate by which N is differentiated."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        n_u = net.d(net.normal, along)
        stated = printed.lelieuvre_u(n_u, net.normal, net.calculus.cross, sign=sign)
        return {"r_u": minus(net.r_u, stated)}

    shown = f"r_u = N_u x N, {ROUTES}, and Kuen's surface"
    return over_nets(setting, every_net(), residuals, shown=shown)


def lelieuvre_v(setting: Setting, *, sign: int = -1, along: str = "v") -> Evidence:
    """Second formula of (eq:lelieuvre); along: the coordinate by which N is differentiated."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        n_v = net.d(net.normal, along)
        stated = printed.lelieuvre_v(n_v, net.normal, net.calculus.cross, sign=sign)
        return {"r_v": minus(net.r_v, stated)}

    shown = f"r_v = -N_v x N, {ROUTES}, and Kuen's surface"
    return over_nets(setting, every_net(), residuals, shown=shown)
