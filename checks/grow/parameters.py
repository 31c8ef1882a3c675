"""From the words of the command line to the exact parameters of the greedy algorithm."""

from fractions import Fraction
from typing import Any

from checks.errors import BadInput
from checks.expression import Expression, parse
from checks.expression_tree import Linear

DEFAULT_SECTORS = 4

#: Most initial sectors.
MOST_SECTORS = 10**4

#: Least radius: float64 keeps too few digits of cosh of smaller distances.
LEAST_RADIUS = Fraction(1, 1000)

#: Most edges on a line as long as the radius and 1: the working arrays grow with them.
MOST_EDGES = 2 * 10**5


def named(option: str, text: str) -> Expression:
    """Number of an option; raises BadInput that names it."""
    try:
        return parse(text)
    except BadInput as error:
        raise BadInput(f"{option}: {error}") from None


def rational(option: str, text: str) -> Fraction:
    """Rational number of an option; raises BadInput.

    >>> rational("--step", "0.02")
    Fraction(1, 50)
    """
    found = named(option, text).exact
    if found is None:
        raise BadInput(f"{option} {text}: expected a rational number, give one as 3, 5/2 or 0.02")
    return found


def angle(option: str, text: str) -> tuple[Fraction, Fraction]:
    """Numbers a and b of an angle a + b pi; raises BadInput.

    >>> angle("--cutoff", "3*pi/4 - 0.5")
    (Fraction(-1, 2), Fraction(3, 4))
    """
    tree = named(option, text).tree
    if not isinstance(tree, Linear):
        raise BadInput(
            f"{option} {text}: expected a + b*pi with rational a and b, give one as 3*pi/4 or 2.5"
        )
    return tree.constant, tree.pi_multiple


def _count(text: str) -> int:
    """Number of initial sectors from the text of --sectors."""
    found = named("--sectors", text).exact
    if found is None or found % 2 or not 4 <= found <= MOST_SECTORS:
        raise BadInput(
            f"--sectors {text}: expected an even integer from 4 to {MOST_SECTORS}, since u- and "
            "v-lines alternate around the centre: give one as 4 or 6"
        )
    return int(found)


def sectors_of(phi0: str | None, sectors: str | None) -> int:
    """Number of initial sectors from either option; raises BadInput where they disagree.

    >>> sectors_of("2*pi/6", None), sectors_of(None, "8"), sectors_of(None, None)
    (6, 8, 4)
    """
    count = None if sectors is None else _count(sectors)
    if phi0 is None:
        return count or DEFAULT_SECTORS
    radians, half_turns = angle("--phi0", phi0)
    meant = Fraction(2) / half_turns if half_turns > 0 and radians == 0 else Fraction(0)
    if meant % 2 or not 4 <= meant <= MOST_SECTORS:
        raise BadInput(
            f"--phi0 {phi0}: expected 2*pi/n with an even integer n from 4 to {MOST_SECTORS}: give "
            "one as pi/2 or pi/3, or give n as --sectors"
        )
    if count not in (None, meant):
        raise BadInput(
            f"--phi0 {phi0} makes {meant} initial sectors and --sectors says {count}: "
            "expected the same, give one of the two"
        )
    return int(meant)


def parameters(
    *, radius: str, phi0: str | None, sectors: str | None, cutoff: str, step: str
) -> Any:
    """Parameters as a discrete.greedy_parameters.GreedyParameters; raises BadInput."""
    disk, edge = rational("--radius", radius), rational("--step", step)
    count = sectors_of(phi0, sectors)
    radians, half_turns = angle("--cutoff", cutoff)
    from discrete.errors import AngleError, DiscreteError
    from discrete.exact_angle import ExactAngle
    from discrete.greedy_parameters import GreedyParameters

    try:
        run = GreedyParameters(
            radius=disk,
            step=edge,
            sectors=count,
            cutoff=ExactAngle(radians=radians, half_turns=half_turns),
        )
    except AngleError as error:
        raise BadInput(f"{error}: give another --cutoff, or more --sectors") from None
    except DiscreteError as error:
        raise BadInput(f"{error}: give another --radius or --step") from None
    _require_feasible(run)
    return run


def _require_feasible(run: Any) -> None:
    """Refuse sizes that float64 or the memory cannot serve."""
    if run.radius < LEAST_RADIUS:
        raise BadInput(
            f"the radius is {float(run.radius):g}: expected at least {LEAST_RADIUS}, since cosh of "
            "smaller distances keeps too few digits: give a larger --radius"
        )
    edges = (run.radius + 1) / run.step
    if edges > MOST_EDGES:
        least = float((run.radius + 1) / MOST_EDGES)
        raise BadInput(
            f"the step is {float(run.step):g}: expected at least {least:.3g} at this radius, since "
            f"the sides of a sector have at most {MOST_EDGES} edges: give a larger --step"
        )
