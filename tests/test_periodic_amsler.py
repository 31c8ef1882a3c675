"""Certified periodic Amsler surfaces: geodesics by Runge-Kutta, and every number of sectors."""

from fractions import Fraction
from itertools import pairwise
from math import cos, pi, sin, sqrt, tan

import numpy as np
import pytest
from flint import arb
from scipy.integrate import solve_ivp

from theory import painleve, periodic_amsler
from theory.errors import DomainError, SingularEdgeError

FLOAT_ERROR = 1e-8
"""Relative tolerance 1e-11 of the Runge-Kutta method along a ray, with room to accumulate."""


def solution(phi0: float, z: float) -> tuple[float, float]:
    """Angle phi and slope phi' at z in float64, from two terms of the series at z = 1/100."""
    s, c = sin(phi0), cos(phi0)
    x = 0.25e-4
    start = [phi0 + s * x + s * c * x**2 / 4, 0.005 * (s + s * c * x / 2)]
    if z <= 0.01:
        return phi0 + s * z * z / 4, s * z / 2
    run = solve_ivp(
        lambda t, y: (y[1], np.sin(y[0]) - y[1] / t), (0.01, z), start, rtol=1e-11, atol=1e-12
    )
    return float(run.y[0, -1]), float(run.y[1, -1])


def ray(phi0: float, part: float, radius: float) -> tuple[float, float]:
    """(u, v) at this distance from the apex on the geodesic at the angle part * phi0 to the u-edge.

    With the Christoffel symbols of du^2 + 2 cos phi du dv + dv^2, phi = phi(z) found beforehand.
    """
    reach = 2.5 * radius + 1
    table = solve_ivp(
        lambda t, y: (y[1], np.sin(y[0]) - y[1] / t),
        (0.01, reach),
        [solution(phi0, 0.01)[0], solution(phi0, 0.01)[1]],
        rtol=1e-11,
        atol=1e-13,
        dense_output=True,
    ).sol

    def force(_, state):
        u, v, du, dv = state
        z = 2 * sqrt(u * v)
        phi, rate = table(z) if z > 0.01 else solution(phi0, z)
        factor = 2 * rate / z if z > 1e-6 else sin(phi0)
        phi_u, phi_v = factor * v, factor * u
        # r_uu = -phi_u/sin phi (r_v - cos phi r_u), and r_vv alike; r_uv has no tangential part.
        return (
            du,
            dv,
            -phi_u / tan(phi) * du**2 + phi_v / sin(phi) * dv**2,
            phi_u / sin(phi) * du**2 - phi_v / tan(phi) * dv**2,
        )

    angle = part * phi0
    direction = sin(phi0 - angle) / sin(phi0), sin(angle) / sin(phi0)
    tiny = 1e-6
    start = [tiny * direction[0], tiny * direction[1], *direction]
    run = solve_ivp(force, (tiny, radius), start, rtol=1e-11, atol=1e-13)
    return float(run.y[0, -1]), float(run.y[1, -1])


def middle(enclosure) -> float:
    low, high = enclosure.ends()
    return float((low + high) / 2)


@pytest.mark.parametrize(("radius", "sectors"), [(1, 6), (2, 8), (2, 10), (Fraction(1, 2), 4)])
def test_on_the_rim_the_angle_is_largest_on_the_mirror_line(radius, sectors):
    phi0 = 2 * pi / sectors
    angles = []
    for part in (0.1, 0.2, 0.3, 0.4, 0.45, 0.5):
        u, v = ray(phi0, part, float(radius))
        angles.append(solution(phi0, 2 * sqrt(u * v))[0])
        mirrored = ray(phi0, 1 - part, float(radius))
        assert mirrored == pytest.approx((v, u), rel=FLOAT_ERROR)
    assert all(np.diff(angles) > 0)
    largest = middle(periodic_amsler.rim_angle(radius, sectors))
    assert angles[-1] == pytest.approx(largest, rel=FLOAT_ERROR)


