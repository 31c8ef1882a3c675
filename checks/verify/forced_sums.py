"""Sums of angles at a vertex that follow from angles in (-pi, 0) alone, for (eq:unramified)."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import statement
from checks.printed import spherical_nets as printed


def _even_between(low: sp.Expr, high: sp.Expr) -> list[sp.Integer]:
    """Even integers in an open interval between rational numbers."""
    return [
        n for n in range(2 * int(sp.floor(low / 2)), int(sp.ceiling(high)), 2) if low < n < high
    ]


def forced_sums(setting: Setting, *, least: str = "-1") -> Evidence:
    """Whether new vertices, and old ones inside a segment, meet (eq:unramified) by themselves.

    Every angle is in (least, 0), in units of pi, and the angles around an interior vertex close up,
    so that their sum is an even integer. A new interior vertex has 4 faces, a new boundary vertex 1
    or 2; inside a segment d is odd, the old sum in its range, and two faces are added.
    """
    low = sp.Rational(least)
    wrong = ""
    if _even_between(4 * low, sp.Integer(0)) != [printed.interior_sum(2)]:
        wrong = f"four angles can add up to any of {_even_between(4 * low, sp.Integer(0))} times pi"
    for d in (2, 3):
        lower, upper = printed.boundary_range(d)
        if (d - 1) * low < lower or min(upper, 0) < 0:
            wrong = wrong or f"{d - 1} angles at the boundary can leave ({lower} pi, {upper} pi)"
    d = sp.Symbol("d", positive=True)
    lower, upper = (
        sp.expand(end)
        for end in (printed.boundary_range(d)[0] + 2 * low, printed.boundary_range(d)[1])
    )
    # Both ends are even for odd d, so an interval of length 4 has one even integer inside.
    middle = sp.expand(printed.interior_sum((d + 1) / 2))
    if sp.expand(upper - lower) != 4 or sp.expand(middle - lower) != 2:
        wrong = wrong or f"inside a segment the sum is between {lower} and {upper}, not {middle}"
    return statement(
        not wrong,
        shown="angles in (-pi, 0) leave one sum at new vertices and inside segments",
        witness=wrong,
    )
