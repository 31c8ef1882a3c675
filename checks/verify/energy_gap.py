"""Checks of the gap between the least E_inf of smooth and of branched isometries of one disk."""

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from checks.evidence import Evidence, Setting
from checks.exact import combined, identities, statement
from checks.verify.ball_bounds import Row, bounded
from checks.verify.initial_angles import fraction
from theory import inscribed_square, periodic_amsler

RADIUS, DELTA = sp.symbols("R delta", positive=True)
#: Radii of disks, and the number of Amsler sectors about the centre.
_DISKS = (("3/2", 6), ("8/5", 6), ("49/25", 8), ("2", 8), ("21/10", 8))


def _square(setting: Setting, stretch: str) -> Evidence:
    """Steps of R^2 <= E (pi - 2 delta) for every C^2 immersion; the side stretched by a factor."""
    a = sp.Rational(stretch) * inscribed_square.half_side(RADIUS, DELTA)
    corner = inscribed_square.squared_length(a, a, DELTA)
    return identities(
        setting,
        {
            "the corner is on the rim at most": corner - RADIUS**2,
            "area": 4 * a**2 * sp.sin(DELTA) - 2 * RADIUS**2 * sp.tan(DELTA / 2),
            "alternating sum": 2 * (sp.pi - DELTA) - 2 * DELTA - 2 * (sp.pi - 2 * DELTA),
        },
        shown="2 R^2 tan(delta/2) <= 2 pi - 4 delta",
    )


def _gap(share: str, sectors: int) -> Evidence:
    """Whether E_inf of the Amsler sectors is below share times the bound of smooth immersions."""

    def rows() -> Iterator[Row]:
        for radius, number in _DISKS:
            chosen = sectors or number
            branched = periodic_amsler.max_curvature(Fraction(radius), chosen, digits=20).ball()
            smooth = inscribed_square.least_energy(Fraction(radius), digits=20).ball()
            yield f"R = {radius}, {chosen} sectors", branched, fraction(share) * smooth

    return bounded(rows(), shown="E_inf of the branched surface is below every smooth one")


def energy_gap(
    setting: Setting, *, share: str = "1", stretch: str = "1", sectors: int = 0
) -> Evidence:
    """Branched surfaces of disks with E_inf below share times a bound of all C^2 isometries.

    stretch: of the square that gives the bound; sectors: their number, by default that of _DISKS.
    """
    fewest = min(sectors or number for _, number in _DISKS)
    branches = statement(
        fewest > 4, shown="", witness=f"{fewest} sectors about the centre: it is no branch point"
    )
    if branches.outcome == "fail":
        return branches
    return combined(
        {"square": _square(setting, stretch), "branch point": branches,
         "gap": _gap(share, sectors)},
        shown="R = 3/2: E_inf > 1.887 for every C^2 isometry, against sqrt(3) < 1.733 for the "
        "monkey saddle of six Amsler sectors; R = 8/5: 1.995, R = 2: 2.483 against cot(pi/8) < "
        "2.415 for eight",
    )  # fmt: skip


def substantially_below(
    setting: Setting, *, share: str = "9/10", radius: str = "8/5", sectors: int = 6
) -> Evidence:
    """A branched surface of one disk with E_inf below this share of that of all C^2 isometries."""
    chosen = Fraction(radius)

    def rows() -> Iterator[Row]:
        branched = periodic_amsler.max_curvature(chosen, sectors, digits=20).ball()
        smooth = inscribed_square.least_energy(chosen, digits=20).ball()
        yield f"R = {radius}, {sectors} sectors", branched, fraction(share) * smooth

    return combined(
        {
            "square": _square(setting, "1"),
            "quotient": bounded(rows(), shown="E_inf of the branched surface is far below"),
        },
        shown=f"R = {radius}: E_inf of {sectors} Amsler sectors is below {share} of that of every "
        "C^2 isometry",
    )
