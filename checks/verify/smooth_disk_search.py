"""Re-analysis of the stored search for smooth disks better than the bobbin's (section 5)."""

from math import cosh, pi, tan

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import RectBivariateSpline

from checks.evidence import Evidence, Setting
from checks.searches import smooth_disks
from checks.stored import load

Array = NDArray[np.float64]
FEWEST = 10_000
DIRECTIONS = 360
STEPS = 60


def _on_axis(coefficients: Array, x: Array) -> Array:
    value: Array = sum(c * x ** (k + 1) for k, c in enumerate(coefficients))
    return value


def _solution(point: Array, cells: int) -> RectBivariateSpline:
    """Spline of the solution of phi_uv = sin phi with these data on both axes, by midpoints."""
    reach = 1.9 * smooth_disks.RADIUS
    x = np.linspace(-reach, reach, 2 * cells + 1)
    h = reach / cells
    phi = np.zeros((len(x), len(x)))
    phi[:, cells] = point[0] + _on_axis(point[1 : 1 + smooth_disks.DEGREE], x)
    phi[cells, :] = point[0] + _on_axis(point[1 + smooth_disks.DEGREE :], x)
    for su in (1, -1):
        for sv in (1, -1):
            for i in range(cells):
                a, b = cells + su * i, cells + su * (i + 1)
                for j in range(cells):
                    c, d = cells + sv * j, cells + sv * (j + 1)
                    middle = np.sin((phi[b, c] + phi[a, d]) / 2)
                    phi[b, d] = phi[b, c] + phi[a, d] - phi[a, c] + su * sv * h * h * middle
    return RectBivariateSpline(x, x, phi)


def _largest_offset(phi: RectBivariateSpline) -> float:
    """Largest |phi - pi/2| on geodesic rays from the centre, by the Runge-Kutta method.

    u' = sin(phi - a)/sin phi, v' = sin a/sin phi, a' = phi_u u', a the angle of the ray to r_u.
    """
    state = np.zeros((3, DIRECTIONS))
    state[2] = np.linspace(0, 2 * pi, DIRECTIONS, endpoint=False)
    h = smooth_disks.RADIUS / STEPS

    def rates(at: Array) -> Array:
        angle = phi.ev(at[0], at[1])
        along_u = np.sin(angle - at[2]) / np.sin(angle)
        along_v = np.sin(at[2]) / np.sin(angle)
        return np.stack([along_u, along_v, phi.ev(at[0], at[1], dx=1) * along_u])

    worst = abs(float(phi.ev(0, 0)) - pi / 2)
    for _ in range(STEPS):
        k1 = rates(state)
        k2 = rates(state + h / 2 * k1)
        k3 = rates(state + h / 2 * k2)
        k4 = rates(state + h * k3)
        state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        worst = max(worst, float(np.max(np.abs(phi.ev(state[0], state[1]) - pi / 2))))
    return worst


def max_curvature(point: Array, cells: int) -> float:
    """E_inf on the disk of the data, on a grid of this many cells a side of each quadrant."""
    return 1 / tan((pi / 2 - _largest_offset(_solution(point, cells))) / 2)


def smooth_disk_search(setting: Setting, *, bound_percent: int = 100) -> Evidence:
    """Whether the best smooth disk found has E_inf of at least bound_percent % of cosh 1.

    Recomputed from the stored data with geodesic rays on three grids, by another method.
    """
    del setting
    run = load("smooth_disks")
    point = np.array(run.result["point"])
    values = [max_curvature(point, cells) for cells in (30, 60, 120)]
    error = abs(values[2] - values[1])
    bound = bound_percent / 100 * cosh(smooth_disks.RADIUS)
    failures = []
    if run.stale:
        failures.append("the stored search is older than its sources")
    if run.evaluations < FEWEST:
        failures.append(f"{run.evaluations} evaluations only")
    if not values[2] + error >= bound:
        failures.append(f"E_inf = {values[2]:.5f} against {bound:.5f}")
    if not abs(values[2] - run.result["curvature"]) < 0.01:
        failures.append(f"E_inf = {values[2]:.5f}, stored {run.result['curvature']:.5f}")
    return Evidence(
        outcome="fail" if failures else "pass",
        grade="experiment",
        residual=f"{error:.0e}",
        tried=run.evaluations,
        met=run.evaluations,
        shown=f"the best of {run.evaluations} smooth disks of radius 1, with polynomials of degree "
        f"4 as data, has E_inf = {values[2]:.4f}, cosh 1 being 1.5431",
        witness="; ".join(failures),
    )
