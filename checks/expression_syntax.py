"""The words of an exact expression: cut, read by Python's parser, walked by hand.

The text is cut into the few words allowed before Python's own parser sees it; of the syntax tree
that comes back every node that is not listed here is refused. Nothing is ever evaluated by Python.
"""

import ast
import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt

from checks import expression_tree as trees
from checks.expression_tree import MOST_BITS, Linear, Node, Power, Quotient, Root, Unresolved

LARGEST_EXPONENT = 64

_NUMBER = re.compile(r"(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE]([+-]?[0-9]+))?")
_WORD = re.compile(rf"{_NUMBER.pattern}|pi|sqrt|\*\*|[-+*/() ]")
_EXPECTED = "expected numbers, pi, sqrt(...), + - * / ** and parentheses, as in 3*pi/4"


class Refusal(Exception):
    """Why a text is no exact expression: what was expected."""


def tree_of(text: str) -> Node:
    """Tree of the exact number that the text denotes.

    Raises Refusal; RecursionError and MemoryError are left to the caller, who bounds the length.
    """
    return _Walk(text.strip(" ")).node(_parsed(text.strip(" ")))


def _parsed(text: str) -> ast.expr:
    place = 0
    while place < len(text):
        word = _WORD.match(text, place)
        if word is None:
            raise Refusal(f"{_EXPECTED}, got {text[place]!a} at character {place + 1}")
        place = word.end()
    try:
        return ast.parse(text, mode="eval").body
    except SyntaxError as error:
        raise Refusal(_EXPECTED) from error


def _bounded(node: Node) -> Node:
    if isinstance(node, Linear):
        for q in (node.constant, node.pi_multiple):
            if max(q.numerator.bit_length(), q.denominator.bit_length()) > MOST_BITS:
                raise Refusal(f"expected rational numbers of at most {MOST_BITS} bits")
    return node


def _sign(node: Node, what: str) -> int:
    try:
        return trees.sign(node)
    except Unresolved as error:
        raise Refusal(f"expected {what} that {MOST_BITS} bits can tell from 0") from error


def _divided(top: Node, bottom: Node) -> Node:
    if _sign(bottom, "a divisor") == 0:
        raise Refusal("expected a divisor that is not 0")
    if isinstance(bottom, Linear) and bottom.rational:
        return trees.multiplied(Linear(1 / bottom.constant), top)
    return Quotient(top, bottom)


def _power(base: Node, exponent: Node) -> Node:
    if not (isinstance(exponent, Linear) and exponent.rational):
        raise Refusal("expected an integer exponent")
    n = exponent.constant
    if n.denominator != 1:
        raise Refusal("expected an integer exponent, for a square root sqrt(...)")
    if abs(n) > LARGEST_EXPONENT:
        shown = str(n) if abs(n) < 10**12 else "a larger one"
        raise Refusal(
            f"expected exponents from -{LARGEST_EXPONENT} to {LARGEST_EXPONENT}, got {shown}"
        )
    if n < 0:
        return _divided(Linear(Fraction(1)), _power(base, Linear(-n)))
    if isinstance(base, Linear) and base.rational:
        return Linear(base.constant ** int(n))
    return base if n == 1 else Linear(Fraction(1)) if n == 0 else Power(base, int(n))


def _root(radicand: Node) -> Node:
    if _sign(radicand, "a radicand") < 0:
        raise Refusal("expected a radicand that is not negative")
    if isinstance(radicand, Linear) and radicand.rational:
        q = radicand.constant
        root = Fraction(isqrt(q.numerator), isqrt(q.denominator))
        if root * root == q:
            return Linear(root)
    return Root(radicand)


_OPERATIONS: dict[type[ast.operator], Callable[[Node, Node], Node]] = {
    ast.Add: trees.added,
    ast.Sub: trees.subtracted,
    ast.Mult: trees.multiplied,
    ast.Div: _divided,
    ast.Pow: _power,
}


@dataclass(frozen=True)
class _Walk:
    """Walk from Python's syntax tree of a text to an exact tree."""

    text: str

    def node(self, syntax: ast.expr) -> Node:
        """Tree of one node of the syntax; raises Refusal for one that is not listed."""
        match syntax:
            case ast.Constant():
                return _bounded(self._number(syntax))
            case ast.Name(id="pi"):
                return Linear(Fraction(0), Fraction(1))
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.node(operand)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return trees.multiplied(Linear(Fraction(-1)), self.node(operand))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATIONS:
                return _bounded(_OPERATIONS[type(op)](self.node(left), self.node(right)))
            case ast.Call(func=ast.Name(id="sqrt"), args=[radicand], keywords=[]):
                return _root(self.node(radicand))
        raise Refusal(_EXPECTED)

    def _number(self, constant: ast.Constant) -> Node:
        # The characters, not Python's value: 0.1 must be 1/10 and not the float next to it.
        written = self.text[constant.col_offset : constant.end_col_offset]
        number = _NUMBER.fullmatch(written)
        if number is None:
            raise Refusal(_EXPECTED)
        if number[1] and abs(int(number[1])) > LARGEST_EXPONENT:
            raise Refusal(
                f"expected decimal exponents from -{LARGEST_EXPONENT} to {LARGEST_EXPONENT}"
            )
        return Linear(Fraction(written))
