"""Checks of section 4: angles, degrees and curves in the proof of discrete surgery, exactly."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import spherical_nets as printed
from checks.verify.discrete_lelieuvre import minus
from checks.verify.unit_vectors import circle, corner
from checks.verify.vertex_angles import degree_parity
from discrete.spherical_net import geodesic_curve
from theory.vectors import dot


def deficit(setting: Setting, *, high: str = "3", most: str = "3") -> Evidence:
    """Whether the missing angle is in (0, 3 pi), for every sum in the range of (eq:unramified).

    high: in delta = (high - d) pi - sum; most: the upper bound tested, in pi. Ends of the range,
    delta being linear in the sum, for every d.
    """
    d = sp.Symbol("d", positive=True)
    lower, upper = printed.boundary_range(d)
    ends = [
        sp.simplify(printed.deficit(total, d, high=sp.Rational(high))) for total in (upper, lower)
    ]
    fine = bool(ends[0] >= 0) and bool(ends[1] <= sp.Rational(most))
    parts = {
        "ends": statement(
            fine, shown="", witness=f"delta ranges over ({ends[0]} pi, {ends[1]} pi), d arbitrary"
        )
    }
    alpha = sp.Symbol("alpha", real=True)
    total = sp.Symbol("S", real=True)
    # Three angles alpha make the sum 2 (1 - m) with 2m = d + 2.
    solved = sp.solve(3 * alpha + total - printed.interior_sum((d + 2) / 2), alpha)[0]
    stated = printed.surgery_angle(printed.deficit(total, d, high=sp.Rational(high)))
    parts["closing"] = identities(setting, {"alpha": solved - stated}, shown="")
    return combined(
        parts,
        shown="delta = (3 - d) pi - sum lies in (0, 2 pi), so in (0, 3 pi), for every d and every "
        "sum that (eq:unramified) allows, and is what makes three angles -pi + delta/3 close",
    )


def angle(setting: Setting, *, parts: str = "3", shift: str = "-1") -> Evidence:
    """Whether alpha = -pi + delta/3 is in (-pi, 0) for delta in (0, 3 pi), and closes a corner."""
    ends = [
        printed.surgery_angle(sp.Integer(x), parts=sp.Rational(parts), shift=sp.Rational(shift))
        for x in (0, 3)
    ]
    d, total = sp.Symbol("d", positive=True), sp.Symbol("S", real=True)
    alpha = printed.surgery_angle(
        printed.deficit(total, d), parts=sp.Rational(parts), shift=sp.Rational(shift)
    )
    inside = sp.Integer(-1) <= ends[0] and ends[1] <= 0
    return combined(
        {
            "range": statement(
                bool(inside), shown="", witness=f"alpha ranges over ({ends[0]} pi, {ends[1]} pi)"
            ),
            "closing": identities(
                setting,
                {"3 alpha + sum": 3 * alpha + total - printed.interior_sum((d + 2) / 2)},
                shown="",
            ),
        },
        shown="delta in (0, 3 pi) is alpha in (-pi, 0), and 3 alpha and the old sum are "
        "2 pi (1 - m) for the new degree 2m = d + 2",
    )


def geodesics(setting: Setting, *, subtracted: int = 1, angle: str = "edge") -> Evidence:
    """Whether the printed points are equally spaced on a great circle, for any k and edge angle.

    angle: "edge" for the delta of the edges, "missing" for another angle; the shipped geodesic is
    compared for k up to 4.
    """
    delta, other = sp.symbols("delta epsilon", positive=True)
    c, s = circle(sp.Symbol("w", real=True))
    k = sp.Symbol("k", integer=True)
    q = corner().n_2
    # A unit tangent at q, turned by any angle, from the frame of two orthogonal ones.
    one, two = _frame()
    along = tuple(c * x + s * y for x, y in zip(one, two, strict=True))
    first = tuple(sp.cos(delta) * x + sp.sin(delta) * y for x, y in zip(q, along, strict=True))
    used = delta if angle == "edge" else other
    angles = (lambda n: sp.cos(n * used)), (lambda n: sp.sin(n * used))

    def point(n: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        return printed.geodesic_point(q, first, n, angles, subtracted=subtracted)

    shipped = geodesic_curve(sp, q, along, delta, 4)
    found = {
        "|gamma(k)|^2 - 1": dot(point(k), point(k)) - 1,
        "<gamma(k), gamma(k + 1)> - cos delta": dot(point(k), point(k + 1)) - sp.cos(delta),
        "gamma(0) - N(q)": minus(point(sp.Integer(0)), q),
        "gamma(1)": minus(point(sp.Integer(1)), first),
    }
    found |= {f"shipped gamma({n})": minus(point(sp.Integer(n)), shipped[n]) for n in range(2, 5)}
    return identities(
        setting,
        found,
        shown="for every unit vector N(q), direction, edge angle and integer k the printed points "
        "are unit vectors in steps of delta, in the plane of N(q) and gamma(1), and the shipped "
        "geodesic's",
    )


def _frame() -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    """Two orthogonal unit tangents at the point q = (c, s cos t, s sin t) of `corner`."""
    c, s = circle(sp.Symbol("y", positive=True))
    turn = circle(sp.Symbol("z", real=True))
    return (-s, c * turn[0], c * turn[1]), (sp.Integer(0), -turn[1], turn[0])


def even_degree(setting: Setting, *, swapped: bool = False) -> Evidence:
    """Whether corners have even degree, 2 or more; swapped: odd degree."""
    return degree_parity(setting, swapped=swapped)
