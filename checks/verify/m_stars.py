"""Identities of stars: directions, pairs of coordinates, dual vectors, asymptotic coordinates.

Ray i at the polar angle beta_i is taken with arbitrary angles to its neighbours. The other side
is found by intersecting lines (Cramer's rule), without the dual vectors of the paper.
"""

from fractions import Fraction
from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import identities, statement
from checks.printed import m_stars as printed
from theory.vectors import Vector, added, cross, dot, scaled

BETA = sp.Symbol("beta", real=True)
#: Angles alpha_i, alpha_(i+1), alpha_(i+2) around the ray i.
ALPHA = dict(enumerate(sp.symbols("alpha_0 alpha_1 alpha_2 alpha_3", positive=True)))
XI, ETA = sp.symbols("xi eta", positive=True)
RAY = 1


def angle(i: int) -> Any:
    """Polar angle beta_i of ray i, for i from 0 to 3, ray 1 being at beta."""
    steps = {0: -ALPHA[1], 1: 0, 2: ALPHA[2], 3: ALPHA[2] + ALPHA[3]}
    return BETA + steps[i]


def ray(i: int) -> Vector:
    """Direction of ray i as printed."""
    return printed.direction(angle(i))


def components(x: Vector, first: Vector, second: Vector) -> tuple[Any, Any]:
    """Coefficients (a, b) of the plane vector x = a first + b second, by Cramer's rule."""
    area = first[0] * second[1] - first[1] * second[0]
    return (
        (x[0] * second[1] - x[1] * second[0]) / area,
        (first[0] * x[1] - first[1] * x[0]) / area,
    )


def gap(a: Any, b: Any) -> Vector:
    """Difference of two vectors."""
    return added(a, scaled(-1, b))


def directions(
    setting: Setting, *, start: int = 0, lag: int = 0, quarter_turns: int = 0, extra: int = 0
) -> Evidence:
    """Unit vectors s_i at the angles beta_i, closing up after 2m = 4, 6, 8; extra: a wider turn."""
    residuals: dict[str, Any] = {}
    for count in (4, 6, 8):
        angles = list(sp.symbols(f"alpha_1:{count}", positive=True))
        angles.append(2 * sp.pi + extra - sum(angles))
        betas = printed.partial_angles(angles, start=start, lag=lag)
        rays = [printed.direction(b, quarter_turns=quarter_turns) for b in (betas[0], betas[-1])]
        residuals[f"s_0 - e_1, {count} rays"] = gap(rays[0], (1, 0, 0))
        residuals[f"beta_2m - 2 pi, {count} rays"] = betas[-1] - 2 * sp.pi
        residuals[f"s_2m - s_0, {count} rays"] = gap(rays[-1], rays[0])
        residuals[f"angle from s_(i-1) to s_i, {count} rays"] = [
            betas[i] - betas[i - 1] - angles[i - 1] for i in range(1, count + 1)
        ]
    first, second = sp.symbols("beta_first beta_second", real=True)
    pair = [printed.direction(b, quarter_turns=quarter_turns) for b in (first, second)]
    residuals["|s|^2 - 1"] = dot(pair[0], pair[0]) - 1
    residuals["sine of the angle of two rays"] = cross(*pair)[2] - sp.sin(second - first)
    return identities(
        setting,
        residuals,
        shown="4, 6 and 8 arbitrary angles of sum 2 pi: unit vectors that begin at e_1, enclose "
        "the given angles and close up",
    )


_DATA = (
    ("six angles pi/3", ("1/3",) * 6, ("1",) * 6, True),
    ("angles 1/2, 1/4, 3/4, 1/2 of pi, four lengths", ("1/2", "1/4", "3/4", "1/2"),
     ("1", "2", "1/3", "5"), True),
    ("eight angles pi/4", ("1/4",) * 8, ("1/2",) * 8, True),
    ("six angles of sum 7 pi/3", ("1/3",) * 5 + ("2/3",), ("1",) * 6, False),
    ("an angle pi", ("1", "1/4", "1/4", "1/2"), ("1",) * 4, False),
    ("an angle 0", ("0", "1/2", "3/4", "3/4"), ("1",) * 4, False),
    ("a length 0", ("1/3",) * 6, ("1",) * 5 + ("0",), False),
    ("five angles", ("2/5",) * 5, ("1",) * 5, False),
    ("three angles 2 pi/3", ("2/3", "2/3", "2/3"), ("1",) * 3, False),
)  # fmt: skip


