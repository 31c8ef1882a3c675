"""Evidence from inequalities between balls, and functions of balls by their common names."""

from collections.abc import Iterable
from typing import Any

from flint import arb, ctx

from checks.evidence import Evidence, Grade

#: Place in words, quantity, bound: the claim is quantity <= bound.
Row = tuple[str, Any, Any]


class Balls:
    """Functions of balls by the names that sympy and mpmath give them."""

    exp = staticmethod(arb.exp)
    log = staticmethod(arb.log)
    sqrt = staticmethod(arb.sqrt)
    sin = staticmethod(arb.sin)
    cos = staticmethod(arb.cos)

    @property
    def pi(self) -> Any:
        """Ball of pi at the precision in force."""
        return arb.pi()


BALLS = Balls()


def bounded(
    rows: Iterable[Row], *, shown: str, bits: int = 128, grade: Grade = "certified"
) -> Evidence:
    """Evidence that each quantity is at most its bound: certified, or refuted at the first place.

    rows are made at the precision of bits; grade: of a pass, numeric where the rows are samples of
    a range for which the claim is made. Undecided where a comparison is; no rows are undecided.
    """
    tried, met, open_places = 0, 0, []
    with ctx.workprec(bits):
        for place, quantity, bound in rows:
            tried += 1
            if quantity <= bound:
                met += 1
            elif quantity > bound:
                witness = f"{place}: {_text(quantity)} > {_text(bound)}"
                return Evidence(
                    outcome="fail",
                    grade="certified",
                    witness=witness,
                    tried=tried,
                    met=tried,
                    shown=shown,
                )
            else:
                open_places.append(place)
    if open_places or not tried:
        where = ", ".join(open_places[:5]) or "no sample"
        return Evidence(
            outcome="undecided",
            grade="certified",
            tried=tried,
            met=met,
            shown=f"not decided: {where}",
        )
    return Evidence(outcome="pass", grade=grade, tried=tried, met=met, shown=shown)


def _text(ball: Any) -> str:
    return str(ball.str(8, radius=False))
