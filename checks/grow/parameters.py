"""From the words of the command line to the exact parameters of the greedy algorithm."""

from fractions import Fraction
from typing import Any

from checks.errors import BadInput
from checks.expression import Expression, parse
from checks.expression_tree import Linear

DEFAULT_SECTORS = 4


def named(name: str, text: str) -> Expression:
    """Number of an option; raises BadInput that names it."""
    try:
        return parse(text)
    except BadInput as error:
        raise BadInput(f"{name}: {error}") from None


def rational(name: str, text: str) -> Fraction:
    """Rational number of an option; raises BadInput."""
    found = named(name, text).exact
    if found is None:
        raise BadInput(f"{name} {text}: expected a rational number such as 3, 5/2 or 0.02")
    return found


def angle(name: str, text: str) -> tuple[Fraction, Fraction]:
    """Numbers a and b of an angle a + b pi; raises BadInput."""
    tree = named(name, text).tree
    if not isinstance(tree, Linear):
        raise BadInput(
            f"{name} {text}: expected a + b*pi with rational a and b, such as 3*pi/4 or 2.5"
        )
    return tree.constant, tree.pi_multiple


def sectors_of(phi0: str | None, sectors: int | None) -> int:
    """Number of initial sectors from either option; raises BadInput where they disagree."""
    if phi0 is None:
        return DEFAULT_SECTORS if sectors is None else sectors
    radians, half_turns = angle("--phi0", phi0)
    count = Fraction(2) / half_turns if half_turns > 0 and radians == 0 else Fraction(0)
    if count.denominator != 1 or count < 4 or count % 2:
        raise BadInput(
            f"--phi0 {phi0}: expected 2*pi/n with an even n of 4 or more, such as pi/2 or pi/6"
        )
    if sectors is not None and sectors != count:
        raise BadInput(
            f"--phi0 {phi0} means {count} sectors and --sectors says {sectors}: give one of them"
        )
    return int(count)


def parameters(radius: str, phi0: str | None, sectors: int | None, cutoff: str, step: str) -> Any:
    """Parameters as a discrete.greedy_parameters.GreedyParameters; raises BadInput."""
    numbers = rational("--radius", radius), rational("--step", step)
    count = sectors_of(phi0, sectors)
    radians, half_turns = angle("--cutoff", cutoff)
    from discrete.errors import DiscreteError
    from discrete.exact_angle import ExactAngle
    from discrete.greedy_parameters import GreedyParameters

    try:
        return GreedyParameters(
            radius=numbers[0],
            step=numbers[1],
            sectors=count,
            cutoff=ExactAngle(radians=radians, half_turns=half_turns),
        )
    except DiscreteError as error:
        raise BadInput(str(error)) from None
