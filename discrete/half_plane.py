"""The upper half-plane as a view of H^2: points are pairs (x, y), y > 0, of any scalars.

The frame (a, b, c, d) of discrete.sl2_frames acts by w -> (a w + b)/(c w + d); its point is the
image of i = (0, 1). The origin (1, 0, 0) is i; the direction x1 there points upwards, x2 to the
right: the view reverses the orientation of triples and disk.
"""

from typing import Any

from discrete.sl2_frames import Frame
from discrete.space_forms import Scalar, Triple


def to_half_plane(p: Triple) -> tuple[Scalar, Scalar]:
    """View of a triple of H^2. Float64 loses digits where p0 and p1 are large and nearly equal."""
    return (p[2] / (p[0] - p[1]), 1 / (p[0] - p[1]))


def from_half_plane(w: Any) -> Triple:
    """Triple of H^2 seen at w. Undefined for y = 0."""
    square = w[0] * w[0] + w[1] * w[1]
    return ((square + 1) / (2 * w[1]), (square - 1) / (2 * w[1]), w[0] / w[1])


def moebius(g: Frame, w: Any) -> tuple[Scalar, Scalar]:
    """Image of w under the frame g."""
    x, y = g[2] * w[0] + g[3], g[2] * w[1]
    norm = x * x + y * y
    re, im = g[0] * w[0] + g[1], g[0] * w[1]
    return ((re * x + im * y) / norm, (im * x - re * y) / norm)


def half_plane_distance(functions: Any, z: Any, w: Any) -> Scalar:
    """Distance of two points of the half-plane, from the half chord."""
    x, y = z[0] - w[0], z[1] - w[1]
    return 2 * functions.asinh(functions.sqrt((x * x + y * y) / (z[1] * w[1])) / 2)
