"""Sides of a sector in balls: heights and turns, and exact distances where it is an axis.

As discrete.sector_sides, with balls of flint at the precision in force in place of floats. Frames
are those of discrete.sl2_frames, all seen from the centre.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from discrete.certified_area import ClippingDisk
from discrete.elementary import ball_functions
from discrete.greedy_parameters import GreedyParameters
from discrete.sl2_frames import Frame, advanced, triple_of, turned


class UndecidedError(ArithmeticError):
    """A ball is too wide at the precision in force: internal, the run is begun anew."""


def ball_of(value: Fraction) -> Any:
    """Ball around a rational number."""
    from flint import arb, fmpq

    return arb(fmpq(value.numerator, value.denominator))


@dataclass(frozen=True, kw_only=True, eq=False)
class BallSide:
    """Heights and turns of the vertices of a side, from the corner on.

    start: distance of the corner from the centre where the side goes straight away from it, so
    that vertex n lies at start + n step exactly; else None.
    """

    heights: Sequence[Any]
    turns: Sequence[Any]
    start: Fraction | None = None

    def from_vertex(self, n: int, step: Fraction, first_turn: Any) -> "BallSide":
        """Side beyond its vertex n, with this entry for the turn there."""
        return BallSide(
            heights=self.heights[n:],
            turns=[first_turn, *self.turns[n + 1 :]],
            start=None if self.start is None else self.start + n * step,
        )

    def with_first_turn(self, turn: Any) -> "BallSide":
        """Side with this entry for its corner."""
        return BallSide(heights=self.heights, turns=[turn, *self.turns[1:]], start=self.start)


@dataclass(frozen=True, kw_only=True, eq=False)
class BallSector:
    """Sector to be swept: see SectorSides; frame: at its corner along the u-edge.

    path: its letters below the initial sector; second.turns[0] is the angle at the corner.
    """

    path: str
    copies: int
    mirrored: bool
    hand: int
    frame: Frame
    first: BallSide
    second: BallSide

    @property
    def opening(self) -> Any:
        """Ball around the angle at the corner."""
        return self.second.turns[0]


@dataclass(frozen=True, kw_only=True, eq=False)
class BallConstants:
    """Balls that a run needs again and again; outer: height up to which the lines are made.

    reach: height below which a quad that meets the disk has a vertex (see run_constants of
    GreedyParameters); q: square of tanh(step/2); clipping: the disk as it cuts quads.
    """

    parameters: GreedyParameters
    q: Any
    rim: Any
    reach: Any
    outer: Any
    cutoff: Any
    clipping: ClippingDisk

    @classmethod
    def of(cls, parameters: GreedyParameters, margin: Fraction) -> "BallConstants":
        """Constants at the precision in force; margin: width of the ring around the disk."""
        half, radius = ball_of(parameters.step / 2), ball_of(parameters.radius)
        sinh, cosh = ball_of(parameters.step).sinh_cosh()
        return cls(
            parameters=parameters,
            q=half.tanh() ** 2,
            rim=radius.cosh(),
            reach=radius.cosh() * half.cosh(),
            outer=ball_of(parameters.radius + margin).cosh(),
            cutoff=parameters.cutoff.ball(),
            clipping=ClippingDisk(rim=radius.cosh(), cosh_length=cosh, sinh_length=sinh),
        )


def geodesic_side(
    constants: BallConstants, frame: Frame, first_turn: Any, *, start: Fraction | None = None
) -> BallSide:
    """Side along the geodesic of a frame, up to the first vertex beyond the height `outer`.

    h cosh t + h' sinh t, h' the derivative of the height along the frame. For a frame in the disk.
    """
    from flint import arb

    height = triple_of(frame)[0]
    # Products: flint's power of a ball around 0 is NaN.
    a, b, c, d = (entry * entry for entry in frame)
    slope = (a - b + c - d) / 2
    step, heights, n = constants.parameters.step, [height + arb(0)], 0
    while not heights[-1] > constants.outer:
        n += 1
        t = ball_of(n * step)
        sinh, cosh = t.sinh_cosh()
        heights.append(height * cosh + slope * sinh)
        if not heights[-1].is_finite():
            raise UndecidedError
    return BallSide(heights=heights, turns=[first_turn] + [arb(0)] * n, start=start)


def initial_ball_sector(constants: BallConstants) -> BallSector:
    """First sector at the centre, between the directions 0 and phi0."""
    from flint import arb

    frame = (arb(1), arb(0), arb(0), arb(1))
    axis = geodesic_side(constants, frame, arb(0), start=Fraction(0))
    return BallSector(
        path="",
        copies=constants.parameters.sectors,
        mirrored=True,
        hand=1,
        frame=frame,
        first=axis,
        second=axis.with_first_turn(constants.parameters.phi0.ball()),
    )


def frame_at_cut(sector: BallSector, step: Fraction, row: BallSide, i: int, k: int) -> Frame:
    """Frame at vertex (i, k) along its row; row: the row k of vertices from the second side on."""
    functions, frame = ball_functions(), sector.frame
    length = ball_of(step)
    if k > 0:
        frame = turned(functions, frame, sector.hand * sector.opening)
        for j in range(1, k + 1):
            frame = turned(
                functions, advanced(functions, frame, length), sector.hand * sector.second.turns[j]
            )
        frame = turned(functions, frame, -sector.hand * row.turns[0])
    for j in range(1, i + 1):
        frame = turned(functions, advanced(functions, frame, length), -sector.hand * row.turns[j])
    return frame
