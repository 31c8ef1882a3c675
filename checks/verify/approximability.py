"""Checks of what smooth isometries approximate: indices, jumps of the second form, smoothing."""

from collections.abc import Sequence

import sympy as sp
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import approximability as printed
from checks.verify.convergence import order as observed_order
from theory import asymptotic_net, smoothed_corner, star_saddle
from theory.vectors import added

#: Sectors in units of pi: neither alpha_1 + alpha_2 nor alpha_2 + alpha_3 is pi.
UNSMOOTH = ("1/3", "1/2", "2/3", "1/2")
H, S = sp.symbols("h s", positive=True)


def _star(shares: Sequence[str]) -> tuple[sp.Expr, ...]:
    return tuple(sp.Rational(share) * sp.pi for share in shares)


def _excluded(order: int) -> Evidence:
    """Whether the regular star of this order has an index other than -1, and a jump in the form."""
    angles = star_saddle.regular_star(order)
    index = star_saddle.winding_number(angles)
    jumps = [star_saddle.hessian_jump(angles, i) for i in range(2 * order)]
    return statement(
        bool(index != -1 and index == 1 - order and all(jump != 0 for jump in jumps)),
        shown="index 1 - m < -1",
        witness=f"order {order}: index {index}, jumps of the second derivative {jumps}",
    )


def not_approximable(setting: Setting, *, orders: str = "3") -> Evidence:
    """Whether (thm:branched) excludes stars of these orders: their index is not -1."""
    del setting
    return combined(
        {f"m = {m}": _excluded(int(m)) for m in orders.split(",")},
        shown=f"for m = {orders} the index is 1 - m, not -1, and the second form jumps across each "
        "ray: no limit in W^{2,2} with bounded curvatures by (thm:branched), nor in W^{2,infinity} "
        "of C^2 immersions at all",
    )


def all_orders(setting: Setting, *, orders: str = "3,4,5,6") -> Evidence:
    """The same for branch points of several orders."""
    return not_approximable(setting, orders=orders)


def area_bound(setting: Setting, *, power: int = 1) -> Evidence:
    """Whether the squared L^2 norm is at most area^power times the squared largest value.

    For three values on sets of any areas, 4 among them.
    """
    weights = (sp.Integer(4), *sp.symbols("w1:3", positive=True))
    largest = sp.Symbol("M", positive=True)
    smaller = [largest / (1 + x) for x in sp.symbols("x1:4", positive=True)]
    area = sp.Add(*weights)
    norm = sp.Add(*(w * a**2 for w, a in zip(weights, smaller, strict=True)))
    return positivity(
        setting,
        {"area max^2 - norm^2": sp.cancel(area**power * largest**2 - norm)},
        shown="||f||_2^2 <= area ||f||_oo^2 on sets of finite area, so uniform convergence of "
        "second derivatives gives convergence in L^2 on compact sets",
    )


def branch_condition(setting: Setting, *, least: int = 2, factor: int = 1) -> Evidence:
    """Whether the condition on J picks the orders m > 2, for m = 2 to 7."""
    del setting
    for m in range(2, 8):
        index = star_saddle.winding_number(star_saddle.regular_star(m))
        claimed = printed.is_branch_point(index, least=least, factor=factor)
        if claimed is not (m > 2):
            return statement(
                False, shown="", witness=f"m = {m}: J = {index}, the condition gives {claimed}"
            )
    return statement(True, shown="J = 1 - m for m = 2 to 7: m > 2 exactly if -J >= 2", witness="-")


def mollified(setting: Setting, *, exponent: str = "2") -> Evidence:
    """Error in the second derivatives, in L^exponent, of averaging over windows of width 2 h.

    Across a ray of the star the second form jumps from -1/2 to 1/2 times the jump; the average is
    the ramp s/h. The 3-saddle of regular sectors.
    """
    del setting
    angles = star_saddle.regular_star(3)
    jump = star_saddle.hessian_jump(angles, 1)
    if exponent == "oo":
        left = sp.Abs(jump) / 2
    else:
        p = sp.Integer(exponent)
        left = (2 * sp.integrate((sp.Abs(jump) / 2 * (1 - S / H)) ** p, (S, 0, H))) ** (1 / p)
    limit = sp.limit(left, H, 0, "+")
    return statement(
        bool(limit == 0),
        shown="the averages are C^2 (smooth for a smooth kernel) and their second derivatives "
        "converge in L^2 with order 1/2 in the width; they are no isometries",
        witness=f"the error tends to {limit} in L^{exponent}",
    )


def flat_limit(setting: Setting, *, exponent: str = "oo", curvature: str = "1") -> Evidence:
    """Least error in L^exponent of continuous second forms for the plane joined to a cylinder.

    The strip (x(s), t, z(s)), x' = cos a, z' = sin a, with a = 0 for s < 0, a = curvature * s for
    s > 0: a C^{1,1} isometry of the plane whose second form jumps. In L^oo a continuous function is
    at least half of the jump away; in L^p its ramps of width h are isometric strips of one kind.
    """
    a = sp.Function("a")(S)
    metric = identities(
        setting,
        {"speed": sp.cos(a) ** 2 + sp.sin(a) ** 2 - 1},
        shown="every such strip is an isometry of the plane",
    )
    jump = sp.Rational(curvature)
    if exponent == "oo":
        left = jump / 2
    else:
        p = sp.Integer(exponent)
        left = sp.integrate((jump * (1 - S / H)) ** p, (S, 0, H)) ** (1 / p)
    limit = sp.limit(left, H, 0, "+")
    close = statement(
        bool(limit == 0),
        shown="limit",
        witness=f"plane joined to a cylinder of radius 1/{curvature}: h = 0 on one side, "
        f"{curvature} on the other, and any continuous second form is at least {limit} away",
    )
    return combined(
        {"isometry": metric, "limit": close},
        shown="ramps of width h in place of the step are C^2 isometries with curvatures at most "
        "the cylinder's, and converge to the joined strip in W^{2,2}",
    )


