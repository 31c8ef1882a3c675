"""The ramification index of the normal map: definition, sign, invariance, graphs (section 3.3)."""

from typing import Any

import sympy as sp
from flint import arb, fmpq

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import normal_map as printed
from checks.verify.front_index import front_indices
from theory import star_saddle
from theory.polynomial_graph import PolynomialGraph, circle, real_power
from theory.vectors import Vector, cross, dot
from theory.winding import X, Y, winding_by_arcs, winding_by_zeros

_POLE: Vector = (arb(0), arb(0), arb(1))
_RADIUS = sp.Rational(1, 10)
#: An isolated zero of the gradient at the origin, of known or unknown index.
SADDLES: dict[str, Any] = {
    "x^2 - y^2": X**2 - Y**2,
    "3 x y - y^2 + x^3": 3 * X * Y - Y**2 + X**3,
    "Re z^3": real_power(3),
    "Re z^3 + x^4 - 2 y^5": real_power(3) + X**4 - 2 * Y**5,
    "Re z^4": real_power(4),
    "Re z^5 - x^6/3": real_power(5) - X**6 / 3,
}


def ball_index(graph: PolynomialGraph, *, turns: int = 1, radius: Any = _RADIUS) -> int:
    """Winding number of x_perp along the circle in the tangent plane at 0, in balls."""
    size = fmpq(int(radius.p), int(radius.q))

    def loop(t: arb) -> tuple[arb, arb]:
        part = printed.tangential_part(_POLE, graph.normal(*circle(t, size, turns=turns)))
        return part[0], part[1]

    return winding_by_arcs(loop)


def _meets_pole(graph: PolynomialGraph) -> bool:
    """Whether the normal certainly is that of p at a point of an axis, off the origin."""
    return any(
        all(entry.subs({X: x, Y: y}) == 0 for entry in graph.gradient)
        for x, y in ((_RADIUS, 0), (0, _RADIUS), (-_RADIUS, 0), (0, -_RADIUS))
    )


def at_samples(wrong: list[str], *, tried: int, shown: str) -> Evidence:
    """Evidence from degrees decided in balls, at samples: only a refutation is certified.

    wrong: what does not agree, in words.
    """
    return Evidence(
        outcome="fail" if wrong else "pass",
        grade="certified" if wrong else "numeric",
        shown=shown,
        tried=tried,
        met=tried,
        witness="; ".join(wrong),
    )


def ramification_index(setting: Setting, *, turns: int = 1, refused: str = "x**2") -> Evidence:
    """Definition (def:Jp) on graphs, its degree in balls against the zeros of the gradient.

    turns: how often the curve goes around p; refused: a height whose normal must not be admitted,
    for N(x) = N(p) on a line.
    """
    wrong = []
    for name, height in SADDLES.items():
        graph = PolynomialGraph(height=height)
        found = ball_index(graph, turns=turns)
        down = (-graph.gradient[0], -graph.gradient[1])
        if found != (expected := winding_by_zeros(down, 0, _RADIUS)) or _meets_pole(graph):
            wrong.append(f"w = {name}: degree {found}, by zeros {expected}")
    near_miss = sp.sympify(refused, locals={"x": X, "y": Y})
    if not _meets_pole(PolynomialGraph(height=near_miss)):
        wrong.append(f"w = {refused} is not refused")
    return at_samples(
        wrong,
        tried=len(SADDLES),
        shown="the degree along one circuit of p agrees, for six graphs, with the zeros of the "
        "gradient inside; the parabolic cylinder, where N(x) = N(p) on a line, is refused",
    )


def equator_retraction(setting: Setting, *, sign: int = -1, power: int = 1) -> Evidence:
    """Retraction to the equator: unit, tangential, the identity there, undefined at the poles."""
    a, b, c, s = sp.symbols("a b c s", real=True)
    pole: Vector = (sp.sin(a) * sp.cos(b), sp.sin(a) * sp.sin(b), sp.cos(a))
    east: Vector = (sp.cos(a) * sp.cos(b), sp.cos(a) * sp.sin(b), -sp.sin(a))
    north: Vector = (-sp.sin(b), sp.cos(b), sp.Integer(0))
    on_equator = tuple(sp.cos(c) * e + sp.sin(c) * n for e, n in zip(east, north, strict=True))
    size = sp.sqrt(1 - s**2)
    x = tuple(s * p + size * e for p, e in zip(pole, on_equator, strict=True))
    image = printed.retraction(pole, x, sign=sign, power=power)
    part = printed.tangential_part(pole, x, sign=sign)
    kept = printed.tangential_part(pole, on_equator, sign=sign)
    return identities(
        setting,
        {
            "|x_perp|^2 - (1 - <N(p), x>^2)": dot(part, part) - (1 - s**2),
            "|pi|^2 - 1": dot(image, image) - 1,
            "N(p) . pi": dot(pole, part),
            "x_perp - x on the equator, where |x| = 1": [
                k - e for k, e in zip(kept, on_equator, strict=True)
            ],
        },
        where=(1 - s**2,),
        shown="for x = <N(p), x> N(p) + sqrt(1 - <N(p), x>^2) e, e on the equator, x_perp has the "
        "length of the second term, so it vanishes at the two poles only; pi is a unit tangent "
        "vector and the identity on the equator",
    )


