"""Positivity is proved only of what is positive, and orders of vanishing are exact."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from checks.evidence import Setting
from checks.order import order_of_zero
from checks.positivity import positivity, proved_positive

X, Y = sp.symbols("x y", positive=True)


@pytest.mark.parametrize(
    "expr",
    [
        X + Y,
        1 + X**2 * Y,
        sp.cosh(X) - 1,
        sp.sinh(X) / (1 + Y),
        sp.exp(X) - 1,
        sp.exp(2 * X) - sp.exp(X),
    ],
    ids=str,
)
def test_what_is_positive_is_proved(expr: sp.Expr):
    assert positivity(Setting(), {"it": expr}, shown="").outcome == "pass"


@pytest.mark.parametrize("expr", [X - Y, sp.cosh(X) - 2, X - X, sp.exp(-X) - 1, -X], ids=str)
def test_what_is_not_is_refuted(expr: sp.Expr):
    found = positivity(Setting(), {"it": expr}, shown="")
    assert found.outcome == "fail"
    assert "it is not positive" in found.witness


def test_what_neither_proves_nor_refutes_is_undecided():
    square = (X - Y) ** 2 + sp.Rational(1, 100)
    assert positivity(Setting(), {"it": square}, shown="").outcome == "undecided"
    with pytest.raises(ValueError, match="nothing to prove"):
        positivity(Setting(), {}, shown="")


@given(st.lists(st.integers(-3, 3), min_size=1, max_size=5), st.fractions("1/20", 5))
def test_a_polynomial_proved_positive_is_positive(coefficients: list[int], value):
    poly = sum(c * X**n for n, c in enumerate(coefficients))
    if proved_positive(poly):
        assert sum(c * value**n for n, c in enumerate(coefficients)) > 0


@pytest.mark.parametrize("order", range(5))
def test_the_order_of_a_zero(order: int):
    expr = sp.sin(X - 1) ** order * (2 + sp.cos(X))
    assert order_of_zero(expr, X, sp.Integer(1)) == order


def test_an_identically_vanishing_expression_has_no_order():
    with pytest.raises(ValueError, match="vanishes to an order above"):
        order_of_zero(sp.sin(X) ** 2 + sp.cos(X) ** 2 - 1, X, sp.Integer(1))
