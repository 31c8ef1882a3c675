"""Checks of the opening of section 3.5: the forms alpha and beta, and Hazzidakis' formula."""

from fractions import Fraction
from typing import Any

import sympy as sp
from flint import arb
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import branched_sine_gordon as printed
from checks.verify.ball_bounds import bounded
from checks.verify.nets import ROUTES, all_nets, over_nets
from theory import asymptotic_polygon as polygons
from theory import rough_front, soliton_rectangle
from theory.amsler import chebyshev_metric
from theory.asymptotic_net import AsymptoticNet
from theory.curvature import intrinsic_curvature

U, V = sp.symbols("u v", real=True)


PHI = sp.Function("phi", positive=True)(U, V)


SIGNS = (1, -1)


def _differential(*, denominator: int = 2, sign_u: int = -1) -> Any:
    """Coefficient of du ^ dv in the differential of the printed one-form."""
    along_u, along_v = printed.one_form(
        sp.diff(PHI, U), sp.diff(PHI, V), denominator=denominator, sign_u=sign_u
    )
    return sp.diff(along_v, U) - sp.diff(along_u, V)


def one_form(setting: Setting, *, denominator: int = 2, sign_u: int = -1) -> Evidence:
    """Differential of alpha for an unknown angle."""
    gap = _differential(denominator=denominator, sign_u=sign_u) - sp.diff(PHI, U, V)
    return identities(
        setting,
        {"d alpha - phi_uv du ^ dv": gap},
        shown="for an unknown angle, d alpha = phi_uv du ^ dv",
    )


def area_form(setting: Setting, *, sigma_power: int = 1, metric_power: int = 1) -> Evidence:
    """Area form oriented by N, and its square, against the metric as printed."""

    def residuals(net: AsymptoticNet) -> dict[str, Any]:
        dot = net.calculus.dot
        metric = printed.metric(net.cos_phi, net.sigma, sigma_power=metric_power)
        area = dot(net.calculus.cross(net.r_u, net.r_v), net.normal)
        beta = printed.area_form(net.sin_phi, net.sigma, sigma_power=sigma_power)
        return {
            "metric": [metric[0, 0] - dot(net.r_u, net.r_u), metric[0, 1] - dot(net.r_u, net.r_v)],
            "beta^2 - det g": beta**2 - metric.det(),
            "beta - (r_u x r_v).N": beta - area,
        }

    return over_nets(
        setting, all_nets(), residuals, shown=f"beta = sigma sin phi du ^ dv, {ROUTES}"
    )


def sine_gordon_in_forms(setting: Setting, *, sigma_power: int = 1, sign_u: int = -1) -> Evidence:
    """Coefficient of d alpha - beta, by the curvature of the metric of asymptotic lines."""
    residuals = {}
    for sigma in SIGNS:
        beta = printed.area_form(sp.sin(PHI), sigma, sigma_power=sigma_power)
        gap = _differential(sign_u=sign_u) - beta
        curvature = intrinsic_curvature(chebyshev_metric(PHI, sigma=sigma), (U, V))
        residuals[f"sine-Gordon, sigma = {sigma}"] = gap - (
            sp.diff(PHI, U, V) - sigma * sp.sin(PHI)
        )
        residuals[f"K + 1, sigma = {sigma}"] = gap + (curvature + 1) * sigma * sp.sin(PHI)
    return identities(
        setting,
        residuals,
        shown="d alpha - beta is phi_uv - sigma sin phi, and -sigma sin phi (K + 1) for the "
        "curvature K of the metric: it vanishes exactly where K = -1",
    )