def unsmooth(setting: Setting, *, second: str = "1/2", first: str = "1/3") -> Evidence:
    """Whether four sectors with index -1 have corners in both curves and a jumping second form."""
    del setting
    rest = 2 - sp.Rational(first) - sp.Rational(second)
    third = sp.Rational(2, 3)
    angles = _star((first, second, str(third), str(rest - third)))
    turns = {
        "alpha_1 + alpha_2 - pi": sp.simplify(angles[0] + angles[1] - sp.pi),
        "alpha_2 + alpha_3 - pi": sp.simplify(angles[1] + angles[2] - sp.pi),
    }
    jumps = [star_saddle.hessian_jump(angles, i) for i in range(4)]
    index = star_saddle.winding_number(angles)
    straight = [name for name, turn in turns.items() if turn == 0]
    smooth = [i for i, jump in enumerate(jumps) if jump == 0]
    return statement(
        bool(index == -1 and not straight and not smooth),
        shown="sectors pi/3, pi/2, 2 pi/3, pi/2: index -1, both curves turn by pi/6 at p, and the "
        "second form at p is a different one in each sector, so the surface is not C^2",
        witness=f"index {index}, straight {straight}, rays without a jump {smooth}",
    )


def corners(setting: Setting, *, add: str = "0") -> Evidence:
    """Tangents on both sides of p of the curves through it: opposite only if two angles make pi."""
    angles = sp.symbols("alpha1:5", positive=True)
    beta = [sp.Add(*angles[:i]) for i in range(4)]
    extra = sp.Rational(add)
    residuals = {}
    for name, i in (("u", 0), ("v", 1)):
        first, second = (star_saddle.direction(beta[i + j]) for j in (0, 2))
        turn = angles[i] + angles[i + 1] - sp.pi + extra
        residuals[f"cosine, gamma_{name}"] = first.dot(-second) - sp.cos(turn)
        residuals[f"sine, gamma_{name}"] = (
            first[0] * -second[1] + first[1] * second[0] - sp.sin(turn)
        )
    return identities(
        setting,
        residuals,
        shown="gamma_u turns by alpha_1 + alpha_2 - pi at p and gamma_v by alpha_2 + alpha_3 - pi: "
        "they have a tangent there only if these vanish",
    )


def smoothed_angle(setting: Setting, *, mixed: int = 1) -> Evidence:
    """The angle of the smoothed net in first order lies between the four angles at p.

    phi = beta - alpha with alpha, beta turning monotonically from their values on one side of p to
    those on the other: s, t in [0, 1] are the shares of the turning that are done.
    """
    s, t = sp.symbols("s t", real=True)
    a = sp.symbols("a0 a1", real=True)
    b = sp.symbols("b0 b1", real=True)
    phi = b[0] + t * (b[1] - b[0]) - a[0] - s * (a[1] - a[0])
    shares = {(0, 0): (1 - s) * (1 - t), (0, 1): (1 - s) * t, (1, 0): s * (1 - t), (1, 1): s * t}
    mean = sp.Add(*(mixed**i * w * (b[j] - a[i]) for (i, j), w in shares.items()))
    return identities(
        setting,
        {"phi minus the mean of the four angles": sp.expand(phi - mean)},
        shown="phi is a mean of the four angles at p with weights >= 0, so it stays between the "
        "least and the largest, in (0, pi); the corrections are at most |u v|",
    )


def smoothed_curves(setting: Setting, *, order: int = 1, percent: int = 100) -> Evidence:
    """Order in the window h of the distance of the smoothed curve from that with a corner.

    percent: turning of the smoothed curve, in percent of the corner's.
    """
    del setting
    with mp.workdps(30):
        turning, half = mp.pi / 6, mp.mpf(1) / 2
        levels = [mp.mpf(2) ** -k for k in (4, 5, 6, 7, 8)]
        errors = []
        for h in levels:
            worst = mp.mpf(0)
            for torsion in (1, -1):
                _, end = smoothed_corner.cornered(turning, half, torsion=torsion)
                _, other = smoothed_corner.smoothed(
                    turning * percent / 100, half, h, torsion=torsion
                )
                worst = max(worst, mp.norm(end - other))
            errors.append(worst)
        return observed_order(
            levels, errors, order, digits=25, shown="distance of curve and frame at the end in h"
        )


def normal_reverses(setting: Setting, *, second_sign: int = -1) -> Evidence:
    """N_u x N_v from the Lelieuvre equations alone, for r_u and r_v at right angles to N.

    second_sign: sign in N_v = -N x r_v.
    """
    normal = sp.Matrix([0, 0, 1])
    r_u, r_v = (sp.Matrix([*sp.symbols(f"{n}1:3", real=True), 0]) for n in "pq")
    n_u, n_v = normal.cross(r_u), second_sign * normal.cross(r_v)
    residuals = {"N_u x N_v + r_u x r_v": list(n_u.cross(n_v) + r_u.cross(r_v))}
    for sigma in (1, -1):
        net = asymptotic_net.general_net(sigma)
        turned = net.calculus.cross(net.d(net.normal, "u"), net.d(net.normal, "v"))
        residuals[f"any smooth net, sigma = {sigma:+d}"] = list(
            added(turned, net.calculus.cross(net.r_u, net.r_v))
        )
    return identities(
        setting,
        residuals,
        shown="first derivatives alone give N_u x N_v = -r_u x r_v, not 0 on an immersion: N is a "
        "local homeomorphism that reverses orientation, so J = -1 everywhere",
    )
