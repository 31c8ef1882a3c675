"""Exact expressions: what they denote in every arithmetic, and what is refused."""

import re
import sys
import warnings
from fractions import Fraction

import mpmath
import pytest
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from checks.errors import BadInput
from checks.expression import compare, parse
from checks.expression_tree import Linear, Unresolved, resolved, sign

HOSTILE = [
    "",
    " ",
    "9**9**9",
    "(((9**64)**64)**64)",
    "2**65",
    "2**-65",
    "2**(1/2)",
    "2**pi",
    "__import__('os')",
    "__import__",
    "os.system",
    "x",
    "e",
    "pi.real",
    "pi(2)",
    "pi[0]",
    "2(3)",
    "sqrt",
    "sqrt()",
    "sqrt(1,2)",
    "sqrt(*pi)",
    "sqrt(**pi)",
    "sqrt(-1)",
    "sqrt(pi-4)",
    "sqrt(sqrt(2)*sqrt(2)-2)",
    "eval(1)",
    "1/0",
    "1/(pi-pi)",
    "1/(sqrt(2)**2-2)",
    "sqrt(2)-sqrt(2)",
    "0**-1",
    "--",
    "-",
    "1+",
    "()",
    "(1",
    "1)",
    "1 2",
    "1,2",
    "1;2",
    "1=2",
    "1==2",
    "1<2",
    "1//2",
    "7%2",
    "1|2",
    "~1",
    "1 if 1 else 2",
    "1or 2",
    "lambda: 1",
    "[1]",
    "{1}",
    "'1'",
    "f'1'",
    "True",
    "None",
    "...",
    "inf",
    "nan",
    "1j",
    "0x10",
    "0b1",
    "007",
    "1_000",
    "1e400",
    "1e-400",
    "1e999999999999",
    "10**64*10**64*10**64*10**64*10**64",
    "1/(10**64*10**64*10**64*10**64*10**64)",
    "pi**64**64",
    "((pi**64)**64)**64",
    "1\x00",
    "\x00",
    "1\n+1",
    "1\\\n+1",
    "1#2",
    "\u0661\u0662",
    "\u03c0",
    "\uff11",
    "1\u22122",
    "\ud800",
    "\u202e1",
    "1" * 201,
    "(" * 100_000 + "1" + ")" * 100_000,
    "(" * 99 + "1" + ")" * 100,
    "-" * 100_000 + "1",
    "sqrt(" * 39 + "2" + ")" * 38,
]


@pytest.mark.parametrize("text", HOSTILE, ids=lambda text: ascii(text[:30]))
def test_what_is_no_exact_expression_is_refused_in_one_line(text: str):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(BadInput, match="expected") as refusal:
            parse(text)
    assert "\n" not in str(refusal.value)
    assert len(str(refusal.value)) < 300
    assert str(refusal.value).isascii()


def test_deep_nesting_leaks_no_recursion_error():
    depth = 0
    frame = sys._getframe()
    while frame is not None:
        depth, frame = depth + 1, frame.f_back
    old = sys.getrecursionlimit()
    sys.setrecursionlimit(depth + 60)
    try:
        with pytest.raises(BadInput, match="less deep nesting"):
            parse("-" * 190 + "1")
    finally:
        sys.setrecursionlimit(old)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("0.1", Fraction(1, 10)),
        (".5", Fraction(1, 2)),
        ("1.", Fraction(1)),
        ("1e-12", Fraction(1, 10**12)),
        ("2.5E+1", Fraction(25)),
        ("1/3+1/6", Fraction(1, 2)),
        ("-2**2", Fraction(-4)),
        ("(-2)**2", Fraction(4)),
        ("2**-3", Fraction(1, 8)),
        ("2**3**2", Fraction(512)),
        ("0**0", Fraction(1)),
        ("sqrt(9/16)", Fraction(3, 4)),
        ("sqrt(0)", Fraction(0)),
        ("2*pi-pi-pi", Fraction(0)),
        ("--1", Fraction(1)),
        ("+-+1", Fraction(-1)),
        (" 3 * ( 4 ) ", Fraction(12)),
        ("-" * 199 + "1", Fraction(-1)),
        ("1" * 200, Fraction(int("1" * 200))),
    ],
)
def test_rationals_are_exact(text: str, number: Fraction):
    assert parse(text).exact == number


def test_pi_is_exact_at_any_precision():
    third = parse("pi/3 + 1/7")
    for bits in (64, 1000, 30000):
        with ctx.workprec(bits), mpmath.workprec(bits):
            ball = third.ball()
            assert ball.rel_accuracy_bits() > bits - 10
            assert abs(third.mpf() - mpmath.pi / 3 - mpmath.mpf(1) / 7) < mpmath.mpf(2) ** (
                2 - bits
            )
    assert third.exact is None


