"""Growth laws of the tree of branch points: areas, numbers, depth (end of section 5.1)."""

from typing import Any

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.positivity import positivity
from checks.printed import branch_tree as printed
from theory import branching, hyperbolic_plane

ROOT = sp.Symbol("q", positive=True)
RADIUS = ROOT**2
"""Radius R as the square of q = sqrt(R)."""

DAUGHTERS = 3
"""Most daughters of a branch point in the algorithm (5.1.at-most-three-daughters)."""


def _area(radius: Any) -> Any:
    r = sp.Symbol("r", positive=True)
    return hyperbolic_plane.area(r).rewrite(sp.exp).subs(r, radius)


def _comparable(quotient: Any, *, what: str) -> Evidence:
    """Whether the quotient has a limit, neither 0 nor infinite, as R tends to infinity."""
    limit = sp.limit(quotient, ROOT, sp.oo)
    return statement(
        bool(limit.is_finite) and limit != 0,
        shown=f"{what} tends to {limit}",
        witness=f"{what} tends to {limit} as R grows",
    )


def _closed_area(setting: Setting) -> Evidence:
    r = sp.Symbol("r", positive=True)
    closed = sp.pi * sp.exp(r) * (1 - sp.exp(-r)) ** 2
    return identities(setting, {"area": _area(r) - closed}, shown="pi e^R (1 - e^-R)^2")


def disk_area(setting: Setting, *, rate: str = "1") -> Evidence:
    """Area of a disk, integrated in the disk model, over what it is said to scale like."""
    q = ROOT
    quotient = sp.expand(_area(q) / printed.disk_area(q, rate=rate))
    return combined(
        {
            "limit": _comparable(quotient, what="area/exp(rate R)"),
            "closed form": _closed_area(setting),
        },
        shown="the area is pi e^R (1 - e^-R)^2, which over e^R increases to pi",
    )


def free_region(
    setting: Setting,
    *,
    power: str = "1/2",
    patch: str = "1",
    branched: str = "1/2",
    constants: str = "kept",
) -> Evidence:
    """Whether (e2) on a free disk of the size named exceeds what (ebs) allows.

    (e2): log E >= r^patch/C_1 on a free disk of radius r; (ebs): log E <= C_2 R^branched. constants
    kept: r = C_1 C_2 free_size; else free_size alone.
    """
    first, second, w = sp.symbols("C_1 C_2 w", positive=True)
    size = printed.free_size(RADIUS, power=power) * (1 + w)
    size *= first * second if constants == "kept" else 1
    least = size ** sp.Rational(patch) / first
    most = second * RADIUS ** sp.Rational(branched)
    excess = sp.cancel((least - most) / second)
    return combined(
        {
            "radius C_1 C_2 sqrt R": identities(
                setting, {"log E by (e2) minus log E by (ebs)": excess.subs(w, 0)}, shown=""
            ),
            "larger radii": positivity(
                setting, {"log E by (e2) minus log E by (ebs)": excess}, shown=""
            ),
        },
        shown="on a disk free of branch points of radius above C_1 C_2 sqrt R, (e2) and the upper "
        "half of (ebs) contradict each other",
    )


def free_area(setting: Setting, *, power: str = "1/2") -> Evidence:
    """Logarithm of the area of a disk of radius k sqrt(R), k > 0 any constant, over the exponent.

    The printed sign compares logarithms up to a factor: k is C_1 C_2 of the previous step.
    """
    k = sp.Symbol("k", positive=True)
    exponent = printed.free_area_exponent(RADIUS, power=power)
    r = k * ROOT
    # log(area) = r + log(pi) + 2 log(1 - e^-r): the closed form of _closed_area.
    logarithm = r + sp.log(sp.pi) + 2 * sp.log(1 - sp.exp(-r))
    return combined(
        {
            "limit": _comparable(logarithm / exponent, what="log(area)/exponent"),
            "closed form": _closed_area(setting),
        },
        shown="log area = k sqrt R + log pi + 2 log(1 - e^(-k sqrt R)) <= k sqrt R + log pi",
    )


def free_area_order(setting: Setting, *, constant: int = 1) -> Evidence:
    """Area of a disk of radius constant * sqrt(R) over exp(sqrt R)."""
    exponent = printed.free_area_exponent(RADIUS)
    quotient = sp.expand(_area(constant * ROOT) / sp.exp(exponent))
    return combined(
        {"limit": _comparable(quotient, what=f"area({constant} sqrt R)/exp(sqrt R)")},
        shown="where the constant in front of sqrt R is 1 the area is of order exp(sqrt R)",
    )


