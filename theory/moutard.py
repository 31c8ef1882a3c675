"""The Goursat problem for a unit normal whose mixed derivative is normal, N_uv = nu N, as a series.

For a unit normal nu = -N_u.N_v; the values of N on the two axes determine the Taylor coefficients.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from theory.vectors import Vector, added, dot, scaled

Series = dict[tuple[int, int], Vector]
ZERO: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(0))


def curve_normals(frame: sp.Matrix, curvature: Any, torsion: int, *, order: int) -> list[Vector]:
    """Taylor coefficients of the binormal of a curve of constant curvature and torsion.

    frame: rows T, N x T, N at the start; the frame turns by the Frenet-Serret equations.
    """
    turn = sp.Matrix([[0, curvature, 0], [-curvature, 0, torsion], [0, -torsion, 0]])
    coefficients: list[Vector] = []
    for n in range(order + 1):
        row = frame.row(2)
        coefficients.append((row[0], row[1], row[2]))
        frame = (turn * frame / (n + 1)).applyfunc(sp.expand)
    return coefficients


def goursat_series(
    on_u_axis: Sequence[Vector], on_v_axis: Sequence[Vector], *, degree: int | None = None
) -> Series:
    """Taylor coefficients of N from those on the axes, whose first members must agree.

    Row i, column j belongs to u^i v^j; as many rows and columns as members are given, but no total
    degree above the given one.
    """
    rows, columns = len(on_u_axis), len(on_v_axis)
    normal: Series = {(i, 0): a for i, a in enumerate(on_u_axis)}
    normal |= {(0, j): a for j, a in enumerate(on_v_axis)}
    for i in range(rows - 1):
        for j in range(columns - 1):
            if degree is not None and i + j + 2 > degree:
                break
            source = _source(normal, i, j)
            entry = scaled(sp.Rational(1, (i + 1) * (j + 1)), source)
            normal[i + 1, j + 1] = _expanded(entry)
    return normal


def _source(normal: Mapping[tuple[int, int], Vector], i: int, j: int) -> Vector:
    """Coefficient of u^i v^j in -(N_u.N_v) N."""
    total = ZERO
    for k in range(i + 1):
        for m in range(j + 1):
            total = added(total, scaled(-_speeds(normal, k, m), normal[i - k, j - m]))
    return total


def _speeds(normal: Mapping[tuple[int, int], Vector], k: int, m: int) -> Any:
    """Coefficient of u^k v^m in N_u.N_v."""
    return sum(
        (
            (a + 1) * (m - b + 1) * dot(normal[a + 1, b], normal[k - a, m - b + 1])
            for a in range(k + 1)
            for b in range(m + 1)
        ),
        sp.Integer(0),
    )


def _expanded(a: Vector) -> Vector:
    return (sp.expand(a[0]), sp.expand(a[1]), sp.expand(a[2]))


def column(normal: Mapping[tuple[int, int], Vector], row: int, v: sp.Symbol) -> Vector:
    """Value at u = 0 of the u-derivative of this order, as a truncated series in v."""
    total = ZERO
    for (i, j), a in normal.items():
        if i == row:
            total = added(total, scaled(sp.factorial(row) * v**j, a))
    return total
