"""Section 4.1, item 5: the comparison principle by the data on both axes, and the dual by it."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import product

import numpy as np
import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.printed import greedy_dual as printed
from theory import goursat_comparison, goursat_float

#: Side of the small square of the exact samples; there phi_1 = 1 on the axes and w(0, 0) = 1/10.
_SIDE, _CORNER = Fraction(1, 50), Fraction(1, 10)


def _slopes() -> Iterator[tuple[Fraction, Fraction]]:
    """Relative falls a, b of w along both axes: multiples of 1/4, one of them also off by 1/100."""
    quarters = [Fraction(k, 4) for k in range(-4, 5)]
    for a, b, off in product(quarters, quarters, (-1, 0, 1)):
        yield a, b + Fraction(off, 100)


def linear_data(
    setting: Setting, *, needs: str = "axes", slack: str = "0", allowance: str = "0"
) -> Evidence:
    """Sign of w = phi_2 - phi_1 at the far corner of a small square, for data linear on the axes.

    w falls by the shares a and b along the axes. needs: hypothesis; slack: part of w(0, 0) by which
    the mixed sum may fail it; allowance: part of w(0, 0) by which the conclusion may fail.
    """
    del setting
    tried = met = 0
    for a, b in _slopes():
        tried += 1
        on_u, on_v = [Fraction(1), 1 - a], [Fraction(1), 1 - b]
        eased = [value + Fraction(slack) for value in on_u[1:]]
        if not printed.data_ordered([on_u[0], *eased], on_v, needs=needs):
            continue
        corners = [goursat_comparison.mixed_sum(x, y, Fraction(1)) for x in on_u for y in on_v]
        low, high = goursat_comparison.far_corner(
            corners[-1], largest=max(abs(c) for c in corners), area=_SIDE**2
        )
        if high < -Fraction(allowance):
            return Evidence(
                outcome="fail", grade="exact", tried=tried, met=tried,
                witness=f"u_0 = v_0 = {_SIDE}, phi_1 = 1 on both axes, phi_2 = {1 + _CORNER} at "
                f"the corner, {1 + _CORNER * (1 - a)} and {1 + _CORNER * (1 - b)} at the ends of "
                f"the axes, linear between: phi_2 - phi_1 <= {float(_CORNER * high):.5f} at the "
                "far corner",
            )  # fmt: skip
        met += low >= -Fraction(allowance)
    return Evidence(
        outcome="pass", grade="exact", tried=tried, met=met,
        shown="data linear on the axes that meet the hypothesis leave phi_1 <= phi_2 at the far "
        "corner wherever the bound on the series decides",
    )  # fmt: skip


def kernel(setting: Setting, *, limit: str = "1/2") -> Evidence:
    """Steps of the proof: w_uv = c w with c >= 0, where both solutions are below limit pi.

    c is sin(h)/h cos(mean) with |h| < pi/2; the series of the T^n A has no negative term then.
    """
    first, second = sp.symbols("phi_1 phi_2", positive=True)
    top = sp.cos(sp.Rational(limit) * sp.pi)
    return combined(
        {
            "rate": identities(
                setting,
                {
                    "c w": goursat_comparison.rate(first, second) * (second - first)
                    - sp.sin(second)
                    + sp.sin(first)
                },
                shown="",
            ),
            "c >= 0": statement(
                bool(top >= 0),
                shown="",
                witness=f"c tends to cos({limit} pi) < 0 where both angles do",
            ),
        },
        shown="w = A + T w with T positive: w is the sum of all T^n A, not negative where A is not",
    )


def solved(setting: Setting, *, needs: str = "mixed sum", slack: str = "0") -> Evidence:
    """Least phi_2 - phi_1 for random data that just meet the hypothesis, from the solved equation.

    slack: part of w(0, 0) by which the mixed sum is negative at the far corner.
    """
    rng = np.random.default_rng(setting.random().getrandbits(32))
    tried, met = 40, 0
    for number in range(tried):
        cells, reach = 40, (0.1, 0.4, 0.8)[number % 3]
        t = np.linspace(0, 1, cells + 1)
        corner, size = rng.uniform(0.3, 0.8), rng.uniform(0.02, 0.2)
        share = rng.uniform(0, 1) if needs == "mixed sum" else 1.0
        rest = 1 + float(Fraction(slack)) - share if needs == "mixed sum" else 1.0
        fall_u, fall_v = (t ** rng.choice([1, 2]) for _ in range(2))
        on_u, on_v = size * (1 - share * fall_u), size * (1 - rest * fall_v)
        first = [corner + rng.uniform(-0.1, 0.2) * t for _ in range(2)]
        step = {"step_u": reach / cells, "step_v": reach / cells}
        below = goursat_float.sine_gordon(first[0], first[1], **step)
        above = goursat_float.sine_gordon(first[0] + on_u, first[1] + on_v, **step)
        grids = np.stack([below, above])
        if not (grids.min() > 0 and grids.max() < np.pi / 2):
            continue
        met += 1
        least = float((above - below).min())
        if least < -1e-9:
            return Evidence(
                outcome="fail", grade="experiment", tried=tried, met=met,
                witness=f"least phi_2 - phi_1 is {least:.2e} on the square of side {reach}",
            )  # fmt: skip
    return Evidence(
        outcome="pass" if met else "undecided", grade="experiment", digits=9, tried=tried, met=met,
        shown="solutions whose data just meet the hypothesis keep their order on the square",
    )  # fmt: skip
