"""Branch points cannot be smoothed away: (thm:branched) and the steps of its proof."""

from itertools import product
from typing import Any

import sympy as sp
from flint import arb, fmpq

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import topological_theorem as printed
from checks.verify.front_index import front_indices
from checks.verify.normal_index import star_index
from checks.verify.normal_separation import collar_claims
from theory import normal_bounds, star_normal, star_saddle
from theory.polynomial_graph import PolynomialGraph, real_power
from theory.vectors import Vector, added, cross, derivative, scaled
from theory.winding import winding_by_arcs, winding_by_zeros


def common_radius(setting: Setting, *, growth: int = 0, divisor: int = 6) -> Evidence:
    """Radius epsilon < min(eta, delta), for curvatures of at most k_max n^growth."""
    n, k, delta = sp.symbols("n k delta", positive=True)
    eta = printed.radius_bound(k * n**growth, divisor=divisor)
    least = sp.limit(eta, n, sp.oo)
    bound = printed.common_radius(least, delta)
    return statement(
        bool(bound.is_positive),
        shown="eta depends on k_max alone: with delta(p) and a third of the distance to the "
        "boundary it bounds epsilon from above by a positive number, the same for all n",
        witness=f"curvatures k n^{growth} leave the radius {bound} for n to infinity",
    )


def common_distance(setting: Setting, *, share: str = "7/8", rule: str = "both") -> Evidence:
    """Lower bound of |N(x) - N(p)| on the collar of epsilon, for y and for every y_n.

    share: c(k) = share/sqrt(1 + k^2); rule: "both" for min(c epsilon, d_0), "d_0" for d_0 alone,
    the constant that (lem:injective) gives for a larger radius delta.
    """
    claims = collar_claims(share)
    k = sp.Integer(2)
    delta = normal_bounds.largest_radius(normal_bounds.cone_slope(k))
    small = delta / 100
    d_0 = sp.Rational(7, 8) * normal_bounds.cone_slope(k) * delta
    reached = 2 * k * small
    return combined(
        {
            "bound": positivity(setting, claims, shown="bound"),
            "constant": statement(
                rule == "both" or not bool(d_0 > reached),
                shown="constant",
                witness=f"k = 2, delta = {delta}: d_0 >= {sp.N(d_0, 4)}, while |dN| <= k gives "
                f"|N(x) - N(p)| <= {sp.N(reached, 4)} on the collar of epsilon = delta/100",
            ),
        },
        shown="with c(k) = 7/8/sqrt(1 + k^2) and epsilon < 1/(8 (1 + k^2)) the bound c epsilon, "
        "hence min(c epsilon, d_0), holds on the collar of epsilon, sector by sector, for C^2 "
        "immersions and for branched ones of curvature at most k on B_{4 epsilon sqrt(1 + k^2)}: "
        "positivity by computer, the cone of directions by hand (theory.normal_bounds)",
    )


def common_circle(setting: Setting, *, largest: str = "1/8") -> Evidence:
    """Degree along circles of several radii about points of smooth fronts, in balls.

    The normal does not return to N(p) for 0 < t < 7/5 s, so the degree is that of small circles.
    largest: radius of the largest circle of the (u, v)-plane.
    """
    radius = sp.Rational(largest)
    size = fmpq(int(radius.p), int(radius.q))
    found = {shrink: front_indices(radius=size / shrink, points=1) for shrink in (1, 4, 64)}
    wrong = [
        f"{name}, radius {radius / shrink}: {index}"
        for shrink, indices in found.items()
        for name, index in indices.items()
        if index != -1
    ]
    s, x = sp.symbols("s x", positive=True)
    slope = 1 / (1 + s)
    claim = normal_bounds.floor(sp.Rational(7, 5) * slope * x / (1 + x), slope)
    return combined(
        {
            "no return": positivity(setting, {"bound for 0 < t < 7/5 s": claim}, shown="bound"),
            "fronts": Evidence(
                outcome="fail" if wrong else "pass",
                grade="certified" if wrong else "numeric",
                tried=3 * len(found[1]),
                met=3 * len(found[1]),
                witness="; ".join(wrong),
            ),
        },
        shown="N(x) is not N(p) within a radius that depends on the bound of the curvature alone, "
        "so every circle in it gives the same degree; circles of radii 1/8, 1/32, 1/512 agree on "
        "three fronts",
    )


