"""Checks of section 3.4 on grids: a whole surgery on the pseudosphere, and edges of class C^1."""

from typing import Any

import numpy as np
from mpmath import mp

from checks.evidence import Evidence, Setting
from checks.exact import combined
from checks.printed import surgery as printed
from checks.verify.convergence import order
from theory import tractrix_surgery as tractrix
from theory.goursat_float import Floats, orientation

# From 32 steps on: coarser, the quad of the largest gap is still far from the corner of the sector.
_STEPS = (32, 64, 128, 256)
# Rounding in sums of 256 terms of size 1; the defects that scale with the step are above 1e-7.
_ROUNDING = 1e-12


def _rays(cut: tractrix.Cut, weight: float, *, swapped: bool = False) -> tuple[Floats, Floats]:
    """Unit vectors e_u, e_v of the printed trisection at the point of the pseudosphere."""
    t_u, t_v, _ = tractrix.tangents(cut)
    vectors = printed.trisecting(tuple(t_u), tuple(t_v), weight=weight)
    e_u, e_v = (np.array(a) / np.linalg.norm(a) for a in vectors)
    return (e_v, e_u) if swapped else (e_u, e_v)


def _orders(errors: list[dict[str, float]], *, expected: int) -> dict[str, Evidence]:
    """Observed orders of all defects, finest grid last."""
    found = {}
    with mp.workdps(15):
        levels = [mp.mpf(1) / steps for steps in _STEPS]
        for name in errors[0]:
            values = [mp.mpf(error[name]) for error in errors]
            found[name] = order(levels, values, expected, digits=8, shown=name)
    return found


def _sizes(gaps: dict[str, float], signs: list[int]) -> dict[str, Evidence]:
    """Gaps that are rounding, and the sides on which the sectors lie."""
    small = {
        name: _evidence(gap < _ROUNDING, f"{name}: the fronts are {gap:.3g} apart")
        for name, gap in gaps.items()
    }
    wanted = [signs[0], -signs[0], signs[0]]
    told = f"the signs of (r_u x r_v).N on the sectors are {signs}"
    return small | {"sides": _evidence(signs[0] != 0 and signs == wanted, told)}


def _evidence(true: bool, witness: str) -> Evidence:
    if true:
        return Evidence(outcome="pass", grade="experiment", shown="")
    return Evidence(outcome="fail", grade="experiment", shown="", witness=witness)


def whole_surgery(
    setting: Setting,
    *,
    fourth: int = 2,
    rate: str = "1",
    swapped: bool = False,
    expected: int = 2,
) -> Evidence:
    """Surgery on the pseudosphere with the printed rays: all defects vanish to second order.

    fourth: sector from which Omega_1 takes its v-axis; rate: factor of sin omega in the equation
    for the angle; swapped: e_u and e_v exchanged; expected: order.
    """
    cut = tractrix.Cut()
    e_u, e_v = _rays(cut, 2.0, swapped=swapped)
    errors: list[dict[str, float]] = []
    for steps in _STEPS:
        found = tractrix.sectors(
            cut, e_u, e_v, steps=steps, rate=float(mp.mpmathify(rate)), fourth=fourth
        )
        gaps = tractrix.edge_gaps(cut, found)
        shared = {name: gaps.pop(name) for name in ("chi_2", "chi_4")}
        for k, sector in enumerate(found, start=1):
            gaps |= {f"{name}, Omega_{k}": e for name, e in tractrix.defects(sector).items()}
        errors.append(gaps)
    signs = [orientation(sector.places, sector.normal) for sector in found]
    return combined(
        _sizes(shared, signs) | _orders(errors, expected=expected),
        shown="on the pseudosphere, on grids of 32 to 256 steps: |N| - 1, K + 1, the gap to the "
        "angle of the sine-Gordon equation and the gaps to r_0 on the edges are of order 2, the "
        "sectors agree on their common edges to rounding and lie on alternating sides",
    )


def kinked_edge(setting: Setting, *, rate: str = "1", jump: str = "3/2") -> Evidence:
    """Sector with an inherited edge that is C^1 but not C^2: the same second order.

    rate: factor of sin omega in the equation for the angle; jump: of the curvature in the angle's
    data, that of the edge being 3/2.
    """
    start = (np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0]))
    ray, first = np.array([np.cos(0.9), np.sin(0.9), 0.0]), 0.9
    errors = []
    for steps in _STEPS:
        s = np.linspace(0.0, 0.8, steps + 1)
        on_u, turning = tractrix.bent_normals(start, (0.5, -1.0), s)
        excess = (float(mp.fraction(*_parts(jump))) - 1.5) * np.maximum(s - 0.4, 0.0)
        axes: Any = (
            on_u,
            tractrix.straight(start[1], ray, s, sign=-1),
            first - turning + excess,
            np.full_like(s, first),
        )
        step = 0.8 / steps
        sector = tractrix.sector(axes, (step, step), np.zeros(3), rate=float(mp.mpmathify(rate)))
        errors.append(tractrix.defects(sector))
    return combined(
        _orders(errors, expected=2),
        shown="with an edge whose curvature jumps from 1/2 to -1 the defects |N| - 1, K + 1 and "
        "the gap of the angles are of order 2 on grids of 32 to 256 steps",
    )


def _parts(rational: str) -> tuple[int, int]:
    top, _, bottom = rational.partition("/")
    return int(top), int(bottom or 1)