def hazzidakis(
    setting: Setting, *, sigma_power: int = 0, sign: int = -1, percent: int = 100
) -> Evidence:
    """Mixed derivative of (eq:hazzidakis) by its last corner, and its value on the sides.

    phi is any solution of phi_uv = sigma sin phi, sin phi du dv its area.
    """
    u0, v0 = sp.symbols("u_0 v_0", real=True)
    residuals = {}
    phi = sp.Function("phi", real=True)
    for sigma in SIGNS:
        left = printed.corner_sum(phi(u0, v0), phi(u0, V), phi(U, V), phi(U, v0), sign=sign)
        mixed = sp.diff(left, U, V).subs(sp.diff(phi(U, V), U, V), sigma * sp.sin(phi(U, V)))
        right = printed.rectangle_area(
            sp.sin(phi(U, V)), sigma, sigma_power=sigma_power, percent=percent
        )
        residuals[f"u_1 = u_0, sigma = {sigma}"] = left.subs(U, u0)
        residuals[f"v_1 = v_0, sigma = {sigma}"] = left.subs(V, v0)
        residuals[f"d^2/du_1 dv_1, sigma = {sigma}"] = mixed - right
    return identities(
        setting,
        residuals,
        shown="both sides vanish on degenerate rectangles and have the same mixed derivative by "
        "the last corner, for both signs of sigma",
    )


_RECTANGLES = (
    (Fraction(-2), Fraction(-1), Fraction(-1), Fraction(0)),
    (Fraction(-3), Fraction(1), Fraction(-4), Fraction(-1)),
    (Fraction(-1, 3), Fraction(0), Fraction(-7), Fraction(0)),
    (Fraction(-9), Fraction(0), Fraction(-9), Fraction(0)),
)


PSEUDOSPHERE_BITS = 128


def hazzidakis_on_pseudosphere(
    setting: Setting, *, sigma_power: int = 0, percent: int = 100
) -> Evidence:
    """(eq:hazzidakis) in balls on rectangles of the pseudosphere, for both orientations.

    With the other orientation sigma = -1 and the angle is pi less the angle before.
    """

    def rows() -> Any:
        for u0, u1, v0, v1 in _RECTANGLES:
            area = soliton_rectangle.area((u0, u1, v0, v1))
            for sigma in SIGNS:
                a, b, c, d = (
                    soliton_rectangle.angle(*p) if sigma == 1
                    else arb.pi() - soliton_rectangle.angle(*p)
                    for p in ((u0, v0), (u0, v1), (u1, v1), (u1, v0))
                )  # fmt: skip
                right = sigma**sigma_power * area * percent / 100
                gap = abs(printed.corner_sum(a, b, c, d) - right)
                yield f"[{u0}, {u1}] x [{v0}, {v1}], sigma = {sigma}", gap, arb("1e-25")

    return bounded(
        rows(),
        bits=PSEUDOSPHERE_BITS,
        sampled=True,
        shown="on four rectangles of the pseudosphere, areas by rigorous quadrature, both sides "
        "agree to 25 decimals",
    )


def path_lengths(setting: Setting, *, diagonal: bool = False, shift: int = 0) -> Evidence:
    """Parities of the lengths of all walks of up to 7 steps from the corner (u_0, v_0).

    diagonal: whether a diagonal counts as an edge too; shift: added to every length.
    """
    corners = [(0, 0), (0, 1), (1, 1), (1, 0)]
    far = {2} if diagonal else set()
    reached: dict[tuple[int, int], set[int]] = {corner: set() for corner in corners}
    here = {(0, 0)}
    for length in range(8):
        for corner in here:
            reached[corner].add((length + shift) % 2)
        here = {b for a in here for b in corners if sum(map(_gap, a, b)) in {1} | far}
    if any(len(parities) != 1 for parities in reached.values()):
        return statement(False, shown="", witness="walks of either parity reach a corner")
    phi = {corner: sp.Symbol(f"phi_{corner[0]}{corner[1]}") for corner in corners}
    total = sum((-1) ** min(reached[corner]) * phi[corner] for corner in corners)
    return identities(
        setting,
        {"sum by parities": total - printed.corner_sum(*(phi[corner] for corner in corners))},
        shown="all walks to a corner have one parity, and the signs are those of the formula",
    )


def _gap(a: int, b: int) -> int:
    return abs(a - b)


