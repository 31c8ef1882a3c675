"""The normal near a point of a branched surface: (lem:injective) and the steps of its proof."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import topological_theorem as printed
from checks.verify.normal_turning import STARS
from theory import normal_bounds, star_normal, star_saddle
from theory.asymptotic_net import AsymptoticNet, general_net
from theory.curvature import intrinsic_curvature
from theory.frames import connection, u_frame, v_frame
from theory.moutard import curve_normals, goursat_series
from theory.polynomial_graph import PolynomialGraph, real_power
from theory.vectors import Vector, added, cross, dot
from theory.winding import X, Y

_S, _X = sp.symbols("s x", positive=True)


def _angle_rate(net: AsymptoticNet, along: str) -> Any:
    """Derivative of phi, from that of its cosine."""
    return -net.calculus.rate(net.cos_phi, along) / net.sin_phi


def _rates(mixed: int) -> dict[str, Any]:
    """Speeds of N and of its derivatives on a net of either orientation.

    mixed: the square of N_uv is compared with cos^2 phi to this power.
    """
    residuals: dict[str, Any] = {}
    for sigma in (1, -1):
        net = general_net(sigma)
        calculus = net.calculus
        n_u, n_v = net.d(net.normal, "u"), net.d(net.normal, "v")
        n_uv = net.d(n_u, "v")
        for name, frame, along in (("u", u_frame(net), "u"), ("v", v_frame(net), "v")):
            turn = connection(net, frame, along)
            residuals |= {
                f"{name}-frame, tilt of the first vector, sigma = {sigma}": turn[0, 2],
                f"{name}-frame, tilt of the second squared, sigma = {sigma}": turn[1, 2] ** 2 - 1,
            }
        residuals |= {
            f"kappa^u + phi_u, sigma = {sigma}": net.geodesic_curvature("u")
            + _angle_rate(net, "u"),
            f"kappa^v - phi_v, sigma = {sigma}": net.geodesic_curvature("v")
            - _angle_rate(net, "v"),
            f"|N_u|^2 - 1, sigma = {sigma}": calculus.dot(n_u, n_u) - 1,
            f"|N_v|^2 - 1, sigma = {sigma}": calculus.dot(n_v, n_v) - 1,
            f"|N_uv|^2 - cos^2 phi, sigma = {sigma}": calculus.dot(n_uv, n_uv)
            - net.cos_phi ** (2 * mixed),
        }
    u, v = sp.symbols("u v", real=True)
    phi = sp.Function("phi")(u, v)
    metric = sp.Matrix([[1, sp.cos(phi)], [sp.cos(phi), 1]])
    curvature = intrinsic_curvature(metric, (u, v))
    residuals["phi_uv + K sin phi"] = sp.diff(phi, u, v) + curvature * sp.sin(phi)
    return residuals


def _cone() -> dict[str, Any]:
    """The bisector of an interval of length pi - phi_0, and phi_0 from the curvature."""
    k = sp.Symbol("k", positive=True)
    tangent = sp.tan(normal_bounds.least_angle(k) / 2)
    a = sp.Symbol("a", positive=True)
    return {
        "cos((pi - phi)/2) - sin(phi/2)": sp.cos((sp.pi - a) / 2) - sp.sin(a / 2),
        "tan(phi_0/2) - 1/k": tangent - 1 / k,
        "s^2 - 1/(1 + k^2)": normal_bounds.cone_slope(k) ** 2 - 1 / (1 + k**2),
    }


def collar_claims(share: str) -> dict[str, Any]:
    """What makes share * s * delta a bound on the collar, for every s < 1 and delta < s^2/8."""
    slope = 1 / (1 + _S)
    delta = normal_bounds.largest_radius(slope) * _X / (1 + _X)
    far = normal_bounds.farthest(2 * delta, slope)
    t = sp.Symbol("t", positive=True)
    rate = sp.diff(normal_bounds.floor(t, slope), t)
    near_end = normal_bounds.floor(delta, slope)
    inside = slope * _X / (1 + _X)
    return {
        "distance_floor at t < s minus t s/2": normal_bounds.distance_floor(inside, slope)
        - inside * slope / 2,
        "s - t at the distance 2 delta": slope - far,
        "rate of the bound, which falls with t, at the distance 2 delta": rate.subs(t, far),
        f"bound at t = delta minus {share} s delta": near_end - sp.Rational(share) * slope * delta,
    }


def separation(
    setting: Setting, *, part: str = "both", reach: str = "7/5", share: str = "7/8", mixed: int = 1
) -> Evidence:
    """(lem:injective): |N - N(p)| >= t s - t^2/2 - t^3/8 on each sector.

    Here t = u + v. part: "punctured" for item 1, "collar" for item 2, "both"; reach: the bound is
    claimed to be positive for 0 < t < reach * s; share: |N - N(p)| >= share * s * delta is
    claimed on the collar delta <= d <= 2 delta < s^2/4; mixed: see _rates.
    """
    slope = 1 / (1 + _S)
    t = sp.Rational(reach) * slope * _X / (1 + _X)
    claims = {}
    if part in ("both", "punctured"):
        claims[f"bound for 0 < t < {reach} s"] = normal_bounds.floor(t, slope)
    if part in ("both", "collar"):
        claims |= collar_claims(share)
    return combined(
        {
            "rates": identities(setting, _rates(mixed), shown="rates"),
            "cone": identities(setting, _cone(), shown="cone"),
            "bound": positivity(setting, claims, shown="bound"),
        },
        shown="by computer: N moves at unit speed along both families, |N_uv| = |cos phi|, the "
        "curves turn by the change of phi, and t s - t^2/2 - t^3/8 is positive for 0 < t < 7/5 s, "
        "and at least 7/8 s delta on the collar of every delta < s^2/8; by hand "
        "(theory.normal_bounds): integrated in a cone of directions these speeds make it a lower "
        "bound of |N - N(p)| on each sector, t = u + v, s = 1/sqrt(1 + k^2), k a bound of the "
        "curvature near p",
    )


def weaker_hypotheses(setting: Setting, *, order: int = 3) -> Evidence:
    """Line 743: a star of this order meets the hypotheses of (lem:injective) alone.

    Its Hessian jumps, so it is not C^2; its normal has several preimages, so it is not one-to-one;
    yet no point of a sector but p is sent to N(p).
    """
    angles = star_saddle.regular_star(order)
    jumps = any(star_saddle.hessian_jump(angles, i) != 0 for i in range(len(angles)))
    many = len(star_normal.preimages(angles, sp.Rational(1, 97))) > 1
    invertible = all(
        sp.simplify(star_normal.sector_map(angles, i).det() + 1) == 0 for i in range(2)
    )
    return statement(
        jumps and many and invertible,
        shown="the monkey saddle of curvature -1 is no C^2 immersion and its normal is not "
        "one-to-one, so it is outside of (lem:maximal); being invertible to first order on each "
        "sector it meets (lem:injective); one-to-one with |N - N_0| >= c delta implies both "
        "properties of (lem:injective), with d_0 = c delta",
        witness=f"m = {order}: the Hessian jumps: {jumps}, several preimages: {many}, "
        f"invertible on sectors: {invertible}",
    )


def smooth_jacobian(setting: Setting, *, jacobian: int = -1) -> Evidence:
    """N is an immersion where y is C^2: N_u x N_v = jacobian * r_u x r_v on every net, not 0."""
    residuals = {}
    for sigma in (1, -1):
        net = general_net(sigma)
        calculus = net.calculus
        left = calculus.cross(net.d(net.normal, "u"), net.d(net.normal, "v"))
        area = calculus.cross(net.r_u, net.r_v)
        residuals[f"N_u x N_v, sigma = {sigma}"] = [
            a - jacobian * b for a, b in zip(left, area, strict=True)
        ]
        residuals[f"|r_u x r_v| - sin phi, sigma = {sigma}"] = (
            calculus.dot(area, net.normal) * sigma - net.sin_phi
        )
    return identities(
        setting,
        residuals,
        shown="the normal map has the Jacobian -1 and sin phi > 0, so by the inverse function "
        "theorem it is one-to-one near p",
    )


def collar_minimum(setting: Setting, *, inner: str = "delta") -> Evidence:
    """Infimum of |N(x) - N(p)|^2 over the collar, for the graphs of Re z^m, m = 2, 3, 4.

    |N - e_3|^2 = 2 - 2/sqrt(1 + |grad w|^2) and |grad w| = m r^(m-1) increase with r; inner: the
    inner radius, "0" for the punctured ball, which is not compact.
    """
    r, delta = sp.symbols("r delta", positive=True)
    parts: dict[str, Evidence] = {}
    for m in (2, 3, 4):
        square = sum(entry**2 for entry in PolynomialGraph(height=real_power(m)).gradient)
        slope = m * r ** (m - 1)
        height = 1 / sp.sqrt(1 + slope**2)
        low = (2 - 2 * height).subs(r, delta if inner == "delta" else 0)
        parts[f"gradient, m = {m}"] = identities(
            setting,
            {
                "|grad w|^2 - m^2 r^(2m-2)": square - m**2 * (X**2 + Y**2) ** (m - 1),
                "rate": sp.diff(2 - 2 * height, r) - 2 * slope * sp.diff(slope, r) * height**3,
            },
            shown="gradient",
        )
        parts[f"infimum, m = {m}"] = statement(
            low != 0 and bool(slope.subs(r, delta).is_positive),
            shown="infimum",
            witness=f"m = {m}: the infimum over the punctured ball is {low}",
        )
    return combined(
        parts,
        shown="for the graphs of Re z^m, m = 2, 3, 4, |N - N(p)| rises on delta <= r <= 2 delta "
        "from its least value at r = delta, which is positive; on the punctured ball the infimum "
        "would be 0; by hand: on a compact set a continuous positive function has a least value",
    )


_ALPHAS = (sp.pi / 3, 2 * sp.pi / 5, 5 * sp.pi / 7)
_ORDER = 4


def sector_extension(setting: Setting, *, bend: str = "0", torsion: int = 1) -> Evidence:
    """Extension of a sector to a C^2 saddle, from its two bounding curves.

    Series of the normal from curves of any constant curvatures, at an angle of cosine 3/5; the
    u-curve is continued at this angle to its tangent, as a multiple of pi; torsion: of the v-curve.
    """
    k, h = sp.symbols("kappa_u kappa_v", real=True)
    frames = [
        sp.Matrix([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        for c, s in ((sp.Integer(1), sp.Integer(0)), (sp.Rational(3, 5), sp.Rational(4, 5)))
    ]
    on_u = curve_normals(frames[0], k, -1, order=_ORDER)
    on_v = curve_normals(frames[1], h, torsion, order=_ORDER)
    series = goursat_series(on_u, on_v)
    u, v = sp.symbols("u v", real=True)
    normal: Vector = tuple(
        sum(a[i] * u**p * v**q for (p, q), a in series.items()) for i in range(3)
    )
    n_u, n_v = (tuple(sp.diff(entry, x) for entry in normal) for x in (u, v))
    residuals: dict[str, Any] = {
        "|N|^2 - 1": _low(dot(normal, normal) - 1, u, v, _ORDER),
        "|N_u|^2 - 1": _low(dot(n_u, n_u) - 1, u, v, _ORDER - 1),
        "|N_v|^2 - 1": _low(dot(n_v, n_v) - 1, u, v, _ORDER - 1),
    }
    origin = {u: 0, v: 0}
    r_u = tuple(e.subs(origin) for e in cross(n_u, normal))
    r_v = tuple(-e.subs(origin) for e in cross(n_v, normal))
    residuals["r_u at p minus s_i"] = list(added(r_u, tuple(-e for e in frames[0].row(0))))
    residuals["r_v at p minus s_{i+1}"] = list(added(r_v, tuple(-e for e in frames[1].row(0))))
    residuals["r_u x r_v at p minus sin alpha"] = cross(r_u, r_v)[2] - sp.Rational(4, 5)
    turned = sp.Rational(bend) * sp.pi
    jumps = {
        alpha: [
            star_saddle.hessian_jump(
                (alpha, sp.pi + turned - alpha, alpha - turned, sp.pi - alpha), i
            )
            for i in range(4)
        ]
        for alpha in _ALPHAS
    }
    wrong = [f"alpha = {alpha}: {found}" for alpha, found in jumps.items() if any(found)]
    return combined(
        {
            "series": identities(setting, residuals, shown="series"),
            "second form": statement(
                not wrong,
                shown="second form",
                witness=f"the second form jumps across the curves through p: {wrong}",
            ),
        },
        shown="from curves of any constant curvatures, at the angle of cosine 3/5, the series up "
        f"to order {_ORDER} in u and v of either sign is a unit normal with unit speeds that "
        "agrees with the sector where u, v >= 0; stars of the angles alpha, pi - alpha, alpha, "
        f"pi - alpha, {len(_ALPHAS)} values of alpha, have a continuous second form across their "
        "rays; by hand: the Goursat problem has a solution for curves of any curvature",
    )


def _low(expr: Any, u: sp.Symbol, v: sp.Symbol, order: int) -> list[Any]:
    """Coefficients of a polynomial in u, v of degree below this order in each of them."""
    terms = sp.Poly(sp.expand(expr), u, v).terms()
    return [c for (p, q), c in terms if p < order and q < order] or [sp.Integer(0)]


def minimal_radius(setting: Setting, *, rule: str = "min", offset: int = 0) -> Evidence:
    """Radius of all sectors from those of each, on stars whose rays have curvatures 0, 1, 2, ...

    Along a ray of constant geodesic curvature k the normal runs through a circle of the sphere at
    unit speed, of length 2 pi/sqrt(1 + k^2), and is back at N(p) there: no radius of a punctured
    ball may be larger. offset: error in the number of sectors.
    """
    k, x = sp.symbols("k x", real=True)
    turn = sp.Matrix([[0, k, 0], [-k, 0, -1], [0, 1, 0]])
    wrong = []
    for name, angles in STARS.items():
        count = printed.sectors(len(angles) // 2, offset=offset)
        if sum(angles[:count]) != 2 * sp.pi:
            wrong.append(f"{name}: {count} sectors fill the angle {sum(angles[:count])}")
        radii = [2 * sp.pi / sp.sqrt(1 + n**2) for n in range(count)]
        delta = printed.sector_radius(radii, rule=rule)
        short = [n for n, radius in enumerate(radii) if bool(delta > radius)]
        if short or not delta > 0:
            wrong.append(f"{name}: N(x) = N(p) at the distance {radii[short[-1]]} along ray "
                         f"{short[-1]}, less than {delta}")  # fmt: skip
    return combined(
        {
            "period": identities(
                setting,
                {"rate of the frame": (turn - x * sp.eye(3)).det() + x * (x**2 + 1 + k**2)},
                shown="period",
            ),
            "stars": statement(not wrong, shown="stars", witness="; ".join(wrong[:2])),
        },
        shown=f"on {len(STARS)} stars the 2m sectors fill the angle 2 pi, and the least of the "
        "positive radii is positive and no larger than any of them",
    )


def punctured_ball(setting: Setting, *, reach: str = "7/5", mixed: int = 1) -> Evidence:
    """Item 1 of (lem:injective); see separation."""
    return separation(setting, part="punctured", reach=reach, mixed=mixed)


def collar_distance(setting: Setting, *, share: str = "7/8", mixed: int = 1) -> Evidence:
    """Item 2 of (lem:injective); see separation."""
    return separation(setting, part="collar", share=share, mixed=mixed)


def normal_defined(setting: Setting, *, curvature: int = -1) -> Evidence:
    """Line 686: N is Lipschitz, and N(x) is not N(p) near p, so that J_p is defined.

    The principal curvatures are k >= 1 and curvature/k. Of the curvature 0 the cylinder over
    y = x^2/2 is taken, on which N is constant along the ruling through p.
    """
    excess = sp.Symbol("e", positive=True)
    t = sp.Symbol("t", real=True)
    k = 1 + excess
    stretch = k**2 * sp.cos(t) ** 2 + curvature**2 / k**2 * sp.sin(t) ** 2
    lipschitz = identities(
        setting,
        {"k^2 - |dN|^2": k**2 - stretch - sp.sin(t) ** 2 * (k**4 - curvature**2) / k**2},
        shown="k^2 - |dN e|^2 = sin^2 t (k^4 - K^2)/k^2",
    )
    if curvature == -1:
        isolated = separation(setting, part="punctured")
    else:
        ruling = [entry.subs(X, 0) for entry in PolynomialGraph(height=X**2 / 2).gradient]
        isolated = statement(
            any(entry != 0 for entry in ruling),
            shown="ruling",
            witness="w = x_1^2/2 has the gradient (x_1, 0): N(0, x_2) = N(0, 0) for all x_2, so "
            "pi(N) and J_p are not defined, though N is smooth",
        )
    return combined(
        {"Lipschitz": lipschitz, "isolated": isolated},
        shown="|dN| <= k, the bound of the curvature: N is Lipschitz; and, by the bound of "
        "(lem:injective), in part by hand, N(x) is not N(p) for 0 < t < 7/5 s on the sectors of a "
        "saddle, so J_p is defined",
    )
