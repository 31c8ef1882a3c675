"""Angles of a Chebyshev net advanced from two sides of a rectangle, without coordinates.

Quad (i, j) has the vertices (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1), sides u_lengths[i],
v_lengths[j], and the angles A, B, A, B with B = pi - A - D (discrete.parallelograms). At a regular
vertex the four angles add up to 2 pi, which is a discrete sine-Gordon equation (Hirota's):

    A[i+1][j+1] - A[i+1][j] = A[i][j+1] - A[i][j] + D[i+1][j] + D[i][j+1].

The differences on both sides are carried, so that small ones do not drown in the angles. The
v-edges lie to the left of the u-edges where A > 0. Exact on any distance: the only errors are those
of rounding, so large hyperbolic nets take this way, and positions follow by discrete.net_frames.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from math import inf, isfinite, pi
from typing import Any

from discrete.errors import AngleError, EdgeLengthError, NotFiniteError, ShapeError
from discrete.geodesics import turn_at
from discrete.parallelograms import half_defect
from discrete.space_forms import Scalar, SpaceForm, Triple


@dataclass(frozen=True, kw_only=True)
class NetAngles:
    """Angles of the quads of a rectangle, rows [i][j] of scalars.

    angles: A of quad (i, j), at its vertices (i, j) and (i + 1, j + 1); half_defects: pi - A - B.
    """

    space: SpaceForm
    u_lengths: Sequence[Scalar]
    v_lengths: Sequence[Scalar]
    angles: Any
    half_defects: Any


def fill_angles(
    defect: Callable[[Scalar, Scalar], Scalar],
    u_factors: Any,
    v_factors: Any,
    corner_angle: Scalar,
    u_turns: Any,
    v_turns: Any,
    angles: Any,
    defects: Any,
) -> None:
    """Fill angles[i][j] and defects[i][j] in place; the body for scalars of every kind.

    defect(q, A): half defect of a quad; u_factors[i] * v_factors[j] is q; u_turns[i]: excess over
    pi of the angle of the first side at vertex (i + 1, 0), measured in the net; v_turns[j]: that of
    the second side at (0, j + 1).
    """
    angles[0][0] = corner_angle
    defects[0][0] = defect(u_factors[0] * v_factors[0], corner_angle)
    for i in range(1, len(u_factors)):
        angles[i][0] = angles[i - 1][0] + (defects[i - 1][0] + u_turns[i - 1])
        defects[i][0] = defect(u_factors[i] * v_factors[0], angles[i][0])
    for j in range(1, len(v_factors)):
        rise = defects[0][j - 1] + v_turns[j - 1]
        angles[0][j] = angles[0][j - 1] + rise
        defects[0][j] = defect(u_factors[0] * v_factors[j], angles[0][j])
        for i in range(1, len(u_factors)):
            rise = rise + (defects[i][j - 1] + defects[i - 1][j])
            angles[i][j] = angles[i][j - 1] + rise
            defects[i][j] = defect(u_factors[i] * v_factors[j], angles[i][j])


def half_tangents(
    space: SpaceForm, functions: Any, u_lengths: Sequence[Scalar], v_lengths: Sequence[Scalar]
) -> tuple[list[Scalar], list[Scalar]]:
    """Factors of q for the columns and the rows of quads; the sign of q is in the first."""
    first = [-space.curvature * space.tangent(functions, a / 2) for a in u_lengths]
    return first, [space.tangent(functions, b / 2) for b in v_lengths]


def net_angles(
    space: SpaceForm,
    functions: Any,
    u_lengths: Sequence[Scalar],
    v_lengths: Sequence[Scalar],
    corner_angle: Scalar,
    *,
    u_turns: Sequence[Scalar] | None = None,
    v_turns: Sequence[Scalar] | None = None,
) -> NetAngles:
    """Angles of the net with these sides, for scalars of any kind; nothing is checked.

    Without turns the sides are geodesics (Amsler data). Turns: see `fill_angles` and `side_turns`.
    """
    n, m = len(u_lengths), len(v_lengths)
    angles, defects = ([[None] * m for _ in range(n)] for _ in range(2))
    fill_angles(
        partial(half_defect, functions),
        *half_tangents(space, functions, u_lengths, v_lengths),
        corner_angle,
        [0] * (n - 1) if u_turns is None else u_turns,
        [0] * (m - 1) if v_turns is None else v_turns,
        angles,
        defects,
    )
    return NetAngles(
        space=space, u_lengths=u_lengths, v_lengths=v_lengths, angles=angles, half_defects=defects
    )


def side_turns(
    space: SpaceForm, functions: Any, side: Sequence[Triple], *, net_on_left: bool
) -> list[Scalar]:
    """Excess over pi of the angles of a polyline, measured in the net that it bounds.

    The net is on the left of its first side (the u-edges) and on the right of its second.
    """
    sign = -1 if net_on_left else 1
    return [
        sign * turn_at(space, functions, side[k - 1], side[k], side[k + 1])
        for k in range(1, len(side) - 1)
    ]


def require_lengths(
    space: SpaceForm, u_lengths: Sequence[float], v_lengths: Sequence[float]
) -> None:
    """Refuse float edge lengths that are not finite and positive, or too long for S^2.

    Raises ShapeError, NotFiniteError, EdgeLengthError, naming the edge.
    """
    for name, lengths in (("u", u_lengths), ("v", v_lengths)):
        if len(lengths) == 0:
            raise ShapeError(f"there are no {name}-edges: a rectangle has one quad at least")
        for k, length in enumerate(lengths):
            if not isfinite(length):
                raise NotFiniteError(f"{name}-edge {k} has the length {length}")
            if length <= 0:
                raise EdgeLengthError(f"{name}-edge {k} has the length {length}, not positive")
    longest = max(u_lengths) + max(v_lengths)
    if longest >= (pi if space.curvature > 0 else inf):
        raise EdgeLengthError(
            f"the longest u- and v-edge on S^2 add up to {longest}, not below pi: the quads "
            "between them do not close in one way"
        )


def require_angles(
    corner_angle: float, turns: dict[str, Sequence[float]], counts: dict[str, int]
) -> None:
    """Refuse a corner angle outside (0, pi) and turns that are too many, too few or too sharp.

    Raises AngleError, NotFiniteError, ShapeError.
    """
    if not 0 < corner_angle < pi:
        raise AngleError(f"the angle at vertex (0, 0) is {corner_angle}, not between 0 and pi")
    for name, values in turns.items():
        if len(values) != counts[name]:
            raise ShapeError(
                f"{len(values)} turns for the {counts[name]} inner vertices of the {name}-side"
            )
        for k, turn in enumerate(values):
            if not isfinite(turn):
                raise NotFiniteError(f"the turn at vertex {k + 1} of the {name}-side is {turn}")
            if abs(turn) >= pi:
                raise AngleError(f"the turn at vertex {k + 1} of the {name}-side is {turn}")


def checked_net_angles(
    space: SpaceForm,
    u_lengths: Sequence[float],
    v_lengths: Sequence[float],
    corner_angle: float,
    *,
    u_turns: Sequence[float] | None = None,
    v_turns: Sequence[float] | None = None,
) -> NetAngles:
    """Angles in float64 by the compiled body, as arrays (n, m), from a user's data.

    Raises ShapeError, NotFiniteError, EdgeLengthError, AngleError, naming the edge or vertex.
    """
    from discrete.angle_kernel import filled_angles

    require_lengths(space, u_lengths, v_lengths)
    counts = {"u": len(u_lengths) - 1, "v": len(v_lengths) - 1}
    turns = {
        "u": [0.0] * counts["u"] if u_turns is None else u_turns,
        "v": [0.0] * counts["v"] if v_turns is None else v_turns,
    }
    require_angles(corner_angle, turns, counts)
    angles, defects = filled_angles(
        space, u_lengths, v_lengths, corner_angle, turns["u"], turns["v"]
    )
    return NetAngles(
        space=space, u_lengths=u_lengths, v_lengths=v_lengths, angles=angles, half_defects=defects
    )
