"""Nonsense given to the nets: a named error that tells where, never a NaN, never numpy's own."""

from fractions import Fraction
from math import cosh, inf, nan, pi, sinh

import numpy as np
import pytest
from flint import arb
from mpmath import mpf

from discrete import branched_net, complex_errors, errors
from discrete.asymptotic_complex import AsymptoticComplex
from discrete.charges import charges
from discrete.complex_errors import AngleSumError, ComplexError, NormalError, PolygonError
from discrete.complex_surgery import attached, boundary_segment, restricted, surgery
from discrete.dual_cycles import crossings
from discrete.errors import (
    AngleError,
    AntipodalError,
    CoincidentVerticesError,
    DiscreteError,
    NotFiniteError,
    OffSpaceError,
    ShapeError,
)
from discrete.face_coordinates import FaceCoordinates
from discrete.face_regions import grown_disk
from discrete.gluing import Seam, fan, glued, rectangle, side, star
from discrete.hamburger import HamburgerPolygon, polygon_around
from discrete.index import normal_winding, ramified_vertex
from discrete.k_surface import k_surface
from discrete.lelieuvre import closure, positions
from discrete.quad_rule import closed_quad
from discrete.sector import amsler_sector
from discrete.space_forms import H2
from discrete.space_frame import SpaceFrame
from discrete.spherical_net import SphericalNet
from discrete.vertex_fan import vertex_fan

BLOCK, MONKEY = rectangle(3, 2), star([2] * 6)
ALL = np.ones(len(MONKEY.faces), dtype=bool)
WHOLE = polygon_around(MONKEY, ALL)
ZEROS = np.zeros((len(MONKEY.faces), 4))
#: Unit vectors of which no two are the same or antipodal.
NORMALS = np.stack([np.cos(np.arange(37) / 9), np.sin(np.arange(37) / 9), np.arange(37) / 37], 1)
NORMALS = NORMALS / np.linalg.norm(NORMALS, axis=1, keepdims=True)
RAY = branched_net.geodesic_ray([0.1, 0.1])
NET = branched_net.regular_star(3, edge_length=0.1, edges=3)


def seam(**given):
    return glued([BLOCK, BLOCK], [Seam(**{"first": 0, "path": (0, 1), "second": 1, **given})])


def frame(**given):
    axes = {"point": np.zeros(3), "normal": np.eye(3)[2], "along_u": np.eye(3)[0], "side": 1}
    return SpaceFrame(**{**axes, **given})


#: The vertex at the centre of the disk model of H^2.
ORIGIN = (1.0, 0.0, 0.0)


def far(distance):
    return cosh(distance), sinh(distance), 0.0


def spherical(normals):
    return SphericalNet(complex=MONKEY, normals=tuple(normals))


def opposite():
    """Normals that the first edge joins to their antipodes."""
    normals = [tuple(map(float, normal)) for normal in NORMALS]
    start, end = MONKEY.edges[0]
    normals[end] = tuple(-x for x in normals[start])
    return normals