_CIRCLES: tuple[tuple[Any, Any, bool], ...] = (
    (sp.Integer(0), sp.Rational(1, 2), True),
    (sp.Rational(1, 4) + sp.I / 3, sp.Integer(1), True),
    (-sp.Rational(2, 3), sp.Rational(3, 4), True),
    (sp.Rational(3, 2), sp.Integer(1), False),
    (sp.I * 2, sp.Rational(1, 3), False),
)


def well_defined(
    setting: Setting, *, around: bool = True, sense: int = 1, hole: bool = False
) -> Evidence:
    """Degrees along circles in U, for the graphs of Re z^2, Re z^3, Re z^4 over the plane.

    around: only circles that bound a disk in V with p inside; sense: 1 or -1 for that sense only,
    0 for both; hole: V leaves out another point where N is N(p), and the circle goes around both.
    """
    wrong = []
    for order in (2, 3, 4):
        gradient = PolynomialGraph(height=real_power(order)).gradient
        kept = [(c, r) for c, r, inside in _CIRCLES if inside or not around]
        found = {
            (center, radius, way): way * winding_by_zeros(gradient, center, radius)
            for center, radius in kept
            for way in ((1, -1) if sense == 0 else (sense,))
        }
        if hole:
            factor = real_power(order + 1) / (order + 1) - real_power(order) / order
            pair = PolynomialGraph(height=factor).gradient
            found |= {
                (0, radius, 1): winding_by_zeros(pair, 0, radius)
                for radius in (sp.Rational(1, 2), sp.Integer(2))
            }
        expected = 1 - order
        if bad := [key for key, value in found.items() if value != expected]:
            center, radius, way = bad[0]
            told = "counter-clockwise" if way > 0 else "clockwise"
            wrong.append(
                f"Re z^{order}: the circle of centre {center} and radius {radius}, {told}, gives "
                f"{found[bad[0]]}, a small circle about p gives {expected}"
            )
    return at_samples(
        wrong,
        tried=3 * len(_CIRCLES),
        shown="along circles about p that bound a disk in V the degree does not depend on the "
        "circle, as the zeros of the gradient show",
    )


def negative_curvature(setting: Setting, *, curvature: int = -1, sense: int = -1) -> Evidence:
    """Turning of the normal around a point, from the sign of the curvature.

    For a quadratic form of determinant D the gradient on the circle turns at the rate D/|H e|^2;
    over a star every sector has D = -1. Three fronts at three points each, in balls.
    """
    a, b, c, t = sp.symbols("a b c t", real=True)
    hessian = sp.Matrix([[a, b], [b, c]])
    e = sp.Matrix([sp.cos(t), sp.sin(t)])
    g = hessian * e
    rate = (g[0] * sp.diff(g[1], t) - g[1] * sp.diff(g[0], t)) / (g.T * g)[0, 0]
    identity = identities(
        setting,
        {"d arg(grad w)/dt - det H/|H e|^2": rate - hessian.det() / (g.T * g)[0, 0]},
        shown="the gradient turns with the sign of det H",
    )
    heights = {-1: (X**2 - Y**2, 3 * X * Y + Y**2), 1: (X**2 + Y**2, 3 * X**2 + X * Y + Y**2)}
    indices = {f"w = {w}": ball_index(PolynomialGraph(height=w)) for w in heights[curvature]}
    if curvature < 0:
        indices |= front_indices()
        indices |= {
            f"regular star of order {m}": int(
                star_saddle.winding_number(star_saddle.regular_star(m))
            )
            for m in (2, 3, 4, 5)
        }
    wrong = [f"{name}: J_p = {j}" for name, j in indices.items() if not j * sense > 0]
    return combined(
        {
            "rate": identity,
            "indices": at_samples(wrong, tried=len(indices), shown="indices"),
        },
        shown="where the Hessian has a negative determinant the gradient turns clockwise at every "
        "moment of the circuit; J_p < 0 on saddles, on stars, and on the pseudosphere, Dini's and "
        "Kuen's surface at nine points",
    )


