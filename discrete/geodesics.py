"""Geodesics of S^2 and H^2: points at a distance, distances, midpoints, angles.

`functions` is a set of elementary functions (see discrete.elementary). Distances and angles keep
their relative precision where points nearly coincide. What is far from (1, 0, 0) on H^2 does not:
triples at distance R carry an error of e^(2 R) units, so large nets use discrete.sl2_frames.
"""

from typing import Any

from discrete.space_forms import Scalar, SpaceForm, Triple


def difference(a: Triple, b: Triple) -> Triple:
    """Vector a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def determinant(a: Triple, b: Triple, c: Triple) -> Scalar:
    """Determinant of three triples."""
    return (
        a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
    )


def distance(space: SpaceForm, functions: Any, p: Triple, q: Triple) -> Scalar:
    """Geodesic distance of p and q, from the half chord: no cancellation where they are close."""
    chord = difference(p, q)
    length = functions.sqrt(space.dot(chord, chord))
    if space.curvature < 0:
        return 2 * functions.asinh(length / 2)
    s = (p[0] + q[0], p[1] + q[1], p[2] + q[2])
    return 2 * functions.atan2(length, functions.sqrt(space.dot(s, s)))


def midpoint(space: SpaceForm, functions: Any, p: Triple, q: Triple) -> Triple:
    """Midpoint of the geodesic from p to q. Undefined for antipodal points of S^2."""
    s = (p[0] + q[0], p[1] + q[1], p[2] + q[2])
    norm = functions.sqrt(space.curvature * space.dot(s, s))
    return (s[0] / norm, s[1] / norm, s[2] / norm)


def tangent_part(space: SpaceForm, p: Triple, q: Triple) -> Triple:
    """Part of q - p tangent at p; it points along the geodesic and has the length sin or sinh d."""
    chord = difference(q, p)
    half = space.dot(chord, chord) / 2
    return (
        chord[0] + half * p[0] * space.curvature,
        chord[1] + half * p[1] * space.curvature,
        chord[2] + half * p[2] * space.curvature,
    )


def direction(space: SpaceForm, functions: Any, p: Triple, q: Triple) -> Triple:
    """Unit tangent at p of the geodesic to q. Undefined where they coincide or are antipodal."""
    part = tangent_part(space, p, q)
    norm = functions.sqrt(space.dot(part, part))
    return (part[0] / norm, part[1] / norm, part[2] / norm)


def turned_direction(
    space: SpaceForm, functions: Any, p: Triple, along: Triple, angle: Scalar
) -> Triple:
    """Unit tangent `along` at p, turned by an angle (positive: from x1 to x2 at the origin)."""
    normal = space.cross(p, along)
    c, s = functions.cos(angle), functions.sin(angle)
    return (
        c * along[0] + s * normal[0],
        c * along[1] + s * normal[1],
        c * along[2] + s * normal[2],
    )


def point_along(
    space: SpaceForm, functions: Any, p: Triple, along: Triple, length: Scalar
) -> Triple:
    """Point at a signed distance on the geodesic that leaves p with the unit tangent `along`."""
    c, s = space.cosine(functions, length), space.sine(functions, length)
    return (c * p[0] + s * along[0], c * p[1] + s * along[1], c * p[2] + s * along[2])


def polar(space: SpaceForm, functions: Any, angle: Scalar, length: Scalar) -> Triple:
    """Point at a distance from the origin (1, 0, 0), in the direction of an angle from x1 to x2.

    Equally spaced points on a geodesic through the origin (geodesics): length = n Delta.
    """
    s = space.sine(functions, length)
    return (
        space.cosine(functions, length),
        s * functions.cos(angle),
        s * functions.sin(angle),
    )


def sine_and_cosine_part(
    space: SpaceForm, p: Triple, p1: Triple, p2: Triple
) -> tuple[Scalar, Scalar]:
    """Sine and cosine of the angle at p from p1 to p2, times the same positive factor.

    From the tangent parts of the chords: no cancellation for short edges, nor for one short edge
    beside a long one.
    """
    t1, t2 = tangent_part(space, p, p1), tangent_part(space, p, p2)
    return determinant(p, t1, t2), space.dot(t1, t2)


def angle_at(space: SpaceForm, functions: Any, p: Triple, p1: Triple, p2: Triple) -> Scalar:
    """Signed angle at p from the edge to p1 to the edge to p2, in (-pi, pi].

    Positive where the turn is from x1 to x2 at the origin. Undefined where p is p1 or p2.
    """
    sine, cosine = sine_and_cosine_part(space, p, p1, p2)
    return functions.atan2(sine, cosine)


def turn_at(space: SpaceForm, functions: Any, before: Triple, p: Triple, after: Triple) -> Scalar:
    """Left turn at p of the polyline before, p, after, in (-pi, pi]; 0 on a geodesic.

    It keeps its relative precision where the angle of the polyline is nearly pi.
    """
    sine, cosine = sine_and_cosine_part(space, p, before, after)
    return functions.atan2(-sine, -cosine)
