"""Lengths of one edge in three nets: on H^2, on S^2 and in space (eq:d_lelieuvre, poincare-ddg).

A quad of a K-surface has the side d in space, its normals the side s = arcsin d on S^2. With the
angles A, B at neighbouring vertices in space, pi - A and pi - B on S^2, Napier's analogy gives
tan(A/2) tan(B/2) = (1 - t t')/(1 + t t') for t = tan(s/2), t' that of the other side; on H^2 the
same with t = tanh(a/2). So the angles are those of a hyperbolic net if tan(s/2) = tanh(a/2), which
is d = sin s = tanh a: s is the Gudermannian of a.
"""

from typing import Any

from discrete.space_forms import Scalar


def spherical_length(functions: Any, a: Scalar) -> Scalar:
    """Length s on S^2 of the normal's edge, from the length a on H^2; s < pi/2."""
    return 2 * functions.atan(functions.tanh(a / 2))


def space_length(functions: Any, a: Scalar) -> Scalar:
    """Length d in space of an edge, from its length a on H^2; d < 1."""
    return functions.tanh(a)


def hyperbolic_length(functions: Any, d: Scalar) -> Scalar:
    """Length a on H^2 of an edge, from its length d < 1 in space: artanh d."""
    return functions.log((1 + d) / (1 - d)) / 2