def smooth_index(setting: Setting, *, index: int = -1, angle: str = "1/3") -> Evidence:
    """J_p of C^2 pseudospherical immersions: nine points of fronts, and all smooth stars.

    A C^2 saddle has the sector angles a, pi - a, a, pi - a; angle: the first as a share of pi.
    """
    wrong = [f"{name}: {found}" for name, found in front_indices().items() if found != index]
    a = sp.Rational(angle) * sp.pi
    for alpha in (a, sp.pi / 2, sp.pi / 50):
        star = (alpha, sp.pi - alpha) * 2
        if star_saddle.winding_number(star) != index:
            wrong.append(f"alpha = {alpha}: {star_saddle.winding_number(star)}")
        if len(star_normal.preimages(star, sp.Rational(1, 97))) != 1:
            wrong.append(f"alpha = {alpha}: not one-to-one")
    return Evidence(
        outcome="fail" if wrong else "pass",
        grade="certified" if wrong else "numeric",
        shown="J_p = -1 at nine points of the pseudosphere, Dini's and Kuen's surface and on "
        "smooth saddles, whose normal is one-to-one to first order",
        tried=12,
        met=12,
        witness="; ".join(wrong[:3]),
    )


def normals_converge(setting: Setting, *, same_metric: bool = True) -> Evidence:
    """N_n - N and its derivative in terms of y_n - y, for maps that induce one metric.

    same_metric: else the area factors of the two maps differ.
    """
    t = sp.Symbol("t", real=True)

    def field(name: str) -> Vector:
        return tuple(sp.Function(f"{name}{i}")(t) for i in range(3))

    a, b, a_n, b_n = (field(name) for name in ("a", "b", "A", "B"))
    area = sp.Symbol("g", positive=True)
    area_n = area if same_metric else sp.Symbol("G", positive=True)
    difference = added(scaled(1 / area_n, cross(a_n, b_n)), scaled(-1 / area, cross(a, b)))
    step_a, step_b = added(a_n, scaled(-1, a)), added(b_n, scaled(-1, b))
    split = added(cross(step_a, b_n), cross(a, step_b))
    rate = added(
        added(cross(derivative(step_a, t), b_n), cross(derivative(a, t), step_b)),
        added(cross(step_a, derivative(b, t)), cross(a_n, derivative(step_b, t))),
    )
    return identities(
        setting,
        {
            "N_n - N": list(added(difference, scaled(-1 / area, split))),
            "its derivative": list(added(derivative(difference, t), scaled(-1 / area, rate))),
        },
        shown="N_n - N and its derivatives are sums of products of a difference of first or second "
        "derivatives with first derivatives or with second derivatives of y; by hand: the former "
        "are small in L^2, the common metric bounds the first derivatives, the C^{1,1} limit has "
        "bounded second ones: convergence in W^{1,2}",
    )


def oscillation(setting: Setting, *, dimension: int = 2) -> Evidence:
    """Mean oscillation on cubes of any side from the gradient, mode by mode of a cosine series.

    mean f^2 <= side^(2 - dimension) / pi^2 * integral |grad f|^2, and the power of the side must be
    0 for W^{1,2} to bound BMO.
    """
    side = sp.Symbol("S", positive=True)
    x = sp.symbols(f"x1:{dimension + 1}", real=True)
    residuals: dict[str, Any] = {}
    numbers = sp.symbols(f"j1:{dimension + 1}", integer=True, positive=True)
    for wave in product((False, True), repeat=dimension):
        modes = [j if waves else sp.Integer(0) for j, waves in zip(numbers, wave, strict=True)]
        if not any(wave):
            continue
        f = sp.prod([sp.cos(j * sp.pi * y / side) for j, y in zip(modes, x, strict=True)])
        mean, energy = f**2, sum(sp.diff(f, y) ** 2 for y in x)
        for y in x:
            mean = sp.integrate(sp.expand(mean), (y, 0, side)) / side
            energy = sp.integrate(sp.expand(energy), (y, 0, side))
        weight = sum(j**2 for j in modes) * sp.pi**2
        residuals[f"mode {modes}"] = sp.simplify(mean * weight - energy)
    return identities(
        setting,
        residuals,
        shown="on squares of any side the mean of f^2, f any non-constant cosine mode (j, k), is "
        "the integral of |grad f|^2 divided by (j^2 + k^2) pi^2, with no power of the side; by "
        "hand: modes are orthogonal, so the mean oscillation is at most |grad f| in L^2, over "
        "pi; L^2 on a bounded set gives L^1",
    )