def test_the_rim_angle_is_the_angle_where_the_diagonal_has_the_radius():
    for radius, sectors in ((1, 6), (3, 20), (6, 400)):
        phi0 = Fraction(2, sectors)

        def opening(part=phi0):
            return arb.pi() * part.numerator / part.denominator

        rim = periodic_amsler.rim_angle(radius, sectors, digits=30)
        low, high = rim.ends()
        place = painleve.crossing(opening, (low + high) / 2, digits=28)
        length = painleve.diagonal(opening, sum(place.ends()) / 2, digits=25)
        assert abs(length.ends()[0] - radius) < Fraction(1, 10**20)


def curvature_or_infinity(radius, sectors):
    """Lower bound on the max curvature; infinite where the disk reaches the singular edge."""
    try:
        return periodic_amsler.max_curvature(radius, sectors).ends()[0]
    except SingularEdgeError:
        return float("inf")


@pytest.mark.parametrize("radius", [Fraction(1, 10), Fraction(1, 2), 1, 2, Fraction(7, 2)])
def test_the_best_number_of_sectors_among_all(radius):
    best = periodic_amsler.best_sectors(radius)
    least = periodic_amsler.max_curvature(radius)
    assert least == periodic_amsler.max_curvature(radius, best)
    for sectors in range(4, best + 12, 2):
        if sectors == best:
            continue
        assert curvature_or_infinity(radius, sectors) > least.ends()[1]


def test_the_larger_of_the_two_curvatures_is_taken():
    """Few sectors: tan(phi/2) at the rim; many: cot(pi/(2m)) at the centre."""
    rim = middle(periodic_amsler.rim_angle(1, 4))
    assert middle(periodic_amsler.max_curvature(1, 4)) == pytest.approx(tan(rim / 2), rel=1e-12)
    for sectors in (8, 100):
        found = middle(periodic_amsler.max_curvature(1, sectors))
        assert found == pytest.approx(1 / tan(pi / sectors), rel=1e-14)


def test_a_tiny_disk_is_nearly_flat():
    """Expand phi = phi0 + sin(phi0) x + ...; the rim is at R = cos(phi0/2) z: here phi0 = pi/2."""
    radius = Fraction(1, 10**20)
    low, high = periodic_amsler.rim_angle(radius, 4, digits=60).ends()
    with_pi = painleve.angle(lambda: _half_pi(), 0, digits=60).ends()[0]
    growth = (low + high) / 2 - with_pi
    assert abs(growth / (radius**2 / 2) - 1) < Fraction(1, 10**15)


def _half_pi():
    return arb.pi() / 2


def test_the_growth_with_the_radius_is_exponential():
    """Ratios of the least curvature over unit steps of R approach e from below."""
    values = [middle(periodic_amsler.max_curvature(radius)) for radius in (8, 10, 12)]
    ratios = [sqrt(second / first) for first, second in pairwise(values)]
    assert 2.5 < ratios[0] < ratios[1] < 2.7183


@pytest.mark.parametrize("sectors", [2, 5, 0, -4, True, 4.0])
def test_a_number_of_sectors_that_is_not_even_or_too_small(sectors):
    with pytest.raises(DomainError, match="sectors"):
        periodic_amsler.max_curvature(1, sectors)


@pytest.mark.parametrize("radius", [0, -1, 51])
def test_radii_out_of_range(radius):
    with pytest.raises(DomainError):
        periodic_amsler.max_curvature(radius, 6)
    with pytest.raises(DomainError):
        periodic_amsler.best_sectors(radius)


def test_the_singular_edge_is_named_with_its_distance():
    with pytest.raises(SingularEdgeError) as raised:
        periodic_amsler.max_curvature(3, 4)
    low, high = raised.value.enclosure.ends()
    # The distance is stationary where phi = pi, so that tan(phi/2) grows like an inverse root.
    for power in (4, 6, 8):
        found = periodic_amsler.max_curvature(low - Fraction(1, 10**power), 4)
        assert 10 ** (power // 2) < found.ends()[0] < 10 ** (power // 2 + 1)
    with pytest.raises(SingularEdgeError):
        periodic_amsler.max_curvature(high + Fraction(1, 1000), 4)
