"""Exact expressions of the command line, such as pi/100 or 3*sqrt(2)/4: read without eval."""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from checks import expression_tree as trees
from checks.errors import BadInput
from checks.expression_syntax import Refusal, tree_of
from checks.expression_tree import MOST_BITS, Linear, Node, Unresolved

MOST_CHARACTERS = 200
LARGEST = 10**300


@dataclass(frozen=True)
class Expression:
    """Exact real number other than an undecided 0; guard: bits lost by evaluating its tree."""

    text: str
    tree: Node
    guard: int

    @property
    def exact(self) -> Fraction | None:
        """The number itself where it is rational, else None."""
        tree = self.tree
        return tree.constant if isinstance(tree, Linear) and tree.rational else None

    def ball(self) -> Any:
        """Ball of flint that contains the number, accurate to the precision in force.

        >>> from flint import ctx
        >>> with ctx.workprec(200):
        ...     print(parse("pi/100").ball().str(30, radius=False))
        0.0314159265358979323846264338328
        """
        from flint import ctx

        with ctx.workprec(ctx.prec + self.guard):
            return trees.value(self.tree, trees.balls())

    def mpf(self) -> Any:
        """Value in mpmath, accurate to the precision in force.

        >>> import mpmath
        >>> with mpmath.workdps(30):
        ...     print(parse("sqrt(2)**3/2").mpf())
        1.41421356237309504880168872421
        """
        from mpmath import mp

        with mp.workprec(mp.prec + self.guard + 8):
            wide = trees.value(self.tree, trees.mpfs())
        return +wide

    def __float__(self) -> float:
        from mpmath import mp

        with mp.workprec(64):
            return float(self.mpf())


def compare(left: Expression, right: Expression) -> int:
    """Sign of left - right, exact where both are linear in pi or written alike.

    Raises BadInput where the two cannot be told apart.

    >>> compare(parse("22/7"), parse("pi")), compare(parse("2*pi/4"), parse("pi/2"))
    (1, 0)
    """
    if left.tree == right.tree:
        return 0
    try:
        return trees.sign(trees.subtracted(left.tree, right.tree))
    except Unresolved as error:
        raise BadInput(
            f"{left.text!a} and {right.text!a} agree to {MOST_BITS} bits: "
            "expected numbers that can be told apart"
        ) from error


def parse(text: str) -> Expression:
    """Exact real number that the text denotes; decimals are rationals, so 0.1 is 1/10.

    At most 200 characters, integer exponents of absolute value at most 64. Raises BadInput.

    >>> parse("0.1 + 2/5").exact
    Fraction(1, 2)
    >>> parse("pi - pi").exact
    Fraction(0, 1)
    >>> parse("9**9**9")
    Traceback (most recent call last):
    checks.errors.BadInput: cannot use '9**9**9': expected exponents from -64 to 64, got 387420489
    """
    try:
        if len(text) > MOST_CHARACTERS:
            raise Refusal(f"expected at most {MOST_CHARACTERS} characters, got {len(text)}")
        tree = tree_of(text)
        return Expression(text, tree, _guard(tree))
    except Refusal as reason:
        shown = ascii(text if len(text) <= 60 else f"{text[:57]}...")
        raise BadInput(f"cannot use {shown}: {reason}") from None
    except (RecursionError, MemoryError):
        raise BadInput(f"cannot use {text!a}: expected less deep nesting") from None


def _guard(tree: Node) -> int:
    """Bits that evaluation loses by cancellation, of a number of reasonable size."""
    if isinstance(tree, Linear) and tree.rational:
        size: Any = abs(tree.constant)
        lost = 0
    else:
        try:
            ball, bits = trees.resolved(tree)
        except Unresolved as error:
            raise Refusal(f"expected a number that {MOST_BITS} bits can tell from 0") from error
        size, lost = abs(ball), max(0, bits - ball.rel_accuracy_bits())
    if not (size == 0 or (size < LARGEST and size * LARGEST > 1)):
        raise Refusal("expected 0 or a size between 1e-300 and 1e300")
    return int(lost)