REFUSED = {
    "ragged faces": (lambda: AsymptoticComplex(faces=[[0, 1, 2, 3], [1, 2]]), ComplexError),
    "a vertex far off": (lambda: AsymptoticComplex(faces=[[0, 1, 2, 10**12]]), ComplexError),
    "grid of text": (lambda: rectangle("a", 2), ComplexError),
    "grid of a fraction": (lambda: rectangle(1.5, 2), ComplexError),
    "no side of a grid": (lambda: side(2, 2, "w = 3"), ComplexError),
    "star of NaN": (lambda: star([nan, 1, 1, 1]), ComplexError),
    "fan of one ray": (lambda: fan([3]), ComplexError),
    "no pieces": (lambda: glued([], []), ComplexError),
    "seam of text": (lambda: seam(onto="ab"), ComplexError),
    "seam between vertices": (lambda: seam(onto=(0.0, 1.5)), ComplexError),
    "seam of NaN": (lambda: seam(onto=(nan, 1)), ComplexError),
    "seam of no piece": (lambda: seam(onto=(0, 1), second="a"), ComplexError),
    "path of text": (lambda: HamburgerPolygon(complex=MONKEY, path=list("abcd")), PolygonError),
    "ragged path": (lambda: HamburgerPolygon(complex=MONKEY, path=[[0], [1, 2], 3, 4]),
                    PolygonError),
    "choice too short": (lambda: polygon_around(MONKEY, ALL[:3]), ComplexError),
    "choice of NaN": (lambda: polygon_around(MONKEY, ALL * nan), ComplexError),
    "part too short": (lambda: restricted(MONKEY, ALL[:3]), ComplexError),
    "surgery at no vertex": (lambda: surgery(MONKEY, 999, 0, [1, 1]), ComplexError),
    "surgery before the first": (lambda: surgery(MONKEY, -1, 0, [1, 1]), ComplexError),
    "surgery in no face": (lambda: surgery(MONKEY, 0, 999, [1, 1]), ComplexError),
    "surgery at text": (lambda: surgery(MONKEY, "a", 0, [1, 1]), ComplexError),
    "rays of text": (lambda: surgery(MONKEY, 0, 0, "ab"), ComplexError),
    "sectors at no vertex": (lambda: attached(BLOCK, 999, [1, 1]), ComplexError),
    "segment from no vertex": (lambda: boundary_segment(BLOCK, -1, along_u=True), ComplexError),
    "fan of no vertex": (lambda: vertex_fan(MONKEY, 37), ComplexError),
    "disk from no face": (lambda: grown_disk(MONKEY, 999, 3, np.random.default_rng(0)),
                          ComplexError),
    "cycle of strangers": (lambda: crossings(MONKEY, (0, 5, 9)), ComplexError),
    "sides without end": (lambda: FaceCoordinates(complex=BLOCK, sizes=[(inf, inf)] * 6),
                          ComplexError),
    "three sides": (lambda: FaceCoordinates(complex=BLOCK, sizes=[(1, 1, 1)] * 6), ComplexError),
    "no corner": (lambda: FaceCoordinates(complex=BLOCK, sizes=[(Fraction(1),) * 2] * 6).corner(
        0, 9), ComplexError),
    "pi is NaN": (lambda: charges(WHOLE, ZEROS, straight_angle=nan), AngleSumError),
    "pi is a ball of NaN": (lambda: charges(WHOLE, ZEROS.astype(object),
                                            straight_angle=arb("nan")), AngleSumError),
    "tolerance is NaN": (lambda: charges(WHOLE, ZEROS, straight_angle=pi, tolerance=nan),
                         AngleSumError),
    "tolerance without end": (lambda: charges(WHOLE, ZEROS, straight_angle=pi, tolerance=inf),
                              AngleSumError),
    "angles of text": (lambda: charges(WHOLE, np.full((24, 4), "a"), straight_angle=pi),
                       AngleSumError),
    "no angles": (lambda: charges(WHOLE, np.full((24, 4), None), straight_angle=pi),
                  AngleSumError),
    "ramified by NaN": (lambda: ramified_vertex(MONKEY, ZEROS, straight_angle=nan), AngleSumError),
    "long normals": (lambda: normal_winding(MONKEY, 7 * NORMALS), NormalError),
    "normals of text": (lambda: normal_winding(MONKEY, NORMALS.astype(str)), NormalError),
    "no sign": (lambda: normal_winding(MONKEY, NORMALS, orientation=0 * MONKEY.orientation),
                NormalError),
    "too few signs": (lambda: normal_winding(MONKEY, NORMALS, orientation=np.ones(2)),
                      NormalError),
    "equal normals and no tolerance": (
        lambda: normal_winding(MONKEY, np.tile(np.eye(3)[2], (37, 1)), tolerance=nan), NormalError
    ),
    "ray of text": (lambda: branched_net.geodesic_ray(["a"]), ShapeError),
    "ray in a table": (lambda: branched_net.geodesic_ray([[0.1, 0.2], [0.3, 0.4]]), ShapeError),
    "turn of NaN": (lambda: branched_net.Ray(lengths=[0.1, 0.1], left_turns=[nan]),
                    NotFiniteError),
    "angles in words": (lambda: branched_net.star([RAY] * 6, ["a"] * 6), AngleError),
    "star of order 1": (lambda: branched_net.regular_star(1, edge_length=0.1, edges=2),
                        ShapeError),
    "star of order 0": (lambda: branched_net.regular_star(0, edge_length=0.1, edges=2),
                        ShapeError),
    "apex between vertices": (lambda: branched_net.surgery(NET, 0, (1.5, 1)), ComplexError),
    "sector of text": (lambda: branched_net.surgery(NET, "a", (1, 1)), ComplexError),
    "corner of text": (lambda: amsler_sector([0.1], [0.1], "a"), AngleError),
    "point of NaN": (lambda: frame(point=np.full(3, nan)), NotFiniteError),
    "no normal": (lambda: frame(normal=np.zeros(3)), ShapeError),
    "long normal": (lambda: frame(normal=2 * np.eye(3)[2]), ShapeError),
    "direction off the plane": (lambda: frame(along_u=np.eye(3)[2]), ShapeError),
    "no side": (lambda: frame(side=0), ShapeError),
    "frame of two numbers": (lambda: frame(normal=np.zeros(2)), ShapeError),
    "normal of NaN": (lambda: positions(np.full((3, 2, 2), nan), np.zeros(3)), NotFiniteError),
    "closure of NaN": (lambda: closure(np.full((3, 2, 2), nan)), NotFiniteError),
    "no quad": (lambda: closure(np.zeros((3, 1, 1))), ShapeError),
    "quad that overflows": (lambda: closed_quad(H2, ORIGIN, (1e200, 1e200, 0.0), ORIGIN),
                            OffSpaceError),
    "quad without digits": (lambda: closed_quad(H2, ORIGIN, far(400.0), far(-400.0)),
                            OffSpaceError),
    "apex of one index": (lambda: branched_net.surgery(NET, 0, (2,)), ComplexError),
    "apex of three indices": (lambda: branched_net.surgery(NET, 0, (2, 2, 2)), ComplexError),
    "apex of a number": (lambda: branched_net.surgery(NET, 0, 2), ComplexError),
    "angles of mpmath's NaN": (lambda: charges(WHOLE, np.full((24, 4), mpf("nan"), dtype=object),
                                               straight_angle=mpf(pi)), AngleSumError),
    "angles of a complex NaN": (lambda: charges(WHOLE, np.full((24, 4), complex(nan, 0)),
                                                straight_angle=pi), AngleSumError),
    "spherical normals of NaN": (lambda: spherical([(nan, 0.0, 0.0)] * 37), NotFiniteError),
    "long spherical normals": (lambda: spherical([(2.0, 0.0, 0.0)] * 37), OffSpaceError),
    "one spherical normal": (lambda: spherical([(1.0, 0.0, 0.0)] * 37), CoincidentVerticesError),
    "antipodal spherical normals": (lambda: spherical(opposite()), AntipodalError),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_nonsense_is_refused_by_name(name: str):
    call, error = REFUSED[name]
    with pytest.raises(error) as caught:
        call()
    assert isinstance(caught.value, DiscreteError)
    assert str(caught.value)


def test_a_surface_has_no_nan():
    lost = branched_net.regular_star(3, edge_length=0.1, edges=2)

    def route(sector, frame):
        points = np.zeros((3, 3, 3))
        points[0, 2, 2] = nan
        return points, points

    with pytest.raises(NotFiniteError, match="vertex"):
        k_surface(lost, route=route)


def test_all_errors_have_one_base_and_one_meaning():
    found = {
        name: kind
        for module in (errors, complex_errors)
        for name, kind in vars(module).items()
        if isinstance(kind, type) and issubclass(kind, Exception)
    }
    # Too few bits are no bad input: a caller that handles bad input must not swallow them.
    assert {kind for kind in found.values() if not issubclass(kind, DiscreteError)} == {
        errors.InsufficientPrecisionError
    }
    assert issubclass(errors.InsufficientPrecisionError, ArithmeticError)
    told = [kind.__doc__ for kind in found.values()]
    assert len(set(told)) == len(told)
    assert issubclass(AngleSumError, AngleError)


@pytest.mark.parametrize(
    ("share", "fine"), [("1/5", False), ("1/3", False), ("2/5", True), ("1", False)]
)
def test_the_angles_at_a_boundary_vertex_of_degree_four_are_bounded(share: str, fine: bool):
    sectors, seams, _ = fan([1, 1, 1, 1])
    complex_, vertex = glued(sectors, seams).complex, 0
    assert complex_.is_boundary[vertex]
    assert complex_.degree[vertex] == 4
    # Of the three angles at the vertex, in units of pi: between -3 and -1 in all.
    angles = np.full(complex_.faces.shape, -Fraction(1, 2))
    angles[complex_.faces == vertex] = -Fraction(share)
    assert (ramified_vertex(complex_, angles, straight_angle=Fraction(1)) != vertex) == fine
