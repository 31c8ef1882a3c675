"""Stars of the plane with rational data: rays around the origin, a sector between two neighbours.

Ray i has a rational unit direction and a length; indices are cyclic modulo the number of rays. A
sector is found as an intersection of strips, by cross products alone. All is exact (Fraction).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import pi, tan
from random import Random

from theory.errors import DomainError

Point = tuple[Fraction, Fraction]


def cross2(a: Point, b: Point) -> Fraction:
    """Cross product of two vectors of the plane."""
    return a[0] * b[1] - a[1] * b[0]


def dot2(a: Point, b: Point) -> Fraction:
    """Inner product of two vectors of the plane."""
    return a[0] * b[0] + a[1] * b[1]


def unit(t: Fraction) -> Point:
    """Unit vector at the polar angle 2 atan t."""
    return ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))


@dataclass(frozen=True, kw_only=True)
class Star:
    """Star with the directions s_1, ..., s_n of its rays and their lengths l_1, ..., l_n.

    Raises DomainError unless the directions are unit vectors that turn once about the origin by
    steps in (0, pi), and the lengths are positive.
    """

    directions: tuple[Point, ...]
    lengths: tuple[Fraction, ...]

    def __post_init__(self) -> None:
        n = len(self.directions)
        if any(dot2(s, s) != 1 for s in self.directions):
            raise DomainError("every direction must be a unit vector")
        if len(self.lengths) != n or any(length <= 0 for length in self.lengths):
            raise DomainError("every ray needs a positive length")
        if any(self.sine(i) <= 0 for i in range(n)):
            raise DomainError("neighbouring rays must enclose an angle in (0, pi)")
        upwards = sum(self.ray(i - 1)[1] < 0 <= self.ray(i)[1] for i in range(n))
        if upwards != 1:
            raise DomainError(f"the rays turn {upwards} times about the origin")

    @property
    def rays(self) -> range:
        """Indices 1, ..., n of the rays and of the sectors."""
        return range(1, len(self.directions) + 1)

    def ray(self, i: int) -> Point:
        """Direction of ray i."""
        return self.directions[(i - 1) % len(self.directions)]

    def length(self, i: int) -> Fraction:
        """Length of ray i."""
        return self.lengths[(i - 1) % len(self.lengths)]

    def sine(self, i: int) -> Fraction:
        """Sine of the angle from ray i - 1 to ray i."""
        return cross2(self.ray(i - 1), self.ray(i))

    def widths(self, i: int, x: Point) -> tuple[Fraction, Fraction]:
        """Distances of x from the lines of ray i and of ray i - 1, positive inside sector i."""
        return cross2(x, self.ray(i)), cross2(self.ray(i - 1), x)

    def in_cone(self, i: int, x: Point) -> bool:
        """Whether the polar angle of x lies between those of ray i - 1 and ray i, or x is 0."""
        first, second = self.widths(i, x)
        return first >= 0 and second >= 0

    def in_sector(self, i: int, x: Point) -> bool:
        """Whether x lies in sector i, with its two rays and without its two outer sides."""
        first, second = self.widths(i, x)
        sine = self.sine(i)
        return 0 <= first < self.length(i - 1) * sine and 0 <= second < self.length(i) * sine

    def inside_sector(self, i: int, x: Point) -> bool:
        """Whether x lies in the interior of sector i."""
        first, second = self.widths(i, x)
        return self.in_sector(i, x) and first > 0 and second > 0

    def sectors_of(self, x: Point) -> tuple[int, ...]:
        """Indices of the sectors that hold x."""
        return tuple(i for i in self.rays if self.in_sector(i, x))


def point(a: Fraction, first: Point, b: Fraction, second: Point) -> Point:
    """Combination a first + b second."""
    return (a * first[0] + b * second[0], a * first[1] + b * second[1])


def random_star(rng: Random, order: int) -> Star:
    """Star of 2 order rays in random directions, ray 2 order being the x-axis; random lengths.

    >>> len(random_star(Random(1), 3).directions)
    6
    """
    for _ in range(1000):
        weights = [rng.uniform(0.15, 1.0) for _ in range(2 * order)]
        total, angle, found = sum(weights), 0.0, []
        for weight in weights[:-1]:
            angle += 2 * pi * weight / total
            found.append(unit(Fraction(tan(angle / 2)).limit_denominator(40)))
        lengths = tuple(Fraction(rng.randint(3, 20), 10) for _ in range(2 * order))
        try:
            return Star(directions=(*found, (Fraction(1), Fraction(0))), lengths=lengths)
        except DomainError:
            continue
    raise DomainError(f"found no star of order {order}")


def sample_points(star: Star, i: int, shares: Sequence[Fraction]) -> list[Point]:
    """Points of sector i at these shares in [0, 1) of the lengths of its two rays."""
    first, second = star.length(i - 1), star.length(i)
    return [
        point(p * first, star.ray(i - 1), q * second, star.ray(i)) for p in shares for q in shares
    ]
