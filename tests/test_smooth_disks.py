"""The two routes to the max curvature of a smooth disk from data on its asymptotic lines."""

from math import atan, cosh, pi

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from checks.searches import smooth_disks
from checks.verify import smooth_disk_search
from theory import periodic_amsler

AMSLER = np.array([pi / 2, *([0.0] * 8)])


def bobbin_data() -> np.ndarray:
    """Even polynomials near the pendulum f'' = sin f, f(0) = 2 atan(1/cosh 1), on [0, 1.5]."""
    start = 2 * atan(1 / cosh(1))
    x = np.linspace(0, 1.5, 60)
    run = solve_ivp(
        lambda t, y: (y[1], np.sin(y[0])), (0, 1.5), (start, 0), t_eval=x, rtol=1e-10, atol=1e-12
    )
    powers = np.stack([x**2, x**4], axis=1)
    second, fourth = np.linalg.lstsq(powers, run.y[0] - start, rcond=None)[0]
    return np.array([start, *(0.0, second, 0.0, fourth) * 2])


def test_the_amsler_surface_has_its_certified_curvature():
    low, _ = periodic_amsler.max_curvature(1, 4).ends()
    errors = [
        smooth_disk_search.max_curvature(AMSLER, cells) - float(low) for cells in (15, 30, 60)
    ]
    orders = [np.log2(errors[k] / errors[k + 1]) for k in (0, 1)]
    assert all(1.8 < order < 2.2 for order in orders)
    assert smooth_disks.max_curvature(AMSLER) == pytest.approx(float(low), rel=3e-3)


def test_the_bobbin_has_the_curvature_cosh_1_by_both_routes():
    """The polynomials are off by some hundredths of a radian."""
    data = bobbin_data()
    assert smooth_disk_search.max_curvature(data, 60) == pytest.approx(cosh(1), rel=0.03)
    assert smooth_disks.max_curvature(data) == pytest.approx(cosh(1), rel=0.03)


def test_unsymmetrical_data_agree():
    data = np.array([1.4, 0.1, 0.2, -0.1, 0.05, -0.05, 0.1, 0.1, 0.0])
    fine = smooth_disk_search.max_curvature(data, 90)
    assert smooth_disks.max_curvature(data) == pytest.approx(fine, rel=5e-3)


def test_a_disk_that_meets_an_edge_is_the_worst():
    assert smooth_disks.max_curvature(np.array([3.0, *([0.0] * 8)])) == smooth_disks.WORST
