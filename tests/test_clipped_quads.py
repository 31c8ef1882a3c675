"""Area of a quad in a disk from heights: against another rule, and in limits where it is known."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from discrete import plain_functions
from discrete.clipped_quads import clipped_area


def quad(length: float, angle: float, rho: float, heading: float) -> np.ndarray:
    """Vertices p, p1, p12, p2 of a rhombus in the hyperboloid, p at distance rho."""

    def point(distance: float, direction: float) -> np.ndarray:
        step = np.array(
            [
                math.cosh(distance),
                math.sinh(distance) * math.cos(direction),
                math.sinh(distance) * math.sin(direction),
            ]
        )
        boost = np.array(
            [
                [math.cosh(rho), math.sinh(rho), 0],
                [math.sinh(rho), math.cosh(rho), 0],
                [0, 0, 1],
            ]
        )
        return boost @ step

    diagonal = 2 * math.atanh(
        math.tanh(length) * math.cos(angle / 2)
    )  # the triangle p, p1, middle is right-angled
    return np.array(
        [
            point(0, 0),
            point(length, heading),
            point(diagonal, heading + angle / 2),
            point(length, heading + angle),
        ]
    )


def area_by_polar_angles(vertices: np.ndarray, radius: float, n: int = 20000) -> float:
    """Area in polar coordinates around the centre, which lies outside the quad; midpoint rule."""
    klein = vertices[:, 1:] / vertices[:, :1]
    angles = np.arctan2(klein[:, 1], klein[:, 0])
    low, high = angles.min(), angles.max()
    theta = low + (high - low) * (np.arange(n) + 0.5) / n
    near, far = np.full(n, np.inf), np.zeros(n)
    for a, b in zip(klein, np.roll(klein, -1, axis=0), strict=True):
        edge = b - a
        det = np.cos(theta) * edge[1] - np.sin(theta) * edge[0]
        r = (a[0] * edge[1] - a[1] * edge[0]) / det
        share = (a[0] * np.sin(theta) - a[1] * np.cos(theta)) / det
        hit = (share >= 0) & (share <= 1)
        near = np.where(hit, np.minimum(near, r), near)
        far = np.where(hit, np.maximum(far, r), far)
    rim = math.tanh(radius)
    heights = [1 / np.sqrt(1 - np.minimum(r, rim) ** 2) for r in (near, far)]
    return float(np.sum(heights[1] - heights[0]) * (high - low) / n)


@given(
    length=st.floats(0.05, 0.5),
    angle=st.floats(0.2, 2.9),
    rho=st.floats(1.5, 4),
    heading=st.floats(-3.1, 3.1),
    share=st.floats(-0.7, 0.7),
)
@settings(max_examples=60, deadline=None, derandomize=True)
def test_area_is_that_in_polar_coordinates(
    length: float, angle: float, rho: float, heading: float, share: float
) -> None:
    vertices = quad(length, angle, rho, heading)
    radius = rho + share * length
    heights = tuple(vertices[:, 0].tolist())
    found = clipped_area(
        math.cosh(length), math.sinh(length), math.cosh(radius),
        math.sin(angle), math.cos(angle), heights,
    )  # fmt: skip
    whole = 2 * length**2 * math.sin(angle)
    assert found == pytest.approx(area_by_polar_angles(vertices, radius), abs=2e-4 * whole)


@given(
    length=st.floats(0.01, 0.5),
    angle=st.floats(0.05, 3.1),
    rho=st.floats(0.0, 6),
    heading=st.floats(-3.1, 3.1),
)
@settings(max_examples=100, deadline=None, derandomize=True)
def test_area_in_a_large_disk_is_the_defect(
    length: float, angle: float, rho: float, heading: float
) -> None:
    heights = tuple(quad(length, angle, rho, heading)[:, 0].tolist())
    q = math.tanh(length / 2) ** 2
    defect = 4 * math.atan(q * math.sin(angle) / (1 - q * math.cos(angle)))
    measures = (math.cosh(length), math.sinh(length))
    large, small = math.cosh(rho + 2), math.cosh(max(rho - 2, 0))
    turn = (math.sin(angle), math.cos(angle))
    assert clipped_area(*measures, large, *turn, heights) == pytest.approx(
        defect, abs=1e-12 * math.cosh(rho)
    )
    if rho > 2:
        assert clipped_area(*measures, small, *turn, heights) == pytest.approx(0, abs=1e-11)


@given(st.floats(0, math.pi / 2))
def test_sine_and_cosine(y: float) -> None:
    assert plain_functions.sine(y) == pytest.approx(math.sin(y), rel=4e-16)
    assert plain_functions.cosine(y) == pytest.approx(math.cos(y), abs=4e-16)


@given(st.floats(-plain_functions.SMALL, plain_functions.SMALL))
def test_small_arc_tangent(x: float) -> None:
    assert plain_functions.small_arc_tangent(x) == pytest.approx(math.atan(x), rel=4e-16)


def test_longest_step_is_within_the_arc_tangent() -> None:
    from discrete.greedy_parameters import LONGEST_STEP

    q = math.tanh(float(LONGEST_STEP) / 2) ** 2
    assert q / math.sqrt(1 - q * q) < plain_functions.SMALL
