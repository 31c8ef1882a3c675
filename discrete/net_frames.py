"""Positions on a hyperbolic net from its angles: frames moved along the edges, re-centred at will.

The frame of vertex (i, j) points along its u-edge to (i + 1, j); on the last column it points
straight on from the edge that arrives. A step is (turn, length, turn): turn on the spot, follow the
edge, turn on arrival. Frames are relative to the vertex from which the walk starts, so distances
and bearings from there keep their digits at any distance.
"""

from collections.abc import Iterator
from typing import Any, TypeAlias

from discrete.angle_advance import NetAngles
from discrete.errors import DiscreteError
from discrete.sl2_frames import IDENTITY, Frame, advanced, turned
from discrete.space_forms import Scalar

Step: TypeAlias = tuple[Scalar, Scalar, Scalar]


def u_step(net: NetAngles, i: int, j: int) -> Step:
    """Step from vertex (i, j) to (i + 1, j)."""
    angles, defects = net.angles, net.half_defects
    if i + 1 == len(net.u_lengths):
        turn = 0
    elif j < len(net.v_lengths):
        turn = (angles[i][j] - angles[i + 1][j]) + defects[i][j]
    else:
        turn = (angles[i][j - 1] - angles[i + 1][j - 1]) - defects[i + 1][j - 1]
    return (0, net.u_lengths[i], turn)


def v_step(net: NetAngles, i: int, j: int) -> Step:
    """Step from vertex (i, j) to (i, j + 1)."""
    last = i == len(net.u_lengths)
    near = net.angles[i - last][j]
    far = near + net.half_defects[i - last][j]
    return (far, net.v_lengths[j], -near) if last else (near, net.v_lengths[j], -far)


def reversed_step(step: Step) -> Step:
    """Step back along the same edge."""
    return (-step[2], -step[1], -step[0])


def followed(functions: Any, g: Frame, step: Step) -> Frame:
    """Frame after a step."""
    return turned(functions, advanced(functions, turned(functions, g, step[0]), step[1]), step[2])


def path(net: NetAngles, start: tuple[int, int], end: tuple[int, int]) -> Iterator[Step]:
    """Steps from a vertex to another, first along u-edges, then along v-edges."""
    (i, j), (k, n) = start, end
    while i < k:
        yield u_step(net, i, j)
        i += 1
    while i > k:
        i -= 1
        yield reversed_step(u_step(net, i, j))
    while j < n:
        yield v_step(net, i, j)
        j += 1
    while j > n:
        j -= 1
        yield reversed_step(v_step(net, i, j))


def relative_frame(
    net: NetAngles, functions: Any, start: tuple[int, int], end: tuple[int, int]
) -> Frame:
    """Frame of vertex `end` seen from that of vertex `start`.

    Raises DiscreteError for a vertex outside the net, or a net that is not hyperbolic.
    """
    require_hyperbolic(net)
    for i, j in (start, end):
        if not (0 <= i <= len(net.u_lengths) and 0 <= j <= len(net.v_lengths)):
            raise DiscreteError(f"the net has no vertex ({i}, {j})")
    g: Frame = IDENTITY
    for step in path(net, start, end):
        g = followed(functions, g, step)
    return g


def net_frames(net: NetAngles, functions: Any) -> list[list[Frame]]:
    """Frames [i][j] of all vertices, seen from vertex (0, 0). Raises DiscreteError on S^2."""
    require_hyperbolic(net)
    columns: list[list[Frame]] = [[IDENTITY]]
    for i in range(len(net.u_lengths)):
        columns.append([followed(functions, columns[i][0], u_step(net, i, 0))])
    for i, column in enumerate(columns):
        for j in range(len(net.v_lengths)):
            column.append(followed(functions, column[j], v_step(net, i, j)))
    return columns


def require_hyperbolic(net: NetAngles) -> None:
    """Refuse a net on S^2, where triples keep their digits. Raises DiscreteError."""
    if net.space.curvature > 0:
        raise DiscreteError("frames of SL(2, R) belong to H^2; on S^2 use discrete.goursat_fill")
