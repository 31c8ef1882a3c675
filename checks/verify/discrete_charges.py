"""Check of the balance of charges on nets: random complexes, polygons and angles, exactly.

Written out here from counts alone, against the library's balance of the same polygon.
"""

from fractions import Fraction

import numpy as np

from checks.evidence import Evidence, Setting
from checks.verify.asymptotic_complexes_samples import generator, operated
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.charges import charges
from discrete.complex_errors import PolygonError
from discrete.face_regions import grown_disk
from discrete.hamburger import HamburgerPolygon, polygon_around
from discrete.index import Angles

_COMPLEXES = 40


def random_angles(complex_: AsymptoticComplex, rng: np.random.Generator) -> Angles:
    """Random fractions of pi at the corners of the faces, of sum 2 at each interior vertex."""
    raw = rng.integers(1, 30, size=complex_.faces.shape)
    sums = np.bincount(complex_.faces.ravel(), raw.ravel(), complex_.vertex_count)
    angles = np.empty(complex_.faces.shape, dtype=object)
    for (face, corner), part in np.ndenumerate(raw):
        vertex = complex_.faces[face, corner]
        # Fractions of numpy integers would overflow silently.
        whole = 40 if complex_.is_boundary[vertex] else int(sums[vertex])
        angles[face, corner] = Fraction(2 * int(part), whole)
    return angles


def _written_out(
    polygon: HamburgerPolygon, angles: Angles, *, regular: int, corners: bool, sign: int
) -> tuple[Fraction, Fraction]:
    """Both sides of the balance in units of pi, face by face."""
    faces = [face for face in range(len(polygon.inside)) if polygon.inside[face]]
    quads: dict[int, int] = {}
    theta: dict[int, Fraction] = {}
    area = Fraction(0)
    for face in faces:
        area += 2 - sum(angles[face].tolist(), Fraction(0))
        for vertex, angle in zip(polygon.complex.faces[face].tolist(), angles[face], strict=True):
            quads[vertex] = quads.get(vertex, 0) + 1
            theta[vertex] = theta.get(vertex, Fraction(0)) + angle
    rim = set((polygon.corners if corners else polygon.path).tolist())
    left = sum((Fraction(quads[b], 2) - theta[b] for b in rim), Fraction(0))
    orders = [quads[v] // 2 for v in quads.keys() - set(polygon.path.tolist())]
    return left, area + sign * sum(m - regular for m in orders)


def balance(
    setting: Setting, *, regular: int = 2, corners: bool = False, sign: int = -1
) -> Evidence:
    """Sum of pi q_b / 2 - Theta_b over the boundary, against area minus pi times sum of m - 2.

    regular: order without charge; corners: whether only the corners are summed over; sign: of the
    charges. Every polygon is a random disk of faces of a complex after random surgeries.
    """
    rng = generator(setting)
    tried = met = enclosing = 0
    for _ in range(_COMPLEXES):
        complex_ = operated(rng, int(rng.integers(1, 5)))
        angles = random_angles(complex_, rng)
        for size in (len(complex_.faces), int(rng.integers(1, len(complex_.faces) + 1))):
            tried += 1
            start = int(rng.integers(len(complex_.faces)))
            try:
                polygon = polygon_around(complex_, grown_disk(complex_, start, size, rng))
            except PolygonError:
                continue
            met += 1
            enclosing += len(polygon.enclosed_branch_points) > 1
            left, right = _written_out(polygon, angles, regular=regular, corners=corners, sign=sign)
            residual = charges(polygon, angles, straight_angle=Fraction(1)).residual
            if left != right or residual != 0:
                return Evidence(
                    outcome="fail",
                    grade="exact",
                    tried=tried,
                    met=met,
                    witness=f"polygon of {len(polygon.path)} vertices around "
                    f"{int(polygon.inside.sum())} quads and "
                    f"{len(polygon.enclosed_branch_points)} branch points: {left} pi on the left, "
                    f"{right} pi on the right",
                )
    return Evidence(
        outcome="pass" if met and enclosing else "undecided",
        grade="exact",
        residual="0",
        tried=tried,
        met=met,
        shown="the sum over all boundary vertices of pi q/2 - Theta is the area less pi times the "
        f"sum of m - 2, in fractions of pi; {enclosing} polygons enclose two branch points or more",
    )
