"""Checks of section 4: refined nets tend to the continuous surfaces, with their orders measured."""

import math
from collections.abc import Callable, Iterator
from itertools import pairwise
from math import cos, log2, pi, sin, sqrt

import numpy as np
import numpy.typing as npt
import sympy as sp

from checks.evidence import Evidence, Setting
from discrete import geodesics
from discrete.goursat_kernel import fill_nodes
from discrete.lelieuvre import positions
from discrete.space_forms import S2
from theory import painleve_float
from theory.reparametrisation import substituted
from theory.surfaces import Front, dini, pseudosphere

FloatArray = npt.NDArray[np.float64]

_LEVELS = (40, 80, 160, 320)
#: The sides of the rectangle of asymptotic coordinates: from 1/2 to 3/2, off the singular edge.
_START, _SIDE = 0.5, 1.0
#: Allowed distance of an observed order from the order claimed.
_WITHIN = 0.05


def _exact(front: Front) -> Callable[[FloatArray, FloatArray], tuple[FloatArray, FloatArray]]:
    """Position and normal of an explicit surface, arrays (3, ...) at asymptotic coordinates."""
    u, v = sp.symbols("u v", real=True)
    _, position, normal = substituted(front, ((1, 0), (0, 1)), u, v, normal_sign=1)
    called = sp.lambdify((u, v), [*position, *normal], "numpy")

    def at(first: FloatArray, second: FloatArray) -> tuple[FloatArray, FloatArray]:
        values = np.array([np.broadcast_to(x, first.shape) for x in called(first, second)])
        return values[:3], values[3:]

    return at


def _explicit(front: Front, sign_v: int) -> Iterator[tuple[float, float]]:
    """Largest errors of normals and of points at each level; sign_v: of the v-steps, -1 right."""
    at = _exact(front)
    for n in _LEVELS:
        line = _START + _SIDE * np.arange(n + 1) / n
        u, v = np.meshgrid(line, line, indexing="ij")
        points, normals = at(u, v)
        nodes = np.empty((3, n + 1, n + 1))
        nodes[:, :, 0], nodes[:, 0, :] = normals[:, :, 0], normals[:, 0, :]
        fill_nodes(S2, nodes)
        found = positions(nodes, points[:, 0, 0])
        if sign_v > 0:
            found = 2 * found[:, :, :1] - found
        yield float(np.abs(nodes - normals).max()), float(np.abs(found - points).max())


def _monkey_sector(speed: float) -> Iterator[float]:
    """Error of the angle at a fixed place of a sector of the regular star of order 3.

    The sector lies between two geodesics of equal steps; speed: of the continuous coordinates.
    """
    first = pi / 3
    for n in _LEVELS:
        h = _SIDE / n
        turn = first - pi
        nodes = np.empty((3, n + 1, n + 1))
        for k in range(n + 1):
            for along, side in (
                ((0.0, 1.0, 0.0), nodes[:, :, 0]),
                ((0.0, cos(turn), sin(turn)), nodes[:, 0, :]),
            ):
                side[:, k] = geodesics.point_along(S2, math, (1.0, 0.0, 0.0), along, k * h)
        fill_nodes(S2, nodes)
        i, j = 3 * n // 5, n // 2
        p, p2, p1, p12 = (nodes[:, a, b] for a in (i, i + 1) for b in (j, j + 1))
        near, far = (
            abs(geodesics.angle_at(S2, math, *corner)) for corner in ((p, p1, p2), (p1, p12, p))
        )
        phi = (pi - near + far) / 2
        z = 2 * sqrt((i + 0.5) * (j + 0.5)) * h * speed
        yield abs(phi - painleve_float.angle(first, z))


def _orders(errors: list[float]) -> list[float]:
    return [log2(one / other) for one, other in pairwise(errors)]


def continuum_limit(
    setting: Setting, *, order: str = "2", sign_v: int = -1, speed: str = "1"
) -> Evidence:
    """Whether normals, points and angles tend to the continuum, with an order.

    On one rectangle of the pseudosphere and of Dini's surface, from their normals on two sides;
    and beside the branch point of a star of order 3, against Painleve III. sign_v: of the v-steps;
    speed: of the continuous coordinates against the discrete ones.
    """
    errors: dict[str, list[float]] = {}
    for front in (pseudosphere(), dini(2)):
        both = list(_explicit(front, sign_v))
        errors[f"normals of {front.name}"] = [normal for normal, _ in both]
        errors[f"points of {front.name}"] = [point for _, point in both]
    errors["angle beside a branch point"] = list(_monkey_sector(float(sp.Rational(speed))))
    claimed = float(sp.Rational(order))
    worst = 0.0
    for name, values in errors.items():
        found = _orders(values)
        worst = max(worst, values[-1])
        if any(abs(x - claimed) >= _WITHIN for x in found):
            told = ", ".join(f"{x:.2f}" for x in found)
            return Evidence(
                outcome="fail",
                grade="experiment",
                witness=f"{name}: orders {told}, the last error is {values[-1]:.1e}",
                tried=len(errors),
                met=len(errors),
            )
    return Evidence(
        outcome="pass",
        grade="experiment",
        residual=f"{worst:.0e}",
        tried=len(errors),
        met=len(errors),
        shown="on four levels from 40 to 320 quads a side the normals and points of a rectangle of "
        "two explicit surfaces, and the angle beside a branch point of order 3, have errors of the "
        f"order {order} within {_WITHIN} of the edge length",
    )