def test_cancellation_costs_neither_the_ball_nor_the_number_its_accuracy():
    small = parse("pi - 3.14159265358979323846264338327950288")
    with ctx.workprec(64):
        assert small.ball().rel_accuracy_bits() > 55
    with mpmath.workdps(60):
        wanted = mpmath.pi - mpmath.mpf("3.14159265358979323846264338327950288")
    with mpmath.workdps(15):
        assert abs(small.mpf() / wanted - 1) < 1e-14
    assert abs(float(small) / float(wanted) - 1) < 1e-14


def test_ties_linear_in_pi_are_decided_exactly():
    assert compare(parse("3*pi/4"), parse("pi*0.75")) == 0
    assert compare(parse("1e-60+pi/2"), parse("pi/2")) == 1
    assert compare(parse("sqrt(2)"), parse("1.5")) == -1
    with pytest.raises(BadInput, match="told apart"):
        compare(parse("sqrt(8)"), parse("2*sqrt(2)"))


def test_a_sign_that_balls_do_not_decide_is_not_guessed():
    assert sign(Linear(Fraction(0))) == 0
    with pytest.raises(Unresolved):
        resolved(Linear(Fraction(0)))


def test_the_precision_of_a_caller_is_left_as_it_was():
    before = (ctx.prec, ctx.cap, mpmath.mp.prec)
    expression = parse("sqrt(pi)-1")
    expression.ball(), expression.mpf(), float(expression)
    for text in ("1/(sqrt(2)**2-2)", "9**9**9"):
        with pytest.raises(BadInput):
            parse(text)
    assert (ctx.prec, ctx.cap, mpmath.mp.prec) == before


NOTHING = mpmath.mpf(10) ** -350
"""Where mpmath sees less than this at 400 digits, the exact number is taken to be 0."""


class Undefined(ArithmeticError):
    """The generated expression divides by 0 or takes the root of a negative number."""


def _quotient(a, b):
    if abs(b) < NOTHING:
        raise Undefined
    return a / b


def _power(a, n):
    return _quotient(1, a**-n) if n < 0 else a**n


def _root(a):
    if a < -NOTHING:
        raise Undefined
    return mpmath.sqrt(abs(a))


LEAVES = st.one_of(
    st.integers(0, 20).map(lambda n: (str(n), lambda: mpmath.mpf(n))),
    st.integers(1, 999).map(lambda n: (f"0.{n:03d}", lambda: mpmath.mpf(n) / 1000)),
    st.just(("pi", lambda: +mpmath.pi)),
)


def _binary(children, op, function):
    return st.tuples(children, children).map(
        lambda p: (f"({p[0][0]}){op}({p[1][0]})", lambda: function(p[0][1](), p[1][1]()))
    )


def _joined(children):
    return st.one_of(
        _binary(children, "+", lambda a, b: a + b),
        _binary(children, "-", lambda a, b: a - b),
        _binary(children, "*", lambda a, b: a * b),
        _binary(children, "/", _quotient),
        children.map(lambda c: (f"sqrt({c[0]})", lambda: _root(c[1]()))),
        children.map(lambda c: (f"-({c[0]})", lambda: -c[1]())),
        st.tuples(children, st.integers(-4, 4)).map(
            lambda p: (f"({p[0][0]})**{p[1]}", lambda: _power(p[0][1](), p[1]))
        ),
    )


def _midpoint(ball):
    mantissa, exponent = ball.mid().man_exp()
    return mpmath.mpf((int(mantissa), int(exponent)))


@given(st.recursive(LEAVES, _joined, max_leaves=6))
def test_every_arithmetic_agrees_with_mpmath(pair):
    text, number = pair
    with mpmath.workdps(400):
        try:
            wanted = number()
        except Undefined:
            with pytest.raises(BadInput):
                parse(text)
            return
    try:
        expression = parse(text)
    except BadInput as error:
        # 0 to 4096 bits, or larger than is allowed: no other reason to refuse what is defined.
        assert re.search("tell from 0|characters|bits|size", str(error))  # noqa: PT017
        return
    tiny = mpmath.mpf(10) ** -58 * abs(wanted) + NOTHING
    with ctx.workprec(200), mpmath.workdps(60):
        ball = expression.ball()
        assert ball.rel_accuracy_bits() > 190 or wanted < NOTHING
        assert abs(_midpoint(ball) - wanted) <= tiny
        assert abs(expression.mpf() - wanted) <= tiny
        if expression.exact is not None:
            q = mpmath.mpf(expression.exact.numerator) / expression.exact.denominator
            assert abs(q - wanted) <= tiny
    assert abs(float(expression) - float(wanted)) <= 4e-16 * abs(float(wanted))


def test_the_ball_contains_the_number():
    text = "sqrt(2)*pi**3/7 - sqrt(3)"
    with mpmath.workdps(100):
        wanted = mpmath.sqrt(2) * mpmath.pi**3 / 7 - mpmath.sqrt(3)
        digits = mpmath.nstr(wanted, 90)
    with ctx.workprec(200):
        ball = parse(text).ball()
    assert ball.is_finite()
    assert ball.rad() < 1e-55
    with ctx.workprec(400):
        assert ball.contains(arb(digits))
