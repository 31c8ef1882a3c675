"""The isometry problem, its exterior system, saddles, and what is smooth at a branch point."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import branched_surfaces as printed
from checks.zero import vanishes
from theory import star_saddle
from theory.curvature import first_form, intrinsic_curvature, second_form, unit_normal
from theory.ridge_functions import Ridge, has_second, is_c1
from theory.sectors import count_sectors
from theory.vectors import Vector, derivative, scaled

X, Y = sp.symbols("x y", real=True)
F = sp.Function("f")(X, Y)
GRAPH: Vector = (X, Y, F)

_FLAT = sp.eye(2)
_PLANE: Vector = (X, Y, sp.Integer(0))
_BENT: Vector = (sp.sin(X), Y, 1 - sp.cos(X))
_FOLDED: Vector = (-X, Y, sp.Integer(0))
_STRETCHED: Vector = (2 * X, 2 * Y, sp.Integer(0))
_MAPS: tuple[tuple[str, Vector, Vector, bool], ...] = (
    ("the plane", _PLANE, _PLANE, True),
    ("a half-plane continued by a cylinder, of class C^{1,1}", _PLANE, _BENT, True),
    ("a plane folded flat along a line", _PLANE, _FOLDED, False),
    ("a dilation of the plane", _STRETCHED, _STRETCHED, False),
)


def isometry_problem(setting: Setting, *, isometric: bool = True, sobolev: bool = True) -> Evidence:
    """Sort maps of the flat plane, smooth on both sides of x = 0, into solutions and others."""
    wrong = []
    for name, left, right, solves in _MAPS:
        gaps = [
            vanish
            for side in (left, right)
            for vanish in map(_zero_or_one, first_form(side, (X, Y)) - _FLAT)
        ]
        jump = any(
            not vanishes((a - b).subs(X, 0))
            for a, b in zip(derivative(left, X), derivative(right, X), strict=True)
        )
        decided = printed.is_w22_isometry(gaps, jump, isometric=isometric, sobolev=sobolev)
        if decided != solves:
            wrong.append(name)
    return statement(
        not wrong,
        shown="a smooth isometry and one of class C^{1,1} are accepted; a fold, isometric almost "
        "everywhere, and a dilation are refused",
        witness=f"decided wrongly: {', '.join(wrong)}",
    )


def _zero_or_one(expr: Any) -> int:
    return 0 if vanishes(expr) else 1


def gauss_map(setting: Setting, *, orientation_preserving: bool = True, order: int = 1) -> Evidence:
    """Compare the normal in several coordinate systems.

    orientation_preserving: whether all are of one orientation; else two coordinates are exchanged.
    """
    a: Vector = sp.symbols("a1:4", real=True)
    b: Vector = sp.symbols("b1:4", real=True)
    normal = printed.gauss_normal(a, b, order=order)
    changes = [((2, 1), (1, 1)), ((1, 0), (-1, 3))]
    changes += [] if orientation_preserving else [((0, 1), (1, 0))]
    residuals: dict[str, Any] = {
        "N . N - 1": sum(entry**2 for entry in normal) - 1,
        "N . d_1 y": sum(n * e for n, e in zip(normal, a, strict=True)),
        "N . d_2 y": sum(n * e for n, e in zip(normal, b, strict=True)),
    }
    for (p, q), (r, s) in changes:
        first = tuple(p * i + q * j for i, j in zip(a, b, strict=True))
        second = tuple(r * i + s * j for i, j in zip(a, b, strict=True))
        other = printed.gauss_normal(first, second, order=order)
        residuals[f"N in coordinates of Jacobian {p * s - q * r}"] = [
            _with_factored_roots(i - j) for i, j in zip(other, normal, strict=True)
        ]
    return identities(
        setting,
        residuals,
        shown="the formula gives a unit normal, the same in coordinates of the same orientation",
    )


def _with_factored_roots(expr: Any) -> Any:
    """Expression with each radicand expanded and factored, so that squares leave the root."""
    half = sp.Rational(1, 2)
    return expr.replace(
        lambda e: e.is_Pow and abs(e.exp) == half,
        lambda e: sp.Pow(sp.factor(sp.expand(e.base)), e.exp),
    )


def exterior_system(
    setting: Setting,
    *,
    converse: bool = True,
    sign: int = 1,
    area_power: int = 1,
    stretch: int = 2,
) -> Evidence:
    """Exterior system on an arbitrary graph, and on its dilation by the factor stretch.

    kappa and dA are those of the graph's metric, by its Riemann tensor. converse: whether the maps
    that solve the system must be isometries, as an equivalence says.
    """
    metric = first_form(GRAPH, (X, Y))
    kappa = intrinsic_curvature(metric, (X, Y))
    normal = unit_normal(GRAPH, (X, Y))
    residuals: dict[str, Any] = {}
    for factor in (1, stretch) if converse else (1,):
        surface = scaled(factor, GRAPH)
        steps = (derivative(surface, X), derivative(surface, Y))
        system = printed.exterior_system(
            normal,
            steps,
            (derivative(normal, X), derivative(normal, Y)),
            kappa,
            sp.sqrt(metric.det()),
            sign=sign,
            area_power=area_power,
        )
        residuals |= {f"{name} for the map {factor} y": value for name, value in system.items()}
        residuals[f"metric of {factor} y minus g"] = list(first_form(surface, (X, Y)) - metric)
    return identities(
        setting,
        residuals,
        shown="every graph satisfies N . dy = 0 and N^*(d Omega) = kappa dA with the curvature of "
        "its own metric",
    )


def normal_is_c1(setting: Setting, *, halves: int = 5) -> Evidence:
    """Smoothness of the normal of the graph of x |x|^(p-1), p = halves/2."""
    term = Ridge(
        coefficient=sp.Integer(1), direction=(1, 0), power=sp.Rational(halves, 2), odd=True
    )
    height = sp.Function("w")(X)
    normal = unit_normal((X, Y, height), (X, Y))
    slope = sp.Symbol("w1", real=True)
    turning = sp.diff((normal[0] / normal[2]).subs(sp.diff(height, X), slope), slope)
    return statement(
        vanishes(turning + 1) and is_c1([term]) and has_second([term], 0),
        shown="the normal is a smooth invertible function of the gradient; for the C^2 graph of "
        "x |x|^(3/2) it is C^1",
        witness=f"the graph of x |x|^({sp.Rational(halves, 2)} - 1) is not C^2: its normal has the "
        "smoothness of its gradient and is not C^1",
    )


_FORMS = {
    -1: ((1, 0, -1), (2, 3, 4), (0, 1, 3)),
    0: ((1, 2, 4),),
    1: ((1, 0, 1), (2, 1, 1)),
}


def locally_saddle(
    setting: Setting, *, curvature: int = -1, above: int = 2, below: int = 2
) -> Evidence:
    """Second form of a graph from its Gauss curvature, and the sectors of such forms.

    curvature: -1, 0 or 1, the sign of K; sectors of rational forms of that determinant are counted.
    """
    wrong = [
        f"{entries} has {found}"
        for entries in _FORMS[curvature]
        if (found := count_sectors((sp.Integer(entries[0]), entries[1], entries[2])))
        != (above, below)
    ]
    if wrong:
        return statement(
            False, shown="", witness=f"numbers of sectors above and below: {'; '.join(wrong)}"
        )
    metric = first_form(GRAPH, (X, Y))
    form = second_form(GRAPH, (X, Y))
    kappa = intrinsic_curvature(metric, (X, Y))
    return identities(
        setting,
        {"det h - K det g": form.det() - kappa * metric.det()},
        shown="the second form of a graph has the determinant K det g, negative where K < 0; three "
        "such forms, and by Sylvester's law of inertia all of them, have two sectors above and two "
        "below the tangent plane",
    )


def only_c11(setting: Setting, *, order: int = 3) -> Evidence:
    """Gradient and Hessian of the quadratic saddle over a star across its rays.

    The gradient for two neighbouring sectors of arbitrary angles a, b, the Hessian over the
    regular star.
    """
    angles = star_saddle.regular_star(order)
    a, b = sp.symbols("a b", positive=True)
    jumps = [star_saddle.hessian_jump(angles, i) for i in range(len(angles))]
    return combined(
        {
            "gradient": identities(
                setting,
                {
                    "jump of the gradient, angles a, b": star_saddle.gradient_jump((a, b), 1),
                    "on the first ray": star_saddle.gradient_jump(angles, 0),
                },
                shown="",
            ),
            "Hessian": statement(
                any(jump != 0 for jump in jumps),
                shown="",
                witness=f"the star of {len(angles)} equal angles has a continuous Hessian",
            ),
        },
        shown="across its rays the quadratic saddle has a continuous gradient, Lipschitz since "
        "its Hessian takes finitely many values; over the regular star of order 3 that jumps",
    )


def branched_paraboloid(setting: Setting, *, determinant: int = -1, order: int = 3) -> Evidence:
    """Branched hyperbolic paraboloid: a quadratic saddle on each sector of a regular star."""
    angles = star_saddle.regular_star(order)
    residuals: dict[str, Any] = {
        "determinant of the Hessian": [
            star_saddle.sector_hessian(angles, i).det() - determinant for i in range(len(angles))
        ],
        "jump of the gradient": [
            e for i in range(len(angles)) for e in star_saddle.gradient_jump(angles, i)
        ],
        "number of sectors": len(angles) - 6,
    }
    return identities(
        setting,
        residuals,
        shown="on six sectors of angle pi/3 the height is a quadratic form of determinant -1, and "
        "the gradient is continuous: hyperbolic, C^{1,1}, with a branch point",
    )


def singular_set(setting: Setting, *, order: int = 3, isolated: bool = False) -> Evidence:
    """Where the curvature of a branched surface of curvature -1 jumps near its branch point.

    Across ray i the second derivative along the normal jumps by 2 (cot a + cot b), a and b the
    angles of the sectors that meet there: it is continuous where a + b = pi. isolated: whether
    the curvature is claimed to be continuous off the branch point.
    """
    angles = star_saddle.regular_star(order)
    a, b = sp.symbols("a b", positive=True)
    gap = sp.cot(a) + sp.cot(b) - sp.sin(a + b) / (sp.sin(a) * sp.sin(b))
    rays = range(len(angles))
    jumps = [sp.simplify(star_saddle.hessian_jump(angles, i)) for i in rays]
    sums = [2 * (-1) ** i * (sp.cot(angles[i]) + sp.cot(angles[i - 1])) + jumps[i] for i in rays]
    smooth_rays = sum(bool(jump == 0) for jump in jumps)
    wanted = len(angles) if isolated else 0
    return combined(
        {
            "jump": identities(
                setting, {"cot a + cot b": gap, "jump": sums}, shown="jump of the second form"
            ),
            "rays": statement(
                smooth_rays == wanted,
                shown="singular rays",
                witness=f"the second form is continuous across {smooth_rays} of the "
                f"{len(angles)} rays",
            ),
        },
        shown="the jump vanishes on every ray only if neighbouring angles add up to pi, which for "
        "the sum 2 pi of all of them means m = 2: for m = 3 whole curves are singular",
    )