def area_bound(setting: Setting, *, hundredths: int = 200) -> Evidence:
    """Bound on the area of rhombi of Minding's bobbin, and of any corners in (0, pi).

    phi = pi s/(1 + s) for s > 0; on the bobbin pi > largest > least > 0.
    """
    s, t, x, y = sp.symbols("s t x y", positive=True)
    bound = printed.area_bound(hundredths=hundredths)
    # High powers bring the rational values of a refutation near the ends of (0, pi).
    low, rise = s**6, t**6
    rhombus = polygons.pendulum_rhombus_area(
        sp.pi * (low + rise) / (1 + low + rise), sp.pi * low / (1 + low + rise)
    )
    corners = printed.corner_sum(*(sp.pi * e / (1 + e) for e in (s, t, x, y)))
    claims = {
        "bound less area, bobbin": bound - rhombus,
        "bound less the sum": sp.together(bound - corners),
        "bound plus the sum": sp.together(bound + corners),
    }
    parts = {
        "bobbin": identities(
            setting, {"area by the pendulum": polygons.pendulum_defect()}, shown=""
        ),
        "bound": positivity(setting, claims, shown=""),
    }
    return combined(
        parts,
        shown="corner angles in (0, pi) keep the alternating sum between -2 pi and 2 pi; rhombi of "
        "the bobbin have every area below 2 pi",
    )


def continuous_angle(setting: Setting, *, jump: bool = False) -> Evidence:
    """Sum over the cells of a rectangle cut by asymptotic lines where phi has kinks.

    jump: whether phi jumps across the first line u = u_1 by an amount that changes along it.
    """
    unknown = polygons.unknown_angle
    step = sp.Function("j", real=True)

    def right_of(point: Any) -> Any:
        return unknown(point) + (step(point[1]) if jump and point[0] == 1 else 0)

    def in_cell(cell: Any) -> Any:
        return polygons.cell_difference(cell, right_of if cell[0] >= 1 else unknown)

    columns, rows = 3, 2
    total = sum(in_cell((i, j)) for i in range(columns) for j in range(rows))
    whole = unknown((0, 0)) - unknown((0, rows)) + unknown((columns, rows)) - unknown((columns, 0))
    return identities(
        setting,
        {"sum over the cells - sum over the rectangle": sp.expand(total - whole)},
        shown="where phi is continuous, the sums over the cells that kinks cut off add up to the "
        "sum over the rectangle, as the areas do: the formula passes to the rectangle, and "
        "with its area the sum tends to 0",
    )


ROUGH_LEVELS = (16, 32, 64, 128)


_ROUGH_LENGTH = 0.8


def rough_angle(setting: Setting, *, percent: int = 100, sign: int = -1) -> Evidence:
    """Hazzidakis' formula on a front whose angle is nowhere differentiable along two edges.

    The averages of phi over the corner cells stand for its values; the claim on every level is that
    the gap is at most h times the area, h the side of a cell: averaging data of Hoelder exponent
    1/2 over a cell makes errors of that size. percent: of the area; sign: in the difference.
    """
    worst, wrong = 0.0, []
    for cells in ROUGH_LEVELS:
        angles = rough_front.cell_angles(rough_front.normals(cells, _ROUGH_LENGTH, 1.2))
        # For sigma = 1 the angle between N_u and N_v is pi - phi.
        a, b, c, d = (float(mp.pi) - angles[i][j] for i, j in ((0, 0), (0, -1), (-1, -1), (-1, 0)))
        area = rough_front.area(angles, _ROUGH_LENGTH)
        gap = abs(float(printed.corner_sum(a, b, c, d, sign=sign)) - area * percent / 100)
        bound = area * _ROUGH_LENGTH / cells
        worst = max(worst, gap / bound)
        if gap > bound:
            wrong.append(f"{cells} cells a side: gap {gap:.3g} above {bound:.3g}")
    return Evidence(
        outcome="fail" if wrong else "pass",
        grade="experiment",
        tried=len(ROUGH_LEVELS),
        met=len(ROUGH_LEVELS),
        residual=f"{worst:.1g}",
        witness="; ".join(wrong),
        shown="on grids of 16 to 128 cells a side the alternating sum is the area up to a "
        f"fraction {worst:.1g} of h times the area",
    )
