"""Index, Hamburger polygons and the balance of charges, on random complexes and polygons."""

from collections import Counter
from fractions import Fraction
from math import pi

import numpy as np
import pytest
import sympy as sp
from complexes import CORPUS, ball_angles, exact_angles, float_angles, random_complex
from flint import arb, ctx

from discrete.charges import charges
from discrete.complex_errors import AngleSumError, NormalError, PolygonError
from discrete.face_regions import grown_disk
from discrete.gluing import Seam, fan, glued, grid, rectangle, star
from discrete.hamburger import HamburgerPolygon, polygon_around
from discrete.index import (
    angle_sums,
    interior_vertices,
    normal_winding,
    ramification_index,
    ramified_vertex,
)

COMPLEXES = 220
ROUNDING = 1e-15
"""Half a unit in the last place of each term, with room for the pairwise sums."""


def polygons():
    """Random complexes, and Hamburger polygons in them that enclose none to all branch points."""
    for seed in range(COMPLEXES):
        rng = np.random.default_rng(seed)
        complex_ = random_complex(rng, int(rng.integers(2, 6)))
        found, tries = [], 0
        while len(found) < 2 and tries < 40:
            tries += 1
            size = int(rng.integers(1, len(complex_.faces) + 1)) if len(found) else 10**6
            start = int(rng.integers(len(complex_.faces)))
            try:
                found.append(polygon_around(complex_, grown_disk(complex_, start, size, rng)))
            except PolygonError:
                continue
        yield complex_, found, rng


SAMPLES = list(polygons())


def test_the_samples_are_varied():
    orders = [c.saddle_order[c.branch_points].tolist() for c, _, _ in SAMPLES]
    assert len(SAMPLES) >= 200
    assert all(3 <= m <= 6 for found in orders for m in found)
    assert sum(len(found) >= 3 and len(set(found)) >= 2 for found in orders) >= COMPLEXES / 2
    share = Counter()
    for complex_, found, _ in SAMPLES:
        for polygon in found:
            inside, most = len(polygon.enclosed_branch_points), len(complex_.branch_points)
            share["none" if not inside else "all" if inside == most else "some"] += 1
    assert sum(share.values()) >= 1.9 * COMPLEXES
    assert min(share[s] for s in ("none", "some", "all")) >= 0.1 * sum(share.values())


def test_the_balance_is_exact():
    for complex_, found, rng in SAMPLES:
        angles = exact_angles(complex_, rng)
        for polygon in found:
            assert charges(polygon, angles, straight_angle=Fraction(1)).residual == 0


def test_the_balance_holds_to_rounding():
    for complex_, found, rng in SAMPLES:
        angles = float_angles(complex_, rng)
        for polygon in found:
            balance = charges(polygon, angles, straight_angle=pi, tolerance=1e-13)
            scale = 2 * pi * len(complex_.faces) * 4
            assert abs(balance.residual) <= ROUNDING * scale


def test_the_balance_is_certified_in_balls():
    with ctx.workprec(128):
        for complex_, found, rng in SAMPLES:
            angles = ball_angles(exact_angles(complex_, rng))
            for polygon in found:
                residual = charges(polygon, angles, straight_angle=arb.pi()).residual
                assert residual.is_finite()
                assert residual.rad() < arb("1e-30")
                assert residual.overlaps(arb(0))


def test_the_balance_holds_for_symbols():
    """Every angle a free symbol but one at each interior vertex, which closes it."""
    complex_ = CORPUS["operated grid"]
    angles = np.array(sp.symbols(f"a:{complex_.faces.size}"), dtype=object)
    angles = angles.reshape(complex_.faces.shape)
    for vertex in interior_vertices(complex_):
        face, corner = (int(n[0]) for n in np.nonzero(complex_.faces == vertex))
        others = angles[complex_.faces == vertex].sum() - angles[face, corner]
        angles[face, corner] = 2 * sp.pi - others
    whole = polygon_around(complex_, np.ones(len(complex_.faces), dtype=bool))
    assert len(whole.enclosed_branch_points) == 1
    sums = angle_sums(complex_, angles)
    assert all(sp.expand(sums[v] - 2 * sp.pi) == 0 for v in whole.enclosed_vertices)
    for (face, corner), value in np.ndenumerate(angles):
        angles[face, corner] = sp.expand(value)
    assert sp.expand(charges(whole, angles, straight_angle=sp.pi).residual) == 0


def star_polygon(m: int, length: int = 2) -> tuple[HamburgerPolygon, np.ndarray]:
    complex_ = star([length] * (2 * m))
    whole = polygon_around(complex_, np.ones(len(complex_.faces), dtype=bool))
    return whole, exact_angles(complex_, np.random.default_rng(m))


