"""Sector of the greedy algorithm before it is swept: its place in the disk and its two sides.

A side is given by the heights of its vertices (cosh of the distance from the centre) and by its
turns, measured in the sector. Its place: polar coordinates (theta, rho) of the corner, and the
heading of the u-edge there, counterclockwise from the direction away from the centre.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from discrete import sl2_frames
from discrete.greedy_parameters import GreedyParameters

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class Place:
    """Corner of a sector at (theta, rho), heading of its u-edge; hand: 1 if v lies left of u."""

    theta: float
    rho: float
    heading: float
    hand: int


@dataclass(frozen=True, kw_only=True, eq=False)
class SectorSides:
    """Sector between two sides, the u-edges first; copies: how many images of it the disk holds.

    mirrored: whether it is its own image under the reflection that swaps the sides.
    first_turns[0] is 0 and second_turns[0] the angle `opening` at the corner.
    """

    parent: int
    letter: int
    generation: int
    copies: int
    mirrored: bool
    place: Place
    opening: float
    first_heights: FloatArray
    first_turns: FloatArray
    second_heights: FloatArray
    second_turns: FloatArray


def geodesic_heights(
    parameters: GreedyParameters, outer: float, rho: float, heading: float
) -> FloatArray:
    """Heights of the vertices of a geodesic side, up to the first beyond the height `outer`.

    From a corner in the disk; heights are convex along a geodesic, so that it leaves the disk once.
    """
    step = float(parameters.step)
    count = math.ceil((rho + math.acosh(outer)) / step) + 2
    t = step * np.arange(count)
    heights = math.cosh(rho) * np.cosh(t) + math.sinh(rho) * math.cos(heading) * np.sinh(t)
    return np.asarray(heights[: int(np.count_nonzero(heights <= outer)) + 1])


def axis_heights(parameters: GreedyParameters, outer: float) -> FloatArray:
    """Heights of an axis through the centre: that of a vertex on the rim is cosh(R) exactly."""
    heights = geodesic_heights(parameters, outer, 0.0, 0.0)
    at = parameters.radius / parameters.step
    if at.denominator == 1:
        heights[int(at)] = math.cosh(float(parameters.radius))
    return heights


def straight_turns(heights: FloatArray, first: float) -> FloatArray:
    """Turns of a geodesic side, with this entry for its corner."""
    turns = np.zeros(len(heights))
    turns[0] = first
    return turns


def initial_sector(parameters: GreedyParameters, outer: float) -> SectorSides:
    """First sector at the centre, between the directions 0 and phi0."""
    axis, phi0 = axis_heights(parameters, outer), float(parameters.phi0)
    return SectorSides(
        parent=-1,
        letter=0,
        generation=0,
        copies=parameters.sectors,
        mirrored=True,
        place=Place(theta=0.0, rho=0.0, heading=0.0, hand=1),
        opening=phi0,
        first_heights=axis,
        first_turns=straight_turns(axis, 0.0),
        second_heights=axis,
        second_turns=straight_turns(axis, phi0),
    )


def start_frame(place: Place) -> sl2_frames.Frame:
    """Frame at the corner of a sector along its u-edge, seen from the centre towards the corner."""
    there = sl2_frames.advanced(math, sl2_frames.IDENTITY, place.rho)
    return sl2_frames.turned(math, there, place.heading)


def place_of(frame: sl2_frames.Frame, start: Place) -> Place:
    """Place of a frame, seen from the centre towards the corner that the path to it starts from."""
    back = sl2_frames.bearing_from_start(math, sl2_frames.inverse(frame))
    theta = start.theta + sl2_frames.bearing_from_start(math, frame)
    return Place(
        theta=math.remainder(theta, 2 * math.pi),
        rho=sl2_frames.distance_from_start(math, frame),
        heading=math.remainder(-math.pi - back, 2 * math.pi),
        hand=start.hand,
    )


def daughters(
    parameters: GreedyParameters,
    outer: float,
    parent: SectorSides,
    number: int,
    place: Place,
    cut_angle: float,
    row: tuple[FloatArray, FloatArray],
    column: tuple[FloatArray, FloatArray],
) -> list[SectorSides]:
    """Sectors u, A, v put in at a cut (lem:surgery, steps 15 to 17); of a mirrored parent, u and A.

    number: of the parent; place: of the cut, heading along the row; row, column: heights and turns
    of the lines that bound what was cut out, from the cut on. The two new sides are geodesics that
    trisect the angle there.
    """
    opening = cut_angle / 3
    turned = [place.heading + k * place.hand * opening for k in (1, 2)]
    near = geodesic_heights(parameters, outer, place.rho, turned[0])
    far = near if parent.mirrored else geodesic_heights(parameters, outer, place.rho, turned[1])
    second = Place(theta=place.theta, rho=place.rho, heading=turned[1], hand=place.hand)
    middle = Place(theta=place.theta, rho=place.rho, heading=turned[1], hand=-place.hand)
    sides: list[tuple[Place, tuple[Any, Any], tuple[Any, Any]]] = [
        (place, row, (near, straight_turns(near, opening))),
        (middle, (far, straight_turns(far, 0.0)), (near, straight_turns(near, opening))),
        (second, (far, straight_turns(far, 0.0)), column),
    ]
    return [
        SectorSides(
            parent=number,
            letter=letter,
            generation=parent.generation + 1,
            copies=parent.copies * (2 if parent.mirrored and letter == 1 else 1),
            mirrored=parent.mirrored and letter == 2,
            place=at,
            opening=opening,
            first_heights=first[0],
            first_turns=first[1],
            second_heights=other[0],
            second_turns=other[1],
        )
        for letter, (at, first, other) in enumerate(sides, start=1)
        if not (parent.mirrored and letter == 3)
    ]
