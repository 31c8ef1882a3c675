"""What a check returns, and the setting in which it runs."""

import random
from dataclasses import dataclass
from typing import Literal, get_args

Outcome = Literal["pass", "fail", "undecided", "error", "not_run"]
Grade = Literal["exact", "certified", "numeric", "experiment"]

GRADES: tuple[Grade, ...] = get_args(Grade)


@dataclass(frozen=True, kw_only=True)
class Setting:
    """What the runner decides for a check.

    digits: decimal digits asked of numeric routes; seed: of this check, derived from the run's;
    """

    digits: int = 30
    seed: str = "0"

    def random(self) -> random.Random:
        """Return a fresh generator, the same one at every call."""
        return random.Random(self.seed)


@dataclass(frozen=True, kw_only=True)
class Evidence:
    """What a check found, as plain data.

    residual: largest discrepancy, an upper bound (`0` where exact); enclosure: a ball as text;
    tried, met: samples drawn, and those that met the hypotheses; witness: what refutes the form,
    in numbers that a reader can verify; shown: one sentence on what was established.
    Raises ValueError where nothing met the hypotheses, or a failure has no witness.
    """

    outcome: Literal["pass", "fail", "undecided"]
    grade: Grade
    shown: str = ""
    residual: str = ""
    enclosure: str = ""
    digits: int | None = None
    tried: int = 1
    met: int = 1
    witness: str = ""

    def __post_init__(self) -> None:
        if self.outcome not in ("pass", "fail", "undecided"):
            raise ValueError(f"unknown outcome {self.outcome!r}")
        for name in ("shown", "residual", "enclosure", "witness"):
            value = getattr(self, name)
            if type(value) is not str:
                raise TypeError(f"{name} must be text, not {type(value).__name__}")
            value.encode()  # lone surrogates would stop the whole ledger from being written
        for name in ("digits", "tried", "met"):
            if type(getattr(self, name)) is not int and (name, self.digits) != ("digits", None):
                raise TypeError(f"{name} must be an int")
        if self.grade not in GRADES:
            raise ValueError(f"unknown grade {self.grade!r}: expected one of {', '.join(GRADES)}")
        if self.met > self.tried or self.met < 0:
            raise ValueError(f"{self.met} samples met the hypotheses out of {self.tried} tried")
        if self.outcome == "pass" and self.met == 0:
            raise ValueError("no sample met the hypotheses: the outcome is undecided, not pass")
        if self.outcome == "fail" and not self.witness:
            raise ValueError("a failure needs a witness")


def weaker(first: Grade, second: Grade) -> Grade:
    """Return the weaker of two grades."""
    return first if GRADES.index(first) >= GRADES.index(second) else second


def stronger(first: Grade, second: Grade) -> Grade:
    """Return the stronger of two grades."""
    return second if weaker(first, second) == first else first
