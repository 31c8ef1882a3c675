"""Points and polylines of both space forms for the tests of the nets, seeded by Hypothesis."""

import math

import numpy as np
from hypothesis import strategies as st

from discrete import geodesics
from discrete.space_forms import H2, S2

SPACES = (S2, H2)
BASE = (1.0, 0.0, 0.0)
lengths = st.floats(0.01, 1.4)
angles = st.floats(0.05, 3.09)
directions = st.floats(-3.1, 3.1)


def placed(space, turn, length):
    """Point at a distance from the origin."""
    return geodesics.polar(space, math, turn, length)


def corner(space, p, turn, angle, a, b):
    """Neighbours p1, p2 of p at the distances a, b, with the angle between them."""
    along = geodesics.direction(space, math, p, geodesics.polar(space, math, turn, 1.5))
    other = geodesics.turned_direction(space, math, p, along, angle)
    return (
        geodesics.point_along(space, math, p, along, a),
        geodesics.point_along(space, math, p, other, b),
    )


def polyline(space, start_direction, edges, turns):
    """Vertices of a polyline from the origin with these edge lengths and left turns."""
    vertices = [BASE]
    along = geodesics.turned_direction(space, math, BASE, (0.0, 1.0, 0.0), start_direction)
    for length, turn in zip(edges, [*turns, 0.0], strict=True):
        p = vertices[-1]
        c, s = space.cosine(math, length), space.sine(math, length)
        vertices.append(geodesics.point_along(space, math, p, along, length))
        moved = tuple(c * along[i] - space.curvature * s * p[i] for i in range(3))
        along = geodesics.turned_direction(space, math, vertices[-1], moved, turn)
    return vertices


def array(points):
    """Array (3, n) of a list of triples."""
    return np.array(points, dtype=float).T


def distance(space, p, q):
    """Geodesic distance in floats."""
    return geodesics.distance(space, math, p, q)


def apart(p, q):
    """Largest difference of two triples."""
    return max(abs(a - b) for a, b in zip(p, q, strict=True))