def number(
    setting: Setting, *, factor: str = "1", power: str = "1/2", spread: str = "even"
) -> Evidence:
    """Number of branch points over what it is said to scale like.

    spread: `even`, one for each part of the area of a disk of radius sqrt(R); `none`, as few as
    suffice for every disk of radius sqrt(R) inside B_R to hold one: disks of that radius about
    them then cover B_(R - sqrt R).
    """
    del setting
    covered = RADIUS if spread == "even" else RADIUS - ROOT
    quotient = _area(covered) / _area(ROOT)
    claimed = sp.exp(printed.number_exponent(RADIUS, factor=factor, power=power))
    return combined(
        {"limit": _comparable(sp.simplify(quotient / claimed), what="number/claimed")},
        shown="area(R)/area(sqrt R) = exp(R - sqrt R) ((1 - e^-R)/(1 - e^-sqrt R))^2",
    )


def fewest_number(setting: Setting, *, factor: str = "2") -> Evidence:
    """Least number of branch points that free disks alone enforce, over exp(R - factor sqrt R)."""
    return number(setting, factor=factor, spread="none")


def generations(setting: Setting, *, most: int = 3, fewest: int = 2) -> Evidence:
    """Growth of the number of nodes with the generations, at most three daughters each.

    fewest: daughters that each has at least, but for those of the last generation.
    """
    del setting
    n = sp.Symbol("n", integer=True, positive=True)
    base, slowest = printed.generation_base(most=most), branching.rate(fewest)
    bound = sp.limit(branching.nodes(DAUGHTERS, n) / sp.Integer(base) ** n, n, sp.oo)
    return combined(
        {
            "at least": statement(
                slowest > 0,
                shown="",
                witness=f"with {fewest} daughter each, {branching.nodes(fewest, n)} branch points "
                "in n generations: rate 0",
            ),
            "at most": statement(
                bool(bound.is_finite) and bound > 0,
                shown="",
                witness=f"the largest number over {base}^n tends to {bound}",
            ),
        },
        shown="at most (3^n - 1)/2 branch points in n generations, at least 2^n - 1 where each has "
        "two daughters or more: the rate is between log 2 and log 3",
    )


def depth(
    setting: Setting, *, factor: str = "1", power: str = "1/2", daughters: str = "2 3"
) -> Evidence:
    """Depth n of a tree of exp(R - sqrt R) nodes against the printed one, for 2 and 3 daughters.

    n log(daughters) minus the printed depth must stay bounded; the printed maximum is 0 exactly
    for R <= 1.
    """
    w = sp.Symbol("w", positive=True)
    claimed = printed.cut_depth(RADIUS, factor=factor, power=power)
    count = sp.exp(printed.number_exponent(RADIUS))
    n = sp.Symbol("n", integer=True, positive=True)
    parts = {}
    for m in map(int, daughters.split()):
        power_of_m = sp.Dummy("p", positive=True)
        total = sp.expand(branching.nodes(m, n)).subs(sp.Integer(m) ** n, power_of_m)
        (reached,) = sp.solve(sp.Eq(total, count), power_of_m)
        excess = sp.limit(sp.expand(reached / sp.exp(claimed)), ROOT, sp.oo)
        parts[f"{m} daughters"] = statement(
            bool(excess.is_finite) and excess != 0,
            shown="",
            witness=f"{m}^n over exp of the printed depth tends to {excess}",
        )
    parts["zero below 1"] = positivity(
        setting,
        {
            "R > 1": claimed.subs(ROOT, 1 + w),
            "R < 1": -sp.cancel(claimed.subs(ROOT, 1 / (1 + w))),
        },
        shown="",
    )
    return combined(
        parts,
        shown="n log 3 (or n log 2) differs from R - sqrt R by a bounded term; R - sqrt R < 0 just "
        "for R < 1",
    )


def slope(setting: Setting, *, factor: str = "1", power: str = "1/2") -> Evidence:
    """First and second derivative of R - sqrt(R) for R > 1, and their limits."""
    r, w = sp.symbols("r w", positive=True)
    curve = printed.cut_depth(r, factor=factor, power=power)
    first, second = sp.diff(curve, r), sp.diff(curve, r, 2)
    limits = [sp.limit(e, r, sp.oo) for e in (curve / r, first, second)]
    at = (1 + w) ** 2
    signs = {
        "slope": sp.powdenest(first.subs(r, at), force=True),
        "its increase": sp.powdenest(second.subs(r, at), force=True),
        "1 - slope": 1 - sp.powdenest(first.subs(r, at), force=True),
    }
    return combined(
        {
            "signs": positivity(setting, signs, shown=""),
            "limits": statement(
                limits == [1, 1, 0], shown="", witness=f"curve/R and its slopes tend to {limits}"
            ),
        },
        shown="the slope 1 - 1/(2 sqrt R) increases from 1/2 at R = 1 to 1, at the rate "
        "R^(-3/2)/4, which tends to 0; (R - sqrt R)/R tends to 1",
    )
