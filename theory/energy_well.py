"""The energy well SO(3) A of a metric G = A^2, and the distance to it.

The best rotation is found through unit quaternions, in which the inner product of a matrix with a
rotation is a quadratic form (Davenport): its largest eigenvalue is the largest inner product.
"""

from collections.abc import Sequence
from typing import Any

import sympy as sp


def rotation(q: Sequence[Any]) -> sp.Matrix:
    """Rotation of the quaternion q = (q0, q1, q2, q3), of any non-zero length."""
    a, b, c, d = q
    turn = sp.Matrix(
        [
            [a**2 + b**2 - c**2 - d**2, 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), a**2 - b**2 + c**2 - d**2, 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), a**2 - b**2 - c**2 + d**2],
        ]
    )
    return turn / (a**2 + b**2 + c**2 + d**2)


def squared_norm(m: sp.Matrix) -> sp.Expr:
    """Squared Frobenius norm of a real matrix."""
    return sum(entry**2 for entry in m)


def symmetric_root(g: sp.Matrix) -> sp.Matrix:
    """Symmetric positive definite root of a symmetric positive definite 2x2 matrix.

    By Cayley-Hamilton A^2 = tr(A) A - det(A), where det(A)^2 = det(g) and
    tr(A)^2 = tr(g) + 2 det(A).
    """
    determinant = sp.sqrt(g.det())
    return (g + determinant * sp.eye(2)) / sp.sqrt(g.trace() + 2 * determinant)


def alignment_form(m: sp.Matrix) -> sp.Matrix:
    """Symmetric 4x4 matrix B with q . B q = |q|^2 <rotation(q), m> for every quaternion q."""
    q = sp.symbols("q0:4", real=True)
    length = sum(c**2 for c in q)
    product = sp.expand(sp.cancel(length * (rotation(q).T * m).trace()))
    return sp.hessian(product, q) / 2


def _largest(values: list[sp.Expr]) -> sp.Expr:
    for value in values:
        if all(sp.expand(value - other).is_nonnegative for other in values):
            return value
    raise ValueError(f"cannot tell which is largest: {values}")


def distance_squared(f: sp.Matrix, a: sp.Matrix) -> sp.Expr:
    """Squared Frobenius distance of the 3x3 matrix f to SO(3) a.

    Entries are rational, or symbols whose signs decide which eigenvalue of the alignment form is
    the largest; raises ValueError where they do not.
    """
    eigenvalues = list(alignment_form(f * a.T).eigenvals())
    return sp.expand(squared_norm(f) + squared_norm(a) - 2 * _largest(eigenvalues))


def rotation_defect_invariants(q: Sequence[Any]) -> tuple[sp.Expr, sp.Expr]:
    """Trace of rotation(q) - 1 and sum of its principal 2x2 minors, zero if its rank is below 2."""
    defect = rotation(q) - sp.eye(3)
    minors = [defect.extract([i, j], [i, j]).det() for i, j in ((0, 1), (0, 2), (1, 2))]
    return sp.cancel(defect.trace()), sp.cancel(sum(minors))
