"""Complexes on which the statements of section 3.3 are tried: disks, bands, tori; their sizes."""

from fractions import Fraction

import numpy as np

from checks.evidence import Setting
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.complex_errors import SurgeryError
from discrete.complex_surgery import attached, surgery
from discrete.face_coordinates import FaceCoordinates, Point
from discrete.gluing import Seam, glued, grid, rectangle, side, star
from discrete.signed_graph import IntArray, components

Samples = dict[str, AsymptoticComplex]
KEEPING_FAMILIES = ((0, 1, 2, 3), (1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0))
"""Orders of the corners of a rectangle in which its u-sides stay u-sides."""


def generator(setting: Setting) -> np.random.Generator:
    """Generator of arrays, from the seed of the check."""
    return np.random.default_rng(setting.random().getrandbits(64))


def band(length: int, *, twisted: bool = False) -> AsymptoticComplex:
    """Rectangles glued along v-edges into a cylinder, or twisted into a Moebius band."""
    last, first = side(1, 1, "u = n"), side(1, 1, "u = 0")
    seams = [
        Seam(
            first=k,
            path=last,
            second=(k + 1) % length,
            onto=first[::-1] if twisted and k == length - 1 else first,
        )
        for k in range(length)
    ]
    return glued([rectangle(1, 1)] * length, seams).complex


def torus(n_u: int, n_v: int) -> AsymptoticComplex:
    """Torus of n_u by n_v rectangles, each at least 3."""
    v = np.arange(n_u * n_v, dtype=np.int64).reshape(n_u, n_v)
    on_u, on_v = np.roll(v, -1, axis=0), np.roll(v, -1, axis=1)
    corners = [v, on_u, np.roll(on_u, -1, axis=1), on_v]
    return AsymptoticComplex(faces=np.stack(corners, axis=-1).reshape(-1, 4))


def face_at(complex_: AsymptoticComplex, vertex: int) -> int:
    """First face that meets a vertex."""
    return int(np.flatnonzero((complex_.faces == vertex).any(axis=1))[0])


def operated_star(inserted: int = 3, *, length: int = 2, new: int = 2) -> AsymptoticComplex:
    """Star of four sectors with one replaced by an odd number of sectors (fig:skew-tcd)."""
    smooth = star([length] * 4)
    return surgery(smooth, 0, face_at(smooth, 0), [new] * (inserted - 1))[0]


def disks() -> Samples:
    """Asymptotic complexes that are disks, the smallest first."""
    middle = int(grid(6, 5)[3, 2])
    plain = rectangle(6, 5)
    return {
        "one rectangle": rectangle(1, 1),
        "block of 2 by 3": rectangle(3, 2),
        "smooth star": star([1] * 4),
        "monkey star": star([1] * 6),
        "star of order 5": star([2, 1, 1, 3, 1, 2, 1, 1, 2, 1]),
        "closed corner": attached(rectangle(2, 2), 0, [1, 2])[0],
        "operated grid": surgery(plain, middle, face_at(plain, middle), [2, 3])[0],
    }


def others() -> Samples:
    """Asymptotic complexes that are not simply connected, the smallest first."""
    bands = {f"cylinder of {n}": band(n) for n in (3, 4, 5, 6)}
    twisted = {f"Moebius band of {n}": band(n, twisted=True) for n in (3, 4, 5)}
    tori = {f"torus of {a} by {b}": torus(a, b) for a, b in ((3, 3), (3, 4), (4, 4), (4, 6))}
    return bands | twisted | tori


def operated(rng: np.random.Generator, steps: int) -> AsymptoticComplex:
    """Random star after surgeries at random vertices, some of which a quadrant forbids."""
    complex_ = star([int(n) for n in rng.integers(1, 4, size=2 * int(rng.integers(2, 5)))])
    for _ in range(3 * steps):
        vertex = int(rng.choice(np.flatnonzero(~complex_.is_boundary)))
        face = int(rng.choice(np.flatnonzero((complex_.faces == vertex).any(axis=1))))
        new = [int(n) for n in rng.integers(1, 4, size=2 * int(rng.integers(1, 3)))]
        try:
            complex_ = surgery(complex_, vertex, face, new)[0]
        except SurgeryError:
            continue
        steps -= 1
        if not steps:
            break
    return complex_


def samples(setting: Setting, *, simply_connected: bool, random: int = 12) -> Samples:
    """Disks, random ones among them; first the bands and tori unless simply connected is asked."""
    rng = generator(setting)
    operations = {f"random disk {n}": operated(rng, 3) for n in range(random)}
    return ({} if simply_connected else others()) | disks() | operations


def turned(complex_: AsymptoticComplex, rng: np.random.Generator) -> AsymptoticComplex:
    """The same complex with the coordinates of each face turned or reflected at random."""
    chosen = np.array(KEEPING_FAMILIES)[rng.integers(4, size=len(complex_.faces))]
    return AsymptoticComplex(faces=np.take_along_axis(complex_.faces, chosen, axis=1))


def strips(complex_: AsymptoticComplex) -> IntArray:
    """Strip to which each edge belongs: opposite sides of a face are in one."""
    edge_of = complex_.sides.edge_of
    opposite = np.concatenate([edge_of[:, [0, 2]], edge_of[:, [1, 3]]])
    return components(len(complex_.edges), opposite)[1]


def coordinates(complex_: AsymptoticComplex, rng: np.random.Generator) -> FaceCoordinates:
    """Random rational sizes of the faces that agree along common edges."""
    strip = strips(complex_)
    length = [Fraction(int(n), 7) for n in rng.integers(1, 30, size=int(strip.max()) + 1)]
    edge_of = complex_.sides.edge_of
    sizes: list[Point] = [(length[strip[u]], length[strip[v]]) for u, v in edge_of[:, :2].tolist()]
    return FaceCoordinates(complex=complex_, sizes=sizes)
