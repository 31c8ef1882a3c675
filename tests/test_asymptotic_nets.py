"""The vector calculus behind section 3.1 on curves and surfaces whose invariants are textbook."""

import pytest
import sympy as sp

from checks.zero import vanishes
from theory.asymptotic_net import Cartesian, general_net
from theory.forms import (
    brioschi,
    coordinate_line_curvatures,
    first_form,
    second_form,
    third_form,
    third_from_others,
)
from theory.frames import curvature_squared, handedness, torsion, u_frame
from theory.gauss_weingarten import R_U, GaussWeingarten, codazzi_defects
from theory.moutard import curve_normals, goursat_series
from theory.one_form import primitive
from theory.surfaces import dini, kuen, pseudosphere
from theory.vectors import cross, derivative, dot

U, V = sp.symbols("u v", real=True)
PLAIN = Cartesian(symbols=(U, V), rates={"u": (1, 0), "v": (0, 1)})


def test_a_right_handed_helix_has_positive_torsion():
    helix = (sp.cos(U), sp.sin(U), U)
    derivatives = [derivative(helix, *([U] * n)) for n in (1, 2, 3)]
    assert sp.simplify(curvature_squared(PLAIN, *derivatives[:2])) == sp.Rational(1, 4)
    assert sp.simplify(torsion(PLAIN, *derivatives)) == sp.Rational(1, 2)


@pytest.mark.parametrize(
    ("metric", "curvature"),
    [
        ((1, 0, sp.cos(U) ** 2), 1),
        ((1, 0, sp.exp(2 * U)), -1),
        ((1, U, 1 + U**2), -1),  # coframe du + u dv, dv: the group of affine maps of the line
        ((1, 2 * V, 1 + 4 * V**2), 0),  # the plane in the coordinates x = u + v^2, y = v
        ((4 / (1 - U**2 - V**2) ** 2, 0, 4 / (1 - U**2 - V**2) ** 2), -1),
    ],
)
def test_brioschi_gives_the_curvature_of_known_metrics(metric, curvature):
    assert sp.simplify(brioschi(metric, PLAIN.rate)) == curvature


def test_a_circle_about_the_origin_bends_to_the_left():
    radius = sp.Symbol("u", positive=True)
    plane = Cartesian(symbols=(radius, V), rates={"u": (1, 0), "v": (0, 1)})
    straight, bent = coordinate_line_curvatures((1, 0, radius**2), radius, plane.rate)
    assert straight == 0
    assert sp.simplify(bent - 1 / radius) == 0


def helicoid(f):
    return GaussWeingarten(u=U, v=V, E=1, F=0, G=1 + U**2, e=0, f=f, g=0, area=sp.sqrt(1 + U**2))


def test_codazzi_holds_on_the_helicoid_and_not_near_it():
    root = sp.sqrt(1 + U**2)
    assert all(vanishes(defect) for defect in codazzi_defects(helicoid(1 / root)))
    assert not all(vanishes(defect) for defect in codazzi_defects(helicoid(1 / root**2)))


def test_the_moving_basis_agrees_with_the_helicoid_in_space():
    position = (U * sp.cos(V), U * sp.sin(V), V)
    r_u, r_v = derivative(position, U), derivative(position, V)
    normal = tuple(entry / sp.sqrt(1 + U**2) for entry in cross(r_u, r_v))
    forms = second_form(PLAIN, r_u, r_v, normal)
    assert [sp.simplify(entry) for entry in first_form(PLAIN, r_u, r_v)] == [1, 0, 1 + U**2]
    assert [forms[0], forms[2]] == [0, 0]
    fields = helicoid(forms[1])
    twice = fields.derivative(fields.derivative(R_U, "v"), "v")
    for i, entry in enumerate(derivative(position, U, V, V)):
        rebuilt = twice[0] * r_u[i] + twice[1] * r_v[i] + twice[2] * normal[i]
        assert sp.simplify(entry - rebuilt) == 0


def test_the_third_form_obeys_the_characteristic_equation_on_the_helicoid():
    position = (U * sp.cos(V), U * sp.sin(V), V)
    r_u, r_v = derivative(position, U), derivative(position, V)
    normal = tuple(entry / sp.sqrt(1 + U**2) for entry in cross(r_u, r_v))
    first, second = first_form(PLAIN, r_u, r_v), second_form(PLAIN, r_u, r_v, normal)
    expected = third_from_others(first, second)
    for found, wanted in zip(third_form(PLAIN, normal), expected, strict=True):
        assert sp.simplify(found - wanted) == 0


@pytest.mark.parametrize("front", [pseudosphere(), dini(2), dini(sp.Rational(1, 3)), kuen()])
def test_components_along_the_radius_agree_with_space(front):
    place = {U: sp.Rational(1, 3), V: sp.Rational(4, 5)}
    position = front.at(front.position, U, V)
    r_u, r_uv = derivative(position, U), derivative(position, U, V)
    net = front.net(1)
    chi = front.rates["u"][0] * place[U] + front.rates["v"][0] * place[V]
    inside = {net.calculus.x: sp.exp(chi), front.theta: place[V] - place[U]}
    for mine, theirs in (
        (net.calculus.dot(net.r_u, net.r_v), dot(r_u, derivative(position, V))),
        (net.calculus.dot(net.d(net.r_u, "v"), net.r_v), dot(r_uv, derivative(position, V))),
        (
            net.calculus.dot(net.d(net.r_u, "v"), net.normal),
            dot(r_uv, front.at(front.normal, U, V)),
        ),
    ):
        assert abs(sp.N(sp.sympify(mine).subs(inside) - theirs.subs(place), 30)) < 1e-20


@pytest.mark.parametrize("sigma", [1, -1])
def test_the_general_net_is_right_handed_along_the_u_lines(sigma):
    net = general_net(sigma)
    assert vanishes(handedness(net.calculus, u_frame(net)) - 1)


def test_the_goursat_series_keeps_the_normal_of_unit_length():
    unit = sp.eye(3)
    along_v = sp.Matrix([unit.row(1), -unit.row(0), unit.row(2)])
    curvature = sp.Symbol("k")
    series = goursat_series(
        curve_normals(unit, curvature, -1, order=4), curve_normals(along_v, 0, 1, order=4)
    )
    for i in range(5):
        for j in range(5):
            product = sum(
                dot(series[k, m], series[i - k, j - m]) for k in range(i + 1) for m in range(j + 1)
            )
            assert sp.expand(product) == (1 if i == j == 0 else 0)


def test_the_primitive_of_a_closed_form_is_the_map_itself():
    whole = (U**2 * V, U + V, U * V**3)
    rebuilt = primitive(derivative(whole, U), derivative(whole, V), U, V)
    assert all(sp.expand(a - b) == 0 for a, b in zip(whole, rebuilt, strict=True))