def definition(
    setting: Setting,
    *,
    whole_turn: bool = True,
    below_pi: bool = True,
    positive: bool = True,
    even: bool = True,
) -> Evidence:
    """Instances of m-stars accepted and near-misses refused (def:m-star)."""
    del setting
    wrong = [
        name
        for name, angles, lengths, member in _DATA
        if printed.is_star(
            [Fraction(a) for a in angles],
            [Fraction(a) for a in lengths],
            whole_turn=whole_turn,
            below_pi=below_pi,
            positive=positive,
            even=even,
        )
        != member
    ]
    return statement(
        not wrong,
        shown="three stars are accepted; a wrong sum, an angle 0 or pi, a length 0 and an odd "
        "number of rays are refused",
        witness=f"decided wrongly: {', '.join(wrong)}",
    )


def cone(setting: Setting, *, first: int = -1, second: int = 0) -> Evidence:
    """Sector (def:sectors) between the rays i - 1 and i, for arbitrary angles."""
    c, d = sp.symbols("c d", positive=True)
    x = printed.sector_point(ray, RAY, c, d, first=first, second=second)
    return identities(
        setting,
        {
            "distance from ray i - 1": cross(ray(RAY - 1), x)[2] - d * sp.sin(ALPHA[RAY]),
            "distance from ray i": cross(x, ray(RAY))[2] - c * sp.sin(ALPHA[RAY]),
        },
        shown="a point with coefficients c, d is at the distance d sin(alpha_i) from ray i - 1 and "
        "c sin(alpha_i) from ray i, on the inner sides: the sector is the parallelogram of the "
        "polar angles from beta_(i-1) to beta_i",
    )


def pair_coordinates(setting: Setting, *, sign: int = -1, behind: int = -1) -> Evidence:
    """The two formulas for x invert to unique coordinates on both sides and agree at eta = 0."""
    ahead = printed.pair_point(ray, RAY, XI, ETA, positive=True)
    back = printed.pair_point(ray, RAY, XI, -ETA, positive=False, sign=sign, behind=behind)
    xi, eta = components(ahead, ray(RAY), ray(RAY + 1))
    xi_back, height = components(back, ray(RAY), ray(RAY - 1))
    on_ray = [
        printed.pair_point(ray, RAY, XI, sp.Integer(0), positive=side, sign=sign, behind=behind)
        for side in (True, False)
    ]
    return identities(
        setting,
        {
            "xi, eta > 0": xi - XI,
            "eta > 0": eta - ETA,
            "xi, eta < 0": xi_back - XI,
            "part along s_(i-1), eta < 0": height - ETA,
            "at eta = 0": gap(on_ray[0], on_ray[1]),
        },
        shown="x determines (xi, eta) on both sides of ray i, the coefficient of s_(i-1) being "
        "-eta >= 0, and the two formulas agree on the ray",
    )


def normal_part(setting: Setting, *, sign: int = -1, opposite: bool = False) -> Evidence:
    """Part normal to ray i of the difference of two points on either side of it.

    sign: of eta in the formula for eta < 0; opposite: whether both points are on the same side.
    """
    a, h, first, second = sp.symbols("a h xi_1 xi_2", positive=True)
    x = printed.pair_point(ray, RAY, first, a, positive=True)
    y = printed.pair_point(ray, RAY, second, -h, positive=False, sign=sign)
    if opposite:
        y = printed.pair_point(ray, RAY, second, h, positive=True)
    stated = a * sp.sin(ALPHA[RAY + 1]) + h * sp.sin(ALPHA[RAY])
    return identities(
        setting,
        {"normal part": cross(ray(RAY), gap(x, y))[2] - stated},
        shown="for eta = a > 0 and eta = -h < 0 the part of x - y normal to the ray is a "
        "sin(alpha_(i+1)) + h sin(alpha_i), at least (a + h) times the lesser sine: both sides add",
    )


def kink(setting: Setting, *, complement: bool = False) -> Evidence:
    """Jump of dx/d(eta) at eta = 0 is s_(i+1) + s_(i-1), of length 2 |cos((a + b)/2)|.

    complement: whether it is claimed to vanish for all angles.
    """
    ahead = printed.pair_point(ray, RAY, XI, ETA, positive=True)
    back = printed.pair_point(ray, RAY, XI, ETA, positive=False)
    jump = tuple(sp.diff(a - b, ETA) for a, b in zip(ahead, back, strict=True))
    squared = jump[0] ** 2 + jump[1] ** 2
    half = (ALPHA[1] + ALPHA[2]) / 2
    claimed = sp.Integer(0) if complement else 4 * sp.cos(half) ** 2
    return identities(
        setting,
        {
            "squared jump": squared - claimed,
            "jump where b = pi - a": [entry.subs(ALPHA[2], sp.pi - ALPHA[1]) for entry in jump],
        },
        shown="across ray i the derivative by eta jumps by a vector of length 2 |cos((alpha_i + "
        "alpha_(i+1))/2)|, which is 0 only where the angles, of sum below 2 pi, add up to pi",
    )