@pytest.mark.parametrize("m", [2, 3, 4, 6])
def test_a_wrong_sign_or_order_breaks_the_balance(m):
    """Sign of the branching and the order m - 1 for m - 2: each leaves a multiple of pi."""
    whole, angles = star_polygon(m)
    found = charges(whole, angles, straight_angle=Fraction(1))
    assert found.residual == 0
    assert found.branching == -(m - 2)
    inside = len(whole.enclosed_vertices)
    flipped = found.boundary - found.area + found.branching
    assert flipped == -2 * (m - 2)
    assert found.boundary - found.area - (found.branching - inside) == inside


def test_the_corners_alone_do_not_balance():
    whole, angles = star_polygon(3)
    sums = angle_sums(whole.complex, angles)
    corners = sum(Fraction(int(whole.quads[b]), 2) - sums[b] for b in whole.corners)
    found = charges(whole, angles, straight_angle=Fraction(1))
    assert corners != found.boundary
    assert len(whole.corners) == 6


def test_corners_alternate():
    for _, found, _ in SAMPLES[::10]:
        for polygon in found:
            assert len(polygon.corners) % 2 == 0
            assert (polygon.quads[polygon.corners] % 2 == 1).all()
            straight = polygon.path[~polygon.is_corner]
            assert (polygon.quads[straight] == 2).all()


def test_signs_of_corners_begin_with_the_u_arcs_counterclockwise():
    """The signs of the Hazzidakis formula: + at (0, 0) and (u, v), - at (u, 0) and (0, v)."""
    v = grid(3, 2)
    path = np.concatenate([v[:, 0], v[-1, 1:], v[-2::-1, -1], v[0, -2:0:-1]])
    forwards = HamburgerPolygon(complex=rectangle(3, 2), path=path)
    assert forwards.is_counterclockwise
    assert forwards.corners.tolist() == [v[0, 0], v[-1, 0], v[-1, -1], v[0, -1]]
    assert forwards.corner_signs.tolist() == [1, -1, 1, -1]
    backwards = HamburgerPolygon(complex=rectangle(3, 2), path=path[::-1])
    assert not backwards.is_counterclockwise
    by_corner = dict(zip(forwards.corners, forwards.corner_signs, strict=True))
    assert dict(zip(backwards.corners, backwards.corner_signs, strict=True)) == by_corner


def test_signs_of_corners_do_not_depend_on_the_way_round():
    for _, found, _ in SAMPLES[::10]:
        for polygon in found:
            other = HamburgerPolygon(complex=polygon.complex, path=polygon.path[::-1])
            assert polygon.is_counterclockwise != other.is_counterclockwise
            assert polygon.corner_signs.sum() == 0
            one, two = (dict(zip(p.corners, p.corner_signs, strict=True)) for p in (polygon, other))
            assert one == two


def test_the_faces_of_a_polygon_are_those_that_it_was_drawn_around():
    rng = np.random.default_rng(5)
    complex_ = rectangle(7, 7)
    for size in (1, 5, 20, 40):
        inside = grown_disk(complex_, 24, size, rng)
        assert (polygon_around(complex_, inside).inside == inside).all()


def test_what_is_no_hamburger_polygon_is_refused():
    square = rectangle(3, 3)
    v = grid(3, 3)
    with pytest.raises(PolygonError, match="no edge joins"):
        HamburgerPolygon(complex=square, path=np.array([v[0, 0], v[1, 0], v[2, 2], v[0, 1]]))
    path = [v[0, 0], v[1, 0], v[1, 1], v[1, 2], v[2, 2], v[2, 1], v[1, 1], v[0, 1]]
    with pytest.raises(PolygonError, match=f"meets vertex {v[1, 1]} twice"):
        HamburgerPolygon(complex=square, path=np.array(path))
    with pytest.raises(PolygonError, match="four vertices"):
        HamburgerPolygon(complex=square, path=np.array([0, 1]))
    with pytest.raises(PolygonError, match="not in the complex"):
        HamburgerPolygon(complex=square, path=np.array([0, 1, 99, 4]))
    with pytest.raises(PolygonError, match="no faces"):
        polygon_around(square, np.zeros(9, dtype=bool))


def test_a_region_with_a_hole_or_a_pinch_is_refused():
    square = rectangle(3, 3)
    hole = np.ones(9, dtype=bool)
    hole[4] = False
    with pytest.raises(PolygonError, match="not one path"):
        polygon_around(square, hole)
    pinch = np.zeros(9, dtype=bool)
    pinch[[0, 4]] = True
    with pytest.raises(PolygonError, match="meets itself"):
        polygon_around(square, pinch)


