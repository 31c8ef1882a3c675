"""Surgery: complexes of quads, gluing, Goursat problems on grids, local series, the trisection."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp

from checks.evidence import Setting
from checks.printed import surgery as printed
from checks.printed.surgery import Sizes
from checks.verify import surgery_fronts, surgery_gluing, surgery_lemma, surgery_sectors, trisection
from theory import goursat_float, quad_complex, tractrix_surgery
from theory.errors import DomainError
from theory.glued_rectangles import Rectangle, attachment_defects, quotient
from theory.quad_surgery import replaced, sector_grid, square_grid
from theory.surgery_sectors import Line, normals, places, sector_normal

SETTING = Setting()
RING = [(2 * k, 2 * k + 1, (2 * k + 3) % 8, (2 * k + 2) % 8) for k in range(4)]
CUBE = [
    (0, 1, 2, 3),
    (4, 5, 6, 7),
    (0, 1, 5, 4),
    (1, 2, 6, 5),
    (2, 3, 7, 6),
    (3, 0, 4, 7),
]  # fmt: skip


def fan(sectors):
    """Quads around one vertex."""
    return [(0, f"a{k}", f"b{k}", f"a{(k + 1) % sectors}") for k in range(sectors)]


@pytest.mark.parametrize("sectors", [4, 6, 8])
def test_a_fan_of_an_even_number_of_quads_is_an_asymptotic_complex(sectors):
    assert quad_complex.defects(fan(sectors)) == []
    assert quad_complex.interior_degrees(fan(sectors)) == {0: sectors}


@pytest.mark.parametrize("sectors", [3, 5])
def test_an_odd_fan_has_no_alternating_labels(sectors):
    assert "labelled" in quad_complex.defects(fan(sectors))[0]


def test_two_quads_that_share_two_edges_are_no_quad_graph():
    assert "2 edges" in quad_complex.defects([(0, 1, 2, 3), (0, 1, 2, 4)])[0]


@pytest.mark.parametrize(
    ("quads", "why"),
    [
        (CUBE, "Euler characteristic 2"),
        ([(0, 1, 2, 3), (0, 4, 5, 6)], "no fan"),
        ([(0, 1, 2, 3), (4, 5, 6, 7)], "Euler characteristic 2"),
        ([(0, 1, 2, 3), (0, 1, 4, 5), (0, 1, 6, 7)], "in 3 faces"),
        ([(0, 1, 1, 2)], "not distinct"),
        (RING, "characteristic 0"),
    ],
)  # fmt: skip
def test_what_is_no_disk_is_told_with_the_reason(quads, why):
    assert any(why in defect for defect in quad_complex.defects(quads))


@pytest.mark.parametrize("half", [1, 2, 3])
def test_an_odd_number_of_sectors_gives_a_branch_point_of_the_next_orders(half):
    grid = square_grid(3, 3)
    start = next(quad for quad in grid if quad[0] == (1, 1))
    after = replaced(grid, start, (1, 1), sectors=2 * half + 1)
    assert quad_complex.defects(after) == []
    assert quad_complex.interior_degrees(after)[1, 1] == 4 + 2 * half


def test_surgery_with_one_sector_gives_the_grid_again():
    grid = square_grid(4, 4)
    start = next(quad for quad in grid if quad[0] == (1, 2))
    after = replaced(grid, start, (1, 2), sectors=1)
    assert len(after) == len(grid)
    assert sorted(quad_complex.degrees(after).values()) == sorted(
        quad_complex.degrees(grid).values()
    )


def test_a_sector_with_a_branch_point_inside_is_refused():
    grid = square_grid(4, 4)
    start = next(quad for quad in grid if quad[0] == (2, 2))
    after = replaced(grid, start, (2, 2))
    outer = next(quad for quad in after if quad[0] == (1, 1))
    with pytest.raises(DomainError, match="no rectangle"):
        sector_grid(after, outer, (1, 1))
    with pytest.raises(DomainError, match="at least one"):
        replaced(grid, start, (2, 2), sectors=0)


def unit_square(name):
    return Rectangle(domain=name, low=(Fraction(0), Fraction(0)), high=(Fraction(1), Fraction(1)))


def test_two_squares_glued_along_an_edge_share_two_vertices():
    zero, one = Fraction(0), Fraction(1)
    right = (("A", (one, zero)), ("A", (one, one)))
    left = (("B", (zero, zero)), ("B", (zero, one)))
    bottom = (("B", (zero, zero)), ("B", (one, zero)))
    squares = [unit_square("A"), unit_square("B")]
    assert attachment_defects(squares, {"good": (right, left)}) == []
    assert "v-edge to a u-edge" in attachment_defects(squares, {"bad": (right, bottom)})[0]
    first, second = quotient(squares, [(right, left)])
    assert len(set(first) & set(second)) == 2


def test_the_printed_chi_4_uses_an_edge_twice_and_the_corrected_one_does_not():
    assert "chi_3 and chi_4" in surgery_gluing.attaching(SETTING).witness
    assert surgery_gluing.attaching(SETTING, fourth=2).outcome == "pass"


@pytest.mark.parametrize("change", [{"second": 1}, {"shifts": "u"}, {"reverse": True}])
def test_wrong_attaching_maps_are_refused(change):
    assert surgery_gluing.attaching(SETTING, fourth=2, **change).outcome == "fail"


def test_the_branch_point_is_in_the_domain_only_if_the_quadrant_is_half_open():
    one, two = Fraction(1), Fraction(2)
    sizes = Sizes(u=one, v=one, u_max=two, v_max=two, u_new=one, v_new=one)
    assert not printed.in_star_domain(sizes, (one, one))
    assert printed.in_star_domain(sizes, (one, one), closed=False)


def orders(errors):
    return [float(np.log2(a / b)) for a, b in pairwise(errors)]


def test_the_moutard_solver_finds_the_pseudosphere_to_second_order():
    errors = []
    for steps in (16, 32, 64, 128):
        s = np.linspace(0.0, 0.8, steps + 1)
        u, v = s[:, None] - 0.9, s[None, :] - 0.6
        exact = tractrix_surgery.unit_normal(u, v)
        found = goursat_float.moutard(exact[:, 0], exact[0], step_u=s[1], step_v=s[1])
        errors.append(np.max(np.abs(found - exact)))
    assert all(1.9 < order < 2.1 for order in orders(errors))


def test_the_front_of_the_pseudosphere_is_found_to_second_order():
    errors = []
    for steps in (16, 32, 64, 128):
        s = np.linspace(0.0, 0.8, steps + 1)
        u, v = s[:, None] + 0.3, s[None, :] + 0.2
        exact = tractrix_surgery.place(u, v)
        found = goursat_float.front(tractrix_surgery.unit_normal(u, v), exact[0, 0])
        errors.append(np.max(np.abs(found - exact)))
    assert all(1.9 < order < 2.1 for order in orders(errors))


def test_the_sine_gordon_solver_finds_the_kink_to_second_order():
    errors = []
    for steps in (16, 32, 64, 128):
        s = np.linspace(0.0, 0.5, steps + 1)
        exact = 4 * np.arctan(np.exp(s[:, None] + s[None, :] - 1.5))
        found = goursat_float.sine_gordon(exact[:, 0], exact[0], step_u=s[1], step_v=s[1])
        errors.append(np.max(np.abs(found - exact)))
    assert all(1.9 < order < 2.1 for order in orders(errors))


def test_goursat_data_that_disagree_in_the_corner_are_refused():
    with pytest.raises(DomainError, match="corner"):
        goursat_float.sine_gordon(np.zeros(3), np.ones(3), step_u=0.1, step_v=0.1)


def test_a_bent_line_turns_its_normal_by_its_torsion():
    s = np.linspace(0.0, 1.0, 4001)
    start = (np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0]))
    found, turning = tractrix_surgery.bent_normals(start, (2.0, -1.0), s)
    speeds = np.linalg.norm(np.diff(found, axis=0), axis=1) / s[1]
    assert np.allclose(speeds, 1, atol=1e-6)
    assert turning[-1] == pytest.approx(0.5, abs=1e-12)


def test_a_straight_line_has_a_great_circle_of_normals():
    line = Line(direction=(sp.Integer(0), sp.Integer(1), sp.Integer(0)))
    x = sp.Symbol("x")
    sine = [sp.series(sp.sin(x), x, 0, 5).removeO().coeff(x, n) for n in range(5)]
    # N_v = -N x r_v: at first along +e_1 for r_v = e_2.
    assert [a[0] for a in normals(line, torsion=1, order=4)] == sine
    assert places(line, torsion=1, order=2)[1] == line.direction
    assert places(line, torsion=1, order=2)[2] == (0, 0, 0)


def test_perpendicular_straight_lines_give_the_amsler_series():
    on_u = Line(direction=(sp.Integer(1), sp.Integer(0), sp.Integer(0)))
    on_v = Line(direction=(sp.Integer(0), sp.Integer(1), sp.Integer(0)))
    normal = sector_normal(on_u, on_v, order=1)
    # N_uv = sigma cos phi N vanishes at a right angle.
    assert normal[1, 1] == (0, 0, 0)


def test_the_trisection_of_two_thirds_of_a_turn_is_one_to_two_to_one():
    t_v = (sp.cos(2 * sp.pi / 3), sp.sin(2 * sp.pi / 3), 0)
    e_u, e_v = printed.trisecting((1, 0, 0), t_v)
    assert sp.simplify(sp.atan2(e_v[1], e_v[0]) - sp.pi / 6) == 0
    assert sp.simplify(sp.atan2(e_u[1], e_u[0]) - sp.pi / 2) == 0


@pytest.mark.parametrize("change", [{"weight": "1"}, {"parallel": True}, {"by": 2}])
def test_wrong_trisections_are_refused(change):
    assert trisection.vectors(SETTING, **change).outcome == "fail"


def test_the_approximation_fails_near_a_straight_angle():
    assert "outer parts are 0" in trisection.approximate(SETTING, largest="1").witness


@pytest.mark.parametrize("change", [{"sign_u": -1}, {"tilt": 1}, {"length": 2}])
def test_wrong_amsler_data_are_refused(change):
    assert surgery_sectors.middle_sector(SETTING, **change).outcome == "fail"


def test_the_printed_composition_is_refused_and_its_converse_holds():
    assert "cannot follow" in surgery_fronts.fronts_agree(SETTING).witness
    assert surgery_fronts.fronts_agree(SETTING, outer=0).outcome == "pass"


def test_five_sectors_give_the_lemma_for_order_four():
    assert surgery_lemma.lemma(SETTING, sectors=5, order=4).outcome == "pass"


def test_a_surgery_towards_a_falling_angle_turns_a_sector_over():
    cut = tractrix_surgery.Cut(u=0.5, v=0.7, edge_u=0.6)
    t_u, t_v, _ = tractrix_surgery.tangents(cut)
    e_u, e_v = (np.array(a) / np.linalg.norm(a) for a in printed.trisecting(tuple(t_u), tuple(t_v)))
    one, two, _ = tractrix_surgery.sectors(cut, e_u, e_v, steps=64)
    assert goursat_float.orientation(one.places, one.normal) == 0
    assert goursat_float.orientation(two.places, two.normal) != 0
