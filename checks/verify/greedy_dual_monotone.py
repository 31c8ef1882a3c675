"""Section 4.1, item 5: moving a branch point outward raises phi in the sectors attached there.

Sectors are grids of phi over (u, v) from their corner. Cut at (a, b), a sector leaves the angle c =
phi(a, b)/3 to three daughters: the middle one has phi = c on both axes, a side one phi = c on the
geodesic and c + phi(a + u, b) - phi(a, b) on the line taken from the parent, whose geodesic
curvature it keeps (lem:surgery).
"""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from checks.evidence import Evidence, Setting
from checks.exact import combined, statement
from theory import goursat_comparison, goursat_float

Floats = NDArray[np.float64]
_CELLS, _PARTS = 48, 3


def daughters(
    grid: Floats, apex: tuple[int, int], step: float, parts: float
) -> tuple[Floats, Floats, Floats]:
    """Side, middle and side sector at a vertex of a sector, as far as the sector goes on."""
    i, j = apex
    corner = grid[i, j] / parts
    along_u = corner + grid[i:, j] - grid[i, j]
    along_v = corner + grid[i, j:] - grid[i, j]
    flat_u, flat_v = np.full_like(along_u, corner), np.full_like(along_v, corner)

    def solved(on_u: Floats, on_v: Floats) -> Floats:
        return goursat_float.sine_gordon(on_u, on_v, step_u=step, step_v=step)

    return solved(along_u, flat_v), solved(flat_u, flat_v), solved(flat_u, along_v)


def _sectors(step: float) -> Iterator[Floats]:
    """Amsler sectors of a few angles, and the daughters of each cut at (1/4, 1/3) of its sides."""
    for angle in (0.15, 0.3, 0.5):
        flat = np.full(_CELLS + 1, angle)
        grid = goursat_float.sine_gordon(flat, flat, step_u=step, step_v=step)
        yield grid
        yield from daughters(grid, (_CELLS // 4, _CELLS // 3), step, _PARTS)


def _moved(
    grid: Floats, old: tuple[int, int], new: tuple[int, int], step: float, parts: float
) -> Iterator[Floats]:
    """Differences of phi, after less before, in each sector where all of phi is below pi/2."""
    after = daughters(grid, new, step, parts)
    for first, second in zip(daughters(grid, old, step, _PARTS), after, strict=True):
        n, m = (min(a, b) for a, b in zip(first.shape, second.shape, strict=True))
        before, later = first[:n, :m], second[:n, :m]
        below = np.maximum.accumulate(np.maximum.accumulate(later, axis=0), axis=1) < np.pi / 2
        yield np.where(below, later - before, 0.0)


def outward(
    setting: Setting, *, direction: int = 1, parts: str = "3", step: str = "1/40"
) -> Evidence:
    """Least rise of phi at equal (u, v) from the branch point, when it moves by one or more edges.

    direction: -1 moves it inward; parts: of the angle that is cut out, after the move.
    """
    rng, size = setting.random(), float(Fraction(step))
    tried = met = 0
    for grid in _sectors(size):
        n, m = grid.shape
        for _ in range(4):
            old = (rng.randint(3, n // 2), rng.randint(3, m // 2))
            by = (rng.randint(0, 3), rng.randint(0, 3))
            new = (old[0] + direction * by[0], old[1] + direction * by[1])
            if by == (0, 0) or grid[: new[0] + 1, : new[1] + 1].max() >= np.pi / 2:
                continue
            for rise in _moved(grid, old, new, size, float(Fraction(parts))):
                tried, met = tried + 1, met + 1
                if rise.min() < -1e-12:
                    return Evidence(
                        outcome="fail", grade="experiment", tried=tried, met=met,
                        witness=f"moved from {old} to {new} edges of {size} in a sector of angle "
                        f"{grid[0, 0]:.4f}: phi falls by {-rise.min():.2e}",
                    )  # fmt: skip
    return Evidence(
        outcome="pass" if met else "undecided", grade="experiment", digits=12, tried=tried, met=met,
        shown="in sectors of generations 0 and 1, moving the cut outward lowers phi nowhere in "
        "the three daughters, as far as phi < pi/2",
    )  # fmt: skip


def ordered_data(setting: Setting, *, limit: str = "1/2", carried: str = "1") -> Evidence:
    """Whether the data before and after the move meet the corrected comparison principle.

    On the geodesic w is constant, so that its mixed sum is w on the line from the parent. The rates
    of the data there are phi_u(a, b)/3 + the integral of phi_uu, and phi_v(a, b)/3 + that of phi_uv
    = sin phi: not negative where phi rises and is convex in u, as it is on both axes of all these
    sectors, and inside because of phi_uuv = cos phi phi_u. limit: of phi, over pi; carried:
    multiple of the turns that the line keeps.
    """
    del setting
    u, v, a, b, t = sp.symbols("u v a b t", positive=True)
    phi = sp.Lambda((u, v), sp.exp(u) * v**2 + u**2 * v + 3 * u)  # any one but for a relation
    angle = sp.Function("phi")(u, v)
    line = phi(a, b) / 3 + sp.Rational(carried) * (phi(a + u, b) - phi(a, b))
    constant = phi(a, b) / 3
    expected = {
        a: sp.diff(phi(a, b), a) / 3 + sp.Integral(sp.diff(phi(a + t, b), t, a), (t, 0, u)),
        b: sp.diff(phi(a, b), b) / 3 + sp.Integral(sp.diff(phi(a + t, b), t, b), (t, 0, u)),
    }
    left = [
        sp.diff(goursat_comparison.mixed_sum(line, constant, constant), x) - rate
        for x, rate in expected.items()
    ]
    gaps = [sp.simplify(x.doit()) for x in left]
    convex = sp.diff(sp.sin(angle), u) - sp.cos(angle) * sp.diff(angle, u)
    top: Any = sp.cos(sp.Rational(limit) * sp.pi)
    return combined(
        {
            "rates": statement(
                gaps == [0, 0], shown="", witness=f"the rates of the data are off by {gaps}"
            ),
            "phi_uuv": statement(bool(convex.equals(0)), shown="", witness=f"off by {convex}"),
            "cos phi": statement(
                bool(top >= 0), shown="", witness=f"phi_uuv < 0 where phi nears {limit} pi"
            ),
        },
        shown="phi is convex in u and in v and rises in both, generation after generation, while "
        "phi <= pi/2: the data of the daughters rise as the branch point moves outward",
    )