def opposite_rays(setting: Setting, *, plus: bool = False) -> Evidence:
    """The jump is s_(i+1) + s_(i-1): no jump exactly where s_(i+1) = -s_(i-1)."""
    ahead = printed.pair_point(ray, RAY, XI, ETA, positive=True)
    back = printed.pair_point(ray, RAY, XI, ETA, positive=False)
    jump = tuple(sp.diff(a - b, ETA) for a, b in zip(ahead, back, strict=True))
    wanted = added(ray(RAY + 1), scaled(-1 if plus else 1, ray(RAY - 1)))
    return identities(
        setting,
        {"jump - (s_(i+1) + s_(i-1))": [a - b for a, b in zip(jump, wanted, strict=True)]},
        shown="dx/d(eta) jumps by s_(i+1) + s_(i-1) across ray i: the coordinates are smooth there "
        "only if s_(i+1) = -s_(i-1), and then linear",
    )


def smooth_stars(
    setting: Setting, *, order: int = 2, every_ray: bool = True, twice: int = 2
) -> Evidence:
    """Solve alpha_i + alpha_(i+1) = pi for all i with the sum 2 pi, for m = 2, ..., 6.

    every_ray: whether the condition is imposed on every ray, or on the even ones only; order: the
    m that is claimed; twice: pi over the right side, doubled.
    """
    del setting
    found: dict[int, Any] = {}
    for m in range(2, 7):
        angles = sp.symbols(f"alpha_1:{2 * m + 1}")
        equations = [
            angles[i] + angles[(i + 1) % (2 * m)] - sp.pi * sp.Rational(2, twice)
            for i in range(0, 2 * m, 1 if every_ray else 2)
        ]
        solutions = sp.linsolve([*equations, sum(angles) - 2 * sp.pi], angles)
        if solutions:
            found[m] = next(iter(solutions))
    shape = False
    if order in found:
        a = found[order]
        shape = all(a[i] - a[(i + 2) % len(a)] == 0 for i in range(len(a)))
    return statement(
        set(found) == {order} and shape,
        shown="s_(i+1) = -s_(i-1) means alpha_i + alpha_(i+1) = pi; summed over all i it says "
        "2 (2 pi) = 2m pi, so m = 2; the linear system has solutions for m = 2 only among m = 2 to "
        "6, those with alpha_1 + alpha_2 = pi, alpha_1 = alpha_3, alpha_2 = alpha_4",
        witness=f"solutions for m in {sorted(found)}: "
        + "; ".join(f"{m}: {a}" for m, a in found.items()),
    )


def transition(setting: Setting, *, sign: int = -1, exchanged: bool = True) -> Evidence:
    """Coordinates of one point in the pairs i and i + 1, and the change between them."""
    x = printed.pair_point(ray, RAY, XI, ETA, positive=True)
    after, height = components(x, ray(RAY + 1), ray(RAY))
    stated = printed.transition(XI, ETA, sign=sign)
    if not exchanged:
        stated = (stated[1], stated[0])
    return identities(
        setting,
        {"xi_(i+1)": after - stated[0], "eta_(i+1)": -height - stated[1]},
        shown="on the common sector of the pairs i and i + 1, xi_(i+1) = eta_i and "
        "eta_(i+1) = -xi_i",
    )


def transition_smooth(setting: Setting, *, sign: int = -1, power: int = 1) -> Evidence:
    """Change of coordinates: linear, and an isometry of the plane; power: of its first entry."""
    xi, eta = sp.symbols("xi eta", real=True)
    image = sp.Matrix(printed.transition(xi, eta, sign=sign))
    image[0] = image[0] ** power
    jacobian = image.jacobian([xi, eta])
    return identities(
        setting,
        {
            "second derivatives": [sp.diff(e, a, b) for e in image for a in (xi, eta)
                                   for b in (xi, eta)],
            "J^T J - 1": list(jacobian.T * jacobian - sp.eye(2)),
            "det J - 1": jacobian.det() - 1,
        },
        shown="(xi, eta) -> (eta, -xi) is a rotation: linear, smooth, of Lipschitz constant 1",
    )  # fmt: skip