def degree_stable(setting: Setting, *, percent: int = 99) -> Evidence:
    """Degrees of loops a and b with |b - a| <= percent/100 |a|, certified in balls.

    The loops a turn -1, -2, -3 times, the differences turn 0, 1 or -4 times.
    """
    wrong = []
    share = fmpq(percent, 100)
    pairs = [(j, k) for j in (-1, -2, -3) for k in (0, 1, -4)]
    for j, k in pairs:

        def loop(t: arb, j: int = j, k: int = k) -> tuple[arb, arb]:
            angle = 2 * arb.pi() * t
            first, last = j * angle, k * angle
            return (
                first.cos() + share * last.cos(),
                first.sin() + share * last.sin(),
            )

        if (found := winding_by_arcs(loop, depth=18)) != j:
            wrong.append(f"a turns {j} times, b = a + {share} e turns {found} times")
    h, k_max = sp.symbols("h k", positive=True)
    volume = normal_bounds.cone_volume(h, 2 * k_max)
    return combined(
        {
            "loops": Evidence(
                outcome="fail" if wrong else "pass",
                grade="certified" if wrong else "numeric",
                tried=len(pairs),
                met=len(pairs),
                witness="; ".join(wrong[:2]),
            ),
            "uniform": identities(
                setting,
                {"cone": volume - sp.pi * h**3 / (12 * k_max**2)},
                shown="a bound in L^1 and the common Lipschitz constant give a uniform one",
            ),
        },
        shown="loops that differ by less than the distance of one of them to 0 have the same "
        "degree, up to that constant, on nine pairs of loops; by hand: all N_n and N have the "
        "Lipschitz constant k_max, so |N_n - N| in L^1 below pi h^3/(12 k_max^2) is below h "
        "everywhere, and h = rho_0/2 keeps the degree: no BMO is needed",
    )


def smooth_indices(*, isometric: bool) -> set[int]:
    """J_p of smooth saddles of determinant -1, or of the graphs of Re z^2, Re z^3 and Re z^4."""
    if isometric:
        shares = (sp.pi / 3, sp.pi / 2, sp.pi / 50)
        return {int(star_saddle.winding_number((a, sp.pi - a) * 2)) for a in shares}
    graphs = [PolynomialGraph(height=real_power(m)) for m in (2, 3, 4)]
    return {winding_by_zeros(graph.gradient, 0, 1) for graph in graphs}


def branched_limit(
    setting: Setting, *, order: int = 2, isometric: bool = True, share: str = "7/8"
) -> Evidence:
    """(thm:branched): orders of saddleness of a limit of smooth immersions of bounded curvature.

    For y of any order m and y_n smooth, of curvatures <= k: |N - N(p)| and |N_n - N_n(p)| are at
    least rho_0 = share s epsilon on the collar, the latter with degree -1; N_n within rho_0/2 of N
    has the degree 1 - m. So 1 - m = -1, and for other m the normals of y_n stay at least
    pi (rho_0/2)^3/(12 k^2) away in L^1. isometric: whether y_n has curvature -1, else any graph.
    """
    k, x = sp.symbols("k x", positive=True)
    slope = normal_bounds.cone_slope(k)
    rho = sp.Rational(share) * slope * normal_bounds.largest_radius(slope) * x / (1 + x)
    gap = normal_bounds.cone_volume(rho / 2, 2 * k)
    smooth = smooth_indices(isometric=isometric)
    orders = [m for m in range(2, 13) if star_index(m) in smooth]
    expected = [printed.limit_order(order=order)]
    return combined(
        {
            "collar": positivity(setting, collar_claims(share), shown="collar"),
            "gap": statement(bool(sp.simplify(gap).is_positive), shown="gap", witness=f"gap {gap}"),
            "orders": statement(
                orders == expected,
                shown="orders",
                witness=f"the limit may have the orders {orders}"
                + ("" if isometric else ": smooth graphs such as that of Re z^3 have J_p = -2"),
            ),
        },
        shown="by computer: the indices -1 and 1 - m, m = 2 to 12, and the signs of all bounds; "
        "so, by the cone of directions and equal Lipschitz constants, by hand, for m != 2 the "
        "normals of smooth immersions of curvature at most k keep a distance "
        "of pi (rho_0/2)^3/(12 k^2) in L^1 from that of y, rho_0 = 7/8 epsilon/sqrt(1 + k^2), "
        "for every epsilon < 1/(8 (1 + k^2)) with B_{4 epsilon sqrt(1 + k^2)}(p) in Omega: no "
        "sequence converges to y",
    )
