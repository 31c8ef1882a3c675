r"""Pseudospherical surfaces around a missing quadrant of asymptotic coordinates, small in scale.

To first order in its size a surface of curvature -1 is a translation net: r = A(u) + B(v) and
N = e3 + i (A(u) - B(v)) in the tangent plane, A and B plane curves of unit speed with directions
alpha(u), beta(v), and phi = beta - alpha. Here alpha steps from -theta to gamma at u = 0 and on to
theta - pi/2, and B is the mirror image of A. All angles are in [phi0, pi - phi0] on the closed
region Q = {u <= 0} + {v >= 0}, the complement of a quadrant, whose corner is folded; two points of
Q have one normal. With s = (1 - i t)/(1 + i t), e^(i theta) = i s and e^(i gamma) = i s^3, t
rational, everything is exact: tan theta = (1 - t^2)/(2 t), phi0 = 4 arctan t.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

Point = tuple[Fraction, Fraction]
ZERO = Fraction(0)


def times(a: Point, b: Point) -> Point:
    """Product of two complex numbers."""
    return (a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0])


def plus(a: Point, b: Point) -> Point:
    """Sum of two complex numbers."""
    return (a[0] + b[0], a[1] + b[1])


def along(length: Fraction, direction: Point) -> Point:
    """Real multiple of a complex number."""
    return (length * direction[0], length * direction[1])


def square(a: Point, b: Point) -> Fraction:
    """Squared distance of two points."""
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2


def squared_distance(point: Point, start: Point, end: Point) -> Fraction:
    """Squared distance of a point from a segment."""
    side = (end[0] - start[0], end[1] - start[1])
    to = (point[0] - start[0], point[1] - start[1])
    length = side[0] ** 2 + side[1] ** 2
    share = (to[0] * side[0] + to[1] * side[1]) / length if length else ZERO
    share = min(max(share, ZERO), Fraction(1))
    return square(point, plus(start, along(share, side)))


@dataclass(frozen=True, kw_only=True)
class FoldedCorner:
    """Translation net of this family, exact; lengths in units of the side m of the double point.

    t: tan(phi0/4), in (0, 1/5); spare: how far alpha = gamma reaches beyond the double point;
    extent: half the side of the square of (u, v). Raises ValueError outside of these ranges.
    """

    t: Fraction
    spare: Fraction
    extent: Fraction = Fraction(4)

    def __post_init__(self) -> None:
        if not 0 < self.t < Fraction(1, 5):
            raise ValueError(f"expected 0 < t < 1/5, so that gamma > 0, got {self.t}")
        if not 0 < self.spare < 1 or not self.extent > 2 + self.arm + self.spare:
            raise ValueError("the square does not hold the double point: enlarge the extent")

    @property
    def turn(self) -> Point:
        """Unit complex number s, of argument -2 arctan t = theta - pi/2."""
        norm = 1 + self.t**2
        return ((1 - self.t**2) / norm, -2 * self.t / norm)

    @property
    def steep(self) -> Point:
        """Unit complex number of argument theta."""
        return times((ZERO, Fraction(1)), self.turn)

    @property
    def bent(self) -> Point:
        """Unit complex number of argument gamma = 3 theta - pi."""
        return times(self.steep, times(self.turn, self.turn))

    @property
    def arm(self) -> Fraction:
        """Length l with l sin gamma = sin theta: the chords of A and of B are then parallel."""
        return self.steep[1] / self.bent[1]

    @property
    def curvature(self) -> Fraction:
        """Largest principal curvature, cot(phi0/2) = tan theta."""
        return (1 - self.t**2) / (2 * self.t)

    @property
    def sine(self) -> Fraction:
        """Sine of phi0, the least of sin phi."""
        return 2 * self.steep[0] * self.steep[1]

    def knots(self) -> tuple[Fraction, ...]:
        """Values of u where alpha steps; -u where beta does."""
        return (ZERO, self.arm + self.spare)

    def on_u(self, u: Fraction) -> Point:
        """Point A(u), with A(0) = 0."""
        far = self.arm + self.spare
        if u <= 0:
            return along(u, (self.steep[0], -self.steep[1]))
        return plus(along(min(u, far), self.bent), along(max(u - far, ZERO), self.turn))

    def on_v(self, v: Fraction) -> Point:
        """Point B(v), the mirror image of A(-v) in the imaginary axis."""
        x, y = self.on_u(-v)
        return (-x, y)

    def position(self, place: Point) -> Point:
        """Image r of (u, v) in the plane."""
        return plus(self.on_u(place[0]), self.on_v(place[1]))

    def normal(self, place: Point) -> Point:
        """Tangential part i (A - B) of the normal at (u, v)."""
        a, b = self.on_u(place[0]), self.on_v(place[1])
        return (b[1] - a[1], a[0] - b[0])

    def double_point(self) -> tuple[Point, Point]:
        """Both places (u, v) with one normal, the right one first."""
        return (self.arm, Fraction(1)), (Fraction(-1), -self.arm)

    def path(self) -> tuple[Point, ...]:
        """Corners of the broken line in Q whose image is the segment between the double points."""
        right, left = self.double_point()
        return (left, (Fraction(-2), ZERO), (ZERO, Fraction(2)), right)

    def boundary(self) -> tuple[Point, ...]:
        """Corners in the plane of the image of the boundary of Q in the square, a closed polygon.

        It runs from the folded corner along u >= 0, around the square, and back along v <= 0.
        """
        far, end = self.arm + self.spare, self.extent
        places = [(ZERO, ZERO), (far, ZERO), (end, ZERO), (end, end), (far, end), (ZERO, end)]
        places += [(-end, end), (-end, ZERO), (-end, -far), (-end, -end)]
        places += [(ZERO, -end), (ZERO, -far), (ZERO, ZERO)]
        return tuple(self.position(place) for place in places)

    def squared_room(self) -> Fraction:
        """Squared distance of the left double point from the image of the boundary."""
        centre = self.position(self.double_point()[1])
        corners = self.boundary()
        return min(squared_distance(centre, a, b) for a, b in pairwise(corners))

    def separation(self) -> Fraction:
        """Distance between the images of the double points, which have one height."""
        right, left = (self.position(place) for place in self.double_point())
        return right[0] - left[0]
