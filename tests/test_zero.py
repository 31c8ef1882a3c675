"""The zero test proves identities, never a false one, and refutations name a point."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from checks.ball import enclosure, nonzero_point
from checks.evidence import Setting
from checks.exact import combined, identities, statement
from checks.zero import vanishes

U, V = sp.symbols("u v", real=True)
K = sp.Symbol("k", positive=True)
PHI = sp.Function("phi")(U, V)

IDENTITIES = [
    sp.cos(PHI / 2) ** 2 - sp.sin(PHI / 2) ** 2 - sp.cos(PHI),
    sp.diff(sp.sin(PHI) ** 2, U) - sp.sin(2 * PHI) * sp.diff(PHI, U),
    sp.cosh(U + V) ** 2 - sp.sinh(U + V) ** 2 - 1,
    sp.sech(U / 2) ** 2 + sp.tanh(U / 2) ** 2 - 1,
    1 / sp.sqrt(K**2 + 1) - sp.sqrt(K**2 + 1) / (K**2 + 1),
    sp.tan(U) - 2 * sp.tan(U / 2) / (1 - sp.tan(U / 2) ** 2),
    sp.cos(3 * U - V) - sp.cos(V - 3 * U),
    sp.sqrt(1 + sp.sqrt(1 + K**2)) ** 4 - (1 + sp.sqrt(1 + K**2)) ** 2,
    sp.exp(U / 2) ** 2 - sp.exp(U),
    PHI.diff(U, V) - PHI.diff(V, U),
    sp.sympify(0),
]


@pytest.mark.parametrize("expr", IDENTITIES, ids=str)
def test_identities_are_proved(expr: sp.Expr):
    assert vanishes(expr)


@pytest.mark.parametrize("expr", IDENTITIES[:-1], ids=str)
def test_a_changed_identity_is_refuted_at_a_point(expr: sp.Expr):
    evidence = identities(Setting(), {"changed": expr + sp.Rational(1, 10**6)}, shown="")
    assert evidence.outcome == "fail"
    assert "changed" in evidence.witness


LEAVES = st.sampled_from([U, V, K, sp.Integer(2), sp.Rational(-1, 3), sp.sin(U), sp.cosh(V)])
TREES = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.tuples(inner, inner).map(lambda p: p[0] + p[1]),
        st.tuples(inner, inner).map(lambda p: p[0] * p[1]),
        inner.map(sp.sin),
        inner.map(lambda e: sp.sqrt(1 + e**2)),
    ),
    max_leaves=5,
)


@given(TREES)
def test_what_is_said_to_vanish_has_no_nonzero_point(expr: sp.Expr):
    found = nonzero_point(expr, Setting().random())
    assert not (vanishes(expr) and found)


@given(TREES, TREES)
def test_the_square_of_a_sum(a: sp.Expr, b: sp.Expr):
    assert vanishes((a + b) ** 2 - a**2 - 2 * a * b - b**2)


@given(st.fractions(-2, 2), st.fractions(-2, 2))
def test_balls_contain_the_value(a, b):
    point = {U: sp.Rational(a.numerator, a.denominator), V: sp.Rational(b.numerator, b.denominator)}
    expr = sp.sin(U) * sp.exp(V) + sp.sqrt(1 + U**2) - sp.atan(U * V)
    exact = expr.subs(point).evalf(40)
    ball = enclosure(expr, point)
    assert abs(float(ball.mid()) - float(exact)) <= float(ball.rad()) + 1e-14


def test_a_relation_outside_the_normal_form_is_left_undecided():
    hidden = sp.sqrt(2) * sp.sqrt(3 + U**2) - sp.sqrt(6 + 2 * U**2)
    assert identities(Setting(), {"hidden": hidden}, shown="").outcome in ("undecided", "pass")
    assert not vanishes(sp.atan(U) + sp.atan(1 / U) - sp.pi / 2)
    assert identities(Setting(), {"sign": sp.Abs(U) - U}, shown="").outcome == "fail"


def test_no_residual_is_an_error_and_no_proof():
    with pytest.raises(ValueError, match="nothing to prove"):
        identities(Setting(), {}, shown="")
    with pytest.raises(TypeError, match="scalar"):
        vanishes(sp.eye(2))


def test_combined_evidence_takes_the_weakest_part():
    good = statement(True, shown="", witness="")
    bad = statement(False, shown="", witness="1 is not 2")
    assert combined({"a": good, "b": good}, shown="both").outcome == "pass"
    failed = combined({"a": good, "b": bad}, shown="both")
    assert failed.outcome == "fail"
    assert failed.witness == "b: 1 is not 2"
    with pytest.raises(ValueError, match="no parts"):
        combined({}, shown="")


X_REAL, X_POSITIVE = sp.Symbol("x", real=True), sp.Symbol("x", positive=True)
F = sp.Function("f")
TRAPS = [
    sp.sin(30 * X_REAL) - sp.sin(30 * X_POSITIVE),
    sp.sin(U) - 2 * sp.Symbol("_t0") / (1 + sp.Symbol("_t0") ** 2),
    F(U) - sp.Symbol("_f0"),
    sp.exp(U) - sp.Symbol("_e0"),
    sp.sqrt(1 + U) - sp.Symbol("_r0"),
    sp.sqrt(sp.exp(4 * sp.I * U)) - sp.exp(2 * sp.I * U),
    sp.sign(sp.sqrt(U)) - 1,
]


# Numbers for names: sympy orders two symbols of one name by chance, and so the text of a trap.
@pytest.mark.parametrize("expr", TRAPS, ids=range(len(TRAPS)))
def test_names_and_assumptions_of_generators_prove_nothing(expr: sp.Expr):
    assert not vanishes(expr)


def test_calls_with_equal_arguments_are_not_told_apart():
    same = F((U + 1) ** 2) - F(U**2 + 2 * U + 1)
    assert identities(Setting(), {"same": same}, shown="").outcome != "fail"


def test_a_refutation_meets_the_hypotheses():
    expr = sp.Abs(U) - U
    assert identities(Setting(), {"abs": expr}, shown="").outcome == "fail"
    assert identities(Setting(), {"abs": expr}, shown="", where=(U,)).outcome != "fail"


def test_a_derivative_that_can_be_carried_out_is_no_unknown():
    lazy = sp.Derivative(sp.sin(U), U) - sp.cos(U)
    assert identities(Setting(), {"lazy": lazy}, shown="").outcome == "pass"
