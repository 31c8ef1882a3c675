"""Exact real numbers built from rationals and pi: a small tree, and its values in each arithmetic.

A leaf is a + b pi with rational a, b, so that what is linear in pi is compared exactly; sums,
products, quotients, integer powers and square roots of leaves are the other nodes.
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Generic, TypeAlias, TypeVar

Number = TypeVar("Number")

MOST_BITS = 4096
"""Largest precision at which a sign is sought, and largest size of a rational."""


class Unresolved(ArithmeticError):
    """A tree whose sign no ball of MOST_BITS bits decides."""


@dataclass(frozen=True)
class Linear:
    """The number constant + pi_multiple * pi."""

    constant: Fraction
    pi_multiple: Fraction = Fraction(0)

    @property
    def rational(self) -> bool:
        """Whether the number is its constant."""
        return self.pi_multiple == 0


@dataclass(frozen=True)
class Sum:
    """The number left + right."""

    left: "Node"
    right: "Node"


@dataclass(frozen=True)
class Product:
    """The number left * right."""

    left: "Node"
    right: "Node"


@dataclass(frozen=True)
class Quotient:
    """The number top / bottom, where bottom is certainly not 0."""

    top: "Node"
    bottom: "Node"


@dataclass(frozen=True)
class Power:
    """The number base ** exponent, for a non-negative integer exponent."""

    base: "Node"
    exponent: int


@dataclass(frozen=True)
class Root:
    """The square root of a certainly positive number."""

    radicand: "Node"


Node: TypeAlias = Linear | Sum | Product | Quotient | Power | Root


@dataclass(frozen=True)
class Arithmetic(Generic[Number]):
    """How one number type takes rationals, pi and square roots; + * / ** are its own."""

    rational: Callable[[Fraction], Number]
    pi: Callable[[], Number]
    sqrt: Callable[[Number], Number]


def value(node: Node, arithmetic: Arithmetic[Any]) -> Any:
    """Value of the tree in the arithmetic, at the precision in force there."""
    match node:
        case Linear(constant, pi_multiple):
            a = arithmetic.rational(constant)
            return a if node.rational else a + arithmetic.rational(pi_multiple) * arithmetic.pi()
        case Sum(left, right):
            return value(left, arithmetic) + value(right, arithmetic)
        case Product(left, right):
            return value(left, arithmetic) * value(right, arithmetic)
        case Quotient(top, bottom):
            return value(top, arithmetic) / value(bottom, arithmetic)
        case Power(base, exponent):
            return value(base, arithmetic) ** exponent
        case Root(radicand):
            return arithmetic.sqrt(value(radicand, arithmetic))


def balls() -> Arithmetic[Any]:
    """Balls of python-flint at the precision in force."""
    from flint import arb, fmpq

    def rational(q: Fraction) -> Any:
        return arb(fmpq(q.numerator, q.denominator))

    return Arithmetic(rational, arb.pi, arb.sqrt)


def mpfs() -> Arithmetic[Any]:
    """Floating-point numbers of mpmath at the precision in force."""
    from mpmath import mp

    def rational(q: Fraction) -> Any:
        return mp.mpf(q.numerator) / q.denominator

    return Arithmetic(rational, lambda: +mp.pi, mp.sqrt)


def resolved(node: Node, *, accuracy: int = 32) -> tuple[Any, int]:
    """Ball of at least this many accurate bits, which excludes 0, and the bits of work it took.

    Raises Unresolved if no ball of MOST_BITS bits is so accurate, as where the number is 0.
    """
    from flint import ctx

    bits = 2 * accuracy
    while bits <= MOST_BITS:
        with ctx.workprec(bits):
            ball = value(node, balls())
            if ball.is_finite() and ball != 0 and ball.rel_accuracy_bits() >= accuracy:
                return ball, bits
        bits *= 2
    raise Unresolved(f"no ball of {MOST_BITS} bits tells it from 0")


def sign(node: Node) -> int:
    """-1, 0 or 1; exact for what is linear in pi, by balls else. Raises Unresolved."""
    if isinstance(node, Linear) and node.rational:
        return (node.constant > 0) - (node.constant < 0)
    return 1 if resolved(node)[0] > 0 else -1


def added(left: Node, right: Node) -> Node:
    """Sum, a leaf where both are."""
    if isinstance(left, Linear) and isinstance(right, Linear):
        return Linear(left.constant + right.constant, left.pi_multiple + right.pi_multiple)
    return Sum(left, right)


def multiplied(left: Node, right: Node) -> Node:
    """Product, a leaf where one is rational and the other a leaf."""
    if isinstance(right, Linear) and right.rational:
        left, right = right, left
    if isinstance(left, Linear) and left.rational:
        if isinstance(right, Linear):
            q = left.constant
            return Linear(q * right.constant, q * right.pi_multiple)
        if left.constant == 0:
            return left
    return Product(left, right)


def subtracted(left: Node, right: Node) -> Node:
    """Difference, exactly 0 where both are the same number linear in pi."""
    return added(left, multiplied(Linear(Fraction(-1)), right))
