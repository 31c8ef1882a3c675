"""The Poincare disk as a view of H^2: points are pairs (x, y), x^2 + y^2 < 1, of any scalars.

For input, output and pictures. Float64 pairs lose digits near the rim: 1 - |z|^2 = 1/cosh^2(d/2)
at distance d from the centre. The origin (1, 0, 0) is the centre, the direction x1 the real axis.
"""

from typing import Any

from discrete.space_forms import Scalar, Triple


def to_disk(p: Triple) -> tuple[Scalar, Scalar]:
    """View of a triple of H^2: stereographic projection from (-1, 0, 0)."""
    return (p[1] / (1 + p[0]), p[2] / (1 + p[0]))


def from_disk(z: Any) -> Triple:
    """Triple of H^2 seen at z. Undefined on the rim |z| = 1."""
    square = z[0] * z[0] + z[1] * z[1]
    gap = 1 - square
    return ((1 + square) / gap, 2 * z[0] / gap, 2 * z[1] / gap)


def moebius(z: Any, centre: Any) -> tuple[Scalar, Scalar]:
    """Image of z under the translation of the disk that moves 0 to `centre` (eq:mobius).

    Quotient of z + centre and 1 + z conj(centre); undefined only on the rim.
    """
    x, y = z[0] + centre[0], z[1] + centre[1]
    re = 1 + z[0] * centre[0] + z[1] * centre[1]
    im = z[1] * centre[0] - z[0] * centre[1]
    norm = re * re + im * im
    return ((x * re + y * im) / norm, (y * re - x * im) / norm)


def disk_distance(functions: Any, z: Any, w: Any) -> Scalar:
    """Distance of two points of the disk, from the half chord: sinh(d/2) is |z - w| over roots."""
    x, y = z[0] - w[0], z[1] - w[1]
    gap_z = 1 - z[0] * z[0] - z[1] * z[1]
    gap_w = 1 - w[0] * w[0] - w[1] * w[1]
    return 2 * functions.asinh(functions.sqrt((x * x + y * y) / (gap_z * gap_w)))