def test_arcs_of_one_family_that_meet_at_a_branch_point_are_refused():
    """Four of the six sectors of a monkey star: at its centre a u-arc would turn to a u-arc."""
    complex_ = star([1] * 6)
    with pytest.raises(PolygonError, match=r"vertex 0 a .-arc meets a .-arc at an angle, with 4"):
        polygon_around(complex_, np.array([True] * 4 + [False] * 2))
    assert polygon_around(complex_, np.array([True] * 5 + [False])).quads[0] == 5


def test_a_polygon_needs_a_disk():
    ends = {"first": 0, "second": 1}
    ring = glued(
        [rectangle(2, 1)] * 2,
        [Seam(path=[4, 5], onto=[0, 1], **ends), Seam(path=[0, 1], onto=[4, 5], **ends)],
    ).complex
    with pytest.raises(PolygonError, match="no disk"):
        HamburgerPolygon(complex=ring, path=np.array([0, 1, 3, 2]))


def test_angles_that_do_not_add_up_are_refused():
    whole, angles = star_polygon(3)
    angles[0, 0] += Fraction(1, 10**9)
    with pytest.raises(AngleSumError, match="at vertex 0"):
        charges(whole, angles, straight_angle=Fraction(1))
    angles[0, 0] -= Fraction(2, 10**9)
    with pytest.raises(AngleSumError, match="at vertex 0"):
        charges(whole, angles, straight_angle=Fraction(1))
    floats = float_angles(whole.complex, np.random.default_rng(0))
    floats[3, 2] = np.nan
    vertex = whole.complex.faces[3, 2]
    with pytest.raises(AngleSumError, match=f"face 3 at vertex {vertex} is not finite"):
        charges(whole, floats, straight_angle=pi, tolerance=1e-12)
    with pytest.raises(AngleSumError, match="shape"):
        angle_sums(whole.complex, floats[:2])


def graph_normals(m: int, length: int) -> tuple[object, np.ndarray]:
    """Star of 2m equal sectors over the graph of Re z^m, and the normals at its vertices."""
    sectors, seams, rays = fan([length] * (2 * m + 1))
    closing = Seam(first=2 * m - 1, path=rays[-1], second=0, onto=rays[0])
    found = glued(sectors, [*seams, closing])
    z = np.zeros(found.complex.vertex_count, dtype=complex)
    for i, places in enumerate(found.places):
        u, v = np.indices((length + 1, length + 1)).reshape(2, -1) / length
        first, second = (u, v) if i % 2 == 0 else (v, u)
        rays_at = np.exp(1j * np.pi * np.array([i, i + 1]) / m)
        z[places] = first * rays_at[0] + second * rays_at[1]
    slope = m * np.conj(z) ** (m - 1)
    normals = np.stack([-slope.real, -slope.imag, np.ones(len(z))], axis=1)
    return found.complex, normals / np.linalg.norm(normals, axis=1, keepdims=True)


@pytest.mark.parametrize("m", [2, 3, 4])
def test_the_normal_of_a_saddle_winds_by_one_minus_m(m):
    complex_, normals = graph_normals(m, 4)
    found = normal_winding(complex_, normals)
    # Sector 0 has its u-ray first and is counterclockwise, as the orientation of face 0 is.
    assert found[0] == 1 - m == ramification_index(complex_)[0]
    assert (found == ramification_index(complex_)).all()
    assert (normal_winding(complex_, normals, orientation=-complex_.orientation) == -found).all()
    assert found[0] != m - 1


def test_normals_that_do_not_wind_are_refused():
    complex_, normals = graph_normals(2, 1)
    normals[complex_.faces[0, 1]] = -normals[0]
    with pytest.raises(NormalError, match="same or antipodal"):
        normal_winding(complex_, normals)
    normals[3] = np.nan
    with pytest.raises(NormalError, match="finite"):
        normal_winding(complex_, normals)


@pytest.mark.parametrize("m", [2, 3, 5])
def test_the_condition_on_angles_tells_a_star_from_a_ramified_one(m):
    complex_ = star([1] * (2 * m))
    inside = 2 * Fraction(m - 1, 2 * m)
    angles = np.full(complex_.faces.shape, Fraction(-1, 3), dtype=object)
    angles[complex_.faces == 0] = -inside
    assert ramified_vertex(complex_, angles, straight_angle=Fraction(1)) is None
    angles[0][complex_.faces[0] == 0] += Fraction(1, 100)
    assert ramified_vertex(complex_, angles, straight_angle=Fraction(1)) == 0