def star_index(order: int) -> int:
    """Winding number of the gradient of the quadratic saddle over the regular star."""
    return int(star_saddle.winding_number(star_saddle.regular_star(order)))


def motion_invariant(setting: Setting, *, reflected_normal: int = -1) -> Evidence:
    """J_p under a rotation Q about any axis through the origin and under its product with -1.

    The normal of Q y is det(Q) Q N, from the cross product; reflected_normal: the factor of Q N
    where det Q = -1. The index is kept if the equators, oriented by N(p), are turned into each
    other: pi' (N') = f Q pi(N) and the frame (N', f Q a, f Q b) is right-handed, f the factor.
    """
    n, x = sp.symbols("n1:4", real=True), sp.symbols("x1:4", real=True)
    w, p, q, r = sp.symbols("w p q r", real=True)
    size = w**2 + p**2 + q**2 + r**2
    turn = sp.Matrix([
        [w**2 + p**2 - q**2 - r**2, 2 * (p * q - w * r), 2 * (p * r + w * q)],
        [2 * (p * q + w * r), w**2 - p**2 + q**2 - r**2, 2 * (q * r - w * p)],
        [2 * (p * r - w * q), 2 * (q * r + w * p), w**2 - p**2 - q**2 + r**2],
    ]) / size  # fmt: skip
    residuals: dict[str, Any] = {"Q^T Q - 1": list(turn.T * turn - sp.eye(3))}
    normal = cross(n, x)
    for name, motion, factor in (("Q", turn, 1), ("-Q", -turn, reflected_normal)):
        moved_n, moved_x = (tuple(factor * motion * sp.Matrix(a)) for a in (n, x))
        part = printed.tangential_part(moved_n, moved_x)
        expected = factor * motion * sp.Matrix(printed.tangential_part(n, x))
        residuals[f"x_perp' - f Q x_perp under {name}"] = list(sp.Matrix(part) - expected)
        residuals[f"handedness under {name}"] = (factor * motion).det() - 1
        carried = cross(tuple(motion * sp.Matrix(n)), tuple(motion * sp.Matrix(x)))
        residuals[f"cross product under {name}"] = list(
            sp.Matrix(carried) - factor * motion * sp.Matrix(normal)
        )
    counts = {
        angles: star_saddle.count_sides(angles)
        for angles in (star_saddle.regular_star(2), star_saddle.regular_star(3))
    }
    kept = statement(
        all(above == below for above, below in counts.values()),
        shown="a motion keeps or exchanges the sides",
        witness=f"sectors above and below: {list(counts.values())}",
    )
    return combined(
        {"index": identities(setting, residuals, shown="the retraction commutes with motions"),
         "order": kept},
        shown="N' = det(Q) Q N, and det(Q) Q is a rotation, also for a reflection: it carries one "
        "retraction and its oriented equator to the other, so J_p is the same; m_p counts the "
        "sectors on one side of the tangent plane, as many as on the other",
    )  # fmt: skip


def branch_index(
    setting: Setting, *, threshold: int = 1, absolute: bool = True, least: int = 2
) -> Evidence:
    """Line 671: |J_p| > 1 exactly where m_p is not 2, for J_p of stars and for every order.

    least: the least order that angles below pi with sum 2 pi allow.
    """
    wrong = []
    for order in range(least, 9):
        found = star_index(order)
        if printed.is_branch_point(found, threshold=threshold, absolute=absolute) != (order != 2):
            wrong.append(f"m_p = {order}, J_p = {found}")
    m = sp.Symbol("m", integer=True, positive=True)
    beyond = identities(
        setting, {"|1 - (2 + m)| - 1 - m": sp.Abs(1 - (2 + m)) - 1 - m}, shown="orders above 2"
    )
    return combined(
        {
            "stars": statement(
                not wrong, shown="stars", witness=f"decided otherwise than by m_p: {wrong}"
            ),
            "all orders": beyond,
        },
        shown="|J_p| - 1 = m_p - 2 for all m_p > 2, and J_p = -1 for m_p = 2; verified on the "
        "stars of orders 2 to 8",
    )
