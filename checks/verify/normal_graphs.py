"""The ramification index by the gradient of a graph (section 3.3)."""

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities
from checks.printed import normal_map as printed
from checks.verify.normal_index import SADDLES, at_samples, ball_index
from theory.orientation import generic_plane
from theory.polynomial_graph import PolynomialGraph, real_power
from theory.vectors import Vector
from theory.winding import X, Y, winding_by_zeros


def graph_normal(setting: Setting, *, sign: int = 1) -> Evidence:
    """Line 673: direction of pi(N), N upward, against the gradient, over a horizontal plane."""
    plane = generic_plane()
    w_1, w_2 = plane.slope_1, plane.slope_2
    up: Vector = (sp.Integer(0), sp.Integer(0), sp.Integer(1))
    part = printed.tangential_part(up, plane.upward_normal)
    x, y = printed.graph_direction((w_1, w_2), sign=sign)
    length = sp.sqrt(1 + w_1**2 + w_2**2)
    found = identities(
        setting,
        {"x_perp - direction/sqrt(1 + |grad w|^2)": [part[0] - x / length, part[1] - y / length]},
        shown="direction",
    )
    if found.outcome == "fail":
        witness = (
            "w = x_1^2/2 - x_2^2/2 at (1, 0): the upward normal is (-1, 0, 1)/sqrt(2), so pi(N) is "
            f"(-1, 0), while grad w is (1, 0); {found.witness}"
        )
        return Evidence(outcome="fail", grade="exact", witness=witness)
    return combined(
        {"direction": found},
        shown="for the upward normal pi(N) = -grad w/|grad w|; the tangent plane is x_3 = 0, "
        "for the gradient vanishes at p",
    )


def graph_index(setting: Setting, *, conjugate: int = 1, radius: str = "1/10") -> Evidence:
    """Line 676: degree of the gradient direction on a small circle against J_p by its definition.

    conjugate: factor of the second derivative (-1 reverses the degree); radius: of the circle on
    which the gradient is taken, J_p being taken on that of radius 1/10.
    """
    heights = {**SADDLES, "Re z^2/8 + Re z^3": real_power(2) / 8 + real_power(3)}
    wrong = []
    size = sp.Rational(radius)
    for name, height in heights.items():
        graph = PolynomialGraph(height=height)
        small = sp.Rational(1, 100)
        by_definition = ball_index(graph, radius=small)
        first, second = graph.gradient
        degree = winding_by_zeros((first, conjugate * second), 0, size * small * 10)
        if degree != by_definition:
            wrong.append(f"w = {name}: the gradient has degree {degree}, J_p is {by_definition}")
    return at_samples(
        wrong,
        tried=len(heights),
        shown="for seven polynomial graphs J_p by its definition, in balls, is the degree of the "
        "gradient, from its zeros; turning all vectors by pi changes no degree, so the sign "
        "of the gradient is of no account here",
    )


def winding_jump(setting: Setting, *, first: int = 2, second: int = 3) -> Evidence:
    """Line 698: degrees of the two saddles, and where a path between them loses its degree.

    On the circle |z| = 1 the gradient of (1 - s) Re z^2 + s Re z^3 vanishes for s = 2/5 alone, at
    z = -1: there, and nowhere else, the degree jumps.
    """
    s = sp.Symbol("s", positive=True)
    wrong = []
    counts = {
        order: winding_by_zeros(PolynomialGraph(height=real_power(order)).gradient, 0, 1)
        for order in (first, second)
    }
    if (abs(counts[first]), abs(counts[second])) != (1, 2):
        wrong.append(f"winding numbers {list(counts.values())}")
    path = (1 - s) * real_power(first) + s * real_power(second)
    at = sp.Rational(first, first + second)
    for value, expected in ((at / 2, counts[first]), ((1 + at) / 2, counts[second])):
        graph = PolynomialGraph(height=sp.expand(path.subs(s, value)))
        if (found := winding_by_zeros(graph.gradient, 0, 1)) != expected:
            wrong.append(f"s = {value}: {found}")
    middle = PolynomialGraph(height=sp.expand(path.subs(s, at)))
    if any(entry.subs({X: -1, Y: 0}) != 0 for entry in middle.gradient):
        wrong.append(f"s = {at}: the gradient does not vanish at -1")
    return at_samples(
        wrong,
        tried=5,
        shown="the gradient of the saddle winds -1 times, that of the monkey saddle -2 times; on "
        "the straight path between them the number changes only where the gradient vanishes on "
        "the circle, so along no path of nowhere vanishing gradients",
    )
