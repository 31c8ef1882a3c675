"""A corpus of complexes, and random ones by recursive surgery, with random angles."""

from fractions import Fraction

import numpy as np
from flint import arb

from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import SurgeryError
from discrete.complex_surgery import attached, surgery
from discrete.gluing import grid, rectangle, star

MOST = 6
"""Largest order of saddleness of the random complexes."""


def face_at(complex_: AsymptoticComplex, vertex: int) -> int:
    """First face at a vertex."""
    return int(np.flatnonzero((complex_.faces == vertex).any(axis=1))[0])


def operated_grid() -> AsymptoticComplex:
    """Grid of 6 by 6 with one quadrant of its middle replaced by three sectors."""
    middle = int(grid(6, 6)[3, 3])
    complex_ = rectangle(6, 6)
    return surgery(complex_, middle, face_at(complex_, middle), [2, 4])[0]


def recursive(depth: int) -> AsymptoticComplex:
    """Monkey saddle with surgery in a sector, then in a sector of that branch point, and so on."""
    complex_ = star([4] * 6)
    for _ in range(depth):
        # The last interior vertex of degree 4 is well inside the newest sectors.
        inner = np.flatnonzero(complex_.saddle_order == 2)
        for vertex in inner[::-1]:
            try:
                complex_, _ = surgery(complex_, int(vertex), face_at(complex_, int(vertex)), [4, 4])
                break
            except SurgeryError:
                continue
    return complex_


CORPUS = {
    "one rectangle": rectangle(1, 1),
    "grid": rectangle(5, 3),
    "smooth star": star([3, 2, 4, 1]),
    "monkey star": star([2] * 6),
    "star of order 12": star([2, 1] * 12),
    "star of order 50": star([1] * 100),
    "operated grid": operated_grid(),
    "closed corner": attached(rectangle(3, 2), 0, [2, 1])[0],
    "seven sectors put in": attached(rectangle(3, 2), 0, [1, 2, 3, 1, 2, 2])[0],
    "recursive, twice": recursive(2),
    "recursive, five times": recursive(5),
}


def random_complex(rng: np.random.Generator, steps: int) -> AsymptoticComplex:
    """Star or grid after random surgeries, its branch points of orders 3 to 6."""
    m = int(rng.integers(2, MOST + 1))
    complex_ = star([int(n) for n in rng.integers(2, 5, size=2 * m)])
    done = tries = 0
    while done < steps and tries < 10 * steps:
        tries += 1
        vertex = int(rng.choice(np.flatnonzero(~complex_.is_boundary)))
        room = MOST - int(complex_.saddle_order[vertex])
        if room < 1:
            continue
        faces = np.flatnonzero((complex_.faces == vertex).any(axis=1))
        lengths = [int(n) for n in rng.integers(1, 4, size=2 * int(rng.integers(1, room + 1)))]
        try:
            complex_, _ = surgery(complex_, vertex, int(rng.choice(faces)), lengths)
            done += 1
        except SurgeryError:
            continue
    return complex_


def float_angles(complex_: AsymptoticComplex, rng: np.random.Generator) -> np.ndarray:
    """Random angles whose sum is 2 pi at each interior vertex, to rounding."""
    angles = rng.uniform(0.2, 2.9, size=complex_.faces.shape)
    sums = np.bincount(complex_.faces.ravel(), angles.ravel(), complex_.vertex_count)
    factor = np.where(complex_.is_boundary, 1, 2 * np.pi / sums)
    return angles * factor[complex_.faces]


def exact_angles(complex_: AsymptoticComplex, rng: np.random.Generator) -> np.ndarray:
    """Random fractions of pi whose sum is 2 at each interior vertex."""
    raw = rng.integers(1, 30, size=complex_.faces.shape)
    sums = np.bincount(complex_.faces.ravel(), raw.ravel(), complex_.vertex_count).astype(int)
    angles = np.empty(complex_.faces.shape, dtype=object)
    for (face, corner), n in np.ndenumerate(raw):
        vertex = complex_.faces[face, corner]
        free = complex_.is_boundary[vertex]
        angles[face, corner] = (
            Fraction(int(n), 40) if free else Fraction(2 * int(n), int(sums[vertex]))
        )
    return angles


def ball_angles(fractions: np.ndarray) -> np.ndarray:
    """Balls around these fractions of pi, at the precision in force."""
    ball = np.frompyfunc(lambda a: arb.pi() * a.numerator / a.denominator, 1, 1)
    return ball(fractions)
