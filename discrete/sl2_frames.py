"""Frames of H^2 as matrices of SL(2, R): positions, distances and bearings that keep their digits.

A frame (a, b, c, d), the matrix [[a, b], [c, d]] with a d - b c = 1, stands for a point and a unit
direction there; the identity stands for (1, 0, 0) and the direction x1. One moves by products from
the right: `advanced` along the own direction, `turned` on the spot. The distance from the frame
that a product starts from needs no difference of large numbers, whatever its length; to measure
between two vertices far out, multiply the steps of a path between them (a re-centred frame)
instead of dividing two frames that both start from far away. Entries grow as e^(d/2): float64 holds
them up to d = 1400.
"""

from typing import Any, TypeAlias

from discrete.space_forms import Scalar, Triple

Frame: TypeAlias = tuple[Scalar, Scalar, Scalar, Scalar]

IDENTITY: Frame = (1, 0, 0, 1)


def product(g: Frame, h: Frame) -> Frame:
    """Frame that h is, seen from g: the matrix product."""
    return (
        g[0] * h[0] + g[1] * h[2],
        g[0] * h[1] + g[1] * h[3],
        g[2] * h[0] + g[3] * h[2],
        g[2] * h[1] + g[3] * h[3],
    )


def inverse(g: Frame) -> Frame:
    """Inverse of a matrix of determinant 1."""
    return (g[3], -g[1], -g[2], g[0])


def advanced(functions: Any, g: Frame, length: Scalar) -> Frame:
    """Frame after a step of this length along its direction."""
    grow = functions.exp(length / 2)
    return (g[0] * grow, g[1] / grow, g[2] * grow, g[3] / grow)


def turned(functions: Any, g: Frame, angle: Scalar) -> Frame:
    """Frame turned to the left by an angle."""
    c, s = functions.cos(angle / 2), functions.sin(angle / 2)
    return (g[0] * c + g[1] * s, g[1] * c - g[0] * s, g[2] * c + g[3] * s, g[3] * c - g[2] * s)


def distance_from_start(functions: Any, g: Frame) -> Scalar:
    """Distance between the identity and the frame; 4 sinh^2(d/2) = (a - d)^2 + (b + c)^2."""
    x, y = g[0] - g[3], g[1] + g[2]
    return 2 * functions.asinh(functions.sqrt(x * x + y * y) / 2)


def bearing_from_start(functions: Any, g: Frame) -> Scalar:
    """Direction, seen from the identity, in which the point of the frame lies.

    In (-2 pi, 2 pi], to be taken modulo 2 pi. Undefined where the point is the start itself.
    """
    return functions.atan2(g[2] - g[1], g[0] + g[3]) + functions.atan2(g[1] + g[2], g[0] - g[3])


def distance(functions: Any, g: Frame, h: Frame) -> Scalar:
    """Distance of two frames; float64 loses digits where both are far from their start."""
    return distance_from_start(functions, product(inverse(g), h))


def triple_of(g: Frame) -> Triple:
    """Point of the frame in the hyperboloid: the entries of g g^T."""
    top = g[0] * g[0] + g[1] * g[1]
    bottom = g[2] * g[2] + g[3] * g[3]
    return ((top + bottom) / 2, (top - bottom) / 2, g[0] * g[2] + g[1] * g[3])
